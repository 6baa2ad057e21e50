// SPDX-License-Identifier: MIT
#include "model/intent/stepperplan.h"

#include <algorithm>

#include "model/intent/backlash.h"
#include "model/intent/planner.h"
#include "model/intent/travel.h"
#include "module/profiledload.h"
#include "module/stepperspeed.h"

namespace nmc {

namespace {

/// The position at which a motion that starts now ends.
[[nodiscard]] std::optional<std::int64_t> goalNow(const StepperMotion& motion, const ModuleState& module) {
    return goalOf(motion, module.stepper.position().value_or(0));
}

/// What prevents any motion, whatever the request.
[[nodiscard]] std::optional<Refusal> whyNoMotion(const ModuleState& module, IntentKind as) {
    const StepperState& stepper = module.stepper;
    if (const auto refusal = whyInaccessible(as, module))
        return refusal;
    return firstUnmet({{stepper.powered(), Refusal::NoPower},
                       {stepper.parameters.has_value(), Refusal::ParametersUnknown},
                       {stepper.amplifierOn(), Refusal::AmplifierOff},
                       {!stepper.estopActs(), Refusal::EstopActive}});
}

struct LoadOf {
    std::int32_t goal;  ///< for motions that have one
    bool reverse;

    stepper::LoadTrajectory operator()(const steppermotion::Trapezoid& move) const {
        return profiledLoad(move.speed, move.accelerationTime, goal);
    }
    stepper::LoadTrajectory operator()(const steppermotion::VelocityProfile& run) const {
        return profiledLoad(run.speed, run.accelerationTime, {}, reverse);
    }
    stepper::LoadTrajectory operator()(const steppermotion::UnprofiledMove& move) const {
        stepper::LoadTrajectory load;
        load.position = Counts(goal);
        load.timer = move.timer;
        load.reverse = reverse;
        return load;
    }
    stepper::LoadTrajectory operator()(const steppermotion::UnprofiledRun& run) const {
        stepper::LoadTrajectory load;
        load.timer = run.timer;
        load.reverse = reverse;
        return load;
    }
};

[[nodiscard]] bool isRelative(const StepperMotion& motion) {
    return std::visit(
        [](const auto& move) {
            if constexpr (requires { move.relative; })
                return move.relative;
            else
                return false;
        },
        motion);
}

/// A load changes nothing until it is started (DS-S 5.1), but the position from which it will start is
/// unknown while the motor moves: so is a relative goal, and the direction bit of a move without a ramp. It
/// goes straight to its goal.
[[nodiscard]] std::optional<Refusal> whyNotLoaded(const StepperMotion& motion, const ModuleState& module) {
    const bool fromHere = isRelative(motion) || std::holds_alternative<steppermotion::UnprofiledMove>(motion);
    if (fromHere && module.stepper.moving())
        return Refusal::NeedsStop;
    return whyNotFromStandstill(motion, withoutBacklash(module));
}

struct StepperPlanner : MotorPlanner {
    using MotorPlanner::operator();

    Plan operator()(const intent::Enable&) const {
        // Only sets AMP_EN: the motor stands still and is held by the holding current (DS-S 5.1, 4.6).
        return as(IntentKind::Enable, stepper::StopMotor{true, stepper::StopManner::AmplifierOnly});
    }
    Plan operator()(const intent::StopSmoothly&) const {
        return as(IntentKind::StopMotion, smoothStop(module).command);
    }
    Plan operator()(const intent::SetAmplifier& amplifier) const {
        return amplifier.enable ? (*this)(intent::Enable{}) : (*this)(intent::MotorOff{});
    }
    Plan operator()(const stepperintent::SetParameters& set) const {
        return unless(whyNotSet(set.parameters, module), set.parameters);
    }
    Plan operator()(const stepperintent::SetOutputs& set) const {
        return as(IntentKind::SetOutputs, stepper::SetOutputs{set.outputs});
    }
    Plan operator()(const intent::Move& move) const {
        const auto* motion = std::get_if<StepperMotion>(&move.motion);
        if (motion == nullptr)
            return tl::unexpected(Refusal::NotAServo);
        return unless(whyNot(*motion, module), boundedLoad(*motion), StartMotion{});
    }
    Plan operator()(const intent::LoadMove& load) const {
        const auto* motion = std::get_if<StepperMotion>(&load.motion);
        if (motion == nullptr)
            return tl::unexpected(Refusal::NotAServo);
        return unless(whyNotLoaded(*motion, module), boundedLoad(*motion));
    }
    /// Takes more than one operation; see procedures.h.
    Plan operator()(const intent::ChangeMotion& change) const {
        return tl::unexpected(whyNotFromStandstill(change.motion, module).value_or(Refusal::NeedsStop));
    }
    /// Also a procedure; determines only why its first move is not possible.
    Plan operator()(const intent::MoveBy& moveBy) const {
        const auto* pace = std::get_if<bus::StepperPace>(&moveBy.pace);
        if (pace == nullptr)
            return tl::unexpected(Refusal::NotAServo);
        if (moveBy.moves.counts == 0)
            return tl::unexpected(Refusal::StepTooShort);
        if (const auto refusal = whyNotStep(IntentKind::Move, module))
            return tl::unexpected(*refusal);
        const steppermotion::Trapezoid first{moveBy.moves.counts, true, pace->speed, pace->accelerationTime};
        return unless(whyNotFromStandstill(first, module));
    }
    Plan operator()(In<ServoIntent> auto) const { return tl::unexpected(Refusal::NotAServo); }

private:
    [[nodiscard]] stepper::LoadTrajectory boundedLoad(const StepperMotion& motion) const {
        return loadFor(withinTravel(motion, module), module);
    }
};

/// Why the loaded motion cannot start now.
[[nodiscard]] std::optional<Refusal> whyNotStart(const ModuleState& module) {
    if (!module.stepper.waiting)
        return Refusal::NothingLoaded;
    if (const auto problem = loadedProblem(module))
        return problem->refusal;
    return whyNotStarted(*module.stepper.waiting, module);
}

[[nodiscard]] std::optional<Refusal> whyNotEnable(const ModuleState& module) {
    const StepperState& stepper = module.stepper;
    // Before the parameters are set, the holding current is 0, so nothing would hold.
    return firstUnmet({{stepper.powered(), Refusal::NoPower},
                       {stepper.parameters.has_value(), Refusal::ParametersUnknown},
                       {!stepper.tooHot(), Refusal::TooHot},
                       {!stepper.moving(), Refusal::NeedsStop}});
}

}  // namespace

bool wantsReverse(const StepperMotion& motion, const ModuleState& module) {
    if (const auto goal = goalNow(motion, module))
        return *goal < module.stepper.position().value_or(0);
    return std::visit(
        [](const auto& run) {
            if constexpr (requires { run.reverse; })
                return run.reverse;
            else
                return false;
        },
        motion);
}

double speedOf(const StepperMotion& motion, const ModuleState& module) {
    return speedOf(loadFor(motion, module), module);
}

double speedOf(const stepper::LoadTrajectory& load, const ModuleState& module) {
    const auto& parameters = module.stepper.parameters;
    if (!parameters)
        return 0.0;
    const StepperSpeed mode(parameters->speedMode);
    const double timed = load.timer ? mode.ofCount(load.timer->count) : 0.0;
    if (load.timer && !load.speed && !load.accelerationTime)
        return timed;
    // Without a speed, a profile has the one loaded before, and none is slower than the minimum (DS-S 5.1).
    const auto speed = load.speed ? load.speed : module.stepper.loadedSpeed;
    return std::max(timed, speed ? mode.ofSpeed(std::max(*speed, parameters->minimumProfileSpeed)) : 0.0);
}

Plan planStep(const Intent& intent, const ModuleState& module) {
    return std::visit(StepperPlanner{{{module}}}, intent);
}

std::optional<Refusal> whyNotStep(IntentKind kind, const ModuleState& module) {
    if (const auto refusal = whyInaccessible(kind, module))
        return refusal;
    switch (kind) {
        case IntentKind::Enable:
        case IntentKind::SetAmplifier:
            return whyNotEnable(module);
        case IntentKind::Move:
            if (const auto refusal = whyNoMotion(module, kind))
                return refusal;
            return module.moving() ? std::optional(Refusal::NeedsStop) : std::nullopt;
        case IntentKind::Load:
        case IntentKind::Run:
        case IntentKind::Hold:
            return whyNoMotion(module, kind);
        case IntentKind::StartLoaded:
            return whyNotStart(module);
        case IntentKind::ResetPosition:
        case IntentKind::ResetModule:
            return module.moving() ? std::optional(Refusal::NeedsStop) : std::nullopt;
        case IntentKind::StopMotion:
        case IntentKind::MotorOff:
        case IntentKind::SaveAsHome:
        case IntentKind::SetParameters:
        case IntentKind::SetOutputs:
            return std::nullopt;
        case IntentKind::DeclarePosition:
            return whyNotDeclare(module);
        case IntentKind::GoHome:
            if (const auto refusal = whyNotStep(IntentKind::Move, module))
                return refusal;
            return module.home.place() ? std::nullopt : std::optional(Refusal::HomeUnknown);
        case IntentKind::ApplyGains:
        case IntentKind::ClearStickyBits:
        case IntentKind::StopHere:
        case IntentKind::DrivePwm:
        case IntentKind::CheckDirection:
        case IntentKind::ControlIo:
        case IntentKind::ControlSc:
        case IntentKind::ArmLimitStop:
            return Refusal::NotAServo;
        case IntentKind::Home:
            return whyNotHome(module);
    }
    return std::nullopt;
}

std::optional<Refusal> whyNotFromStandstill(const StepperMotion& motion, const ModuleState& module,
                                            IntentKind as) {
    if (const auto refusal = whyNoMotion(module, as))
        return refusal;
    if (const auto refusal = whyNotThatFar(goalNow(motion, module), module))
        return refusal;
    if (const auto problem = travelProblem(intent::Move{motion}, module))
        return problem->refusal;
    const bool reverse = wantsReverse(motion, module);
    if (module.stepper.limitActs(reverse))
        return reverse ? Refusal::Limit2Active : Refusal::Limit1Active;
    return std::nullopt;
}

std::optional<Refusal> whyNot(const StepperMotion& wanted, const ModuleState& module, IntentKind as) {
    if (const auto refusal = whyNotFromStandstill(wanted, module, as))
        return refusal;
    const StepperMotion motion = withinTravel(wanted, module);
    const StepperState& stepper = module.stepper;
    if (!stepper.moving())
        return std::nullopt;
    // The motion was started by another host, so its direction is unknown.
    if (!stepper.runsReverse())
        return Refusal::NeedsStop;
    // In a motion that ends at a goal, a load with only a timer count keeps that goal and would not run on.
    const bool hasGoal =
        stepper.mode() == StepperMode::Trapezoidal || stepper.mode() == StepperMode::UnprofiledWithStop;
    if (hasGoal && std::holds_alternative<steppermotion::UnprofiledRun>(motion))
        return Refusal::NeedsStop;
    return mayFollow(stepper.mode(), *stepper.runsReverse(), loadFor(motion, module))
               ? std::nullopt
               : std::optional(Refusal::NeedsStop);
}

std::optional<Refusal> whyNotSet(const stepper::SetParameters& parameters, const ModuleState& module) {
    if (const auto refusal = whyNotStep(IntentKind::SetParameters, module))
        return refusal;
    const auto& now = module.stepper.parameters;
    const bool inMotion = now && stepper::sameInMotion(*now, parameters);
    return module.moving() && !inMotion ? std::optional(Refusal::NeedsStop) : std::nullopt;
}

std::optional<Refusal> whyNotStarted(const stepper::LoadTrajectory& load, const ModuleState& module) {
    const StepperState& stepper = module.stepper;
    if (const auto refusal = whyNoMotion(module, IntentKind::StartLoaded))
        return refusal;
    if (load.position)
        if (const auto refusal = whyNotThatFar(load.position->value(), module))
            return refusal;
    const bool reverse =
        load.position ? load.position->value() < stepper.position().value_or(0) : load.reverse;
    if (stepper.limitActs(reverse))
        return reverse ? Refusal::Limit2Active : Refusal::Limit1Active;
    if (!mayFollow(stepper.mode(), stepper.runsReverse().value_or(false), load))
        return Refusal::NeedsStop;
    // A smooth stop leaves no speed loaded (DS-S 5.1), and what another host has loaded is unknown.
    const bool runs = load.timer || load.speed || stepper.loadedSpeed.value_or(0) != 0;
    return runs ? std::nullopt : std::optional(Refusal::NoVelocity);
}

stepper::LoadTrajectory loadFor(const StepperMotion& motion, const ModuleState& module) {
    const auto goal = static_cast<std::int32_t>(goalNow(motion, module).value_or(0));
    return std::visit(LoadOf{goal, wantsReverse(motion, module)}, motion);
}

bus::Order smoothStop(const ModuleState& module) {
    if (!module.isStepper())
        return {module.info.index, ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})};
    const StepperState& stepper = module.stepper;
    const bool ramp = stepper.accelerationTime || stepper.mode() == StepperMode::Trapezoidal ||
                      stepper.mode() == StepperMode::VelocityProfile;
    const auto manner = ramp ? stepper::StopManner::Smoothly : stepper::StopManner::Abruptly;
    return {module.info.index, StepperCommand(stepper::StopMotor{module.amplifierKept(), manner})};
}

}  // namespace nmc

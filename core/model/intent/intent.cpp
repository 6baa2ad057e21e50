// SPDX-License-Identifier: MIT
#include "model/intent/intent.h"

#include <algorithm>

#include "model/intent/directplan.h"
#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"
#include "model/intent/planner.h"
#include "model/intent/rights.h"
#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "model/path/pathplan.h"
#include "module/profiledload.h"
#include "module/stopmanner.h"

namespace nmc {

namespace {

bool gainsAct(const ModuleState& module) {
    // With Kd alone, the servo brakes but holds nothing, which is how a new motor is tuned first. Without an
    // output limit above 0, nothing drives it.
    return module.gains && (module.gains->kp != 0 || module.gains->kd != 0) && module.gains->ol != 0;
}

/// What a trajectory lacks to ever start or end. A run at velocity 0 ends another one.
std::optional<Refusal> lacking(const servo::LoadTrajectory& load) {
    const bool moves = load.velocity && (load.isVelocityMode() || load.velocity->value() != 0);
    const bool accelerates = load.acceleration && load.acceleration->value() != 0;
    return firstUnmet({{moves, Refusal::NoVelocity}, {accelerates, Refusal::NoAcceleration}});
}

/// Why what was loaded cannot start now.
std::optional<Refusal> whyNoStart(const ModuleState& module) {
    if (!module.loadWaiting)
        return Refusal::NothingLoaded;
    if (const auto problem = loadedProblem(module))
        return problem->refusal;
    if (!module.load.servo)
        return whyNot(IntentKind::DrivePwm, module);
    const servo::LoadTrajectory load = module.trajectory();
    if (const auto refusal = lacking(load))
        return refusal;
    if (const auto refusal = whyNot(IntentKind::Move, module))
        return refusal;
    const bool toPlace = load.isTrapezoidal() && !load.relative && load.position;
    return toPlace ? whyNotThatFar(load.position->value(), module) : std::nullopt;
}

/// Direction of the motion from the present position, -1 or 1; 0: none.
int directionOf(const servo::LoadTrajectory& load, const ModuleState& module) {
    if (!load.isTrapezoidal())
        return load.reverse ? -1 : 1;
    const auto from = module.position();
    if (!load.position || !from)
        return 0;
    const std::int32_t distance =
        load.relative ? load.position->value() : countsBetween(*from, load.position->value());
    return distance > 0 ? 1 : distance < 0 ? -1 : 0;
}

/// An SC with limit protection would not start, and would not report it (docs/family.md).
bool startsIntoLimit(const Orders& orders, const ModuleState& module) {
    for (const bus::Order& step : orders)
        if (const auto* load = getIf<servo::LoadTrajectory>(step.command))
            if (module.limitEnds(directionOf(*load, module)))
                return true;
    return false;
}

struct ServoPlanner : MotorPlanner {
    using MotorPlanner::operator();

    Plan operator()(const intent::Enable&) const {
        // A single Stop Motor sets AMP_EN and makes the servo hold its present position (DS-V 5.2). The
        // position error bit is set while a servo is off, and remains set; once it is cleared, its next edge
        // is a trip.
        return as(IntentKind::Enable, servo::StopMotor{true, servo::StopManner::Abruptly, {}},
                  servo::ClearStickyBits{});
    }

    Plan operator()(const intent::Move& move) const {
        const auto motion = bounded(move.motion);
        if (!motion)
            return tl::unexpected(motion.error());
        const bool ends = std::holds_alternative<servomotion::Trapezoid>(*motion);
        if (ends && motion->index() != std::get<ServoMotion>(move.motion).index() && module.moving())
            return tl::unexpected(Refusal::RunNeedsStop);
        return loading(ends ? IntentKind::Move : IntentKind::Run, *motion, StartMotion{});
    }

    Plan operator()(const intent::LoadMove& load) const {
        const auto motion = bounded(load.motion);
        if (!motion)
            return tl::unexpected(motion.error());
        return loading(IntentKind::Load, *motion);
    }

    Plan operator()(const intent::StopSmoothly&) const {
        // With acceleration 0, the chip could not decelerate (link.md 2.6).
        return stop(module.canDecelerate() ? StopManner::Smoothly : StopManner::Abruptly);
    }

    Plan operator()(const intent::ApplyGains& apply) const {
        return as(IntentKind::ApplyGains, gainsFor(module, apply.gains));
    }

    Plan operator()(const intent::ClearStickyBits&) const {
        return as(IntentKind::ClearStickyBits, servo::ClearStickyBits{});
    }

    Plan operator()(const intent::StopHere&) const {
        const auto refusal = whyNot(IntentKind::StopHere, module);
        // A motor in motion has left the reported position, and would be driven back to it.
        if (!refusal && module.moving())
            return stop(StopManner::Abruptly);
        const std::int32_t here = module.position().value_or(0);
        return unless(refusal,
                      servo::StopMotor{module.amplifierKept(), servo::StopManner::Here, Counts(here)});
    }

    Plan operator()(const intent::DrivePwm& drive) const {
        servo::LoadTrajectory load;
        load.servo = false;
        load.pwm = drive.pwm;
        load.reverse = drive.reverse;
        if (module.amplifierEnabled == true)
            return as(IntentKind::DrivePwm, load, StartMotion{});
        // Without AMP_EN, the motor would not turn.
        return as(IntentKind::DrivePwm, servo::StopMotor{true, servo::StopManner::MotorOff, {}}, load,
                  StartMotion{});
    }

    Plan operator()(const intent::SetAmplifier& amplifier) const {
        return as(IntentKind::SetAmplifier,
                  servo::StopMotor{amplifier.enable, servo::StopManner::AmplifierOnly, {}});
    }

    Plan operator()(const intent::ControlIo& control) const { return as(IntentKind::ControlIo, control.io); }

    Plan operator()(const intent::ControlSc& control) const {
        return as(IntentKind::ControlSc, servo::StopMotor{false, servo::StopManner::MotorOff, {}},
                  control.io);
    }

    Plan operator()(const intent::MoveBy& moveBy) const {
        const auto* pace = std::get_if<ServoPace>(&moveBy.pace);
        if (pace == nullptr)
            return tl::unexpected(Refusal::NotAStepper);
        if (const auto refusal = lacking(profiledLoad(pace->velocity, pace->acceleration, 0)))
            return tl::unexpected(*refusal);
        if (moveBy.moves.counts == 0)
            return tl::unexpected(Refusal::StepTooShort);
        if (const auto refusal = whyNot(IntentKind::Move, module))
            return tl::unexpected(*refusal);
        const int direction = moveBy.moves.counts < 0 ? -1 : 1;
        return unless(firstUnmet({{module.certainPosition().has_value(), Refusal::PositionUnknown},
                                  {!module.limitEnds(direction), Refusal::LimitClosed}}));
    }
    Plan operator()(const intent::CheckDirection&) const { return as(IntentKind::CheckDirection); }
    Plan operator()(In<ServoProcedure> auto wanted) const { return unless(whyNot(wanted, module)); }
    Plan operator()(const intent::KeepGains&) const { return as(IntentKind::ApplyGains); }
    Plan operator()(const intent::SaveConfiguration&) const { return as(IntentKind::ControlSc); }

    Plan operator()(const intent::ArmLimitStop& arm) const {
        return unless(whyNotArm(arm, module), limitStop(arm));
    }

    Plan operator()(In<StepperIntent> auto) const { return tl::unexpected(Refusal::NotAStepper); }

private:
    /// The motion as it may be sent: within the travel limits, and with nothing lacking.
    [[nodiscard]] tl::expected<ServoMotion, Refusal> bounded(const MotionSpec& wanted) const {
        const auto* servo = std::get_if<ServoMotion>(&wanted);
        if (servo == nullptr)
            return tl::unexpected(Refusal::NotAStepper);
        const ServoMotion motion = withinTravel(*servo, module);
        if (const auto refusal = lacking(loadFor(motion)))
            return tl::unexpected(*refusal);
        return motion;
    }
    /// The motion's load and what follows it, unless something prevents the motion.
    template <typename... Commands>
    [[nodiscard]] Plan loading(IntentKind kind, const ServoMotion& motion, const Commands&... then) const {
        const auto refusal = whyNot(kind, module);
        return unless(refusal ? refusal : whyNotThatFar(goalOf(motion, 0), module), loadFor(motion), then...);
    }
    [[nodiscard]] static servo::LoadTrajectory loadFor(const ServoMotion& motion) {
        if (const auto* run = std::get_if<servomotion::VelocityProfile>(&motion))
            return profiledLoad(run->velocity, run->acceleration, {}, run->reverse);
        const auto& move = std::get<servomotion::Trapezoid>(motion);
        return profiledLoad(move.velocity, move.acceleration, move.position.value());
    }
};

}  // namespace

bool isStop(IntentKind kind) {
    return kind == IntentKind::StopMotion || kind == IntentKind::StopHere || kind == IntentKind::MotorOff;
}

bool isStop(const Intent& intent) {
    if (const auto* direct = std::get_if<intent::Direct>(&intent)) {
        // At any other position than the present one, Here is a move.
        const auto* stop = getIf<servo::StopMotor>(direct->command);
        return stopManner(direct->command) && (stop == nullptr || stop->manner != servo::StopManner::Here);
    }
    return std::visit(
        []<typename T>(const T&) {
            return AnyOf<T, intent::StopSmoothly, intent::StopAbruptly, intent::StopHere, intent::MotorOff>;
        },
        intent);
}

std::optional<Refusal> firstUnmet(std::initializer_list<Need> needs) {
    const auto* unmet = std::ranges::find(needs, false, &Need::met);
    return unmet != needs.end() ? std::optional(unmet->otherwise) : std::nullopt;
}

std::optional<Refusal> whyNotThatFar(std::optional<std::int64_t> goal, const ModuleState& module) {
    if (!goal)
        return std::nullopt;
    if (!module.certainPosition())
        return Refusal::PositionUnknown;
    constexpr ValueRange kReach = servo::kPositionRange;  // that of a PIC-STEP is the same
    const bool reached = kReach.contains(*goal) && kReach.contains(*goal - *module.position());
    return reached ? std::nullopt : std::optional(Refusal::TooFar);
}

Plan plan(const Intent& intent, const ModuleState& module) {
    if (std::holds_alternative<intent::AskAnew>(intent))
        return Planner{module}.unless({}, Nop{});
    if (const auto* direct = std::get_if<intent::Direct>(&intent)) {
        if (module.rights)
            return tl::unexpected(Refusal::OperatorMode);
        if (const auto refusal = whyNotDirect(direct->command, module))
            return tl::unexpected(*refusal);
        return Orders{{module.info.index, direct->command}};
    }
    // The bus carries this out (bus/readdresstask.h).
    if (std::holds_alternative<intent::ResetModule>(intent))
        return Planner{module}.as(IntentKind::ResetModule);
    if (const auto* goHome = std::get_if<intent::GoHome>(&intent)) {
        if (const auto refusal = whyNot(IntentKind::GoHome, module))
            return tl::unexpected(*refusal);
        return plan(intent::Move{*motionOf(*goHome, module)}, module);
    }
    if (module.isIo())
        return planIo(intent, module);
    Plan orders =
        module.isStepper() ? planStep(intent, module) : std::visit(ServoPlanner{{{module}}}, intent);
    if (orders)
        if (const auto problem = travelProblem(intent, module))
            return tl::unexpected(problem->refusal);
    if (orders && module.isServo() && startsIntoLimit(*orders, module))
        return tl::unexpected(Refusal::LimitClosed);
    return orders;
}

Orders stopOf(ModuleState module) {
    module.silent = false;
    return plan(intent::StopSmoothly{}, module).value_or(Orders());
}

std::optional<Refusal> whyNot(IntentKind kind, const ModuleState& module) {
    if (module.isStepper())
        return whyNotStep(kind, module);
    if (module.isIo())
        return whyNotIo(kind, module);
    if (kind == IntentKind::Home)
        return whyNotHome(module);
    if (!module.isServo())
        return Refusal::NotAServo;
    if (const auto refusal = whyInaccessible(kind, module))
        return refusal;

    const ModuleIdentity& chip = module.info.identity;
    const bool powered = module.latest && module.latest->servoStatus().powerOn();
    const bool placed = module.certainPosition().has_value();
    const Need on{module.servoOn(), Refusal::ServoOff};
    const Need off{!module.servoOn(), Refusal::ServoOn};
    const Need still{!module.moving(), Refusal::Moving};
    const Need turnsNot{!module.moving() && !module.turns(), Refusal::Moving};
    const Need offThePath{!module.onPath(), Refusal::NeedsStop};
    const Need speedsKnown{module.speedsKnown(), Refusal::ServoRateUnknown};
    switch (kind) {
        case IntentKind::Enable:
            return firstUnmet({{powered, Refusal::NoPower}, {gainsAct(module), Refusal::GainsUnknown}});
        case IntentKind::Move:
            if (const auto refusal = whyNot(IntentKind::Run, module))
                return refusal;
            return firstUnmet({still});
        case IntentKind::Load:  // changes nothing until it is started (DS-V 5.1, note 1)
            return firstUnmet({speedsKnown, on});
        case IntentKind::GoHome:
            if (!module.home.place())
                return Refusal::HomeUnknown;
            return whyNot(IntentKind::Move, module);
        case IntentKind::Run:
        case IntentKind::Hold:
            return firstUnmet({on, speedsKnown, offThePath, {!limitStopDue(module), Refusal::LimitStopDue}});
        case IntentKind::StopMotion:  // a stop would switch on a servo that is off
            return firstUnmet({on});
        case IntentKind::ResetPosition:
        case IntentKind::ResetModule:
            return firstUnmet({turnsNot});
        case IntentKind::DeclarePosition:
            return whyNotDeclare(module);
        case IntentKind::StartLoaded:
            return whyNoStart(module);
        case IntentKind::StopHere:
            return firstUnmet({{chip.version >= servo::kStopHereVersion, Refusal::VersionLacksIt},
                               {placed || module.moving(), Refusal::PositionUnknown},
                               on});
        case IntentKind::DrivePwm:
            return firstUnmet({{powered, Refusal::NoPower}, off});
        case IntentKind::CheckDirection:
            if (const auto refusal = whyNot(IntentKind::DrivePwm, module))
                return refusal;
            return firstUnmet({{placed && module.latest->aux, Refusal::PositionUnknown}, turnsNot});
        case IntentKind::ControlIo:
            return firstUnmet({{chip.version < servo::kOtherIoVersion, Refusal::VersionLacksIt}, offThePath});
        case IntentKind::ControlSc:
            return firstUnmet({{isSc(chip), Refusal::VersionLacksIt}, off, turnsNot});
        case IntentKind::ArmLimitStop:
            return firstUnmet({{chip.version >= servo::kAutoStopVersion, Refusal::VersionLacksIt}});
        case IntentKind::Home:  // handled above
        case IntentKind::SaveAsHome:
        case IntentKind::SetAmplifier:
        case IntentKind::MotorOff:
        case IntentKind::ApplyGains:
        case IntentKind::ClearStickyBits:
            return std::nullopt;
        case IntentKind::SetParameters:
        case IntentKind::SetOutputs:
            return Refusal::NotAStepper;
    }
    return std::nullopt;
}

std::optional<MotionSpec> motionOf(const intent::GoHome& goHome, const ModuleState& module) {
    const auto& home = module.home.place();
    return home ? std::optional(moveTo(home->counts, goHome.pace)) : std::nullopt;
}

std::optional<Refusal> whyNotDeclare(const ModuleState& module) {
    return firstUnmet(
        {{module.position().has_value(), Refusal::PositionUnknown}, {!module.moving(), Refusal::Moving}});
}

std::optional<Refusal> whyInaccessible(IntentKind kind, const ModuleState& module) {
    const bool heard = !module.silent && module.latest;
    const Refusal unheard = module.notAsked ? Refusal::NotAsked : Refusal::Unresponsive;
    return firstUnmet({{!module.lent, Refusal::Lent},
                       {!module.readOnly, Refusal::ReadOnly},
                       {!module.rights || allows(*module.rights, kind), Refusal::OperatorMode},
                       {!module.lookedFor || isStop(kind), Refusal::Looking},
                       {heard || kind == IntentKind::MotorOff, unheard},
                       {!module.otherType() || isStop(kind), Refusal::OtherType}});
}

std::optional<Refusal> whyInaccessible(const LinkState& link) {
    return firstUnmet({{link.isOpen(), Refusal::NotConnected},
                       {!link.lent, Refusal::Lent},
                       {!link.readOnly, Refusal::ReadOnly},
                       {!link.rights, Refusal::OperatorMode}});
}

std::optional<Refusal> whyNoChain(const LinkState& link) {
    if (link.lent)
        return Refusal::Lent;
    if (link.phase == LinkPhase::Connected)
        return std::nullopt;
    return link.phase == LinkPhase::Connecting && link.looking ? Refusal::Looking : Refusal::NotConnected;
}

std::optional<Refusal> whyNoStop(const LinkState& link) {
    const auto refusal = whyNoChain(link);
    return refusal == Refusal::Looking ? std::nullopt : refusal;
}

}  // namespace nmc

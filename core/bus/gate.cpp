// SPDX-License-Identifier: MIT
#include "bus/gate.h"

#include "base/overloaded.h"
#include "protocol/unsupported.h"

namespace nmc::bus {

namespace {

using servo::ProfileMode;

[[nodiscard]] Permission onlyAtStandstill(const Belief& belief) {
    if (!belief.fresh())
        return Permission::NeedsStatus;
    if (belief.mayMove())
        return Permission::InMotion;
    // With the servo off the command velocity follows the actual one: a motor that coasts is in motion.
    if (belief.info().identity.type == ModuleType::Servo && !belief.on()) {
        if (!belief.velocity())
            return Permission::NeedsStatus;
        return *belief.velocity() == 0 && !belief.rolls() ? Permission::Allowed : Permission::InMotion;
    }
    return Permission::Allowed;
}

/// Some mode of Table 4 knows what is loaded.
[[nodiscard]] bool inTable(const stepper::LoadTrajectory& load) {
    return goalMode(StepperMode::Stopped, load) || goalMode(StepperMode::Trapezoidal, load);
}

[[nodiscard]] bool trapezoidal(const servo::LoadTrajectory& load) {
    return load.servo && load.profile == ProfileMode::Trapezoidal;
}

struct GateJudge {
    const Belief& belief;

    Permission operator()(const Nop&) const { return Permission::Allowed; }
    Permission operator()(const ReadStatus&) const { return Permission::Allowed; }
    Permission operator()(const DefineStatus&) const { return Permission::Allowed; }
    Permission operator()(const SetAddress&) const { return Permission::Never; }
    Permission operator()(const SetBaud&) const { return Permission::Never; }
    Permission operator()(const HardReset&) const { return Permission::Never; }
    Permission operator()(const ResetPosition&) const { return onlyAtStandstill(belief); }
    Permission operator()(const SaveAsHome&) const { return Permission::Allowed; }
    Permission operator()(const StartMotion&) const {
        if (!belief.loaded())
            return Permission::Never;
        if (const auto& load = belief.stepperLoad())
            return mayStart(*load);
        const auto& load = belief.servoLoad();
        return load && trapezoidal(*load) ? onlyAtStandstill(belief) : offThePath();
    }

    Permission operator()(const servo::LoadTrajectory& load) const {
        // Until it is started a load changes nothing (DS-V 5.1, note 1).
        if (trapezoidal(load) && load.startNow)
            return Permission::Never;
        return load.startNow ? offThePath() : Permission::Allowed;
    }
    Permission operator()(const AnyOf<servo::SetGain, servo::StopMotor> auto&) const {
        return Permission::Allowed;
    }
    /// Fast path would change the rate of the points that are in the buffer.
    Permission operator()(const servo::IoControl&) const { return offThePath(); }
    Permission operator()(const servo::SetHoming&) const { return Permission::Allowed; }
    Permission operator()(const servo::ClearStickyBits&) const { return Permission::Allowed; }
    Permission operator()(const AnyOf<servo::ResetRelativeToHome, servo::SetPosition> auto&) const {
        return onlyAtStandstill(belief);
    }
    /// Each of its bits acts at once, and some of them can destroy an amplifier that is on.
    Permission operator()(const servo::ScIoControl&) const {
        if (!belief.fresh())
            return Permission::NeedsStatus;
        return belief.mayBeOn() || belief.mayMove() ? Permission::InMotion : Permission::Allowed;
    }
    /// Points belong to PathTask, which asks mayFollowPath().
    Permission operator()(const AnyOf<servo::AddPathPoints, servo::HardReset> auto&) const {
        return Permission::Never;
    }

    Permission operator()(const stepper::LoadTrajectory& load) const {
        if (!inTable(load) || !belief.parametersSet())
            return Permission::Never;
        // Without the start bit it has no effect whatsoever (DS-S 5.1).
        return load.startNow ? mayStart(load) : Permission::Allowed;
    }
    /// In motion the chip ignores a change of the speed mode and of the minimum speed (DS-S 5.1): nobody
    /// would know which are in force.
    Permission operator()(const stepper::SetParameters& parameters) const {
        const auto& now = belief.parameters();
        return now && stepper::sameInMotion(*now, parameters) ? Permission::Allowed
                                                              : onlyAtStandstill(belief);
    }
    Permission operator()(const stepper::StopMotor&) const { return Permission::Allowed; }
    Permission operator()(const stepper::SetOutputs&) const { return Permission::Allowed; }
    Permission operator()(const stepper::SetHoming&) const { return Permission::Allowed; }
    Permission operator()(const io::OwnCommand auto&) const { return Permission::Allowed; }

    [[nodiscard]] Permission offThePath() const {
        return belief.onPath() ? Permission::InMotion : Permission::Allowed;
    }
    [[nodiscard]] Permission mayStart(const stepper::LoadTrajectory& load) const {
        if (!belief.fresh())
            return Permission::NeedsStatus;
        return mayFollow(belief.stepperMode(), belief.runsReverse(), load) ? Permission::Allowed
                                                                           : Permission::InMotion;
    }
};

/// What every chip of the family takes for the same.
[[nodiscard]] bool isQuestion(CommandCode code) {
    return code == CommandCode::Nop || code == CommandCode::ReadStatus || code == CommandCode::DefineStatus;
}

/// The command is one of the module's own, as its version knows it.
[[nodiscard]] bool belongs(const ModuleIdentity& module, const ModuleCommand& command) {
    return std::visit(
        [&](const auto& own) {
            const CommandCode code = encode(own).code;
            if (!isKnown(module))
                return isQuestion(code) || code == CommandCode::StopMotor;
            return isQuestion(code) || takes(module, own);
        },
        command);
}

}  // namespace

Permission judge(const Belief& belief, const ModuleCommand& command) {
    if (belief.restarted() || !belongs(belief.info().identity, command))
        return Permission::Never;
    return std::visit([&](const auto& chip) { return std::visit(GateJudge{belief}, chip); }, command);
}

Permission mayFollowPath(const Belief& belief, servo::PathRate rate) {
    const auto& control = belief.pathControl();
    if (belief.restarted() || !hasPathBuffer(belief.info().identity) || !control ||
        control->stepAndDirection || !servo::toPathWord({0, rate}, control->fastPath))
        return Permission::Never;
    const Permission still = onlyAtStandstill(belief);
    return still == Permission::Allowed && !belief.on() ? Permission::Never : still;
}

}  // namespace nmc::bus

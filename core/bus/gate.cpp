// SPDX-License-Identifier: MIT
#include "bus/gate.h"

#include "base/overloaded.h"
#include "protocol/unsupported.h"

namespace nmc::bus {

namespace {

using servo::ProfileMode;

[[nodiscard]] Verdict onlyAtStandstill(const Belief& belief) {
    if (!belief.fresh())
        return Verdict::NeedsStatus;
    if (belief.mayMove())
        return Verdict::InMotion;
    // With the servo off the command velocity follows the actual one: a motor that coasts is in motion.
    if (belief.info().identity.type == ModuleType::Servo && !belief.on()) {
        if (!belief.velocity())
            return Verdict::NeedsStatus;
        return *belief.velocity() == 0 ? Verdict::Allowed : Verdict::InMotion;
    }
    return Verdict::Allowed;
}

/// Some mode of Table 4 knows what is loaded.
[[nodiscard]] bool inTable(const stepper::LoadTrajectory& load) {
    return goalMode(StepperMode::Stopped, load) || goalMode(StepperMode::Trapezoidal, load);
}

[[nodiscard]] bool trapezoidal(const servo::LoadTrajectory& load) {
    return load.servo && load.profile == ProfileMode::Trapezoidal;
}

struct Judge {
    const Belief& belief;

    Verdict operator()(const Nop&) const { return Verdict::Allowed; }
    Verdict operator()(const ReadStatus&) const { return Verdict::Allowed; }
    Verdict operator()(const DefineStatus&) const { return Verdict::Allowed; }
    Verdict operator()(const SetAddress&) const { return Verdict::Never; }
    Verdict operator()(const SetBaud&) const { return Verdict::Never; }
    Verdict operator()(const HardReset&) const { return Verdict::Never; }
    Verdict operator()(const ResetPosition&) const { return onlyAtStandstill(belief); }
    Verdict operator()(const SaveAsHome&) const { return Verdict::Allowed; }
    Verdict operator()(const StartMotion&) const {
        if (!belief.loaded())
            return Verdict::Never;
        if (const auto& load = belief.stepperLoad())
            return mayStart(*load);
        const auto& load = belief.servoLoad();
        return load && trapezoidal(*load) ? onlyAtStandstill(belief) : offThePath();
    }

    Verdict operator()(const servo::LoadTrajectory& load) const {
        // Until it is started a load changes nothing (DS-V 5.1, note 1).
        if (trapezoidal(load) && load.startNow)
            return Verdict::Never;
        return load.startNow ? offThePath() : Verdict::Allowed;
    }
    Verdict operator()(const AnyOf<servo::SetGain, servo::StopMotor> auto&) const { return Verdict::Allowed; }
    /// Fast path would change the rate of the points that are in the buffer.
    Verdict operator()(const servo::IoControl&) const { return offThePath(); }
    Verdict operator()(const servo::SetHoming&) const { return Verdict::Allowed; }
    Verdict operator()(const servo::ClearStickyBits&) const { return Verdict::Allowed; }
    Verdict operator()(const AnyOf<servo::ResetRelativeToHome, servo::SetPosition> auto&) const {
        return onlyAtStandstill(belief);
    }
    /// Each of its bits acts at once, and some of them can destroy an amplifier that is on.
    Verdict operator()(const servo::ScIoControl&) const {
        if (!belief.fresh())
            return Verdict::NeedsStatus;
        return belief.mayBeOn() || belief.mayMove() ? Verdict::InMotion : Verdict::Allowed;
    }
    /// Points belong to PathTask, which asks mayFollowPath().
    Verdict operator()(const AnyOf<servo::AddPathPoints, servo::HardReset> auto&) const {
        return Verdict::Never;
    }

    Verdict operator()(const stepper::LoadTrajectory& load) const {
        if (!inTable(load) || !belief.parametersSet())
            return Verdict::Never;
        // Without the start bit it has no effect whatsoever (DS-S 5.1).
        return load.startNow ? mayStart(load) : Verdict::Allowed;
    }
    /// In motion the chip ignores a change of the speed mode and of the minimum speed (DS-S 5.1): nobody
    /// would know which are in force.
    Verdict operator()(const stepper::SetParameters& parameters) const {
        const auto& now = belief.parameters();
        return now && stepper::sameInMotion(*now, parameters) ? Verdict::Allowed : onlyAtStandstill(belief);
    }
    Verdict operator()(const stepper::StopMotor&) const { return Verdict::Allowed; }
    Verdict operator()(const stepper::SetOutputs&) const { return Verdict::Allowed; }
    Verdict operator()(const stepper::SetHoming&) const { return Verdict::Allowed; }
    Verdict operator()(const io::OwnCommand auto&) const { return Verdict::Allowed; }

    [[nodiscard]] Verdict offThePath() const {
        return belief.onPath() ? Verdict::InMotion : Verdict::Allowed;
    }
    [[nodiscard]] Verdict mayStart(const stepper::LoadTrajectory& load) const {
        if (!belief.fresh())
            return Verdict::NeedsStatus;
        return mayFollow(belief.stepperMode(), belief.runsReverse(), load) ? Verdict::Allowed
                                                                           : Verdict::InMotion;
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

Verdict judge(const Belief& belief, const ModuleCommand& command) {
    if (belief.restarted() || !belongs(belief.info().identity, command))
        return Verdict::Never;
    return std::visit([&](const auto& chip) { return std::visit(Judge{belief}, chip); }, command);
}

Verdict mayFollowPath(const Belief& belief, servo::PathRate rate) {
    const auto& control = belief.pathControl();
    if (belief.restarted() || !hasPathBuffer(belief.info().identity) || !control ||
        control->stepAndDirection || !servo::toPathWord({0, rate}, control->fastPath))
        return Verdict::Never;
    const Verdict still = onlyAtStandstill(belief);
    return still == Verdict::Allowed && !belief.on() ? Verdict::Never : still;
}

}  // namespace nmc::bus

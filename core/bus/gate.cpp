// SPDX-License-Identifier: MIT
#include "bus/gate.h"

#include "module/commandfacts.h"
#include "protocol/takes.h"

namespace nmc::bus {

namespace {

[[nodiscard]] Permission onlyAtStandstill(const Belief& belief) {
    if (!belief.fresh())
        return Permission::NeedsStatus;
    if (belief.mayMove())
        return Permission::InMotion;
    // With the servo off, the command velocity follows the actual one: a motor that coasts is in motion.
    if (belief.info().identity.type == ModuleType::Servo && !belief.on()) {
        if (!belief.velocity())
            return Permission::NeedsStatus;
        return *belief.velocity() == 0 && !belief.rolls() ? Permission::Allowed : Permission::InMotion;
    }
    return Permission::Allowed;
}

[[nodiscard]] Permission offThePath(const Belief& belief) {
    return belief.onPath() ? Permission::InMotion : Permission::Allowed;
}

[[nodiscard]] Permission onlyWhileOff(const Belief& belief) {
    if (!belief.fresh())
        return Permission::NeedsStatus;
    return belief.mayBeOn() || belief.mayMove() ? Permission::InMotion : Permission::Allowed;
}

/// Commands that depend on what was loaded or set before.
struct AsLoaded {
    const Belief& belief;

    Permission operator()(const StartMotion&) const {
        if (const auto& load = belief.stepperLoad())
            return mayStart(*load);
        const auto& load = belief.servoLoad();
        if (!load)
            return Permission::Never;
        return mayStart(*load);
    }
    Permission operator()(const servo::LoadTrajectory& load) const { return mayStart(load); }
    Permission operator()(const stepper::LoadTrajectory& load) const {
        if (!inTable4(load) || !belief.parametersSet())
            return Permission::Never;
        // Without the start bit, it has no effect (DS-S 5.1).
        return load.startNow ? mayStart(load) : Permission::Allowed;
    }
    /// In motion, the chip ignores changes of the speed mode and the minimum speed (DS-S 5.1), so it would be
    /// unknown which ones are in force.
    Permission operator()(const stepper::SetParameters& parameters) const {
        const auto& now = belief.stepperRegisters().parameters;
        return now && stepper::sameInMotion(*now, parameters) ? Permission::Allowed
                                                              : onlyAtStandstill(belief);
    }
    Permission operator()(const auto& /*other*/) const { return Permission::Never; }

    /// PWM mode drops what the servo moves (DS-V 5.1, notes 1 and 2).
    [[nodiscard]] Permission mayStart(const servo::LoadTrajectory& load) const {
        const bool stands = load.servo ? load.isTrapezoidal() : belief.mayBeOn();
        return stands ? onlyAtStandstill(belief) : offThePath(belief);
    }
    [[nodiscard]] Permission mayStart(const stepper::LoadTrajectory& load) const {
        if (!belief.fresh())
            return Permission::NeedsStatus;
        return mayFollow(belief.stepperMode(), belief.runsReverse(), load) ? Permission::Allowed
                                                                           : Permission::InMotion;
    }
};

/// True if the command belongs to the module's chip, and its version supports it.
[[nodiscard]] bool belongs(const ModuleIdentity& module, const ModuleCommand& command) {
    if (isQuestion(command))
        return true;
    if (!isKnown(module))
        return payloadOf(command).code == CommandCode::StopMotor;
    return std::visit([&](const auto& own) { return takes(module, own); }, command);
}

}  // namespace

Permission permit(const Belief& belief, const ModuleCommand& command) {
    if (belief.restarted() || !belongs(belief.info().identity, command))
        return Permission::Never;
    switch (factsOf(command).when) {
        case When::Always:
            return Permission::Allowed;
        case When::Never:
            return Permission::Never;
        case When::Standstill:
            return onlyAtStandstill(belief);
        case When::OffThePath:
            return offThePath(belief);
        case When::MotorOff:
            return onlyWhileOff(belief);
        case When::AsLoaded:
            return visitCommand(AsLoaded{belief}, command);
    }
    return Permission::Never;
}

Permission mayFollowPath(const Belief& belief, servo::PathRate rate) {
    const auto& control = belief.servoRegisters().pathControl;
    if (belief.restarted() || !hasPathBuffer(belief.info().identity) || !control ||
        control->stepAndDirection || !servo::toPathWord({0, rate}, control->fastPath))
        return Permission::Never;
    const Permission still = onlyAtStandstill(belief);
    return still == Permission::Allowed && !belief.on() ? Permission::Never : still;
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "protocol/takes.h"

#include "base/overloaded.h"

namespace nmc {
namespace {

/// Checks a command for features that the version lacks. Ranges are left to the decoder, except those that
/// depend on the version.
struct VersionHas {
    const ModuleIdentity& module;

    [[nodiscard]] bool since(std::uint8_t version) const { return module.version >= version; }

    bool operator()(const AnyOf<DefineStatus, ReadStatus> auto& c) const {
        return (c.items.mask() & ~allItems(module).mask()) == 0;
    }
    bool operator()(const servo::LoadTrajectory& c) const {
        return (!c.relative || hasPathBuffer(module)) &&
               (!c.velocity || loadableVelocities(module).contains(c.velocity->value()));
    }
    bool operator()(const servo::SetGain& c) const {
        return (!c.sm || isSc(module)) && (!c.db || since(servo::kDeadbandVersion));
    }
    bool operator()(const servo::StopMotor& c) const {
        return (c.manner != servo::StopManner::Here || since(servo::kStopHereVersion)) &&
               (!c.advancedFeatures || module.version == kPathVersion);
    }
    bool operator()(const servo::IoControl& c) const {
        return !since(servo::kOtherIoVersion) && (!c.fastPath || hasPathBuffer(module));
    }
    bool operator()(const servo::SetHoming& c) const {
        return since(servo::kAutoStopVersion) || (!c.motorOff && !c.stopAbruptly && !c.stopSmoothly);
    }
    bool operator()(const AnyOf<servo::ResetRelativeToHome, servo::AddPathPoints> auto&) const {
        return hasPathBuffer(module);
    }
    bool operator()(const AnyOf<servo::SetPosition, servo::ScIoControl, servo::HardReset> auto&) const {
        return isSc(module);
    }
    bool operator()(const auto& /*other*/) const { return true; }
};

/// A command that does not decode to itself after encoding is not valid for the module.
template <typename Command, typename Decode>
bool takesAs(ModuleType chip, const ModuleIdentity& module, const Command& command, Decode decode) {
    if (!isKnown(module) || module.type != chip || !std::visit(VersionHas{module}, command))
        return false;
    return decode(encode(command)) == command;
}

}  // namespace

ValueRange loadableVelocities(const ModuleIdentity& module) {
    return hasPathBuffer(module) ? servo::kLaterVelocityRange : servo::kVelocityRange;
}

bool takes(const ModuleIdentity& module, const ServoCommand& command) {
    return takesAs(ModuleType::Servo, module, command,
                   [&module](const Payload& payload) { return decodeServoCommand(module, payload); });
}

bool takes(const ModuleIdentity& module, const StepperCommand& command) {
    return takesAs(ModuleType::Stepper, module, command, decodeStepCommand);
}

bool takes(const ModuleIdentity& module, const IoCommand& command) {
    return takesAs(ModuleType::Io, module, command, decodeIoCommand);
}

}  // namespace nmc

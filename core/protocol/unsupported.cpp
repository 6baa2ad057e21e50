// SPDX-License-Identifier: MIT
#include "protocol/unsupported.h"

namespace nmc {

namespace {

using Reason = std::optional<Unsupported>;

Reason reasonIf(bool condition, Unsupported reason) {
    return condition ? Reason(reason) : std::nullopt;
}

/// Checks a command for features that the version lacks. Ranges are left to the decoder, except those that
/// depend on the version.
struct ReasonOf {
    const ModuleIdentity& module;
    [[nodiscard]] bool before(std::uint8_t version) const { return module.version < version; }
    [[nodiscard]] Reason items(StatusItems asked) const {
        return reasonIf((asked.mask() & ~allItems(module).mask()) != 0, Unsupported::StatusItem);
    }

    Reason operator()(const DefineStatus& c) const { return items(c.items); }
    Reason operator()(const ReadStatus& c) const { return items(c.items); }
    Reason operator()(const servo::LoadTrajectory& c) const {
        if (c.relative && !hasPathBuffer(module))
            return Unsupported::RelativeMove;
        return reasonIf(
            hasPathBuffer(module) && c.velocity && !servo::kLaterVelocityRange.contains(c.velocity->value()),
            Unsupported::OutOfRange);
    }
    Reason operator()(const servo::SetGain& c) const {
        if (c.sm && !isSc(module))
            return Unsupported::StepMultiplier;
        return reasonIf(c.db && before(servo::kDeadbandVersion), Unsupported::Deadband);
    }
    Reason operator()(const servo::StopMotor& c) const {
        if (c.manner == servo::StopManner::Here && before(servo::kStopHereVersion))
            return Unsupported::StopHere;
        return reasonIf(c.advancedFeatures && module.version != kPathVersion, Unsupported::AdvancedFeatures);
    }
    Reason operator()(const servo::IoControl& c) const {
        if (!before(servo::kOtherIoVersion))
            return Unsupported::FirstIoControl;
        return reasonIf(c.fastPath && !hasPathBuffer(module), Unsupported::IoFastPath);
    }
    Reason operator()(const servo::SetHoming& c) const {
        return reasonIf((c.motorOff || c.stopAbruptly || c.stopSmoothly) && before(servo::kAutoStopVersion),
                        Unsupported::AutoStop);
    }
    Reason operator()(const servo::ResetRelativeToHome&) const {
        return reasonIf(!hasPathBuffer(module), Unsupported::RelativeReset);
    }
    Reason operator()(const servo::SetPosition&) const {
        return reasonIf(!isSc(module), Unsupported::SetPosition);
    }
    Reason operator()(const servo::ScIoControl&) const {
        return reasonIf(!isSc(module), Unsupported::ScIoControl);
    }
    Reason operator()(const servo::AddPathPoints&) const {
        return reasonIf(!hasPathBuffer(module), Unsupported::PathPoints);
    }
    Reason operator()(const servo::HardReset&) const {
        return reasonIf(!isSc(module), Unsupported::SavedConfiguration);
    }
    template <typename Command>
    Reason operator()(const Command&) const {
        return std::nullopt;
    }
};

/// A command that does not decode to itself after encoding is not valid for the module.
template <typename Command, typename Decode>
Reason reasonAgainst(const ModuleIdentity& module, ModuleType chip, const Command& command, Decode decode) {
    if (!isKnown(module))
        return Unsupported::UnknownModule;
    if (module.type != chip)
        return Unsupported::OtherChip;
    if (const Reason reason = std::visit(ReasonOf{module}, command))
        return reason;
    const auto decoded = decode(encode(command));
    return reasonIf(!decoded || *decoded != command, Unsupported::OutOfRange);
}

}  // namespace

std::optional<Unsupported> unsupported(const ModuleIdentity& module, const ServoCommand& command) {
    return reasonAgainst(module, ModuleType::Servo, command,
                         [&module](const Payload& payload) { return decodeServoCommand(module, payload); });
}

std::optional<Unsupported> unsupported(const ModuleIdentity& module, const StepperCommand& command) {
    return reasonAgainst(module, ModuleType::Stepper, command, decodeStepCommand);
}

std::optional<Unsupported> unsupported(const ModuleIdentity& module, const IoCommand& command) {
    return reasonAgainst(module, ModuleType::Io, command, decodeIoCommand);
}

std::string_view toText(Unsupported reason) {
    switch (reason) {
        case Unsupported::UnknownModule:
            return "the module is of a type or version that is not known";
        case Unsupported::OtherChip:
            return "the command belongs to another type of module";
        case Unsupported::StatusItem:
            return "the version has no such status item";
        case Unsupported::StopHere:
            return "version 1 cannot stop at a position";
        case Unsupported::AutoStop:
            return "versions before 3 do not stop when home is found";
        case Unsupported::Deadband:
            return "versions before 4 have no deadband compensation";
        case Unsupported::RelativeReset:
            return "versions before 5 cannot reset the position relative to home";
        case Unsupported::RelativeMove:
            return "versions before 5 have no relative moves";
        case Unsupported::PathPoints:
            return "versions before 5 have no path buffer";
        case Unsupported::AdvancedFeatures:
            return "only version 5 has advanced features to switch on";
        case Unsupported::FirstIoControl:
            return "version 10 has another I/O Control";
        case Unsupported::IoFastPath:
            return "versions before 5 have no path buffer to make fast";
        case Unsupported::SetPosition:
            return "versions before 10 cannot set the position to a value";
        case Unsupported::StepMultiplier:
            return "versions before 10 have no step multiplier";
        case Unsupported::ScIoControl:
            return "versions before 10 have another I/O Control";
        case Unsupported::SavedConfiguration:
            return "versions before 10 save no configuration";
        case Unsupported::OutOfRange:
            return "a value is outside the range of the data sheet";
    }
    return {};
}

}  // namespace nmc

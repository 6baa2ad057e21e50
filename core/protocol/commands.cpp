// SPDX-License-Identifier: MIT
#include "protocol/commands.h"

namespace nmc {

namespace {

/// Tries the alternatives of a command set in order until one has this code.
template <typename Variant, std::size_t I = 0>
tl::expected<Variant, CommandError> decodeAny(const Payload& payload, const ModuleIdentity& module) {
    if constexpr (I == std::variant_size_v<Variant>) {
        return tl::unexpected(CommandError::WrongCode);
    } else {
        const auto command = decode<std::variant_alternative_t<I, Variant>>(payload, module);
        if (command)
            return Variant(*command);
        if (command.error() == CommandError::WrongCode)
            return decodeAny<Variant, I + 1>(payload, module);
        return tl::unexpected(command.error());
    }
}

template <typename Command>
tl::expected<ServoCommand, CommandError> decodeAs(const Payload& payload, const ModuleIdentity& module) {
    return decode<Command>(payload, module).map([](const Command& command) { return ServoCommand(command); });
}

}  // namespace

/// Where several commands share a code, the first alternative is the one that all versions know.
tl::expected<ServoCommand, CommandError> decodeServoCommand(const ModuleIdentity& module,
                                                            const Payload& payload) {
    if (!hasPathBuffer(module) && payload.code == CommandCode::AddPathPoints)
        return tl::unexpected(CommandError::WrongCode);
    if (!hasPathBuffer(module))
        return decodeAny<ServoCommand>(payload, hasDataSheet(module) ? module : kFirstServo);
    const unsigned control = payload.data.empty() ? 0U : payload.data[0];
    if (payload.code == CommandCode::ResetPosition) {
        if (isSc(module) && ((control & 2U) != 0 || payload.data.size() > 1))
            return decodeAs<servo::SetPosition>(payload, module);
        if ((control & 1U) != 0)
            return decodeAs<servo::ResetRelativeToHome>(payload, module);
    }
    if (isSc(module) && payload.code == CommandCode::IoControl)
        return decodeAs<servo::ScIoControl>(payload, module);
    if (isSc(module) && payload.code == CommandCode::HardReset && !payload.data.empty())
        return decodeAs<servo::HardReset>(payload, module);
    return decodeAny<ServoCommand>(payload, module);
}

tl::expected<StepperCommand, CommandError> decodeStepCommand(const Payload& payload) {
    return decodeAny<StepperCommand>(payload, {ModuleType::Stepper, 1});
}

tl::expected<IoCommand, CommandError> decodeIoCommand(const Payload& payload) {
    return decodeAny<IoCommand>(payload, {ModuleType::Io, 1});
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "protocol/commands.h"

namespace nmc {

namespace {

/// Decodes the payload as the first alternative of a command set that has its code.
template <typename Variant, std::size_t I = 0>
std::optional<Variant> decodeAny(const Payload& payload, const ModuleIdentity& module) {
    if constexpr (I == std::variant_size_v<Variant>) {
        return std::nullopt;
    } else {
        using Command = std::variant_alternative_t<I, Variant>;
        if (payload.code != Command::kCode)
            return decodeAny<Variant, I + 1>(payload, module);
        return decode<Command>(payload, module);
    }
}

}  // namespace

/// Where several commands share a code, the first alternative is the one that all versions know.
std::optional<ServoCommand> decodeServoCommand(const ModuleIdentity& module, const Payload& payload) {
    if (!hasPathBuffer(module) && payload.code == CommandCode::AddPathPoints)
        return std::nullopt;
    if (!hasPathBuffer(module))
        return decodeAny<ServoCommand>(payload, hasDataSheet(module) ? module : kFirstServo);
    const unsigned control = payload.data.empty() ? 0U : payload.data[0];
    if (payload.code == CommandCode::ResetPosition) {
        if (isSc(module) && ((control & 2U) != 0 || payload.data.size() > 1))
            return decode<servo::SetPosition>(payload, module);
        if ((control & 1U) != 0)
            return decode<servo::ResetRelativeToHome>(payload, module);
    }
    if (isSc(module) && payload.code == CommandCode::IoControl)
        return decode<servo::ScIoControl>(payload, module);
    if (isSc(module) && payload.code == CommandCode::HardReset && !payload.data.empty())
        return decode<servo::HardReset>(payload, module);
    return decodeAny<ServoCommand>(payload, module);
}

std::optional<StepperCommand> decodeStepCommand(const Payload& payload) {
    return decodeAny<StepperCommand>(payload, {ModuleType::Stepper, 1});
}

std::optional<IoCommand> decodeIoCommand(const Payload& payload) {
    return decodeAny<IoCommand>(payload, {ModuleType::Io, 1});
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "protocol/commands.h"

#include "protocol/payloadcheck.h"

namespace nmc {

using detail::checkPayload;

namespace {

/// Decodes a command that is nothing but its code.
template <typename Command>
tl::expected<Command, CommandError> decodeBare(const Payload& payload, CommandCode code,
                                               std::size_t maxData = 0) {
    if (const auto error = checkPayload(payload, code, 0, maxData))
        return tl::unexpected(*error);
    return Command{};
}

/// Tries the alternatives of a command set until one owns the code.
template <typename Variant, std::size_t I = 0>
tl::expected<Variant, CommandError> decodeAny(const Payload& payload) {
    if constexpr (I == std::variant_size_v<Variant>) {
        return tl::unexpected(CommandError::WrongCode);
    } else {
        const auto command = std::variant_alternative_t<I, Variant>::decode(payload);
        if (command)
            return Variant(*command);
        if (command.error() == CommandError::WrongCode)
            return decodeAny<Variant, I + 1>(payload);
        return tl::unexpected(command.error());
    }
}

}  // namespace

Payload ResetPosition::encode() const {
    return {CommandCode::ResetPosition, {}};
}

tl::expected<ResetPosition, CommandError> ResetPosition::decode(const Payload& payload) {
    return decodeBare<ResetPosition>(payload, CommandCode::ResetPosition, 1);
}

Payload SetAddress::encode() const {
    const auto groupByte = static_cast<std::uint8_t>(leader ? group.value() & 0x7FU : group.value() | 0x80U);
    return {CommandCode::SetAddress, {address.value(), groupByte}};
}

tl::expected<SetAddress, CommandError> SetAddress::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetAddress, 2, 2))
        return tl::unexpected(*error);
    const std::uint8_t groupByte = payload.data[1];
    return SetAddress{BusAddress(payload.data[0]), BusAddress(static_cast<std::uint8_t>(groupByte | 0x80U)),
                      !detail::bitOf(groupByte, 7)};
}

Payload DefineStatus::encode() const {
    return {CommandCode::DefineStatus, {items.mask()}};
}

tl::expected<DefineStatus, CommandError> DefineStatus::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::DefineStatus, 1, 1))
        return tl::unexpected(*error);
    return DefineStatus{StatusItems(payload.data[0])};
}

Payload ReadStatus::encode() const {
    return {CommandCode::ReadStatus, {items.mask()}};
}

tl::expected<ReadStatus, CommandError> ReadStatus::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::ReadStatus, 1, 1))
        return tl::unexpected(*error);
    return ReadStatus{StatusItems(payload.data[0])};
}

Payload StartMotion::encode() const {
    return {CommandCode::StartMotion, {}};
}

tl::expected<StartMotion, CommandError> StartMotion::decode(const Payload& payload) {
    return decodeBare<StartMotion>(payload, CommandCode::StartMotion);
}

Payload SetBaud::encode() const {
    return {CommandCode::SetBaud, {brd}};
}

tl::expected<SetBaud, CommandError> SetBaud::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetBaud, 1, 1))
        return tl::unexpected(*error);
    return SetBaud{payload.data[0]};
}

Payload SaveAsHome::encode() const {
    return {CommandCode::SaveAsHome, {}};
}

tl::expected<SaveAsHome, CommandError> SaveAsHome::decode(const Payload& payload) {
    return decodeBare<SaveAsHome>(payload, CommandCode::SaveAsHome);
}

Payload Nop::encode() const {
    return {CommandCode::Nop, {}};
}

tl::expected<Nop, CommandError> Nop::decode(const Payload& payload) {
    return decodeBare<Nop>(payload, CommandCode::Nop);
}

Payload HardReset::encode() const {
    return {CommandCode::HardReset, {}};
}

tl::expected<HardReset, CommandError> HardReset::decode(const Payload& payload) {
    return decodeBare<HardReset>(payload, CommandCode::HardReset, 1);
}

namespace {

using FirstServoCommand =
    std::variant<ResetPosition, SetAddress, DefineStatus, ReadStatus, servo::LoadTrajectory, StartMotion,
                 servo::SetGain, servo::StopMotor, servo::IoControl, servo::SetHoming, SetBaud,
                 servo::ClearStickyBits, SaveAsHome, Nop, HardReset>;

template <typename Command>
tl::expected<ServoCommand, CommandError> decodeAs(const Payload& payload) {
    return Command::decode(payload).map([](const Command& command) { return ServoCommand(command); });
}

tl::expected<ServoCommand, CommandError> decodeFirst(const Payload& payload) {
    return decodeAny<FirstServoCommand>(payload).map([](const FirstServoCommand& command) {
        return std::visit([](const auto& c) { return ServoCommand(c); }, command);
    });
}

tl::expected<ServoCommand, CommandError> decodeReset(const ModuleIdentity& module, const Payload& payload) {
    const std::uint8_t control = payload.data.empty() ? std::uint8_t{0} : payload.data[0];
    if (isSc(module) && (detail::bitOf(control, 1) || payload.data.size() > 1))
        return decodeAs<servo::SetPosition>(payload);
    return detail::bitOf(control, 0) ? decodeAs<servo::ResetRelativeToHome>(payload) : decodeFirst(payload);
}

/// Bits and bytes of the first commands that only later versions read.
struct LaterParts {
    const ModuleIdentity& module;
    const Payload& payload;
    [[nodiscard]] bool bit(unsigned number) const { return detail::bitOf(payload.data[0], number); }

    void operator()(servo::LoadTrajectory& load) const {
        const bool relative = load.servo && load.profile == servo::ProfileMode::Trapezoidal && load.reverse;
        load.relative = relative;
        load.reverse = load.reverse && !relative;
    }
    void operator()(servo::SetGain& gains) const {
        if (isSc(module) && payload.data.size() > 14)
            gains.sm = payload.data[14];
    }
    void operator()(servo::StopMotor& stop) const { stop.advancedFeatures = !isSc(module) && bit(5); }
    void operator()(servo::IoControl& control) const { control.fastPath = bit(6); }
    template <typename Command>
    void operator()(Command&) const {}
};

}  // namespace

tl::expected<ServoCommand, CommandError> decodeServoCommand(const ModuleIdentity& module,
                                                            const Payload& payload) {
    if (!hasPathBuffer(module))
        return decodeFirst(payload);
    if (payload.code == CommandCode::ResetPosition)
        return decodeReset(module, payload);
    if (payload.code == CommandCode::AddPathPoints)
        return decodeAs<servo::AddPathPoints>(payload);
    if (isSc(module) && payload.code == CommandCode::IoControl)
        return decodeAs<servo::ScIoControl>(payload);
    if (isSc(module) && payload.code == CommandCode::HardReset && !payload.data.empty())
        return decodeAs<servo::HardReset>(payload);
    auto command = decodeFirst(payload);
    if (command)
        std::visit(LaterParts{module, payload}, *command);
    return command;
}

tl::expected<StepperCommand, CommandError> decodeStepCommand(const Payload& payload) {
    return decodeAny<StepperCommand>(payload);
}

tl::expected<IoCommand, CommandError> decodeIoCommand(const Payload& payload) {
    return decodeAny<IoCommand>(payload);
}

}  // namespace nmc

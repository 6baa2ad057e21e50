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
    return decodeBare<HardReset>(payload, CommandCode::HardReset);
}

tl::expected<ServoCommand, CommandError> decodeServoCommand(const Payload& payload) {
    return decodeAny<ServoCommand>(payload);
}

tl::expected<StepCommand, CommandError> decodeStepCommand(const Payload& payload) {
    return decodeAny<StepCommand>(payload);
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "protocol/laterservocommands.h"

#include "protocol/payloadcheck.h"

namespace nmc::servo {

using detail::bitOf;
using detail::checkPayload;
using detail::packBits;

namespace {

constexpr std::uint8_t kRelativeToHome = 0x01;
constexpr std::uint8_t kToValue = 0x02;

}  // namespace

Payload ResetRelativeToHome::encode() const {
    return {CommandCode::ResetPosition, {kRelativeToHome}};
}

tl::expected<ResetRelativeToHome, CommandError> ResetRelativeToHome::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::ResetPosition, 1, 1))
        return tl::unexpected(*error);
    // "One of bits 0 and 1 only."
    if ((payload.data[0] & (kRelativeToHome | kToValue)) != kRelativeToHome)
        return tl::unexpected(CommandError::OutOfRange);
    return ResetRelativeToHome{};
}

Payload SetPosition::encode() const {
    Payload payload{CommandCode::ResetPosition, {kToValue}};
    payload.data.appendLittleEndian(position.value());
    return payload;
}

tl::expected<SetPosition, CommandError> SetPosition::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::ResetPosition, 5, 5))
        return tl::unexpected(*error);
    if ((payload.data[0] & (kRelativeToHome | kToValue)) != kToValue)
        return tl::unexpected(CommandError::OutOfRange);
    return SetPosition{Counts(readLittleEndian<std::int32_t>(ByteSpan(payload.data).subspan(1)))};
}

Payload ScIoControl::encode() const {
    return {CommandCode::IoControl,
            {packBits(false, false, limitStop == LimitStop::MotorOff, limitStop == LimitStop::Abruptly,
                      threePhase, antiphase, fastPath, stepAndDirection)}};
}

tl::expected<ScIoControl, CommandError> ScIoControl::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::IoControl, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    ScIoControl command;
    if (bitOf(control, 2))
        command.limitStop = LimitStop::MotorOff;
    if (bitOf(control, 3))
        command.limitStop = LimitStop::Abruptly;
    command.threePhase = bitOf(control, 4);
    command.antiphase = bitOf(control, 5);
    command.fastPath = bitOf(control, 6);
    command.stepAndDirection = bitOf(control, 7);
    // One manner of stopping; and step and direction wants both bits clear.
    const int bits = int{bitOf(control, 2)} + int{bitOf(control, 3)};
    if (bits + int{command.stepAndDirection} > 1)
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

std::optional<AddPathPoints> AddPathPoints::of(std::span<const PathPoint> points, bool fastPath) {
    AddPathPoints command;
    if (points.size() > kMaxPoints)
        return std::nullopt;
    for (const PathPoint& point : points) {
        const auto word = toPathWord(point, fastPath);
        if (!word)
            return std::nullopt;
        command.m_words[command.m_count++] = *word;
    }
    return command;
}

Payload AddPathPoints::encode() const {
    Payload payload{CommandCode::AddPathPoints, {}};
    for (const std::uint16_t word : words())
        payload.data.appendLittleEndian(word);
    return payload;
}

tl::expected<AddPathPoints, CommandError> AddPathPoints::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::AddPathPoints, 0, 2 * kMaxPoints))
        return tl::unexpected(*error);
    if (payload.data.size() % 2 != 0)
        return tl::unexpected(CommandError::Length);
    AddPathPoints command;
    detail::DataReader reader(payload.data);
    while (command.m_count < payload.data.size() / 2)
        command.m_words[command.m_count++] = reader.take<std::uint16_t>();
    return command;
}

Payload HardReset::encode() const {
    return {CommandCode::HardReset,
            {packBits(save, restoreAddresses, amplifierOn, servoOn, stepAndDirection, limitProtection,
                      threePhase, antiphase)}};
}

tl::expected<HardReset, CommandError> HardReset::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::HardReset, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    return HardReset{bitOf(control, 0), bitOf(control, 1), bitOf(control, 2), bitOf(control, 3),
                     bitOf(control, 4), bitOf(control, 5), bitOf(control, 6), bitOf(control, 7)};
}

}  // namespace nmc::servo

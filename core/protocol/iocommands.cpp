// SPDX-License-Identifier: MIT
#include "protocol/iocommands.h"

#include "protocol/payloadcheck.h"

namespace nmc::io {

using detail::bitOf;
using detail::checkPayload;
using detail::packBits;

namespace {

/// IO1 to IO8, then IO9 to IO12 in the low nibble.
void appendPins(Payload& payload, std::uint16_t pins) {
    payload.data.appendLittleEndian(static_cast<std::uint16_t>(pins & kAllPins));
}

std::uint16_t pinsOf(const Payload& payload) {
    return static_cast<std::uint16_t>(readLittleEndian<std::uint16_t>(payload.data) & kAllPins);
}

}  // namespace

Payload SetDirection::encode() const {
    Payload payload{CommandCode::ResetPosition, {}};
    appendPins(payload, inputs);
    return payload;
}

tl::expected<SetDirection, CommandError> SetDirection::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::ResetPosition, 2, 2))
        return tl::unexpected(*error);
    return SetDirection{pinsOf(payload)};
}

Payload SetPwm::encode() const {
    return {CommandCode::LoadTrajectory, {pwm1, pwm2}};
}

tl::expected<SetPwm, CommandError> SetPwm::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::LoadTrajectory, 2, 2))
        return tl::unexpected(*error);
    return SetPwm{payload.data[0], payload.data[1]};
}

Payload SynchOutput::encode() const {
    return {CommandCode::StartMotion, {}};
}

tl::expected<SynchOutput, CommandError> SynchOutput::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::StartMotion, 0, 0))
        return tl::unexpected(*error);
    return SynchOutput{};
}

Payload SetOutput::encode() const {
    Payload payload{CommandCode::SetGain, {}};
    appendPins(payload, outputs);
    return payload;
}

tl::expected<SetOutput, CommandError> SetOutput::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetGain, 2, 2))
        return tl::unexpected(*error);
    return SetOutput{pinsOf(payload)};
}

Payload SetSynchOutput::encode() const {
    Payload payload{CommandCode::StopMotor, {}};
    appendPins(payload, outputs);
    payload.data.push_back(pwm1);
    payload.data.push_back(pwm2);
    return payload;
}

tl::expected<SetSynchOutput, CommandError> SetSynchOutput::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::StopMotor, 4, 4))
        return tl::unexpected(*error);
    return SetSynchOutput{pinsOf(payload), payload.data[2], payload.data[3]};
}

Payload SetTimerMode::encode() const {
    const unsigned prescale = static_cast<unsigned>(prescaler) << 4U;
    return {CommandCode::IoControl, {static_cast<std::uint8_t>(packBits(enable, counter) | prescale)}};
}

tl::expected<SetTimerMode, CommandError> SetTimerMode::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::IoControl, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t mode = payload.data[0];
    return SetTimerMode{bitOf(mode, 0), bitOf(mode, 1), static_cast<Prescaler>(mode >> 4U & 0x03U)};
}

Payload SynchInput::encode() const {
    return {CommandCode::SaveAsHome, {}};
}

tl::expected<SynchInput, CommandError> SynchInput::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SaveAsHome, 0, 0))
        return tl::unexpected(*error);
    return SynchInput{};
}

}  // namespace nmc::io

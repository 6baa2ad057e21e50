// SPDX-License-Identifier: MIT
#include "protocol/servocommands.h"

#include "protocol/payloadcheck.h"

namespace nmc::servo {

using detail::bitOf;
using detail::checkPayload;
using detail::packBits;

Payload LoadTrajectory::encode() const {
    Payload payload{CommandCode::LoadTrajectory, {}};
    payload.data.push_back(packBits(position.has_value(), velocity.has_value(), acceleration.has_value(),
                                    pwm.has_value(), servo, profile == ProfileMode::Velocity,
                                    reverse || relative, startNow));
    if (position)
        payload.data.appendLittleEndian(position->value());
    if (velocity)
        payload.data.appendLittleEndian(velocity->value());
    if (acceleration)
        payload.data.appendLittleEndian(acceleration->value());
    if (pwm)
        payload.data.push_back(*pwm);
    return payload;
}

tl::expected<LoadTrajectory, CommandError> LoadTrajectory::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::LoadTrajectory, 1, 14))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    const std::size_t announced = 1U + (bitOf(control, 0) ? 4U : 0U) + (bitOf(control, 1) ? 4U : 0U) +
                                  (bitOf(control, 2) ? 4U : 0U) + (bitOf(control, 3) ? 1U : 0U);
    if (payload.data.size() != announced)
        return tl::unexpected(CommandError::Length);

    LoadTrajectory command;
    detail::DataReader reader(ByteSpan(payload.data).subspan(1));
    if (bitOf(control, 0))
        command.position = Counts(reader.take<std::int32_t>());
    if (bitOf(control, 1))
        command.velocity = CountsPerTick(reader.take<std::uint32_t>());
    if (bitOf(control, 2))
        command.acceleration = CountsPerTickSquared(reader.take<std::uint32_t>());
    if (bitOf(control, 3))
        command.pwm = reader.take<std::uint8_t>();
    command.servo = bitOf(control, 4);
    command.profile = bitOf(control, 5) ? ProfileMode::Velocity : ProfileMode::Trapezoidal;
    command.reverse = bitOf(control, 6);
    command.startNow = bitOf(control, 7);
    if ((command.position && !kPositionRange.contains(command.position->value())) ||
        (command.velocity && !kVelocityRange.contains(command.velocity->value())) ||
        (command.acceleration && !kVelocityRange.contains(command.acceleration->value())))
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

Payload SetGain::encode() const {
    Payload payload{CommandCode::SetGain, {}};
    payload.data.appendLittleEndian(kp);
    payload.data.appendLittleEndian(kd);
    payload.data.appendLittleEndian(ki);
    payload.data.appendLittleEndian(il);
    payload.data.push_back(ol);
    payload.data.push_back(cl);
    payload.data.appendLittleEndian(el);
    payload.data.push_back(sr);
    if (db)
        payload.data.push_back(*db);
    if (db && sm)
        payload.data.push_back(*sm);
    return payload;
}

tl::expected<SetGain, CommandError> SetGain::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetGain, 13, 15))
        return tl::unexpected(*error);
    detail::DataReader reader(payload.data);
    SetGain gains;
    gains.kp = reader.take<std::uint16_t>();
    gains.kd = reader.take<std::uint16_t>();
    gains.ki = reader.take<std::uint16_t>();
    gains.il = reader.take<std::uint16_t>();
    gains.ol = reader.take<std::uint8_t>();
    gains.cl = reader.take<std::uint8_t>();
    gains.el = reader.take<std::uint16_t>();
    gains.sr = reader.take<std::uint8_t>();
    if (payload.data.size() >= 14)
        gains.db = reader.take<std::uint8_t>();
    for (const std::uint16_t gain : {gains.kp, gains.kd, gains.ki, gains.il})
        if (!kGainRange.contains(gain))
            return tl::unexpected(CommandError::OutOfRange);
    if (!kPositionErrorRange.contains(gains.el) || !kServoRateRange.contains(gains.sr))
        return tl::unexpected(CommandError::OutOfRange);
    return gains;
}

Payload StopMotor::encode() const {
    Payload payload{CommandCode::StopMotor, {}};
    payload.data.push_back(packBits(amplifierEnable, manner == StopManner::MotorOff,
                                    manner == StopManner::Abruptly, manner == StopManner::Smoothly,
                                    manner == StopManner::Here, advancedFeatures));
    if (manner == StopManner::Here)
        payload.data.appendLittleEndian(here.value());
    return payload;
}

tl::expected<StopMotor, CommandError> StopMotor::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::StopMotor, 1, 5))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    if (payload.data.size() != (bitOf(control, 4) ? 5U : 1U))
        return tl::unexpected(CommandError::Length);
    StopMotor command;
    command.amplifierEnable = bitOf(control, 0);
    switch (control & 0x1EU) {
        case 0x00:
            command.manner = StopManner::AmplifierOnly;
            break;
        case 0x02:
            command.manner = StopManner::MotorOff;
            break;
        case 0x04:
            command.manner = StopManner::Abruptly;
            break;
        case 0x08:
            command.manner = StopManner::Smoothly;
            break;
        case 0x10:
            command.manner = StopManner::Here;
            command.here = Counts(readLittleEndian<std::int32_t>(ByteSpan(payload.data).subspan(1)));
            break;
        default:  // "only one of the bits 1, 2, 3 or 4 should be set"
            return tl::unexpected(CommandError::OutOfRange);
    }
    return command;
}

Payload IoControl::encode() const {
    return {CommandCode::IoControl,
            {packBits(limit1Output, limit2Output, limit1IsInput, limit2IsInput, false, false, fastPath)}};
}

tl::expected<IoControl, CommandError> IoControl::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::IoControl, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    return IoControl{bitOf(control, 0), bitOf(control, 1), bitOf(control, 2), bitOf(control, 3)};
}

Payload SetHoming::encode() const {
    return {CommandCode::SetHoming,
            {packBits(onLimit1Change, onLimit2Change, motorOff, onIndexChange, stopAbruptly, stopSmoothly,
                      onPositionError, onCurrentLimit)}};
}

tl::expected<SetHoming, CommandError> SetHoming::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetHoming, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    SetHoming command;
    command.onLimit1Change = bitOf(control, 0);
    command.onLimit2Change = bitOf(control, 1);
    command.motorOff = bitOf(control, 2);
    command.onIndexChange = bitOf(control, 3);
    command.stopAbruptly = bitOf(control, 4);
    command.stopSmoothly = bitOf(control, 5);
    command.onPositionError = bitOf(control, 6);
    command.onCurrentLimit = bitOf(control, 7);
    if (int{command.motorOff} + int{command.stopAbruptly} + int{command.stopSmoothly} > 1)
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

Payload ClearStickyBits::encode() const {
    return {CommandCode::ClearStickyBits, {}};
}

tl::expected<ClearStickyBits, CommandError> ClearStickyBits::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::ClearStickyBits, 0, 0))
        return tl::unexpected(*error);
    return ClearStickyBits{};
}

}  // namespace nmc::servo

// SPDX-License-Identifier: MIT
#include "protocol/steppercommands.h"

#include "protocol/payloadcheck.h"

namespace nmc::stepper {

using detail::bitOf;
using detail::checkPayload;
using detail::packBits;

Payload LoadTrajectory::encode() const {
    Payload payload{CommandCode::LoadTrajectory, {}};
    payload.data.push_back(packBits(position.has_value(), speed.has_value(), accelerationTime.has_value(),
                                    timer.has_value(), reverse, false, false, startNow));
    if (position)
        payload.data.appendLittleEndian(position->value());
    if (speed)
        payload.data.push_back(*speed);
    if (accelerationTime)
        payload.data.push_back(*accelerationTime);
    if (timer) {
        payload.data.appendLittleEndian(timer->count);
        payload.data.push_back(timer->nearestSpeed);
    }
    return payload;
}

tl::expected<LoadTrajectory, CommandError> LoadTrajectory::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::LoadTrajectory, 1, 10))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    const std::size_t announced = 1U + (bitOf(control, 0) ? 4U : 0U) + (bitOf(control, 1) ? 1U : 0U) +
                                  (bitOf(control, 2) ? 1U : 0U) + (bitOf(control, 3) ? 3U : 0U);
    if (payload.data.size() != announced)
        return tl::unexpected(CommandError::Length);

    LoadTrajectory command;
    detail::DataReader reader(ByteSpan(payload.data).subspan(1));
    if (bitOf(control, 0))
        command.position = Counts(reader.take<std::int32_t>());
    if (bitOf(control, 1))
        command.speed = reader.take<std::uint8_t>();
    if (bitOf(control, 2))
        command.accelerationTime = reader.take<std::uint8_t>();
    if (bitOf(control, 3)) {
        const auto count = reader.take<std::uint16_t>();
        command.timer = TimerCount{count, reader.take<std::uint8_t>()};
    }
    command.reverse = bitOf(control, 4);
    command.startNow = bitOf(control, 7);
    if ((command.position && !kPositionRange.contains(command.position->value())) ||
        (command.speed && !kSpeedRange.contains(*command.speed)) ||
        (command.accelerationTime && !kAccelerationTimeRange.contains(*command.accelerationTime)) ||
        (command.timer && (!kTimerCountRange.contains(command.timer->count) ||
                           !kSpeedRange.contains(command.timer->nearestSpeed))))
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

Payload SetParameters::encode() const {
    const auto mode = static_cast<std::uint8_t>(
        static_cast<unsigned>(speedMode) |
        unsigned{packBits(false, false, ignoreLimits, ignoreEstop, motorOffOnLimitOrEstop)});
    return {CommandCode::SetGain, {mode, minimumProfileSpeed, runCurrent, holdCurrent, thermalLimit}};
}

tl::expected<SetParameters, CommandError> SetParameters::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetGain, 5, 5))
        return tl::unexpected(*error);
    const std::uint8_t mode = payload.data[0];
    SetParameters command;
    command.speedMode = static_cast<SpeedMode>(mode & 0x03U);
    command.ignoreLimits = bitOf(mode, 2);
    command.ignoreEstop = bitOf(mode, 3);
    command.motorOffOnLimitOrEstop = bitOf(mode, 4);
    command.minimumProfileSpeed = payload.data[1];
    command.runCurrent = payload.data[2];
    command.holdCurrent = payload.data[3];
    command.thermalLimit = payload.data[4];
    if (!kSpeedRange.contains(command.minimumProfileSpeed))
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

Payload StopMotor::encode() const {
    return {
        CommandCode::StopMotor,
        {packBits(amplifierEnable, false, manner == StopManner::Abruptly, manner == StopManner::Smoothly)}};
}

tl::expected<StopMotor, CommandError> StopMotor::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::StopMotor, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    if (bitOf(control, 2) && bitOf(control, 3))
        return tl::unexpected(CommandError::OutOfRange);
    const StopManner manner = bitOf(control, 2)   ? StopManner::Abruptly
                              : bitOf(control, 3) ? StopManner::Smoothly
                                                  : StopManner::AmplifierOnly;
    return StopMotor{bitOf(control, 0), manner};
}

Payload SetOutputs::encode() const {
    return {CommandCode::IoControl, {outputs}};
}

tl::expected<SetOutputs, CommandError> SetOutputs::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::IoControl, 1, 1))
        return tl::unexpected(*error);
    return SetOutputs{static_cast<std::uint8_t>(payload.data[0] & 0x1FU)};
}

Payload SetHoming::encode() const {
    return {
        CommandCode::SetHoming,
        {packBits(onLimit1Change, onLimit2Change, motorOff, onHomeSwitchChange, stopAbruptly, stopSmoothly)}};
}

tl::expected<SetHoming, CommandError> SetHoming::decode(const Payload& payload) {
    if (const auto error = checkPayload(payload, CommandCode::SetHoming, 1, 1))
        return tl::unexpected(*error);
    const std::uint8_t control = payload.data[0];
    SetHoming command;
    command.onLimit1Change = bitOf(control, 0);
    command.onLimit2Change = bitOf(control, 1);
    command.motorOff = bitOf(control, 2);
    command.onHomeSwitchChange = bitOf(control, 3);
    command.stopAbruptly = bitOf(control, 4);
    command.stopSmoothly = bitOf(control, 5);
    if (int{command.motorOff} + int{command.stopAbruptly} + int{command.stopSmoothly} > 1)
        return tl::unexpected(CommandError::OutOfRange);
    return command;
}

}  // namespace nmc::stepper

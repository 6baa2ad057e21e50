// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "model/module/modulestate.h"

namespace nmc::testing_support {

/// After this count, the position counter wraps.
inline constexpr std::int32_t kLastCount = std::numeric_limits<std::int32_t>::max();

inline constexpr std::uint8_t kMoveDone = 0x01;
inline constexpr std::uint8_t kPower = 0x08;
inline constexpr std::uint8_t kPosError = 0x10;
inline constexpr std::uint8_t kHoming = 0x80;
inline constexpr std::uint8_t kServoOn = 0x04;
inline constexpr std::uint8_t kAccelDone = 0x08;
inline constexpr std::uint8_t kSlewDone = 0x10;

inline TimePoint atSeconds(double s) {
    return TimePoint(fromSeconds(s));
}

inline bus::Sample sampleOf(double seconds, std::uint8_t status, std::uint8_t aux,
                            std::int32_t position = 0) {
    StatusReport report;
    report.items = StatusItems(StatusItems::Position | StatusItems::Aux);
    report.status = status;
    report.aux = aux;
    report.position = position;
    return {ModuleIndex(0), atSeconds(seconds), report};
}

inline bus::CommandExecuted executedAt(double seconds, ServoCommand command) {
    return {ModuleIndex(0), atSeconds(seconds), std::move(command)};
}

inline ModuleState servoModule(std::uint8_t version = 4) {
    ModuleState module;
    module.info = {ModuleIndex(0), BusAddress(1), {ModuleType::Servo, version}};
    return module;
}

inline servo::LoadTrajectory trapezoid(std::int32_t goal, std::uint32_t velocity,
                                       std::uint32_t acceleration) {
    servo::LoadTrajectory load;
    load.position = Counts(goal);
    load.velocity = CountsPerTick(velocity);
    load.acceleration = CountsPerTickSquared(acceleration);
    return load;
}

inline servo::LoadTrajectory velocityMode(std::uint32_t velocity, std::uint32_t acceleration,
                                          bool reverse = false) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(velocity);
    load.acceleration = CountsPerTickSquared(acceleration);
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = reverse;
    load.startNow = true;
    return load;
}

inline servo::StopMotor stopWith(servo::StopManner manner, bool amplifier = true) {
    return {amplifier, manner, {}};
}

/// A servo that has gains, is on, and holds position 0.
inline ModuleState holdingServo() {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    servo::SetGain gains;
    gains.kp = 200;
    gains.kd = 2'000;
    gains.ol = 255;
    gains.el = 8'000;
    gains.db = std::uint8_t{0};
    module.apply(executedAt(0.1, gains));
    module.apply(executedAt(0.2, stopWith(servo::StopManner::Abruptly)));
    module.apply(sampleOf(0.2, kMoveDone | kPosError | kPower, kServoOn));
    return module;
}

}  // namespace nmc::testing_support

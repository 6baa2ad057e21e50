// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bus/types.h"

/// Requests of a panel as steps; the gains are those of simulator.md, which suit the simulated motor.
namespace nmc::test {

/// A velocity: one count per tick.
inline constexpr std::uint32_t kOnePerTick = 65'536;

[[nodiscard]] inline bus::Order toServo(std::uint8_t module, ServoCommand command) {
    return {ModuleIndex(module), std::move(command)};
}

[[nodiscard]] inline bus::Order gains(std::uint8_t module) {
    return toServo(module, servo::SetGain{200, 2000, 20, 200, 255, 0, 4000, 1, std::uint8_t{0}});
}

[[nodiscard]] inline bus::Order enable(std::uint8_t module) {
    return toServo(module, servo::StopMotor{true, servo::StopManner::Abruptly, {}});
}

[[nodiscard]] inline bus::Order motorOff(std::uint8_t module) {
    return toServo(module, servo::StopMotor{false, servo::StopManner::MotorOff, {}});
}

/// Loads a move with up to 2 counts per tick and 0.01 counts per tick squared.
[[nodiscard]] inline bus::Order loadMove(std::uint8_t module, std::int32_t goal) {
    servo::LoadTrajectory load;
    load.position = Counts(goal);
    load.velocity = CountsPerTick(2 * 65'536);
    load.acceleration = CountsPerTickSquared(655);
    return toServo(module, load);
}

[[nodiscard]] inline bus::Order start(std::uint8_t module) {
    return toServo(module, StartMotion{});
}

[[nodiscard]] inline bus::Order loadVelocity(std::uint8_t module, std::uint32_t velocity,
                                             bool startNow = false) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(velocity);
    load.acceleration = CountsPerTickSquared(655);
    load.profile = servo::ProfileMode::Velocity;
    load.startNow = startNow;
    return toServo(module, load);
}

[[nodiscard]] inline bus::Order loadPwm(std::uint8_t module, std::uint8_t pwm) {
    servo::LoadTrajectory load;
    load.pwm = pwm;
    load.servo = false;
    load.startNow = true;
    return toServo(module, load);
}

/// A hold with a new press each time.
[[nodiscard]] inline bus::HoldToMove forward(std::uint8_t module, std::uint32_t velocity = kOnePerTick) {
    static std::uint32_t presses = 0;
    return {ModuleIndex(module), CountsPerTick(velocity), CountsPerTickSquared(655), false, {}, ++presses};
}

/// A load for a PIC-STEP with only these of its items, in the order of DS-S 5.1, Table 4.
[[nodiscard]] inline stepper::LoadTrajectory partOf(stepper::LoadTrajectory load, bool position, bool speed,
                                                    bool acceleration, bool timer) {
    if (!position)
        load.position.reset();
    if (!speed)
        load.speed.reset();
    if (!acceleration)
        load.accelerationTime.reset();
    if (!timer)
        load.timer.reset();
    return load;
}

}  // namespace nmc::test

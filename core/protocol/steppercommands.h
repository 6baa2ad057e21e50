// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/strong.h"
#include "protocol/commandform.h"

/// The commands that only a PIC-STEP has, or that mean something else on a PIC-SERVO (DS-S 5.1).
namespace nmc::stepper {

inline constexpr ValueRange kPositionRange{-0x7FFFFFFFLL, 0x7FFFFFFFLL};
inline constexpr ValueRange kSpeedRange{1, 250};
inline constexpr ValueRange kNearestSpeedRange{0, 250};      ///< 0 is nearest to less than half a speed unit
inline constexpr ValueRange kAccelerationTimeRange{1, 255};  ///< units of 0.25 ms per speed unit
inline constexpr ValueRange kTimerCountRange{1, 65'452};
inline constexpr ValueRange kByteRange{0, 0xFF};

/// A timer count is sent together with the nearest integer speed, from which a later ramp starts.
struct TimerCount {
    std::uint16_t count = 1;
    std::uint8_t nearestSpeed = 1;
    bool operator==(const TimerCount&) const = default;
};

/// Load Trajectory. The values that are loaded determine the mode (DS-S table 4).
struct LoadTrajectory {
    std::optional<Counts> position;                ///< steps
    std::optional<std::uint8_t> speed;             ///< 1..250
    std::optional<std::uint8_t> accelerationTime;  ///< 1..255
    std::optional<TimerCount> timer;
    bool reverse = false;
    bool startNow = false;

    static constexpr CommandCode kCode = CommandCode::LoadTrajectory;
    static void fields(auto& form, auto& c) {
        bool timed = c.timer.has_value();
        form.bit(3, timed);
        form.optional(0, "position", c.position, kPositionRange);
        form.optional(1, "speed", c.speed, kSpeedRange);
        form.optional(2, "acceleration time", c.accelerationTime, kAccelerationTimeRange);
        if (timed) {
            if constexpr (std::remove_reference_t<decltype(form)>::kReads)
                c.timer.emplace();
            form.number("timer count", c.timer->count, kTimerCountRange);
            form.number("nearest speed", c.timer->nearestSpeed, kNearestSpeedRange);
        }
        form.bit(4, c.reverse, "reverse");
        form.bit(7, c.startNow, "start now");
        form.orElse("nothing loaded");
    }
    bool operator==(const LoadTrajectory&) const = default;
};

/// Bits 1, 0 of the mode byte.
enum class SpeedMode : std::uint8_t { X8 = 0, X4 = 1, X2 = 2, X1 = 3 };

struct SetParameters {
    SpeedMode speedMode = SpeedMode::X8;
    bool ignoreLimits = false;
    bool ignoreEstop = false;
    bool motorOffOnLimitOrEstop = false;
    std::uint8_t minimumProfileSpeed = 1;  ///< 1..250
    std::uint8_t runCurrent = 0;
    std::uint8_t holdCurrent = 0;
    std::uint8_t thermalLimit = 0;  ///< 0: off

    static constexpr CommandCode kCode = CommandCode::SetGain;
    static void fields(auto& form, auto& c) {
        form.choice(0x03, c.speedMode,
                    {{SpeedMode::X8, 0, "8x"},
                     {SpeedMode::X4, 1, "4x"},
                     {SpeedMode::X2, 2, "2x"},
                     {SpeedMode::X1, 3, "1x"}});
        form.bit(2, c.ignoreLimits, "ignore limits");
        form.bit(3, c.ignoreEstop, "ignore E-stop");
        form.bit(4, c.motorOffOnLimitOrEstop, "motor off on limit or E-stop");
        form.number("minimum profile speed", c.minimumProfileSpeed, kSpeedRange);
        form.number("run current", c.runCurrent);
        form.number("hold current", c.holdCurrent);
        form.number("thermal limit", c.thermalLimit);
    }
    bool operator==(const SetParameters&) const = default;
};

/// True when one may replace the other in motion. The chip would ignore a change of these two parameters
/// (DS-S 5.1).
[[nodiscard]] constexpr bool sameInMotion(const SetParameters& a, const SetParameters& b) {
    return a.speedMode == b.speedMode && a.minimumProfileSpeed == b.minimumProfileSpeed;
}

enum class StopManner : std::uint8_t { AmplifierOnly, Abruptly, Smoothly };

struct StopMotor {
    bool amplifierEnable = false;
    StopManner manner = StopManner::AmplifierOnly;

    static constexpr CommandCode kCode = CommandCode::StopMotor;
    static void fields(auto& form, auto& c) {
        form.choice(0x0C, c.manner,
                    {{StopManner::AmplifierOnly, 0x00},
                     {StopManner::Abruptly, 0x04, "stop abruptly"},
                     {StopManner::Smoothly, 0x08, "stop smoothly"}});
        form.bit(0, c.amplifierEnable);
        form.say(c.amplifierEnable ? "amplifier on" : "amplifier off");
    }
    bool operator==(const StopMotor&) const = default;
};

/// OUT1..OUT5 as bits 0..4.
struct SetOutputs {
    std::uint8_t outputs = 0;

    static constexpr CommandCode kCode = CommandCode::IoControl;
    static void fields(auto& form, auto& c) { form.lines("high", "OUT", 5, c.outputs); }
    bool operator==(const SetOutputs&) const = default;
};

/// Without a condition, it cancels homing. At most one of the three stop actions may be set.
struct SetHoming {
    bool onLimit1Change = false;
    bool onLimit2Change = false;
    bool onHomeSwitchChange = false;
    bool motorOff = false;
    bool stopAbruptly = false;
    bool stopSmoothly = false;

    [[nodiscard]] constexpr bool watches() const {
        return onLimit1Change || onLimit2Change || onHomeSwitchChange;
    }

    static constexpr CommandCode kCode = CommandCode::SetHoming;
    static void fields(auto& form, auto& c) {
        form.bit(0, c.onLimit1Change, "change of limit1");
        form.bit(1, c.onLimit2Change, "change of limit2");
        form.bit(3, c.onHomeSwitchChange, "change of home switch");
        homingStopFields(form, c);
    }
    bool operator==(const SetHoming&) const = default;
};

}  // namespace nmc::stepper

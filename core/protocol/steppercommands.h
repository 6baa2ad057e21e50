// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "base/strong.h"
#include "protocol/commanderror.h"
#include "protocol/frame.h"

/// The commands that only a PIC-STEP has, or that mean something else on a PIC-SERVO (DS-S 5.1).
namespace nmc::stepper {

inline constexpr ValueRange kPositionRange{-0x7FFFFFFFLL, 0x7FFFFFFFLL};
inline constexpr ValueRange kSpeedRange{1, 250};
inline constexpr ValueRange kAccelerationTimeRange{1, 255};  ///< 0.25 ms per speed unit
inline constexpr ValueRange kTimerCountRange{1, 65'452};
inline constexpr ValueRange kByteRange{0, 0xFF};

/// A timer count travels with its nearest integer speed, from which a later ramp starts.
struct TimerCount {
    std::uint16_t count = 1;
    std::uint8_t nearestSpeed = 1;
    bool operator==(const TimerCount&) const = default;
};

/// Load Trajectory. What is loaded decides the mode (DS-S table 4).
struct LoadTrajectory {
    std::optional<Counts> position;                ///< steps
    std::optional<std::uint8_t> speed;             ///< 1..250
    std::optional<std::uint8_t> accelerationTime;  ///< 1..255
    std::optional<TimerCount> timer;
    bool reverse = false;
    bool startNow = false;

    [[nodiscard]] Payload encode() const;
    static tl::expected<LoadTrajectory, CommandError> decode(const Payload& payload);
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

    [[nodiscard]] Payload encode() const;
    static tl::expected<SetParameters, CommandError> decode(const Payload& payload);
    bool operator==(const SetParameters&) const = default;
};

/// One may replace the other in motion: the chip would ignore what differs otherwise (DS-S 5.1).
[[nodiscard]] constexpr bool sameInMotion(const SetParameters& a, const SetParameters& b) {
    return a.speedMode == b.speedMode && a.minimumProfileSpeed == b.minimumProfileSpeed;
}

enum class StopManner : std::uint8_t { AmplifierOnly, Abruptly, Smoothly };

struct StopMotor {
    bool amplifierEnable = false;
    StopManner manner = StopManner::AmplifierOnly;

    [[nodiscard]] Payload encode() const;
    static tl::expected<StopMotor, CommandError> decode(const Payload& payload);
    bool operator==(const StopMotor&) const = default;
};

/// OUT1..OUT5 as bits 0..4.
struct SetOutputs {
    std::uint8_t outputs = 0;

    [[nodiscard]] Payload encode() const;
    static tl::expected<SetOutputs, CommandError> decode(const Payload& payload);
    bool operator==(const SetOutputs&) const = default;
};

/// All false: cancel. At most one of the three stops.
struct SetHoming {
    bool onLimit1Change = false;
    bool onLimit2Change = false;
    bool onHomeSwitchChange = false;
    bool motorOff = false;
    bool stopAbruptly = false;
    bool stopSmoothly = false;

    [[nodiscard]] Payload encode() const;
    static tl::expected<SetHoming, CommandError> decode(const Payload& payload);
    bool operator==(const SetHoming&) const = default;
};

}  // namespace nmc::stepper

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "base/strong.h"
#include "protocol/commanderror.h"
#include "protocol/frame.h"

/// The commands that only a PIC-SERVO has, or that mean something else on a PIC-STEP (DS-V 5.2).
namespace nmc::servo {

/// Position -0x7FFFFFFF..+0x7FFFFFFF, velocity and acceleration 0..0x7FFFFFFF (DS-V 5.2 Load Trajectory).
inline constexpr ValueRange kPositionRange{-0x7FFFFFFFLL, 0x7FFFFFFFLL};
inline constexpr ValueRange kVelocityRange{0, 0x7FFFFFFFLL};
inline constexpr ValueRange kGainRange{0, 0x7FFF};           ///< Kp, Kd, Ki, IL
inline constexpr ValueRange kByteRange{0, 0xFF};             ///< OL, CL, DB, PWM
inline constexpr ValueRange kPositionErrorRange{0, 0x3FFF};  ///< EL
inline constexpr ValueRange kServoRateRange{1, 0xFF};        ///< SR
/// The first version that takes deadband compensation as a fourteenth gain byte.
inline constexpr std::uint8_t kDeadbandVersion = 4;
/// The first version that can stop by itself when home is found.
inline constexpr std::uint8_t kAutoStopVersion = 3;
/// The first version whose I/O Control means something else: ScIoControl.
inline constexpr std::uint8_t kOtherIoVersion = 10;
/// The first version that has Stop Here.
inline constexpr std::uint8_t kStopHereVersion = 2;

enum class ProfileMode : std::uint8_t { Trapezoidal, Velocity };

/// Load Trajectory. What is empty is not sent and keeps its value.
struct LoadTrajectory {
    std::optional<Counts> position;         ///< goal, trapezoidal mode only
    std::optional<CountsPerTick> velocity;  ///< goal or maximum velocity, a magnitude
    std::optional<CountsPerTickSquared> acceleration;
    std::optional<std::uint8_t> pwm;  ///< PWM mode only; limits do not apply
    bool servo = true;                ///< false: PWM mode
    ProfileMode profile = ProfileMode::Trapezoidal;
    bool reverse = false;  ///< velocity and PWM modes
    bool startNow = false;
    /// Trapezoidal mode of CMC and SC: position counts from the current command position. The same bit as
    /// reverse, which older versions ignore in that mode.
    bool relative = false;

    [[nodiscard]] Payload encode() const;
    static tl::expected<LoadTrajectory, CommandError> decode(const Payload& payload);
    bool operator==(const LoadTrajectory&) const = default;
};

/// Set Gain. 14 data bytes with a deadband (version 4), 13 without, 15 with a step rate multiplier (SC).
struct SetGain {
    std::uint16_t kp = 0;
    std::uint16_t kd = 0;
    std::uint16_t ki = 0;
    std::uint16_t il = 0;
    std::uint8_t ol = 0;
    std::uint8_t cl = 0;   ///< 0 off; odd: upper bound, even: lower bound on the A/D value
    std::uint16_t el = 0;  ///< counts
    std::uint8_t sr = 1;   ///< servo tick = sr x 0.512 ms
    std::optional<std::uint8_t> db;
    std::optional<std::uint8_t> sm = {};  ///< SC: step rate multiplier; sent with db only

    [[nodiscard]] Payload encode() const;
    /// A fifteenth byte is ignored, as the chip does; decodeServoCommand() reads that of an SC.
    static tl::expected<SetGain, CommandError> decode(const Payload& payload);
    bool operator==(const SetGain&) const = default;
};

/// Only one of these at a time (DS-V 5.2 Stop Motor).
enum class StopManner : std::uint8_t {
    AmplifierOnly,  ///< no motion bit: only AMP_EN is set or cleared
    MotorOff,
    Abruptly,  ///< switches a disabled servo ON
    Smoothly,
    Here,  ///< not on version 1
};

struct StopMotor {
    bool amplifierEnable = false;  ///< AMP_EN is set or cleared whatever else
    StopManner manner = StopManner::AmplifierOnly;
    Counts here;                    ///< only for StopManner::Here
    bool advancedFeatures = false;  ///< CMC only: switches them on

    [[nodiscard]] Payload encode() const;
    static tl::expected<StopMotor, CommandError> decode(const Payload& payload);
    bool operator==(const StopMotor&) const = default;
};

/// Versions 1 to 5; that of an SC is ScIoControl.
struct IoControl {
    bool limit1Output = false;  ///< value when an output
    bool limit2Output = false;
    bool limit1IsInput = true;
    bool limit2IsInput = true;
    bool fastPath = false;  ///< CMC only: path points at 60 and 120 Hz instead of 30 and 60

    [[nodiscard]] Payload encode() const;
    static tl::expected<IoControl, CommandError> decode(const Payload& payload);
    bool operator==(const IoControl&) const = default;
};

/// Set Homing Mode: captures the home position when any of the chosen conditions happens. All false: cancel.
struct SetHoming {
    bool onLimit1Change = false;
    bool onLimit2Change = false;
    bool onIndexChange = false;
    bool onPositionError = false;
    bool onCurrentLimit = false;
    bool motorOff = false;  ///< version 3 and later; at most one of these three
    bool stopAbruptly = false;
    bool stopSmoothly = false;

    [[nodiscard]] Payload encode() const;
    static tl::expected<SetHoming, CommandError> decode(const Payload& payload);
    bool operator==(const SetHoming&) const = default;
};

struct ClearStickyBits {
    [[nodiscard]] Payload encode() const;
    static tl::expected<ClearStickyBits, CommandError> decode(const Payload& payload);
    bool operator==(const ClearStickyBits&) const = default;
};

}  // namespace nmc::servo

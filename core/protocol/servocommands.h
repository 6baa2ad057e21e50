// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/strong.h"
#include "base/text.h"
#include "protocol/commandform.h"

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
/// The first version whose I/O Control has a different layout, that of ScIoControl.
inline constexpr std::uint8_t kOtherIoVersion = 10;
/// The first version that has Stop Here.
inline constexpr std::uint8_t kStopHereVersion = 2;

enum class ProfileMode : std::uint8_t { Trapezoidal, Velocity };

/// Load Trajectory. Empty values are not sent and stay unchanged in the module.
struct LoadTrajectory {
    std::optional<Counts> position;         ///< goal, trapezoidal mode only
    std::optional<CountsPerTick> velocity;  ///< goal or maximum velocity, a magnitude
    std::optional<CountsPerTickSquared> acceleration;
    std::optional<std::uint8_t> pwm;  ///< PWM mode only; limits do not apply
    bool servo = true;                ///< false: PWM mode
    ProfileMode profile = ProfileMode::Trapezoidal;
    bool reverse = false;  ///< velocity and PWM modes
    bool startNow = false;
    /// Trapezoidal mode of CMC and SC: the position is relative to the current command position. This is the
    /// same bit as reverse, which older versions ignore in that mode.
    bool relative = false;

    /// The motion ends at a position. In velocity and PWM mode, it has no end.
    [[nodiscard]] constexpr bool isTrapezoidal() const {
        return servo && profile == ProfileMode::Trapezoidal;
    }
    [[nodiscard]] constexpr bool isVelocityMode() const { return servo && profile == ProfileMode::Velocity; }

    static constexpr CommandCode kCode = CommandCode::LoadTrajectory;
    static void fields(auto& form, auto& c) {
        form.optional(0, "position", c.position, kPositionRange);
        form.optional(1, "velocity", c.velocity, kVelocityRange);
        form.optional(2, "acceleration", c.acceleration, kVelocityRange);
        form.optional(3, "PWM", c.pwm);
        form.bit(4, c.servo);
        form.choice(0x20, c.profile, {{ProfileMode::Trapezoidal, 0x00}, {ProfileMode::Velocity, 0x20}});
        const bool trapezoidal = c.isTrapezoidal();
        bool backwards = c.reverse || c.relative;
        form.bit(6, backwards);
        if constexpr (std::remove_reference_t<decltype(form)>::kReads) {
            c.relative = backwards && trapezoidal && form.ofVersions(kPathVersion);
            c.reverse = backwards && !c.relative;
        }
        form.say(!c.servo ? "PWM mode" : trapezoidal ? "trapezoidal" : "velocity mode");
        form.say(c.relative ? "relative" : "");
        form.say(c.reverse ? "reverse" : "");
        form.bit(7, c.startNow, "start now");
    }
    bool operator==(const LoadTrajectory&) const = default;
};

/// Set Gain. It has 14 data bytes with a deadband (version 4), 13 without, and 15 with a step rate multiplier
/// (SC).
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

    static constexpr CommandCode kCode = CommandCode::SetGain;
    static void fields(auto& form, auto& c) {
        form.number("Kp", c.kp, kGainRange);
        form.number("Kd", c.kd, kGainRange);
        form.number("Ki", c.ki, kGainRange);
        form.number("IL", c.il, kGainRange);
        form.number("OL", c.ol);
        form.number("CL", c.cl);
        form.number("EL", c.el, kPositionErrorRange);
        form.number("SR", c.sr, kServoRateRange);
        form.trailing("DB", c.db);
        if (c.db && form.ofVersions(kScVersion))
            form.trailing("SM", c.sm);
        form.ignoreRest(1);  // the other versions accept the fifteenth byte but do not read it
    }
    bool operator==(const SetGain&) const = default;
};

template <typename Each>
struct GainsForm : CommandForm {
    explicit GainsForm(const Each& function) : each(function) {}
    const Each& each;

    void number(std::string_view name, auto& value, ValueRange range = kByteRange) {
        each(lowered(name), value, range);
    }
    void trailing(std::string_view name, auto& value) { number(name, value); }
};
/// Calls each(name in lower case, value, range) for the fields of Set Gain, in the order in which they are
/// sent; SM only if there is a DB. The value is an optional where some versions lack the field.
template <typename Each>
void forEachGain(auto& gains, const Each& each) {
    GainsForm<Each> form(each);
    SetGain::fields(form, gains);
}

/// Only one of these may be requested at a time (DS-V 5.2 Stop Motor).
enum class StopManner : std::uint8_t {
    AmplifierOnly,  ///< no motion bit: only AMP_EN is set or cleared
    MotorOff,
    Abruptly,  ///< this and the next two switch a disabled servo ON
    Smoothly,
    Here,  ///< not on version 1
};

struct StopMotor {
    bool amplifierEnable = false;  ///< AMP_EN is set or cleared in any case
    StopManner manner = StopManner::AmplifierOnly;
    Counts here;                    ///< only for StopManner::Here
    bool advancedFeatures = false;  ///< CMC only: switches the advanced features on

    static constexpr CommandCode kCode = CommandCode::StopMotor;
    static void fields(auto& form, auto& c) {
        form.choice(0x1E, c.manner,
                    {{StopManner::AmplifierOnly, 0x00},
                     {StopManner::MotorOff, 0x02, "motor off"},
                     {StopManner::Abruptly, 0x04, "stop abruptly"},
                     {StopManner::Smoothly, 0x08, "stop smoothly"},
                     {StopManner::Here, 0x10, "stop here"}});
        if (c.manner == StopManner::Here)
            form.number("position", c.here);
        form.bit(0, c.amplifierEnable);
        form.say(c.amplifierEnable ? "amplifier on" : "amplifier off");
        if (form.ofVersions(kPathVersion, kPathVersion))
            form.bit(5, c.advancedFeatures, "advanced features");
    }
    bool operator==(const StopMotor&) const = default;
};

/// I/O Control of versions 1 to 5; an SC has ScIoControl.
struct IoControl {
    bool limit1Output = false;  ///< value when configured as an output
    bool limit2Output = false;
    bool limit1IsInput = true;
    bool limit2IsInput = true;
    bool fastPath = false;  ///< CMC only: path points at 60 and 120 Hz instead of 30 and 60

    static constexpr CommandCode kCode = CommandCode::IoControl;
    static void fields(auto& form, auto& c) {
        form.bit(0, c.limit1Output);
        form.bit(1, c.limit2Output);
        form.bit(2, c.limit1IsInput);
        form.bit(3, c.limit2IsInput);
        form.say(c.limit1IsInput ? "limit1 input" : c.limit1Output ? "limit1 output 1" : "limit1 output 0");
        form.say(c.limit2IsInput ? "limit2 input" : c.limit2Output ? "limit2 output 1" : "limit2 output 0");
        if (form.ofVersions(kPathVersion))
            form.bit(6, c.fastPath, "fast path");
    }
    bool operator==(const IoControl&) const = default;
};

/// Set Homing Mode: captures the home position when any of the chosen conditions occurs. Without one, it
/// cancels homing.
struct SetHoming {
    bool onLimit1Change = false;
    bool onLimit2Change = false;
    bool onIndexChange = false;
    bool onPositionError = false;
    bool onCurrentLimit = false;
    bool motorOff = false;  ///< version 3 and later; at most one of these three
    bool stopAbruptly = false;
    bool stopSmoothly = false;

    [[nodiscard]] constexpr bool watches() const {
        return onLimit1Change || onLimit2Change || onIndexChange || onPositionError || onCurrentLimit;
    }

    static constexpr CommandCode kCode = CommandCode::SetHoming;
    static void fields(auto& form, auto& c) {
        form.bit(0, c.onLimit1Change, "change of limit1");
        form.bit(1, c.onLimit2Change, "change of limit2");
        form.bit(3, c.onIndexChange, "change of index");
        form.bit(6, c.onPositionError, "position error");
        form.bit(7, c.onCurrentLimit, "current limiting");
        if (form.ofVersions(kAutoStopVersion))
            homingStopFields(form, c);
    }
    bool operator==(const SetHoming&) const = default;
};

struct ClearStickyBits : CommandWithoutData<CommandCode::ClearStickyBits> {};

}  // namespace nmc::servo

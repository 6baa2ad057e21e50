// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/conformance.h"

namespace nmc::conformance {

/// The answer of a servo that has been idle since power-up: move_done, power_on, pos_error.
inline const Bytes kIdle{0x19, 0x19};

/// 1 count per tick in 16.16.
inline constexpr std::uint32_t kOne = 65536;

// Status byte and auxiliary status byte (DS-V 5.3).
inline constexpr unsigned kMoveDone = 0x01, kChecksumError = 0x02, kOvercurrent = 0x04, kPowerOn = 0x08,
                          kPositionError = 0x10, kLimit1 = 0x20, kLimit2 = 0x40, kHomeInProgress = 0x80;
inline constexpr unsigned kIndexLow = 0x01, kPositionWrap = 0x02, kServoOn = 0x04, kAccelerationDone = 0x08,
                          kSlewDone = 0x10, kServoOverrun = 0x20;

// Load Trajectory's control byte.
inline constexpr unsigned kLoadPosition = 0x01, kLoadVelocity = 0x02, kLoadAcceleration = 0x04,
                          kLoadPwm = 0x08, kServo = 0x10, kVelocityProfile = 0x20, kReverse = 0x40,
                          kStart = 0x80;

// Stop Motor's control byte.
inline constexpr unsigned kAmplifier = 0x01, kMotorOff = 0x02, kAbruptly = 0x04, kSmoothly = 0x08,
                          kHere = 0x10;

/// Set Gain's parameters. The limits do not limit unless they are given.
struct Gains {
    unsigned kp = 0, kd = 0, ki = 0, il = 0, ol = 255, cl = 0, el = 0x3FFF, sr = 1, db = 0;
};

/// Gains that hold the default motor well (simulator.md, Fidelity).
inline constexpr Gains kGoodGains{.kp = 200, .kd = 2000, .ki = 20, .il = 200};

/// 14 data bytes; the last is the deadband compensation.
[[nodiscard]] Bytes gainBytes(const Gains& gains);
[[nodiscard]] Bytes position(std::int32_t counts);

/// The contents of a reply with the items 1F.
struct Status {
    unsigned byte = 0;
    std::int32_t position = 0;
    unsigned analog = 0;
    int velocity = 0;  ///< as it is sent
    unsigned auxiliary = 0;
    std::int32_t home = 0;
};

/// A statement about the PIC-SERVO. The chain is one module of version 4 with address 1 unless the test
/// makes another.
class PicServo : public Statement {
protected:
    PicServo() { start("servo", 1); }
    void start(const std::string& chain, unsigned count, const std::vector<std::string>& options = {});

    Bytes command(unsigned code, const Bytes& data = {}, unsigned at = 1) {
        return rig->command(at, code, data);
    }
    Status status(unsigned at = 1);
    /// A value of the true state of module 1.
    nlohmann::json truth(const char* name) { return rig->state()[name]; }
    double number(const char* name) { return truth(name).get<double>(); }
    nlohmann::json statistics(const char* name, int module = 1) {
        return rig->control("stats")["modules"][static_cast<std::size_t>(module - 1)][name];
    }

    void gains(const Gains& gains, unsigned at = 1) { command(0xE6, gainBytes(gains), at); }
    void stop(unsigned control, unsigned at = 1) { command(0x17, {static_cast<std::uint8_t>(control)}, at); }
    void stopHere(std::int32_t counts) {
        command(0x57, Bytes{static_cast<std::uint8_t>(kHere | kAmplifier)} + position(counts));
    }
    /// Load Trajectory; the command byte counts the data.
    Bytes load(unsigned control, const Bytes& data = {}, unsigned at = 1);
    void trapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration,
                   unsigned more = kStart, unsigned at = 1);
    void velocity(std::int32_t velocity, std::uint32_t acceleration, unsigned more = kStart);
    void pwm(int value);
    void homing(unsigned control) { command(0x19, {static_cast<std::uint8_t>(control)}); }

    /// Amplifier and servo on with gains that hold the motor, and no sticky bit.
    void servoOn(const Gains& with = kGoodGains, unsigned at = 1);
    /// Holds the shaft where it is, between whole counts.
    void block();
    /// Moves the shaft some thousand counts forward; after that, the motor is at rest and switched off.
    void turnAway();
    /// Lets a load turn the shaft, with the motor off, until the counter has wrapped.
    void wrapPosition();
    void expectNoViolation() { EXPECT_EQ(rig->violations(), std::vector<std::string>{}); }
    void expectViolation(const std::string& kind) {
        EXPECT_EQ(rig->violations(), std::vector<std::string>{kind});
    }
};

}  // namespace nmc::conformance

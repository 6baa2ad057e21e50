// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/strong.h"
#include "sim/encoder.h"
#include "sim/homing.h"
#include "sim/motorplant.h"
#include "sim/path.h"
#include "sim/pid.h"
#include "sim/profile.h"
#include "sim/random.h"
#include "sim/snapshot.h"

namespace nmc::sim {

/// The parameters that Load Trajectory leaves in the chip's memory. A parameter that is not loaded keeps its
/// value.
struct Trajectory {
    static constexpr std::uint8_t kPwm = 0x08;
    static constexpr std::uint8_t kServo = 0x10;
    static constexpr std::uint8_t kVelocityProfile = 0x20;
    static constexpr std::uint8_t kReverse = 0x40;
    static constexpr std::uint8_t kRelative = 0x40;  ///< in trapezoidal mode of CMC and SC
    static constexpr std::uint8_t kStartNow = 0x80;

    std::int32_t position = 0;
    std::uint32_t velocity = 0;      ///< 16.16 counts/tick, 0..7FFFFFFF
    std::uint32_t acceleration = 0;  ///< 16.16 counts/tick², 0..7FFFFFFF
    std::uint8_t pwm = 0;
    std::uint8_t control = 0;
    bool isLoaded = false;
    bool velocityZeroed = false;  ///< a stop has set the velocity to 0, and none has been loaded since

    [[nodiscard]] bool has(std::uint8_t bit) const { return (control & bit) != 0; }
    [[nodiscard]] bool isTrapezoidal() const { return has(kServo) && !has(kVelocityProfile); }
};

/// Bits of an SC's I/O Control (docs/family.md).
struct ScControl {
    static constexpr std::uint8_t kLimitOff = 0x04;
    static constexpr std::uint8_t kLimitAbrupt = 0x08;
    static constexpr std::uint8_t kThreePhase = 0x10;
    static constexpr std::uint8_t kAntiphase = 0x20;
    static constexpr std::uint8_t kFastPath = 0x40;  ///< also on a CMC
    static constexpr std::uint8_t kStepAndDirection = 0x80;
};

/// The part of the PIC-SERVO that moves a motor, together with the motor: encoder, profile, control filter,
/// current limit, home search, power monitor (DS-V 4.2 - 4.5). It knows nothing of packets. Time advances in
/// ticks of 512 us.
class ServoLoop {
public:
    explicit ServoLoop(std::uint8_t version)
        : m_version(version),
          m_encoder(version >= kLater ? Encoder::kLaterMaxEdgesPerTick : Encoder::kMaxEdgesPerTick),
          m_path(Path::capacityOf(version)) {}

    /// Restores the chip's power-up state. The motor and its shaft are not affected.
    void reset();
    /// Runs this many maximum-rate ticks: first the shaft, then the encoder, then everything computed from
    /// it.
    void run(std::uint64_t ticks);

    // Commands (DS-V 5.2).
    void resetPosition() { setPosition(0); }
    void resetRelativeToHome();
    void setPosition(std::int32_t position);
    void setGains(const Gains& gains);
    [[nodiscard]] const Gains& gains() const { return m_gains; }
    void load(const Trajectory& trajectory) { m_loaded = trajectory; }
    [[nodiscard]] const Trajectory& loaded() const { return m_loaded; }
    /// Starts the loaded trajectory. Does nothing when limit protection forbids the motion.
    void start();
    void setAmplifier(bool enabled);
    void turnOff();
    void stopAbruptly();
    void stopSmoothly();
    void stopHere(std::int32_t position);
    void controlPins(std::uint8_t control);
    void setHoming(std::uint8_t control);
    void clearStickyBits();
    void saveAsHome() { m_home = m_encoder.position(); }
    /// Returns false when the path buffer is full.
    bool addPathPoint(std::uint16_t word) { return m_path.add(word); }
    void startPath();
    void endPath();

    // Status items (DS-V 5.2 Define Status, 5.3).
    /// The status byte without the checksum error bit, which belongs to the receiver.
    [[nodiscard]] std::uint8_t statusByte() const;
    [[nodiscard]] std::uint8_t auxiliaryByte() const;
    [[nodiscard]] std::int32_t position() const { return m_encoder.position(); }
    [[nodiscard]] std::int32_t home() const { return m_home; }
    [[nodiscard]] const Homing& homing() const { return m_homing; }
    [[nodiscard]] std::uint8_t analog() const;
    /// Counts that the motor moved in the last servo tick; forward is positive.
    [[nodiscard]] std::int32_t velocity() const { return m_velocity; }
    /// Command position - position, in counts.
    [[nodiscard]] std::int32_t positionError() const {
        return countsBetween(m_encoder.position(), m_profile.position());
    }
    [[nodiscard]] std::size_t pathPoints() const { return m_path.points(); }
    /// True when an error or the supply voltage has switched the servo off in step and direction mode.
    [[nodiscard]] bool steppingFault() const { return m_fault && controls(ScControl::kStepAndDirection); }

    /// True during a trapezoidal move, when Reset Position and a new trapezoid are forbidden.
    [[nodiscard]] bool inTrapezoid() const;
    /// While the servo is off, it follows the velocity of the motor.
    [[nodiscard]] std::int64_t commandVelocity() const { return m_profile.velocity(); }
    [[nodiscard]] bool isServoOn() const { return m_servoOn; }

    /// The value must be in the range that Input states.
    void set(Input input, std::optional<double> value);
    /// Replaces the default motor; `seed` is for its encoder's noise.
    void setMotor(const MotorParameters& motor, std::uint64_t seed = 1) {
        m_plant.setParameters(motor);
        m_noise = Random(seed);
    }
    /// Holds the shaft where it is, or releases it.
    void holdShaft(bool held);
    /// Exchanges the encoder's channels, or restores them.
    void reverseEncoder(bool reversed);
    [[nodiscard]] const MotorParameters& motor() const { return m_plant.parameters(); }
    [[nodiscard]] ServoSnapshot snapshot() const;

private:
    static constexpr std::uint8_t kLater = 5;  ///< CMC and SC
    static constexpr std::uint8_t kSc = 10;
    [[nodiscard]] bool isLater() const { return m_version >= kLater; }
    [[nodiscard]] bool isSc() const { return m_version >= kSc; }
    /// Output steps per PWM count: an SC has two more bits.
    [[nodiscard]] int pwmSteps() const { return isSc() ? 4 : 1; }
    [[nodiscard]] bool controls(std::uint8_t bit) const { return (m_control & bit) != 0; }

    [[nodiscard]] LaterServoSnapshot laterSnapshot() const;
    void tick();
    [[nodiscard]] std::int64_t encoderNoise();
    void servoTick();
    void stepProfile();
    void startPwm();
    void protectLimits();
    [[nodiscard]] bool protectsLimits() const;
    /// True when limit protection forbids motion in this direction: 1 forward, -1 reverse.
    [[nodiscard]] bool isBlocked(int direction) const;
    /// The direction in which the loaded trajectory would move.
    [[nodiscard]] int loadedDirection() const;
    [[nodiscard]] std::int32_t loadedGoal() const;
    void fault();
    [[nodiscard]] bool undervoltage() const { return m_volts < kMinVolts; }
    [[nodiscard]] bool isPowered() const { return !undervoltage() && m_volts <= kMaxVolts; }
    void limitCurrent();
    void watchHome();
    void driveMotor();
    void turnServoOn();
    void disableServo();
    void forgetVelocity();
    void setOutput(std::int64_t magnitude, bool reverse);
    [[nodiscard]] int ticksPerServoTick() const { return m_gains.sr == 0 ? 256 : m_gains.sr; }
    [[nodiscard]] bool currentIsOver() const;
    [[nodiscard]] bool limitPin(unsigned number) const;
    [[nodiscard]] bool indexPin() const;
    [[nodiscard]] HomeInputs homeInputs() const { return {limitPin(0), limitPin(1), indexPin()}; }

    std::uint8_t m_version;
    MotorPlant m_plant;
    std::int64_t m_encoderShaft = 0;  ///< counts; lags the shaft by at most the play
    std::int64_t m_load = 0;          ///< counts; lags the encoder by at most the load's play
    Random m_noise{1};
    Encoder m_encoder;
    Profile m_profile;
    Path m_path;
    PidFilter m_filter;
    Homing m_homing;
    Gains m_gains;
    Trajectory m_loaded;

    std::int32_t m_lastServoPosition = 0;
    std::int32_t m_velocity = 0;
    std::int32_t m_home = 0;
    int m_ticksToServoTick = 1;
    int m_magnitude = 0;  ///< PWM before current limiting, in pwmSteps() like the next two
    int m_adjustment = 0;
    int m_pwm = 0;  ///< output to the amplifier
    bool m_reverse = false;
    bool m_servoOn = false;
    bool m_stoppedHere = false;
    bool m_ampEnabled = false;
    bool m_overcurrent = false;
    bool m_positionError = true;
    bool m_servoOverrun = false;
    bool m_tripped = false;   ///< the position error limit was exceeded in this tick
    bool m_limiting = false;  ///< the current exceeds its limit in this tick
    bool m_quiet = false;     ///< another tick would change nothing
    bool m_fault = false;     ///< an error or the supply voltage has switched the servo off
    std::uint8_t m_pinControl = kPinsAreInputs;
    std::uint8_t m_control = 0;  ///< I/O Control: the bits of ScControl that the version has

    static constexpr std::uint8_t kPinsAreInputs = 0x0C;
    // Voltage range of POWER_ON (docs/family.md).
    static constexpr double kMinVolts = 0.9;
    static constexpr double kMaxVolts = 4.5;
    static constexpr double kGoodVolts = 2.5;
    // The world outside the chip.
    double m_volts = kGoodVolts;  ///< at VOLT_SENSE; older versions only detect whether there is power
    std::int64_t m_pulses = 0;    ///< pulses at the step input not yet added to the command position
    bool m_limitsAutomatic = false;
    bool m_limitInput[2] = {false, false};
    std::optional<std::int64_t> m_homeSwitchAt;
    std::optional<std::uint8_t> m_analogInput;
    std::optional<bool> m_indexInput;
    std::int64_t m_indexInputAt = 0;  ///< shaft position at which m_indexInput holds
};

}  // namespace nmc::sim

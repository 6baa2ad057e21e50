// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "protocol/servocommands.h"

/// A motor and the control filter that holds it, computed in double precision. Pure. Counts, seconds, PWM
/// counts (255 is full output).
namespace nmc {

/// A motor as the control filter sees it, including its amplifier and encoder:
///
///     tau dv/dt = K (w + load - c sgn v) - v        w = u less the deadband, nothing within it
///
/// At rest, dry friction holds it as long as |w + load| <= c.
struct MotorConstants {
    double gain = 0.0;  ///< K, counts/s per PWM count: the speed that one more PWM count adds in the end
    double timeConstant = 0.0;  ///< tau, s, above 0
    double friction = 0.0;      ///< c, dry friction, PWM counts
    double load = 0.0;          ///< PWM counts; a load that pulls forwards is positive
    double delay = 0.0;         ///< s, by which torque lags PWM (inductance, the chip's computing time)
    double deadband = 0.0;      ///< PWM counts, in either direction, that produce no amplifier output
    double play = 0.0;          ///< counts by which the shaft turns before the encoder turns with it
    double noise = 0.0;         ///< counts rms; encoder noise, drawn anew each tick
    double second = 0.0;        ///< inertia of a second mass on a spring, relative to the shaft's own
    double resonance = 0.0;     ///< Hz, of the oscillation of both against each other
};

/// Damping of that oscillation as a fraction of critical damping. It is a guess.
inline constexpr double kSpringDamping = 0.02;

/// The range of PWM values for which friction holds the shaft at rest.
struct HoldingRange {
    double least = 0.0, most = 0.0;

    /// The value at `part` of the range: -1 is the least, 1 the most.
    [[nodiscard]] double at(double part) const { return (least + most + part * (most - least)) / 2; }
};
[[nodiscard]] HoldingRange holdingRange(const MotorConstants& motor);

struct MotorMotion {
    double position = 0.0;  ///< counts
    double velocity = 0.0;  ///< counts/s
};

/// The exact motion after `seconds` with a constant PWM value `drive` beyond the deadband, including a
/// reversal or a stop in between. The delay is not considered here.
[[nodiscard]] MotorMotion moved(const MotorConstants& motor, const MotorMotion& from, double drive,
                                double seconds);

/// How the filter's integer arithmetic is modelled.
enum class Rounding : std::uint8_t {
    Chip,  ///< like the chip: counts rounded down, the integral and PWM values truncated
    /// Mean values of the rounded quantities, so that a slightly different motor yields a slightly different
    /// motion. A position is then the mean encoder reading, half a count less than the position of the shaft.
    Mean,
};

/// The control filter of DS-V 4.3 with output limit and deadband compensation, without the current limit. The
/// data sheet prints a minus before Kd, which would drive instead of damp; it is a plus.
class ControlFilter {
public:
    /// `integral`: the running sum over 256, in counts. `error`: position error of the previous tick, in
    /// counts. `deadband`: the amplifier's, in PWM counts.
    ControlFilter(const servo::SetGain& gains, Rounding rounding, double integral, double error,
                  double deadband = 0.0);

    /// Returns the output for a position error in counts: signed PWM counts beyond the deadband. Called once
    /// per servo tick.
    [[nodiscard]] double output(double error);
    /// The output for an unchanged error, without advancing a tick.
    [[nodiscard]] double standing() const;

private:
    [[nodiscard]] double toAmplifier(double sum) const;
    [[nodiscard]] double integral() const;

    servo::SetGain m_gains;
    Rounding m_rounding;
    double m_deadband;
    double m_sum;
    double m_errorBefore;
};

struct LoopStart {
    double position = 0.0;  ///< counts, encoder position
    double command = 0.0;   ///< counts, command position until the step
    double integral = 0.0;  ///< the running sum over 256, counts
    double slack = 0.5;     ///< fraction of the play by which the shaft is ahead of the encoder
};

/// Simulates steps of the command position, tick by tick.
class Loop {
public:
    /// Maximum delay in ticks; a longer delay is treated as this.
    static constexpr std::size_t kLongestDelay = 3;

    /// The first tick that sees `goal` is at 0 s; until then the shaft is at rest.
    Loop(const MotorConstants& motor, const servo::SetGain& gains, const LoopStart& start, double goal,
         Rounding rounding);

    /// The position at the encoder and the velocity of the shaft at a time, which must not be earlier than a
    /// previous one.
    [[nodiscard]] MotorMotion at(double seconds);
    /// Starts another step, which the next tick sees.
    void goTo(double goal) { m_goal = goal; }
    /// The time of the next tick in s.
    [[nodiscard]] double nextTick() const { return m_nextTick; }
    /// The encoder reading at a shaft position.
    [[nodiscard]] double reading(double position) const;
    [[nodiscard]] double tick() const { return m_tick; }

private:
    struct State {
        MotorMotion shaft;
        double twist = 0.0;   ///< counts by which the shaft is ahead of the second mass
        double second = 0.0;  ///< counts/s, velocity of the second mass
    };
    [[nodiscard]] State after(double seconds) const;
    void go(State& state, double pwm, double seconds) const;
    [[nodiscard]] double driven(double shaft) const;
    [[nodiscard]] double noisyReading();

    MotorConstants m_motor;
    Rounding m_rounding;
    double m_tick;
    double m_ownDelay;         ///< s, the fraction of the delay beyond whole ticks
    std::size_t m_wholeDelay;  ///< ticks
    double m_goal;
    ControlFilter m_filter;
    std::array<double, kLongestDelay + 2> m_sent;  ///< PWM values beyond the deadband, latest first
    State m_state;                                 ///< at the last tick
    double m_driven;                               ///< counts, encoder position at the last tick
    std::minstd_rand m_random;
    std::normal_distribution<double> m_noise;
    double m_lastTick = 0.0;
    double m_nextTick = 0.0;
};

}  // namespace nmc

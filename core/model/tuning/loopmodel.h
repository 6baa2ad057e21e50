// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "protocol/servocommands.h"

/// A motor and the control filter that holds it, reckoned in double precision. Pure. Counts, seconds, PWM
/// counts (255 is full on).
namespace nmc {

/// A motor as the control filter sees it, with its amplifier and encoder:
///
///     tau dv/dt = K (w + load - c sgn v) - v        w = u less the deadband, nothing within it
///
/// At rest dry friction holds it as long as |w + load| <= c.
struct MotorConstants {
    double gain = 0.0;  ///< K, counts/s per PWM count: what one more of them adds to the speed, in the end
    double timeConstant = 0.0;  ///< tau, s, above 0
    double friction = 0.0;      ///< c, dry friction, PWM counts
    double load = 0.0;          ///< PWM counts; what pulls forwards is positive
    double delay = 0.0;         ///< s, by which torque follows PWM (inductance, the chip's reckoning)
    double deadband = 0.0;      ///< PWM counts of which the amplifier makes nothing, either way
    double play = 0.0;          ///< counts by which the shaft turns before the encoder turns with it
    double noise = 0.0;         ///< counts rms, of the encoder, another one each tick
    double second = 0.0;        ///< inertia that hangs on the shaft by a spring, in parts of the shaft's own
    double resonance = 0.0;     ///< Hz, at which both swing against each other
};

/// The damping of that swing, as a share of critical damping. It is a guess.
inline constexpr double kSpringDamping = 0.02;

/// The PWM values by which friction holds the shaft at rest.
struct HoldingRange {
    double least = 0.0, most = 0.0;

    /// -1..1, from the least to the most.
    [[nodiscard]] double at(double part) const { return (least + most + part * (most - least)) / 2; }
};
[[nodiscard]] HoldingRange holdingRange(const MotorConstants& motor);

struct MotorMotion {
    double position = 0.0;  ///< counts
    double velocity = 0.0;  ///< counts/s
};

/// Where it is after `seconds` of what a constant PWM value has beyond the deadband, exactly, with a turn
/// round or a stop in between. The delay is not this function's.
[[nodiscard]] MotorMotion moved(const MotorConstants& motor, const MotorMotion& from, double drive,
                                double seconds);

/// How the filter's whole numbers are reckoned.
enum class Rounding : std::uint8_t {
    Chip,  ///< as the chip does: counts rounded down, the integral and PWM values cut off
    /// What these come to on average, so that a motor that is a little different moves a little differently.
    /// A position is then what the encoder tells on average: half a count less than where the shaft is.
    Mean,
};

/// s; SR times 0.512 ms (DS-V 4.3).
[[nodiscard]] double servoTickOf(const servo::SetGain& gains);

/// The control filter of DS-V 4.3 with output limit and deadband compensation, without the current limit. The
/// sheet prints a minus before Kd, which would drive instead of damp; it is a plus.
class ControlFilter {
public:
    /// `integral`: the running sum over 256, counts. `error`: counts, of the tick before. `deadband`: the
    /// amplifier's, PWM counts.
    ControlFilter(const servo::SetGain& gains, Rounding rounding, double integral, double error,
                  double deadband = 0.0);

    /// PWM counts beyond the deadband, signed, for the position error in counts. Once per servo tick.
    [[nodiscard]] double output(double error);
    /// The same if nothing changes, without a tick.
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
    double position = 0.0;  ///< counts, where the encoder stands
    double command = 0.0;   ///< counts, held until then
    double integral = 0.0;  ///< the running sum over 256, counts
    double slack = 0.5;     ///< part of the play by which the shaft is ahead of the encoder
};

/// Steps of the command position, tick by tick.
class Loop {
public:
    /// Ticks; a longer delay counts as this.
    static constexpr std::size_t kLongestDelay = 3;

    /// The first tick that sees `goal` is at 0 s; until then the shaft stands.
    Loop(const MotorConstants& motor, const servo::SetGain& gains, const LoopStart& start, double goal,
         Rounding rounding);

    /// What the encoder sits on at that time, and the shaft's velocity; the time is not before one asked for
    /// already.
    [[nodiscard]] MotorMotion at(double seconds);
    /// Another step: the next tick sees it.
    void goTo(double goal) { m_goal = goal; }
    /// s
    [[nodiscard]] double nextTick() const { return m_nextTick; }
    /// Where the encoder says that a shaft is.
    [[nodiscard]] double reading(double position) const;
    /// What the amplifier was last told, beyond its deadband.
    [[nodiscard]] double pwm() const { return m_sent.front(); }
    [[nodiscard]] double tick() const { return m_tick; }

private:
    struct State {
        MotorMotion shaft;
        double twist = 0.0;   ///< counts by which the shaft is ahead of the second mass
        double second = 0.0;  ///< counts/s, of that
    };
    [[nodiscard]] State after(double seconds) const;
    void go(State& state, double pwm, double seconds) const;
    [[nodiscard]] double driven(double shaft) const;
    [[nodiscard]] double told();

    MotorConstants m_motor;
    Rounding m_rounding;
    double m_tick;
    double m_ownDelay;         ///< s, what the delay has beyond whole ticks
    std::size_t m_wholeDelay;  ///< ticks
    double m_goal;
    ControlFilter m_filter;
    std::array<double, kLongestDelay + 2> m_sent;  ///< PWM values beyond the deadband, the latest first
    State m_state;                                 ///< at the last tick
    double m_driven;                               ///< counts, the encoder then
    std::minstd_rand m_random;
    std::normal_distribution<double> m_noise;
    double m_lastTick = 0.0;
    double m_nextTick = 0.0;
};

}  // namespace nmc

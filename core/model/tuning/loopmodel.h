// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "protocol/servocommands.h"

/// A motor and the control filter that holds it, reckoned in double precision. Pure. Counts, seconds, PWM
/// counts (255 is full on).
namespace nmc {

/// A motor as the control filter sees it, with its amplifier and encoder:
///
///     tau dv/dt = K (u + load - c sgn v) - v
///
/// At rest dry friction holds it as long as |u + load| <= c.
struct MotorConstants {
    double gain = 0.0;  ///< K, counts/s per PWM count: what one more of them adds to the speed, in the end
    double timeConstant = 0.0;  ///< tau, s, above 0
    double friction = 0.0;      ///< c, dry friction, PWM counts
    double load = 0.0;          ///< PWM counts; what pulls forwards is positive
    double delay = 0.0;         ///< s, by which torque follows PWM (inductance, the chip's reckoning)
};

struct MotorMotion {
    double position = 0.0;  ///< counts
    double velocity = 0.0;  ///< counts/s
};

/// Where it is after `seconds` of a constant PWM value, exactly, with a turn round or a stop in between. The
/// delay is not this function's.
[[nodiscard]] MotorMotion moved(const MotorConstants& motor, const MotorMotion& from, double pwm,
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
    /// `integral`: the running sum over 256, counts. `error`: counts, of the tick before.
    ControlFilter(const servo::SetGain& gains, Rounding rounding, double integral, double error);

    /// PWM counts, signed, for the position error in counts. Once per servo tick.
    [[nodiscard]] double output(double error);
    /// The same if nothing changes, without a tick.
    [[nodiscard]] double standing() const;

private:
    [[nodiscard]] double toAmplifier(double sum) const;
    [[nodiscard]] double integral() const;

    servo::SetGain m_gains;
    Rounding m_rounding;
    double m_sum;
    double m_errorBefore;
};

struct LoopStart {
    double position = 0.0;  ///< counts, where the shaft stands
    double command = 0.0;   ///< counts, held until then
    double integral = 0.0;  ///< the running sum over 256, counts
};

/// Steps of the command position, tick by tick.
class Loop {
public:
    /// Ticks; a longer delay counts as this.
    static constexpr std::size_t kLongestDelay = 3;

    /// The first tick that sees `goal` is at 0 s; until then the shaft stands.
    Loop(const MotorConstants& motor, const servo::SetGain& gains, const LoopStart& start, double goal,
         Rounding rounding);

    /// The shaft at that time, which is not before one asked for already.
    [[nodiscard]] MotorMotion at(double seconds);
    /// Another step: the next tick sees it.
    void goTo(double goal) { m_goal = goal; }
    /// s
    [[nodiscard]] double nextTick() const { return m_nextTick; }
    /// Where the encoder says that a shaft is.
    [[nodiscard]] double reading(double position) const;
    /// What the amplifier was last told.
    [[nodiscard]] double pwm() const { return m_sent.front(); }
    [[nodiscard]] double tick() const { return m_tick; }

private:
    [[nodiscard]] MotorMotion after(double seconds) const;

    MotorConstants m_motor;
    Rounding m_rounding;
    double m_tick;
    double m_ownDelay;         ///< s, what the delay has beyond whole ticks
    std::size_t m_wholeDelay;  ///< ticks
    double m_goal;
    ControlFilter m_filter;
    std::array<double, kLongestDelay + 2> m_sent;  ///< PWM values, the latest first
    MotorMotion m_motion;                          ///< at the last tick
    double m_lastTick = 0.0;
    double m_nextTick = 0.0;
};

}  // namespace nmc

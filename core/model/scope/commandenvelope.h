// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "base/time.h"
#include "model/scope/profilecurve.h"
#include "model/scope/tickclock.h"

namespace nmc {

/// Counts. The true value is neither below `low` nor above `high`.
struct CommandEstimate {
    double position = 0;
    double low = 0;
    double high = 0;
    bool operator==(const CommandEstimate&) const = default;
};

/// The time of an event, as far as it is known.
struct Moments {
    TimePoint earliest;
    TimePoint likely;
    TimePoint latest;
    /// Maximum relative difference between the clocks; 0 where the module's ticks were counted.
    double apart = TickClock::kApart;
};

/// A command position over time whose changes are each known within bounds. It consists of three curves: the
/// likely one and one on either side. A change starts the high curve at the moment that leads highest and the
/// low curve at the moment that leads lowest; since none overtakes another, all possible motions lie between
/// them. A change of velocity by dv at a moment that is uncertain by dt therefore leaves dv x dt, not v x dt.
///
/// The only thing it knows of the chip is that its profile advances in steps of a servo tick. Velocities are
/// in counts/s unless stated otherwise.
class CommandEnvelope {
public:
    /// The servo tick in s, and the acceleration in counts per servo tick squared.
    struct Pace {
        double tick = 0;
        double acceleration = 0;
    };

    /// Starts at standstill.
    explicit CommandEnvelope(const CommandEstimate& held);

    [[nodiscard]] CommandEstimate at(const Moments& when) const;

    // Changes. `when` is the start of the curve that best matches the chip's steps.
    /// Moves from standstill exactly to `goal`, in a trapezoid.
    void moveTo(double goal, double velocity, Pace pace, const Moments& when);
    /// Changes from the present motion to a velocity, which then continues.
    void changeVelocity(double velocity, Pace pace, const Moments& when);
    /// Makes the present position 0; `when` is as in at().
    void makeZero(Pace pace, const Moments& when);
    /// Lengthens the servo tick by `factor`, between the last step of the old length and the first of the new
    /// one.
    void stretch(double factor, const Moments& before, const Moments& after);

    // Reports of the module. If one contradicts the curves, all three are moved to match it, and false is
    // returned.
    /// A phase of the last change has ended, at the latest at `by`.
    bool ended(ProfileCurve::Phase phase, TimePoint by) { return reported(phase, 1, by); }
    /// A phase of the last change has not ended, at the earliest at `yet`.
    bool goesOn(ProfileCurve::Phase phase, TimePoint yet) { return reported(phase, -1, yet); }

private:
    struct Curve {
        ProfileCurve profile;
        TimePoint start;
        [[nodiscard]] double seconds(TimePoint time) const { return toSeconds(time - start); }
        void moveStart(Duration later);
    };
    enum Side : std::size_t { Low, Likely, High };

    /// A phase ends no later than `bound` (`sign` 1), or no earlier (-1).
    bool reported(ProfileCurve::Phase phase, int sign, TimePoint bound);
    [[nodiscard]] Curve changed(Side side, double velocity, Pace pace, const Moments& when) const;
    [[nodiscard]] Curve changedTrapezoid(Side side, double velocity, Pace pace, const Moments& when) const;
    /// Changes one of the three curves from `start` on, for one side; `apart` is as in Moments.
    [[nodiscard]] Curve changed(const Curve& curve, Side side, double velocity, Pace pace, TimePoint start,
                                double apart) const;
    /// The moment at which a change (`up`: upwards) leads furthest to that side.
    [[nodiscard]] static TimePoint pick(Side side, bool up, const Moments& when);
    [[nodiscard]] ProfileCurve::Range range(const Curve& curve, const Moments& when) const;

    std::array<Curve, 3> m_curves;
    // For a trapezoidal move: its steps may be this far off the curve, for this long, and never pass its
    // ends.
    double m_steps = 0;
    double m_settling = 0;
    ProfileCurve::Range m_ends{-std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
};

}  // namespace nmc

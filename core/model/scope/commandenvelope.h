// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>

#include "base/time.h"
#include "model/scope/profilecurve.h"
#include "model/scope/tickclock.h"

namespace nmc {

/// Counts. The true value is not below `low` nor above `high`.
struct CommandEstimate {
    double position = 0;
    double low = 0;
    double high = 0;
    bool operator==(const CommandEstimate&) const = default;
};

/// When something happened, as far as it is known.
struct Moments {
    TimePoint earliest;
    TimePoint likely;
    TimePoint latest;
    /// So fast or slow the clock may be; 0 where the module's ticks were counted.
    double apart = TickClock::kApart;
};

/// A command position over time of which each change is known within bounds: three curves, the likely one and
/// one on either side. A change sends the high curve on its way at the moment that leads highest, the low
/// curve at the one that leads lowest; since none overtakes another, all that may have been lies between
/// them. A change of velocity by dv at a moment that is off by dt so leaves dv x dt, and not v x dt.
///
/// Knows of the chip only that its profile goes in steps of a servo tick. Velocities in counts/s but where
/// said otherwise.
class CommandEnvelope {
public:
    /// A servo tick, and an acceleration in counts per servo tick squared.
    struct Pace {
        double tick = 0;
        double acceleration = 0;
    };

    /// Stands still.
    explicit CommandEnvelope(const CommandEstimate& held);

    [[nodiscard]] CommandEstimate at(const Moments& when) const;

    // Changes; `when` is when the curve begins for which the chip's steps are the best match.
    /// From standstill to exactly `goal`, in a trapezoid.
    void moveTo(double goal, double velocity, Pace pace, const Moments& when);
    /// From whatever it does to a velocity, and on at it.
    void changeVelocity(double velocity, Pace pace, const Moments& when);
    /// The place where it is is called 0 from now on; `when` as in at().
    void makeZero(Pace pace, const Moments& when);
    /// The servo tick becomes longer by `factor`, between the last step of the old length and the first of
    /// the new one.
    void stretch(double factor, const Moments& before, const Moments& after);

    // What the module says. A contradiction moves all three curves to where it says, and false comes back.
    /// A phase of the last change is over, at the latest by then.
    bool ended(ProfileCurve::Phase phase, TimePoint by);
    /// It is not over, at the earliest then.
    bool goesOn(ProfileCurve::Phase phase, TimePoint yet);

private:
    struct Curve {
        ProfileCurve profile;
        TimePoint start;
        [[nodiscard]] double seconds(TimePoint time) const { return toSeconds(time - start); }
        void moveStart(Duration later);
    };
    enum Side : std::size_t { Low, Likely, High };

    [[nodiscard]] Curve changed(Side side, double velocity, Pace pace, const Moments& when) const;
    [[nodiscard]] Curve changedTrapezoid(Side side, double velocity, Pace pace, const Moments& when) const;
    /// One of the three from this moment on, for a side; `apart` as in Moments.
    [[nodiscard]] Curve changed(const Curve& curve, Side side, double velocity, Pace pace, TimePoint start,
                                double apart) const;
    /// The moment at which a change that leads up, or not, leads furthest to that side.
    [[nodiscard]] static TimePoint pick(Side side, bool up, const Moments& when);
    [[nodiscard]] ProfileCurve::Range range(const Curve& curve, const Moments& when) const;

    std::array<Curve, 3> m_curves;
    // Of a trapezoidal move: its steps may be so far off the curve, for so long, and are never beyond its
    // ends.
    double m_steps = 0;
    double m_settling = 0;
    ProfileCurve::Range m_ends{-std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
};

}  // namespace nmc

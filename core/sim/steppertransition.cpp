// SPDX-License-Identifier: MIT
#include "sim/steppertransition.h"

#include <array>

namespace nmc::sim {

namespace {

enum class Load : std::uint8_t { Must, May, MustNot };

/// A cell of Table 4 that is not "Not Allowed".
struct Cell {
    StepperMode from;
    StepperMode goal;
    Load position;
    Load profile;  ///< velocity and acceleration, which always have the same rule
    Load timer;
};

using enum Load;
using enum StepperMode;

// In motion, "unprofiled with stop" is distinguished from "without" by the mode that it is entered from,
// which the table always determines; entered from a trapezoid, a "velocity profile" is distinguished from it
// by a loaded velocity or acceleration.
constexpr std::array kTransitions{
    Cell{Stopped, Trapezoidal, Must, May, MustNot},
    Cell{Stopped, Velocity, MustNot, May, MustNot},
    Cell{Stopped, UnprofiledWithStop, Must, MustNot, Must},
    Cell{Stopped, Unprofiled, MustNot, MustNot, Must},
    Cell{Trapezoidal, UnprofiledWithStop, MustNot, MustNot, Must},
    Cell{Trapezoidal, Velocity, MustNot, May, Must},
    Cell{Velocity, Velocity, MustNot, May, MustNot},
    Cell{Velocity, Unprofiled, MustNot, MustNot, Must},
    Cell{UnprofiledWithStop, Velocity, MustNot, May, MustNot},
    Cell{UnprofiledWithStop, UnprofiledWithStop, MustNot, MustNot, Must},
    Cell{Unprofiled, Velocity, MustNot, May, MustNot},
    Cell{Unprofiled, Unprofiled, MustNot, MustNot, Must},
};

constexpr bool fits(Load rule, bool loaded) {
    return rule == May || (rule == Must) == loaded;
}

}  // namespace

std::optional<StepperMode> goalMode(StepperMode from, std::uint8_t control) {
    const auto loaded = [control](unsigned bits) { return (control & bits) != 0; };
    const bool position = loaded(StepperTrajectory::kPosition);
    const bool profile = loaded(StepperTrajectory::kSpeed | StepperTrajectory::kAcceleration);
    const bool timer = loaded(StepperTrajectory::kTimer);
    for (const Cell& cell : kTransitions)
        if (cell.from == from && fits(cell.position, position) && fits(cell.profile, profile) &&
            fits(cell.timer, timer))
            return cell.goal;
    return std::nullopt;
}

}  // namespace nmc::sim

// SPDX-License-Identifier: GPL-3.0-or-later
// The mode transitions of a PIC-STEP (DS-S 5.1, Table 4), cell by cell as in the data sheet.
#include "module/stepperrun.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using enum StepperMode;

[[nodiscard]] stepper::LoadTrajectory loading(bool position, bool speed, bool acceleration, bool timer,
                                              bool reverse = false) {
    stepper::LoadTrajectory whole{Counts(1'000), std::uint8_t{100}, std::uint8_t{4},
                                  stepper::TimerCount{60'000, 10}};
    whole.reverse = reverse;
    return partOf(whole, position, speed, acceleration, timer);
}

/// The requirements of a cell: y must be loaded, n must not, and - may be, in the order position, velocity,
/// acceleration, timer. An empty cell is not allowed.
struct Cell {
    StepperMode goal;
    StepperMode from;
    std::string_view loads;
};

/// The goal "stopped" requires the Stop command in all five columns, and no Load Trajectory leads there.
constexpr std::array kTable{
    Cell{Trapezoidal, Stopped, "y--n"},
    Cell{Trapezoidal, Trapezoidal, ""},
    Cell{Trapezoidal, VelocityProfile, ""},
    Cell{Trapezoidal, UnprofiledWithStop, ""},
    Cell{Trapezoidal, Unprofiled, ""},
    Cell{VelocityProfile, Stopped, "n--n"},
    Cell{VelocityProfile, Trapezoidal, "n--y"},
    Cell{VelocityProfile, VelocityProfile, "n--n"},
    Cell{VelocityProfile, UnprofiledWithStop, "n--n"},
    Cell{VelocityProfile, Unprofiled, "n--n"},
    Cell{UnprofiledWithStop, Stopped, "ynny"},
    Cell{UnprofiledWithStop, Trapezoidal, "nnny"},
    Cell{UnprofiledWithStop, VelocityProfile, ""},
    Cell{UnprofiledWithStop, UnprofiledWithStop, "nnny"},
    Cell{UnprofiledWithStop, Unprofiled, ""},
    Cell{Unprofiled, Stopped, "nnny"},
    Cell{Unprofiled, Trapezoidal, ""},
    Cell{Unprofiled, VelocityProfile, "nnny"},
    Cell{Unprofiled, UnprofiledWithStop, ""},
    Cell{Unprofiled, Unprofiled, "nnny"},
};

[[nodiscard]] bool fits(std::string_view loads, unsigned loaded) {
    if (loads.empty())
        return false;
    for (unsigned i = 0; i < 4; ++i) {
        const bool isLoaded = (loaded >> i & 1U) != 0;
        if ((loads[i] == 'y' && !isLoaded) || (loads[i] == 'n' && isLoaded))
            return false;
    }
    return true;
}

/// True if any cell of the column fits what is loaded.
[[nodiscard]] bool tableAllows(StepperMode from, unsigned loaded) {
    for (const Cell& cell : kTable)
        if (cell.from == from && fits(cell.loads, loaded))
            return true;
    return false;
}

[[nodiscard]] stepper::LoadTrajectory loadOf(unsigned loaded, bool reverse = false) {
    return loading((loaded & 1U) != 0, (loaded & 2U) != 0, (loaded & 4U) != 0, (loaded & 8U) != 0, reverse);
}

TEST(StepperGate, FollowsEveryCellOfTheTable) {
    for (const StepperMode from : {Stopped, Trapezoidal, VelocityProfile, UnprofiledWithStop, Unprofiled})
        for (unsigned loaded = 0; loaded < 16; ++loaded) {
            EXPECT_EQ(mayFollow(from, false, loadOf(loaded)), tableAllows(from, loaded))
                << "from " << static_cast<int>(from) << " with " << loaded;
        }
}

TEST(StepperGate, NamesTheGoalOfEveryCell) {
    for (const StepperMode from : {Stopped, Trapezoidal, VelocityProfile, UnprofiledWithStop, Unprofiled})
        for (unsigned loaded = 0; loaded < 16; ++loaded) {
            std::optional<StepperMode> expected;
            for (const Cell& cell : kTable)
                if (!expected && cell.from == from && fits(cell.loads, loaded))
                    expected = cell.goal;
            // With only a timer count, two cells of this column fit, and only one of them needs no ramp.
            if (from == Trapezoidal && loaded == 0b1000)
                expected = UnprofiledWithStop;
            EXPECT_EQ(goalMode(from, loadOf(loaded)), expected)
                << "from " << static_cast<int>(from) << " with " << loaded;
        }
}

TEST(StepperGate, NeverChangesTheDirectionInMotion) {
    for (const bool reverse : {false, true})
        for (unsigned loaded = 0; loaded < 16; ++loaded) {
            for (const StepperMode from :
                 {Trapezoidal, VelocityProfile, UnprofiledWithStop, Unprofiled, Unknown})
                EXPECT_FALSE(mayFollow(from, reverse, loadOf(loaded, !reverse)));
            EXPECT_EQ(mayFollow(Stopped, reverse, loadOf(loaded, !reverse)), tableAllows(Stopped, loaded))
                << "at rest, both directions are possible";
        }
}

TEST(StepperGate, ForbidsEverythingWhileTheModeIsNotKnown) {
    for (unsigned loaded = 0; loaded < 16; ++loaded)
        for (const bool reverse : {false, true})
            EXPECT_FALSE(mayFollow(Unknown, reverse, loadOf(loaded, reverse)));
}

}  // namespace

}  // namespace nmc::test

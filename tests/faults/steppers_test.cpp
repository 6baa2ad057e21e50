// SPDX-License-Identifier: GPL-3.0-or-later
// M-19, M-21 to M-23: what a PIC-STEP does not tolerate while it moves.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

[[nodiscard]] Order toStep(StepperCommand command) {
    return {ModuleIndex(0), std::move(command)};
}

/// The starting modes of DS-S 5.1, Table 4.
enum class From : std::uint8_t { Stopped, Trapezoidal, Velocity, UnprofiledWithStop, Unprofiled };
constexpr std::array kFrom{From::Stopped, From::Trapezoidal, From::Velocity, From::UnprofiledWithStop,
                           From::Unprofiled};

/// Slow enough to be under way for all of a test: 25 x 30 steps per second in speed mode 1x.
[[nodiscard]] stepper::LoadTrajectory run(bool position, bool speed, bool acceleration, bool timer,
                                          bool reverse = false) {
    stepper::LoadTrajectory whole{Counts(20'000), std::uint8_t{30}, std::uint8_t{4},
                                  stepper::TimerCount{500, 50}};
    whole.reverse = reverse;
    return partOf(whole, position, speed, acceleration, timer);
}

class Stepper {
public:
    FaultyBus bus{{{ModuleType::Stepper, 1}}, 115'200};

    [[nodiscard]] bool isReady() {
        return bus.connect() &&
               bus.perform({toStep(stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 10,
                                                          200, 50, 0}),
                            toStep(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}) ==
                   Outcome::Done;
    }
    [[nodiscard]] std::optional<Outcome> start(const stepper::LoadTrajectory& load) {
        return bus.perform({toStep(load), toStep(StartMotion{})});
    }
    [[nodiscard]] bool enter(From from) {
        if (!isReady())
            return false;
        std::optional<Outcome> outcome = Outcome::Done;
        switch (from) {
            case From::Stopped:
                break;
            case From::Trapezoidal:
                outcome = start(run(true, true, true, false));
                break;
            case From::Velocity:
                outcome = start(run(false, true, true, false));
                break;
            case From::UnprofiledWithStop:
                outcome = start(run(true, false, false, true));
                break;
            case From::Unprofiled:
                outcome = start(run(false, false, false, true));
                break;
        }
        bus.runFor(200ms);
        return outcome == Outcome::Done && truth().moving == (from != From::Stopped);
    }
    [[nodiscard]] sim::StepperSnapshot truth() {
        return *bus.chain.snapshot(ModuleIndex(0), bus.now).stepper;
    }
};

TEST(M19_StepperPositionResetWhileMoving, IsNeverSent) {
    for (const From from : kFrom) {
        SCOPED_TRACE(static_cast<int>(from));
        Stepper stepper;
        ASSERT_TRUE(stepper.enter(from));
        const auto outcome = stepper.bus.perform({toStep(ResetPosition{})});
        EXPECT_EQ(outcome, from == From::Stopped ? Outcome::Done : Outcome::Forbidden);
        EXPECT_EQ(stepper.bus.sentTo(0, CommandCode::ResetPosition), from == From::Stopped ? 1U : 0U);
        stepper.bus.expectNoViolations();
    }
}

TEST(M21_DirectionReversedWithoutAStop, IsNeverSent) {
    for (const bool timer : {false, true}) {
        SCOPED_TRACE(timer);
        Stepper stepper;
        ASSERT_TRUE(stepper.enter(timer ? From::Unprofiled : From::Velocity));
        const auto executed = stepper.bus.executed(0, CommandCode::StartMotion);
        EXPECT_EQ(stepper.start(run(false, !timer, !timer, timer, true)), Outcome::Forbidden);
        EXPECT_EQ(stepper.bus.executed(0, CommandCode::StartMotion), executed);
        EXPECT_FALSE(stepper.truth().reverse);
        ASSERT_TRUE(stepper.bus.stopAll());
        EXPECT_EQ(stepper.start(run(false, !timer, !timer, timer, true)), Outcome::Done)
            << "after a stop it may";
        EXPECT_TRUE(stepper.truth().reverse);
        stepper.bus.expectNoViolations();
    }
}

/// Every starting mode with every choice of what is loaded, started after the load or at once.
TEST(M22_ForbiddenModeTransition, IsNeverSent) {
    for (const From from : kFrom)
        for (unsigned loaded = 0; loaded < 16; ++loaded)
            for (const bool atOnce : {false, true}) {
                Stepper stepper;
                ASSERT_TRUE(stepper.enter(from));
                stepper::LoadTrajectory load =
                    run((loaded & 1U) != 0, (loaded & 2U) != 0, (loaded & 4U) != 0, (loaded & 8U) != 0);
                load.startNow = atOnce;
                const auto outcome = atOnce ? stepper.bus.perform({toStep(load)}) : stepper.start(load);
                EXPECT_TRUE(outcome == Outcome::Done || outcome == Outcome::Forbidden);
                for (const sim::Violation& v : stepper.bus.chain.violations().entries())
                    // This is not a forbidden mode but a missing velocity: what the panel loads has one.
                    if (v.kind != sim::ViolationKind::VelocityNotLoaded)
                        ADD_FAILURE() << sim::toText(v.kind) << " from mode " << static_cast<int>(from)
                                      << ": " << toHex(v.bytes);
            }
}

/// The cells of Table 4 that are allowed stay allowed: a gate that forbids everything would be safe and
/// useless.
TEST(M22_ForbiddenModeTransition, LeavesTheOpenCellsOpen) {
    struct Cell {
        From from;
        stepper::LoadTrajectory load;
    };
    for (const Cell& cell : {Cell{From::Stopped, run(true, true, true, false)},
                             Cell{From::Stopped, run(false, true, true, false)},
                             Cell{From::Stopped, run(true, false, false, true)},
                             Cell{From::Stopped, run(false, false, false, true)},
                             Cell{From::Velocity, run(false, true, false, false)}}) {
        Stepper stepper;
        ASSERT_TRUE(stepper.enter(cell.from));
        EXPECT_EQ(stepper.start(cell.load), Outcome::Done) << static_cast<int>(cell.from);
        EXPECT_TRUE(stepper.truth().moving);
        stepper.bus.expectNoViolations();
    }
}

/// The chip ignores another speed mode while it moves: the host would believe something untrue.
TEST(M23_SpeedModeSetWhileMoving, IsNeverSent) {
    for (const From from : kFrom) {
        SCOPED_TRACE(static_cast<int>(from));
        Stepper stepper;
        ASSERT_TRUE(stepper.enter(from));
        // Set Parameters has the code of Set Gain.
        const auto before = stepper.bus.sentTo(0, CommandCode::SetGain);
        const auto outcome = stepper.bus.perform(
            {toStep(stepper::SetParameters{stepper::SpeedMode::X8, false, false, false, 10, 200, 50, 0})});
        EXPECT_EQ(outcome, from == From::Stopped ? Outcome::Done : Outcome::Forbidden);
        EXPECT_EQ(stepper.bus.sentTo(0, CommandCode::SetGain), before + (from == From::Stopped ? 1U : 0U));
        stepper.bus.expectNoViolations();
    }
}

}  // namespace

}  // namespace nmc::test

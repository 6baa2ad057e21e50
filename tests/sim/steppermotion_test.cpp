// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.1 to 4.3: the step timer, the unprofiled modes and the two profiles.
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

struct Timer {
    unsigned mode;
    double hertz;
    unsigned k;
    unsigned multiplier;
};
constexpr Timer kTimers[] = {{k1x, 625e3, 2, 1}, {k2x, 1.25e6, 4, 2}, {k4x, 2.5e6, 8, 4}, {k8x, 5e6, 16, 8}};

TEST(StepperTimer, TheInitialCountOfTheFormulaGivesTheSpeedInAllFourModes) {
    for (const Timer& timer : kTimers) {
        // Speeds that divide the clock: 65 536 - f/S + k.
        for (const unsigned speed :
             {50U * timer.multiplier, 1000U * timer.multiplier, 5000U * timer.multiplier}) {
            StepperWire wire;
            wire.parameters(timer.mode);
            const auto count = static_cast<std::uint16_t>(65'536 - timer.hertz / speed + timer.k);
            wire.load({.count = count});
            wire.wait(milliseconds(100));
            EXPECT_NEAR(wire.step().stepRate, speed, 1e-9);
            EXPECT_NEAR(wire.stepsIn(kEightSeconds), 8.0 * speed, 1.0) << speed;
            EXPECT_EQ(wire.stepReport().timerCount, count);
            EXPECT_EQ(wire.violations(), std::vector<ViolationKind>{});
        }
    }
}

TEST(StepperTimer, TakesCountsFrom1To65452AndNoOthers) {
    for (const Timer& timer : kTimers) {
        StepperWire wire;
        wire.parameters(timer.mode);
        wire.load({.count = std::uint16_t{1}});
        EXPECT_NEAR(wire.step().stepRate, timer.hertz / (65'535 + timer.k), 1e-4);
        wire.load({.count = std::uint16_t{65'452}});
        EXPECT_NEAR(wire.step().stepRate, timer.hertz / (84 + timer.k), 1e-1);
        EXPECT_EQ(wire.violations(), std::vector<ViolationKind>{});
        wire.load({.count = std::uint16_t{65'453}});
        EXPECT_EQ(wire.violations(), std::vector{ViolationKind::OutOfRange});
        EXPECT_EQ(wire.step().timerCount, 65'452);
        wire.load({.count = std::uint16_t{0}});
        EXPECT_EQ(wire.step().timerCount, 1);
    }
    // The largest count at 8x gives the highest speed.
    StepperWire wire;
    wire.parameters(k8x);
    wire.load({.count = std::uint16_t{65'452}});
    EXPECT_NEAR(wire.step().stepRate, 50'000, 1e-6);
}

TEST(Unprofiled, StartsAtFullSpeedInTheDirectionOfTheBit) {
    StepperWire wire;
    wire.parameters(k1x, 50);
    wire.load({.count = std::uint16_t{65'536 - 125 + 2}, .nearest = 200, .reverse = true});  // 5000/s
    EXPECT_EQ(wire.stepReport().status & 0x71U, 0x11U) << "moving, at speed, no profile";
    EXPECT_TRUE(wire.step().reverse);
    EXPECT_NEAR(wire.stepsIn(milliseconds(512)), -2560, 1);
}

TEST(Unprofiled, StopsAbruptlyAtTheLoadedPosition) {
    for (const std::int32_t goal : {5000, -5000}) {
        StepperWire wire;
        wire.parameters(k1x, 50);
        // The direction bit applies only to the modes without a position.
        wire.load({.position = goal, .count = std::uint16_t{65'536 - 125 + 2}, .reverse = goal > 0});
        EXPECT_NEAR(toSeconds(wire.timeToStop()), 1.0, 0.02);
        EXPECT_EQ(wire.position(), goal);
        EXPECT_EQ(wire.stepReport().status & 0x71U, 0U);
        wire.wait(seconds(1));
        EXPECT_EQ(wire.position(), goal);
    }
}

TEST(VelocityProfile, HasTheResolutionAndMaximumOfTable3) {
    for (const Timer& timer : kTimers) {
        StepperWire wire;
        wire.parameters(timer.mode);
        wire.load({.speed = std::uint8_t{1}, .acceleration = std::uint8_t{1}});
        EXPECT_NEAR(wire.step().stepRate, 25.0 * timer.multiplier, 1e-9);
        EXPECT_NEAR(wire.stepsIn(kEightSeconds), 200.0 * timer.multiplier, 1.0);
        wire.load({.speed = std::uint8_t{250}});
        wire.wait(milliseconds(100));
        EXPECT_NEAR(wire.step().stepRate, 6250.0 * timer.multiplier, 1e-9);
        EXPECT_NEAR(wire.stepsIn(kEightSeconds), 50'000.0 * timer.multiplier, 1.0);
        EXPECT_EQ(wire.stepReport().timerCount, 65'536U - 100U + timer.k);
    }
}

TEST(VelocityProfile, From25To125WithAnAccelerationTimeOf4Takes100Milliseconds) {
    StepperWire wire;
    wire.parameters(k1x, 25);
    wire.load({.speed = std::uint8_t{25}, .acceleration = std::uint8_t{4}});
    EXPECT_EQ(wire.stepReport().status & 0x71U, 0x31U);
    wire.load({.speed = std::uint8_t{125}, .start = false});
    EXPECT_EQ(wire.step().speed, 25U) << "no effect until Start Motion";
    wire.command(1, 0x05);
    // The command was executed before its reply of 2 bytes, 20 bit times at 19 531 Bd.
    const TimePoint begin = wire.now - std::chrono::microseconds(1024);
    EXPECT_EQ(wire.stepReport().status & 0x10U, 0U);
    wire.wait(milliseconds(50) - (wire.now - begin));
    EXPECT_NEAR(wire.step().speed, 75.0, 1.0);
    wire.wait(milliseconds(98) - (wire.now - begin));
    EXPECT_LT(wire.step().speed, 125U);
    wire.wait(milliseconds(101) - (wire.now - begin));
    EXPECT_EQ(wire.step().speed, 125U);
    EXPECT_EQ(wire.stepReport().status & 0x10U, 0x10U);
}

TEST(VelocityProfile, AGoalBelowTheMinimumRunsAtTheMinimum) {
    StepperWire wire;
    wire.parameters(k1x, 40);
    wire.load({.speed = std::uint8_t{10}, .acceleration = std::uint8_t{4}});
    wire.wait(seconds(1));
    EXPECT_EQ(wire.step().speed, 40U);
}

TEST(VelocityProfile, ASmoothStopRampsToTheMinimumAndThenStops) {
    StepperWire wire;
    wire.parameters(k1x, 50);
    wire.load({.speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
    wire.wait(milliseconds(500));
    ASSERT_EQ(wire.step().speed, 150U);
    const std::int32_t from = wire.position();
    wire.stop(0x09);
    EXPECT_NEAR(toSeconds(wire.timeToStop()), 0.1, 0.003);
    // 1 ms at each of 150 ... 51: 10 050 x 25 x 0.001 = 251 steps, plus those made while the command arrived.
    EXPECT_NEAR(wire.position() - from, 251 + 0.0031 * 150 * 25, 4);
    // The goal speed is 0 now, and that is below the minimum.
    wire.load({});
    wire.wait(milliseconds(500));
    EXPECT_EQ(wire.step().speed, 50U);
}

TEST(VelocityProfile, AnAbruptStopStopsAtOnceAndTheSpeedStaysLoaded) {
    StepperWire wire;
    wire.parameters(k1x, 50);
    wire.load({.speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
    wire.wait(milliseconds(500));
    wire.stop(0x05);
    EXPECT_FALSE(wire.step().moving);
    EXPECT_EQ(wire.stepsIn(seconds(1)), 0);
    wire.load({});
    wire.wait(milliseconds(500));
    EXPECT_EQ(wire.step().speed, 150U);
}

TEST(UnprofiledVelocity, RampsFromTheNearestIntegerSpeedWhenAProfileFollows) {
    StepperWire wire;
    wire.parameters(k1x, 10);
    wire.load({.acceleration = std::uint8_t{40}, .start = false});
    wire.load({.count = std::uint16_t{65'536 - 250 + 2}, .nearest = 100});  // 2500/s
    wire.wait(milliseconds(100));
    wire.load({.speed = std::uint8_t{110}, .acceleration = std::uint8_t{40}});  // 10 ms for each speed
    EXPECT_EQ(wire.step().speed, 100U);
    wire.wait(milliseconds(55));
    EXPECT_NEAR(wire.step().speed, 105.0, 1.0);
    wire.wait(milliseconds(55));
    EXPECT_EQ(wire.step().speed, 110U);
}

TEST(TrapezoidalProfile, RampsFromAndToTheMinimumSpeedAndEndsExactlyOnItsGoal) {
    // 8x, from 50 to 150 and back at 1 ms each: 2 x 9950 x 200 x 0.001 = 3980 steps in 0.2 s, and one second
    // at 30 000 steps per second.
    for (const std::int32_t goal : {33'980, -33'980}) {
        StepperWire wire;
        wire.parameters(k8x, 50);
        wire.load({.position = goal, .speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
        EXPECT_EQ(wire.stepReport().status & 0x71U, 0x41U);
        EXPECT_NEAR(wire.step().speed, 58, 6) << "it began at the minimum";
        const TimePoint begin = wire.now;
        wire.wait(milliseconds(600));
        EXPECT_EQ(wire.step().speed, 150U);
        EXPECT_EQ(wire.stepReport().status & 0x71U, 0x51U);
        static_cast<void>(wire.timeToStop());
        EXPECT_NEAR(toSeconds(wire.now - begin), 1.2, 0.015);
        EXPECT_EQ(wire.position(), goal);
        EXPECT_EQ(wire.stepReport().status & 0x71U, 0U);
        EXPECT_EQ(wire.stepReport().position, goal);
    }
}

TEST(TrapezoidalProfile, DecelerationTakesAsLongAsAcceleration) {
    StepperWire wire;
    wire.parameters(k8x, 50);
    wire.load({.position = 33'980, .speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
    wire.wait(milliseconds(600));
    while (wire.step().speed == 150)
        wire.wait(kTick);
    EXPECT_NEAR(toSeconds(wire.timeToStop()), 0.1, 0.001);
    EXPECT_EQ(wire.position(), 33'980);
}

TEST(TrapezoidalProfile, AnyLengthEndsExactlyAndNeverFasterThanItsSpeed) {
    for (const std::int32_t goal : {1, 2, 3, 17, 100, 999, 1990, 3979, 3980, 3981, 5000}) {
        StepperWire wire;
        wire.parameters(k8x, 50);
        wire.load({.position = goal, .speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
        unsigned last = 0;
        while (wire.step().moving) {
            last = wire.step().speed;
            EXPECT_LE(last, 150U);
            wire.wait(kTick);
        }
        EXPECT_EQ(wire.position(), goal);
        EXPECT_LE(last, 53U) << goal << ": slow at the end";
    }
}

TEST(TrapezoidalProfile, AMoveToWhereItStandsDoesNotMove) {
    StepperWire wire;
    wire.parameters(k1x, 50);
    wire.load({.position = 0, .speed = std::uint8_t{150}, .acceleration = std::uint8_t{4}});
    EXPECT_FALSE(wire.step().moving);
    EXPECT_EQ(wire.stepReport().status & 0x71U, 0U);
}

TEST(TrapezoidalProfile, ThePositionCounterHas32Bits) {
    StepperWire wire;
    wire.parameters(k8x, 250);
    wire.load({.position = 0x7FFFFFFF, .speed = std::uint8_t{250}, .acceleration = std::uint8_t{1}});
    wire.wait(seconds(42'949));  // 2 147 450 000 steps
    EXPECT_NEAR(wire.position(), 2'147'450'000, 1000);
    static_cast<void>(wire.timeToStop());
    EXPECT_EQ(wire.position(), 0x7FFFFFFF);
    wire.load({.position = -0x7FFFFFFF - 1 + 100});
    static_cast<void>(wire.timeToStop());
    EXPECT_EQ(wire.position(), -0x7FFFFFFF - 1 + 100) << "forward across the wrap";
}

TEST(StepMotor, TwoRunsOfTheSameAreTheSameHoweverTimeIsCut) {
    const auto run = [](Duration slice) {
        StepperWire wire;
        wire.parameters(k8x, 3);
        wire.load({.position = 123'456, .speed = std::uint8_t{201}, .acceleration = std::uint8_t{7}});
        for (const TimePoint end = wire.now + milliseconds(2520); wire.now < end;)
            wire.wait(slice);
        return wire.position();
    };
    EXPECT_EQ(run(milliseconds(2520)), run(std::chrono::microseconds(700)));
    EXPECT_EQ(run(milliseconds(2520)), run(milliseconds(2520)));
    EXPECT_GT(run(milliseconds(2520)), 10'000);
}

}  // namespace
}  // namespace nmc::sim::test

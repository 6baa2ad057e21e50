// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.1 to 4.3, the step timer, the unprofiled modes and the two profiles: the simulator's behaviour
// beyond the statements, which tests/conformance covers.
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

struct Timer {
    unsigned mode;
    double hertz;
    unsigned k;
};
constexpr Timer kTimers[] = {{k1x, 625e3, 2}, {k2x, 1.25e6, 4}, {k4x, 2.5e6, 8}, {k8x, 5e6, 16}};

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

// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.5 and 4.6, limits, E-stop, power, temperature, currents: the simulator's behaviour beyond the
// statements, which tests/conformance covers.
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using Kinds = std::vector<ViolationKind>;

class StepperPinsTest : public testing::Test {
protected:
    void run(bool reverse = false) { wire.load({.count = kCount, .nearest = 40, .reverse = reverse}); }
    [[nodiscard]] bool moving() { return wire.step().moving; }
    [[nodiscard]] bool amplifier() { return (wire.stepReport().status & 0x04U) != 0; }
    StepperWire wire;
};

TEST_F(StepperPinsTest, Limit1StopsForwardAndLimit2ReverseMotionAndTheWayBackIsFree) {
    wire.parameters(k1x);
    for (const bool reverse : {false, true}) {
        const Input own = reverse ? Input::Limit2 : Input::Limit1;
        const Input other = reverse ? Input::Limit1 : Input::Limit2;
        run(reverse);
        wire.set(other, 1);
        wire.waitTicks(2);
        EXPECT_TRUE(moving()) << "it moves away from that switch";
        wire.set(other, 0);
        wire.set(own, 1);
        wire.waitTicks(2);
        EXPECT_FALSE(moving());
        EXPECT_TRUE(amplifier());
        run(reverse);
        EXPECT_FALSE(moving()) << "inhibited";
        EXPECT_EQ(wire.stepsIn(milliseconds(100)), 0);
        run(!reverse);
        EXPECT_TRUE(moving());
        wire.stop(0x05);
        wire.set(own, 0);
    }
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(StepperPinsTest, ALimitStopsATrapezoidToo) {
    wire.parameters(k1x, 10);
    wire.load({.position = 10'000, .speed = std::uint8_t{100}, .acceleration = std::uint8_t{4}});
    wire.wait(milliseconds(500));
    wire.set(Input::Limit1, 1);
    wire.waitTicks(2);
    EXPECT_FALSE(moving());
    EXPECT_EQ(wire.stepReport().status & 0x71U, 0U);
    EXPECT_LT(wire.position(), 10'000);
    wire.load({.position = 0});
    static_cast<void>(wire.timeToStop());
    EXPECT_EQ(wire.position(), 0);
}

TEST_F(StepperPinsTest, StoppingAtLimitsCanBeDisabled) {
    wire.parameters(k1x | kIgnoreLimits);
    run();
    wire.set(Input::Limit1, 1);
    wire.waitTicks(2);
    EXPECT_TRUE(moving());
    wire.parameters(k1x);
    wire.waitTicks(2);
    EXPECT_FALSE(moving()) << "the bit takes effect in motion, too";
}

TEST_F(StepperPinsTest, EStopStopsAndCanBeDisabled) {
    wire.parameters(k1x);
    run();
    wire.set(Input::Estop, 1);
    wire.waitTicks(2);
    EXPECT_FALSE(moving());
    EXPECT_TRUE(amplifier());
    run();
    run(true);
    EXPECT_FALSE(moving());
    wire.parameters(k1x | kIgnoreEstop);
    run();
    EXPECT_TRUE(moving());
    EXPECT_EQ(wire.stepReport().inputs, 0x01U);
}

TEST_F(StepperPinsTest, TheMotorIsTurnedOffOnLimitOrEStopWhenAskedTo) {
    for (const Input input : {Input::Limit1, Input::Estop}) {
        wire.stop(0x01);
        wire.parameters(k1x | kMotorOffAtLimit);
        run();
        EXPECT_TRUE(amplifier());
        wire.set(input, 1);
        wire.waitTicks(2);
        EXPECT_FALSE(moving());
        EXPECT_FALSE(amplifier());
        wire.set(input, 0);
        wire.waitTicks(2);
        EXPECT_FALSE(amplifier()) << "it stays off until a Stop Motor command enables it";
    }
}

TEST_F(StepperPinsTest, LowPowerLowersTheAmplifierAndTerminatesMotion) {
    wire.parameters(k1x | kIgnoreLimits | kIgnoreEstop);
    run();
    EXPECT_EQ(wire.stepReport().status & 0x0DU, 0x0DU);
    wire.set(Input::Power, 0);
    wire.waitTicks(2);
    EXPECT_EQ(wire.stepReport().status & 0x0DU, 0U);
    wire.stop(0x01);
    run();
    EXPECT_EQ(wire.stepReport().status & 0x0DU, 0U);
    wire.set(Input::Power, 1);
    wire.waitTicks(2);
    EXPECT_EQ(wire.stepReport().status & 0x0DU, 0x08U) << "AMP_EN does not come back by itself";
    wire.stop(0x01);
    EXPECT_EQ(wire.stepReport().status & 0x0DU, 0x0CU);
}

TEST_F(StepperPinsTest, AnAnalogValueBelowTheThermalLimitTurnsTheMotorOffAndZeroDisablesThat) {
    wire.parameters(k1x, 1, 200, 80, 100);
    run();
    wire.set(Input::Analog, 100);
    wire.waitTicks(2);
    EXPECT_TRUE(moving());
    EXPECT_TRUE(amplifier());
    wire.set(Input::Analog, 99);
    wire.waitTicks(2);
    EXPECT_FALSE(moving());
    EXPECT_FALSE(amplifier());
    EXPECT_EQ(wire.stepReport().analog, 99U);
    wire.parameters(k1x, 1, 200, 80, 0);
    wire.set(Input::Analog, 0);
    wire.stop(0x01);
    run();
    wire.waitTicks(2);
    EXPECT_TRUE(moving());
    EXPECT_TRUE(amplifier());
}

TEST_F(StepperPinsTest, RunsAtTheRunningCurrentAndHoldsItAQuarterSecondAfterTheStop) {
    EXPECT_EQ(wire.step().currentLimit, 0);
    wire.parameters(k1x, 1, 200, 80);
    EXPECT_EQ(wire.step().currentLimit, 80);
    run();
    EXPECT_EQ(wire.step().currentLimit, 200);
    wire.wait(milliseconds(1000));
    EXPECT_EQ(wire.step().currentLimit, 200);
    const TimePoint before = wire.now;
    wire.stop(0x05);
    wire.wait(milliseconds(245) - (wire.now - before));
    EXPECT_EQ(wire.step().currentLimit, 200);
    wire.wait(milliseconds(10));
    EXPECT_EQ(wire.step().currentLimit, 80);
}

}  // namespace
}  // namespace nmc::sim::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Hold to move of a PIC-STEP: velocity profile mode, whose direction only a stop can change (DS-S 4.2).
#include <gtest/gtest.h>

#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

class StepperHold : public ::testing::Test {
protected:
    [[nodiscard]] static Order to(StepperCommand command) { return {ModuleIndex(0), std::move(command)}; }
    void prepare(bool enabled = true) {
        ASSERT_TRUE(bus.connect());
        stepper::SetParameters parameters;
        parameters.speedMode = stepper::SpeedMode::X1;
        ASSERT_EQ(bus.perform({to(parameters)}), Outcome::Done);
        if (enabled) {
            ASSERT_EQ(bus.perform({to(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}),
                      Outcome::Done);
        }
        bus.runFor(100ms);
        from = bus.sent.size();
    }
    /// 40 x 25 steps/s, with one more unit every 1 ms.
    [[nodiscard]] static HoldToMove pace(bool reverse, std::uint8_t speed = 40) {
        HoldToMove hold;
        hold.module = ModuleIndex(0);
        hold.reverse = reverse;
        hold.pace = StepperPace{speed, 4};
        return hold;
    }
    void holdFor(Duration time, const HoldToMove& hold) {
        for (const TimePoint end = bus.now + time; bus.now < end; bus.runFor(100ms))
            bus.engine.hold(hold, bus.now);
    }
    sim::StepperSnapshot truth() { return bus.chain.snapshot(ModuleIndex(0), bus.now).stepper.value(); }

    VirtualBus bus{std::vector<ModuleIdentity>{{ModuleType::Stepper, 1}}};
    std::size_t from = 0;
};

// Load speed and acceleration time, start now: 86, in reverse 96; 40 = 28. Stop smoothly, amplifier on: 09.
TEST_F(StepperHold, MovesUntilReleased) {
    prepare();
    holdFor(1s, pace(false));
    EXPECT_NEAR(truth().stepRate, 1'000, 1e-6);
    EXPECT_EQ(bus.sends("AA 01 34 86 28 04", from), 1U) << "the same pace is not sent again";
    bus.engine.release(bus.now);
    bus.runFor(500ms);
    EXPECT_EQ(bus.sends("AA 01 17 09", from), 1U);
    EXPECT_FALSE(truth().moving);
    EXPECT_TRUE(truth().ampEnabled);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U) << "every answer was believed";
    bus.expectNoViolations();
}

TEST_F(StepperHold, StopsWhenItsStartIsNotAnswered) {
    prepare();
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x34; };
    bus.engine.hold(pace(false), bus.now);
    bus.runFor(200ms);
    EXPECT_EQ(bus.sends("AA 01 34 86", from), 1U);
    EXPECT_FALSE(truth().moving);
    EXPECT_EQ(bus.count<HoldExpired>(), 1U);
}

TEST_F(StepperHold, NeverRestartsWhatALimitHasStopped) {
    prepare();
    holdFor(300ms, pace(false));
    bus.chain.set(ModuleIndex(0), sim::Input::Limit1, 1.0, bus.now);
    holdFor(300ms, pace(false));
    bus.chain.set(ModuleIndex(0), sim::Input::Limit1, 0.0, bus.now);
    holdFor(300ms, pace(false));
    EXPECT_FALSE(truth().moving);
    EXPECT_EQ(bus.sends("AA 01 34 86", from), 1U);
}

TEST_F(StepperHold, EndsWithAStopOfAllMotors) {
    prepare();
    holdFor(300ms, pace(true));
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(500ms);
    EXPECT_EQ(bus.sends("AA 01 34", from), 1U);
    EXPECT_FALSE(truth().moving);
    EXPECT_TRUE(truth().ampEnabled);
}

TEST_F(StepperHold, EndsByItselfWhenTheEvidenceStopsComing) {
    prepare();
    bus.engine.hold(pace(true), bus.now);
    const TimePoint last = bus.now;
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<HoldExpired>() == 1; }, 1s));
    EXPECT_EQ(bus.now - last, Duration(250ms));
    bus.runFor(300ms);
    EXPECT_EQ(bus.sends("AA 01 34 96 28 04", from), 1U);
    EXPECT_FALSE(truth().moving);
    EXPECT_LT(truth().position, 0);
    bus.expectNoViolations();
}

TEST_F(StepperHold, ChangesTheSpeedOnTheFly) {
    prepare();
    holdFor(500ms, pace(false));
    holdFor(500ms, pace(false, 20));
    EXPECT_NEAR(truth().stepRate, 500, 1e-6);
    bus.expectNoViolations();
}

TEST_F(StepperHold, KeepsItsSpeedOnTheWayToATravelLimit) {
    for (const bool reverse : {false, true}) {
        SCOPED_TRACE(reverse);
        VirtualBus chain(std::vector<ModuleIdentity>{{ModuleType::Stepper, 1}});
        ASSERT_TRUE(chain.connect());
        stepper::SetParameters parameters;
        parameters.speedMode = stepper::SpeedMode::X1;
        ASSERT_EQ(
            chain.perform({to(parameters), to(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}),
            Outcome::Done);
        chain.engine.setTravelLimits({{-5'000, 5'000}});
        chain.runFor(100ms);
        HoldToMove hold = pace(reverse);
        hold.goal = reverse ? -5'000 : 5'000;
        hold.press = 1;
        const auto holdOn = [&](Duration time) {
            for (const TimePoint end = chain.now + time; chain.now < end; chain.runFor(100ms))
                chain.engine.hold(hold, chain.now);
            return chain.chain.snapshot(ModuleIndex(0), chain.now).stepper.value();
        };
        const double sign = reverse ? -1 : 1;
        EXPECT_NEAR(holdOn(500ms).stepRate, sign * 1'000, 1e-6);
        hold.pace->speed = 60;
        EXPECT_NEAR(holdOn(500ms).stepRate, sign * 1'000, 1e-6);
        EXPECT_EQ(holdOn(5s).position, sign * 5'000);
        EXPECT_EQ(chain.count<HoldExpired>(), 0U);
        chain.expectNoViolations();
    }
}

TEST_F(StepperHold, StopsInsteadOfReversing) {
    prepare();
    holdFor(500ms, pace(false));
    holdFor(100ms, pace(true));
    bus.runFor(300ms);
    EXPECT_FALSE(truth().moving);
    EXPECT_EQ(bus.sends("AA 01 34 96", from), 0U);
    bus.expectNoViolations();
}

TEST_F(StepperHold, NeverSwitchesAnAmplifierOn) {
    prepare(false);
    holdFor(500ms, pace(false));
    EXPECT_EQ(bus.sends("AA 01 34", from), 0U);
    EXPECT_EQ(bus.sends("AA 01 17", from), 0U);
    EXPECT_FALSE(truth().ampEnabled);
}

TEST_F(StepperHold, NeverStartsWhatNoParametersWereSetFor) {
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({to(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}), Outcome::Done);
    from = bus.sent.size();
    holdFor(300ms, pace(false));
    EXPECT_EQ(bus.sends("AA 01 34", from), 0U);
}

TEST_F(StepperHold, OfAPaceIsNothingForAServo) {
    VirtualBus servoBus(servos(1));
    ASSERT_TRUE(servoBus.connect());
    ASSERT_EQ(servoBus.perform({{ModuleIndex(0), ServoCommand(nmc::servo::StopMotor{
                                                     true, nmc::servo::StopManner::Abruptly, {}})}}),
              Outcome::Done);
    const std::size_t before = servoBus.sent.size();
    servoBus.engine.hold(pace(false), servoBus.now);
    servoBus.runFor(200ms);
    EXPECT_EQ(servoBus.sends("AA 01 34", before), 0U);
}

// The direction of a move is that of its goal, whatever the bit says (DS-S 5.1).
TEST_F(StepperHold, GoesOnWithAMoveInTheDirectionThatItHas) {
    prepare();
    stepper::LoadTrajectory move;
    move.position = Counts(-20'000);
    move.timer = stepper::TimerCount{64'288, 20};
    ASSERT_EQ(bus.perform({to(move), to(StartMotion{})}), Outcome::Done);
    bus.runFor(300ms);
    holdFor(300ms, pace(true));
    EXPECT_EQ(bus.sends("AA 01 34 96", from), 1U);
    bus.engine.release(bus.now);
    bus.runFor(300ms);
    EXPECT_FALSE(truth().moving);
    bus.expectNoViolations();
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// M-13, M-15, M-17, M-19, M-20, M-26: servos.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

// ---- M-13 ----

TEST(M13_ServoOverrun, IsShownAndChangesNothing) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(200ms);
    const std::size_t from = bus.sent.size();
    bus.chain.set(ModuleIndex(0), sim::Input::ServoOverrun, 1.0, bus.now);
    const auto shown = [&] {
        const auto sample = bus.lastSample(0);
        return sample && sample->report.aux && servo::AuxByte{*sample->report.aux}.servoOverrun();
    };
    EXPECT_TRUE(bus.runUntil(shown, 1s));
    bus.runFor(2s);
    bus.expectOnlyQuestions(from);
    EXPECT_EQ(bus.sentTo(0, CommandCode::StopMotor, from), 0U);
    EXPECT_GT(bus.servo(0).commandVelocity, 0.9);
    EXPECT_EQ(bus.count<MotionSuspect>(), 0U);
    EXPECT_EQ(bus.health(), LinkHealth::Good);
}

// ---- M-15 ----

/// The switch closes while the module is not heard. What is reported about home afterwards is true, and the
/// doubt about the link was reported before.
TEST(M15_HomeCapturedWhileRepliesWereLost, IsToldAsItIs) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    servo::SetHoming homing;
    homing.onLimit1Change = true;
    homing.stopAbruptly = true;
    ASSERT_EQ(bus.perform({toServo(0, homing), loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(500ms);
    const auto resyncs = bus.engine.statistics().resyncs;
    bus.fault("module 1 drop status for=100ms");
    bus.runFor(40ms);
    bus.chain.set(ModuleIndex(0), sim::Input::Limit1, 1.0, bus.now);
    bus.runFor(3s);
    EXPECT_GT(bus.engine.statistics().resyncs, resyncs) << "a home search can see that the link was in doubt";
    const std::int32_t home = bus.servo(0).home;
    EXPECT_NE(home, 0);
    int told = 0;
    for (const Sample& sample : bus.all<Sample>())
        if (sample.module == ModuleIndex(0) && sample.report.home && *sample.report.home != 0) {
            EXPECT_EQ(*sample.report.home, home);
            ++told;
        }
    EXPECT_GT(told, 0);
    const auto last = bus.lastSample(0);
    ASSERT_TRUE(last);
    EXPECT_FALSE(last->report.servoStatus().homeInProgress());
    bus.expectNoViolations();
}

// ---- M-17 ----

/// The position error limit is so high that it does not end a motion before the host does.
void enableWithoutALimit(FaultyBus& bus) {
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({toServo(0, servo::SetGain{200, 2000, 20, 200, 255, 0, 0x3FFF, 1, std::uint8_t{0}}),
                           enable(0)}),
              Outcome::Done);
}

TEST(M17_MotorRunsAway, IsStoppedWithinThreePolls) {
    constexpr std::int32_t kFarOut = 500;
    for (const bool byVelocity : {false, true}) {
        SCOPED_TRACE(byVelocity);
        FaultyBus bus(servos(1), kFast);
        ASSERT_NO_FATAL_FAILURE(enableWithoutALimit(bus));
        bus.runFor(200ms);
        bus.fault("module 1 reverse");
        if (byVelocity)
            bus.submit({loadVelocity(0, kOnePerTick, true)});
        else
            bus.submit({loadMove(0, 5'000), start(0)});
        ASSERT_TRUE(bus.runUntil([&] { return bus.servo(0).position < -kFarOut; }, 3s));
        const std::size_t samples = bus.samplesOf(0);
        ASSERT_TRUE(bus.runUntil([&] { return bus.motionSuspects(0) > 0; }, 1s));
        EXPECT_LE(bus.samplesOf(0), samples + 3);
        EXPECT_EQ(bus.last<MotionSuspect>()->reason, MotionSuspect::Reason::WrongWay);
        const std::size_t from = bus.sent.size();
        bus.runFor(50ms);
        EXPECT_GE(bus.sentTo(0, CommandCode::StopMotor) - 1, 1U)
            << "in addition to the one that switched it on";
        bus.runFor(1s);
        bus.expectOnlyQuestions(from);
    }
}

/// It is noticed at the same time in both runs, in a reply; the stop of the other is submitted just before.
TEST(M17_MotorRunsAway, LeavesAnotherModuleItsStop) {
    std::optional<TimePoint> noticed;
    for (const bool stops : {false, true}) {
        FaultyBus bus(servos(2), kFast);
        ASSERT_NO_FATAL_FAILURE(enableWithoutALimit(bus));
        ASSERT_EQ(bus.perform({gains(1), enable(1), loadVelocity(1, kOnePerTick, true)}), Outcome::Done);
        bus.runFor(200ms);
        bus.fault("module 1 reverse");
        bus.submit({loadVelocity(0, kOnePerTick, true)});
        if (stops) {
            bus.runFor(*noticed - 200us - bus.now);
            bus.submit({toServo(1, servo::StopMotor{true, servo::StopManner::Smoothly, {}})});
        }
        ASSERT_EQ(bus.motionSuspects(0), 0U);
        ASSERT_TRUE(bus.runUntil([&] { return bus.motionSuspects(0) > 0; }, 3s));
        if (stops)
            EXPECT_EQ(bus.now, *noticed);
        noticed = bus.now;
        bus.runFor(1s);
        EXPECT_EQ(bus.servo(1).commandVelocity == 0.0, stops);
    }
}

/// A stop that keeps the servo on would let it run on the wrong way.
TEST(M17_MotorRunsAway, IsSwitchedOffByAStopOfAllModulesAsWell) {
    FaultyBus bus(servos(1), kFast);
    ASSERT_NO_FATAL_FAILURE(enableWithoutALimit(bus));
    bus.fault("module 1 reverse");
    bus.submit({loadVelocity(0, kOnePerTick, true)});
    bool lost = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (bus.motionSuspects(0) > 0 && !std::exchange(lost, true))
            command.clear();  // the stop that is owed for it does not arrive
    };
    ASSERT_TRUE(bus.runUntil([&] { return bus.motionSuspects(0) > 0; }, 3s));
    const std::size_t from = bus.sent.size();
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(0).servoOn);
    EXPECT_EQ(bus.sends("AA 01 17 05", from), 0U) << "stop abruptly, amplifier on (DS-V 5.2)";
}

TEST(M17_MotorRunsAway, IsSwitchedOffWhateverStopIsAskedForDuringASearch) {
    FaultyBus bus(servos(1), kFast);
    ASSERT_NO_FATAL_FAILURE(enableWithoutALimit(bus));
    bus.fault("module 1 reverse");
    bus.submit({loadVelocity(0, kOnePerTick, true)});
    bool arrives = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (!arrives && command.size() > 2 && command[2] == 0x17)
            command.clear();  // no stop
    };
    ASSERT_TRUE(bus.runUntil([&] { return bus.motionSuspects(0) > 0; }, 3s));
    const std::size_t from = bus.sent.size();
    bus.engine.connect(bus.now);
    ASSERT_EQ(bus.perform({toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})}),
              Outcome::Done);
    arrives = true;
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(0).servoOn);
    EXPECT_GE(bus.sends("AA 01 17 02", from), 1U) << "motor off (DS-V 5.2)";
    EXPECT_EQ(bus.sends("AA 01 17 09", from), 0U) << "stop smoothly, amplifier on";
}

TEST(M17_MotorRunsAway, IsNotSaidOfAMotorThatDoesAsItIsTold) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    for (const std::int32_t goal : {5'000, -5'000, 300, 301, 299, 0}) {
        ASSERT_EQ(bus.perform({loadMove(0, goal), start(0)}), Outcome::Done);
        bus.runFor(4s);
        EXPECT_NEAR(bus.servo(0).position, goal, 5);
    }
    for (const std::uint32_t velocity : {4 * kOnePerTick, kOnePerTick / 2, 10 * kOnePerTick}) {
        ASSERT_EQ(bus.perform({loadVelocity(1, velocity, true)}), Outcome::Done);
        bus.runFor(1s);
    }
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(1s);
    EXPECT_EQ(bus.count<MotionSuspect>(), 0U);
    bus.expectNoViolations();
}

// ---- M-19, M-20 ----

class M19_PositionResetWhileMoving : public testing::TestWithParam<bool> {};
TEST_P(M19_PositionResetWhileMoving, IsNeverSent) {
    FaultyBus bus(servos(1), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    const auto moving = GetParam() ? bus.perform({loadVelocity(0, kOnePerTick, true)})
                                   : bus.perform({loadMove(0, 20'000), start(0)});
    ASSERT_EQ(moving, Outcome::Done);
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(bus.perform({toServo(0, ResetPosition{})}), Outcome::Forbidden);
        bus.runFor(37ms);
    }
    EXPECT_EQ(bus.sentTo(0, CommandCode::ResetPosition), 0U);
    ASSERT_TRUE(bus.stopAll());
    EXPECT_EQ(bus.perform({toServo(0, ResetPosition{})}), Outcome::Done);
    bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(Modes, M19_PositionResetWhileMoving, testing::Bool());

/// Not even when answers about the motion are lost: in doubt, the motor counts as moving.
TEST(M20_TrapezoidChangedWhileMoving, IsNeverSent) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(1), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault("bus drop status p=.1");
        for (std::int32_t i = 0; i < 100; ++i) {
            bus.submit({loadMove(0, i % 2 == 0 ? 2'000 : -2'000), start(0)});
            bus.runFor(130ms);
        }
        bus.expectNoViolations();
    }
}

// ---- M-26 ----

TEST(M26_OneMemberRefusedItsLoad, StartsNobody) {
    for (const char* fault : {"module 2 cksum on=load_trajectory", "module 2 silent on=load_trajectory",
                              "module 2 drop cmd on=load_trajectory"}) {
        SCOPED_TRACE(fault);
        FaultyBus bus(servos(3), kFast);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault(fault);
        const auto outcome = bus.perform(
            {loadMove(0, 1'000), loadMove(1, 1'000), loadMove(2, 1'000), start(0), start(1), start(2)});
        EXPECT_TRUE(outcome == Outcome::Refused || outcome == Outcome::NoAnswer);
        bus.runFor(1s);
        for (std::uint8_t i = 0; i < 3; ++i) {
            EXPECT_EQ(bus.sentTo(i, CommandCode::StartMotion), 0U);
            EXPECT_EQ(bus.servo(i).commandVelocity, 0.0);
        }
    }
}

}  // namespace

}  // namespace nmc::test

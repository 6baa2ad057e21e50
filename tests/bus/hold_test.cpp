// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/holdtask.h"
#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr const char* kSmoothStop = "AA 01 17 09 21";

class Hold : public ::testing::Test {
protected:
    void enableFirst() {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
        bus.runFor(100ms);
        from = bus.sent.size();
    }
    /// Sends `hold` every 100 ms, as a held button does.
    void holdFor(Duration time, const HoldToMove& hold) {
        for (const TimePoint end = bus.now + time; bus.now < end; bus.runFor(100ms))
            bus.engine.hold(hold, bus.now);
    }

    VirtualBus bus{servos(2)};
    std::size_t from = 0;
};

TEST_F(Hold, MovesUntilReleased) {
    enableFirst();
    holdFor(1s, forward(0));
    // One count a tick, as soon as it is at speed.
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-3);
    EXPECT_EQ(bus.sends("AA 01 94 B6 00 00 01 00", from), 1U) << "the same velocity is not sent again";
    bus.engine.release(bus.now);
    bus.runFor(500ms);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 1U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_TRUE(bus.servo(0).servoOn);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
    EXPECT_GT(bus.servo(0).position, 1500);
    bus.expectNoViolations();
}

/// A stop that was requested earlier is sent first: after the start, it would end a motion that is held.
TEST_F(Hold, BeginsBehindAStopThatWasAskedForBefore) {
    enableFirst();
    servo::StopMotor stop;
    stop.amplifierEnable = true;
    stop.manner = servo::StopManner::Smoothly;
    bus.engine.submit({OperationId{7}, {{ModuleIndex(0), ServoCommand(stop)}}}, bus.now);
    holdFor(1s, forward(0));
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-3);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 1U);
    bus.expectNoViolations();
}

TEST_F(Hold, EndsByItselfWhenTheEvidenceStopsComing) {
    enableFirst();
    const HoldToMove press = forward(0);
    bus.engine.hold(press, bus.now);
    const TimePoint last = bus.now;
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<HoldExpired>() == 1; }, 1s));
    EXPECT_EQ(bus.now - last, Duration(250ms));
    EXPECT_EQ(bus.last<HoldExpired>()->module, ModuleIndex(0));
    EXPECT_EQ(bus.last<HoldExpired>()->reason, HoldExpired::Reason::Expired);
    EXPECT_EQ(bus.last<HoldExpired>()->press, press.press);
    bus.runFor(300ms);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 1U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
}

TEST_F(Hold, ChangesTheVelocityOnTheFly) {
    enableFirst();
    holdFor(500ms, forward(0));
    holdFor(500ms, forward(0, 32'768));
    EXPECT_EQ(bus.sends("AA 01 94 B6", from), 2U);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 0.5, 1e-3);
    bus.expectNoViolations();
}

/// At two counts a tick, which are 3906 counts/s, the motor takes 200 counts to come to rest (v^2 / 2a; a is
/// 655/65536 counts/tick^2), and moves 391 counts in the 0.1 s that the stop may need.
TEST_F(Hold, ChangesTheVelocityOnTheWayToATravelLimitToo) {
    enableFirst();
    bus.engine.setTravelLimits({{-8'000, 8'000}});
    HoldToMove hold = forward(0);
    hold.goal = 8'000;
    holdFor(500ms, hold);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-3);
    hold.velocity = CountsPerTick(2 * kOnePerTick);
    holdFor(500ms, hold);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 2.0, 1e-3);
    holdFor(4s, hold);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 1U);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_LE(bus.servo(0).position, 8'000);
    EXPECT_GT(bus.servo(0).position, 8'000 - 391 - 100);

    // Another press takes it to the limit itself.
    HoldToMove again = forward(0);
    again.goal = 8'000;
    holdFor(1s, again);
    EXPECT_NEAR(bus.servo(0).position, 8'000, 2);
    bus.expectNoViolations();
}

/// With position, velocity and acceleration, the load is AA 01 D4 17; a start is AA 01 05 06 (DS-V 5.2).
/// Only the way back finds out that a silent module has restarted, so its stop must leave time for that.
TEST_F(Hold, LeavesTheLineToTheOthersWhenItsModuleRestarts) {
    enableFirst();
    holdFor(1s, forward(0));
    bus.chain.powerCycle(ModuleIndex(0), bus.now);
    bus.engine.release(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }, 10s));
    const std::size_t polled = bus.samplesOf(1);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(1), polled + 10);
}

TEST_F(Hold, LeavesNoLoadBehindWhenItIsReleasedBeforeItsStart) {
    enableFirst();
    HoldToMove hold = forward(0);
    hold.goal = 8'000;
    bus.engine.hold(hold, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 01 D4 17", from) == 1; }, 1s));
    bus.engine.release(bus.now);
    bus.runFor(500ms);
    EXPECT_EQ(bus.sends("AA 01 05", from), 0U);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 1U);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden) << "nothing waits for a start";
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).position, 0, 2);
    bus.expectNoViolations();
}

/// Ten counts a tick are 19531 counts/s: a stop that is a report late would take 3906 counts and its ramp.
TEST_F(Hold, KeepsItsVelocityWhereARunCouldNotBeStoppedBeforeTheLimit) {
    enableFirst();
    bus.engine.setTravelLimits({{-3'000, 3'000}});
    HoldToMove hold = forward(0);
    hold.goal = 3'000;
    holdFor(500ms, hold);
    hold.velocity = CountsPerTick(10 * kOnePerTick);
    holdFor(500ms, hold);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-3);
    holdFor(1s, hold);
    EXPECT_NEAR(bus.servo(0).position, 3'000, 2);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 0U);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
    bus.expectNoViolations();
}

TEST_F(Hold, NeverSwitchesAServoOn) {
    ASSERT_TRUE(bus.connect());
    holdFor(500ms, forward(0));
    EXPECT_EQ(bus.sends("AA 01 94"), 0U);
    EXPECT_EQ(bus.sends("AA 01 17"), 0U);
    EXPECT_FALSE(bus.servo(0).servoOn);
    ASSERT_EQ(bus.count<HoldExpired>(), 1U) << "only once: the held button moves nothing";
    EXPECT_EQ(bus.last<HoldExpired>()->reason, HoldExpired::Reason::NotPossible);
    EXPECT_FALSE(bus.last<HoldExpired>()->started);
}

TEST_F(Hold, NeverSwitchesATrippedServoOn) {
    enableFirst();
    const HoldToMove press = forward(0);
    holdFor(300ms, press);
    bus.chain.set(ModuleIndex(0), sim::Input::Power, 0.0, bus.now);
    holdFor(200ms, press);
    bus.chain.set(ModuleIndex(0), sim::Input::Power, 1.0, bus.now);
    holdFor(200ms, forward(0));
    ASSERT_FALSE(bus.servo(0).servoOn);
    holdFor(300ms, forward(0, 20'000));
    bus.engine.release(bus.now);
    bus.runFor(300ms);
    EXPECT_FALSE(bus.servo(0).servoOn);
    EXPECT_EQ(bus.sends("AA 01 94", from), 1U);
    EXPECT_EQ(bus.sends("AA 01 17", from), 0U);
}

TEST_F(Hold, IsSentOnceTheServoIsKnownToBeOn) {
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    holdFor(300ms, forward(0));  // no poll in between: the engine queries it first
    EXPECT_EQ(bus.sends("AA 01 94"), 1U);
}

TEST_F(Hold, StopsAbruptlyWithoutAnAcceleration) {
    enableFirst();
    HoldToMove hold = forward(0);
    hold.acceleration = CountsPerTickSquared(0);
    holdFor(200ms, hold);
    bus.engine.release(bus.now);
    bus.runFor(100ms);
    EXPECT_EQ(bus.sends("AA 01 17 05 1D", from), 1U);
}

TEST_F(Hold, OfAnotherModuleStopsTheFirst) {
    enableFirst();
    ASSERT_EQ(bus.perform({gains(1), enable(1)}), Outcome::Done);
    holdFor(200ms, forward(0));
    holdFor(300ms, forward(1));
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_NEAR(bus.servo(1).commandVelocity, 1.0, 1e-3);
    bus.engine.release(bus.now);
    bus.runFor(300ms);
    EXPECT_EQ(bus.servo(1).commandVelocity, 0);
}

TEST_F(Hold, StopsAlthoughAnswersGetLost) {
    enableFirst();
    holdFor(300ms, forward(0));
    int lost = 0;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() == 5 && command[2] == 0x17 && lost++ < 3)
            command.clear();
    };
    bus.engine.release(bus.now);
    bus.runFor(1s);
    EXPECT_EQ(lost, 4);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
}

TEST_F(Hold, StopsWhenItsStartIsNotAnswered) {
    enableFirst();
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x94; };
    bus.engine.hold(forward(0), bus.now);
    bus.runFor(200ms);
    EXPECT_EQ(bus.sends("AA 01 94", from), 1U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_EQ(bus.count<HoldExpired>(), 1U);
}

TEST_F(Hold, SaysThatItsStartWasNotAnsweredAlthoughItIsStillHeld) {
    enableFirst();
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x94; };
    const HoldToMove press = forward(0);
    holdFor(500ms, press);
    ASSERT_EQ(bus.count<HoldExpired>(), 1U);
    EXPECT_EQ(bus.last<HoldExpired>()->reason, HoldExpired::Reason::NoAnswer);
    EXPECT_EQ(bus.last<HoldExpired>()->press, press.press);
    EXPECT_TRUE(bus.last<HoldExpired>()->started) << "it may have been: its module was sent a stop";
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
}

TEST_F(Hold, SaysThatNothingWasStartedWhenItsStartIsRefusedThreeTimes) {
    enableFirst();
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 5 && command[2] == 0x94)
            command.back() ^= 0x40U;  // the module flags a communication error
    };
    holdFor(500ms, forward(0));
    EXPECT_EQ(bus.sends("AA 01 94", from), 3U);
    ASSERT_EQ(bus.count<HoldExpired>(), 1U);
    EXPECT_EQ(bus.last<HoldExpired>()->reason, HoldExpired::Reason::NoAnswer);
    EXPECT_FALSE(bus.last<HoldExpired>()->started);
    EXPECT_EQ(bus.servo(0).position, 0);
}

TEST_F(Hold, DoesNotWaitForAQuarantineToStop) {
    enableFirst();
    holdFor(300ms, forward(0));
    const auto before = bus.engine.statistics().timeouts;
    bus.losesReply = [](ByteSpan) { return true; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before; }, 1s));
    bus.losesReply = {};
    const TimePoint released = bus.now;
    bus.engine.release(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends(kSmoothStop, from) > 0; }, 1s));
    EXPECT_LT(bus.now - released, 15ms);
}

TEST_F(Hold, EndsWhenTheLinkIsLost) {
    enableFirst();
    HoldToMove press = forward(0);
    holdFor(300ms, press);
    ASSERT_NE(bus.servo(0).commandVelocity, 0);
    bus.losesReply = [](ByteSpan) { return true; };
    for (int i = 0; i < 100 && bus.count<LinkLost>() == 0; ++i)
        holdFor(100ms, press);
    ASSERT_EQ(bus.count<LinkLost>(), 1U);
    bus.losesReply = {};
    holdFor(10s, press);
    press.velocity = CountsPerTick(2 * kOnePerTick);
    holdFor(500ms, press);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0) << "only another press moves it";
    holdFor(500ms, forward(0));
    EXPECT_NE(bus.servo(0).commandVelocity, 0);
}

TEST_F(Hold, EndsWithAStopOfAllMotors) {
    enableFirst();
    holdFor(300ms, forward(0));
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(500ms);
    EXPECT_EQ(bus.sends("AA 01 94", from), 1U);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 0U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
}

/// Otherwise, another velocity from a button or stick that is still held would start the motor again.
TEST_F(Hold, EndsWithAStopOfItsMotor) {
    enableFirst();
    HoldToMove press = forward(0);
    holdFor(300ms, press);
    bus.submit({toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})});
    press.velocity = CountsPerTick(kOnePerTick / 2);
    holdFor(500ms, press);
    EXPECT_EQ(bus.sends("AA 01 94 B6", from), 1U);
    EXPECT_EQ(bus.sends(kSmoothStop, from), 1U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_EQ(bus.count<HoldExpired>(), 0U);
}

// ---- a hold that has ended does not begin again until the button has been released ----

TEST_F(Hold, LateEvidenceOfAPressThatExpiredMovesNothing) {
    enableFirst();
    const HoldToMove press = forward(0);
    bus.engine.hold(press, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<HoldExpired>() == 1; }, 1s));
    bus.runFor(300ms);
    const std::int32_t position = bus.servo(0).position;
    holdFor(1s, press);
    EXPECT_EQ(bus.sends("AA 01 94", from), 1U);
    EXPECT_NEAR(bus.servo(0).position, position, 2);
    EXPECT_EQ(bus.count<HoldExpired>(), 1U);
    holdFor(500ms, forward(0));
    EXPECT_EQ(bus.sends("AA 01 94", from), 2U) << "the next press moves again";
}

TEST_F(Hold, LateEvidenceAfterAReleaseAStopOrAMissingAnswerMovesNothing) {
    enableFirst();
    const auto expectOver = [this](const HoldToMove& press) {
        bus.runFor(500ms);
        const std::size_t starts = bus.sends("AA 01 94", from);
        holdFor(500ms, press);
        EXPECT_EQ(bus.sends("AA 01 94", from), starts);
        EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    };
    const HoldToMove released = forward(0);
    holdFor(300ms, released);
    bus.engine.release(bus.now);
    expectOver(released);
    const HoldToMove stopped = forward(0);
    holdFor(300ms, stopped);
    ASSERT_TRUE(bus.stopAll());
    expectOver(stopped);
    const HoldToMove unanswered = forward(0);
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x94; };
    holdFor(200ms, unanswered);
    bus.losesReply = {};
    expectOver(unanswered);
    const HoldToMove first = forward(0);
    holdFor(300ms, first);
    ASSERT_EQ(bus.perform({gains(1), enable(1)}), Outcome::Done);
    holdFor(300ms, forward(1));
    bus.engine.release(bus.now);
    expectOver(first);
}

TEST_F(Hold, APressThatCameDuringAStopIsOverBeforeItBegan) {
    enableFirst();
    const HoldToMove press = forward(0);
    bus.engine.stopAll(bus.now);
    bus.engine.hold(press, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 1s));
    holdFor(500ms, press);
    EXPECT_EQ(bus.sends("AA 01 94", from), 0U);
}

TEST_F(Hold, ItsEndDoesNotSwitchOnWhatWasSwitchedOffMeanwhile) {
    enableFirst();
    bus.engine.hold(forward(0), bus.now);
    bus.runFor(100ms);
    ASSERT_GT(bus.servo(0).velocity, 0.5);
    // "Motor off" is on its way when the button is released.
    bus.engine.submit({OperationId(9), {motorOff(0)}}, bus.now);
    while (bus.sends("AA 01 17 02", from) == 0)
        bus.runFor(500us);
    bus.engine.release(bus.now);
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(0).servoOn);
}

TEST(HoldTask, KnowsAPressByItsNumber) {
    const TimePoint t{};
    Chain chain({{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}}, 19'200, false);
    const Line line(4ms, 10ms);
    std::vector<Event> events;
    EngineConfig config;
    config.holdTimeout = 250ms;
    HoldTask task({chain, line, events}, config);
    HoldToMove press = forward(0);
    task.hold(press, t);
    task.expire(t + 249ms);
    EXPECT_TRUE(task.active());
    task.expire(t + 250ms);
    EXPECT_FALSE(task.active());
    EXPECT_FALSE(chain.at(ModuleIndex(0)).owed) << "nothing was sent";
    EXPECT_TRUE(events.empty());
    task.hold(press, t + 251ms);
    EXPECT_FALSE(task.active());
    ++press.press;
    task.refuse(press);
    task.hold(press, t + 252ms);
    EXPECT_FALSE(task.active());
    ++press.press;
    task.hold(press, t + 253ms);
    ASSERT_TRUE(task.active());
    task.onChange({Change::Kind::Stopped, {ModuleIndex(0)}});
    task.hold(press, t + 254ms);
    EXPECT_FALSE(task.active());
    EXPECT_FALSE(task.expiry());
}

/// Two hands, or a hand and a gamepad: the motor must not follow both in turn.
TEST(HoldTask, FollowsTheLastOfTwoPresses) {
    const TimePoint t{};
    Chain chain({{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}}, 19'200, false);
    const Line line(4ms, 10ms);
    std::vector<Event> events;
    EngineConfig config;
    config.holdTimeout = 250ms;
    HoldTask task({chain, line, events}, config);
    const HoldToMove first = forward(0);
    HoldToMove second = first;
    ++second.press;
    second.reverse = true;
    task.hold(first, t);
    task.hold(second, t + 100ms);
    task.hold(first, t + 200ms);
    task.expire(t + 349ms);
    EXPECT_TRUE(task.active());
    task.expire(t + 350ms);
    EXPECT_FALSE(task.active());
}

/// Its button has not been released, and must not move a second module.
TEST(HoldTask, EndsAPressThatMovesToAnotherModule) {
    Chain chain({{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}},
                 {ModuleIndex(1), BusAddress(2), {ModuleType::Servo, 4}}},
                19'200, false);
    const Line line(4ms, 10ms);
    std::vector<Event> events;
    HoldTask task({chain, line, events}, {});
    HoldToMove press = forward(0);
    task.hold(press, {});
    press.module = ModuleIndex(1);
    task.hold(press, {});
    EXPECT_FALSE(task.active());
    ++press.press;
    task.hold(press, {});
    EXPECT_TRUE(task.holds(ModuleIndex(1)));
}

TEST_F(Hold, DoesNotStartAgainAfterARefusalOnceReleased) {
    enableFirst();
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 5 && command[2] == 0x94)
            command.back() ^= 0x40U;  // the module flags a communication error
    };
    bus.engine.hold(forward(0), bus.now);
    bus.runFor(3ms);
    bus.engine.release(bus.now);
    bus.runFor(300ms);
    EXPECT_LE(bus.sends("AA 01 94", from), 1U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The engine keeps travel limits, whatever else is busy.
#include <gtest/gtest.h>

#include "tests/bus/groups.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

class TravelLimit : public testing::Test {
protected:
    void enableFirst() {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
        bus.runFor(100ms);
    }
    static constexpr std::uint32_t kSlow = 131;      ///< 131/65536 counts/tick^2 are 7625 counts/s^2
    static constexpr std::uint32_t kHasty = 13'107;  ///< 0.2 counts/tick^2: 10 counts to rest
    /// Two counts a tick, which are 3906 counts/s.
    [[nodiscard]] static servo::LoadTrajectory twoPerTick(std::uint32_t acceleration) {
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(2 << 16);
        load.acceleration = CountsPerTickSquared(acceleration);
        load.profile = servo::ProfileMode::Velocity;
        return load;
    }
    [[nodiscard]] static Order run(bool reverse = false, std::uint32_t acceleration = kSlow) {
        servo::LoadTrajectory load = twoPerTick(acceleration);
        load.reverse = reverse;
        load.startNow = true;
        return toServo(0, load);
    }
    /// Waits for Start Motion.
    [[nodiscard]] static Order loaded(std::uint32_t acceleration) {
        return toServo(0, twoPerTick(acceleration));
    }
    /// Expects that a run ends before 20 000 counts, and not farther before it than the way in the 0.1 s that
    /// the stop may need.
    static void expectStopBeforeTheLimit(VirtualBus& chain) {
        chain.engine.setTravelLimits({{std::nullopt, 20'000}});
        chain.runFor(8s);
        EXPECT_EQ(chain.count<StoppedBeforeLimit>(), 1U);
        EXPECT_EQ(chain.servo(0).commandVelocity, 0);
        EXPECT_LE(chain.servo(0).position, 20'000);
        EXPECT_GT(chain.servo(0).position, 20'000 - 391 - 100);
        chain.expectNoViolations();
    }
    VirtualBus bus{servos(2)};
};

/// The motor takes 1001 counts to come to rest (v^2 / 2a), and moves 391 counts in the 0.1 s that the stop
/// may need.
TEST_F(TravelLimit, ARunThatWasBegunBeforeItsLimitsEndsBeforeThem) {
    for (const bool reverse : {false, true}) {
        SCOPED_TRACE(reverse);
        VirtualBus chain(servos(1));
        ASSERT_TRUE(chain.connect());
        ASSERT_EQ(chain.perform({gains(0), enable(0), run(reverse)}), Outcome::Done);
        chain.runFor(1s);
        const std::size_t from = chain.sent.size();
        chain.engine.setTravelLimits({{-20'000, 20'000}});
        chain.runFor(8s);
        EXPECT_EQ(chain.count<StoppedBeforeLimit>(), 1U);
        EXPECT_EQ(chain.sends("AA 01 17 09 21", from), 1U) << "smoothly, and its servo stays on";
        const double way = std::abs(static_cast<double>(chain.servo(0).position));
        EXPECT_LE(way, 20'000);
        EXPECT_GT(way, 20'000 - 391 - 100);
        EXPECT_EQ(chain.servo(0).commandVelocity, 0);
        EXPECT_TRUE(chain.servo(0).servoOn);
        chain.expectNoViolations();
    }
}

/// DS-V 5.2: what waits for Start Motion is only buffered, so a stop still takes 1001 counts.
TEST_F(TravelLimit, ALoadThatWaitsDoesNotShortenTheWayOfAStop) {
    enableFirst();
    ASSERT_EQ(bus.perform({run(), loaded(kHasty)}), Outcome::Done);
    expectStopBeforeTheLimit(bus);
}

/// From 40 counts/tick the motor would take 400 000 counts to come to rest.
TEST_F(TravelLimit, AFasterLoadThatWaitsDoesNotEndARunEarly) {
    enableFirst();
    servo::LoadTrajectory faster = twoPerTick(kSlow);
    faster.velocity = CountsPerTick(40 << 16);
    ASSERT_EQ(bus.perform({run(), toServo(0, faster)}), Outcome::Done);
    expectStopBeforeTheLimit(bus);
}

TEST_F(TravelLimit, StartMotionMakesTheAccelerationOfItsLoadThatOfAStop) {
    for (const auto& [before, after] : {std::pair(kHasty, kSlow), {kSlow, kHasty}})
        for (const bool toGroup : {false, true}) {
            SCOPED_TRACE(testing::Message() << "to " << after << (toGroup ? ", by the group" : ""));
            GroupBus chain(servos(1));
            ASSERT_TRUE(chain.connect());
            ASSERT_EQ(chain.put(0, kGroup).outcome, Outcome::Done);
            ASSERT_EQ(chain.perform({gains(0), enable(0), run(false, before)}), Outcome::Done);
            chain.runFor(500ms);
            ASSERT_EQ(chain.perform({enable(0)}), Outcome::Done);
            chain.runFor(500ms);
            ASSERT_EQ(chain.perform({loaded(after)}), Outcome::Done);
            const auto started = toGroup ? chain.start(kGroup).outcome : chain.perform({start(0)});
            ASSERT_EQ(started, Outcome::Done);
            expectStopBeforeTheLimit(chain);
        }
}

TEST_F(TravelLimit, TheWayBackIsFree) {
    enableFirst();
    ASSERT_EQ(bus.perform({run()}), Outcome::Done);
    bus.engine.setTravelLimits({{std::nullopt, 5'000}});
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StoppedBeforeLimit>() == 1; }, 5s));
    bus.runFor(1s);
    EXPECT_EQ(bus.perform({run(true)}), Outcome::Done);
    bus.runFor(3s);
    EXPECT_LT(bus.servo(0).position, 0);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 1U);
}

TEST_F(TravelLimit, APwmOutputIsSwitchedOff) {
    enableFirst();
    const servo::StopMotor offWithPower{true, servo::StopManner::MotorOff, {}};
    ASSERT_EQ(bus.perform({toServo(0, offWithPower), loadPwm(0, 60)}), Outcome::Done);
    bus.engine.setTravelLimits({{std::nullopt, 20'000}});
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StoppedBeforeLimit>() == 1; }, 20s));
    EXPECT_LT(bus.servo(0).position, 20'000);
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(0).servoOn);
    EXPECT_EQ(bus.servo(0).pwm, 0);
}

/// The zero of the counter is then at another place, and so are the limits.
TEST_F(TravelLimit, IsNotInForceAfterTheCounterWasSet) {
    enableFirst();
    bus.engine.setTravelLimits({{-1'000, 1'000}});
    ASSERT_EQ(bus.perform({toServo(0, ResetPosition{}), run()}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_GT(bus.servo(0).position, 5'000);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 0U);
    bus.engine.setTravelLimits({{std::nullopt, 15'000}});
    bus.runFor(4s);
    EXPECT_LE(bus.servo(0).position, 15'000);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 1U);
}

TEST_F(TravelLimit, ARunIsWatchedThoughASearchForHomeWasCancelled) {
    enableFirst();
    servo::SetHoming cancel;
    cancel.stopSmoothly = true;
    ASSERT_EQ(bus.perform({run(), toServo(0, cancel)}), Outcome::Done);
    expectStopBeforeTheLimit(bus);
}

/// DS-V 5.2: home is captured once, and only then is the motor stopped. The switch changes after the last
/// status, and before the run begins.
TEST_F(TravelLimit, ARunIsWatchedThatBeganAfterHomeWasFound) {
    enableFirst();
    servo::SetHoming homing;
    homing.onLimit1Change = homing.stopAbruptly = true;
    ASSERT_EQ(bus.perform({toServo(0, homing)}), Outcome::Done);
    bus.runFor(200ms);
    bus.chain.set(ModuleIndex(0), sim::Input::Limit1, 1.0, bus.now);
    ASSERT_EQ(bus.perform({run()}), Outcome::Done);
    expectStopBeforeTheLimit(bus);
}

TEST_F(TravelLimit, LeavesAMoveAloneThatEndsByItself) {
    enableFirst();
    bus.engine.setTravelLimits({{std::nullopt, 5'000}});
    ASSERT_EQ(bus.perform({loadMove(0, 6'000), start(0)}), Outcome::Done) << "the plan allowed it";
    bus.runFor(6s);
    EXPECT_NEAR(bus.servo(0).position, 6'000, 4);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 0U);
}

/// Four motors take 2 / (26 / 65536) = 5041 ticks, 2.6 s, to come to rest. At 19 200 Bd, a query takes about
/// 9 ms, so that with 20 ms between two of the same motor there is always one of them due.
TEST_F(TravelLimit, IsKeptWhileManyOthersSlowDown) {
    constexpr std::uint8_t kOthers = 4;
    constexpr std::uint32_t kVerySlow = 26;
    GroupBus chain(servos(1 + kOthers));
    ASSERT_TRUE(chain.connect());
    for (std::uint8_t i = 1; i <= kOthers; ++i)
        ASSERT_EQ(chain.put(i, kGroup).outcome, Outcome::Done);
    for (std::uint8_t i = 0; i <= kOthers; ++i) {
        servo::LoadTrajectory load = twoPerTick(i == 0 ? kSlow : kVerySlow);
        load.startNow = true;
        ASSERT_EQ(chain.perform({gains(i), enable(i), toServo(i, load)}), Outcome::Done);
    }
    chain.runFor(4s);
    const std::int32_t limit = chain.servo(0).position + 4'000;
    chain.engine.setTravelLimits({{std::nullopt, limit}});
    chain.submitGroup(GroupCommand{kGroup, GroupCommand::Action::StopSmoothly});
    const std::size_t from = chain.samplesOf(0);
    chain.runFor(500ms);
    EXPECT_GT(chain.samplesOf(0), from + 2);
    chain.runFor(4s);
    EXPECT_EQ(chain.count<StoppedBeforeLimit>(), 1U);
    EXPECT_LE(chain.servo(0).position, limit);
    for (std::uint8_t i = 0; i <= kOthers; ++i)
        EXPECT_EQ(chain.servo(i).commandVelocity, 0) << int{i};
    chain.expectNoViolations();
}

/// The stop of all modules does what the limit requires.
TEST_F(TravelLimit, IsSilentWhileEverythingIsBeingStopped) {
    enableFirst();
    ASSERT_EQ(bus.perform({run()}), Outcome::Done);
    bus.runFor(1s);
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 2 && command[2] == 0x17)
            command.clear();  // no stop arrives
    };
    bus.engine.stopAll(bus.now);
    bus.engine.setTravelLimits({{std::nullopt, bus.servo(0).position + 500}});
    bus.runFor(1s);
    EXPECT_GT(bus.servo(0).position, 500);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 0U);
}

/// The limit asks for a smooth stop, by a report that was on its way when the operator asked for more.
TEST_F(TravelLimit, DoesNotKeepAMotorOnThatTheOperatorSwitchesOff) {
    for (const auto after : {0us, 4'000us, 8'000us, 12'000us}) {
        SCOPED_TRACE(after.count());
        GroupBus chain(servos(1));
        ASSERT_TRUE(chain.connect());
        ASSERT_EQ(chain.put(0, kGroup).outcome, Outcome::Done);
        ASSERT_EQ(chain.perform({gains(0), enable(0), run()}), Outcome::Done);
        chain.runFor(1s + after);
        chain.engine.setTravelLimits({{std::nullopt, chain.servo(0).position}});
        chain.submitGroup(GroupCommand{kGroup, GroupCommand::Action::MotorOff});
        chain.runFor(1s);
        EXPECT_FALSE(chain.servo(0).servoOn);
    }
}

TEST_F(TravelLimit, LeavesAnotherHostsRunAlone) {
    enableFirst();
    ASSERT_EQ(bus.perform({run()}), Outcome::Done);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    bus.engine.setTravelLimits({{std::nullopt, 5'000}});
    bus.runFor(3s);
    EXPECT_GT(bus.servo(0).position, 6'000);
    EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 0U);
}

/// A PIC-STEP that makes 25 steps/s for each unit of speed. From 1000 steps/s, it takes some 1220 steps to
/// come to rest with an acceleration time of 255, and 10 with one of 2.
class TravelLimitOfAStepper : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({told(stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 10,
                                                           200, 50, 0}),
                               told(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}),
                  Outcome::Done);
    }
    [[nodiscard]] static Order told(const StepperCommand& command) { return {ModuleIndex(0), command}; }
    [[nodiscard]] static stepper::LoadTrajectory profile(std::uint8_t accelerationTime, bool startNow) {
        stepper::LoadTrajectory load;
        load.speed = std::uint8_t{40};
        load.accelerationTime = accelerationTime;
        load.startNow = startNow;
        return load;
    }
    void expectStopBeforeTheLimit() {
        bus.engine.setTravelLimits({{std::nullopt, 5'000}});
        bus.runFor(10s);
        const sim::StepperSnapshot motor = *bus.chain.snapshot(ModuleIndex(0), bus.now).stepper;
        EXPECT_EQ(bus.count<StoppedBeforeLimit>(), 1U);
        EXPECT_FALSE(motor.moving);
        EXPECT_LE(motor.position, 5'000);
        EXPECT_GT(motor.position, 4'000);
        bus.expectNoViolations();
    }
    VirtualBus bus{std::vector<ModuleIdentity>(1, ModuleIdentity{ModuleType::Stepper, 1})};
};

/// DS-S 5.1: a start takes what was loaded last, even by a load that was never started itself.
TEST_F(TravelLimitOfAStepper, ARunTakesTheAccelerationTimeOfALoadThatWasReplaced) {
    ASSERT_EQ(
        bus.perform({told(profile(2, true)), told(stepper::StopMotor{true, stepper::StopManner::Abruptly})}),
        Outcome::Done);
    stepper::LoadTrajectory timed;  // 1000 steps/s
    timed.timer = stepper::TimerCount{64'913, 40};
    timed.startNow = true;
    ASSERT_EQ(bus.perform({told(profile(255, false)), told(timed)}), Outcome::Done);
    expectStopBeforeTheLimit();
}

/// It may have been started, or the run before may go on.
TEST_F(TravelLimitOfAStepper, ARunWhoseAnswerWasLostHasTheLongerWayOfAStop) {
    ASSERT_EQ(bus.perform({told(profile(2, true))}), Outcome::Done);
    bus.runFor(200ms);
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x34; };
    ASSERT_EQ(bus.perform({told(profile(255, true))}), Outcome::NoAnswer);
    bus.losesReply = nullptr;
    expectStopBeforeTheLimit();
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

[[nodiscard]] bool has(ByteSpan packet, const std::string& prefix) {
    return toHex(packet).rfind(prefix, 0) == 0;
}

TEST(Operations, MoveAServoToItsGoal) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(1), enable(1)}), Outcome::Done);
    ASSERT_EQ(bus.perform({loadMove(1, 1000), start(1)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_NEAR(bus.servo(1).position, 1000, 3);
    EXPECT_EQ(bus.servo(0).position, 0);
    EXPECT_NEAR(bus.lastSample(1)->report.position.value(), 1000, 3);
    bus.expectNoViolations();
}

TEST(Operations, RunInTheirOrder) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    const auto a = bus.submit({toServo(0, servo::ClearStickyBits{}), toServo(1, servo::ClearStickyBits{})});
    const auto b = bus.submit({toServo(0, SaveAsHome{})});
    bus.runFor(200ms);
    const auto finished = bus.all<OperationFinished>();
    ASSERT_EQ(finished.size(), 2U);
    EXPECT_EQ(finished[0].id, a);
    EXPECT_EQ(finished[0].module, ModuleIndex(1));
    EXPECT_EQ(finished[0].commandByte, 0x0B);
    EXPECT_EQ(finished[1].id, b);
    EXPECT_EQ(finished[1].commandByte, 0x0C);
}

TEST(Operations, GoBeforePolls) {
    ScriptedBus bus(3);
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    bus.engine.submit({OperationId(1), {toServo(2, SaveAsHome{}), toServo(2, servo::ClearStickyBits{})}},
                      bus.now);
    const std::size_t from = bus.sent.size();
    bus.runFor(40ms);
    ASSERT_GE(bus.sent.size(), from + 2);
    EXPECT_EQ(bus.sent[from].hex, "AA 03 0C 0F");
    EXPECT_EQ(bus.sent[from + 1].hex, "AA 03 0B 0E");
}

/// The golden frames of protocol.md section 4, as sent by the engine.
TEST(Operations, PutTheGoldenFramesOnTheWire) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.aux = 0x04;  // servo on
    bus.runFor(200ms);
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(100'000);
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = load.startNow = true;
    load.servo = true;
    bus.engine.submit(
        {OperationId(1),
         {toServo(0, load), toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}}),
          toServo(0, servo::StopMotor{true, servo::StopManner::Here, Counts(100)}), motorOff(0)}},
        bus.now);
    const std::size_t from = bus.sent.size();
    bus.runFor(200ms);
    EXPECT_EQ(bus.sends("AA 01 54 F2 A0 86 01 00 6E", from), 1U);
    EXPECT_EQ(bus.sends("AA 01 17 09 21", from), 1U);
    EXPECT_EQ(bus.sends("AA 01 57 11 64 00 00 00 CD", from), 1U);
    EXPECT_EQ(bus.sends("AA 01 17 02 1A", from), 1U);
    EXPECT_EQ(bus.all<OperationFinished>().at(0).outcome, Outcome::Done);
}

TEST(Operations, AreReportedWithTheTimeAtWhichTheModuleTookThem) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.engine.submit({OperationId(1), {toServo(0, SaveAsHome{})}}, bus.now);
    bus.runFor(100ms);
    const auto executed = bus.all<CommandExecuted>();
    ASSERT_EQ(executed.size(), 1U);
    TimePoint sent{};
    for (const auto& s : bus.sent)
        if (s.hex == "AA 01 0C 0D")
            sent = s.time;
    // Four bytes of ten bits at 19 200 Bd, then half a tick of 512 us.
    EXPECT_EQ(executed[0].time - sent, Duration(4 * 520'833) + 256us);
}

TEST(Operations, EndAtTheFirstStepThatFails) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.losesReply = [](ByteSpan command) { return has(command, "AA 01 D4"); };
    EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::NoAnswer);
    EXPECT_EQ(bus.sends("AA 01 05"), 0U);
    EXPECT_EQ(bus.sends("AA 01 D4"), 3U);
    bus.runFor(500ms);
    EXPECT_NEAR(bus.servo(0).position, 0, 3);
}

TEST(Operations, RepeatALoadWhoseAnswerIsLost) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bool lost = false;
    bus.losesReply = [&](ByteSpan command) { return has(command, "AA 01 D4") && !std::exchange(lost, true); };
    EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::Done);
    EXPECT_EQ(bus.sends("AA 01 D4"), 2U);
    EXPECT_EQ(bus.sends("AA 01 05"), 1U);
    EXPECT_EQ(bus.engine.statistics().retries, 1U);
}

TEST(Operations, NeverRepeatAStartBlindly) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.losesReply = [](ByteSpan command) { return has(command, "AA 01 05"); };
    EXPECT_EQ(bus.perform({loadMove(0, 20'000), start(0)}), Outcome::Done) << "it moves, so it was started";
    EXPECT_EQ(bus.sends("AA 01 05"), 1U);
    EXPECT_EQ(bus.count<CommandExecuted>(), 4U) << "gains, stop, load, and the start";
}

TEST(Operations, LeaveAStartThatDidNotArriveToTheOperator) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (has(command, "AA 01 05"))
            command.clear();
    };
    EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::NoAnswer);
    EXPECT_EQ(bus.sends("AA 01 05"), 1U);
    EXPECT_EQ(bus.last<OperationFinished>()->commandByte, 0x05);
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).position, 0, 3);
}

/// It goes on at its old velocity, which is no sign of the new one.
TEST(Operations, LeaveAStartInMotionThatDidNotArriveToTheOperator) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(300ms);
    ASSERT_EQ(bus.perform({loadVelocity(0, 2 * kOnePerTick)}), Outcome::Done);
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (has(command, "AA 01 05"))
            command.clear();
    };
    EXPECT_EQ(bus.perform({start(0)}), Outcome::NoAnswer);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
    EXPECT_EQ(bus.sends("AA 01 05"), 1U) << "it is not repeated";
}

/// What a query of the module can determine is not left open (link.md 2.3).
TEST(Operations, LookWhetherAResetWasCarriedOut) {
    for (const bool arrives : {true, false}) {
        SCOPED_TRACE(arrives);
        VirtualBus bus(servos(1));
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 500), start(0)}), Outcome::Done);
        bus.runFor(2s);
        bool lost = false;
        const auto first = [&](ByteSpan c) { return has(c, "AA 01 00") && !std::exchange(lost, true); };
        if (arrives)
            bus.losesReply = first;
        else
            bus.onCommand = [&](std::vector<std::uint8_t>& c) {
                if (first(c))
                    c.clear();
            };
        EXPECT_EQ(bus.perform({toServo(0, ResetPosition{})}), Outcome::Done);
        EXPECT_EQ(bus.sends("AA 01 00 01"), arrives ? 1U : 2U);
        bus.runFor(100ms);
        EXPECT_NEAR(bus.servo(0).position, 0, 3);
    }
}

/// Regardless of what the bits and the code would mean to a motor: 200 has bit 7, which starts a Load
/// Trajectory, and Set Synch Output has the code of Stop Motor, which is sent up to five times.
TEST(Operations, RepeatWhatAPicIoWasToldTwice) {
    const std::vector<std::pair<IoCommand, std::string>> commands{
        {io::SetPwm{100, 0}, "AA 01 24 64"},
        {io::SetPwm{200, 0}, "AA 01 24 C8"},
        {io::SetOutput{0x0001}, "AA 01 26"},
        {io::SetDirection{0x0FFE}, "AA 01 20"},
        {io::SetSynchOutput{0x0001, 0, 0}, "AA 01 47"},
    };
    for (const auto& [command, hex] : commands) {
        SCOPED_TRACE(hex);
        VirtualBus bus({{ModuleType::Io, 1}});
        ASSERT_TRUE(bus.connect());
        bus.losesReply = [h = hex](ByteSpan c) { return has(c, h); };
        EXPECT_EQ(bus.perform({{ModuleIndex(0), command}}), Outcome::NoAnswer);
        EXPECT_EQ(bus.sends(hex), 3U);
    }
}

TEST(Operations, AreNotRepeatedWhenTheyAreNotIdempotent) {
    const std::vector<std::pair<ModuleCommand, std::string>> commands{
        {ServoCommand(servo::SetHoming{}), "AA 01 19"}, {loadVelocity(0, 0, true).command, "AA 01 94"}};
    for (const auto& [command, hex] : commands) {
        SCOPED_TRACE(hex);
        VirtualBus bus(servos(1));
        ASSERT_TRUE(bus.connect());
        bus.losesReply = [h = hex](ByteSpan c) { return has(c, h); };
        EXPECT_EQ(bus.perform({{ModuleIndex(0), command}}), Outcome::NoAnswer);
        EXPECT_EQ(bus.sends(hex), 1U);
        EXPECT_EQ(bus.count<CommandExecuted>(), 0U);
    }
}

TEST(Operations, TryThreeTimesWhenTheModuleRefuses) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.answer = [&](ByteSpan packet) {
        auto reply = bus.likeAServo(packet);
        if (toHex(packet) == "AA 01 0C 0D") {
            reply.pop_back();
            reply[0] |= 0x02U;
            reply = withSum(reply);
        }
        return reply;
    };
    bus.engine.submit({OperationId(7), {toServo(0, SaveAsHome{})}}, bus.now);
    bus.runFor(200ms);
    EXPECT_EQ(bus.sends("AA 01 0C 0D"), 3U);
    const auto refused = bus.all<CommandRefused>();
    ASSERT_EQ(refused.size(), 3U);
    EXPECT_EQ(refused[0].attempt, 1);
    EXPECT_EQ(refused[2].attempt, 3);
    EXPECT_EQ(bus.all<OperationFinished>().at(0).outcome, Outcome::Refused);
    EXPECT_EQ(bus.count<CommandExecuted>(), 0U);
    EXPECT_EQ(bus.engine.statistics().refused, 3U);
    EXPECT_EQ(bus.engine.statistics().retries, 2U);
    EXPECT_EQ(bus.engine.statistics().timeouts, 0U);
}

/// A servo rate divisor of 10 makes a tick ten times as long, so ten times as many counts per tick would be
/// plausible (DS-V 5.2). The module refuses it, so 200 counts a tick stay as implausible as before.
TEST(Operations, ARefusedCommandChangesNothingThatIsHeldPlausible) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    bool fast = false;
    bus.answer = [&](ByteSpan packet) {
        std::vector<std::uint8_t> reply = bus.likeAServo(packet);
        const auto frame = parsePacket(packet);
        constexpr std::size_t kVelocity = 1 + 4 + 1;  // after status, position and A/D
        if (frame && frame->payload.code == CommandCode::SetGain) {
            reply[0] |= 0x02U;
        } else if (fast && reply.size() > kVelocity + 2) {
            reply[kVelocity] = 0x38;  // -200, which is sent for 200
            reply[kVelocity + 1] = 0xFF;
        }
        reply.pop_back();
        return withSum(reply);
    };
    bus.engine.submit(
        {OperationId(7), {toServo(0, servo::SetGain{100, 1'000, 0, 0, 255, 0, 4'000, 10, std::uint8_t{0}})}},
        bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<OperationFinished>() > 0; }));
    ASSERT_GT(bus.engine.statistics().refused, 0U);
    fast = true;
    bus.runFor(50ms);
    EXPECT_GT(bus.engine.statistics().rejections[static_cast<std::size_t>(Rejection::VelocityJump)], 0U);
}

TEST(Operations, SucceedWhenTheSecondAttemptIsAccepted) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    ASSERT_EQ(bus.perform({loadMove(0, 500)}), Outcome::Done);
    bool spoilt = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (has(command, "AA 01 05") && !std::exchange(spoilt, true))
            command.back() ^= 0x40U;
    };
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Done);
    EXPECT_EQ(bus.count<CommandRefused>(), 1U);
    bus.runFor(1500ms);
    EXPECT_NEAR(bus.servo(0).position, 500, 3);
}

TEST(Operations, NeverStartWhatWasNotLoaded) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden);
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 100)}), Outcome::Done);
    // Stop Motor zeroes the velocity parameter.
    ASSERT_EQ(bus.perform({enable(0)}), Outcome::Done);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden);
    EXPECT_EQ(bus.sends("AA 01 05"), 0U);
}

/// Otherwise, the next start of its group would make a move that was reported as not carried out.
TEST(Operations, LeaveNoLoadBehindWhenTheStartIsForbidden) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 1'000), start(0)}), Outcome::Done);
    ASSERT_EQ(bus.perform({loadMove(0, 5'000), start(0)}), Outcome::Forbidden) << "it moves";
    bus.runFor(2s);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden);
    bus.runFor(2s);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 2);
    ASSERT_EQ(bus.perform({loadMove(0, 2'000)}), Outcome::Done);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Done) << "a load by itself waits";
}

TEST(Operations, AreForbiddenWhileATrapezoidalMoveRuns) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 4000), start(0)}), Outcome::Done);
    EXPECT_EQ(bus.perform({loadMove(0, 0), start(0)}), Outcome::Forbidden);
    EXPECT_EQ(bus.perform({toServo(0, ResetPosition{})}), Outcome::Forbidden);
    EXPECT_EQ(bus.sends("AA 01 05"), 1U) << "Start Motion";
    EXPECT_EQ(bus.sends("AA 01 00"), 0U);
    // Velocity mode may be entered from a trapezoidal move.
    EXPECT_EQ(bus.perform({loadVelocity(0, 32'768, true)}), Outcome::Done);
    EXPECT_EQ(bus.perform({loadMove(0, 0), start(0)}), Outcome::Forbidden);
    bus.runFor(3s);
    EXPECT_EQ(bus.perform({loadMove(0, 0), start(0)}), Outcome::Forbidden)
        << "still at speed, although move_done is set";
    ASSERT_EQ(bus.perform({toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})}),
              Outcome::Done);
    bus.runFor(500ms);
    EXPECT_EQ(bus.perform({loadMove(0, 0), start(0)}), Outcome::Done);
    bus.expectNoViolations();
}

TEST(Operations, MayStartAgainAsSoonAsTheMoveHasEnded) {
    VirtualBus bus(servos(8));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 200), start(0)}), Outcome::Done);
    ASSERT_TRUE(bus.runUntil([&] { return bus.servo(0).commandPosition >= 200; }, 5s));
    // The last poll may still report motion: the gate queries it once more.
    EXPECT_EQ(bus.perform({loadMove(0, 0), start(0)}), Outcome::Done);
    bus.expectNoViolations();
}

TEST(Operations, OnModulesWithoutADataSheetAreForbidden) {
    ScriptedBus bus(1);
    bus.type = 7;
    ASSERT_TRUE(bus.connect());
    for (const ServoCommand& command :
         {ServoCommand(SaveAsHome{}), ServoCommand(servo::IoControl{}), ServoCommand(servo::SetGain{})}) {
        bus.events.clear();
        bus.engine.submit({OperationId(1), {toServo(0, command)}}, bus.now);
        bus.runFor(50ms);
        EXPECT_EQ(bus.all<OperationFinished>().at(0).outcome, Outcome::Forbidden);
    }
    bus.events.clear();
    bus.engine.submit({OperationId(2), {motorOff(0)}}, bus.now);
    bus.runFor(50ms);
    EXPECT_EQ(bus.all<OperationFinished>().at(0).outcome, Outcome::Done);
    EXPECT_EQ(bus.sends("AA 01 12 0B 1E"), 0U);
    EXPECT_GT(bus.sends("AA 01 13 20 34"), 3U);
}

TEST(Operations, ForTheEngineAloneAreForbidden) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    for (const ServoCommand& command : {ServoCommand(HardReset{}), ServoCommand(SetBaud{10}),
                                        ServoCommand(SetAddress{BusAddress(9), BusAddress(0xFF), false})})
        EXPECT_EQ(bus.perform({toServo(0, command)}), Outcome::Forbidden);
    EXPECT_EQ(bus.perform({toServo(5, Nop{})}), Outcome::Forbidden) << "there is no such module";
}

TEST(Operations, ChangeTheLengthOfRepliesWithDefineStatus) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({toServo(0, DefineStatus{StatusItems(0x1F)})}), Outcome::Done);
    bus.runFor(500ms);
    EXPECT_EQ(bus.engine.statistics().timeouts, 0U);
    EXPECT_TRUE(bus.lastSample(0)->report.velocity.has_value());
}

TEST(Operations, AreBounded) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    for (std::uint32_t i = 0; i < 300; ++i)
        bus.engine.submit({OperationId(i), {toServo(0, Nop{})}}, bus.now);
    bus.runFor(3s);
    const auto finished = bus.all<OperationFinished>();
    ASSERT_EQ(finished.size(), 300U);
    EXPECT_EQ(std::count_if(finished.begin(), finished.end(),
                            [](const auto& f) { return f.outcome == Outcome::QueueFull; }),
              300 - 256);
    EXPECT_EQ(bus.outcomeOf(OperationId(299)), Outcome::QueueFull);
}

// ---- a stop of one motor ----

/// Two servos that are on, of which the first runs.
class StopOfOne : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1), loadVelocity(0, kOnePerTick, true)}),
                  Outcome::Done);
        bus.runFor(300ms);
        from = bus.sent.size();
    }
    OperationId stop() {
        return bus.submit({toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})});
    }
    [[nodiscard]] bool isSent() {
        return bus.runUntil([&] { return bus.sends("AA 01 17 09 21", from) > 0; }, 1s);
    }
    void expectStopped(OperationId id) {
        EXPECT_EQ(bus.outcomeOf(id), Outcome::Done);
        bus.runFor(1s);
        EXPECT_EQ(bus.count<OwedStopConfirmed>(), 1U);
        EXPECT_EQ(bus.sends("AA 01 17", from), 1U);
        EXPECT_EQ(bus.servo(0).commandVelocity, 0);
        EXPECT_TRUE(bus.servo(0).servoOn);
    }

    VirtualBus bus{servos(2)};
    std::size_t from = 0;
};

TEST_F(StopOfOne, GoesPastTheOperationsThatWait) {
    for (int i = 0; i < 20; ++i)
        bus.submit({gains(1)});
    const OperationId own = bus.submit({loadVelocity(0, 2 * kOnePerTick, true)});
    const OperationId id = stop();
    EXPECT_EQ(bus.outcomeOf(own), Outcome::Cancelled);
    ASSERT_TRUE(isSent());
    EXPECT_LE(bus.sends("AA 02", from), 1U) << "only what was on the line already";
    expectStopped(id);
    EXPECT_EQ(bus.sends("AA 01 94", from), 0U);
}

/// The nulls take 8.3 ms at 19 200 Bd, and the quarantine 100 ms.
TEST_F(StopOfOne, DoesNotWaitForAQuarantine) {
    const auto before = bus.engine.statistics().timeouts;
    bus.losesReply = [](ByteSpan) { return true; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before; }, 1s));
    bus.losesReply = {};
    const TimePoint asked = bus.now;
    const OperationId id = stop();
    ASSERT_TRUE(isSent());
    EXPECT_LT(bus.now - asked, 15ms);
    expectStopped(id);
}

TEST_F(StopOfOne, DoesNotWaitForTheSearchForARestartedModule) {
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 00 13", from) > 0; }, 5s));
    const OperationId id = stop();
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Done);
    ASSERT_TRUE(isSent());
    expectStopped(id);
}

TEST_F(StopOfOne, DoesNotWaitForAnotherModuleToBeReset) {
    ASSERT_EQ(bus.perform({toServo(0, servo::StopMotor{true, servo::StopManner::Abruptly, {}})}),
              Outcome::Done);
    bus.runFor(500ms);
    from = bus.sent.size();
    bus.engine.resetModule(ModuleIndex(1), bus.now);
    const OperationId id = stop();
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Done);
    EXPECT_TRUE(isSent());
    EXPECT_EQ(bus.sends("AA 02 0F", from), 0U);
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<Readdressed>() == 1; }, 5s));
}

TEST_F(StopOfOne, IsRepeatedUntilItIsAnswered) {
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 1 && command[1] == 1)
            command.clear();
    };
    const OperationId id = stop();
    ASSERT_TRUE(bus.runUntil([&] { return bus.outcomeOf(id).has_value(); }, 5s));
    EXPECT_EQ(bus.outcomeOf(id), Outcome::NoAnswer);
    EXPECT_NE(bus.servo(0).commandVelocity, 0);
    bus.onCommand = {};
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 1; }, 10s));
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_TRUE(bus.servo(0).servoOn);
}

/// What switches a servo on is a stop as well (DS-V 5.2), and nobody may be near the motor by then.
TEST_F(StopOfOne, IsNotRepeatedIfItWasToSwitchTheServoOn) {
    ASSERT_EQ(bus.perform({motorOff(1)}), Outcome::Done);
    bus.runFor(200ms);
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 1 && command[1] == 2)
            command.clear();
    };
    const OperationId id = bus.submit({enable(1)});
    ASSERT_TRUE(bus.runUntil([&] { return bus.outcomeOf(id).has_value(); }, 5s));
    bus.onCommand = {};
    bus.runFor(5s);
    EXPECT_FALSE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.count<OwedStopConfirmed>(), 0U);
}

TEST_F(StopOfOne, IsNotLostIfTheChainIsSearchedForMeanwhile) {
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 1 && command[1] == 1)
            command.clear();
    };
    const OperationId id = stop();
    bus.runFor(60ms);
    ASSERT_FALSE(bus.outcomeOf(id)) << "it is still being retried";
    bus.engine.connect(bus.now);
    bus.onCommand = {};
    bus.runFor(1ms);
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Cancelled);
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 1; }, 10s));
    EXPECT_EQ(bus.servo(0).commandVelocity, 0);
}

/// The first operation is cancelled by what its own answer shows; that answer is not the second one's.
TEST(Operations, AreNotEndedByTheAnswerToAnotherThatWasCancelled) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(300ms);
    const OperationId first = bus.submit({toServo(0, servo::ClearStickyBits{})});
    const OperationId second = bus.submit({toServo(1, SaveAsHome{})});
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 01 0B") == 1; }, 1s));
    bus.engine.setTravelLimits({{std::nullopt, 0}});  // it is beyond that already
    bus.runFor(500ms);
    ASSERT_EQ(bus.count<StoppedBeforeLimit>(), 1U);
    EXPECT_EQ(bus.outcomeOf(first), Outcome::Cancelled);
    EXPECT_EQ(bus.outcomeOf(second), Outcome::Done);
    EXPECT_EQ(bus.sends("AA 02 0C"), 1U);
}

TEST(Operations, WithoutAConnectionAreCancelled) {
    VirtualBus bus(servos(1));
    EXPECT_EQ(bus.perform({toServo(0, Nop{})}), Outcome::Cancelled);
}

TEST(Operations, AreCancelledByANewConnection) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    const auto id = bus.submit({toServo(0, Nop{}), toServo(0, Nop{})});
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Cancelled);
}

}  // namespace

}  // namespace nmc::test

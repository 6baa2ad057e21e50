// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/commandlane.h"
#include "bus/stoplane.h"
#include "tests/bus/groups.h"
#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

[[nodiscard]] std::vector<std::uint8_t> numbers(const std::vector<ModuleIndex>& modules) {
    std::vector<std::uint8_t> n;
    for (const ModuleIndex m : modules)
        n.push_back(m.value());
    return n;
}

[[nodiscard]] bool has(const std::string& hex, const std::string& prefix) {
    return hex.rfind(prefix, 0) == 0;
}

TEST(StopAll, StopsWhatMovesAndKeepsItHolding) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(1), enable(1), loadVelocity(1, 65'536, true)}), Outcome::Done);
    bus.runFor(500ms);
    ASSERT_GT(bus.servo(1).velocity, 0.5);
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0, 1, 2));
    EXPECT_THAT(stopped->unreached, IsEmpty());
    EXPECT_TRUE(bus.servo(1).servoOn);
    EXPECT_NEAR(bus.servo(1).velocity, 0, 0.1);
    EXPECT_LT(stopped->took, 500ms);
}

TEST(StopAll, KeepsAServoThatIsOffOff) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    const std::size_t from = bus.sent.size();
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->wereOff), ElementsAre(1));
    EXPECT_TRUE(bus.servo(0).servoOn);
    EXPECT_FALSE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.sends("AA 02 17", from), 0U);
    EXPECT_EQ(bus.sends("AA FF", from), 0U) << "not all of them may receive the same packet";
}

/// The first stops do not arrive, and the user does not wait for the end of the stop of all modules.
TEST(StopAll, LetsAMotorBeSwitchedOffMeanwhile) {
    for (const bool group : {false, true}) {
        GroupBus bus(servos(2));
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.put(0, kGroup).outcome, Outcome::Done);
        ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
        bus.runFor(300ms);
        bus.onCommand = [](std::vector<std::uint8_t>& command) {
            if (command.size() > 3 && command[2] == 0x17 &&
                command[3] == 0x05)  // stop abruptly, amplifier on
                command.clear();
        };
        bus.engine.stopAll(bus.now);
        bus.runFor(50ms);
        ASSERT_TRUE(bus.engine.stopping());
        if (group)
            bus.submitGroup(GroupCommand{kGroup, GroupCommand::Action::MotorOff});
        else
            EXPECT_EQ(bus.perform({motorOff(0)}), Outcome::Done);
        EXPECT_TRUE(bus.runUntil([&] { return !bus.servo(0).servoOn; }, 200ms));
        EXPECT_EQ(bus.perform({enable(1)}), Outcome::Cancelled) << "it would switch that servo on";
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 5s));
        EXPECT_THAT(bus.last<StopFinished>()->unreached, IsEmpty());
        EXPECT_FALSE(bus.servo(1).servoOn);
    }
}

TEST(StopAll, SwitchesOffAPwmOutput) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(
        bus.perform({toServo(0, servo::StopMotor{true, servo::StopManner::MotorOff, {}}), loadPwm(0, 60)}),
        Outcome::Done);
    bus.runFor(300ms);
    ASSERT_GT(bus.servo(0).pwm, 0);
    const std::size_t from = bus.sent.size();
    const auto stopped = bus.stopAll();
    EXPECT_GT(bus.sends("AA 01 17 02 1A", from), 0U);
    EXPECT_EQ(bus.servo(0).pwm, 0);
    EXPECT_FALSE(bus.servo(0).servoOn);
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0));
    EXPECT_THAT(stopped->wereOff, IsEmpty()) << "its motor was driven";
}

TEST(StopAll, StopsAServoThatMayHaveBeenSwitchedOn) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0)}), Outcome::Done);
    // The command is carried out, but its answer is lost.
    bus.losesReply = [](ByteSpan) { return true; };
    bus.submit({loadVelocity(0, 65'536, true)});
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 01 94") == 1; }, 1s));
    bus.runFor(30ms);
    bus.losesReply = {};
    const std::size_t from = bus.sent.size();
    const auto stopped = bus.stopAll();
    EXPECT_GT(bus.sends("AA 01 17 05 1D", from), 0U);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 0, 1e-9);
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0));
}

TEST(StopAll, OvertakesQueuedMoves) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1)}), Outcome::Done);
    std::vector<OperationId> queued;
    for (int i = 0; i < 10; ++i)
        queued.push_back(bus.submit({loadMove(0, 1000 + i), start(0)}));
    const std::size_t from = bus.sent.size();
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(300ms);
    for (const OperationId id : queued)
        EXPECT_EQ(bus.outcomeOf(id), Outcome::Cancelled);
    EXPECT_EQ(bus.sends("AA 01 05", from), 0U);
    EXPECT_EQ(bus.sends("AA 01 D4", from), 0U);
}

TEST(StopAll, CancelsWhatIsSubmittedWhileItRuns) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    bus.engine.stopAll(bus.now);
    const auto id = bus.submit({toServo(0, Nop{})});
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Cancelled);
}

TEST(StopAll, PreEmptsAReplyAndLeavesTheGap) {
    ScriptedBus bus(1);
    bus.aux = 0x04;
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    // A poll has just been sent, and its reply is on its way.
    const std::size_t polls = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > polls; }));
    const auto poll = bus.sent.back();
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return has(bus.sent.back().hex, "AA 01 17"); }));
    EXPECT_EQ(bus.sent.back().hex, "AA 01 17 05 1D");
    const Duration onWire = Duration(520'833) * static_cast<Duration::rep>(fromHex(poll.hex + " ").size());
    EXPECT_EQ(bus.sent.back().time - poll.time, onWire + 512us);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }));
    EXPECT_THAT(bus.all<StopFinished>()[0].unreached, IsEmpty());
}

TEST(StopAll, SendsNullsFirstWhenTheLinkIsSuspect) {
    ScriptedBus bus(2);
    bus.aux = 0x04;
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    auto servo = bus.answer;
    bus.answer = [](ByteSpan) { return std::vector<std::uint8_t>{}; };
    const auto before = bus.engine.statistics().timeouts;
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before; }));
    bus.answer = servo;
    const std::size_t from = bus.sent.size();
    bus.engine.stopAll(bus.now);
    bus.runFor(50ms);
    ASSERT_GT(bus.sent.size(), from + 1);
    EXPECT_EQ(bus.sent[from].hex, ScriptedBus::kNulls);
    EXPECT_EQ(bus.sent[from + 1].hex, "AA FF 17 05 1B");
    EXPECT_LT(bus.sent[from + 1].time - bus.sent[from].time, 12ms) << "no quarantine before a stop";
}

TEST(StopAll, ReachesEverybodyWithOnePacketWhereAllMayTakeIt) {
    VirtualBus bus(servos(32));
    ASSERT_TRUE(bus.connect());
    std::vector<Order> orders;
    for (std::uint8_t i = 0; i < 32; ++i) {
        orders.push_back(gains(i));
        orders.push_back(enable(i));
    }
    ASSERT_EQ(bus.perform(orders), Outcome::Done);
    bus.runFor(1s);
    const std::size_t from = bus.sent.size();
    const TimePoint asked = bus.now;
    const auto stopped = bus.stopAll();
    EXPECT_EQ(bus.sends("AA FF 17 05 1B", from), 1U);
    EXPECT_LT(bus.sent[from].time - asked, 10ms);
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->stopped.size(), 32U);
    EXPECT_THAT(numbers(stopped->unreached), IsEmpty());
}

TEST(StopAll, TellsWhichModuleDidNotAnswer) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    bus.losesReply = [](ByteSpan command) {
        return command.size() > 1 && command[0] == 0xAA && command[1] == 2;
    };
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0, 2));
    EXPECT_THAT(numbers(stopped->unreached), ElementsAre(1));
    EXPECT_LE(stopped->took, StopLane::kLimit + 100ms);
}

TEST(StopAll, EndsInTimeWhenNobodyAnswers) {
    VirtualBus bus(servos(32));
    ASSERT_TRUE(bus.connect());
    bus.losesReply = [](ByteSpan) { return true; };
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->unreached.size(), 32U);
    EXPECT_LE(stopped->took, StopLane::kLimit + 100ms);
}

TEST(StopAll, RepeatsAStopThatGotLost) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(300ms);
    int lost = 0;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() == 5 && command[2] == 0x17 && lost++ < 2)
            command.clear();
    };
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0));
    EXPECT_NEAR(bus.servo(0).commandVelocity, 0, 1e-9);
}

TEST(StopAll, DoesNotSwitchATrippedServoOnAgain) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    // Sixty times the inertia: an abrupt stop from 15 600 counts/s takes some 450 counts, the error limit is
    // 150.
    bus.chain.set(ModuleIndex(0), sim::Input::Inertia, 1e-3, bus.now);
    ASSERT_EQ(bus.perform({toServo(0, servo::SetGain{200, 2000, 20, 200, 255, 0, 150, 1, std::uint8_t{0}}),
                           enable(0), loadVelocity(0, 8 * 65'536, true)}),
              Outcome::Done);
    bus.runFor(2s);
    ASSERT_TRUE(bus.servo(0).servoOn);
    const auto stopped = bus.stopAll();
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(0).servoOn);
    ASSERT_TRUE(stopped);
}

TEST(StopAll, RaisesNoAmplifierThatIsOff) {
    // AMP_EN low, and then a move: the servo is on, its command position has moved 2000 counts, and the
    // motor, which has no current, is at rest (DS-V 5.2). With AMP_EN high, the motor would leap there.
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), motorOff(0), loadMove(0, 2'000), start(0)}), Outcome::Done);
    bus.runFor(2s);
    ASSERT_TRUE(bus.servo(0).servoOn);
    ASSERT_EQ(bus.servo(0).position, 0);
    const auto stopped = bus.stopAll();
    bus.runFor(500ms);
    EXPECT_EQ(bus.servo(0).position, 0);
    ASSERT_TRUE(stopped);
    EXPECT_THAT(numbers(stopped->stopped), ElementsAre(0));
}

TEST(StopAll, EndsOnceWhenAskedForTwice) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bus.engine.stopAll(bus.now);
    bus.runFor(10ms);
    bus.engine.stopAll(bus.now);
    bus.runFor(1s);
    EXPECT_EQ(bus.count<StopFinished>(), 1U);
    EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 2U);
}

TEST(StopAll, WithoutAConnectionEndsAtOnce) {
    VirtualBus bus(servos(2));
    bus.engine.stopAll(bus.now);
    bus.runFor(1ms);
    EXPECT_EQ(bus.count<StopFinished>(), 1U);
}

TEST(StopAll, DuringARestartIsConfirmed) {
    VirtualBus bus(servos(2));
    bus.engine.restart(bus.now);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 5s));
    EXPECT_EQ(bus.count<ChainFound>(), 1U) << "by then, the modules are known";
    EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 2U);
    bus.engine.restart(bus.now);
    bus.runFor(400ms);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 2; }, 5s));
    EXPECT_EQ(bus.count<ChainFound>(), 1U) << "now the chain is already known";
    EXPECT_EQ(bus.last<StopFinished>()->stopped.size() + bus.last<StopFinished>()->unreached.size(), 2U);
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<ChainFound>() == 2; }, 10s)) << "the restart continues";
}

TEST(StopAll, IsNoLinkError) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), gains(2), enable(2)}), Outcome::Done);
    for (int i = 0; i < 20; ++i) {
        bus.runFor(i * 1ms);
        ASSERT_TRUE(bus.stopAll());
    }
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    EXPECT_EQ(bus.engine.statistics().surplusBytes, 0U);
}

TEST(StopAll, TakesShortTimeOnAHealthyLink) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(500ms);
    const std::size_t from = bus.sent.size();
    const TimePoint asked = bus.now;
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    // At worst, the stop waits for a whole poll, 5 bytes of 0.52 ms, and the gap.
    ASSERT_EQ(bus.sent[from].hex(), "AA 01 17 05 1D");
    EXPECT_LT(bus.sent[from].time - asked, 4ms);
    EXPECT_LT(stopped->took, 150ms);
}

[[nodiscard]] Belief stepper(std::uint8_t status) {
    Belief belief({ModuleIndex(0), BusAddress(1), {ModuleType::Stepper, 1}});
    StatusReport report;
    report.status = status;
    belief.onStatus(report, TimePoint(1s));
    return belief;
}

TEST(StopFor, AStepperThatIsOnStopsAndKeepsItsCurrent) {
    // DS-S 5.2: bit 0 moving, bit 2 amplifier enabled, bit 3 power.
    const auto stop = stopFor(stepper(0x0D));
    ASSERT_TRUE(stop);
    EXPECT_EQ(toHex(payloadOf(*stop).data), "05");
}

TEST(StopFor, AStepperThatIsOffIsNotEnergised) {
    EXPECT_FALSE(stopFor(stepper(0x08)));
}

TEST(StopFor, AServoOfWhichNothingIsKnownSinceTheResetIsLeftOff) {
    EXPECT_FALSE(stopFor(Belief({ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}})));
}

TEST(StopFor, AModuleWithoutADataSheetIsLeftAlone) {
    EXPECT_FALSE(stopFor(Belief({ModuleIndex(0), BusAddress(1), {ModuleType::Io, 1}})));
}

TEST(StopAll, NeverCallsAModuleStoppedThatItCannotTell) {
    ScriptedBus bus(2);
    bus.answer = [&](ByteSpan packet) {
        bus.type = packet[1] == 2 ? 7 : 0;
        return bus.likeAServo(packet);
    };
    ASSERT_TRUE(bus.connect());
    const std::size_t from = bus.sent.size();
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }));
    const StopFinished finished = bus.all<StopFinished>()[0];
    EXPECT_THAT(numbers(finished.stopped), ElementsAre(0));
    EXPECT_THAT(numbers(finished.noStopKnown), ElementsAre(1));
    EXPECT_THAT(finished.unreached, IsEmpty());
    EXPECT_THAT(finished.unconfirmed, IsEmpty());
    bus.runFor(5s);
    EXPECT_EQ(bus.count<OwedStopConfirmed>(), 0U);
    for (std::size_t i = from; i < bus.sent.size(); ++i)
        EXPECT_FALSE(has(bus.sent[i].hex, "AA 02 17")) << "it is not known how it would interpret a stop";
}

TEST(StopAll, StopsASteppersMotion) {
    ScriptedBus bus(2);
    bus.type = 3;
    bus.status = 0x2D;  // moving in velocity profile mode
    bus.aux = 0;
    bus.answer = [&](ByteSpan packet) {
        if (toHex(packet).find(" 17 05 ") != std::string::npos)
            bus.status = 0x0C;
        return bus.likeAServo(packet);
    };
    ASSERT_TRUE(bus.connect());
    bus.runFor(300ms);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }));
    EXPECT_THAT(numbers(bus.all<StopFinished>()[0].stopped), ElementsAre(0, 1));
}

TEST(StopAll, GoesOnPollingAfterwards) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_TRUE(bus.stopAll());
    const std::size_t before = bus.samplesOf(0);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(0), before + 30);
}

TEST(StopAll, IsReportedAsExecutedForTheModel) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    const std::size_t before = bus.count<CommandExecuted>();
    ASSERT_TRUE(bus.stopAll());
    EXPECT_GT(bus.count<CommandExecuted>(), before);
    EXPECT_EQ(bus.last<CommandExecuted>()->command,
              ModuleCommand(ServoCommand(servo::StopMotor{true, servo::StopManner::Abruptly, {}})));
}

TEST(StopAll, IsReportedBeforeWhatTheModuleSaysAfterIt) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 4 * 65'536), start(0)}), Outcome::Done);
    bus.runFor(200ms);
    const std::size_t polled = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > polled; }, 1s));  // a reply is on its way
    bus.events.clear();
    ASSERT_TRUE(bus.stopAll());
    // No status from after the first command that stops module 1 may be reported before that command.
    std::optional<TimePoint> stopped;
    std::vector<TimePoint> before;
    for (const bus::Event& event : bus.events) {
        const auto* sample = std::get_if<bus::Sample>(&event);
        if (const auto* executed = std::get_if<CommandExecuted>(&event); executed != nullptr && !stopped)
            stopped = executed->time;
        else if (sample != nullptr && sample->module == ModuleIndex(0) && !stopped)
            before.push_back(sample->time);
    }
    ASSERT_TRUE(stopped.has_value());
    for (const TimePoint time : before)
        EXPECT_LT(time, *stopped);
}

TEST(StopAll, StopsASimulatedStepperAndLeavesAnOffOneOff) {
    VirtualBus bus({{ModuleType::Servo, 4}, {ModuleType::Stepper, 1}, {ModuleType::Stepper, 1}});
    ASSERT_TRUE(bus.connect());
    const auto toStep = [](StepperCommand command) { return bus::Order{ModuleIndex(1), std::move(command)}; };
    stepper::LoadTrajectory run;
    run.speed = std::uint8_t{100};
    run.accelerationTime = std::uint8_t{2};
    ASSERT_EQ(bus.perform(
                  {toStep(stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 5, 200, 50, 0}),
                   toStep(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly}), toStep(run),
                   toStep(StartMotion{})}),
              Outcome::Done);
    bus.runFor(500ms);
    ASSERT_TRUE(bus.chain.snapshot(ModuleIndex(1), bus.now).stepper->moving);
    const auto finished = bus.stopAll();
    ASSERT_TRUE(finished.has_value());
    EXPECT_THAT(numbers(finished->stopped), ElementsAre(0, 1, 2));
    EXPECT_FALSE(bus.chain.snapshot(ModuleIndex(1), bus.now).stepper->moving);
    EXPECT_TRUE(bus.chain.snapshot(ModuleIndex(1), bus.now).stepper->ampEnabled) << "it still holds";
    EXPECT_FALSE(bus.chain.snapshot(ModuleIndex(2), bus.now).stepper->ampEnabled);
    bus.expectNoViolations();
}

/// The motor must then be seen at rest before it starts again.
TEST(OwedStop, IsForAFaultOnceOneIsAddedToWhatTheOperatorWanted) {
    const ModuleIndex motor(0);
    const auto after = [motor](StopCause first, StopCause then) {
        Chain chain({ModuleInfo{motor, BusAddress(1), {ModuleType::Servo, 4}}}, 19'200, false);
        chain.owe(motor, first);
        chain.owe(motor, then);
        return chain.at(motor).owed->cause;
    };
    using enum StopCause;
    EXPECT_EQ(after(HoldReleased, MotionSuspect), MotionSuspect);
    EXPECT_EQ(after(MotionSuspect, GroupStop), MotionSuspect);
    EXPECT_EQ(after(LinkGivenUp, MotionSuspect), LinkGivenUp);
    EXPECT_EQ(after(GroupStop, TravelLimit), GroupStop);
    EXPECT_EQ(after(GroupStop, StopCause::StopAll), GroupStop);
}

/// link.md 2.6.
TEST(OwedStop, IsMadeGentlerOnlyIfTheOperatorWantsBoth) {
    const ModuleIndex motor(0);
    const auto after = [motor](StopCause first, StopManner wanted, StopCause then, StopManner later) {
        Chain chain({ModuleInfo{motor, BusAddress(1), {ModuleType::Servo, 4}}}, 19'200, false);
        chain.owe(motor, first, wanted);
        chain.owe(motor, then, later);
        return chain.at(motor).owed->target.manner();
    };
    using enum StopManner;
    EXPECT_EQ(after(StopCause::GroupStop, Off, StopCause::GroupStop, Smoothly), Smoothly);
    EXPECT_EQ(after(StopCause::GroupStop, Off, StopCause::LinkGivenUp, Abruptly), Off);
    EXPECT_EQ(after(StopCause::GroupStop, Off, StopCause::TravelLimit, Smoothly), Off);
    EXPECT_EQ(after(StopCause::MotionSuspect, Off, StopCause::GroupStop, Smoothly), Off);
    EXPECT_EQ(after(StopCause::PathEnded, Smoothly, StopCause::GroupStop, Abruptly), Abruptly);
}

}  // namespace

}  // namespace nmc::test

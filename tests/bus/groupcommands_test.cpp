// SPDX-License-Identifier: GPL-3.0-or-later
// Commands to groups other than start and home: stops, a new zero, sticky bits (DS-V 4.1, 5.2).
#include <gtest/gtest.h>

#include "tests/bus/groups.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using Action = GroupCommand::Action;

/// Four servos that are on; the first three are group 81, which the second leads if there is a leader.
class GroupCommands : public testing::TestWithParam<bool> {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        for (std::uint8_t i = 0; i < 4; ++i)
            ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
        for (std::uint8_t i = 0; i < 3; ++i)
            ASSERT_EQ(bus.put(i, kGroup, GetParam() && i == 1).outcome, Outcome::Done);
    }
    void runAll() {
        for (std::uint8_t i = 0; i < 4; ++i)
            ASSERT_EQ(bus.perform({loadVelocity(i, 65'536, true)}), Outcome::Done);
        bus.runFor(300ms);
        from = bus.sent.size();
    }
    [[nodiscard]] GroupFinished tell(Action action) {
        return bus.finish(bus.submitGroup(GroupCommand{kGroup, action}));
    }
    /// Number of members that have confirmed that they are at rest.
    [[nodiscard]] std::size_t confirmed() const {
        std::size_t n = 0;
        for (const auto& stop : bus.all<OwedStopConfirmed>())
            n += stop.cause == StopCause::GroupStop ? 1U : 0U;
        return n;
    }
    void expectStopped(bool on = true) {
        EXPECT_TRUE(bus.runUntil([&] { return confirmed() == 3; }, 3s)) << confirmed();
        for (std::uint8_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(bus.servo(i).commandVelocity, 0.0, 0.01) << int{i};
            EXPECT_EQ(bus.servo(i).servoOn, on) << int{i};
        }
    }

    GroupBus bus{servos(4)};
    std::size_t from = 0;
};

// AA, group, 17, control, sum (DS-V 5.2): amplifier 01, off 02, abruptly 04, smoothly 08.
TEST_P(GroupCommands, StopAllMembersInTheSameTickAndEachConfirms) {
    struct Case {
        Action action;
        const char* packet;
        bool on;
    };
    for (const Case& c : {Case{Action::StopSmoothly, "AA 81 17 09 A1", true},
                          {Action::StopAbruptly, "AA 81 17 05 9D", true},
                          {Action::MotorOff, "AA 81 17 02 9A", false}}) {
        SCOPED_TRACE(c.packet);
        runAll();
        const GroupFinished finished = tell(c.action);
        EXPECT_EQ(finished.outcome, Outcome::Done);
        EXPECT_EQ(finished.members.size(), 3U);
        expectStopped(c.on);
        EXPECT_EQ(bus.sends(c.packet, from), 1U);
        EXPECT_NEAR(bus.servo(3).commandVelocity, 1.0, 1e-9) << "it is in no group";
        bus.events.clear();
    }
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    bus.expectNoViolations();
}

TEST_P(GroupCommands, StopAMemberByItselfThatHasNotHeardTheGroup) {
    for (const Action action : {Action::StopSmoothly, Action::StopAbruptly, Action::MotorOff}) {
        bus.onCommand = [](std::vector<std::uint8_t>& command) {
            if (command.size() > 1 && command[1] == kGroup)
                command.clear();
        };
        runAll();
        EXPECT_EQ(tell(action).outcome, Outcome::Done);
        expectStopped(action != Action::MotorOff);
        bus.onCommand = nullptr;
        bus.events.clear();
    }
}

TEST_P(GroupCommands, StopMembersWhileTheChainIsSearchedFor) {
    for (const Action action : {Action::StopSmoothly, Action::StopAbruptly, Action::MotorOff}) {
        runAll();
        bus.engine.connect(bus.now);
        bus.runFor(20ms);
        const GroupFinished finished = tell(action);
        EXPECT_EQ(finished.outcome, Outcome::Done);
        EXPECT_EQ(finished.members.size(), 3U);
        expectStopped(action != Action::MotorOff);
        EXPECT_NEAR(bus.servo(3).commandVelocity, 1.0, 1e-9) << "it is in no group";
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<ChainFound>() > 0; }, 10s));
        bus.events.clear();
    }
}

TEST_P(GroupCommands, LeaveAMotorOffThatIsOff) {
    runAll();
    ASSERT_EQ(bus.perform({motorOff(1)}), Outcome::Done);
    from = bus.sent.size();
    EXPECT_EQ(tell(Action::StopAbruptly).outcome, Outcome::Done);
    EXPECT_TRUE(bus.runUntil([&] { return confirmed() == 3; }, 3s));
    EXPECT_EQ(bus.sends("AA 81 17", from), 0U) << "it would switch that servo on (DS-V 5.2)";
    EXPECT_FALSE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0.0);
    EXPECT_EQ(bus.servo(2).commandVelocity, 0.0);
}

TEST_P(GroupCommands, StopWhatWaitsForTheGroupAndNothingElse) {
    const OperationId own = bus.submit({loadMove(0, 40'000), start(0)});
    const OperationId waiting = bus.submit({loadMove(2, 40'000), start(2)});
    const OperationId other = bus.submit({loadMove(3, 2'000), start(3)});
    const OperationId start = bus.submitGroup(GroupCommand{kGroup, Action::StartMotion});
    EXPECT_EQ(tell(Action::StopAbruptly).outcome, Outcome::Done);
    EXPECT_EQ(bus.outcomeOf(own), Outcome::Cancelled);
    EXPECT_EQ(bus.outcomeOf(waiting), Outcome::Cancelled);
    EXPECT_EQ(bus.finish(start).outcome, Outcome::Cancelled);
    bus.runFor(4s);
    EXPECT_EQ(bus.outcomeOf(other), Outcome::Done);
    EXPECT_NEAR(bus.servo(3).position, 2'000, 2);
    EXPECT_NEAR(bus.servo(0).position, 0, 2);
    EXPECT_NEAR(bus.servo(2).position, 0, 2);
}

TEST_P(GroupCommands, StopAHoldOfAMemberForGood) {
    HoldToMove hold = forward(2);
    for (int i = 0; i < 5; ++i) {
        bus.engine.hold(hold, bus.now);
        bus.runFor(100ms);
    }
    EXPECT_GT(bus.servo(2).commandVelocity, 0.5);
    EXPECT_EQ(tell(Action::StopSmoothly).outcome, Outcome::Done);
    for (int i = 0; i < 5; ++i) {
        bus.engine.hold(hold, bus.now);
        bus.runFor(100ms);
    }
    EXPECT_EQ(bus.servo(2).commandVelocity, 0.0) << "the press has ended";
    expectStopped();
}

TEST_P(GroupCommands, LetTheOperatorStartAgainAtOnce) {
    runAll();
    EXPECT_EQ(tell(Action::StopSmoothly).outcome, Outcome::Done);
    ASSERT_TRUE(bus.runUntil([&] { return confirmed() == 3; }, 3s));
    EXPECT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-9);
}

TEST_P(GroupCommands, SetTheirPositionsTo0InTheSameTick) {
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({loadMove(i, 1'000 * (i + 1)), start(i)}), Outcome::Done);
    bus.runFor(200ms);
    GroupFinished finished = tell(Action::ResetPosition);
    EXPECT_EQ(finished.outcome, Outcome::Forbidden) << "they move";
    EXPECT_EQ(bus.sends("AA 81 00"), 0U);
    bus.runFor(3s);
    finished = tell(Action::ResetPosition);
    EXPECT_EQ(finished.outcome, Outcome::Done);
    EXPECT_EQ(bus.sends("AA 81 00 81"), 1U);
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(bus.servo(i).position, 0, 2);
        EXPECT_EQ(bus.executedOnly<ResetPosition>(i), 1U) << "it is reported to the panel";
    }
    EXPECT_EQ(bus.engine.statistics().errors(), 0U) << "a new zero is no contradiction";
    bus.expectNoViolations();
}

TEST_P(GroupCommands, SayWhoseZeroIsStillTheOldOne) {
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({loadMove(i, 1'000), start(i)}), Outcome::Done);
    bus.runFor(3s);
    bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 1 && command[1] == kGroup)
            command.clear();
    };
    const GroupFinished finished = tell(Action::ResetPosition);
    EXPECT_EQ(finished.outcome, Outcome::NoAnswer);
    ASSERT_EQ(finished.members.size(), 3U);
    for (const GroupMember& member : finished.members)
        EXPECT_EQ(member.outcome, MemberOutcome::NotDone);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 2);
}

TEST_P(GroupCommands, ClearTheirStickyBits) {
    // A current limit of 0 does not trip; an error limit of 1 does: the servo switches off, and the bit stays
    // set when it is on again (DS-V 5.3).
    const auto tripped = toServo(0, servo::SetGain{200, 2000, 20, 200, 255, 0, 1, 1, std::uint8_t{0}});
    ASSERT_EQ(bus.perform({tripped, loadVelocity(0, 655'360, true)}), Outcome::Done);
    ASSERT_TRUE(bus.runUntil([&] { return !bus.servo(0).servoOn; }, 2s));
    bus.runFor(1s);
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.runFor(200ms);
    ASSERT_TRUE(servo::StatusByte{bus.lastSample(0)->report.status}.positionError());
    EXPECT_EQ(tell(Action::ClearStickyBits).outcome, Outcome::Done);
    EXPECT_EQ(bus.sends("AA 81 0B 8C"), 1U);
    bus.runFor(200ms);
    EXPECT_FALSE(servo::StatusByte{bus.lastSample(0)->report.status}.positionError());
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Leader, GroupCommands, testing::Bool(),
                         [](const auto& leader) { return leader.param ? "WithLeader" : "Without"; });

TEST(GroupStops, ServosAndSteppersEachInItsOwnWords) {
    GroupBus bus({{ModuleType::Servo, 4}, {ModuleType::Stepper, 1}});
    ASSERT_TRUE(bus.connect());
    const auto toStepper = [](StepperCommand command) { return Order{ModuleIndex(1), std::move(command)}; };
    const stepper::LoadTrajectory run{std::nullopt, std::uint8_t{40}, std::uint8_t{4}, std::nullopt, false,
                                      true};
    ASSERT_EQ(
        bus.perform(
            {gains(0), enable(0), loadVelocity(0, 65'536, true),
             toStepper(stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 10, 200, 50, 0}),
             toStepper(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly}), toStepper(run)}),
        Outcome::Done);
    for (std::uint8_t i = 0; i < 2; ++i)
        ASSERT_EQ(bus.put(i, 0x85, i == 0).outcome, Outcome::Done);
    bus.runFor(1s);
    ASSERT_TRUE(bus.lastSample(1)->report.stepperStatus().moving());
    EXPECT_EQ(bus.finish(bus.submitGroup(GroupCommand{0x85, GroupCommand::Action::StopSmoothly})).outcome,
              Outcome::Done);
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 2; }, 5s));
    EXPECT_FALSE(bus.lastSample(1)->report.stepperStatus().moving());
    EXPECT_NEAR(bus.servo(0).commandVelocity, 0.0, 0.01);
    EXPECT_EQ(bus.finish(bus.submitGroup(GroupCommand{0x85, GroupCommand::Action::ClearStickyBits})).outcome,
              Outcome::Forbidden)
        << "a PIC-STEP has none (DS-S 5.1)";
    EXPECT_EQ(bus.sends("AA 85 0B"), 0U);
    bus.expectNoViolations();
}

TEST(GroupStops, AreRefusedForAGroupThatHasNobody) {
    GroupBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.finish(bus.submitGroup(GroupCommand{0x90, GroupCommand::Action::StopAbruptly})).outcome,
              Outcome::Forbidden);
    EXPECT_EQ(bus.sends("AA 90"), 0U);
}

}  // namespace

}  // namespace nmc::test

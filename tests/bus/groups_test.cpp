// SPDX-License-Identifier: GPL-3.0-or-later
// Groups (DS-V 4.1): their members, and the commands that all members carry out in the same tick.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/bus/groups.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Three servos in group 81 that are on and at rest; if `leader`, the second leads it.
void makeGroup(GroupBus& bus, bool leader) {
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 3; ++i) {
        ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
        ASSERT_EQ(bus.put(i, 0x81, leader && i == 1).outcome, Outcome::Done);
    }
}

/// A run that takes a second to reach its velocity, and as long to stop smoothly.
[[nodiscard]] Order slowRun(std::uint8_t module) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(2 * kOnePerTick);
    load.acceleration = CountsPerTickSquared(65);
    load.profile = servo::ProfileMode::Velocity;
    load.startNow = true;
    return toServo(module, load);
}

// ---- membership ----

TEST(Groups, AreWhatTheModulesWereTold) {
    GroupBus bus(servos(3));
    makeGroup(bus, true);
    for (std::uint8_t i = 0; i < 3; ++i) {
        const auto truth = bus.chain.snapshot(ModuleIndex(i), bus.now);
        EXPECT_EQ(truth.address, i + 1);
        EXPECT_EQ(truth.group, 0x81);
        EXPECT_EQ(truth.leader, i == 1);
    }
    // AA address, 21, address, group; bit 7 of the group byte cleared for the leader (DS-V 5.2).
    EXPECT_EQ(bus.sends("AA 01 21 01 81 A4"), 1U);
    EXPECT_EQ(bus.sends("AA 02 21 02 01 26"), 1U);
    const auto told = bus.last<GroupChanged>();
    ASSERT_TRUE(told);
    EXPECT_EQ(told->module, ModuleIndex(2));
    EXPECT_EQ(told->place, (GroupPlace{0x81, false}));
    bus.expectNoViolations();
}

TEST(Groups, LoseTheirOldLeaderBeforeTheyGetAnother) {
    GroupBus bus(servos(3));
    makeGroup(bus, true);
    bool two = false;
    bus.onTime = [&] {
        unsigned leaders = 0;
        for (std::uint8_t i = 0; i < 3; ++i)
            leaders += bus.chain.snapshot(ModuleIndex(i), bus.now).leader ? 1U : 0U;
        two = two || leaders > 1;
    };
    const GroupFinished finished = bus.put(2, 0x81, true);
    EXPECT_EQ(finished.outcome, Outcome::Done);
    EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(1), MemberOutcome::Done},
                                                          {ModuleIndex(2), MemberOutcome::Done}}));
    EXPECT_FALSE(two);
    EXPECT_FALSE(bus.chain.snapshot(ModuleIndex(1), bus.now).leader);
    EXPECT_TRUE(bus.chain.snapshot(ModuleIndex(2), bus.now).leader);
}

TEST(Groups, ThatCannotBeAreRefused) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    const std::size_t from = bus.sent.size();
    EXPECT_EQ(bus.put(0, 0xFF, true).outcome, Outcome::Forbidden) << "stops and rates go to FF";
    EXPECT_EQ(bus.put(0, 0x7F).outcome, Outcome::Forbidden) << "this is a module's address";
    EXPECT_EQ(bus.put(5, 0x81).outcome, Outcome::Forbidden) << "there is no such module";
    EXPECT_EQ(bus.sends("AA 01 21", from) + bus.sends("AA 02 21", from), 0U);
}

TEST(Groups, OfAnotherHostAreNotKnownAndGetNoCommand) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.put(0, 0x81).outcome, Outcome::Done);
    ASSERT_EQ(bus.put(1, 0x81, true).outcome, Outcome::Done);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    const auto found = bus.last<ChainFound>();
    ASSERT_TRUE(found && found->attached);
    for (const ModuleInfo& info : found->modules)
        EXPECT_FALSE(info.group);
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 500)}), Outcome::Done);
    const std::size_t from = bus.sent.size();
    ASSERT_EQ(bus.put(0, 0x82).outcome, Outcome::Done);
    const GroupFinished withheld = bus.start(0x82);
    EXPECT_EQ(withheld.outcome, Outcome::Forbidden);
    EXPECT_EQ(withheld.members, (std::vector<GroupMember>{{ModuleIndex(1), MemberOutcome::Withheld}}));
    EXPECT_EQ(bus.put(0, 0x82, true).outcome, Outcome::Forbidden) << "the other module may lead it";
    EXPECT_EQ(bus.sends("AA 82", from), 0U);
}

TEST(Groups, AreKnownAgainWhenAChangeIsAnsweredLate) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bool lose = true;
    bus.losesReply = [&](ByteSpan command) {
        return command.size() > 2 && command[2] == 0x21 && std::exchange(lose, false);
    };
    EXPECT_EQ(bus.put(1, 0x81).outcome, Outcome::Done) << "repeated after a query has found it";
    EXPECT_EQ(bus.sends("AA 02 21 02 81"), 2U);
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x21; };
    EXPECT_EQ(bus.put(1, 0x83).outcome, Outcome::NoAnswer);
    EXPECT_FALSE(bus.last<GroupChanged>()->place);
    bus.losesReply = nullptr;
    bus.runFor(1s);
    EXPECT_FALSE(bus.lastSample(1).value().unsettled) << "nothing is being found out any more";
    EXPECT_EQ(bus.start(0x81).outcome, Outcome::Forbidden) << "it may be in any group";
    EXPECT_EQ(bus.put(1, 0xFF).outcome, Outcome::Done);
}

TEST(Groups, AreNotKnownWhenAStopCutsTheirChangeOff) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bus.submitGroup(GroupChange{ModuleIndex(1), {0x81, false}});
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 02 21 02 81") == 1; }, 1s));
    ASSERT_TRUE(bus.stopAll());
    ASSERT_TRUE(bus.last<GroupChanged>());
    EXPECT_EQ(bus.last<GroupChanged>()->module, ModuleIndex(1));
    EXPECT_FALSE(bus.last<GroupChanged>()->place);
    EXPECT_EQ(bus.start(0x81).outcome, Outcome::Forbidden) << "it may be in any group";
}

TEST(Groups, AreKnownAgainWhenTheAnswerComesAfterAStopOfTheirModule) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(1), enable(1)}), Outcome::Done);
    bus.runFor(200ms);
    bus.submitGroup(GroupChange{ModuleIndex(1), {0x81, false}});
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 02 21 02 81") == 1; }, 1s));
    bus.submit({enable(1)});
    bus.runFor(1ms);
    ASSERT_TRUE(bus.last<GroupChanged>());
    EXPECT_FALSE(bus.last<GroupChanged>()->place);
    bus.runFor(200ms);
    EXPECT_EQ(bus.last<GroupChanged>()->place, (GroupPlace{0x81, false}));
}

// ---- start ----

TEST(GroupStart, IsLatchedByAllMembersInTheSameTick) {
    for (const bool leader : {false, true}) {
        SCOPED_TRACE(leader ? "with a leader" : "without a leader");
        GroupBus bus(servos(3));
        makeGroup(bus, leader);
        ASSERT_EQ(bus.perform({loadMove(0, 4'000), loadMove(1, -4'000), loadMove(2, 8'000)}), Outcome::Done);
        const GroupFinished finished = bus.start(0x81);
        EXPECT_EQ(finished.outcome, Outcome::Done);
        EXPECT_FALSE(finished.stopped);
        EXPECT_EQ(finished.members.size(), 3U);
        for (std::uint8_t i = 0; i < 3; ++i) {
            // While they accelerate, the phase between two chips' clocks may make a difference of one tick,
            // 0.01 counts per tick.
            const double speed = std::abs(bus.servo(i).commandVelocity);
            EXPECT_GT(speed, 0.02) << int{i};
            EXPECT_LT(speed, 1.99) << int{i};
            EXPECT_NEAR(speed, std::abs(bus.servo(0).commandVelocity), 0.0101) << int{i};
        }
        EXPECT_EQ(bus.sends("AA 81 05 86"), 1U);
        bus.runFor(5s);
        EXPECT_NEAR(bus.servo(0).position, 4'000, 2);
        EXPECT_NEAR(bus.servo(1).position, -4'000, 2);
        EXPECT_NEAR(bus.servo(2).position, 8'000, 2);
        for (std::uint8_t i = 0; i < 3; ++i)
            EXPECT_EQ(bus.executedOnly<StartMotion>(i), 1U) << "each is reported to the model";
        bus.expectNoViolations();
    }
}

/// The members are queried instead, after which the leader's samples are as certain as those of the others.
TEST(GroupStart, IsSettledAlthoughTheAnswerOfItsLeaderWasLost) {
    GroupBus bus(servos(3));
    makeGroup(bus, true);
    ASSERT_EQ(bus.perform({loadMove(0, 40'000), loadMove(1, 40'000), loadMove(2, 40'000)}), Outcome::Done);
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[1] == kGroup; };
    EXPECT_EQ(bus.start(kGroup).outcome, Outcome::Done);
    bus.runFor(500ms);
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_EQ(bus.executedOnly<StartMotion>(i), 1U) << int{i};
        EXPECT_FALSE(bus.lastSample(i).value().unsettled) << int{i};
    }
    EXPECT_EQ(bus.sends("AA 81 05"), 1U);
}

TEST(GroupStart, OfAMoveToWhereItIsAndOfOneTooShortToSeeIsDone) {
    GroupBus bus(servos(3));
    makeGroup(bus, false);
    ASSERT_EQ(bus.perform({loadMove(0, 0), loadMove(1, 40), loadMove(2, 4'000)}), Outcome::Done);
    const GroupFinished finished = bus.start(0x81);
    EXPECT_EQ(finished.outcome, Outcome::Done);
    bus.runFor(4s);
    EXPECT_NEAR(bus.servo(1).position, 40, 2);
    EXPECT_NEAR(bus.servo(2).position, 4'000, 2);
}

TEST(GroupStart, IsWithheldWhenALoadWasNotConfirmedOrIsUsedUp) {
    GroupBus bus(servos(3));
    makeGroup(bus, false);
    ASSERT_EQ(bus.perform({loadMove(0, 4'000), loadMove(1, 4'000)}), Outcome::Done);
    GroupFinished finished = bus.start(0x81);
    EXPECT_EQ(finished.outcome, Outcome::Forbidden);
    EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(2), MemberOutcome::Withheld}}));
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[1] == 3; };
    EXPECT_EQ(bus.perform({loadMove(2, 4'000)}), Outcome::NoAnswer);
    bus.losesReply = nullptr;
    bus.runFor(6s);
    finished = bus.start(0x81);
    EXPECT_EQ(finished.outcome, Outcome::Forbidden) << "the load may have arrived";
    ASSERT_EQ(bus.perform({loadMove(2, 4'000)}), Outcome::Done);
    ASSERT_EQ(bus.perform({enable(1)}), Outcome::Done);
    EXPECT_EQ(bus.start(0x81).outcome, Outcome::Forbidden) << "a stop uses the load up (DS-V 5.2)";
    EXPECT_EQ(bus.sends("AA 81 05"), 0U);
    for (std::uint8_t i = 0; i < 3; ++i)
        EXPECT_EQ(bus.servo(i).commandVelocity, 0.0);
    ASSERT_EQ(bus.perform({loadMove(1, 4'000)}), Outcome::Done);
    EXPECT_EQ(bus.start(0x81).outcome, Outcome::Done);
}

TEST(GroupStart, IsNotForAGroupThatHasNobody) {
    GroupBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.start(0x90).outcome, Outcome::Forbidden);
    EXPECT_EQ(bus.sends("AA 90"), 0U);
}

TEST(GroupStart, TakesServosAndSteppersTogether) {
    GroupBus bus({{ModuleType::Servo, 4}, {ModuleType::Stepper, 1}});
    ASSERT_TRUE(bus.connect());
    const auto toStepper = [](StepperCommand command) { return Order{ModuleIndex(1), std::move(command)}; };
    const stepper::LoadTrajectory far{Counts(2'000), std::uint8_t{40}, std::uint8_t{4}, std::nullopt};
    ASSERT_EQ(bus.perform({gains(0), enable(0),
                           toStepper(stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 10,
                                                            200, 50, 0}),
                           toStepper(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}),
              Outcome::Done);
    for (std::uint8_t i = 0; i < 2; ++i)
        ASSERT_EQ(bus.put(i, 0x85, i == 0).outcome, Outcome::Done);
    ASSERT_EQ(bus.perform({loadMove(0, 3'000), toStepper(far)}), Outcome::Done);
    EXPECT_EQ(bus.start(0x85).outcome, Outcome::Done);
    bus.runFor(6s);
    EXPECT_NEAR(bus.servo(0).position, 3'000, 2);
    EXPECT_EQ(bus.chain.snapshot(ModuleIndex(1), bus.now).stepper->position, 2'000);
    bus.expectNoViolations();
}

TEST(GroupStart, OfVelocityModeIsSeenByTheWayThatIsGone) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 2; ++i) {
        ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
        ASSERT_EQ(bus.put(i, 0x81).outcome, Outcome::Done);
    }
    ASSERT_EQ(bus.perform({loadVelocity(0, 65'536), loadVelocity(1, 65'536)}), Outcome::Done);
    EXPECT_EQ(bus.start(0x81).outcome, Outcome::Done);
    bus.runFor(300ms);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 1e-9);
    EXPECT_NEAR(bus.servo(1).commandVelocity, 1.0, 1e-9);
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 2U);
}

/// At SR 20, a servo tick is 20 x 0.512 ms: 1 count per tick is 98 counts/s.
TEST(GroupStart, OfVelocityModeIsSeenAtALowServoRateAsWell) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    const servo::SetGain slow{
        20, 40, 0, 0, 255, 0, 16'000, 20, std::uint8_t{0}};  // soft enough for such a tick
    for (std::uint8_t i = 0; i < 2; ++i) {
        ASSERT_EQ(bus.perform({toServo(i, slow), enable(i)}), Outcome::Done);
        ASSERT_EQ(bus.put(i, 0x81).outcome, Outcome::Done);
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(kOnePerTick);
        load.acceleration = CountsPerTickSquared(kOnePerTick);
        load.profile = servo::ProfileMode::Velocity;
        ASSERT_EQ(bus.perform({toServo(i, load)}), Outcome::Done);
    }
    const GroupFinished started = bus.start(0x81);
    EXPECT_FALSE(started.stopped);
    for (const GroupMember& member : started.members)
        EXPECT_TRUE(member.outcome == MemberOutcome::Done || member.outcome == MemberOutcome::Unknown);
    EXPECT_TRUE(bus.engine.anythingMoves());
}

TEST(GroupStart, IsWithheldUntilAStopThatIsOwedForAFaultIsConfirmed) {
    GroupBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), slowRun(0)}), Outcome::Done);
    bus.runFor(1500ms);
    const ModuleInfo running = bus.last<ChainFound>()->modules.front();
    EngineConfig next;
    next.unconfirmed = {{running, StopManner::Smoothly}};
    bus.newHost(next);
    ASSERT_TRUE(bus.connect());
    ASSERT_TRUE(bus.runUntil([&] { return bus.servo(0).commandVelocity < 1.9; }, 1s));
    ASSERT_EQ(bus.put(0, kGroup).outcome, Outcome::Done);
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick)}), Outcome::Done);
    const GroupFinished withheld = bus.start(kGroup);
    EXPECT_EQ(withheld.outcome, Outcome::Forbidden);
    EXPECT_EQ(withheld.members, (std::vector<GroupMember>{{ModuleIndex(0), MemberOutcome::Withheld}}));
    EXPECT_EQ(bus.sends("AA 81 05"), 0U);
    EXPECT_GT(bus.servo(0).commandVelocity, 0.0) << "it still slows down";
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 1; }, 5s));
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick)}), Outcome::Done);
    EXPECT_EQ(bus.start(kGroup).outcome, Outcome::Done);
    bus.expectNoViolations();
}

TEST(GroupStart, TakesThePlaceOfAStopThatTheOperatorWanted) {
    for (const bool leader : {false, true}) {
        GroupBus bus(servos(3));
        makeGroup(bus, leader);
        ASSERT_EQ(bus.perform({slowRun(0)}), Outcome::Done);
        bus.runFor(1500ms);
        bus.submitGroup(GroupCommand{kGroup, GroupCommand::Action::StopSmoothly});
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 2; }, 1s));
        ASSERT_GT(bus.servo(0).commandVelocity, 0.5) << "it still slows down";
        ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick), loadVelocity(1, kOnePerTick),
                               loadVelocity(2, kOnePerTick)}),
                  Outcome::Done);
        bus.start(kGroup);
        bus.runFor(3s);
        for (std::uint8_t i = 0; i < 3; ++i)
            EXPECT_NEAR(bus.servo(i).commandVelocity, 1.0, 0.01) << int{i};
        bus.expectNoViolations();
    }
}

// ---- stops ----

TEST(GroupStart, DoesNotHoldUpAStop) {
    for (const bool leader : {false, true})
        for (const auto after : {0us, 700us, 3'000us, 9'000us, 25'000us, 60'000us}) {
            SCOPED_TRACE(after.count());
            GroupBus bus(servos(3));
            makeGroup(bus, leader);
            ASSERT_EQ(bus.perform({loadMove(0, 40'000), loadMove(1, 40'000), loadMove(2, 40'000)}),
                      Outcome::Done);
            bus.submitGroup(GroupCommand{0x81, GroupCommand::Action::StartMotion});
            bus.runFor(after);
            const auto stop = bus.stopAll();
            ASSERT_TRUE(stop);
            EXPECT_EQ(stop->stopped.size(), 3U);
            ASSERT_TRUE(bus.last<GroupFinished>());
            bus.runFor(1s);
            for (std::uint8_t i = 0; i < 3; ++i)
                EXPECT_EQ(bus.servo(i).commandVelocity, 0.0);
            EXPECT_EQ(bus.count<GroupFinished>(), 4U) << "three changes and the start";
        }
}

/// The outcome of a start is found out by queries of its members, and a stop of any other module comes first.
TEST(GroupStart, ThatIsNotFollowedUpBecauseOfAStopOfAnotherMotorIsEnded) {
    GroupBus bus(servos(4));
    makeGroup(bus, false);
    ASSERT_EQ(bus.put(3, 0x82).outcome, Outcome::Done);
    ASSERT_EQ(bus.perform({gains(3), enable(3), loadVelocity(3, kOnePerTick, true)}), Outcome::Done);
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({loadMove(i, 40'000)}), Outcome::Done);
    const OperationId started = bus.submitGroup(GroupCommand{0x81, GroupCommand::Action::StartMotion});
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 81 05") == 1; }, 1s));
    bus.submitGroup(GroupCommand{0x82, GroupCommand::Action::StopAbruptly});
    EXPECT_EQ(bus.finish(started).outcome, Outcome::Cancelled);
    bus.runFor(1s);
    for (std::uint8_t i = 0; i < 4; ++i)
        EXPECT_EQ(bus.servo(i).commandVelocity, 0.0) << int{i};
    bus.expectNoViolations();
}

TEST(GroupStop, GoesToEachModuleWhenNotAllAreInGroupFF) {
    GroupBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i), loadVelocity(i, 65'536, true)}), Outcome::Done);
    ASSERT_EQ(bus.put(1, 0x81).outcome, Outcome::Done);
    const std::size_t from = bus.sent.size();
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 3U);
    EXPECT_EQ(bus.sends("AA FF 17", from), 0U);
    ASSERT_EQ(bus.put(1, 0xFF).outcome, Outcome::Done);
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({loadVelocity(i, 65'536, true)}), Outcome::Done);
    const std::size_t again = bus.sent.size();
    ASSERT_TRUE(bus.stopAll());
    EXPECT_EQ(bus.sends("AA FF 17 05 1B", again), 1U) << "all are in FF again";
    bus.expectNoViolations();
}

TEST(GroupStop, GoesToEachModuleWhereAnotherHostChoseTheGroups) {
    GroupBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 2; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i), loadVelocity(i, 65'536, true)}), Outcome::Done);
    ASSERT_EQ(bus.put(0, 0x81).outcome, Outcome::Done);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    const std::size_t from = bus.sent.size();
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 2U);
    EXPECT_EQ(bus.sends("AA FF 17", from), 0U) << "the first would not hear it";
    EXPECT_EQ(bus.sends("AA 01 17 05 1D", from), 2U) << "blindly at first, and again for the reply";
    EXPECT_EQ(bus.sends("AA 02 17 05 1E", from), 2U);
    bus.expectNoViolations();
}

// ---- home ----

TEST(GroupHome, IsSavedByAllMembersInTheSameTick) {
    for (const bool leader : {false, true}) {
        GroupBus bus(servos(3));
        makeGroup(bus, leader);
        ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true), loadVelocity(1, 131'072, true)}),
                  Outcome::Done);
        bus.runFor(500ms);
        const GroupFinished finished =
            bus.finish(bus.submitGroup(GroupCommand{0x81, GroupCommand::Action::SaveAsHome}));
        EXPECT_EQ(finished.outcome, Outcome::Done);
        EXPECT_EQ(bus.sends("AA 81 0C 8D"), 1U);
        EXPECT_GT(bus.servo(0).home, 300);
        EXPECT_GT(bus.servo(1).home, 600);
        EXPECT_NEAR(bus.servo(2).home, 0, 4);
        EXPECT_EQ(bus.engine.statistics().errors(), 0U) << "a new home is no contradiction";
        bus.expectNoViolations();
    }
}

// ---- load now, start later ----

TEST(LoadNow, StartsLaterByAnOperationOfItsOwn) {
    GroupBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 3'000)}), Outcome::Done);
    bus.runFor(3s);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0.0) << "the load waits";
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Done);
    bus.runFor(4s);
    EXPECT_NEAR(bus.servo(0).position, 3'000, 2);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden) << "the load is used up";
    ASSERT_EQ(bus.perform({loadMove(0, 0), loadMove(0, 1'000)}), Outcome::Done);
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Done);
    bus.runFor(4s);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 2) << "the last load counts";
    ASSERT_EQ(bus.perform({loadMove(0, 0)}), Outcome::Done);
    ASSERT_TRUE(bus.stopAll());
    EXPECT_EQ(bus.perform({start(0)}), Outcome::Forbidden) << "a stop uses it up";
    bus.expectNoViolations();
}

}  // namespace

}  // namespace nmc::test

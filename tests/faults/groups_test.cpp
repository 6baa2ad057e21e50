// SPDX-License-Identifier: GPL-3.0-or-later
// M-26, M-27: the start of a group when something goes wrong at that moment. Whatever it is, the command is
// sent once, and what is reported about a member is true.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>

#include "tests/bus/groups.h"
#include "tests/faults/faultybus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

class FaultyGroup : public WithGroups<FaultyBus> {
public:
    using WithGroups<FaultyBus>::WithGroups;

    /// Sets up three servos in a group, with loads that take seconds; the second one leads it if `leader`.
    [[nodiscard]] bool isLoaded(bool leader) {
        if (!connectAndEnable())
            return false;
        for (std::uint8_t i = 0; i < 3; ++i)
            if (put(i, kGroup, leader && i == 1).outcome != Outcome::Done)
                return false;
        return perform({loadMove(0, 20'000), loadMove(1, -20'000), loadMove(2, 20'000)}) == Outcome::Done;
    }
    [[nodiscard]] std::uint64_t starts(std::uint8_t module) const {
        return executed(module, CommandCode::StartMotion);
    }
    void expectTrue(const GroupFinished& finished) {
        EXPECT_EQ(sends("AA 81 05"), 1U) << "the start is never repeated";
        ASSERT_EQ(finished.members.size(), 3U);
        bool all = true;
        for (const auto& [module, outcome] : finished.members) {
            const std::uint64_t started = starts(module.value());
            EXPECT_LE(started, 1U);
            EXPECT_FALSE(outcome == MemberOutcome::Done && started == 0) << int{module.value()};
            EXPECT_FALSE(outcome == MemberOutcome::NotDone && started == 1) << int{module.value()};
            EXPECT_NE(outcome, MemberOutcome::Withheld);
            all = all && outcome == MemberOutcome::Done;
        }
        EXPECT_EQ(finished.outcome, all ? Outcome::Done : Outcome::NoAnswer);
    }
    void expectAllStandSoon() {
        runFor(1s);
        for (std::uint8_t i = 0; i < 3; ++i)
            EXPECT_TRUE(stands(i)) << int{i};
    }
};

TEST(M26_GroupStart, IsWithheldWhenALoadWasRefused) {
    for (const char* fault : {"module 2 cksum on=load_trajectory", "module 2 silent on=load_trajectory"}) {
        SCOPED_TRACE(fault);
        FaultyGroup bus(servos(3), kFast);
        ASSERT_TRUE(bus.isLoaded(false));
        bus.fault(fault);
        EXPECT_NE(bus.perform({loadMove(1, 5'000)}), Outcome::Done);
        bus.clearFaults();
        bus.runFor(5s);
        const GroupFinished finished = bus.start(kGroup);
        EXPECT_EQ(finished.outcome, Outcome::Forbidden);
        EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(1), MemberOutcome::Withheld}}));
        EXPECT_EQ(bus.sends("AA 81"), 0U);
        bus.expectAllStandSoon();
    }
}

TEST(M27_GroupStartPartlyHeard, StopsTheGroupAndSaysWhoStarted) {
    for (const bool leader : {false, true})
        for (const std::uint8_t deaf : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
            SCOPED_TRACE(testing::Message() << (leader ? "leader, " : "no leader, ") << int{deaf});
            FaultyGroup bus(servos(3), kFast);
            ASSERT_TRUE(bus.isLoaded(leader));
            bus.fault("module " + std::to_string(deaf + 1) + " ignore=start_motion n=1");
            const GroupFinished finished = bus.start(kGroup);
            EXPECT_EQ(bus.struck(), 1U);
            bus.expectTrue(finished);
            for (const auto& [module, outcome] : finished.members)
                EXPECT_EQ(outcome, module.value() == deaf ? MemberOutcome::NotDone : MemberOutcome::Done)
                    << int{module.value()};
            EXPECT_TRUE(finished.stopped);
            bus.expectAllStandSoon();
            for (std::uint8_t i = 0; i < 3; ++i)
                EXPECT_TRUE(bus.servo(i).servoOn) << "it holds";
        }
}

TEST(M27_GroupStartPartlyHeard, ByNobodyLeavesTheLoads) {
    FaultyGroup bus(servos(3), kFast);
    ASSERT_TRUE(bus.isLoaded(false));
    bool lose = true;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 2 && command[1] == kGroup && std::exchange(lose, false))
            command.clear();
    };
    const GroupFinished finished = bus.start(kGroup);
    bus.expectTrue(finished);
    for (const auto& member : finished.members)
        EXPECT_EQ(member.outcome, MemberOutcome::NotDone);
    EXPECT_FALSE(finished.stopped);
    bus.runFor(1s);
    EXPECT_EQ(bus.sends("AA 81 05"), 1U) << "the operator decides what to do next";
    for (std::uint8_t i = 0; i < 3; ++i)
        EXPECT_TRUE(bus.stands(i));
    EXPECT_EQ(bus.start(kGroup).outcome, Outcome::Done);
    bus.expectNoViolations();
}

/// Each of these strikes once, the last one twice, at the packet to the group or right after it.
constexpr std::array kSingleFaults{
    "bus drop cmd on=start_motion n=1",
    "bus flip cmd on=start_motion n=1",
    "bus dup cmd on=start_motion n=1",
    "bus truncate cmd on=start_motion n=1",
    "bus garbage cmd on=start_motion n=1",
    "bus drop status on=start_motion n=1",
    "bus flip status on=start_motion n=1",
    "bus dup status on=start_motion n=1",
    "bus truncate status on=start_motion n=1",
    "bus garbage status on=start_motion n=1",
    "bus delay status on=start_motion t=60ms..80ms n=1",
    "bus silent on=start_motion n=1",
    "bus cksum on=start_motion n=1",
    "module 1 drop cmd on=start_motion n=1",
    "module 2 drop cmd on=start_motion n=1",
    "module 2 flip cmd on=start_motion n=1",
    "module 3 flip cmd on=start_motion n=1",
    "module 2 cksum on=start_motion n=1",
    "module 3 cksum on=start_motion n=1",
    "module 2 overrun on=start_motion n=1",
    "module 2 silent on=start_motion n=1",
    "bus drop status on=read_status n=1",
    "bus flip status on=read_status n=1",
    "bus silent on=read_status n=1",
    "bus drop cmd on=read_status n=1",
    "module 1 silent on=read_status n=2",
};

TEST(M27_SingleFaultAtAGroupStart, StartsNobodyTwiceAndClaimsNothingWrong) {
    for (const bool leader : {false, true})
        for (const std::string fault : kSingleFaults)
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                SCOPED_TRACE(testing::Message() << fault << (leader ? ", leader, " : ", ") << seed);
                FaultyGroup bus(servos(3), kFast, seed);
                ASSERT_TRUE(bus.isLoaded(leader));
                bus.fault(fault);
                const GroupFinished finished = bus.start(kGroup);
                bus.clearFaults();
                bus.expectTrue(finished);
                if (finished.stopped)
                    bus.expectAllStandSoon();
                const auto stop = bus.stopAll();
                ASSERT_TRUE(stop);
                EXPECT_EQ(stop->stopped.size(), 3U);
                bus.expectAllStandSoon();
            }
}

TEST(M27_SingleFaultAtAGroupStart, OfAMemberThatFallsSilentStopsTheOthers) {
    for (const bool leader : {false, true}) {
        FaultyGroup bus(servos(3), kFast);
        ASSERT_TRUE(bus.isLoaded(leader));
        bool out = false;
        bus.onCommand = [&](std::vector<std::uint8_t>& command) {
            out = out || (command.size() > 2 && command[1] == kGroup);
        };
        bus.losesReply = [&](ByteSpan command) { return out && command.size() > 2 && command[1] == 3; };
        const GroupFinished finished = bus.start(kGroup);
        bus.expectTrue(finished);
        EXPECT_EQ(finished.members[2].outcome, MemberOutcome::NoAnswer);
        EXPECT_TRUE(finished.stopped);
        bus.expectAllStandSoon();
    }
}

TEST(M27_SingleFaultAtAChangeOfGroup, NeverMakesTwoLeaders) {
    for (const char* fault :
         {"bus drop cmd on=set_address n=1", "bus flip cmd on=set_address n=1",
          "bus drop status on=set_address n=1", "bus silent on=set_address n=1",
          "bus cksum on=set_address n=1", "bus drop cmd on=set_address", "bus silent on=set_address",
          "bus cksum on=set_address", "module 2 silent on=set_address", "module 2 cksum on=set_address"})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            SCOPED_TRACE(testing::Message() << fault << ", " << seed);
            FaultyGroup bus(servos(3), kFast, seed);
            ASSERT_TRUE(bus.isLoaded(true));
            bus.fault(fault);
            const GroupFinished finished = bus.put(2, kGroup, true);
            bus.clearFaults();
            unsigned leaders = 0;
            for (std::uint8_t i = 0; i < 3; ++i) {
                const auto truth = bus.chain.snapshot(ModuleIndex(i), bus.now);
                EXPECT_EQ(truth.address, i + 1);
                leaders += truth.leader ? 1U : 0U;
            }
            EXPECT_LE(leaders, 1U);
            const bool leads = bus.chain.snapshot(ModuleIndex(2), bus.now).leader;
            EXPECT_FALSE(finished.outcome == Outcome::Done && !leads);
            bus.runFor(2s);
            const auto stop = bus.stopAll();
            ASSERT_TRUE(stop);
            EXPECT_EQ(stop->stopped.size(), 3U);
        }
}

/// Everything that concerns the chain as a whole, in any order and with any of the faults above.
TEST(M27_GroupsAndRates, InRandomSessionsNeverMakeTwoLeadersAndAlwaysStop) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        const auto below = [&](unsigned n) { return static_cast<std::uint8_t>(random() % n); };
        FaultyGroup bus(servos(3), seed % 2 == 0 ? kFast : 19'200, seed);
        ASSERT_TRUE(bus.isLoaded(seed % 3 == 0));
        bool twoLeaders = false;
        bus.onTime = [&] {
            unsigned leaders = 0;
            for (std::uint8_t i = 0; i < 3; ++i) {
                const auto truth = bus.chain.snapshot(ModuleIndex(i), bus.now);
                leaders += truth.leader && truth.group == kGroup ? 1U : 0U;
            }
            twoLeaders = twoLeaders || leaders > 1;
        };
        for (int i = 0; i < 12; ++i) {
            const std::uint8_t module = below(3);
            switch (below(8)) {
                case 0:
                    bus.submitGroup(GroupChange{ModuleIndex(module), {kGroup, below(2) == 0}});
                    break;
                case 1:
                    bus.submitGroup(GroupCommand{kGroup, GroupCommand::Action::StartMotion});
                    break;
                case 2:
                    bus.submitGroup(GroupCommand{kGroup, GroupCommand::Action::SaveAsHome});
                    break;
                case 3:
                    bus.engine.changeRate(kBaudRows[below(4)].nominal, bus.now);
                    break;
                case 4:
                    bus.engine.stopAll(bus.now);
                    break;
                case 5:
                    bus.fault(kSingleFaults[below(kSingleFaults.size())]);
                    break;
                case 6:
                    bus.engine.distrust(bus.now);
                    break;
                default:
                    bus.submit({loadMove(module, below(250) * 100)});
            }
            bus.runFor(std::chrono::milliseconds(below(120)));
        }
        bus.clearFaults();
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_EQ(stop->stopped.size(), 3U);
        bus.expectAllStandSoon();
        bus.runFor(3s);
        EXPECT_FALSE(twoLeaders);
        const auto samples = bus.samplesOf(0);
        bus.runFor(1s);
        EXPECT_GT(bus.samplesOf(0), samples + 3) << "the chain still answers, at " << bus.hostBaud;
    }
}

}  // namespace

}  // namespace nmc::test

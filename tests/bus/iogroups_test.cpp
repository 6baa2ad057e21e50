// SPDX-License-Identifier: GPL-3.0-or-later
// A PIC-I/O in a group: Start Motion is its Synch Output, Save as Home its Synch Input (docs/family.md).
#include <gtest/gtest.h>

#include "tests/bus/groups.h"

namespace nmc::test {
namespace {

using namespace bus;
using namespace std::chrono_literals;

/// A servo that is on and a PIC-I/O whose IO1 to IO4 are outputs, in one group; led by `leader`, if any.
class IoGroups : public testing::Test {
protected:
    static constexpr std::uint8_t kServo = 0;
    static constexpr std::uint8_t kIo = 1;

    void make(std::optional<std::uint8_t> leader = {}) {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(kServo), enable(kServo), told(io::SetDirection{0x0FF0}),
                               told(io::SetOutput{0x0001})}),
                  Outcome::Done);
        for (const std::uint8_t module : {kServo, kIo})
            ASSERT_EQ(bus.put(module, kGroup, leader == module).outcome, Outcome::Done);
    }
    [[nodiscard]] static Order told(const IoCommand& command) { return {ModuleIndex(kIo), command}; }
    [[nodiscard]] sim::IoSnapshot truth() { return *bus.chain.snapshot(ModuleIndex(kIo), bus.now).io; }

    GroupBus bus{{{ModuleType::Servo, 4}, {ModuleType::Io, 1}}};
};

TEST_F(IoGroups, PutsOutWhatWasStoredWhenTheMotorStarts) {
    make();
    ASSERT_EQ(bus.perform({loadMove(kServo, 20'000), told(io::SetSynchOutput{0x0006, 40, 50})}),
              Outcome::Done);
    EXPECT_EQ(truth().outputs & 0x000FU, 0x0001U);
    const GroupFinished finished = bus.start(kGroup);
    EXPECT_EQ(finished.outcome, Outcome::Done);
    EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(kServo), MemberOutcome::Done},
                                                          {ModuleIndex(kIo), MemberOutcome::Done}}));
    EXPECT_EQ(bus.sends("AA 81 05 86"), 1U) << "one packet for both";
    EXPECT_EQ(truth().outputs & 0x000FU, 0x0006U);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{40, 50}));
    bus.expectNoViolations();
}

TEST_F(IoGroups, NothingStartsWhileNothingIsStored) {
    make();
    ASSERT_EQ(bus.perform({loadMove(kServo, 20'000)}), Outcome::Done);
    const GroupFinished finished = bus.start(kGroup);
    EXPECT_EQ(finished.outcome, Outcome::Forbidden);
    EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(kIo), MemberOutcome::Withheld}}));
    EXPECT_EQ(bus.sends("AA 81"), 0U);
    EXPECT_EQ(truth().outputs & 0x000FU, 0x0001U);
}

TEST_F(IoGroups, AMemberThatDidNotHearIsTold) {
    make();
    ASSERT_EQ(bus.perform({loadMove(kServo, 20'000), told(io::SetSynchOutput{0x0006, 0, 0})}), Outcome::Done);
    bus.onCommand = [](std::vector<std::uint8_t>& packet) {
        if (packet.size() > 2 && packet[1] == kGroup && packet[2] == 0x05)
            packet.clear();
    };
    const GroupFinished finished = bus.start(kGroup);
    EXPECT_EQ(finished.members, (std::vector<GroupMember>{{ModuleIndex(kServo), MemberOutcome::NotDone},
                                                          {ModuleIndex(kIo), MemberOutcome::NotDone}}));
    EXPECT_EQ(truth().outputs & 0x000FU, 0x0001U);
}

/// PWM cannot be read back, and latched values are not polled: only a leader's answer shows that the command
/// was received.
TEST_F(IoGroups, WhatNobodyCanSeeALeaderConfirms) {
    make(kIo);
    ASSERT_EQ(bus.perform({loadMove(kServo, 20'000), told(io::SetSynchOutput{0x0001, 99, 0})}),
              Outcome::Done);
    const GroupFinished finished = bus.start(kGroup);
    EXPECT_EQ(finished.outcome, Outcome::Done);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{99, 0}));
}

TEST_F(IoGroups, LatchesItsInputsWhenHomesAreSaved) {
    make(kIo);
    bus.chain.set(ModuleIndex(kIo), sim::Input::Pin, 1.0, bus.now, 12);
    const GroupFinished finished =
        bus.finish(bus.submitGroup(GroupCommand{kGroup, GroupCommand::Action::SaveAsHome}));
    EXPECT_EQ(finished.outcome, Outcome::Done);
    EXPECT_EQ(truth().latchedPins & 0x0800U, 0x0800U);
    EXPECT_EQ(bus.sends("AA 81 0C 8D"), 1U);
    bus.expectNoViolations();
}

}  // namespace
}  // namespace nmc::test

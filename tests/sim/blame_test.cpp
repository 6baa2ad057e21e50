// SPDX-License-Identifier: GPL-3.0-or-later
// The effects of injected faults and of other hosts are not counted as violations of the host.
#include <gmock/gmock.h>

#include "sim/control.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using testing::IsEmpty;
using Kind = ViolationKind;
using Kinds = std::vector<Kind>;

class Blame : public testing::Test {
protected:
    Blame() { wire.address(2); }
    std::string say(const std::string& line) { return handleControlLine(wire.chain, line, wire.now); }
    /// Sends another command `after` sending `first`, whether or not its answer has arrived.
    void sendsBehind(const Bytes& first, Duration after) {
        wire.chain.hostSends(first, wire.now);
        wire.wait(after);
        wire.exchange(packet(2, 0x0E));
    }
    HostWire wire{"servo,servo", withFaults()};
};

TEST_F(Blame, NobodyIsForTwoModulesThatAFaultGaveOneAddress) {
    say("fault module 2,1 sameaddr");
    wire.command(2, 0x0E);
    ASSERT_EQ(wire.chain.statistics().modules[0].executions(CommandCode::Nop), 1U);
    EXPECT_THAT(wire.violations(), IsEmpty());
}

TEST_F(Blame, ClearingTheFaultGivesTheModuleItsOwnAddressBack) {
    say("fault module 2,1 sameaddr");
    ASSERT_EQ(wire.truth(1).address, 2);
    say("fault clear");
    EXPECT_EQ(wire.truth(1).address, 1);
    EXPECT_EQ(wire.truth(2).address, 2);
    EXPECT_EQ(wire.command(1, 0x0E), kIdle);

    say("fault module 2,1 sameaddr");
    wire.command(2, 0x21, {5, 0xFF});
    say("fault clear");
    EXPECT_EQ(wire.truth(1).address, 5) << "the host has assigned another address since";
    say("fault module 2,1 sameaddr");
    say("power-cycle 1");
    say("fault clear");
    EXPECT_EQ(wire.truth(1).address, 0);
}

TEST_F(Blame, NobodyIsForAReplyThatAFaultDelays) {
    say("fault module 1 delay t=50ms");
    sendsBehind(packet(1, 0x0E), milliseconds(20));
    EXPECT_THAT(wire.violations(), IsEmpty());
    say("fault clear");
    wire.wait(milliseconds(100));
    sendsBehind(packet(1, 0x13, {0x1F}), milliseconds(5));
    EXPECT_EQ(wire.violations(), Kinds{Kind::CommandInFlight}) << "without the fault";
}

TEST_F(Blame, NobodyIsForItemsThatAFaultDefined) {
    do {
        say("fault module 1 definestat");
    } while (wire.command(1, 0x0E).size() < 10);
    // Two bytes were expected, within 2.1 + 0.5 + 1.0 ms.
    sendsBehind(packet(1, 0x0E), milliseconds(4));
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
    EXPECT_THAT(wire.violations(), IsEmpty());
    wire.command(1, 0x12, {0x1F});
    sendsBehind(packet(1, 0x0E), milliseconds(4));
    EXPECT_EQ(wire.violations(), Kinds{Kind::CommandInFlight}) << "the host itself has defined these items";
}

TEST_F(Blame, NobodyIsForAReplyThatAFaultHasMadeLonger) {
    say("fault bus dup status");
    // An answer of 14 bytes has ended after 2.6 + 0.5 + 7.3 ms at the latest; here, one byte is doubled.
    sendsBehind(packet(1, 0x13, {0x1F}), milliseconds(9));
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
    EXPECT_THAT(wire.violations(), IsEmpty());
}

TEST_F(Blame, NobodyIsForCommandsThatFaultsHaveChanged) {
    for (const char* text : {"fault bus collide cmd p=0.5", "fault bus drop cmd p=0.1",
                             "fault bus dup cmd p=0.1", "fault module 2 garbage cmd p=0.1",
                             "fault bus noise cmd t=3ms..9ms", "fault module 1 overrun p=0.1"})
        say(text);
    for (int i = 0; i < 2'000; ++i) {
        wire.chain.hostSends(packet(1U + static_cast<unsigned>(i) % 2U, 0x13, {0x01}), wire.now);
        wire.wait(milliseconds(30));
    }
    EXPECT_THAT(wire.violations(), IsEmpty());
    std::uint64_t others = 0;
    for (const ModuleStatistics& module : wire.chain.statistics().modules)
        for (unsigned code = 0; code < 16; ++code)
            if (code != 3)
                others += module.executed[code];
    EXPECT_GT(others, 10U) << "commands that the host never sent";
}

TEST_F(Blame, NobodyIsForWhatAnotherHostSends) {
    say("foreign AA 01 17 0D 25");
    wire.wait(milliseconds(20));
    EXPECT_THAT(wire.violations(), IsEmpty()) << "two manners of stopping";
    say("foreign AA 01 13 1F 33");
    wire.wait(milliseconds(6));
    wire.exchange(packet(2, 0x0E));
    EXPECT_THAT(wire.violations(), IsEmpty()) << "the other host's reply was cut";
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
}

TEST_F(Blame, TheHostIsForWhatItDoesBetweenFaults) {
    say("fault bus drop cmd n=1");
    wire.command(1, 0x0E);
    say("fault clear");
    wire.exchange(Bytes(20, 0));  // back in step
    wire.command(1, 0x17, {0x0D});
    EXPECT_EQ(wire.violations(), Kinds{Kind::StopBits});
    say("fault bus flip p=0");
    wire.command(1, 0x17, {0x0D});
    EXPECT_EQ(wire.violations().size(), 2U) << "a fault that does not strike";
    wire.command(1, 0x21, {1, 0x01});
    wire.command(2, 0x21, {2, 0x01});
    wire.command(0x81, 0x0E);
    EXPECT_EQ(wire.violations().size(), 4U) << "two leaders";
}

}  // namespace
}  // namespace nmc::sim::test

// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 3 and 5, the answers of a stepper, and the commands that do not cause motion: the simulator's
// behaviour beyond the statements, which tests/conformance covers.
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using Kinds = std::vector<ViolationKind>;

TEST(StepperStatus, RepliesBeginWithinATickOfTheCommandsEnd) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        ChainOptions options;
        options.seed = seed;
        StepperWire wire("step", options);
        const TimePoint sent = wire.now;
        const auto reply = wire.exchange(packet(1, 0x0E));
        ASSERT_EQ(reply.size(), 2U);
        // Four bytes of 520.8 us out, the first byte of 512 us (19 531 Bd) in.
        const Duration begin = reply[0].due - std::chrono::microseconds(512) - sent;
        EXPECT_GT(begin, std::chrono::microseconds(2083));
        EXPECT_LT(begin, std::chrono::microseconds(2084 + 512));
    }
}

TEST(StepperCommands, ThereIsNoClearStickyBits) {
    StepperWire wire;
    EXPECT_EQ(wire.command(1, 0x0B).size(), 2U);
    EXPECT_EQ(wire.violations(), Kinds{ViolationKind::UnknownCommand});
}

TEST(StepperCommands, ResetPositionOnTheGoalEndsTheMove) {
    StepperWire wire;
    wire.parameters(k1x);
    wire.load({.count = kCount});
    wire.wait(milliseconds(200));
    wire.stop(0x05);
    wire.load({.position = 0, .count = kCount});
    wire.waitTicks(20);
    wire.command(1, 0x00);
    EXPECT_FALSE(wire.step().moving);
    EXPECT_EQ(wire.position(), 0);
}

TEST(StepperCommands, ValuesOutsideTheirRangeAreViolations) {
    StepperWire wire;
    wire.parameters(k1x, 251);
    wire.parameters(k1x, 0);
    wire.load({.speed = std::uint8_t{251}, .acceleration = std::uint8_t{1}});
    wire.wait(milliseconds(200));
    EXPECT_EQ(wire.step().speed, 250U);
    wire.load({.speed = std::uint8_t{0}, .acceleration = std::uint8_t{0}});
    EXPECT_EQ(wire.violations(), Kinds(5, ViolationKind::OutOfRange));
    wire.command(1, 0x34, {0x82, 9, 9});
    EXPECT_EQ(wire.violations().back(), ViolationKind::WrongLength);
}

TEST(StepperCommands, StartMotionWithNothingLoadedDoesNothing) {
    StepperWire wire;
    wire.parameters(k1x);
    wire.command(1, 0x05);
    EXPECT_FALSE(wire.step().moving);
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST(StepReset, ToAddressFFIsObeyedWhateverTheGroupUnlikeAServo) {
    HostWire wire("step,servo");
    ASSERT_EQ(wire.command(0, 0x21, {1, 0x85}).size(), 2U);
    ASSERT_EQ(wire.command(0, 0x21, {2, 0x85}).size(), 2U);
    Bytes wrong = packet(0xFF, 0x0F);
    wrong.back() ^= 1;
    EXPECT_TRUE(wire.exchange(wrong).empty());
    EXPECT_EQ(wire.truth(1).address, 1);
    EXPECT_TRUE(wire.command(0xFF, 0x0E).empty()) << "no other command to FF is for it";
    EXPECT_EQ(wire.chain.statistics().modules[0].executions(CommandCode::Nop), 0U);
    EXPECT_TRUE(wire.command(0xFF, 0x0F).empty());
    EXPECT_EQ(wire.truth(1).address, 0);
    EXPECT_EQ(wire.truth(1).group, 0xFF);
    EXPECT_EQ(wire.truth(2).address, 2);
}

}  // namespace
}  // namespace nmc::sim::test

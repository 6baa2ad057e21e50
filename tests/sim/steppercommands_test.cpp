// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 3 and 5: the answers of a stepper, and the commands that do not cause motion.
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using Kinds = std::vector<ViolationKind>;

TEST(StepperStatus, AfterPowerUpTheReplyIsStatusAndSum) {
    HostWire wire("step");
    EXPECT_EQ(wire.command(0, 0x21, {1, 0xFF}), (Bytes{0x08, 0x08})) << "power, and nothing else";
    EXPECT_EQ(wire.command(1, 0x17, {0x01}), (Bytes{0x0C, 0x0C}));
    EXPECT_EQ(wire.command(1, 0x17, {0x00}), (Bytes{0x08, 0x08}));
}

TEST(StepperStatus, TheTypeIs3AndTheVersion1) {
    StepperWire wire;
    EXPECT_EQ(wire.command(1, 0x13, {0x20}), (Bytes{0x0C, 3, 1, 0x10}));
    EXPECT_EQ(wire.command(1, 0x0E).size(), 2U) << "Read Status applies only once";
    EXPECT_EQ(wire.command(1, 0x12, {0x24}).size(), 6U)
        << "the answer to Define Status already has its items";
    EXPECT_EQ(wire.command(1, 0x0E).size(), 6U);
}

TEST(StepperStatus, ItemsComeInTheirOrder) {
    StepperWire wire;
    wire.parameters(k1x);
    wire.load({.position = 0x0102, .count = std::uint16_t{0xFD91}});  // 1000/s
    static_cast<void>(wire.timeToStop());
    wire.command(1, 0x0C);
    wire.set(Input::In1, 1);
    wire.set(Input::HomeSwitch, 1);
    wire.set(Input::Analog, 0x55);
    const Bytes expected{0x0C, 0x02, 0x01, 0, 0, 0x55, 0x91, 0xFD, 0x22, 0x02, 0x01, 0, 0, 3, 1};
    Bytes reply = wire.command(1, 0x13, {0x3F});
    ASSERT_EQ(reply.size(), expected.size() + 1);
    reply.pop_back();
    EXPECT_EQ(reply, expected);
    EXPECT_EQ(wire.command(1, 0x13, {0x09}).size(), 7U);
}

TEST(StepperStatus, TheInputsByteHasABitForEachInput) {
    StepperWire wire;
    const Input inputs[] = {Input::Estop,  Input::In1,    Input::In2,
                            Input::Limit1, Input::Limit2, Input::HomeSwitch};
    for (std::size_t i = 0; i < 6; ++i) {
        wire.set(inputs[i], 1);
        EXPECT_EQ(wire.stepReport().inputs, 1U << i);
        wire.set(inputs[i], 0);
    }
}

TEST(StepperStatus, AWrongSumIsAnsweredWithTheErrorBitAndNotExecuted) {
    StepperWire wire;
    Bytes wrong = packet(1, 0x17, {0x00});
    wrong.back() ^= 1;
    EXPECT_EQ(values(wire.exchange(wrong)), (Bytes{0x0E, 0x0E}));
    EXPECT_EQ(wire.command(1, 0x0E), (Bytes{0x0C, 0x0C}));
}

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

TEST(StepperCommands, ResetPositionIsForStandstill) {
    StepperWire wire;
    wire.parameters(k1x);
    wire.load({.count = kCount});
    wire.wait(milliseconds(100));
    wire.stop(0x05);
    EXPECT_GT(wire.position(), 90);
    wire.command(1, 0x00);
    EXPECT_EQ(wire.position(), 0);
    EXPECT_EQ(wire.violations(), Kinds{});
    wire.load({.count = kCount});
    wire.command(1, 0x00);
    EXPECT_EQ(wire.violations(), Kinds{ViolationKind::ResetInMotion});
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

TEST(StepperCommands, AGoalIsNoFartherThan7FFFFFFFFromZeroNorFromWhereTheMotorStands) {
    StepperWire wire;
    wire.parameters(k8x, 250);
    wire.load({.position = -0x7FFFFFFF, .start = false});
    EXPECT_EQ(wire.violations(), Kinds{});
    wire.load({.position = -0x7FFFFFFF - 1, .start = false});
    EXPECT_EQ(wire.violations(), Kinds{ViolationKind::OutOfRange});
    wire.load({.position = -1, .speed = std::uint8_t{250}, .acceleration = std::uint8_t{1}});
    static_cast<void>(wire.timeToStop());
    wire.load({.position = 0x7FFFFFFE, .start = false});
    EXPECT_EQ(wire.violations().size(), 1U);
    wire.load({.position = 0x7FFFFFFF, .start = false});
    EXPECT_EQ(wire.violations(), Kinds(2, ViolationKind::OutOfRange));
}

TEST(StepperCommands, StartMotionExecutesTheLatestLoadInAGroupAtOnce) {
    StepperWire wire("step,step");
    wire.command(1, 0x21, {1, 0x01});
    ASSERT_EQ(wire.command(0, 0x21, {2, 0x81}).size(), 2U);
    for (const unsigned module : {1U, 2U}) {
        wire.command(module, 0x56, {k1x, 1, 0, 0, 0});
        wire.command(module, 0x44, {0x08, 0x91, 0xFD, 40});
    }
    EXPECT_EQ(wire.command(1, 0x05).size(), 2U);
    wire.stop(0x05);
    EXPECT_EQ(wire.command(0x81, 0x05).size(), 2U) << "the leader answers";
    wire.wait(milliseconds(500));
    EXPECT_NEAR(wire.truth(1).stepper->position, wire.truth(2).stepper->position, 10);
    EXPECT_GT(wire.truth(2).stepper->position, 490);
    EXPECT_EQ(wire.violations(), Kinds{});
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

TEST(StepReset, LosesPositionMotionAndAmplifier) {
    StepperWire wire;
    wire.parameters(k1x);
    wire.load({.count = kCount});
    wire.wait(milliseconds(100));
    EXPECT_TRUE(wire.command(1, 0x0F).empty());
    const StepperSnapshot s = wire.step();
    EXPECT_EQ(s.position, 0);
    EXPECT_FALSE(s.moving);
    EXPECT_FALSE(s.ampEnabled);
    EXPECT_EQ(s.currentLimit, 0);
}

}  // namespace
}  // namespace nmc::sim::test

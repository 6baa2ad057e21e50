// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 4.1: packets, sums, replies and the buffer; 5.1, what is allowed while moving.
#include <algorithm>
#include <numeric>

#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

const Bytes kNop = packet(1, 0x0E);
/// Ten bits at 19 200 Bd, rounded up.
constexpr Duration kHostByte = std::chrono::nanoseconds(520'834);

TEST_P(PicServo, Protocol1_TheDefaultRateIs19200WithTenBitsPerByte) {
    EXPECT_EQ(truth("baud"), 19'531) << "1 250 000 / 64, the chip's nearest";
    rig->send(kNop);
    rig->wait(4 * kHostByte);
    // The reply's two bytes take 2 * 10 / 19 531 s, and it begins within a tick.
    Bytes answer = rig->wait(microseconds(1'023));
    EXPECT_LT(answer.size(), 2U) << "not yet";
    EXPECT_EQ(answer + rig->wait(kTick + microseconds(2)), kIdle);
}

TEST_P(PicServo, Protocol2_BytesBeforeTheHeaderAreIgnored) {
    EXPECT_EQ(rig->exchange(Bytes{0x00, 0x55, 0x01, 0x0E, 0x0F, 0xFF} + kNop), kIdle);
    EXPECT_EQ(statistics("executed")["nop"], 1);
    EXPECT_EQ(statistics("checksum_errors"), 0);
}

TEST_P(PicServo, Protocol3_AHeaderWithinAPacketIsData) {
    EXPECT_EQ(command(0x21, {0xAA, 0xFF}).size(), 2U);
    EXPECT_EQ(rig->command(0xAA, 0x0E), kIdle);
    expectNoViolation();
}

TEST_P(PicServo, Protocol4_TheSecondByteIsTheAddressOfTheModuleOrOfItsGroup) {
    start("servo,servo", 2);
    rig->command(2, 0x21, {2, 0x90});
    EXPECT_EQ(rig->command(2, 0x0C).size(), 2U);
    EXPECT_EQ(rig->command(0x90, 0x0C).size(), 0U);
    EXPECT_EQ(rig->command(3, 0x0C).size(), 0U);
    EXPECT_EQ(statistics("executed", 2)["save_as_home"], 2);
    EXPECT_FALSE(statistics("executed", 1).contains("save_as_home"));
}

TEST_P(PicServo, Protocol5_TheCommandBytesLowNibbleIsTheCommand) {
    const std::vector<std::pair<unsigned, std::string>> kOneByteCommands{
        {2, "define_status"}, {3, "read_status"}, {7, "stop_motor"}, {8, "io_control"}, {9, "set_homing"}};
    const std::vector<std::pair<unsigned, std::string>> kBareCommands{{0, "reset_position"},
                                                                      {5, "start_motion"},
                                                                      {0xB, "clear_sticky_bits"},
                                                                      {0xC, "save_as_home"},
                                                                      {0xE, "nop"}};
    for (const auto& [code, name] : kOneByteCommands) {
        command(0x10 | code, {0});
        EXPECT_EQ(statistics("executed")[name], 1) << name;
    }
    for (const auto& [code, name] : kBareCommands) {
        command(code);
        EXPECT_EQ(statistics("executed")[name], 1) << name;
    }
    expectNoViolation();
}

TEST_P(PicServo, Protocol6_TheCommandBytesHighNibbleIsTheNumberOfDataBytes) {
    const Bytes gains = packet(1, 0xE6, gainBytes({.kp = 256}));
    for (std::size_t i = 0; i + 1 < gains.size(); ++i)
        ASSERT_EQ(rig->exchange({gains[i]}), Bytes{}) << "it waits for all 14";
    EXPECT_EQ(rig->exchange({gains.back()}), kIdle);
    EXPECT_EQ(truth("gains")["kp"], 256);
    Bytes thirteen = gainBytes({.kp = 512});
    thirteen.pop_back();
    EXPECT_EQ(command(0xD6, thirteen), kIdle);
    EXPECT_EQ(truth("gains")["kp"], 512);
}

TEST_P(PicServo, Protocol7_TheSumIsOfTheAddressByteThroughTheLastDataByteIn8Bits) {
    // 01 + 21 + FE + FF = 21F.
    EXPECT_EQ(rig->exchange({0xAA, 0x01, 0x21, 0xFE, 0xFF, 0x1F}), kIdle);
    EXPECT_EQ(truth("address"), 0xFE);
}

TEST_P(PicServo, Protocol8_AWrongSumIsAnsweredButNotExecuted) {
    const Bytes answer = rig->exchange({0xAA, 0x01, 0x12, 0x3F, 0x53});
    EXPECT_EQ(answer, (Bytes{0x1B, 0x1B}));
    EXPECT_EQ(command(0x0E), kIdle) << "the items have not changed";
    EXPECT_EQ(statistics("checksum_errors"), 1);
}

TEST_P(PicServo, Protocol9_AnotherCommunicationErrorIsAnsweredButNotExecutedEither) {
    // 9 600 Bd against 10 000 is 4.0 % off: some bytes are received wrong. Nulls after each command let the
    // module find the next header.
    constexpr int kCommands = 400;
    const auto answers = [this] {
        return statistics("replies").get<int>() + statistics("replies_dropped").get<int>();
    };
    command(0x21,
            {1, 0x7F});  // as a leader, it also answers commands that a wrong address sends to the group
    rig->command(0xFF, 0x1A, {124});
    rig->setBaud(9'600);
    const int before = answers();
    for (int i = 0; i < kCommands; ++i) {
        command(0x12, {0x00});
        rig->exchange(Bytes(16, 0x00));
    }
    const int executed = statistics("executed")["define_status"];
    const int errors = statistics("checksum_errors");
    EXPECT_GT(errors, 0);
    EXPECT_LT(executed, kCommands);
    EXPECT_EQ(answers() - before, executed + errors);
}

TEST_P(PicServo, Protocol10_ACommandIsExecutedAndAnsweredAtTheEndOfTheTick) {
    start("servo", 1, {"--unpaced"});
    for (int i = 0; i < 20; ++i) {
        rig->send(kNop);
        EXPECT_EQ(rig->wait(microseconds(2'083)), Bytes{}) << "not before its last byte has arrived";
        EXPECT_EQ(rig->wait(microseconds(1) + kTick), kIdle);
        rig->wait(microseconds(37 * i));  // another phase of the tick
    }
}

TEST_P(PicServo, Protocol11_AMotionCommandIsAnsweredAtOnce) {
    servoOn();
    rig->send(packet(1, 0xD4, Bytes{0x97} + position(100'000) + little(kOne, 4) + little(kOne, 4)));
    EXPECT_EQ(rig->wait(17 * kHostByte + kTick + milliseconds(2)).size(), 2U);
    EXPECT_LT(number("command_position"), 10);
}

TEST_P(PicServo, Protocol12_TheReplyIsTheStatusByteTheItemsAndTheir8BitSum) {
    turnAway();
    rig->must("set 1 analog 200");
    const Bytes answer = command(0x13, {0x3F});
    ASSERT_EQ(answer.size(), 16U);
    EXPECT_EQ(answer[0], 0x19);
    const Bytes summed(answer.begin(), answer.end() - 1);
    EXPECT_GT(std::accumulate(summed.begin(), summed.end(), 0), 0xFF);
    EXPECT_EQ(Bytes{answer.back()}, sumOf(summed));
}

TEST_P(PicServo, Protocol13_DataFromTheHostStopTheReplyAndAreHeard) {
    start("servo,servo", 2);
    command(0x12, {0x3F});
    rig->send(kNop);
    // This covers the command (2.1 ms), the tick (0.5 ms) and some of the reply (16 * 0.5 ms).
    const std::size_t before = rig->wait(milliseconds(5)).size();
    EXPECT_GT(before, 2U);
    const std::size_t after = rig->exchange(packet(2, 0x17, {0x00})).size();
    EXPECT_GT(after, 2U) << "module 2 has answered";
    EXPECT_LT(before + after, 16U) << "module 1 has not continued";
    EXPECT_EQ(statistics("replies_dropped", 1), 1);
    EXPECT_EQ(statistics("executed", 2)["stop_motor"], 1);
}

TEST_P(PicServo, Protocol14_NoNewCommandIsSentBeforeTheStatusPacket) {
    rig->exchange(kNop);
    rig->exchange(kNop);
    expectNoViolation();
    rig->exchange(kNop + kNop);
    expectViolation("command_in_flight");
}

TEST_P(PicServo, Protocol15_ACommandTooSoonOverwritesTheOneBefore) {
    rig->command(0xFF, 0x1A, {10});
    rig->setBaud(115'200);
    // Four bytes take 0.35 ms, less than a tick.
    Bytes burst;
    for (int i = 0; i < 30; ++i)
        burst = burst + packet(0xFF, 0x0E);
    rig->exchange(burst);
    EXPECT_LT(statistics("executed")["nop"], 30);
    const std::vector<std::string> kinds = rig->violations();
    EXPECT_EQ(30 - statistics("executed")["nop"].get<int>(),
              std::count(kinds.begin(), kinds.end(), "command_overwritten"));
}

TEST_P(PicServo, Protocol16_HalfAMillisecondAfterAGroupCommandIsEnough) {
    rig->command(0xFF, 0x1A, {10});
    rig->setBaud(115'200);
    for (int i = 0; i < 30; ++i) {
        rig->send(packet(0xFF, 0x0E));
        rig->wait(4 * microseconds(87) + kTick);
    }
    EXPECT_EQ(statistics("executed")["nop"], 30);
    expectNoViolation();
}

TEST_P(PicServo, Protocol17_SixteenNullsFillAPartiallyFilledBuffer) {
    rig->exchange({0xAA, 0x01, 0xE6});  // requires 14 data bytes and a sum
    rig->exchange(Bytes(16, 0x00));
    EXPECT_EQ(rig->exchange(kNop), kIdle);
    EXPECT_EQ(truth("gains")["sr"], 1) << "the sum was wrong";
}

TEST_P(PicServo, WhileMoving1_ResetPositionIsNotAllowed) {
    servoOn();
    trapezoid(10'000, kOne, kOne);
    command(0x00);
    expectViolation("reset_in_motion");
}

TEST_P(PicServo, WhileMoving2_LoadTrajectoryIsAllowedWithoutStartOrInVelocityMode) {
    servoOn();
    trapezoid(10'000, kOne, kOne);
    load(kServo | kLoadPosition, position(500));
    velocity(2 * kOne, kOne);
    expectNoViolation();
    load(kServo | kLoadPosition | kStart, position(500));
    expectViolation("trapezoid_in_motion");
    for (const bool profile : {false, true}) {
        start("servo", 1);
        servoOn();
        if (profile)
            velocity(kOne, kOne);
        else
            trapezoid(10'000, kOne, kOne);
        load(kLoadPwm, {40});
        expectNoViolation();
        pwm(40);
        expectViolation("trapezoid_in_motion");
        pwm(30);
        expectViolation("trapezoid_in_motion");  // no further one: the servo is off
    }
}

TEST_P(PicServo, WhileMoving3_StartMotionIsAllowedInVelocityModeOnly) {
    servoOn();
    velocity(kOne, kOne);
    velocity(2 * kOne, kOne, 0);
    command(0x05);
    expectNoViolation();
    load(kServo | kLoadPosition, position(500));
    command(0x05);
    expectViolation("trapezoid_in_motion");
    load(kLoadPwm, {40});
    command(0x05);
    EXPECT_EQ(rig->violations(), (std::vector<std::string>{"trapezoid_in_motion", "trapezoid_in_motion"}));
}

TEST_P(PicServo, WhileMoving4_EveryOtherCommandIsAllowed) {
    servoOn();
    trapezoid(10'000, kOne, kOne);
    command(0x21, {1, 0xFF});
    command(0x12, {0x01});
    command(0x13, {0x3F});
    gains(kGoodGains);
    command(0x18, {0x0C});
    homing(0x01);
    rig->command(0xFF, 0x1A, {64});
    command(0x0B);
    command(0x0C);
    command(0x0E);
    EXPECT_EQ(number("command_velocity"), 1) << "the move has continued";
    stop(kAmplifier | kSmoothly);
    command(0x0F);
    expectNoViolation();
}

}  // namespace
}  // namespace nmc::conformance

// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of protocol.md section 4, and those printed in section 5.2 of the data sheet of PIC-SERVO SC:
// bytes that came from data sheets and host programs, not from our encoder.
#include <gtest/gtest.h>

#include "protocol/commands.h"
#include "protocol/frame.h"
#include "protocol/takes.h"
#include "tests/support/hexbytes.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing_support::fromHex;
using testing_support::kSc;
using testing_support::kServo;

struct Golden {
    std::string name;
    std::string hex;
    std::uint8_t address;
    ServoCommand command;
};

servo::LoadTrajectory trapezoid() {
    servo::LoadTrajectory load;
    load.position = Counts(-1024);
    load.velocity = CountsPerTick(100'000);
    load.acceleration = CountsPerTickSquared(100);
    load.startNow = true;
    return load;
}

servo::LoadTrajectory velocity() {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(100'000);
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = true;
    load.startNow = true;
    return load;
}

servo::LoadTrajectory pwm() {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(100'000);
    load.acceleration = CountsPerTickSquared(100);
    load.pwm = std::uint8_t{0};
    load.servo = false;
    load.startNow = true;
    return load;
}

servo::SetHoming homing() {
    servo::SetHoming set;
    set.onLimit1Change = set.onLimit2Change = set.stopAbruptly = true;
    return set;
}

const std::vector<Golden>& goldenFrames() {
    static const std::vector<Golden> frames{
        {"ResetPosition", "AA 01 00 01", 1, ResetPosition{}},
        {"Start", "AA 01 05 06", 1, StartMotion{}},
        {"Nop", "AA 01 0E 0F", 1, Nop{}},
        {"AddressMember", "AA 00 21 01 81 A3", 0, SetAddress{BusAddress(1), BusAddress(0x81), false}},
        {"AddressLeader", "AA 01 21 01 01 24", 1, SetAddress{BusAddress(1), BusAddress(0x81), true}},
        {"ReadTypeAndVersion", "AA 01 13 20 34", 1, ReadStatus{StatusItems(StatusItems::Identity)}},
        {"MotorOff", "AA 01 17 02 1A", 1, servo::StopMotor{false, servo::StopManner::MotorOff, {}}},
        {"SmoothAmplifierOn", "AA 01 17 09 21", 1, servo::StopMotor{true, servo::StopManner::Smoothly, {}}},
        {"StopHere", "AA 01 57 11 64 00 00 00 CD", 1,
         servo::StopMotor{true, servo::StopManner::Here, Counts(100)}},
        {"Trapezoid", "AA 01 D4 97 00 FC FF FF A0 86 01 00 64 00 00 00 F1", 1, trapezoid()},
        {"Velocity", "AA 01 54 F2 A0 86 01 00 6E", 1, velocity()},
        {"Pwm", "AA 01 A4 8E A0 86 01 00 64 00 00 00 00 BE", 1, pwm()},
        {"Home", "AA 01 19 13 2D", 1, homing()},
        {"AllTo115200", "AA FF 1A 0A 23", 0xFF, SetBaud{10}},
        {"ClearStickyBits", "AA 01 0B 0C", 1, servo::ClearStickyBits{}},
        {"SaveAsHomeGroup", "AA 81 0C 8D", 0x81, SaveAsHome{}},
        {"ResetAll", "AA FF 0F 0E", 0xFF, HardReset{}},
    };
    return frames;
}

class GoldenFrames : public testing::TestWithParam<Golden> {};

TEST_P(GoldenFrames, EncodeToTheseBytes) {
    const Golden& golden = GetParam();
    const PacketBytes bytes = toPacket({BusAddress(golden.address), encode(golden.command)});
    EXPECT_EQ(toHex(bytes), golden.hex);
}

TEST_P(GoldenFrames, DecodeToTheirMeaning) {
    const Golden& golden = GetParam();
    const auto frame = parsePacket(fromHex(golden.hex));
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->address.value(), golden.address);
    const auto command = decodeServoCommand(kServo, frame->payload);
    ASSERT_TRUE(command.has_value());
    EXPECT_EQ(*command, golden.command);
}

TEST_P(GoldenFrames, SayTheSameToAnSc) {
    // The sheet of PIC-SERVO SC prints the same frames.
    const Golden& golden = GetParam();
    const auto command = decodeServoCommand(kSc, encode(golden.command));
    ASSERT_TRUE(command.has_value());
    EXPECT_EQ(*command, golden.command);
    EXPECT_TRUE(takes(kSc, golden.command));
}

INSTANTIATE_TEST_SUITE_P(ProtocolPage, GoldenFrames, testing::ValuesIn(goldenFrames()),
                         [](const auto& golden) { return golden.param.name; });

servo::SetGain scGains() {
    return {100, 1'000, 50, 200, 0xFF, 0x35, 4'000, 1, std::uint8_t{0}, std::uint8_t{5}};
}

servo::ScIoControl threePhaseSteps() {
    servo::ScIoControl control;
    control.threePhase = control.stepAndDirection = true;
    return control;
}

servo::AddPathPoints fourPoints() {
    const std::array<servo::PathPoint, 4> points{{{-100, servo::PathRate::Hz60},
                                                  {-101, servo::PathRate::Hz60},
                                                  {-102, servo::PathRate::Hz60},
                                                  {-103, servo::PathRate::Hz60}}};
    return servo::AddPathPoints::of(points, false).value();
}

servo::HardReset saved() {
    servo::HardReset reset;
    reset.save = reset.restoreAddresses = reset.amplifierOn = reset.servoOn = true;
    reset.stepAndDirection = reset.threePhase = true;
    return reset;
}

/// The frames of the PIC-SERVO SC data sheet that are not in the first data sheet.
const std::vector<Golden>& scFrames() {
    static const std::vector<Golden> frames{
        {"ResetRelativeToHome", "AA 01 10 01 12", 1, servo::ResetRelativeToHome{}},
        {"SetPosition", "AA 01 50 02 A2 32 54 01 7C", 1, servo::SetPosition{Counts(0x015432A2)}},
        {"DefinePositionAndError", "AA 01 12 41 54", 1,
         DefineStatus{StatusItems(StatusItems::Position | StatusItems::PositionError)}},
        {"Gains", "AA 01 F6 64 00 E8 03 32 00 C8 00 FF 35 A0 0F 01 00 05 29", 1, scGains()},
        {"IoControl", "AA 01 18 90 A9", 1, threePhaseSteps()},
        {"PathPoints", "AA 01 8D 21 03 29 03 31 03 39 03 4E", 1, fourPoints()},
        {"StartPath", "AA 81 0D 8E", 0x81, servo::AddPathPoints{}},
        {"Save", "AA 01 1F 5F 7F", 1, saved()},
        {"Erase", "AA 01 1F 00 20", 1, servo::HardReset{}},
    };
    return frames;
}

class ScFrames : public testing::TestWithParam<Golden> {};

TEST_P(ScFrames, EncodeToTheseBytes) {
    const Golden& golden = GetParam();
    EXPECT_EQ(toHex(toPacket({BusAddress(golden.address), encode(golden.command)})), golden.hex);
}

TEST_P(ScFrames, DecodeToTheirMeaning) {
    const Golden& golden = GetParam();
    const auto frame = parsePacket(fromHex(golden.hex));
    ASSERT_TRUE(frame.has_value());
    const auto command = decodeServoCommand(kSc, frame->payload);
    ASSERT_TRUE(command.has_value());
    EXPECT_EQ(*command, golden.command);
    EXPECT_TRUE(takes(kSc, golden.command));
}

INSTANTIATE_TEST_SUITE_P(ScSheet, ScFrames, testing::ValuesIn(scFrames()),
                         [](const auto& golden) { return golden.param.name; });

TEST(GoldenReply, HasNineteenBytesOnAnSc) {
    // All items, put together by hand: position 1000, A/D 20, velocity +3, servo on and slewing, home -1,
    // type 0 version 10, error -2, 5 path points.
    std::vector<std::uint8_t> reply = fromHex("09 E8 03 00 00 14 03 00 14 FF FF FF FF 00 0A FE FF 05");
    reply.push_back(sum8(reply));
    ASSERT_EQ(reply.size(), 19U);
    const auto report = decodeStatus(kSc, StatusItems(0xFF), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->position, 1'000);
    EXPECT_EQ(report->analog, 20);
    EXPECT_EQ(report->velocity, 3);
    EXPECT_EQ(report->aux, 0b0001'0100);  // as on the wire
    EXPECT_EQ(report->home, -1);
    EXPECT_EQ(report->identity, kSc);
    EXPECT_EQ(report->positionError, -2);
    EXPECT_EQ(report->pathPoints, 5);
}

TEST(DataSheetExample, LoadPositionAndAcceleration) {
    // DS-V 5.2 Load Trajectory: "the command byte would be 0x94, the control byte would be 0x15".
    servo::LoadTrajectory load;
    load.position = Counts(1);
    load.acceleration = CountsPerTickSquared(2);
    const Payload payload = encode(load);
    EXPECT_EQ(payload.commandByte(), 0x94);
    EXPECT_EQ(toHex(payload.data), "15 01 00 00 00 02 00 00 00");
}

TEST(GoldenReply, IdleServoWithItems1F) {
    const auto reply = fromHex("11 22 25 00 00 4F 00 00 18 E0 05 00 00 A4");
    const auto report = decodeStatus(kServo, StatusItems(0x1F), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_TRUE(report->servoStatus().moveDone());
    EXPECT_TRUE(report->servoStatus().positionError());
    EXPECT_FALSE(report->servoStatus().powerOn());
    EXPECT_EQ(report->position, 0x2522);
    EXPECT_EQ(report->analog, 0x4F);
    EXPECT_EQ(report->velocity, 0);
    EXPECT_EQ(report->aux, 0x18);
    EXPECT_EQ(report->home, 0x05E0);
    EXPECT_FALSE(report->identity.has_value());
}

}  // namespace
}  // namespace nmc

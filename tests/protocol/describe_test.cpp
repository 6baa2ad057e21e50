// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of protocol.md section 4, and bytes put together by hand from the data sheets' tables, each with
// the sentence a reader of the sheet would write beside it.
#include "protocol/describe.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <sstream>

namespace nmc {
namespace {

std::vector<std::uint8_t> fromHex(const std::string& text) {
    std::vector<std::uint8_t> bytes;
    std::istringstream stream(text);
    for (unsigned byte = 0; stream >> std::hex >> byte;)
        bytes.push_back(static_cast<std::uint8_t>(byte));
    return bytes;
}

std::string servoSays(const std::string& hex) {
    return describeCommand(ModuleType::Servo, fromHex(hex));
}
std::string stepSays(const std::string& hex) {
    return describeCommand(ModuleType::Step, fromHex(hex));
}

struct Row {
    std::string hex;
    std::string text;
};

TEST(DescribeCommand, SaysWhatTheGoldenFramesSay) {
    // 100 000 / 65 536 = 1.52588, 100 / 65 536 = 0.00152588.
    for (const Row& row : std::vector<Row>{
             {"AA 01 00 01", "Reset Position"},
             {"AA 01 05 06", "Start Motion"},
             {"AA 01 0E 0F", "No Operation"},
             {"AA 00 21 01 81 A3", "Set Address: address 1, group 81, member"},
             {"AA 01 21 01 01 24", "Set Address: address 1, group 81, leader"},
             {"AA 01 13 20 34", "Read Status: type, version"},
             {"AA 01 17 02 1A", "Stop Motor: motor off, amplifier off"},
             {"AA 01 17 09 21", "Stop Motor: stop smoothly, amplifier on"},
             {"AA 01 57 11 64 00 00 00 CD", "Stop Motor: stop here, position 100, amplifier on"},
             {"AA 01 D4 97 00 FC FF FF A0 86 01 00 64 00 00 00 F1",
              "Load Trajectory: position -1024, velocity 1.52588, acceleration 0.00152588, trapezoidal, "
              "start now"},
             {"AA 01 54 F2 A0 86 01 00 6E",
              "Load Trajectory: velocity 1.52588, velocity mode, reverse, start now"},
             {"AA 01 A4 8E A0 86 01 00 64 00 00 00 00 BE",
              "Load Trajectory: velocity 1.52588, acceleration 0.00152588, PWM 0, PWM mode, start now"},
             {"AA 01 19 13 2D", "Set Homing Mode: change of limit1, change of limit2, stop abruptly"},
             {"AA FF 1A 0A 23", "Set Baud Rate: code 10, 115200 Bd"},
             {"AA 01 0B 0C", "Clear Sticky Bits"},
             {"AA 81 0C 8D", "Save Current Position as Home"},
             {"AA FF 0F 0E", "Hard Reset"},
         })
        EXPECT_EQ(servoSays(row.hex), row.text) << row.hex;
}

TEST(DescribeCommand, SaysTheOtherCommandsOfAServo) {
    // Kp 200 = 00C8, Kd 2000 = 07D0, Ki 20 = 0014, IL 200 = 00C8, OL FF, CL 0, EL 8000 = 1F40, SR 1, DB 0.
    for (const Row& row : std::vector<Row>{
             {"AA 01 E6 C8 00 D0 07 14 00 C8 00 FF 00 40 1F 01 00 C1",
              "Set Gain: Kp 200, Kd 2000, Ki 20, IL 200, OL 255, CL 0, EL 8000, SR 1, DB 0"},
             {"AA 01 D6 C8 00 D0 07 14 00 C8 00 FF 00 40 1F 01 B1",
              "Set Gain: Kp 200, Kd 2000, Ki 20, IL 200, OL 255, CL 0, EL 8000, SR 1"},
             {"AA 01 12 00 13", "Define Status: status byte only"},
             {"AA 01 13 03 17", "Read Status: position, A/D value"},
             {"AA 01 12 1D 30", "Define Status: position, velocity, auxiliary status, home position"},
             {"AA 01 17 01 19", "Stop Motor: amplifier on"},
             {"AA 01 17 05 1D", "Stop Motor: stop abruptly, amplifier on"},
             {"AA 01 18 0C 25", "I/O Control: limit1 input, limit2 input"},
             {"AA 01 18 05 1E", "I/O Control: limit1 input, limit2 output 0"},
             {"AA 01 19 00 1A", "Set Homing Mode: cancel"},
             {"AA 01 19 28 42", "Set Homing Mode: change of index, stop smoothly"},
             // 2000 = 07D0, 1.5 = 1 8000
             {"AA 01 94 93 D0 07 00 00 00 80 01 00 80",
              "Load Trajectory: position 2000, velocity 1.5, trapezoidal, start now"},
             {"AA FF 1A 14 2D", "Set Baud Rate: code 20, 57600 Bd"},
             // 1 250 000 / 125 = 10 000
             {"AA FF 1A 7C 95", "Set Baud Rate: code 124, 10000 Bd"},
         })
        EXPECT_EQ(servoSays(row.hex), row.text) << row.hex;
}

TEST(DescribeCommand, SaysTheCommandsOfAStepper) {
    for (const Row& row : std::vector<Row>{
             // position 1000 = 03E8, speed 50, acceleration time 20, start now
             {"AA 01 74 87 E8 03 00 00 32 14 2D",
              "Load Trajectory: position 1000, speed 50, acceleration time 20, start now"},
             // timer count 64 000 = FA00 with nearest speed 5, reverse
             {"AA 01 44 18 00 FA 05 5C", "Load Trajectory: timer count 64000, nearest speed 5, reverse"},
             {"AA 01 14 00 15", "Load Trajectory: nothing loaded"},
             {"AA 01 56 13 0A 64 32 00 0A",
              "Set Parameters: 1x, motor off on limit or E-stop, minimum profile speed 10, run current 100, "
              "hold "
              "current 50, thermal limit 0"},
             {"AA 01 17 09 21", "Stop Motor: stop smoothly, amplifier on"},
             {"AA 01 18 11 2A", "Set Outputs: OUT1, OUT5 high"},
             {"AA 01 18 00 19", "Set Outputs: all low"},
             {"AA 01 19 18 32", "Set Homing Mode: change of home switch, stop abruptly"},
             {"AA 01 13 0C 20", "Read Status: current timer count, inputs"},
             {"AA 01 0B 0C", "command 11, which the chip does not have: no data"},
         })
        EXPECT_EQ(stepSays(row.hex), row.text) << row.hex;
}

TEST(DescribeCommand, SaysWhatIsNoPacket) {
    for (const Row& row : std::vector<Row>{
             {"", ""},
             {"00", "1 null"},
             {"00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00", "16 nulls"},
             {"12 34", "2 bytes outside a packet"},
             {"00 00 AA FF 0F 0E", "2 nulls; Hard Reset"},
             {"AA 01 17 05 1D AA 02 17 05 1E",
              "Stop Motor: stop abruptly, amplifier on; Stop Motor: stop abruptly, amplifier on"},
             {"AA", "cut packet"},
             {"AA 01 13", "cut packet"},
             {"AA 01 13 20 35", "packet with a wrong sum"},
             {"AA 01 24 01 02 28", "Load Trajectory, not as the data sheet has it: 01 02"},
             {"AA 01 0D 0E", "command 13, which the chip does not have: no data"},
         })
        EXPECT_EQ(servoSays(row.hex), row.text) << row.hex;
}

TEST(DescribeReply, SaysWhatTheGoldenReplySays) {
    // 0x2522 = 9506, 0x4F = 79, 0x18 = accel_done and slew_done, 0x05E0 = 1504, 0x11 = move_done and
    // pos_error.
    EXPECT_EQ(
        describeReply(ModuleType::Servo, StatusItems(0x1F),
                      fromHex("11 22 25 00 00 4F 00 00 18 E0 05 00 00 A4")),
        "position 9506, A/D value 79, velocity 0, auxiliary status accel_done slew_done, home position 1504, "
        "move_done pos_error");
}

TEST(DescribeReply, SaysTheVelocityAsTheMotorHasIt) {
    // The wire carries the negative: FFFE is +2. 1234 = 04D2. 09+D2+04+FE+FF = 2DC.
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0x05), fromHex("09 D2 04 00 00 FE FF DC")),
              "position 1234, velocity 2, move_done power_on");
}

TEST(DescribeReply, SaysWhatAStepperReports) {
    // moving, power and amplifier; inputs limit1 and home switch; timer count 64 000 = FA00.
    EXPECT_EQ(describeReply(ModuleType::Step, StatusItems(0x0C), fromHex("0D 00 FA 28 2F")),
              "current timer count 64000, inputs limit1 + home switch, moving + amplifier enabled + power");
}

TEST(DescribeReply, NamesTypeVersionAndBareStatus) {
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0x20), fromHex("18 03 01 1C")),
              "type 3, version 1, power_on pos_error");
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0), fromHex("00 00")), "status 00");
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0x08), fromHex("01 C0 C1")),
              "auxiliary status bit6 bit7, move_done");
}

TEST(DescribeReply, TellsDamage) {
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0), {}), "");
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0x01), fromHex("09 D2 04")), "3 of 6 bytes");
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0), fromHex("09 0A")),
              "sum 0A instead of 09; move_done power_on");
    EXPECT_EQ(describeReply(ModuleType::Servo, StatusItems(0), fromHex("09 09 00")),
              "move_done power_on; 1 byte too many");
}

RC_GTEST_PROP(Describe, SaysSomethingAboutAnyBytes,
              (const std::vector<std::uint8_t>& bytes, std::uint8_t mask)) {
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Adc, ModuleType::Io, ModuleType::Step}) {
        RC_ASSERT(describeCommand(type, bytes).empty() == bytes.empty());
        RC_ASSERT(describeReply(type, StatusItems(mask), bytes).empty() == bytes.empty());
    }
}

}  // namespace
}  // namespace nmc

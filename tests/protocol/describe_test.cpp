// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of protocol.md section 4, and bytes put together by hand from the data sheets' tables, each with
// the sentence that a reader of the data sheet would write beside it.
#include "protocol/describe.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/support/hexbytes.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing_support::fromHex;
using testing_support::kCmc;
using testing_support::kIo;
using testing_support::kSc;
using testing_support::kServo;
using testing_support::kStep;

std::string servoSays(const std::string& hex) {
    return describeCommand(kServo, fromHex(hex));
}
std::string stepSays(const std::string& hex) {
    return describeCommand(kStep, fromHex(hex));
}

struct Described {
    std::string hex;
    std::string text;
};

TEST(DescribeCommand, SaysWhatTheGoldenFramesSay) {
    // 100 000 / 65 536 = 1.52588, 100 / 65 536 = 0.00152588.
    for (const Described& row : std::vector<Described>{
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
    for (const Described& row : std::vector<Described>{
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
    for (const Described& row : std::vector<Described>{
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
             {"AA 01 18 11 2A", "Set Outputs: high OUT1 OUT5"},
             {"AA 01 18 00 19", "Set Outputs: high none"},
             {"AA 01 19 18 32", "Set Homing Mode: change of home switch, stop abruptly"},
             {"AA 01 13 0C 20", "Read Status: current timer count, inputs"},
             {"AA 01 0B 0C", "command 11, which the chip does not have: no data"},
         })
        EXPECT_EQ(stepSays(row.hex), row.text) << row.hex;
}

TEST(DescribeCommand, SaysWhatIsNoPacket) {
    for (const Described& row : std::vector<Described>{
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

TEST(DescribeCommand, SaysWhatTheFramesOfAnScSay) {
    // 0x0321 without its two low bits is 800: 800 / 256 = 3.125 counts per tick, then 3.15625 and so on.
    for (const Described& row : std::vector<Described>{
             {"AA 01 10 01 12", "Reset Position: relative to home"},
             {"AA 01 50 02 A2 32 54 01 7C", "Reset Position: to position 22295202"},
             {"AA 01 12 41 54", "Define Status: position, position error"},
             {"AA 01 F6 64 00 E8 03 32 00 C8 00 FF 35 A0 0F 01 00 05 29",
              "Set Gain: Kp 100, Kd 1000, Ki 50, IL 200, OL 255, CL 53, EL 4000, SR 1, DB 0, SM 5"},
             {"AA 01 18 90 A9", "I/O Control: 3-phase, step and direction"},
             {"AA 01 18 68 81", "I/O Control: stop abruptly on limit, antiphase, fast path"},
             {"AA 01 18 00 19", "I/O Control: all off"},
             {"AA 01 8D 21 03 29 03 31 03 39 03 4E",
              "Add Path Points: 4 points at -3.125, -3.15625, -3.1875, -3.21875"},
             {"AA 01 2D 06 00 34", "Add Path Points: 1 point at 0.015625 long"},
             {"AA 81 0D 8E", "Add Path Points: start the path"},
             {"AA 01 1F 5F 7F",
              "Hard Reset: save configuration, restore addresses, amplifier on, servo on, step and "
              "direction, "
              "3-phase"},
             {"AA 01 1F 00 20", "Hard Reset: erase configuration"},
             {"AA 01 0F 10", "Hard Reset"},
             {"AA 01 0B 0C", "Clear Bits"},
             {"AA 01 14 50 65", "Load Trajectory: trapezoidal, relative"},
             {"AA 01 18 84 9D", "I/O Control, not as the data sheet has it: 84"},
         })
        EXPECT_EQ(describeCommand(kSc, fromHex(row.hex)), row.text) << row.hex;
}

TEST(DescribeCommand, SaysWhatOlderVersionsMakeOfThem) {
    // A version ignores what it does not know.
    EXPECT_EQ(servoSays("AA 01 10 01 12"), "Reset Position");
    EXPECT_EQ(servoSays("AA 01 14 50 65"), "Load Trajectory: trapezoidal, reverse");
    EXPECT_EQ(servoSays("AA 01 1F 00 20"), "Hard Reset");
    EXPECT_EQ(describeCommand(ModuleIdentity{ModuleType::Servo, 2}, fromHex("AA 01 19 11 2B")),
              "Set Homing Mode: change of limit1");
    EXPECT_EQ(describeCommand(kCmc, fromHex("AA 01 18 4C 65")),
              "I/O Control: limit1 input, limit2 input, fast path");
    EXPECT_EQ(describeCommand(kCmc, fromHex("AA 01 17 21 39")),
              "Stop Motor: amplifier on, advanced features");
}

TEST(DescribeCommand, SaysWhatAPicIoIsAsked) {
    for (const Described& row : std::vector<Described>{
             {"AA 02 20 FF 0F 30",
              "Set Direction: inputs IO1 IO2 IO3 IO4 IO5 IO6 IO7 IO8 IO9 IO10 IO11 IO12"},
             {"AA 02 20 00 00 22", "Set Direction: inputs none"},
             {"AA 02 24 80 40 E6", "Set PWM: PWM1 128, PWM2 64"},
             {"AA 02 05 07", "Synch Output"},
             {"AA 02 26 01 08 31", "Set Output: high IO1 IO12"},
             {"AA 02 47 00 02 0A 0B 60", "Set Synch Output: high IO10, PWM1 10, PWM2 11"},
             {"AA 02 18 00 1A", "Set Timer Mode: off"},
             {"AA 02 18 21 3B", "Set Timer Mode: timer, prescaler 4"},
             {"AA 02 18 03 1D", "Set Timer Mode: counter, prescaler 1"},
             {"AA 02 0C 0E", "Synch Input"},
             {"AA 02 12 1F 33",
              "Define Status: inputs, A/D value 1, A/D value 2, A/D value 3, counter/timer"},
             {"AA 02 13 C0 D5", "Read Status: latched inputs, latched counter"},
             {"AA 02 09 0B", "command 9, which the chip does not have: no data"},
         })
        EXPECT_EQ(describeCommand(kIo, fromHex(row.hex)), row.text) << row.hex;
}

TEST(DescribeCommand, SaysACommandThatIsNotOnTheWireYet) {
    EXPECT_EQ(describeCommand(ServoCommand(servo::SetPosition{Counts(5)})), "Reset Position: to position 5");
    EXPECT_EQ(describeCommand(StepperCommand(stepper::SetOutputs{1})), "Set Outputs: high OUT1");
    EXPECT_EQ(describeCommand(IoCommand(io::SynchInput{})), "Synch Input");
}

TEST(DescribeReply, SaysWhatTheGoldenReplySays) {
    // 0x2522 = 9506, 0x4F = 79, 0x18 = accel_done and slew_done, 0x05E0 = 1504, 0x11 = move_done and
    // pos_error.
    EXPECT_EQ(
        describeReply(kServo, StatusItems(0x1F), fromHex("11 22 25 00 00 4F 00 00 18 E0 05 00 00 A4")),
        "position 9506, A/D value 79, velocity 0, auxiliary status accel_done slew_done, home position 1504, "
        "move_done pos_error");
}

TEST(DescribeReply, SaysTheVelocityAsTheMotorHasIt) {
    // The wire carries the negative: FFFE is +2. 1234 = 04D2. 09+D2+04+FE+FF = 2DC.
    EXPECT_EQ(describeReply(kServo, StatusItems(0x05), fromHex("09 D2 04 00 00 FE FF DC")),
              "position 1234, velocity 2, move_done power_on");
}

TEST(DescribeReply, SaysWhatAStepperReports) {
    // moving, power and amplifier; inputs limit1 and home switch; timer count 64 000 = FA00.
    EXPECT_EQ(describeReply(kStep, StatusItems(0x0C), fromHex("0D 00 FA 28 2F")),
              "current timer count 64000, inputs limit1 + home switch, moving + amplifier enabled + power");
}

TEST(DescribeReply, SaysWhatLaterModulesReport) {
    EXPECT_EQ(describeReply(kSc, StatusItems(0xCC), fromHex("09 FE FF 59 FE FF 05 61")),
              "velocity -2, auxiliary status index accel slew path_mode, position error -2, path points 5, "
              "move_done power_on");
    EXPECT_EQ(describeReply(kCmc, StatusItems(0x08), fromHex("01 59 5A")),
              "auxiliary status index accel_done slew_done path_mode, move_done");
    // IO1 and IO12 high; A/D 3 of 7; counter 258; nothing latched.
    EXPECT_EQ(describeReply(kIo, StatusItems(0x59), fromHex("02 01 08 07 02 01 00 00 00 00 15")),
              "inputs IO1 IO12, A/D value 3 7, counter/timer 258, latched inputs all low, cksum_error");
}

TEST(DescribeReply, NamesTypeVersionAndBareStatus) {
    EXPECT_EQ(describeReply(kServo, StatusItems(0x20), fromHex("18 03 01 1C")),
              "type 3, version 1, power_on pos_error");
    EXPECT_EQ(describeReply(kServo, StatusItems(0), fromHex("00 00")), "status 00");
    EXPECT_EQ(describeReply(kServo, StatusItems(0x08), fromHex("01 C0 C1")),
              "auxiliary status bit6 bit7, move_done");
}

TEST(DescribeReply, TellsDamage) {
    EXPECT_EQ(describeReply(kServo, StatusItems(0), {}), "");
    EXPECT_EQ(describeReply(kServo, StatusItems(0x01), fromHex("09 D2 04")), "3 of 6 bytes");
    EXPECT_EQ(describeReply(kServo, StatusItems(0), fromHex("09 0A")),
              "sum 0A instead of 09; move_done power_on");
    EXPECT_EQ(describeReply(kServo, StatusItems(0), fromHex("09 09 00")),
              "move_done power_on; 1 byte too many");
}

RC_GTEST_PROP(Describe, SaysSomethingAboutAnyBytes,
              (const std::vector<std::uint8_t>& bytes, std::uint8_t mask)) {
    for (const ModuleIdentity& module : {kServo, kCmc, kSc, kStep, kIo, ModuleIdentity{ModuleType::Adc, 1},
                                         ModuleIdentity{ModuleType::Servo, 99}}) {
        RC_ASSERT(describeCommand(module, bytes).empty() == bytes.empty());
        RC_ASSERT(describeReply(module, StatusItems(mask), bytes).empty() == bytes.empty());
    }
}

}  // namespace
}  // namespace nmc

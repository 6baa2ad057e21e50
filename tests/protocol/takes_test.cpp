// SPDX-License-Identifier: GPL-3.0-or-later
// Checks every command, and every bit of it, against every version, by the table below, which can be compared
// with docs/family.md row by row.
#include "protocol/takes.h"

#include <gtest/gtest.h>

#include <functional>

namespace nmc {
namespace {

using std::optional;

template <typename Command>
Command with(const std::function<void(Command&)>& change) {
    Command command;
    change(command);
    return command;
}

struct Row {
    std::string name;
    ServoCommand command;
    std::vector<unsigned> versions;  ///< that accept it
};

const std::vector<unsigned> kAll{1, 2, 3, 4, 5, 10};

servo::LoadTrajectory load(const std::function<void(servo::LoadTrajectory&)>& change) {
    return with<servo::LoadTrajectory>(change);
}
servo::SetHoming homing(const std::function<void(servo::SetHoming&)>& change) {
    return with<servo::SetHoming>(change);
}
servo::StopMotor stop(servo::StopManner manner) {
    return {true, manner, {}};
}
ReadStatus read(unsigned mask) {
    return {StatusItems(static_cast<std::uint8_t>(mask))};
}

std::vector<Row> rows() {
    servo::SetGain gains;
    servo::SetGain deadband = gains;
    deadband.db = std::uint8_t{1};
    servo::SetGain steps = deadband;
    steps.sm = std::uint8_t{1};
    servo::StopMotor advanced = stop(servo::StopManner::Smoothly);
    advanced.advancedFeatures = true;
    servo::IoControl fast;
    fast.fastPath = true;
    return {
        {"reset", ResetPosition{}, kAll},
        {"address", SetAddress{BusAddress(1), BusAddress(0x81), true}, kAll},
        {"define", DefineStatus{StatusItems(0x3F)}, kAll},
        {"read", read(0x3F), kAll},
        {"read position error", read(0x40), {5, 10}},
        {"read path points", read(0x80), {5, 10}},
        {"define path points", DefineStatus{StatusItems(0x81)}, {5, 10}},
        {"load", load([](auto& l) { l.position = Counts(-5); }), kAll},
        {"reverse", load([](auto& l) { l.reverse = true, l.profile = servo::ProfileMode::Velocity; }), kAll},
        {"PWM", load([](auto& l) { l.servo = false, l.pwm = std::uint8_t{255}, l.reverse = true; }), kAll},
        {"relative", load([](auto& l) { l.relative = true; }), {5, 10}},
        {"velocity 83886080", load([](auto& l) { l.velocity = CountsPerTick(83'886'080); }), kAll},
        {"velocity 83886081", load([](auto& l) { l.velocity = CountsPerTick(83'886'081); }), {1, 2, 3, 4}},
        {"velocity 0x80000000", load([](auto& l) { l.velocity = CountsPerTick(0x80000000); }), {}},
        {"start", StartMotion{}, kAll},
        {"gains", gains, kAll},
        {"gains with deadband", deadband, {4, 5, 10}},
        {"gains with step multiplier", steps, {10}},
        {"motor off", stop(servo::StopManner::MotorOff), kAll},
        {"abruptly", stop(servo::StopManner::Abruptly), kAll},
        {"smoothly", stop(servo::StopManner::Smoothly), kAll},
        {"amplifier", stop(servo::StopManner::AmplifierOnly), kAll},
        {"here", stop(servo::StopManner::Here), {2, 3, 4, 5, 10}},
        {"advanced features", advanced, {5}},
        {"I/O control", servo::IoControl{true, true, false, false}, {1, 2, 3, 4, 5}},
        {"fast path of CMC", fast, {5}},
        {"I/O control of SC", servo::ScIoControl{}, {10}},
        {"homing", homing([](auto& h) { h.onIndexChange = true; }), kAll},
        {"homing, off", homing([](auto& h) { h.motorOff = true; }), {3, 4, 5, 10}},
        {"homing, abruptly", homing([](auto& h) { h.stopAbruptly = true; }), {3, 4, 5, 10}},
        {"homing, smoothly", homing([](auto& h) { h.stopSmoothly = true; }), {3, 4, 5, 10}},
        {"baud", SetBaud{10}, kAll},
        {"clear", servo::ClearStickyBits{}, kAll},
        {"home", SaveAsHome{}, kAll},
        {"nop", Nop{}, kAll},
        {"hard reset", HardReset{}, kAll},
        {"relative to home", servo::ResetRelativeToHome{}, {5, 10}},
        {"set position", servo::SetPosition{Counts(7)}, {10}},
        {"path", servo::AddPathPoints{}, {5, 10}},
        {"saved configuration", servo::HardReset{}, {10}},
    };
}

TEST(Takes, KnowsForEveryServoVersionWhatItDoesNotKnow) {
    for (const Row& row : rows())
        for (const unsigned version : kAll) {
            const ModuleIdentity module{ModuleType::Servo, static_cast<std::uint8_t>(version)};
            const bool known = std::count(row.versions.begin(), row.versions.end(), version) > 0;
            EXPECT_EQ(takes(module, row.command), known) << row.name << ", version " << version;
        }
}

TEST(Takes, HasARowForEveryCommand) {
    std::set<std::size_t> seen;
    for (const Row& row : rows())
        seen.insert(row.command.index());
    EXPECT_EQ(seen.size(), std::variant_size_v<ServoCommand>);
}

TEST(Takes, KnowsNothingForAModuleThatIsNotKnown) {
    for (const Row& row : rows())
        for (const ModuleIdentity& module :
             {ModuleIdentity{ModuleType::Servo, 0}, ModuleIdentity{ModuleType::Servo, 7},
              ModuleIdentity{ModuleType::Servo, 21}, ModuleIdentity{ModuleType::Adc, 1}})
            EXPECT_FALSE(takes(module, row.command)) << row.name;
}

TEST(Takes, KeepsTheChipsApart) {
    const ModuleIdentity servo{ModuleType::Servo, 10};
    const ModuleIdentity stepper{ModuleType::Stepper, 1};
    const ModuleIdentity pins{ModuleType::Io, 1};
    EXPECT_FALSE(takes(stepper, ServoCommand(Nop{})));
    EXPECT_FALSE(takes(servo, StepperCommand(Nop{})));
    EXPECT_FALSE(takes(servo, IoCommand(Nop{})));
    EXPECT_FALSE(takes(pins, ServoCommand(Nop{})));
    EXPECT_TRUE(takes(stepper, StepperCommand(Nop{})));
}

TEST(Takes, TakesEveryCommandOfThePicIo) {
    const ModuleIdentity pins{ModuleType::Io, 1};
    for (const IoCommand& command : std::vector<IoCommand>{
             io::SetDirection{0x0FFF}, SetAddress{BusAddress(2), BusAddress(0xFF), false},
             DefineStatus{StatusItems(0xFF)}, ReadStatus{StatusItems(0x1F)}, io::SetPwm{1, 2},
             io::SynchOutput{}, io::SetOutput{0x0001}, io::SetSynchOutput{0x0800, 1, 2},
             io::SetTimerMode{true, true, io::Prescaler::X8}, SetBaud{20}, io::SynchInput{}, Nop{},
             HardReset{}})
        EXPECT_TRUE(takes(pins, command)) << command.index();
    // There are twelve pins.
    EXPECT_FALSE(takes(pins, IoCommand(io::SetOutput{0x1000})));
}

TEST(Takes, RefusesStatusItemsThatAStepperDoesNotHave) {
    const ModuleIdentity stepper{ModuleType::Stepper, 1};
    EXPECT_FALSE(takes(stepper, StepperCommand(read(0x40))));
}

TEST(Takes, RefusesStepAndDirectionTogetherWithALimitStop) {
    const ModuleIdentity sc{ModuleType::Servo, 10};
    servo::ScIoControl control;
    control.stepAndDirection = true;
    EXPECT_TRUE(takes(sc, ServoCommand(control)));
    control.limitStop = servo::LimitStop::Abruptly;
    EXPECT_FALSE(takes(sc, ServoCommand(control)));
}

}  // namespace
}  // namespace nmc

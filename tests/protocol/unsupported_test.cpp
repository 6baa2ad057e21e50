// SPDX-License-Identifier: GPL-3.0-or-later
// Checks every command, and every bit of it, against every version, by the table below, which can be compared
// with docs/family.md row by row.
#include "protocol/unsupported.h"

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
    Unsupported reason;              ///< on the versions that do not accept it
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
    using U = Unsupported;
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
        {"reset", ResetPosition{}, U::OutOfRange, kAll},
        {"address", SetAddress{BusAddress(1), BusAddress(0x81), true}, U::OutOfRange, kAll},
        {"define", DefineStatus{StatusItems(0x3F)}, U::OutOfRange, kAll},
        {"read", read(0x3F), U::OutOfRange, kAll},
        {"read position error", read(0x40), U::StatusItem, {5, 10}},
        {"read path points", read(0x80), U::StatusItem, {5, 10}},
        {"define path points", DefineStatus{StatusItems(0x81)}, U::StatusItem, {5, 10}},
        {"load", load([](auto& l) { l.position = Counts(-5); }), U::OutOfRange, kAll},
        {"reverse", load([](auto& l) { l.reverse = true, l.profile = servo::ProfileMode::Velocity; }),
         U::OutOfRange, kAll},
        {"PWM", load([](auto& l) { l.servo = false, l.pwm = std::uint8_t{255}, l.reverse = true; }),
         U::OutOfRange, kAll},
        {"relative", load([](auto& l) { l.relative = true; }), U::RelativeMove, {5, 10}},
        {"velocity 83886080", load([](auto& l) { l.velocity = CountsPerTick(83'886'080); }), U::OutOfRange,
         kAll},
        {"velocity 83886081",
         load([](auto& l) { l.velocity = CountsPerTick(83'886'081); }),
         U::OutOfRange,
         {1, 2, 3, 4}},
        {"velocity 0x80000000",
         load([](auto& l) { l.velocity = CountsPerTick(0x80000000); }),
         U::OutOfRange,
         {}},
        {"start", StartMotion{}, U::OutOfRange, kAll},
        {"gains", gains, U::OutOfRange, kAll},
        {"gains with deadband", deadband, U::Deadband, {4, 5, 10}},
        {"gains with step multiplier", steps, U::StepMultiplier, {10}},
        {"motor off", stop(servo::StopManner::MotorOff), U::OutOfRange, kAll},
        {"abruptly", stop(servo::StopManner::Abruptly), U::OutOfRange, kAll},
        {"smoothly", stop(servo::StopManner::Smoothly), U::OutOfRange, kAll},
        {"amplifier", stop(servo::StopManner::AmplifierOnly), U::OutOfRange, kAll},
        {"here", stop(servo::StopManner::Here), U::StopHere, {2, 3, 4, 5, 10}},
        {"advanced features", advanced, U::AdvancedFeatures, {5}},
        {"I/O control", servo::IoControl{true, true, false, false}, U::FirstIoControl, {1, 2, 3, 4, 5}},
        {"fast path of CMC", fast, U::IoFastPath, {5}},
        {"I/O control of SC", servo::ScIoControl{}, U::ScIoControl, {10}},
        {"homing", homing([](auto& h) { h.onIndexChange = true; }), U::OutOfRange, kAll},
        {"homing, off", homing([](auto& h) { h.motorOff = true; }), U::AutoStop, {3, 4, 5, 10}},
        {"homing, abruptly", homing([](auto& h) { h.stopAbruptly = true; }), U::AutoStop, {3, 4, 5, 10}},
        {"homing, smoothly", homing([](auto& h) { h.stopSmoothly = true; }), U::AutoStop, {3, 4, 5, 10}},
        {"baud", SetBaud{10}, U::OutOfRange, kAll},
        {"clear", servo::ClearStickyBits{}, U::OutOfRange, kAll},
        {"home", SaveAsHome{}, U::OutOfRange, kAll},
        {"nop", Nop{}, U::OutOfRange, kAll},
        {"hard reset", HardReset{}, U::OutOfRange, kAll},
        {"relative to home", servo::ResetRelativeToHome{}, U::RelativeReset, {5, 10}},
        {"set position", servo::SetPosition{Counts(7)}, U::SetPosition, {10}},
        {"path", servo::AddPathPoints{}, U::PathPoints, {5, 10}},
        {"saved configuration", servo::HardReset{}, U::SavedConfiguration, {10}},
    };
}

TEST(Unsupported, SaysForEveryServoVersionWhatItDoesNotKnow) {
    for (const Row& row : rows())
        for (const unsigned version : kAll) {
            const ModuleIdentity module{ModuleType::Servo, static_cast<std::uint8_t>(version)};
            const bool known = std::count(row.versions.begin(), row.versions.end(), version) > 0;
            const auto reason = unsupported(module, row.command);
            EXPECT_EQ(takes(module, row.command), known) << row.name << ", version " << version;
            if (reason) {
                // CMC and SC have different I/O Controls, so the reason depends on the version.
                EXPECT_EQ(*reason, known ? Unsupported{}
                                   : row.name == "fast path of CMC" && version == 10
                                       ? Unsupported::FirstIoControl
                                       : row.reason)
                    << row.name << ", version " << version;
                EXPECT_FALSE(toText(*reason).empty());
            }
        }
}

TEST(Unsupported, HasARowForEveryCommand) {
    std::set<std::size_t> seen;
    for (const Row& row : rows())
        seen.insert(row.command.index());
    EXPECT_EQ(seen.size(), std::variant_size_v<ServoCommand>);
}

TEST(Unsupported, KnowsNothingForAModuleThatIsNotKnown) {
    for (const Row& row : rows())
        for (const ModuleIdentity& module :
             {ModuleIdentity{ModuleType::Servo, 0}, ModuleIdentity{ModuleType::Servo, 7},
              ModuleIdentity{ModuleType::Servo, 21}, ModuleIdentity{ModuleType::Adc, 1}})
            EXPECT_EQ(unsupported(module, row.command), Unsupported::UnknownModule) << row.name;
}

TEST(Unsupported, KeepsTheChipsApart) {
    const ModuleIdentity servo{ModuleType::Servo, 10};
    const ModuleIdentity stepper{ModuleType::Stepper, 1};
    const ModuleIdentity pins{ModuleType::Io, 1};
    EXPECT_EQ(unsupported(stepper, ServoCommand(Nop{})), Unsupported::OtherChip);
    EXPECT_EQ(unsupported(servo, StepperCommand(Nop{})), Unsupported::OtherChip);
    EXPECT_EQ(unsupported(servo, IoCommand(Nop{})), Unsupported::OtherChip);
    EXPECT_EQ(unsupported(pins, ServoCommand(Nop{})), Unsupported::OtherChip);
    EXPECT_TRUE(takes(stepper, StepperCommand(Nop{})));
}

TEST(Unsupported, TakesEveryCommandOfThePicIo) {
    const ModuleIdentity pins{ModuleType::Io, 1};
    for (const IoCommand& command : std::vector<IoCommand>{
             io::SetDirection{0x0FFF}, SetAddress{BusAddress(2), BusAddress(0xFF), false},
             DefineStatus{StatusItems(0xFF)}, ReadStatus{StatusItems(0x1F)}, io::SetPwm{1, 2},
             io::SynchOutput{}, io::SetOutput{0x0001}, io::SetSynchOutput{0x0800, 1, 2},
             io::SetTimerMode{true, true, io::Prescaler::X8}, SetBaud{20}, io::SynchInput{}, Nop{},
             HardReset{}})
        EXPECT_TRUE(takes(pins, command)) << command.index();
    // There are twelve pins.
    EXPECT_EQ(unsupported(pins, IoCommand(io::SetOutput{0x1000})), Unsupported::OutOfRange);
}

TEST(Unsupported, RefusesStatusItemsThatAStepperDoesNotHave) {
    const ModuleIdentity stepper{ModuleType::Stepper, 1};
    EXPECT_EQ(unsupported(stepper, StepperCommand(read(0x40))), Unsupported::StatusItem);
}

TEST(Unsupported, RefusesStepAndDirectionTogetherWithALimitStop) {
    const ModuleIdentity sc{ModuleType::Servo, 10};
    servo::ScIoControl control;
    control.stepAndDirection = true;
    EXPECT_TRUE(takes(sc, ServoCommand(control)));
    control.limitStop = servo::LimitStop::Abruptly;
    EXPECT_EQ(unsupported(sc, ServoCommand(control)), Unsupported::OutOfRange);
}

}  // namespace
}  // namespace nmc

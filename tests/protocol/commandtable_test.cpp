// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/commandtable.h"

#include <gmock/gmock.h>

#include <set>

#include "protocol/commands.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing::ElementsAre;
using testing_support::kCmc;
using testing_support::kIo;
using testing_support::kSc;
using testing_support::kServo;
using testing_support::kStep;

std::vector<std::string> keys(const ModuleIdentity& module) {
    std::vector<std::string> names;
    for (const CommandRow& row : commandTable(module))
        names.emplace_back(row.key);
    return names;
}

TEST(CommandTable, HasEveryServoCommandOfTheDataSheet) {
    EXPECT_THAT(keys(kServo), ElementsAre("reset_position", "set_address", "define_status", "read_status",
                                          "load_trajectory", "start_motion", "set_gain", "stop_motor",
                                          "io_control", "set_homing", "set_baud", "clear_sticky_bits",
                                          "save_as_home", "nop", "hard_reset"));
}

TEST(CommandTable, HasEveryStepCommandOfTheDataSheet) {
    EXPECT_THAT(keys(kStep),
                ElementsAre("reset_position", "set_address", "define_status", "read_status",
                            "load_trajectory", "start_motion", "set_parameters", "stop_motor", "set_outputs",
                            "set_homing", "set_baud", "save_as_home", "nop", "hard_reset"));
}

TEST(CommandTable, GivesTheLaterServosAddPathPoints) {
    for (const ModuleIdentity& module : {kCmc, kSc}) {
        auto expected = keys(kServo);
        expected.insert(expected.end() - 2, "add_path_points");
        EXPECT_EQ(keys(module), expected);
    }
}

TEST(CommandTable, HasEveryCommandOfThePicIo) {
    EXPECT_THAT(keys(kIo), ElementsAre("set_direction", "set_address", "define_status", "read_status",
                                       "set_pwm", "synch_output", "set_output", "set_synch_output",
                                       "set_timer_mode", "set_baud", "synch_input", "nop", "hard_reset"));
    // The command bytes of docs/family.md: their high nibble is the length.
    for (const unsigned byte :
         {0x20U, 0x21U, 0x12U, 0x13U, 0x24U, 0x05U, 0x26U, 0x47U, 0x18U, 0x1AU, 0x0CU, 0x0EU, 0x0FU}) {
        const auto row = findCommand(kIo, static_cast<CommandCode>(byte & 0x0FU));
        ASSERT_TRUE(row.has_value());
        EXPECT_EQ(row->minData, byte >> 4U) << row->name;
        EXPECT_EQ(row->maxData, byte >> 4U) << row->name;
    }
}

TEST(CommandTable, KnowsNoCommandOfAModuleThatIsNotKnown) {
    for (const ModuleIdentity& module :
         {ModuleIdentity{ModuleType::Servo, 0}, ModuleIdentity{ModuleType::Servo, 6},
          ModuleIdentity{ModuleType::Servo, 21}, ModuleIdentity{ModuleType::Adc, 1},
          ModuleIdentity{ModuleType::Io, 2}, ModuleIdentity{ModuleType::Stepper, 2},
          ModuleIdentity{static_cast<ModuleType>(99), 1}})
        EXPECT_TRUE(commandTable(module).empty()) << int{module.version};
    EXPECT_FALSE(findCommand(kServo, CommandCode::AddPathPoints).has_value());
    EXPECT_FALSE(findCommand(kStep, CommandCode::ClearStickyBits).has_value());
}

TEST(CommandTable, KnowsHowLengthsDifferByVersion) {
    EXPECT_EQ(findCommand(kServo, CommandCode::ResetPosition)->maxData, 1);
    EXPECT_EQ(findCommand(kCmc, CommandCode::ResetPosition)->maxData, 1);
    EXPECT_EQ(findCommand(kSc, CommandCode::ResetPosition)->maxData, 5);
    EXPECT_EQ(findCommand(kSc, CommandCode::SetGain)->maxData, 15);
    EXPECT_EQ(findCommand(kSc, CommandCode::HardReset)->maxData, 1);
    EXPECT_EQ(findCommand(kSc, CommandCode::AddPathPoints)->maxData, 14);
}

template <typename... Commands>
void expectEncodersFitTheTable(const ModuleIdentity& module, std::variant<Commands...>*) {
    const auto check = [&module](const Payload& payload) {
        const auto row = findCommand(module, payload.code);
        ASSERT_TRUE(row.has_value());
        EXPECT_GE(payload.data.size(), row->minData) << row->name;
        EXPECT_LE(payload.data.size(), row->maxData) << row->name;
    };
    (check(encode(Commands{})), ...);
    // Each row has a command.
    std::set<CommandCode> codes{encode(Commands{}).code...};
    EXPECT_EQ(codes.size(), commandTable(module).size());
}

TEST(CommandTable, AgreesWithTheEncoders) {
    expectEncodersFitTheTable(kSc, static_cast<ServoCommand*>(nullptr));
    expectEncodersFitTheTable(kStep, static_cast<StepperCommand*>(nullptr));
    expectEncodersFitTheTable(kIo, static_cast<IoCommand*>(nullptr));
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/commandtable.h"

#include <gmock/gmock.h>

#include "protocol/commands.h"

namespace nmc {
namespace {

using testing::ElementsAre;

std::vector<std::string> keys(ModuleType type) {
    std::vector<std::string> names;
    for (const CommandRow& row : commandTable(type))
        names.emplace_back(row.key);
    return names;
}

TEST(CommandTable, HasEveryServoCommandOfTheDataSheet) {
    EXPECT_THAT(
        keys(ModuleType::Servo),
        ElementsAre("reset_position", "set_address", "define_status", "read_status", "load_trajectory",
                    "start_motion", "set_gain", "stop_motor", "io_control", "set_homing", "set_baud",
                    "clear_sticky_bits", "save_as_home", "nop", "hard_reset"));
}

TEST(CommandTable, HasEveryStepCommandOfTheDataSheet) {
    EXPECT_THAT(keys(ModuleType::Step),
                ElementsAre("reset_position", "set_address", "define_status", "read_status",
                            "load_trajectory", "start_motion", "set_parameters", "stop_motor", "set_outputs",
                            "set_homing", "set_baud", "save_as_home", "nop", "hard_reset"));
}

TEST(CommandTable, KnowsNoCommandOfAModuleWithoutADataSheet) {
    EXPECT_TRUE(commandTable(ModuleType::Io).empty());
    EXPECT_TRUE(commandTable(static_cast<ModuleType>(99)).empty());
    EXPECT_FALSE(findCommand(ModuleType::Servo, CommandCode::Reserved).has_value());
    EXPECT_FALSE(findCommand(ModuleType::Step, CommandCode::ClearStickyBits).has_value());
}

template <typename... Commands>
void expectEncodersFitTheTable(ModuleType type, std::variant<Commands...>*) {
    const auto check = [type](const Payload& payload) {
        const auto row = findCommand(type, payload.code);
        ASSERT_TRUE(row.has_value());
        EXPECT_GE(payload.data.size(), row->minData) << row->name;
        EXPECT_LE(payload.data.size(), row->maxData) << row->name;
    };
    (check(Commands{}.encode()), ...);
    EXPECT_EQ(sizeof...(Commands), commandTable(type).size());
}

TEST(CommandTable, AgreesWithTheEncoders) {
    expectEncodersFitTheTable(ModuleType::Servo, static_cast<ServoCommand*>(nullptr));
    expectEncodersFitTheTable(ModuleType::Step, static_cast<StepCommand*>(nullptr));
}

}  // namespace
}  // namespace nmc

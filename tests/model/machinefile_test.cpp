// SPDX-License-Identifier: GPL-3.0-or-later
// A machine is read from its file exactly as it was written. Expected numbers and lines are counted by hand.
#include "model/machinefile/machinefile.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/model/anymachine.h"
#include "tests/model/machines.h"

namespace nmc {
namespace {

using testing_support::anyMachine;
using testing_support::mill;

constexpr std::string_view kSmall = R"({
  "format": "nmc-panel-machine",
  "version": 1,
  "name": "Mill",
  "made_by": {"who": "Anna", "when": [2026, 11.5, null]},
  "rate_bd": 57600,
  "axes": [
    {
      "colour": "#0072B2",
      "name": "Z axis",
      "expected": {"type": "PIC-SERVO", "version": 3, "serial": 77},
      "unit": {"kind": "turns", "counts_per_unit": 2000.25},
      "motion": {"velocity_counts_per_tick": 7.1},
      "gains": {
        "Kp": 100, "Kd": 1000, "Ki": 5, "IL": 40, "tuned": true,
        "OL": 255, "CL": 0, "EL_counts": 2000, "SR": 1
      }
    },
    {"expected": {"type": 7, "version": 2}}
  ],
  "groups": [
    {"address": 130, "modules": [2, 1], "leader": 1, "why": "gantry"}
  ],
  "notes": "greased in May"
}
)";

TEST(MachineFile, SaysWhatStandsInIt) {
    const auto parsed = parseMachine(kSmall);
    ASSERT_TRUE(parsed.has_value());
    const Machine& machine = parsed->machine;
    EXPECT_EQ(machine.name, "Mill");
    EXPECT_EQ(machine.baud, 57'600U);
    ASSERT_EQ(machine.axes.size(), 2U);
    EXPECT_EQ(machine.axes[0].name, "Z axis");
    EXPECT_EQ(machine.axes[0].expected, (ModuleIdentity{ModuleType::Servo, 3}));
    EXPECT_EQ(machine.axes[0].unit, (AxisUnit{UnitKind::Turns, 2000.25, ""}));
    EXPECT_EQ(machine.axes[0].motion.velocity, 7.1);
    EXPECT_EQ(machine.axes[0].motion.stepSize, 0.0);
    EXPECT_EQ(machine.axes[0].gains, (servo::SetGain{100, 1'000, 5, 40, 255, 0, 2'000, 1, std::nullopt}));
    EXPECT_EQ(machine.axes[0].io, std::nullopt);
    EXPECT_EQ(machine.axes[1].expected, (ModuleIdentity{static_cast<ModuleType>(7), 2}));
    ASSERT_EQ(machine.groups.size(), 1U);
    EXPECT_EQ(machine.groups[0].address, 0x82);
    EXPECT_EQ(machine.groups[0].members, (std::vector{ModuleIndex(1), ModuleIndex(0)}));
    EXPECT_EQ(machine.groups[0].leader, ModuleIndex(0));
}

/// A negative number means that the user's forward is the chip's reverse.
TEST(MachineFile, AReversedAxisIsKept) {
    std::string text(kSmall);
    text.replace(text.find("2000.25"), 7, "-2000.25");
    const auto parsed = parseMachine(text);
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(parsed->machine.axes[0].unit, (AxisUnit{UnitKind::Turns, -2000.25, ""}));
    EXPECT_EQ(parseMachine(writeMachine(parsed->machine))->machine, parsed->machine);
}

TEST(MachineFile, EveryMachineIsReadAsItWasWritten) {
    EXPECT_TRUE(rc::check([] {
        const Machine machine = anyMachine();
        const auto again = parseMachine(writeMachine(machine));
        RC_ASSERT(again.has_value());
        RC_ASSERT(again->machine == machine);
    }));
}

TEST(MachineFile, PointsAndSequencesAreKept) {
    const Machine machine = testing_support::taughtMill();
    const auto again = parseMachine(writeMachine(machine));
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->machine.program, machine.program);
    EXPECT_EQ(again->machine.homeOrder, machine.homeOrder);
}

/// Nothing keeps the user from teaching a grid of 18 x 18 points, or from a long sequence. Each of the 127
/// group addresses, 0x80 to 0xFE, can have a name. Divisor 0 is 1 250 000 Bd (DS-V 5.2 Set Baud Rate). A
/// PIC-STEP's highest speed is 250 units of 200 steps/s, and its steepest ramp one such unit every 0.25 ms
/// (DS-S 4.1, 4.2); a servo's highest number is 32 767 (DS-V 4.4), and the largest distance 2^31 - 1.
TEST(MachineFile, WhatCanBeEnteredIsReadAgain) {
    Machine machine;
    for (int i = 0; i < 18 * 18; ++i)
        machine.program.points.push_back({std::to_string(i), {{ModuleIndex(0), i, true}}});
    for (int i = 0; i < 100; ++i)
        machine.program.sequences.push_back({std::to_string(i), {}});
    machine.program.sequences[0].rows.assign(400, action::Wait{1.0});
    machine.program.sequences[0].rows.emplace_back(action::Repeat{399, 2});
    for (unsigned address = 0x80; address <= 0xFE; ++address)
        machine.groups.push_back({static_cast<std::uint8_t>(address), "Group", {}, {}});
    machine.baud = 1'250'000;
    const auto axisOf = [](ModuleType type, double fastest, double steepest) {
        constexpr double kFarthest = 2'147'483'647.0;
        AxisSettings axis;
        axis.expected = ModuleIdentity{type, 1};
        axis.unit = {UnitKind::Own, -1e9, "u"};
        axis.motion = {fastest, steepest, fastest, fastest, fastest, kFarthest};
        axis.travel = {-2'147'483'647, 2'147'483'647, fastest};
        axis.backlash = {kFarthest, true};
        axis.arrival = {kFarthest, 60.0};
        HomingRecipe& recipe = axis.homing.emplace();
        recipe.velocity = recipe.indexVelocity = fastest;
        recipe.acceleration = steepest;
        recipe.travelLimit = kFarthest;
        recipe.timeLimit = 86'400.0;
        axis.analog = {-1e6, 1e6, "V"};
        axis.accelerationTime = 255;
        return axis;
    };
    machine.axes = {axisOf(ModuleType::Servo, 32'767.0, 32'767.0),
                    axisOf(ModuleType::Stepper, 50'000.0, 800'000.0)};
    const auto parsed = parseMachine(writeMachine(machine));
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(parsed->machine, machine);
}

TEST(MachineFile, OneOfAnOlderProgramHasNone) {
    const auto parsed = parseMachine(kSmall);
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(parsed->machine.program, Program{});
    EXPECT_TRUE(parsed->machine.homeOrder.empty());
}

TEST(MachineFile, ARowThatDoesSomethingElseNowKeepsNothingOfTheOldOne) {
    const auto parsed = parseMachine(writeMachine(testing_support::taughtMill()));
    ASSERT_TRUE(parsed.has_value());
    Machine machine = parsed->machine;
    machine.program.sequences[0].rows[0] = action::WaitForArrival{};
    const std::string text = writeMachine(machine, parsed->unknown);
    const auto row = text.find("\"do\": \"wait for arrival\"");
    ASSERT_NE(row, std::string::npos);
    EXPECT_EQ(text.substr(row, text.find('}', row) - row).find("module"), std::string::npos);
    EXPECT_EQ(parseMachine(text)->machine, machine);
}

TEST(MachineFile, AFileFromBeforeLimitsOfTravelHasNone) {
    const auto parsed =
        parseMachine(R"({"format": "nmc-panel-machine", "version": 1, "axes": [{"name": "Z"}]})");
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(parsed->machine.axes.at(0).travel, TravelSettings{});
    EXPECT_FALSE(parsed->machine.axes.at(0).travel.limited());
    EXPECT_FALSE(parsed->machine.axes.at(0).limitStop.eachMotion);
    EXPECT_EQ(parsed->machine.axes.at(0).backlash.distance, 0);
}

TEST(MachineFile, WritingWhatWasReadChangesNothingAnyMore) {
    const std::string once = writeMachine(mill());
    const auto parsed = parseMachine(once);
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(writeMachine(parsed->machine, parsed->unknown), once);
}

TEST(MachineFile, NumbersSayTheirUnitByTheAxisChip) {
    const std::string text = writeMachine(mill());
    EXPECT_NE(text.find("\"velocity_counts_per_tick\": 8.0"), std::string::npos) << text;
    EXPECT_NE(text.find("\"velocity_steps_per_s\": 1200.0"), std::string::npos) << text;
    EXPECT_NE(text.find("\"time_limit_s\": 30.0"), std::string::npos) << text;
    EXPECT_NE(text.find("\"type\": \"PIC-STEP\""), std::string::npos) << text;
    EXPECT_NE(text.find("\"Drehteller ä\""), std::string::npos) << "letters are not escaped";
}

TEST(MachineFile, AnAxisWhoseChipChangesLosesTheOldUnitsKeys) {
    auto parsed = parseMachine(kSmall);
    ASSERT_TRUE(parsed.has_value());
    parsed->machine.axes.resize(1);
    parsed->machine.groups.clear();
    parsed->machine.axes[0].expected = ModuleIdentity{ModuleType::Stepper, 1};
    const std::string text = writeMachine(parsed->machine, parsed->unknown);
    EXPECT_EQ(text.find("_per_tick"), std::string::npos) << text;
    EXPECT_EQ(text.find("counts_per_unit"), std::string::npos) << text;
    const auto again = parseMachine(text);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->machine, parsed->machine);
}

// ---- unknown keys ----

TEST(MachineFile, UnknownKeysSurviveAtEveryLevelAndInPlace) {
    auto parsed = parseMachine(kSmall);
    ASSERT_TRUE(parsed.has_value());
    parsed->machine.axes[0].gains->kp = 150;
    parsed->machine.name = "Lathe";
    const std::string text = writeMachine(parsed->machine, parsed->unknown);
    // The keys in the order of the file.
    const std::string_view order[] = {"\"format\"",
                                      "\"version\"",
                                      "\"name\": \"Lathe\"",
                                      "\"made_by\"",
                                      "\"who\": \"Anna\"",
                                      "11.5",
                                      "null",
                                      "\"rate_bd\"",
                                      "\"axes\"",
                                      "\"colour\": \"#0072B2\"",
                                      "\"Z axis\"",
                                      "\"serial\": 77",
                                      "\"turns\"",
                                      "\"Kp\": 150",
                                      "\"tuned\": true",
                                      "\"OL\"",
                                      "\"groups\"",
                                      "\"why\": \"gantry\"",
                                      "\"notes\": \"greased in May\""};
    std::size_t at = 0;
    for (const std::string_view key : order) {
        const std::size_t found = text.find(key, at);
        ASSERT_NE(found, std::string::npos) << key << " does not follow its predecessor in\n" << text;
        at = found;
    }
    EXPECT_EQ(parseMachine(text)->machine, parsed->machine);
}

TEST(MachineFile, WhatIsNotThereAnyMoreTakesItsUnknownKeysWithIt) {
    auto parsed = parseMachine(kSmall);
    ASSERT_TRUE(parsed.has_value());
    parsed->machine.groups.clear();
    parsed->machine.axes.resize(1);
    const std::string text = writeMachine(parsed->machine, parsed->unknown);
    EXPECT_EQ(text.find("gantry"), std::string::npos);
    EXPECT_NE(text.find("greased"), std::string::npos);
    EXPECT_EQ(parseMachine(text)->machine, parsed->machine);
}

TEST(MachineFile, PastedControlCharactersAreWrittenAsBlanks) {
    Machine machine;
    machine.axes.resize(1);
    machine.axes[0].name = "X\naxis\x1B";
    const auto parsed = parseMachine(writeMachine(machine));
    ASSERT_TRUE(parsed.has_value());
    EXPECT_EQ(parsed->machine.axes[0].name, "X axis ");
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that are out of the chain: the settings of those behind them move up along with them.
#include "model/machinefile/axisremoval.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "model/sequence/sequenceedit.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing_support::kFirst;
using testing_support::kSecond;
using testing_support::kThird;

std::vector<AxisSettings> axesCalled(std::initializer_list<const char*> names) {
    std::vector<AxisSettings> axes;
    for (const char* name : names)
        axes.emplace_back().name = name;
    return axes;
}

/// X, Y and Z. No row uses Y, and each kind of row that names a module uses Z.
Machine xyz() {
    Machine machine;
    machine.axes = axesCalled({"X", "Y", "Z"});
    machine.groups = {{0x81, "Table", {kFirst, kSecond, kThird}, kThird}};
    machine.program.points = {{"All", {{kFirst, 1, true}, {kSecond, 2, true}, {kThird, 3, false}}}};
    machine.program.sequences = {
        {"Main",
         {action::Home{kThird}, action::MoveTo{"All"}, action::WaitForInput{kThird, InputPin::In1},
          action::SetOutput{kThird, 2}, action::WaitForAnalog{kThird}, action::Home{kFirst},
          action::Repeat{1, 2}}}};
    machine.homeOrder = {kThird, kSecond, kFirst};
    return machine;
}

TEST(AxisRemoval, WhateverNamesTheModulesBehindFollowsThem) {
    Machine xz;
    xz.axes = axesCalled({"X", "Z"});
    xz.groups = {{0x81, "Table", {kFirst, kSecond}, kSecond}};
    xz.program.points = {{"All", {{kFirst, 1, true}, {kSecond, 3, false}}}};
    xz.program.sequences = {{"Main",
                             {action::Home{kSecond}, action::MoveTo{"All"},
                              action::WaitForInput{kSecond, InputPin::In1}, action::SetOutput{kSecond, 2},
                              action::WaitForAnalog{kSecond}, action::Home{kFirst}, action::Repeat{1, 2}}}};
    xz.homeOrder = {kSecond, kFirst};
    EXPECT_EQ(withoutAxes({kSecond}, {xyz(), {}}).machine, xz);
}

TEST(AxisRemoval, AGroupLosesItsLeaderAndIsGoneWithItsOnlyModule) {
    Machine machine;
    machine.groups = {{0x81, "Table", {kFirst, kSecond}, kSecond}, {0x82, "", {kThird}, kThird}};
    const auto groups = withoutAxes({kSecond, kThird}, {machine, {}}).machine.groups;
    EXPECT_EQ(groups, (std::vector<GroupSettings>{{0x81, "Table", {kFirst}, std::nullopt}}));
}

TEST(AxisRemoval, SeveralGoAtOnceAndNeedNotHaveSettings) {
    Machine machine;
    machine.axes = axesCalled({"X", "Y"});
    EXPECT_EQ(withoutAxes({kFirst, kThird}, {machine, {}}).machine.axes, axesCalled({"Y"}));
    EXPECT_EQ(withoutAxes({kThird}, {Machine{}, {}}).machine, Machine{});
    EXPECT_EQ(indexWithout({kFirst, kThird}, kSecond), kFirst);
    EXPECT_EQ(indexWithout({kFirst, kThird}, ModuleIndex(3)), kSecond);
    EXPECT_EQ(indexWithout({kFirst, kThird}, kThird), std::nullopt);
}

TEST(AxisRemoval, AKeyThatThisProgramDoesNotKnowStaysWithItsAxis) {
    auto file = nlohmann::json::parse(writeMachine(xyz()));
    for (std::size_t i = 0; i < 3; ++i)
        file["axes"][i]["serial"] = i + 1;
    const auto parsed = parseMachine(file.dump());
    ASSERT_TRUE(parsed);
    const auto [machine, unknown] = withoutAxes({kSecond}, *parsed);
    const auto axes = nlohmann::json::parse(writeMachine(machine, unknown))["axes"];
    ASSERT_EQ(axes.size(), 2U);
    EXPECT_EQ(axes[0]["serial"], 1);
    EXPECT_EQ(axes[1]["name"], "Z");
    EXPECT_EQ(axes[1]["serial"], 3);
}

/// A point keeps its other axes, but a row about the module alone would have nothing left to do.
TEST(AxisRemoval, OnlyARowThatNamesTheModuleUsesIt) {
    EXPECT_EQ(userOfModules(xyz().program, {kSecond}), std::nullopt);
    EXPECT_EQ(userOfModules(xyz().program, {kSecond, kThird}), (RowPlace{"Main", 0}));
    EXPECT_EQ(userOfModules(xyz().program, {kFirst}), (RowPlace{"Main", 5}));
}

/// The numbers of a PIC-STEP are in steps, those of a PIC-SERVO in counts.
TEST(OtherModules, AnAxisForAnotherTypeBeginsAnewAndLeavesThePoints) {
    using testing_support::kServo;
    using testing_support::kStep;
    Machine machine = xyz();
    for (AxisSettings& axis : machine.axes) {
        axis.expected = kStep;
        axis.unit = {UnitKind::Millimetres, 200.0, {}};
        axis.motion.velocity = 2'000;
        axis.travel = {0, 40'000, 3'000};
        axis.homing.emplace().velocity = 400;
    }
    Machine after = machine;
    after.axes[1] = {};
    after.axes[1].name = "Y";
    after.axes[1].expected = kServo;
    after.program.points = {{"All", {{kFirst, 1, true}, {kThird, 3, false}}}};
    EXPECT_EQ(withModules({kStep, kServo, kStep}, machine), after);
}

TEST(OtherModules, AnotherVersionANewModuleAndOneThatIsMissingChangeNoNumbers) {
    using testing_support::kCmc;
    using testing_support::kServo;
    using testing_support::kStep;
    Machine machine = xyz();
    machine.axes[0].expected = kServo;
    for (AxisSettings& axis : machine.axes)
        axis.motion.velocity = 2;
    Machine after = machine;
    after.axes[0].expected = kCmc;
    after.axes[1].expected = kStep;
    EXPECT_EQ(withModules({kCmc, kStep}, machine), after);
    EXPECT_EQ(withModules({kCmc}, after), after) << "nor do those of module 2 lose their type";
    after.axes[2].expected = kServo;
    after.axes.emplace_back().expected = kServo;
    EXPECT_EQ(withModules({kCmc, kStep, kServo, kServo}, machine), after);
}

/// Whatever type is heard later, it must not be another one than expected.
TEST(OtherModules, OneWhoseTypeWasNotHeardIsNotExpected) {
    using testing_support::kServo;
    using testing_support::kStep;
    Machine machine = xyz();
    machine.axes[0].expected = kServo;
    Machine after = machine;
    after.axes[2].expected = kStep;
    EXPECT_EQ(withModules({kUnheardModule, kUnheardModule, kStep}, machine), after);
    EXPECT_EQ(withModules({kUnheardModule}, {}).axes, std::vector{AxisSettings{}});
    EXPECT_FALSE(isOtherType(kUnheardModule, kServo)) << "should a file say so";
}

/// Module 3 has 2000 steps/s, which would be 3.9 million counts/s for a PIC-SERVO in its place.
TEST(OtherModules, ANewModuleThatIsSetUpIsExpectedAndSoAreThoseBeforeIt) {
    using testing_support::kServo;
    using testing_support::kStep;
    const std::vector<ModuleIdentity> there{kServo, kServo, kStep, kServo};
    Machine machine;
    machine.axes.resize(4);
    machine.axes[0].expected = kServo;
    machine.axes[3].name = "No number";
    EXPECT_EQ(forModules(there, machine, machine), machine);
    Machine set = machine;
    set.axes[2].motion.velocity = 2'000;
    Machine taught = machine;
    taught.program.points = {{"All", {{kThird, 3, false}}}};
    Machine waits = machine;
    waits.program.sequences = {{"Main", {action::WaitForInput{kThird, InputPin::Limit1}}}};
    for (const Machine& edited : {set, taught, waits}) {
        Machine after = edited;
        after.axes[1].expected = kServo;
        after.axes[2].expected = kStep;
        EXPECT_EQ(forModules(there, machine, edited), after) << "as far as it, with no gap";
        EXPECT_EQ(forModules({}, machine, edited), edited) << "nothing is connected";
    }
}

/// The first edit of any axis makes the whole chain the expected one, also where nothing is set up.
TEST(OtherModules, AnAxisThatIsNotSetUpIsForTheModuleForWhichItIsFirstSetUp) {
    using testing_support::kServo;
    using testing_support::kStep;
    Machine machine = xyz();
    machine.program = {};
    machine.axes[0].expected = kServo;
    Machine edited = machine;
    edited.axes[0].motion.velocity = 2'000;
    Machine after = edited;
    after.axes[0].expected = kStep;
    EXPECT_EQ(forModules({kStep}, machine, edited), after);
    EXPECT_EQ(forModules({kStep}, edited, edited), edited) << "these numbers are those of the servo";
    EXPECT_EQ(forModules({kUnheardModule}, machine, edited), edited);
}

}  // namespace
}  // namespace nmc

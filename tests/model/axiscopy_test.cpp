// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of one axis for others: only to the same type of module, and only what was chosen.
#include "model/machinefile/axiscopy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "model/machinefile/machinefile.h"
#include "tests/model/machines.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::ids;
using testing_support::kFirst;
using testing_support::kIo;
using testing_support::kSc;
using testing_support::kSecond;
using testing_support::kServo;
using testing_support::kStep;
using testing_support::kThird;
using testing_support::servoAxis;

/// A chain of modules that answer and are off, in this order.
std::vector<ModuleState> chainOf(std::initializer_list<ModuleIdentity> identities) {
    std::vector<ModuleState> modules;
    for (const ModuleIdentity& identity : identities) {
        ModuleState& module = modules.emplace_back();
        const auto index = static_cast<std::uint8_t>(modules.size() - 1);
        module.info = {ModuleIndex(index), BusAddress(static_cast<std::uint8_t>(index + 1)), identity};
        StatusReport report;
        report.status = 0x09;  // power, move done
        report.position = 0;
        report.aux = 0;
        module.latest = report;
    }
    return modules;
}

AxisCopy copyOf(const AxisSettings& axis, std::vector<ModuleIndex> to, std::vector<MachinePart> parts = {}) {
    return {kFirst, axis, std::move(to), std::move(parts)};
}

TEST(AxisCopy, GoesOnlyToModulesOfTheSameType) {
    const auto modules = chainOf({kServo, kStep, {ModuleType::Servo, 3}, kIo, kSc});
    EXPECT_THAT(copyTargets(kFirst, {}, modules), ElementsAre(kThird, ModuleIndex(4)));
    EXPECT_THAT(copyTargets(kSecond, {}, modules), IsEmpty());
    EXPECT_THAT(copyTargets(ModuleIndex(9), {}, modules), IsEmpty()) << "there is no such module";
}

TEST(AxisCopy, NeitherFromNorToAnAxisWhoseModuleIsAnotherThanExpected) {
    const auto modules = chainOf({kServo, kServo, kServo});
    Machine machine;
    machine.axes.resize(3);
    machine.axes[1].expected = kStep;
    EXPECT_THAT(copyTargets(kFirst, machine, modules), ElementsAre(kThird));
    EXPECT_THAT(copyTargets(kSecond, machine, modules), IsEmpty()) << "its settings are those of a PIC-STEP";
    Machine copied = withCopy(copyOf(servoAxis(), {kSecond}), machine, modules);
    EXPECT_EQ(copied, machine);
}

TEST(AxisCopy, ChangesTheChosenPartsOfTheChosenAxesAndNothingElse) {
    const auto modules = chainOf({kServo, kServo, kServo});
    Machine machine;
    machine.axes.resize(3);
    machine.axes[0] = servoAxis();
    machine.axes[1].name = "Y axis";
    machine.axes[2].name = "Z axis";
    const AxisCopy copy = copyOf(servoAxis(), {kThird}, {MachinePart::Gains, MachinePart::Motion});
    const auto rows = copyDifferences(copy, machine, modules);
    EXPECT_THAT(ids(rows),
                ElementsAre(PartId{kThird, MachinePart::Motion}, PartId{kThird, MachinePart::Gains}))
        << "not the gains of the first, which its module has not been sent either";
    const Machine file = withCopy(copy, machine, modules);
    Machine wanted = machine;
    wanted.axes[2].motion = servoAxis().motion;
    wanted.axes[2].gains = servoAxis().gains;
    EXPECT_EQ(applied(file, machine, modules, ids(rows)), wanted);
    const auto sent = sendings(file, machine, modules, ids(rows));
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].module, kThird);
    const auto* apply = std::get_if<intent::ApplyGains>(&sent[0].intent);
    ASSERT_NE(apply, nullptr);
    EXPECT_EQ(apply->gains, *servoAxis().gains);
}

TEST(AxisCopy, TakesSettingsAwayThatTheOtherAxisHasNot) {
    const auto modules = chainOf({kServo, kServo});
    Machine machine;
    machine.axes.resize(2);
    machine.axes[1].travel = {-100, 100, 0.0};
    const AxisCopy copy = copyOf({}, {kSecond}, {MachinePart::Travel});
    const auto rows = copyDifferences(copy, machine, modules);
    ASSERT_EQ(rows.size(), 1U);
    const Machine result = applied(withCopy(copy, machine, modules), machine, modules, ids(rows));
    EXPECT_EQ(result.axes[1].travel, TravelSettings{});
}

TEST(AxisCopy, LimitPinsOfAnScStayWithScs) {
    const auto modules = chainOf({kServo, kSc, kServo});
    Machine machine;
    machine.axes.resize(3);
    machine.axes[1].fastPath = true;
    const Machine copied = withCopy(copyOf(servoAxis(), {kSecond, kThird}), machine, modules);
    EXPECT_EQ(copied.axes[1].io, std::nullopt);
    EXPECT_EQ(copied.axes[1].fastPath, true);
    EXPECT_EQ(copied.axes[1].gains, servoAxis().gains);
    EXPECT_EQ(copied.axes[2].io, servoAxis().io);
}

/// An axis with every setting there is, none of them the default. The names of all members are here so that
/// another one does not compile without a value of its own.
AxisSettings everySetting() {
    AxisSettings axis = servoAxis();
    auto& [name, expected, unit, motion, travel, backlash, arrival, homing, limitStop, workOffsets, analog,
           gains, io, fastPath, parameters, accelerationTime, outputNames, inputNames, pins] = axis;
    travel = {-5, 5, 4.0};
    backlash = {20, true};
    arrival = {5, 0.25};
    limitStop.eachMotion = true;
    workOffsets = {{"fixture A", 1'000}};
    analog.unit = "A";
    fastPath = true;
    parameters = testing_support::stepAxis().parameters;
    accelerationTime = 100;
    outputNames[0] = "Coolant";
    inputNames[0] = "Door";
    pins.emplace().pins.push_back({"Lamp", true, true});
    return axis;
}

nlohmann::json fileOf(const AxisSettings& axis) {
    Machine machine;
    machine.axes.push_back(axis);
    return nlohmann::json::parse(writeMachine(machine))["axes"][0];
}

/// The keys of the machine file that a part brings to an axis without settings.
std::vector<std::string> keysOf(MachinePart part) {
    Machine file;
    file.axes.push_back(everySetting());
    Machine now;
    now.axes.emplace_back().expected = everySetting().expected;
    const nlohmann::json before = fileOf(now.axes[0]);
    const nlohmann::json after = fileOf(applied(file, now, {}, {{kFirst, part}}).axes[0]);
    std::vector<std::string> keys;
    for (const auto& [key, value] : after.items())
        if (!before.contains(key) || before[key] != value)
            keys.push_back(key);
    return keys;
}

TEST(AxisCopy, EveryKeyOfAnAxisIsInExactlyOnePart) {
    std::map<std::string, int> parts;
    for (int part = 0; part <= static_cast<int>(MachinePart::Parameters); ++part)
        for (const std::string& key : keysOf(static_cast<MachinePart>(part)))
            ++parts[key];
    const nlohmann::json file = fileOf(everySetting());
    for (const auto& [key, value] : file.items())
        EXPECT_EQ(parts[key], key == "expected" ? 0 : 1) << key;
    EXPECT_EQ(file.size(), 19U) << "as many as an axis has members";
}

TEST(AxisCopy, EverySettingButNameAndWorkOffsetsCanBeCopied) {
    const auto modules = chainOf({kServo, kServo});
    Machine machine;
    machine.axes = {everySetting(), {}};
    machine.axes[1].name = "Y axis";
    machine.axes[1].expected = kServo;
    const AxisCopy copy = copyOf(everySetting(), {kSecond});
    const auto rows = copyDifferences(copy, machine, modules);
    const Machine result = applied(withCopy(copy, machine, modules), machine, modules, ids(rows));
    AxisSettings wanted = everySetting();
    wanted.name = "Y axis";
    wanted.workOffsets.clear();  // a place of the other axis
    EXPECT_EQ(result.axes[1], wanted);
}

}  // namespace
}  // namespace nmc

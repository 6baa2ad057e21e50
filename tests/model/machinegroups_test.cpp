// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/machinefile/machinegroups.h"

#include <gtest/gtest.h>

#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing_support::kFirst;
using testing_support::kSecond;
using testing_support::kThird;

std::vector<ModuleState> chainIn(const std::vector<std::optional<bus::GroupPlace>>& places) {
    std::vector<ModuleState> modules;
    for (const auto& place : places) {
        bus::ModuleInfo& info = modules.emplace_back().info;
        info.index = ModuleIndex(static_cast<std::uint8_t>(modules.size() - 1));
        info.group = place;
    }
    return modules;
}

TEST(MachineGroups, PutEachModuleWhereItBelongsTheLeaderLast) {
    Machine machine;
    machine.groups.push_back({0x81, "gantry", {kFirst, kSecond}, kFirst});
    const auto changes =
        groupChanges(machine, chainIn({bus::GroupPlace{}, bus::GroupPlace{}, bus::GroupPlace{}}));
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0], (bus::GroupChange{kSecond, {0x81, false}}));
    EXPECT_EQ(changes[1], (bus::GroupChange{kFirst, {0x81, true}}));
}

TEST(MachineGroups, WhatIsThereAlreadyIsLeftAloneAndWhatIsUnknownIsNot) {
    Machine machine;
    machine.groups.push_back({0x81, {}, {kFirst}, {}});
    const auto changes = groupChanges(
        machine, chainIn({bus::GroupPlace{0x81, false}, std::nullopt, bus::GroupPlace{0x82, true}}));
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_EQ(changes[0], (bus::GroupChange{kSecond, {0xFF, false}}));
    EXPECT_EQ(changes[1], (bus::GroupChange{kThird, {0xFF, false}}));
}

TEST(MachineGroups, AModuleIsInOneGroupOnly) {
    Machine machine;
    noteGroup(machine, {kSecond, {0x81, false}});
    noteGroup(machine, {kFirst, {0x81, true}});
    ASSERT_EQ(machine.groups.size(), 1U);
    EXPECT_EQ(machine.groups[0].members, (std::vector{kFirst, kSecond}));
    EXPECT_EQ(machine.groups[0].leader, kFirst);
    noteGroup(machine, {kFirst, {0x82, false}});
    ASSERT_EQ(machine.groups.size(), 2U);
    EXPECT_EQ(machine.groups[0].leader, std::nullopt);
    noteGroup(machine, {kSecond, {0xFF, false}});
    ASSERT_EQ(machine.groups.size(), 1U);
    EXPECT_EQ(machine.groups[0].address, 0x82);
}

TEST(MachineGroups, ANameStaysWhenTheLastMemberGoes) {
    Machine machine;
    nameGroup(machine, 0x81, "Table");
    noteGroup(machine, {kFirst, {0x81, false}});
    noteGroup(machine, {kFirst, {0xFF, false}});
    ASSERT_EQ(machine.groups.size(), 1U);
    EXPECT_EQ(machine.groups[0].name, "Table");
    EXPECT_TRUE(machine.groups[0].members.empty());
    nameGroup(machine, 0x81, "");
    EXPECT_TRUE(machine.groups.empty());
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "model/machinefile/machinegroups.h"

#include <algorithm>

namespace nmc {

namespace {

/// The group of all modules, in which each one starts.
constexpr std::uint8_t kNoGroup = 0xFF;

[[nodiscard]] bus::GroupPlace placeOf(ModuleIndex module, const Machine& machine) {
    for (const GroupSettings& group : machine.groups)
        if (std::ranges::find(group.members, module) != group.members.end())
            return {group.address, group.leader == module};
    return {kNoGroup, false};
}

[[nodiscard]] GroupSettings& settingsOf(Machine& machine, std::uint8_t address) {
    for (GroupSettings& group : machine.groups)
        if (group.address == address)
            return group;
    return machine.groups.emplace_back(GroupSettings{address, {}, {}, {}});
}

void forgetEmpty(Machine& machine) {
    std::erase_if(machine.groups,
                  [](const GroupSettings& group) { return group.members.empty() && group.name.empty(); });
}

}  // namespace

std::vector<bus::GroupChange> groupChanges(const Machine& machine, const std::vector<ModuleState>& modules) {
    std::vector<bus::GroupChange> changes;
    for (const ModuleState& module : modules) {
        const bus::GroupPlace wanted = placeOf(module.info.index, machine);
        if (!module.readOnly && !module.lent && module.info.group != wanted)
            changes.push_back({module.info.index, wanted});
    }
    std::stable_partition(changes.begin(), changes.end(),
                          [](const bus::GroupChange& change) { return !change.place.leader; });
    return changes;
}

void noteGroup(Machine& machine, const bus::GroupChange& change) {
    for (GroupSettings& group : machine.groups) {
        std::erase(group.members, change.module);
        if (group.leader == change.module)
            group.leader.reset();
    }
    if (change.place.group != kNoGroup) {
        GroupSettings& group = settingsOf(machine, change.place.group);
        group.members.push_back(change.module);
        std::ranges::sort(group.members);
        if (change.place.leader)
            group.leader = change.module;
    }
    forgetEmpty(machine);
}

void nameGroup(Machine& machine, std::uint8_t address, const std::string& name) {
    settingsOf(machine, address).name = name;
    forgetEmpty(machine);
}

}  // namespace nmc

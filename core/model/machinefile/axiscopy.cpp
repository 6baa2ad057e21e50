// SPDX-License-Identifier: MIT
#include "model/machinefile/axiscopy.h"

#include <algorithm>
#include <utility>

namespace nmc {

namespace {

bool isExpected(const ModuleState& module, const Machine& machine) {
    const auto& expected = machine.axis(module.info.index).expected;
    return module.isKnown() && (!expected || *expected == module.info.identity);
}

template <typename T>
bool contains(const std::vector<T>& values, const T& value) {
    return std::ranges::find(values, value) != values.end();
}

}  // namespace

std::vector<ModuleIndex> copyTargets(ModuleIndex from, const Machine& machine,
                                     const std::vector<ModuleState>& modules) {
    std::vector<ModuleIndex> targets;
    if (from.value() >= modules.size() || !isExpected(modules[from.value()], machine))
        return targets;
    for (const ModuleState& module : modules)
        if (module.info.index != from && isExpected(module, machine) &&
            module.info.identity.type == modules[from.value()].info.identity.type)
            targets.push_back(module.info.index);
    return targets;
}

Machine withCopy(const AxisCopy& copy, Machine now, const std::vector<ModuleState>& modules) {
    const auto possible = copyTargets(copy.from, now, modules);
    now.axes.resize(std::max(now.axes.size(), modules.size()));
    for (const ModuleIndex to : possible) {
        if (!contains(copy.to, to))
            continue;
        AxisSettings& axis = now.axes[to.value()];
        const AxisSettings before = std::exchange(axis, copy.settings);
        axis.name = before.name;
        axis.expected = before.expected;
        axis.workOffsets = before.workOffsets;
        if (isSc(modules[to.value()].info.identity) != isSc(modules[copy.from.value()].info.identity)) {
            axis.io = before.io;
            axis.fastPath = before.fastPath;
        }
    }
    return now;
}

std::vector<Difference> copyDifferences(const AxisCopy& copy, const Machine& now,
                                        const std::vector<ModuleState>& modules) {
    std::vector<Difference> rows = compare(withCopy(copy, now, modules), now, modules);
    std::erase_if(rows, [&copy](const Difference& row) {
        return !row.id.module || !contains(copy.to, *row.id.module) || !row.possible() ||
               !(copy.parts.empty() || contains(copy.parts, row.id.part));
    });
    return rows;
}

}  // namespace nmc

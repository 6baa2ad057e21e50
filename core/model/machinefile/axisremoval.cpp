// SPDX-License-Identifier: MIT
#include "model/machinefile/axisremoval.h"

#include <algorithm>
#include <functional>

#include "model/machinefile/fieldwriter.h"
#include "model/machinefile/machinegroups.h"

namespace nmc {

namespace {

using Gone = std::vector<ModuleIndex>;

[[nodiscard]] bool isGone(const Gone& gone, ModuleIndex module) {
    return std::ranges::find(gone, module) != gone.end();
}

/// `module`: the member that names the module.
template <typename T, typename Member = std::identity>
void renumber(std::vector<T>& all, const Gone& gone, Member module = {}) {
    std::erase_if(all, [&](const T& one) { return isGone(gone, std::invoke(module, one)); });
    for (T& one : all)
        std::invoke(module, one) = *indexWithout(gone, std::invoke(module, one));
}

void renumber(Action& row, const Gone& gone) {
    std::visit(
        [&gone](auto& action) {
            if constexpr (requires { action.module; })
                action.module = indexWithout(gone, action.module).value_or(action.module);
        },
        row);
}

/// `axes`: by index.
template <typename Axes>
[[nodiscard]] Axes left(const Gone& gone, Axes axes, Axes kept) {
    for (std::size_t i = 0; i < axes.size(); ++i)
        if (!isGone(gone, ModuleIndex(static_cast<std::uint8_t>(i))))
            kept.push_back(std::move(axes[i]));
    return kept;
}

/// Unknown keys stand in the axes of the file, in the same order.
[[nodiscard]] UnknownKeys left(const Gone& gone, const UnknownKeys& unknown) {
    using Json = layout::FieldWriter::Json;
    Json file = Json::parse(unknown.text, nullptr, false);
    if (!file.is_object() || !file.contains("axes") || !file["axes"].is_array())
        return unknown;
    file["axes"] = left(gone, file["axes"], Json::array());
    return {layout::fileText(file)};
}

}  // namespace

std::optional<ModuleIndex> indexWithout(const std::vector<ModuleIndex>& gone, ModuleIndex module) {
    if (isGone(gone, module))
        return std::nullopt;
    const auto before = std::ranges::count_if(gone, [module](ModuleIndex other) { return other < module; });
    return ModuleIndex(static_cast<std::uint8_t>(module.value() - before));
}

ParsedMachine withoutAxes(const std::vector<ModuleIndex>& gone, ParsedMachine from) {
    Machine& machine = from.machine;
    for (const ModuleIndex module : gone)
        noteGroup(machine, {module, {}});
    for (GroupSettings& group : machine.groups) {
        renumber(group.members, gone);
        if (group.leader)
            group.leader = indexWithout(gone, *group.leader);
    }
    for (Point& point : machine.program.points)
        renumber(point.axes, gone, &PointAxis::module);
    for (Sequence& sequence : machine.program.sequences)
        for (Action& row : sequence.rows)
            renumber(row, gone);
    renumber(machine.homeOrder, gone);
    machine.axes = left(gone, std::move(machine.axes), {});
    from.unknown = left(gone, from.unknown);
    return from;
}

Machine withModules(const std::vector<ModuleIdentity>& there, Machine machine) {
    machine.axes.resize(std::max(machine.axes.size(), there.size()));
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (there[i] == kUnheardModule)
            continue;
        AxisSettings& axis = machine.axes[i];
        if (isOtherType(axis.expected, there[i])) {
            axis = usable(axis, there[i]);
            for (Point& point : machine.program.points)
                std::erase_if(point.axes, [i](const PointAxis& place) { return place.module.value() == i; });
        }
        axis.expected = there[i];
    }
    return machine;
}

Machine forModules(const std::vector<ModuleIdentity>& there, const Machine& before, Machine edited) {
    bool behind = false;
    for (std::size_t i = there.size(); i-- > 0;) {
        const ModuleIndex module(static_cast<std::uint8_t>(i));
        const auto expected = edited.axis(module).expected;
        const bool isNew = isSetUp(edited, module) &&
                           (!expected || (isOtherType(expected, there[i]) && !isSetUp(before, module)));
        if ((isNew || (behind && !expected)) && there[i] != kUnheardModule) {
            edited.axes.resize(std::max(edited.axes.size(), i + 1));
            edited.axes[i].expected = there[i];
        }
        behind = behind || isNew;
    }
    return edited;
}

}  // namespace nmc

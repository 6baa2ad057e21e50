// SPDX-License-Identifier: MIT
#include "model/path/pathplan.h"

#include <algorithm>
#include <cstdlib>

#include "model/intent/travel.h"

namespace nmc {

namespace {

[[nodiscard]] std::optional<PathObstacle> notReady(servo::PathRate rate, const ModuleState& module) {
    const auto of = [&](PathObstacle::Kind kind) {
        return PathObstacle{.kind = kind, .module = module.info.index};
    };
    if (const auto refusal = whyNot(IntentKind::Move, module))
        return PathObstacle{.module = module.info.index, .refusal = refusal};
    if (!hasPathBuffer(module.info.identity))
        return of(PathObstacle::Kind::NoPathBuffer);
    if (!module.pathControl)
        return of(PathObstacle::Kind::ControlUnknown);
    if (module.pathControl->stepAndDirection)
        return of(PathObstacle::Kind::StepAndDirection);
    if (!servo::toPathWord({0, rate}, module.pathControl->fastPath))
        return of(PathObstacle::Kind::WrongFastPath);
    if (module.servoRate != 1) {
        PathObstacle obstacle = of(PathObstacle::Kind::ServoRate);
        obstacle.value = module.servoRate.value_or(0);
        return obstacle;
    }
    return module.commandPosition() ? std::nullopt : std::optional(of(PathObstacle::Kind::PlaceUnknown));
}

/// Checks the segment to a point.
[[nodiscard]] std::optional<PathObstacle> wrongSegment(std::int64_t before, std::int64_t point,
                                                       servo::PathRate rate, const ModuleState& module) {
    const auto distance = static_cast<double>(std::abs(point - before));
    if (const int most = servo::maxPathCounts(rate); distance > most)
        return PathObstacle{
            .kind = PathObstacle::Kind::Jump, .value = distance, .allowed = static_cast<double>(most)};
    if (const double fastest = module.travel.fastest;
        fastest > 0.0 && distance > longestSegment(fastest, rate))
        return PathObstacle{.kind = PathObstacle::Kind::TooFast,
                            .value = distance / servo::ticksPerPoint(rate),
                            .allowed = fastest};
    if (const auto range = travelRange(module))
        if (const auto problem = beyondTravel(before, point, *range))
            return PathObstacle{.kind = PathObstacle::Kind::BeyondTravel,
                                .value = static_cast<double>(point),
                                .allowed = static_cast<double>(problem->limit)};
    return std::nullopt;
}

/// The group that has exactly these modules as members.
[[nodiscard]] std::optional<std::uint8_t> groupOf(const PathTable& table,
                                                  std::span<const ModuleState> modules) {
    const auto& place = modules[table.columns.front().module.value()].info.group;
    if (!place || BusAddress(place->group) == bus::kEverybody)
        return std::nullopt;
    const bool theirs = std::ranges::all_of(modules, [&](const ModuleState& module) {
        const bool axis = std::ranges::any_of(table.columns, [&](const PathTable::Column& column) {
            return column.module == module.info.index;
        });
        return module.info.group && (module.info.group->group == place->group) == axis;
    });
    return theirs ? std::optional(place->group) : std::nullopt;
}

[[nodiscard]] bool wellFormed(const PathTable& table, std::span<const ModuleState> modules) {
    if (table.columns.empty() || table.columns.front().points.empty())
        return false;
    for (const PathTable::Column& column : table.columns) {
        const auto same = std::ranges::count(table.columns, column.module, &PathTable::Column::module);
        if (same != 1 || moduleAt(column.module, modules) == nullptr ||
            column.points.size() != table.columns.front().points.size())
            return false;
    }
    return true;
}

}  // namespace

std::optional<PathObstacle> obstacle(const bus::PathAxis& axis, servo::PathRate rate,
                                     const ModuleState& module) {
    if (auto obstacle = notReady(rate, module))
        return obstacle;
    std::int32_t before = *module.commandPosition();
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
        if (auto obstacle = wrongSegment(before, axis.points[i], rate, module)) {
            if (i == 0 && obstacle->kind == PathObstacle::Kind::Jump)
                obstacle->kind = PathObstacle::Kind::TooFarToStart;
            obstacle->module = axis.module;
            obstacle->point = i + 1;
            return obstacle;
        }
        before = axis.points[i];
    }
    return std::nullopt;
}

tl::expected<intent::FollowPath, PathObstacle> planPath(const PathTable& table,
                                                        std::span<const ModuleState> modules,
                                                        const PathLine& line) {
    if (!wellFormed(table, modules))
        return tl::unexpected(PathObstacle{.kind = PathObstacle::Kind::NoPoints});
    const auto plan = std::make_shared<bus::PathPlan>();
    plan->rate = table.rate;
    plan->smoothStop = true;
    std::vector<ModuleIdentity> axes;
    for (const PathTable::Column& column : table.columns) {
        const ModuleState& module = *moduleAt(column.module, modules);
        bus::PathAxis axis{column.module, module.commandPosition().value_or(0), column.points};
        if (auto problem = obstacle(axis, table.rate, module))
            return tl::unexpected(*problem);
        plan->smoothStop = plan->smoothStop && module.canDecelerate();
        plan->axes.push_back(std::move(axis));
        axes.push_back(module.info.identity);
    }
    if (plan->axes.size() > 1 && !(plan->group = groupOf(table, modules)))
        return tl::unexpected(PathObstacle{.kind = PathObstacle::Kind::NotAGroup});
    if (const double share = pathShare(line, table.rate, axes, modules.size()); share > kPathAvailable)
        return tl::unexpected(
            PathObstacle{.kind = PathObstacle::Kind::BusTooSlow, .value = share, .allowed = kPathAvailable});
    return intent::FollowPath{plan};
}

std::optional<Refusal> whyNot(const intent::FollowPath& follow, const ModuleState& module) {
    if (!follow.plan || follow.plan->axes.empty() || follow.plan->axes.front().module != module.info.index)
        return Refusal::PathNotPossible;
    const bus::PathAxis& axis = follow.plan->axes.front();
    const auto problem = obstacle(axis, follow.plan->rate, module);
    if (problem)
        return problem->refusal.value_or(Refusal::PathNotPossible);
    return module.commandPosition() == axis.from ? std::nullopt : std::optional(Refusal::PathNotPossible);
}

}  // namespace nmc

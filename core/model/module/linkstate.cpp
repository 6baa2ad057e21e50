// SPDX-License-Identifier: MIT
#include "model/module/linkstate.h"

#include <algorithm>
#include <utility>

#include "bus/exchange.h"
#include "bus/pollschedule.h"

namespace nmc {

void LinkState::take(const Machine& machine) {
    static const AxisSettings none;
    for (ModuleState& module : modules) {
        const AxisSettings& ofMachine = machine.axis(module.info.index);
        const bool other = isOtherType(ofMachine.expected, module.info.identity);
        const AxisSettings& axis = other ? none : ofMachine;
        module.expected = ofMachine.expected;
        module.nothingSetUp = other && !isSetUp(machine, module.info.index);
        module.unit = axis.unit.kind;
        module.travel = axis.travel;
        module.backlash = axis.backlash;
        module.limitStop = axis.limitStop;
        module.home.keepWork(axis.workOffsets);
    }
}

Machine usable(Machine machine, const std::vector<ModuleState>& modules) {
    for (std::size_t i = 0; i < std::min(machine.axes.size(), modules.size()); ++i)
        machine.axes[i] = usable(machine.axes[i], modules[i].info.identity);
    return machine;
}

bool isSetUp(const Machine& machine, ModuleIndex module) {
    AxisSettings axis = machine.axis(module);
    axis.name.clear();
    axis.expected.reset();
    const auto isIn = [module](const Point& point) {
        return std::ranges::find(point.axes, module, &PointAxis::module) != point.axes.end();
    };
    const auto isUsed = [module](const Sequence& sequence) {
        return std::ranges::any_of(sequence.rows,
                                   [module](const Action& row) { return moduleOf(row) == module; });
    };
    return axis != AxisSettings{} || std::ranges::any_of(machine.program.points, isIn) ||
           std::ranges::any_of(machine.program.sequences, isUsed);
}

ModuleState asShown(ModuleState module, const LinkState& link) {
    module.lookedFor = link.phase == LinkPhase::Connecting && link.looking;
    if (link.phase != LinkPhase::Connected && !module.lookedFor) {
        module.notAsked =
            link.phase == LinkPhase::Lost && link.quiet && !module.silent && !module.hasRestarted;
        module.silent = true;
        module.repliesPerSecond = 0;
    }
    return module;
}

LinkState asShown(LinkState link) {
    for (ModuleState& module : link.modules)
        module = asShown(std::move(module), link);
    return link;
}

bool isMissing(const ModuleState& module) {
    return module.silent && !module.latest && !module.hasRestarted;
}

std::vector<ModuleIndex> movingModules(const LinkState& link) {
    std::vector<ModuleIndex> moving;
    for (const ModuleState& module : link.modules)
        if (module.stillMoves())
            moving.push_back(module.info.index);
    return moving;
}

namespace {

/// The planned interval between two polls of a module. On a bad line, replies arrive more rarely, but the
/// latest one is out of date all the same.
[[nodiscard]] Duration expectedPollOf(const LinkState& link, const ModuleState& module) {
    if (link.focused && link.focused != module.info.index)
        return bus::PollSchedule::kInSight;
    constexpr std::size_t kQuestion = 5;  // bytes of a Read Status
    Duration round{};
    bus::LineTiming timing;
    timing.byteTime = byteTimeAtBaud(link.baud == 0 ? kPowerUpBaud : link.baud);
    for (const ModuleState& each : link.modules) {
        const ModuleIdentity& identity = each.info.identity;
        round +=
            timing.wireTime(kQuestion, replyLength(identity, bus::fullItems(identity))) + timing.adapter();
    }
    return std::max(bus::PollSchedule::kBackground, round);
}

}  // namespace

bool isLive(const LinkState& link, const ModuleState& module) {
    /// Never treats a status as out of date before this.
    constexpr Duration kOldAfter = std::chrono::milliseconds(500);
    constexpr int kPeriods = 3;
    if (link.phase != LinkPhase::Connected || module.silent || module.positionDoubtful())
        return false;
    if (!link.now || !module.latest)
        return true;
    const Duration oldAfter = std::max<Duration>(kOldAfter, kPeriods * expectedPollOf(link, module));
    return *link.now - module.latestTime <= oldAfter;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
// A path beside all else that the engine does: how it begins, and who stops when it ends.
#include <algorithm>
#include <utility>

#include "bus/engine.h"

namespace nmc::bus {

void Engine::beginPath(const Operation& operation, TimePoint now) {
    const auto motion = [&](const PathAxis& axis) {
        return m_hold.holds(axis.module) || m_operations.swings(axis.module);
    };
    const auto& axes = operation.path->axes;
    if (std::any_of(axes.begin(), axes.end(), motion) || !m_path.begin(operation))
        m_events.emplace_back(rejected(operation, Outcome::Forbidden));
    else
        m_chain.schedule().unfocus();
    proceed(now);
}

void Engine::leavePath(const std::vector<ModuleIndex>& stopped) {
    if (!m_path.isFor(stopped))
        return;
    m_path.overtake(stopped);
    dropWorkOf(m_path);
}

void Engine::stopPath() {
    m_path.noteSilence();
    PathTask::Stops stops = m_path.takeStops();
    if (stops.modules.empty())
        return;
    dropWorkOf(m_path);
    for (const ModuleIndex module : stops.modules)
        m_chain.owe(module, StopCause::PathEnded, stops.manner);
    m_unacknowledged.tellTogether(std::move(stops.modules));
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "model/scope/flightrecorder.h"

#include <algorithm>

namespace nmc {

unsigned FlightRecorder::note(std::optional<ModuleIndex> module, TimePoint at, const History& history) {
    if (m_incidents.size() == kKept)
        m_incidents.pop_front();
    m_incidents.push_back({++m_noted, module, at});
    take(m_incidents.back(), history);
    return m_noted;
}

void FlightRecorder::take(Incident& incident, const History& history) {
    if (!incident.history.zero() || incident.history.zero() == history.zero())
        incident.history = history.cut(incident.at - kBefore, incident.at + kAfter);
}

void FlightRecorder::keep(const History& history, TimePoint now) {
    for (Incident& incident : m_incidents) {
        if (incident.whole || now < incident.at + kAfter)
            continue;
        take(incident, history);
        incident.whole = true;
    }
}

void FlightRecorder::keepAll(const History& history) {
    keep(history, TimePoint::max());
}

const FlightRecorder::Incident* FlightRecorder::find(unsigned number, const History& history) {
    const auto found = std::ranges::find(m_incidents, number, &Incident::number);
    if (found == m_incidents.end())
        return nullptr;
    if (!found->whole)
        take(*found, history);
    return &*found;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "model/scope/flightrecorder.h"

#include <algorithm>

namespace nmc {

void FlightRecorder::note(std::string key, std::optional<ModuleIndex> module, TimePoint at) {
    std::erase_if(m_incidents, [&key](const Incident& incident) { return incident.key == key; });
    if (m_incidents.size() == kKept)
        m_incidents.pop_front();
    m_incidents.push_back({std::move(key), module, at});
}

void FlightRecorder::take(Incident& incident, const History& history) {
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

const FlightRecorder::Incident* FlightRecorder::find(const std::string& key, const History& history) {
    const auto found =
        std::ranges::find_if(m_incidents, [&key](const Incident& incident) { return incident.key == key; });
    if (found == m_incidents.end())
        return nullptr;
    if (!found->whole)
        take(*found, history);
    return &*found;
}

}  // namespace nmc

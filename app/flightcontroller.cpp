// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flightcontroller.h"

#include <QTime>

#include "link/clock.h"
#include "widgets/common/dates.h"
#include "widgets/common/texts.h"

namespace nmc {

unsigned FlightController::note(const QString& what, std::optional<ModuleIndex> module, TimePoint at) {
    const unsigned record = m_recorder.note(module, at, m_store.history());
    const LinkState& link = m_store.link();
    m_circumstances[record] = {texts::recordTitle(what, QTime::currentTime()), m_window.scopeModules(),
                               QString::fromStdString(link.port), link.simulated, dateOf(at, monotonicNow())};
    if (m_circumstances.size() > FlightRecorder::kKept)
        m_circumstances.erase(m_circumstances.begin());
    return m_recorder.find(record, m_store.history())->history.empty() ? 0 : record;
}

void FlightController::show(unsigned record) {
    const FlightRecorder::Incident* incident = m_recorder.find(record, m_store.history());
    if (incident == nullptr)
        return m_window.showMessage(texts::recordNotKept(FlightRecorder::kKept));
    const Circumstances& then = m_circumstances[record];
    const double at = toSeconds(incident->at - *incident->history.zero());
    m_window.showRecord(std::make_shared<const ScopeRecord>(
        ScopeRecord{then.title, incident->history, then.modules, incident->module, incident->at,
                    ScopeOrigin{then.port, then.simulated, then.date.addMSecs(-qRound64(at * 1e3))}}));
}

}  // namespace nmc

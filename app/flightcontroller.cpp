// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flightcontroller.h"

#include <QTime>

#include "link/clock.h"
#include "widgets/common/texts.h"

namespace nmc {

void FlightController::note(const QString& key, const QString& what, std::optional<ModuleIndex> module,
                            TimePoint at) {
    m_recorder.note(key.toStdString(), module, at);
    const LinkState& link = m_store.link();
    m_circumstances[key.toStdString()] = {
        texts::recordTitle(what, QTime::currentTime()), m_window.scopeModules(),
        QString::fromStdString(link.port), link.simulated,
        QDateTime::currentDateTime().addMSecs(-qRound64(toSeconds(monotonicNow() - at) * 1e3))};
}

bool FlightController::show(const QString& key) {
    const FlightRecorder::Incident* incident = m_recorder.find(key.toStdString(), m_store.history());
    if (incident == nullptr || incident->history.empty())
        return false;
    const Circumstances& then = m_circumstances[incident->key];
    const double at = toSeconds(incident->at - *incident->history.zero());
    m_window.showRecord(std::make_shared<const ScopeRecord>(ScopeRecord{
        then.title, incident->history, then.modules, then.simulated, incident->module, incident->at,
        ScopeOrigin{then.port, then.simulated, then.date.addMSecs(-qRound64(at * 1e3))}}));
    return true;
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flightcontroller.h"

#include <QTime>

#include "widgets/common/texts.h"

namespace nmc {

void FlightController::note(const QString& key, const QString& what, std::optional<ModuleIndex> module,
                            TimePoint at) {
    m_recorder.note(key.toStdString(), module, at);
    m_circumstances[key.toStdString()] = {texts::recordTitle(what, QTime::currentTime()),
                                          m_window.scopeModules(), m_store.link().simulated};
}

bool FlightController::show(const QString& key) {
    const FlightRecorder::Incident* incident = m_recorder.find(key.toStdString(), m_store.history());
    if (incident == nullptr || incident->history.empty())
        return false;
    const Circumstances& then = m_circumstances[incident->key];
    m_window.showRecord(std::make_shared<const ScopeRecord>(ScopeRecord{
        then.title, incident->history, then.modules, then.simulated, incident->module, incident->at}));
    return true;
}

}  // namespace nmc

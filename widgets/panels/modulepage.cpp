// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepage.h"

namespace nmc {

namespace {
/// Stops are never held back; everything else waits for the answer to the click before.
bool isStop(const Intent& intent) {
    return std::holds_alternative<intent::StopSmoothly>(intent) ||
           std::holds_alternative<intent::StopAbruptly>(intent) ||
           std::holds_alternative<intent::StopHere>(intent) ||
           std::holds_alternative<intent::MotorOff>(intent) ||
           std::holds_alternative<intent::CancelProcedure>(intent);
}
}  // namespace

void ModulePage::pass(const Intent& intent) {
    if (!isStop(intent)) {
        if (m_askedAt.has_value())
            return;
        m_askedAt = m_latestTime;
        setBusy(true);
    }
    emit intentRequested(m_module, intent);
}

void ModulePage::passSettings(const AxisSettings& settings) {
    emit settingsEdited(m_module, settings);
}

void ModulePage::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    if (m_askedAt.has_value() &&
        (module.info.index != m_module || module.latestTime != *m_askedAt || !view.connected)) {
        m_askedAt.reset();
        setBusy(false);
    }
    m_module = module.info.index;
    m_latestTime = module.latestTime;
    showBoxes(view);
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepage.h"

namespace nmc {

void ModulePage::pass(const Intent& intent) {
    if (!isStop(intent) && !std::holds_alternative<intent::CancelProcedure>(intent)) {
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

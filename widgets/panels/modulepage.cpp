// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepage.h"

#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/focuskeeper.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

void ModulePage::layOut(QWidget* head, QLayout* motions, QTabWidget* pages) {
    pages->setDocumentMode(true);
    pages->tabBar()->setAccessibleName(pages->accessibleName());
    pages->tabBar()->setObjectName(pages->objectName() + u"Bar"_s);
    keepFocusOnTabs(*pages);
    const int unit = look::gridUnit(this);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(unit * 3 / 2);
    columns->addLayout(motions, 5);
    columns->addWidget(pages, 4);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit / 2, unit, unit);
    layout->setSpacing(unit / 2);
    layout->addWidget(head);
    layout->addLayout(columns, 1);
}

void ModulePage::pass(const Intent& intent) {
    if (!isStop(intent) && !std::holds_alternative<intent::CancelProcedure>(intent)) {
        if (m_askedAt.has_value())
            return;
        m_askedAt = m_latestTime;
        setBusy(true);
    }
    emit intentRequested(m_module, intent);
}

void ModulePage::passEdit(const SettingsEdit& edit) {
    AxisSettings settings = m_settings;
    edit(settings);
    if (m_showing || settings == m_settings)
        return;
    m_settings = settings;
    emit settingsEdited(m_module, settings);
}

void ModulePage::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    if (m_askedAt.has_value() && (module.info.index != m_module || !view.connected ||
                                  (module.latestTime != *m_askedAt && !module.awaited))) {
        m_askedAt.reset();
        setBusy(false);
    }
    m_module = module.info.index;
    m_latestTime = module.latestTime;
    m_settings = view.settings;
    const QScopedValueRollback<bool> showing(m_showing, true);
    showBoxes(view);
}

}  // namespace nmc

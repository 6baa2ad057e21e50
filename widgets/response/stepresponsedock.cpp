// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepresponsedock.h"

#include <QAction>
#include <QScrollArea>

#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepResponseDock::StepResponseDock(QWidget* parent)
    : QDockWidget(StepResponsePage::tr("Step response"), parent) {
    look::name(this, u"stepResponseDock"_s, windowTitle());
    setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    toggleViewAction()->setShortcut(Qt::Key_F9);
    connect(toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
        if (shown)
            open();
    });
    // Not showEvent: a dock behind another's tab is shown, but not seen.
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        m_seen = seen;
        if (seen) {
            page();
            emit opened();
        }
    });
}

StepResponsePage& StepResponseDock::page() {
    if (m_page == nullptr) {
        m_page = new StepResponsePage(this);
        connect(m_page, &StepResponsePage::asked, this, &StepResponseDock::asked);
        connect(m_page, &StepResponsePage::gainsWanted, this, &StepResponseDock::gainsWanted);
        connect(m_page, &StepResponsePage::saveRequested, this, &StepResponseDock::saveRequested);
        setWidget(scrolled(m_page));
    }
    return *m_page;
}

void StepResponseDock::open() {
    show();
    raise();
    emit roomWanted();
}

void StepResponseDock::showModule(const PanelView& view) {
    if (m_seen)
        page().showModule(view);
}

void StepResponseDock::showNothing() {
    if (m_seen)
        page().showNothing();
}

}  // namespace nmc

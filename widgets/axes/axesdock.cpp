// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/axes/axesdock.h"

#include <QAction>
#include <QScrollArea>

#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"

namespace nmc {

using namespace Qt::StringLiterals;

AxesDock::AxesDock(QWidget* parent) : QDockWidget(AxesPage::tr("All axes"), parent) {
    look::name(this, u"axesDock"_s, windowTitle());
    setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    toggleViewAction()->setShortcut(Qt::Key_F4);
    connect(toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
        if (shown)
            raise();
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

AxesPage& AxesDock::page() {
    if (m_page == nullptr) {
        m_page = new AxesPage(this);
        m_page->setHoldInterval(m_holdInterval);
        connect(m_page, &AxesPage::intentRequested, this, &AxesDock::intentRequested);
        connect(m_page, &AxesPage::holdRequested, this, &AxesDock::holdRequested);
        connect(m_page, &AxesPage::holdReleased, this, &AxesDock::holdReleased);
        connect(m_page, &AxesPage::homeAllRequested, this, &AxesDock::homeAllRequested);
        connect(m_page, &AxesPage::homeOrderEdited, this, &AxesDock::homeOrderEdited);
        setWidget(scrolled(m_page));
    }
    return *m_page;
}

void AxesDock::showModules(const std::vector<PanelView>& views, const Machine& machine) {
    if (m_seen)
        page().showModules(views, machine);
}

void AxesDock::forgetModules() {
    if (m_page != nullptr)
        m_page->forgetModules();
}

void AxesDock::endHold() {
    if (m_page != nullptr)
        m_page->endHold();
}

void AxesDock::setHoldInterval(int milliseconds) {
    m_holdInterval = milliseconds;
    if (m_page != nullptr)
        m_page->setHoldInterval(milliseconds);
}

}  // namespace nmc

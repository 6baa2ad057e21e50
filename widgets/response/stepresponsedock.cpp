// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepresponsedock.h"

#include <QScrollArea>
#include <utility>

#include "widgets/common/scrolled.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepResponseDock::StepResponseDock(QWidget* parent)
    : LazyDock(u"stepResponseDock"_s, StepResponsePage::tr("Step response"), Qt::Key_F9, parent) {}

StepResponsePage& StepResponseDock::page() {
    if (m_page == nullptr) {
        m_page = new StepResponsePage(this);
        connect(m_page, &StepResponsePage::asked, this, &StepResponseDock::asked);
        connect(m_page, &StepResponsePage::gainsWanted, this, &StepResponseDock::gainsWanted);
        connect(m_page, &StepResponsePage::suggestionWanted, this, &StepResponseDock::suggestionWanted);
        connect(m_page, &StepResponsePage::identifyWanted, this, &StepResponseDock::identifyWanted);
        connect(m_page, &StepResponsePage::saveRequested, this, &StepResponseDock::saveRequested);
        connect(m_page, &StepResponsePage::printRequested, this, &StepResponseDock::printRequested);
        connect(m_page, &StepResponsePage::runsChanged, this, &StepResponseDock::runsChanged);
        setWidget(scrolled(m_page));
        if (!m_waiting.empty())
            m_page->showKept(std::exchange(m_waiting, {}));
    }
    return *m_page;
}

void StepResponseDock::showModule(const PanelView& view) {
    if (inUse())
        page().showModule(view);
}

void StepResponseDock::showKept(std::vector<KeptRun> runs) {
    if (m_page != nullptr)
        m_page->showKept(std::move(runs));
    else
        m_waiting = std::move(runs);
}

void StepResponseDock::clearRuns() {
    m_waiting.clear();
    if (m_page != nullptr)
        m_page->clearRuns();
}

void StepResponseDock::forgetModules() {
    if (m_page != nullptr)
        m_page->forgetModules();
}

void StepResponseDock::takeFormBack() {
    if (m_page != nullptr)
        m_page->takeFormBack();
}

void StepResponseDock::showNothing() {
    if (inUse())
        page().showNothing();
}

}  // namespace nmc

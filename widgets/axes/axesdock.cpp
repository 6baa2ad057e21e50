// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/axes/axesdock.h"

namespace nmc {

using namespace Qt::StringLiterals;

AxesDock::AxesDock(Requests& requests, QWidget* parent)
    : PageDock(u"axesDock"_s, AxesPage::tr("All axes"), Qt::Key_F4, requests, parent) {}

void AxesDock::showSoFar() {
    m_page->showSequence(m_sequenceRuns);
}

void AxesDock::showModules(const std::vector<PanelView>& views, const Machine& machine) {
    if (seen())
        page().showModules(views, machine);
}

void AxesDock::showSequence(bool running) {
    m_sequenceRuns = running;
    if (m_page != nullptr)
        m_page->showSequence(running);
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequences/sequencesdock.h"

#include "widgets/common/sequencetexts.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

SequencesDock::SequencesDock(Requests& requests, QWidget* parent)
    : PageDock(u"sequencesDock"_s, Common::tr("Points and sequences"), Qt::Key_F3, requests, parent) {}

void SequencesDock::showSoFar() {
    if (m_run)
        m_page->showRun(*m_run);
}

void SequencesDock::showSession(const LinkState& link, const Machine& machine) {
    if (seen())
        page().showSession(link, machine);
}

void SequencesDock::showRun(const SequenceReport& report) {
    const bool news = m_run != report;
    m_run = report;
    if (m_page != nullptr)
        m_page->showRun(report);
    if (news && texts::sequenceOver(report))
        emit ended();
}

}  // namespace nmc

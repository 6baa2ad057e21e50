// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/paths/pathsdock.h"

namespace nmc {

using namespace Qt::StringLiterals;

PathsDock::PathsDock(Requests& requests, QWidget* parent)
    : PageDock(u"pathsDock"_s, PathsPage::tr("Paths"), Qt::SHIFT | Qt::Key_F3, requests, parent) {}

void PathsDock::showSession(const LinkState& link, const Machine& machine,
                            const Session::Procedures& procedures) {
    if (seen())
        page().showSession(link, machine, procedures);
}

void PathsDock::showSequence(bool running) {
    m_sequenceRuns = running;
    if (m_page != nullptr)
        m_page->showSequence(running);
}

}  // namespace nmc

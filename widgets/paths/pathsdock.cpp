// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/paths/pathsdock.h"

#include <QScrollArea>

#include "widgets/common/scrolled.h"

namespace nmc {

using namespace Qt::StringLiterals;

PathsDock::PathsDock(Requests& requests, QWidget* parent)
    : LazyDock(u"pathsDock"_s, PathsPage::tr("Paths"), Qt::SHIFT | Qt::Key_F3, parent),
      m_requests(requests) {}

PathsPage& PathsDock::page() {
    if (m_page == nullptr) {
        m_page = new PathsPage(m_requests, this);
        m_page->showSequence(m_sequenceRuns);
        setWidget(scrolled(m_page));
    }
    return *m_page;
}

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

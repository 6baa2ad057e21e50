// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsedock.h"

#include <utility>

#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ResponseDock::ResponseDock(Requests& requests, QWidget* parent)
    : PageDock(u"responseDock"_s, Common::tr("Step response"), Qt::Key_F9, requests, parent) {}

void ResponseDock::showSoFar() {
    if (!m_waiting.empty())
        m_page->showKept(std::exchange(m_waiting, {}));
}

void ResponseDock::showModule(const PanelView& view) {
    if (inUse())
        page().showModule(view);
}

void ResponseDock::showKept(std::vector<KeptResponse> runs) {
    if (m_page != nullptr)
        m_page->showKept(std::move(runs));
    else
        m_waiting = std::move(runs);
}

void ResponseDock::clearRuns() {
    m_waiting.clear();
    if (m_page != nullptr)
        m_page->clearRuns();
}

void ResponseDock::showNothing() {
    if (inUse())
        page().showNothing();
}

}  // namespace nmc

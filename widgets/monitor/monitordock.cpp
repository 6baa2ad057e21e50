// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/monitordock.h"

#include <utility>

#include "widgets/monitor/packetsaving.h"

namespace nmc {

using namespace Qt::StringLiterals;

MonitorDock::MonitorDock(Requests& requests, QWidget* parent)
    : PageDock(u"monitorDock"_s, PacketMonitor::tr("Packet monitor"), {}, requests, parent) {
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        if (m_page != nullptr)
            m_page->setSeen(seen);
    });
}

void MonitorDock::showSoFar() {
    connect(m_page, &PacketMonitor::recordingChanged, this, &MonitorDock::recordingChanged);
    m_page->begin(m_session);
    m_page->offerModules(m_modules);
    m_page->showFigures(m_figures);
}

QString MonitorDock::lastPackets(int most) const {
    if (m_page == nullptr)
        return {};
    return QString::fromStdString(nmc::lastPackets(m_page->log(), static_cast<std::uint64_t>(most)));
}

void MonitorDock::begin(const PacketSession& session) {
    m_session = session;
    m_figures = {};
    if (m_page != nullptr)
        m_page->begin(session);
}

void MonitorDock::showPackets(std::vector<bus::ExchangeRecord> records) {
    if (m_page != nullptr)
        m_page->showPackets(std::move(records));
}

void MonitorDock::showLink(const LinkState& link) {
    m_modules = qMax(m_modules, static_cast<int>(link.modules.size()));
    if (m_page != nullptr)
        m_page->offerModules(m_modules);
}

void MonitorDock::showFigures(const LinkFigures& figures) {
    m_figures = figures;
    if (m_page != nullptr)
        m_page->showFigures(figures);
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bus/exchangerecord.h"
#include "model/module/linkstate.h"
#include "model/packets/packetlog.h"
#include "widgets/common/lazydock.h"
#include "widgets/monitor/packetmonitor.h"

namespace nmc {

/// The dock of the packet monitor. Its content starts with the present state of the connection.
class MonitorDock : public PageDock<PacketMonitor> {
    Q_OBJECT

public:
    explicit MonitorDock(Requests& requests, QWidget* parent = nullptr);

    // These are passed on to the PacketMonitor, if it exists.
    void begin(const PacketSession& session);
    void showPackets(std::vector<bus::ExchangeRecord> records);
    void showLink(const LinkState& link);
    void showFigures(const LinkFigures& figures);
    [[nodiscard]] const LinkFigures& figures() const { return m_figures; }
    /// The last packets, at most `most`, as text; empty: none were recorded.
    [[nodiscard]] QString lastPackets(int most) const;

signals:
    /// From now on, every exchange is needed, or none.
    void recordingChanged(bool recording);

private:
    void showSoFar() override;

    PacketSession m_session;
    LinkFigures m_figures;
    int m_modules = 0;  ///< the largest number in a chain so far
};

}  // namespace nmc

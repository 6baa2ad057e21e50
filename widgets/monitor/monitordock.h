// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <vector>

#include "bus/exchangerecord.h"
#include "model/module/linkstate.h"
#include "model/packets/packetlog.h"
#include "widgets/common/filedialog.h"

namespace nmc {

class PacketMonitor;

/// The place of the packet monitor, which is closed at first and often stays so: its content is built when it
/// is seen for the first time, and finds the connection then as it has become.
class MonitorDock : public QDockWidget {
    Q_OBJECT

public:
    explicit MonitorDock(QWidget* parent = nullptr);

    // As in PacketMonitor.
    void begin(const PacketSession& session);
    void showPackets(std::vector<bus::ExchangeRecord> records);
    void showLink(const LinkState& link);
    void showFigures(const LinkFigures& figures);
    [[nodiscard]] bool recording() const;
    [[nodiscard]] const LinkFigures& figures() const { return m_figures; }
    /// At most so many, as text; empty: none were recorded.
    [[nodiscard]] QString lastPackets(int most) const;

    /// The content; built if need be.
    PacketMonitor& page();

signals:
    void recordingChanged(bool recording);
    void saveRequested(const QString& path, const nmc::FileContent& content);

private:
    PacketMonitor* m_page = nullptr;
    PacketSession m_session;
    LinkFigures m_figures;
    int m_modules = 0;  ///< most in a chain so far
};

}  // namespace nmc

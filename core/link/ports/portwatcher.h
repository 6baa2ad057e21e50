// SPDX-License-Identifier: MIT
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <functional>

#include "link/ports/linktypes.h"

namespace nmc {

/// Detects that serial ports appear and disappear. Qt has no signal for this, and a query takes 3 ms, so it
/// queries only 300 ms after a change among the device files. GUI thread.
class PortWatcher : public QObject {
    Q_OBJECT

public:
    using List = std::function<QList<PortEntry>()>;
    static constexpr int kSettleMs = 300;  ///< udev needs a moment for names and permissions

    PortWatcher(List list, const QString& folder, QObject* parent = nullptr);

    /// Queries the ports; emits no signal, but a change that it finds is still announced.
    [[nodiscard]] QList<PortEntry> ports();

signals:
    void portsChanged(const QList<nmc::PortEntry>& ports);

private:
    void look();

    List m_list;
    QList<PortEntry> m_ports;
    bool m_changed = false;  ///< since the last signal
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
};

}  // namespace nmc

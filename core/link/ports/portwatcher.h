// SPDX-License-Identifier: MIT
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <functional>

#include "link/ports/linktypes.h"

namespace nmc {

/// Notices that serial ports come and go. Qt has no signal for it, and asking takes 3 ms, so it asks only
/// 300 ms after something has changed among the device files. GUI thread.
class PortWatcher : public QObject {
    Q_OBJECT

public:
    using List = std::function<QList<PortEntry>()>;
    static constexpr int kSettleMs = 300;  ///< udev needs a moment for names and permissions

    PortWatcher(List list, const QString& folder, QObject* parent = nullptr);

    /// Asked anew; tells of no change.
    [[nodiscard]] QList<PortEntry> ports();

signals:
    void portsChanged(const QList<nmc::PortEntry>& ports);

private:
    void look();

    List m_list;
    QList<PortEntry> m_ports;
    QFileSystemWatcher m_watcher;
    QTimer m_settle;
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "link/ports/portwatcher.h"

#include <utility>

namespace nmc {

PortWatcher::PortWatcher(List list, const QString& folder, QObject* parent)
    : QObject(parent), m_list(std::move(list)) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &PortWatcher::look);
    m_watcher.addPath(folder);
    // The timer is not restarted by further changes: a folder that is never quiet must not postpone the check
    // forever.
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] {
        if (!m_settle.isActive())
            m_settle.start();
    });
}

QList<PortEntry> PortWatcher::ports() {
    QList<PortEntry> now = m_list();
    m_changed = m_changed || now != m_ports;
    m_ports = std::move(now);
    return m_ports;
}

void PortWatcher::look() {
    const QList<PortEntry> now = ports();
    if (std::exchange(m_changed, false))
        emit portsChanged(now);
}

}  // namespace nmc

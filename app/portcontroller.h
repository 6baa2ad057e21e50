// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "base/time.h"
#include "link/ports/adaptermemory.h"
#include "link/ports/latencytimer.h"
#include "link/ports/portlist.h"
#include "link/ports/portwatcher.h"
#include "widgets/common/texts.h"

namespace nmc {

/// A connection as requested by the user, and as used for reconnecting.
struct ConnectTarget {
    QString port;
    quint32 baud = 0;
    bool readOnly = false;
};

/// Everything about ports except the connection itself: their list, the adapter that was lost and the one
/// that is back, and the speed of an adapter. It makes offers, but never connects. GUI thread.
class PortController : public QObject {
    Q_OBJECT

public:
    /// Where ports are found; tests use their own.
    struct Places {
        PortWatcher::List list = serialPorts;
        QString devices = QStringLiteral("/dev");
        QString sysfs = QStringLiteral("/sys");
    };

    explicit PortController(Places places);

    [[nodiscard]] QList<PortEntry> ports() { return m_watcher.ports(); }
    /// Returns false if another adapter is present than before; the user is asked first.
    [[nodiscard]] bool mayConnect(const ConnectTarget& target);
    /// The target of Reconnect.
    [[nodiscard]] const std::optional<ConnectTarget>& offered() const { return m_offer; }
    /// The port at which the adapter was lost that is back at this one. Empty if this is any other adapter.
    [[nodiscard]] std::optional<QString> lostBefore(const QString& port) const {
        return m_adapters.isBackAt(port) ? std::optional(m_open.port) : std::nullopt;
    }

    void opening(const ConnectTarget& target);
    /// For every end of a connection, with what ended it.
    void closed(const std::optional<PortError>& error);

    /// The adapter latency to allow for in timeouts (link.md 2.1).
    [[nodiscard]] Duration adapterLatency(const QString& port) const;
    [[nodiscard]] QString latencyFile() const { return latencyTimerFile(m_open.port, m_places.sysfs); }
    /// Call once a second while connected; reports once that the adapter makes the link slow.
    void noteRate(double exchangesPerSecond);

signals:
    void portsChanged(const QList<nmc::PortEntry>& ports);
    void reported(const nmc::Message& message);
    void ended(const QString& key);

private:
    void look(const QList<PortEntry>& ports);
    void offer(const ConnectTarget& target, const Message& message);

    Places m_places;
    PortWatcher m_watcher;
    AdapterMemory m_adapters;
    ConnectTarget m_open;  ///< the present connection, or the last one
    std::optional<ConnectTarget> m_offer;
    std::optional<Duration> m_slow;  ///< not yet reported
    bool m_lost = false;
};

}  // namespace nmc

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

/// A connection as the user asked for it, and as it is made again.
struct ConnectTarget {
    QString port;
    quint32 baud = 0;
    bool readOnly = false;
};

/// Everything about ports but the connection itself: the list of them, the adapter that is lost and the one
/// that is back, and how slow an adapter is. It offers, and never connects. GUI thread.
class PortController : public QObject {
    Q_OBJECT

public:
    /// Where ports are found; tests bring their own.
    struct Places {
        PortWatcher::List list = serialPorts;
        QString devices = QStringLiteral("/dev");
        QString sysfs = QStringLiteral("/sys");
    };

    explicit PortController(Places places, QObject* parent = nullptr);

    [[nodiscard]] QList<PortEntry> ports() { return m_watcher.ports(); }
    /// False when another adapter is there than before: the user is asked first.
    [[nodiscard]] bool mayConnect(const ConnectTarget& target);
    /// What Reconnect would connect to.
    [[nodiscard]] const std::optional<ConnectTarget>& offered() const { return m_offer; }

    void opening(const ConnectTarget& target);
    void closed(const PortError& error);

    /// What to reckon with in time-outs (link.md 2.1).
    [[nodiscard]] Duration adapterLatency(const QString& port) const;
    [[nodiscard]] QString latencyFile() const { return latencyTimerFile(m_open.port, m_places.sysfs); }
    /// Once a second while connected; says once that the adapter is why it is slow.
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
    ConnectTarget m_open;  ///< or was last
    std::optional<ConnectTarget> m_offer;
    std::optional<Duration> m_slow;  ///< not yet told
    bool m_lost = false;
};

}  // namespace nmc

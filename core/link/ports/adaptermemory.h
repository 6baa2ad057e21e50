// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QList>
#include <optional>

#include "link/ports/linktypes.h"

namespace nmc {

/// Distinguishes the adapters of this session regardless of their names: /dev/ttyUSB0 is whichever was
/// plugged in first. The criteria are vendor, product and serial number; ports that have none are not
/// distinguished. Of several that are alike, one that was there together with the lost one is another. Pure.
class AdapterMemory {
public:
    /// The adapter that was lost has returned.
    struct Back {
        QString port;
        bool sameSerial = false;  ///< the same adapter; otherwise one of the same kind, without a serial
                                  ///< number
        bool operator==(const Back&) const = default;
    };

    /// A connection to this port has been opened.
    void opened(const QString& port, const QList<PortEntry>& ports);
    /// The adapter at this port was unplugged.
    void lost(const QString& port);
    /// True if the adapter was unplugged from this port, which has none now.
    [[nodiscard]] bool isLostAt(const QString& port, const QList<PortEntry>& ports) const;
    /// Called whenever ports have appeared or disappeared; returns each return once.
    [[nodiscard]] std::optional<Back> back(const QList<PortEntry>& ports);
    /// True if that was the port, and the adapter has not disappeared since.
    [[nodiscard]] bool isBackAt(const QString& port) const { return m_back && m_back->name == port; }
    /// True when this is not the adapter that was connected under this name in this session.
    [[nodiscard]] bool differs(const QString& port, const QList<PortEntry>& ports) const;

private:
    QHash<QString, PortEntry> m_known;
    QString m_opened;           ///< the port opened last
    QList<PortEntry> m_others;  ///< there ever since they were listed together with its adapter
    std::optional<PortEntry> m_lost;
    std::optional<PortEntry> m_back;
};

}  // namespace nmc

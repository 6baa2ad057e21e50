// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QList>
#include <optional>

#include "link/ports/linktypes.h"

namespace nmc {

/// Knows the adapters of this session apart, whatever names the system gives them: /dev/ttyUSB0 is whichever
/// was plugged in first. By vendor, product and serial number; ports that have none are not told apart. Pure.
class AdapterMemory {
public:
    /// The adapter that was lost is there again.
    struct Back {
        QString port;
        bool sameSerial = false;  ///< the very one; otherwise one of the same kind, which have no number
        bool operator==(const Back&) const = default;
    };

    /// A connection to this port has been opened.
    void opened(const QString& port, const QList<PortEntry>& ports);
    /// The adapter at this port was unplugged.
    void lost(const QString& port);
    /// Asked whenever ports have come or gone; tells once.
    [[nodiscard]] std::optional<Back> back(const QList<PortEntry>& ports);
    /// Another adapter than the one that was connected under this name in this session.
    [[nodiscard]] bool differs(const QString& port, const QList<PortEntry>& ports) const;

private:
    QHash<QString, PortEntry> m_known;
    std::optional<PortEntry> m_lost;
};

}  // namespace nmc

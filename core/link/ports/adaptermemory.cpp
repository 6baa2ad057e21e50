// SPDX-License-Identifier: MIT
#include "link/ports/adaptermemory.h"

#include <algorithm>

namespace nmc {

namespace {

bool sameAdapter(const PortEntry& a, const PortEntry& b) {
    return a.vendor == b.vendor && a.product == b.product && a.serialNumber == b.serialNumber;
}

const PortEntry* find(const QString& port, const QList<PortEntry>& ports) {
    const auto found = std::ranges::find(ports, port, &PortEntry::name);
    return found != ports.end() && found->vendor != 0 ? &*found : nullptr;
}

QList<PortEntry> allBut(const QString& port, QList<PortEntry> ports) {
    ports.removeIf([&](const PortEntry& entry) { return entry.name == port; });
    return ports;
}

}  // namespace

void AdapterMemory::opened(const QString& port, const QList<PortEntry>& ports) {
    m_lost.reset();
    m_back.reset();
    m_opened = port;
    m_others = allBut(port, ports);
    if (const PortEntry* entry = find(port, ports))
        m_known[port] = *entry;
    else
        m_known.remove(port);
}

void AdapterMemory::lost(const QString& port) {
    m_lost.reset();
    m_back.reset();
    if (const auto known = m_known.constFind(port); known != m_known.constEnd())
        m_lost = *known;
}

bool AdapterMemory::isLostAt(const QString& port, const QList<PortEntry>& ports) const {
    return m_lost && port == m_opened && find(port, ports) == nullptr;
}

std::optional<AdapterMemory::Back> AdapterMemory::back(const QList<PortEntry>& ports) {
    if (!m_lost && find(m_opened, ports) != nullptr)
        m_others = allBut(m_opened, ports);
    else
        m_others.removeIf([&](const PortEntry& other) { return !ports.contains(other); });
    if (m_back && !ports.contains(*m_back))
        m_back.reset();
    if (!m_lost || m_back)
        return std::nullopt;
    for (const PortEntry& entry : ports)
        if (sameAdapter(entry, *m_lost) && !m_others.contains(entry)) {
            m_back = entry;
            return Back{entry.name, !entry.serialNumber.isEmpty()};
        }
    return std::nullopt;
}

bool AdapterMemory::differs(const QString& port, const QList<PortEntry>& ports) const {
    const PortEntry* now = find(port, ports);
    const auto known = m_known.constFind(port);
    return now != nullptr && known != m_known.constEnd() && !sameAdapter(*now, *known);
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/portcontroller.h"

#include <algorithm>
#include <cmath>

#include "bus/engine.h"

namespace nmc {

namespace {

/// From this latency on, the adapter rather than the line limits how often a module is polled.
constexpr Duration kSlow = std::chrono::milliseconds(8);

}  // namespace

PortController::PortController(Places places)
    : m_places(std::move(places)), m_watcher(m_places.list, m_places.devices) {
    connect(&m_watcher, &PortWatcher::portsChanged, this, &PortController::look);
}

bool PortController::mayConnect(const ConnectTarget& target) {
    if (!m_adapters.differs(target.port, ports()))
        return true;
    offer(target, texts::differentAdapter(target.port));
    return false;
}

void PortController::opening(const ConnectTarget& target) {
    m_open = target;
    m_offer.reset();
    // A port without its adapter cannot be opened, so the adapter remains lost.
    if (!m_adapters.isLostAt(target.port, ports())) {
        m_lost = false;
        m_adapters.opened(target.port, ports());
    }
    const auto latency = latencyTimerOf(target.port, m_places.sysfs);
    m_slow = latency && *latency >= kSlow ? latency : std::nullopt;
    emit ended(texts::key::kSlowAdapter);  // its remedy applies to the port that is open
}

void PortController::closed(const std::optional<PortError>& error) {
    m_slow.reset();
    if (!error || error->problem != PortProblem::Gone)
        return;
    m_lost = true;
    m_adapters.lost(m_open.port);
}

Duration PortController::adapterLatency(const QString& port) const {
    const Duration least = bus::EngineConfig{}.adapterLatency;
    return std::max(least, latencyTimerOf(port, m_places.sysfs).value_or(least));
}

void PortController::noteRate(double exchangesPerSecond) {
    if (!m_slow || exchangesPerSecond < 1.0)
        return;
    const auto ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(*std::exchange(m_slow, std::nullopt));
    emit reported(
        texts::slowAdapter(static_cast<int>(std::lround(exchangesPerSecond)), static_cast<int>(ms.count())));
}

void PortController::look(const QList<PortEntry>& ports) {
    emit portsChanged(ports);
    const bool offersReturn = m_offer && m_adapters.isBackAt(m_offer->port);
    const auto back = m_adapters.back(ports);
    if (offersReturn && !m_adapters.isBackAt(m_offer->port)) {
        m_offer.reset();
        emit ended(texts::key::kPort);
    }
    if (back) {
        m_lost = false;
        offer({back->port, m_open.baud, m_open.readOnly}, texts::adapterBack(back->port, back->sameSerial));
    } else if (m_lost && m_adapters.differs(m_open.port, ports)) {
        m_lost = false;  // reported once; the lost adapter may still come back
        offer(m_open, texts::differentAdapter(m_open.port));
    }
}

void PortController::offer(const ConnectTarget& target, const Message& message) {
    m_offer = target;
    // Replaces the previous message about the port instead of counting as its repetition.
    emit ended(message.key);
    emit reported(message);
}

}  // namespace nmc

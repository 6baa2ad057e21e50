// SPDX-License-Identifier: MIT
#include "link/connection/simulatortransport.h"

#include <array>

#include "link/clock.h"
#include "sim/control.h"

namespace nmc {

SimulatorTransport::SimulatorTransport(std::vector<ModuleIdentity> modules, sim::ChainOptions options)
    : m_chain(modules, options) {}

tl::expected<void, PortError> SimulatorTransport::open() {
    m_powerUp = monotonicNow();
    return {};
}

tl::expected<void, PortError> SimulatorTransport::setBaud(std::uint32_t baud) {
    m_chain.advanceTo(chainTime(monotonicNow()));
    m_chain.setHostBaud(baud);
    return {};
}

tl::expected<void, PortError> SimulatorTransport::send(ByteSpan bytes) {
    m_chain.hostSends(bytes, chainTime(monotonicNow()));
    return {};
}

void SimulatorTransport::discardInput() {
    (void)arrived();
}

Transport::Received SimulatorTransport::receive(std::optional<TimePoint> until, int wakeFd) {
    std::array<pollfd, 1> fds{{{wakeFd, POLLIN, 0}}};
    while (true) {
        std::optional<TimePoint> next = until;
        if (const auto event = m_chain.nextEvent())
            next = earliest({until, m_powerUp + event->time_since_epoch()});
        const bool woken = pollUntil(fds, next) != 0;
        std::vector<std::uint8_t> bytes = arrived();
        if (woken || !bytes.empty() || (until && monotonicNow() >= *until))
            return bytes;
    }
}

std::optional<std::string> SimulatorTransport::control(std::string_view line) {
    return sim::handleControlLine(m_chain, line, chainTime(monotonicNow()));
}

std::vector<std::uint8_t> SimulatorTransport::arrived() {
    m_chain.advanceTo(chainTime(monotonicNow()));
    std::vector<std::uint8_t> bytes;
    for (const sim::HostByte& byte : m_chain.takeHostBytes())
        bytes.push_back(byte.value);
    return bytes;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "link/simserver.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "link/clock.h"
#include "protocol/baud.h"
#include "sim/control.h"

namespace nmc {

namespace {

/// A line that never ends must not fill the memory.
constexpr std::size_t kMaxLine = 4'096;

}  // namespace

SimServer::SimServer(sim::Chain chain, PtyServer terminal, double speed, int controlIn, int controlOut)
    : m_chain(std::move(chain)),
      m_terminal(std::move(terminal)),
      m_speed(speed),
      m_controlIn(controlIn),
      m_controlOut(controlOut),
      m_hostBaud(kPowerUpBaud),
      m_started(monotonicNow()) {}

void SimServer::run(int stopFd) {
    while (true) {
        std::optional<TimePoint> next;
        if (const auto event = m_chain.nextEvent())
            next = realTimeOf(*event);
        std::array<pollfd, 3> fds{{{stopFd, POLLIN, 0},
                                   {m_terminal.fd(), POLLIN, 0},
                                   {m_controlOpen ? m_controlIn : -1, POLLIN, 0}}};
        pollUntil(fds, next);
        if (fds[0].revents != 0)
            return;
        if (fds[1].revents != 0)
            serveHost();
        deliver();
        if (fds[2].revents != 0 && !serveControl())
            return;
    }
}

TimePoint SimServer::simulatedNow() const {
    return TimePoint(fromSeconds(toSeconds(monotonicNow() - m_started) * m_speed));
}

TimePoint SimServer::realTimeOf(TimePoint simulated) const {
    return m_started + fromSeconds(toSeconds(simulated.time_since_epoch()) / m_speed);
}

void SimServer::serveHost() {
    const std::vector<std::uint8_t> bytes = m_terminal.read();
    const TimePoint now = simulatedNow();
    m_chain.advanceTo(now);
    const std::uint32_t baud = m_terminal.hostBaud().value_or(kPowerUpBaud);
    if (baud != m_hostBaud) {
        m_hostBaud = baud;
        m_chain.setHostBaud(baud);
    }
    if (!bytes.empty())
        m_chain.hostSends(bytes, now);
}

void SimServer::deliver() {
    const TimePoint now = simulatedNow();
    m_chain.advanceTo(now);
    std::vector<std::uint8_t> bytes;
    for (const sim::HostByte& byte : m_chain.takeHostBytes()) {
        bytes.push_back(byte.value);
        m_lag = std::max(m_lag, toSeconds(now - byte.due) / m_speed);
    }
    if (!bytes.empty())
        m_terminal.write(bytes);
}

bool SimServer::serveControl() {
    std::array<char, 1024> buffer{};
    const auto got = ::read(m_controlIn, buffer.data(), buffer.size());
    if (got <= 0) {
        m_controlOpen = false;  // the end of standard input does not end the simulator
        return true;
    }
    m_pendingLine.append(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = m_pendingLine.find('\n')) != std::string::npos;) {
        const std::string line = m_pendingLine.substr(0, end);
        m_pendingLine.erase(0, end + 1);
        if (!answer(line))
            return false;
    }
    if (m_pendingLine.size() > kMaxLine)
        m_pendingLine.clear();
    return true;
}

bool SimServer::answer(const std::string& line) {
    const bool last = line == "quit" || line == "quit\r";
    std::string reply =
        last ? R"({"quit":true})"
             : sim::handleControlLine(m_chain, line, simulatedNow(), std::exchange(m_lag, 0.0));
    reply += '\n';
    [[maybe_unused]] const auto written = ::write(m_controlOut, reply.data(), reply.size());
    return !last;
}

}  // namespace nmc

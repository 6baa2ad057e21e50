// SPDX-License-Identifier: MIT
#include "link/simserver.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "link/clock.h"
#include "protocol/baud.h"
#include "sim/control.h"

namespace nmc {

namespace {

/// A line that never ends must not fill the memory.
constexpr std::size_t kMaxLine = 4'096;

}  // namespace

SimServer::SimServer(sim::Chain chain, PtyServer terminal, const Pacing& pacing, int controlIn,
                     int controlOut)
    : m_chain(std::move(chain)),
      m_terminal(std::move(terminal)),
      m_pacing(pacing),
      m_controlIn(controlIn),
      m_controlOut(controlOut),
      m_hostBaud(kPowerUpBaud),
      m_started(monotonicNow()) {}

void SimServer::run(int stopFd) {
    while (true) {
        std::optional<TimePoint> next;
        if (const auto event = m_chain.nextEvent(); event && !m_pacing.stepped)
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
    if (m_pacing.stepped)
        return m_stepped;
    return TimePoint(fromSeconds(toSeconds(monotonicNow() - m_started) * m_pacing.speed));
}

TimePoint SimServer::realTimeOf(TimePoint simulated) const {
    return m_started + fromSeconds(toSeconds(simulated.time_since_epoch()) / m_pacing.speed);
}

void SimServer::serveHost() {
    const std::vector<std::uint8_t> bytes = m_terminal.read();
    m_pace.received += bytes.size();
    const TimePoint now = simulatedNow();
    m_chain.advanceTo(now);
    const std::size_t before = endOfLastSetBaud(bytes);
    const std::uint32_t baud = m_terminal.hostBaud().value_or(m_hostBaud);
    if (baud == m_hostBaud) {
        m_chain.hostSends(bytes, now);
        return;
    }
    // A pseudo-terminal does not tell what was written before tcsetattr(3) and what behind it, and takes
    // bytes long before a UART would have sent them. Set Baud and then the new rate is how a rate is changed.
    m_chain.hostSends(ByteSpan(bytes).first(before), now);
    m_hostBaud = baud;
    m_chain.setHostBaud(baud);
    m_chain.hostSends(ByteSpan(bytes).subspan(before), now);
}

std::size_t SimServer::endOfLastSetBaud(ByteSpan bytes) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (!m_monitor.hears(bytes[i], false))
            continue;
        const sim::Packet& packet = m_monitor.packet();
        if (packet.code() == CommandCode::SetBaud && packet.sumIsRight())
            end = i + 1;
    }
    return end;
}

void SimServer::deliver() {
    const TimePoint now = simulatedNow();
    m_chain.advanceTo(now);
    std::vector<std::uint8_t> bytes;
    for (const sim::HostByte& byte : m_chain.takeHostBytes()) {
        bytes.push_back(byte.value);
        m_pace.lagSeconds = std::max(m_pace.lagSeconds, toSeconds(now - byte.due) / m_pacing.speed);
    }
    m_pace.sent += bytes.size();
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
    const std::string reply = (last ? R"({"quit":true})" : answerTo(line)) + '\n';
    [[maybe_unused]] const auto written = ::write(m_controlOut, reply.data(), reply.size());
    return !last;
}

std::string SimServer::answerTo(const std::string& line) {
    if (line.rfind("advance", 0) == 0)
        return advance(line);
    return sim::handleControlLine(m_chain, line, simulatedNow(), takePace());
}

std::string SimServer::advance(const std::string& line) {
    constexpr double kLongest = 100'000.0;
    if (!m_pacing.stepped)
        return R"({"error":"advance is for nmcsim --stepped; here time passes by itself"})";
    std::istringstream words(line);
    std::string verb;
    double seconds = 0.0;
    if (!(words >> verb >> seconds) || verb != "advance" || !(words >> std::ws).eof() ||
        !(seconds >= 0.0 && seconds <= kLongest))
        return R"({"error":"allowed is advance SECONDS, from 0 to 100000"})";
    m_stepped += fromSeconds(seconds);
    deliver();
    m_pace.lagSeconds = 0.0;  // nothing is late where nothing is paced
    return sim::handleControlLine(m_chain, "time", simulatedNow(), takePace());
}

sim::Pace SimServer::takePace() {
    const sim::Pace pace = m_pace;
    m_pace.lagSeconds = 0.0;
    return pace;
}

}  // namespace nmc

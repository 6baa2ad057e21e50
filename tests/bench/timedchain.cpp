// SPDX-License-Identifier: GPL-3.0-or-later
#include "timedchain.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <utility>

#include "link/clock.h"
#include "link/ports/linerate.h"
#include "protocol/baud.h"

namespace nmc::bench {

TimedChain::TimedChain(std::size_t modules)
    : m_terminal(PtyServer::create({}).value()),
      m_chain(std::vector<ModuleIdentity>(modules, {ModuleType::Servo, 4})),
      m_began(monotonicNow()),
      m_thread([this] { run(); }) {}

TimedChain::~TimedChain() {
    m_stop.wake();
    m_thread.join();
}

std::vector<WirePacket> TimedChain::takePackets() {
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_packets, {});
}

void TimedChain::run() {
    constexpr Duration kAtLeastEvery = std::chrono::milliseconds(50);
    wantFineTimers();
    // The measuring thread must not be late itself; where its priority is not permitted, the figures are a
    // little worse.
    const sched_param first{1};
    ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &first);
    while (true) {
        std::array<pollfd, 2> fds{{{m_stop.fd(), POLLIN, 0}, {m_terminal.fd(), POLLIN, 0}}};
        TimePoint until = monotonicNow() + kAtLeastEvery;
        if (const auto event = m_chain.nextEvent())
            until = std::min(until, m_began + event->time_since_epoch());
        pollUntil(fds, until);
        if (fds[0].revents != 0)
            return;
        m_chain.advanceTo(TimePoint(monotonicNow() - m_began));
        serve();
        std::vector<std::uint8_t> bytes;
        for (const sim::HostByte& byte : m_chain.takeHostBytes())
            bytes.push_back(byte.value);
        if (!bytes.empty())
            m_terminal.write(bytes);
    }
}

void TimedChain::serve() {
    const std::vector<std::uint8_t> bytes = m_terminal.read();
    const TimePoint now = monotonicNow();
    const TimePoint chainNow(now - m_began);
    // As in SimServer: a rate is changed by Set Baud, followed by the new rate.
    sim::Receiver monitor;
    std::size_t old = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        if (monitor.hears(bytes[i], false) && monitor.packet().code() == CommandCode::SetBaud)
            old = i + 1;
    const std::uint32_t baud = lineRate(m_terminal.fd()).value_or(m_baud);
    if (baud == m_baud)
        old = bytes.size();
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i == old)
            m_baud = baud;
        note(bytes[i], now);
    }
    m_chain.hostSends(ByteSpan(bytes).first(old), chainNow);
    m_baud = baud;
    m_chain.setHostBaud(baud);
    m_chain.hostSends(ByteSpan(bytes).subspan(old), chainNow);
}

void TimedChain::note(std::uint8_t byte, TimePoint now) {
    const TimePoint begins = std::max(now, m_busyUntil);
    m_busyUntil = begins + byteTimeAtBaud(m_baud);
    if (!m_receiver.inPacket()) {
        m_packetBegan = begins;
        m_packetBytes = 0;
    }
    ++m_packetBytes;
    if (m_receiver.hears(byte, false))
        m_packets.push_back({m_packetBegan, m_busyUntil, m_receiver.packet().code(),
                             m_receiver.packet().address, m_packetBytes});
}

}  // namespace nmc::bench

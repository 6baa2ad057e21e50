// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "link/connection/wakeup.h"
#include "link/terminal/ptyserver.h"
#include "sim/chain.h"
#include "sim/receiver.h"

namespace nmc::bench {

/// A command packet on the wire. A pseudo-terminal accepts bytes faster than a UART sends them, so the times
/// are those of a UART at the host's rate that starts when the bytes arrive.
struct WirePacket {
    TimePoint begins;
    TimePoint ends;
    CommandCode code = CommandCode::Nop;
    std::uint8_t address = 0;
    std::size_t bytes = 0;
};

/// A simulated chain behind a pseudo-terminal, in a thread of its own, that records when each packet is on
/// the wire.
class TimedChain {
public:
    explicit TimedChain(std::size_t modules);
    ~TimedChain();
    TimedChain(const TimedChain&) = delete;
    TimedChain& operator=(const TimedChain&) = delete;

    [[nodiscard]] const std::string& terminal() const { return m_terminal.path(); }
    /// All packets since the last call.
    [[nodiscard]] std::vector<WirePacket> takePackets();

private:
    void run();
    void serve();
    void note(std::uint8_t byte, TimePoint now);

    PtyServer m_terminal;
    sim::Chain m_chain;
    TimePoint m_began;
    std::uint32_t m_baud = 19'200;
    TimePoint m_busyUntil;
    TimePoint m_packetBegan;
    std::size_t m_packetBytes = 0;
    sim::Receiver m_receiver;
    Wakeup m_stop;
    std::mutex m_mutex;
    std::vector<WirePacket> m_packets;
    std::thread m_thread;
};

}  // namespace nmc::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "app/composition.h"
#include "protocol/commandcode.h"
#include "sim/chain.h"

namespace nmc::monkey {

/// What the program gave to its port.
struct Packet {
    TimePoint time;
    std::vector<std::uint8_t> bytes;

    [[nodiscard]] std::uint8_t address() const { return bytes[1]; }
    [[nodiscard]] CommandCode code() const { return static_cast<CommandCode>(bytes[2] & 0x0FU); }
    /// Sets a motor in motion, or may. From the data sheet (DS-V 5.2, DS-S 5.2), not by the encoder.
    [[nodiscard]] bool starts() const;
};

/// Motor modules on a table, and the port to them, in virtual time. They stay as they are while no port is
/// open. The program's bus thread runs only while the GUI thread waits in run(), so that a seed is the same
/// session each time. All public members belong to the GUI thread.
class Bench {
public:
    Bench(const std::vector<ModuleIdentity>& modules, std::uint64_t seed);

    [[nodiscard]] Composition::Transports transports();
    /// Lets time pass, on the bus and not in the window.
    void run(Duration time);
    /// A port is open, or about to be, or not yet closed.
    [[nodiscard]] bool open();

    /// A line of the simulator (simulator.md, Control).
    void tell(const std::string& line);
    /// The adapter is gone, and comes back.
    void unplug() { m_plugged = false; }
    void plugIn() { m_plugged = true; }
    [[nodiscard]] bool plugged() const { return m_plugged; }
    /// Something has gone wrong on it since it was set up.
    void disturb() { m_disturbed = true; }
    [[nodiscard]] bool disturbed() const { return m_disturbed; }

    [[nodiscard]] std::size_t size() const { return m_chain.moduleCount(); }
    [[nodiscard]] std::uint8_t address(std::size_t place) { return look(place).address; }
    [[nodiscard]] std::uint8_t group(std::size_t place) { return look(place).group; }
    /// Something turns the motor by command, whatever holds the shaft or turns it besides.
    [[nodiscard]] bool driven(std::size_t place);
    /// The motor has current.
    [[nodiscard]] bool isOn(std::size_t place);
    [[nodiscard]] std::uint64_t violations() const { return m_chain.violations().count(); }
    [[nodiscard]] std::string firstViolation() const;
    /// Those since the last call.
    [[nodiscard]] std::vector<Packet> takePackets() { return std::exchange(m_packets, {}); }

private:
    class Port;

    [[nodiscard]] TimePoint chainTime() const;
    [[nodiscard]] sim::ModuleSnapshot look(std::size_t place);
    // In the bus thread.
    void end();
    void waitForTurn(std::unique_lock<std::mutex>& lock);
    /// Until that has come, or the GUI has had its turn.
    void waitUntil(std::optional<TimePoint> time);

    sim::Chain m_chain;
    TimePoint m_powerUp;
    bool m_plugged = true;
    bool m_disturbed = false;
    std::vector<Packet> m_packets;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_open = false;  ///< there is a bus thread, or will be
    bool m_guisTurn = true;
    TimePoint m_until{};
};

}  // namespace nmc::monkey

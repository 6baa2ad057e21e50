// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "link/connection/busworker.h"
#include "protocol/commandcode.h"
#include "sim/chain.h"

namespace nmc::testing_support {

/// What the program gave to its port.
struct Packet {
    TimePoint time;
    std::vector<std::uint8_t> bytes;

    [[nodiscard]] std::uint8_t address() const { return bytes[1]; }
    [[nodiscard]] CommandCode code() const { return static_cast<CommandCode>(bytes[2] & 0x0FU); }
    /// Sets a motor in motion, or may. From the data sheet (DS-V 5.2, DS-S 5.2), not by the encoder.
    [[nodiscard]] bool starts() const;
};

/// Motor modules, and the port to them, in virtual time. They stay as they are while no port is open. The
/// program's bus thread runs only while the GUI thread waits in run(), so that a seed is the same
/// session each time. All public members belong to the GUI thread.
class VirtualChain {
public:
    /// `terminal`: where it is found; empty: at one of its own.
    explicit VirtualChain(const std::vector<ModuleIdentity>& modules, std::uint64_t seed = 1,
                          const QString& terminal = {});
    /// As nmcsim has it: "servo,servo,step".
    explicit VirtualChain(const QString& modules, const QString& terminal = {});
    ~VirtualChain();
    VirtualChain(const VirtualChain&) = delete;
    VirtualChain& operator=(const VirtualChain&) = delete;

    /// The chain at this port; null: there is none.
    [[nodiscard]] static VirtualChain* at(const QString& terminal);
    /// Lets time pass at all of them.
    static void runAll(Duration time);

    /// What opens the port to it.
    [[nodiscard]] BusWorker::TransportFactory transport();
    /// Lets time pass, on the bus and not in the window.
    void run(Duration time);
    /// A port is open, or about to be, or not yet closed.
    [[nodiscard]] bool open();

    /// A line of the simulator (simulator.md, Control).
    void tell(const std::string& line);
    // As NmcsimProcess has them.
    [[nodiscard]] const QString& terminal() const { return m_terminal; }
    QJsonObject control(const QString& line);
    [[nodiscard]] QJsonObject state(int module) { return control(QStringLiteral("state %1").arg(module)); }
    /// The first; empty: none.
    [[nodiscard]] std::string violations() const;
    /// The adapter is gone, and comes back.
    void unplug() { m_plugged = false; }
    void plugIn() { m_plugged = true; }
    [[nodiscard]] bool plugged() const { return m_plugged; }
    /// Another program has the port open, or has closed it.
    void setInUse(bool inUse) { m_inUse = inUse; }
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
    QString m_terminal;
    TimePoint m_powerUp;
    bool m_plugged = true;
    bool m_inUse = false;
    bool m_disturbed = false;
    std::vector<Packet> m_packets;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_open = false;  ///< there is a bus thread, or will be
    bool m_guisTurn = true;
    TimePoint m_until{};
};

inline void letPass(VirtualChain& chain, Duration time) {
    chain.run(time);
}

}  // namespace nmc::testing_support

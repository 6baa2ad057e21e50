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

/// A packet that the program wrote to its port.
struct Packet {
    TimePoint time;
    std::vector<std::uint8_t> bytes;

    [[nodiscard]] std::uint8_t address() const { return bytes[1]; }
    [[nodiscard]] CommandCode code() const { return static_cast<CommandCode>(bytes[2] & 0x0FU); }
    /// True if it sets a motor in motion, or may do so. Follows the data sheet (DS-V 5.2, DS-S 5.2), not the
    /// encoder.
    [[nodiscard]] bool starts() const;
};

/// Motor modules, and the port to them, in virtual time. They keep their state while no port is open. The
/// program's bus thread runs only while the GUI thread waits in run(), so that a seed always gives the same
/// session. All public members belong to the GUI thread.
class VirtualChain {
public:
    /// `terminal`: the port at which it is found; if empty, a new one.
    explicit VirtualChain(const std::vector<ModuleIdentity>& modules, std::uint64_t seed = 1,
                          const QString& terminal = {});
    /// `modules`: as for nmcsim, for example "servo,servo,step".
    explicit VirtualChain(const QString& modules, const QString& terminal = {});
    ~VirtualChain();
    VirtualChain(const VirtualChain&) = delete;
    VirtualChain& operator=(const VirtualChain&) = delete;

    /// The chain at this port; null if there is none.
    [[nodiscard]] static VirtualChain* at(const QString& terminal);
    /// Lets time pass on all chains.
    static void runAll(Duration time);

    /// Factory of the port to it.
    [[nodiscard]] BusWorker::TransportFactory transport();
    /// Lets time pass on the bus, but not in the window.
    void run(Duration time);
    /// True if a port is open, is about to be opened, or is not yet closed.
    [[nodiscard]] bool open();

    /// Carries out a control line of the simulator (simulator.md, Control), which must not fail.
    void tell(const std::string& line);
    // The same interface as that of NmcsimProcess.
    [[nodiscard]] const QString& terminal() const { return m_terminal; }
    QJsonObject control(const QString& line);
    [[nodiscard]] QJsonObject state(int module) { return control(QStringLiteral("state %1").arg(module)); }
    /// The first violation; empty if there is none.
    [[nodiscard]] std::string violations() const;
    /// The adapter is unplugged, and plugged in again.
    void unplug() { m_plugged = false; }
    void plugIn() { m_plugged = true; }
    [[nodiscard]] bool plugged() const { return m_plugged; }
    /// The adapter has another name from now on; no port may be open.
    void rename(const QString& terminal) { m_terminal = terminal; }
    /// Sets whether another program has the port open.
    void setInUse(bool inUse) { m_inUse = inUse; }
    /// Notes that something on it has gone wrong since it was set up.
    void disturb() { m_disturbed = true; }
    [[nodiscard]] bool disturbed() const { return m_disturbed; }

    [[nodiscard]] std::size_t size() const { return m_chain.moduleCount(); }
    [[nodiscard]] std::uint8_t address(std::size_t place) { return look(place).address; }
    [[nodiscard]] std::uint8_t group(std::size_t place) { return look(place).group; }
    /// True if a command drives the motor, or will when motor power returns, whatever holds the shaft or
    /// turns it besides.
    [[nodiscard]] bool driven(std::size_t place);
    /// True if the motor has current.
    [[nodiscard]] bool isOn(std::size_t place);
    /// Packets since the last call.
    [[nodiscard]] std::vector<Packet> takePackets() { return std::exchange(m_packets, {}); }

private:
    class Port;

    [[nodiscard]] static TimePoint beginning();
    [[nodiscard]] TimePoint chainTime() const;
    [[nodiscard]] sim::ModuleSnapshot look(std::size_t place);
    // Called in the bus thread.
    void end();
    void waitForTurn(std::unique_lock<std::mutex>& lock);
    /// Returns false when this time has come, and true after the GUI has had its turn.
    bool waitUntil(std::optional<TimePoint> time);

    sim::Chain m_chain;
    QString m_terminal;
    TimePoint m_powerUp;
    bool m_plugged = true;
    bool m_inUse = false;
    bool m_disturbed = false;
    std::vector<Packet> m_packets;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_open = false;  ///< there is a bus thread, or there will be one
    bool m_guisTurn = true;
    TimePoint m_until{};
};

inline void letPass(VirtualChain& chain, Duration time) {
    chain.run(time);
}

}  // namespace nmc::testing_support

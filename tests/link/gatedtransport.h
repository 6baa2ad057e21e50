// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "link/connection/simulatortransport.h"

namespace nmc::testing_support {

/// Keeps a bus thread where it is, as a port does that does not return: a gate that any thread shuts and
/// opens.
class Gate {
public:
    /// Returns when the bus thread stands before it.
    void shut() {
        std::unique_lock lock(m_mutex);
        m_shut = true;
        m_changed.wait(lock, [this] { return m_waits; });
    }
    void open() { set(m_shut, false); }
    /// From now on the port is gone.
    void breakPort() { set(m_broken, true); }

    /// Bus thread: false when the port is gone.
    bool pass() {
        std::unique_lock lock(m_mutex);
        m_waits = m_shut;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return !m_shut; });
        m_waits = false;
        return !m_broken;
    }

private:
    void set(bool& flag, bool value) {
        const std::scoped_lock lock(m_mutex);
        flag = value;
        m_changed.notify_all();
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_shut = false;
    bool m_waits = false;
    bool m_broken = false;
};

/// The built-in simulator behind a gate, which must outlive it.
class GatedTransport : public SimulatorTransport {
public:
    GatedTransport(Gate& gate, std::vector<ModuleIdentity> modules, sim::ChainOptions options = {})
        : SimulatorTransport(std::move(modules), options), m_gate(gate) {}

    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        if (!m_gate.pass())
            return tl::unexpected(PortError{PortProblem::Gone, {}, {}, {}, {}});
        return SimulatorTransport::receive(until, wakeFd);
    }

private:
    Gate& m_gate;
};

}  // namespace nmc::testing_support

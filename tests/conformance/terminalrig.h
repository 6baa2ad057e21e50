// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/rig.h"
#include "tests/support/simprocess.h"

namespace nmc::conformance {

/// nmcsim in a process of its own, with its time stepped, and this program as the host at its terminal:
/// nothing but POSIX between the scenario and the simulator.
class TerminalRig : public Rig {
public:
    TerminalRig(const std::string& chain, const std::vector<std::string>& options);
    ~TerminalRig() override;
    TerminalRig(const TerminalRig&) = delete;
    TerminalRig& operator=(const TerminalRig&) = delete;

    void send(const Bytes& bytes) override;
    Bytes wait(Duration time) override;
    void setBaud(unsigned baud) override;
    nlohmann::json control(const std::string& line) override { return m_simulator.control(line); }

private:
    void waitUntilHeard();

    testing_support::SimProcess m_simulator;
    int m_port = -1;
    std::uint64_t m_sent = 0;      ///< bytes to the simulator
    std::uint64_t m_received = 0;  ///< bytes from it
};

}  // namespace nmc::conformance

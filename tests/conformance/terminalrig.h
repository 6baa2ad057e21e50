// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdio>

#include "tests/conformance/rig.h"

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
    nlohmann::json control(const std::string& line) override;

private:
    std::string answer();
    void waitUntilHeard();

    pid_t m_process = -1;
    std::FILE* m_toSimulator = nullptr;
    std::FILE* m_fromSimulator = nullptr;
    int m_port = -1;
    std::uint64_t m_sent = 0;      ///< bytes to the simulator
    std::uint64_t m_received = 0;  ///< bytes from it
};

}  // namespace nmc::conformance

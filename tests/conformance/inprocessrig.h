// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/chain.h"
#include "tests/conformance/rig.h"

namespace nmc::conformance {

/// The simulator in this process, as it is built into the panel.
class InProcessRig : public Rig {
public:
    InProcessRig(const std::string& chain, const std::vector<std::string>& options);

    void send(const Bytes& bytes) override { m_chain.hostSends(bytes, m_now); }
    Bytes wait(Duration time) override;
    void setBaud(unsigned baud) override { m_chain.setHostBaud(baud); }
    nlohmann::json control(const std::string& line) override;

private:
    sim::Chain m_chain;
    TimePoint m_now;
};

}  // namespace nmc::conformance

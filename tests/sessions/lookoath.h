// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "bus/types.h"
#include "sim/statistics.h"
#include "tests/sessions/wire.h"

namespace nmc::test {

class Rig;

/// What must be true of a read-only connection (EngineConfig::readOnly), whatever happens to the chain and
/// whatever is requested of it.
///
///  wire     nothing is sent but No Operation, Read Status and nulls; Stop Motor if a stop was requested
///  truth    no module has carried out anything else, by the simulator's own count
///  motions  no motion is suspected; what moved continues to move unless it was stopped or lost its power
class LookOath {
public:
    explicit LookOath(Rig& rig) : m_rig(&rig) {}

    /// Another engine takes over.
    void begin();
    void stopAsked() { m_stopAsked = true; }
    void onPowerCycle(std::uint8_t place);
    void onSent(const WireItem& item);
    void onEvent(const bus::Event& event);
    /// Called at the end of a session.
    void check();

private:
    [[nodiscard]] bool permits(CommandCode code) const;

    Rig* m_rig;
    bool m_stopAsked = false;
    std::vector<bool> m_moving;  ///< by place
    sim::ChainStatistics m_before;
};

}  // namespace nmc::test

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <vector>

#include "base/time.h"
#include "bus/types.h"

namespace nmc::bus {

struct EngineConfig {
    /// Nominal rate to run at, that the chips can make (findBrd). Discovery always begins at 19 200.
    std::uint32_t baud = 19'200;
    /// What the adapter adds to every reply (link.md 2.1).
    Duration adapterLatency = std::chrono::milliseconds(4);
    /// Scheduling margin of this machine (link.md 2.1).
    Duration margin = std::chrono::milliseconds(10);
    /// Wait after a Hard Reset: longer than any module's dead time seen in the field (protocol.md 1).
    Duration resetWait = std::chrono::milliseconds(25);
    /// Held motion ends this long after the last hold().
    Duration holdTimeout = std::chrono::milliseconds(250);
    /// The chain that was known at this port last, so that its modules keep their places when one is missing
    /// (rejoin.h). Empty: nothing is known.
    std::vector<ModuleInfo> known{};
    /// The rate that chain was left at, where it is none of kBaudRows; 0: not known. It is looked for there,
    /// too, and at `baud`.
    std::uint32_t knownBaud = 0;
    /// Looks at a chain that has its addresses and changes nothing: No Operation and Read Status only, and a
    /// stop where somebody asks for one (faults.md H-02). Of such a stop everything holds that is true of
    /// any: what is not confirmed is owed, and repeated until it is. Line::Permit keeps it.
    bool readOnly = false;
};

}  // namespace nmc::bus

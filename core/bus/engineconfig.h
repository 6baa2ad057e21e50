// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <vector>

#include "base/time.h"
#include "bus/types.h"

namespace nmc::bus {

struct EngineConfig {
    /// Nominal rate to run at, one that the chips support (findBrd). Discovery always begins at 19 200.
    std::uint32_t baud = 19'200;
    /// Latency that the adapter adds to every reply (link.md 2.1).
    Duration adapterLatency = std::chrono::milliseconds(4);
    /// Scheduling margin of this computer (link.md 2.1).
    Duration margin = std::chrono::milliseconds(10);
    /// Wait after a Hard Reset: longer than any module's dead time seen in the field (protocol.md 1).
    Duration resetWait = std::chrono::milliseconds(25);
    /// Held motion ends this long after the last hold().
    Duration holdTimeout = std::chrono::milliseconds(250);
    /// The last known chain at this port, so that its modules keep their places when one is missing
    /// (rejoin.h). Empty: unknown.
    std::vector<ModuleInfo> known{};
    /// The rate at which that chain was left, if it is not in kBaudRows; 0: unknown. The chain is searched
    /// for there as well, and at `baud`.
    std::uint32_t knownBaud = 0;
    /// The line has one rate, 19 200 Bd, and the chain is searched for and reset at no other.
    bool fixedRate = false;
    /// Engine::unconfirmedStops() of the last connection to this port. A module that is found as it was is
    /// sent its stop again; ignored on a read-only connection.
    std::vector<UnconfirmedStop> unconfirmed{};
    /// Monitors a chain that has addresses without changing anything: No Operation and Read Status only, and
    /// a stop on request (faults.md H-02). Such a stop has all the properties of any other: if it is not
    /// confirmed, it is owed and repeated until it is. Enforced by Line::Permit.
    bool readOnly = false;
};

}  // namespace nmc::bus

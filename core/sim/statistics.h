// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/time.h"
#include "protocol/commandcode.h"
#include "protocol/moduletype.h"

namespace nmc::sim {

/// What one module has done since the chain was constructed or the statistics were cleared; a reset does not
/// clear them.
struct ModuleStatistics {
    ModuleIdentity identity;
    std::array<std::uint64_t, 16> executed{};  ///< by command code
    std::uint64_t checksumErrors = 0;          ///< packets to it with a wrong sum or a framing error
    std::uint64_t replies = 0;                 ///< replies sent to the last byte
    std::uint64_t repliesDropped = 0;          ///< replies cut short by a byte of the host
    std::uint64_t bytesGarbled = 0;  ///< bytes garbled by different rates, received by the module or sent to
                                     ///< the host

    [[nodiscard]] std::uint64_t executions(CommandCode code) const {
        return executed[static_cast<std::size_t>(code)];
    }
};

struct ChainStatistics {
    TimePoint time;
    std::uint64_t exchanges = 0;     ///< commands answered to the last byte
    std::uint64_t bytesIn = 0;       ///< host to modules
    std::uint64_t bytesOut = 0;      ///< modules to host
    std::uint64_t bytesUnheard = 0;  ///< those of bytesIn that no module listened to
    std::uint64_t bytesLost = 0;     ///< exceeding the capacity of the line: see HostLine and
                                     ///< Chain::takeHostBytes
    std::vector<ModuleStatistics> modules;
};

}  // namespace nmc::sim

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/types.h"

namespace nmc::bus {

/// A known chain, as far as a search has found it again: all its modules, in their places.
struct Rejoined {
    std::vector<ModuleInfo> modules;
    std::vector<ModuleIndex> absent;  ///< modules that do not answer at their address
    /// The absent module that has restarted: it answers without an address.
    std::optional<ModuleIndex> restarted;
};

/// True if two searches found the same module: address, type and version agree.
[[nodiscard]] bool sameModule(const ModuleInfo& one, const ModuleInfo& other);

/// Matches modules by address, type and version; the place in the chain alone means nothing, because a module
/// that restarted is missing among the addresses, and all after it would move up. Returns nothing if a found
/// module does not belong to the known chain: then it is another chain, and is taken as found. `unaddressed`:
/// the identity of a module that answers without an address, if there is one. Pure.
[[nodiscard]] std::optional<Rejoined> rejoin(const std::vector<ModuleInfo>& known,
                                             const std::vector<ModuleInfo>& found,
                                             std::optional<ModuleIdentity> unaddressed);

}  // namespace nmc::bus

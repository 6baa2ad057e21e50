// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/types.h"

namespace nmc::bus {

/// A chain that was known, as far as a search has found it again: all its modules, in their places.
struct Rejoined {
    std::vector<ModuleInfo> modules;
    std::vector<ModuleIndex> absent;  ///< do not answer at their address
    /// Of them, the one that has restarted: it answers without an address.
    std::optional<ModuleIndex> restarted;
};

/// Whether what two searches found is one module: address, type and version agree.
[[nodiscard]] bool sameModule(const ModuleInfo& one, const ModuleInfo& other);

/// Modules are the same where address, type and version are; a place in the chain alone says nothing, since
/// one that restarted is missing among the addresses and all behind it would move up. Nothing when some
/// module that was found is not of that chain: then it is another one, and is taken as it was found.
/// `unaddressed`: what a module without an address says it is, if one answers. Pure.
[[nodiscard]] std::optional<Rejoined> rejoin(const std::vector<ModuleInfo>& known,
                                             const std::vector<ModuleInfo>& found,
                                             std::optional<ModuleIdentity> unaddressed);

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// The changes that put the modules into the groups of a machine and out of all others: for modules in a
/// different or unknown group, leaders last; none on a read-only connection. Pure; nothing moves as a result.
[[nodiscard]] std::vector<bus::GroupChange> groupChanges(const Machine& machine,
                                                         const std::vector<ModuleState>& modules);

/// Records the change that a module was sent in the machine's groups; groups without members and name are
/// removed.
void noteGroup(Machine& machine, const bus::GroupChange& change);
void nameGroup(Machine& machine, std::uint8_t address, const std::string& name);

}  // namespace nmc

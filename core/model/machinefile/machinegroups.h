// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// What puts the modules into the groups of a machine, and out of all others: those that are somewhere else
/// or nobody knows where, the leaders last; none where the connection only looks. Pure; nothing moves by it.
[[nodiscard]] std::vector<bus::GroupChange> groupChanges(const Machine& machine,
                                                         const std::vector<ModuleState>& modules);

/// Keeps what a module was told in the machine's groups; those without a member and a name go.
void noteGroup(Machine& machine, const bus::GroupChange& change);
void nameGroup(Machine& machine, std::uint8_t address, const std::string& name);

}  // namespace nmc

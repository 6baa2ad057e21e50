// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/machinefile/machinefile.h"
#include "model/module/linkstate.h"

/// Settings and positions belong to places in the chain. When modules are taken out, those behind them move
/// up, and what belongs to them has to move along: otherwise one motor gets the limits of another. Pure.
namespace nmc {

/// The index of a module once those in `gone` are out of the chain; empty: it is one of them.
[[nodiscard]] std::optional<ModuleIndex> indexWithout(const std::vector<ModuleIndex>& gone,
                                                      ModuleIndex module);

/// The machine without the axes of these modules, and with the new index wherever another module is named.
/// They leave groups, points and the order of homing; no row of a sequence may use them (userOfModules()).
[[nodiscard]] ParsedMachine withoutAxes(const std::vector<ModuleIndex>& gone, ParsedMachine from);

/// The machine that expects these modules. An axis that was set for another type is reset (usable()), and
/// removed from the points: positions are in counts of the chip as well. Where the type was not heard yet,
/// and beyond these modules, the former one stays expected, so that no numbers lose their type.
[[nodiscard]] Machine withModules(const std::vector<ModuleIdentity>& there, Machine machine);

/// The edited machine, with the module that is there as the expected one of each axis that has been set up
/// and expects none. So it is of one that expects another type, for which nothing had been set up `before`.
/// The places before such an axis that expect no module expect theirs, too.
[[nodiscard]] Machine forModules(const std::vector<ModuleIdentity>& there, const Machine& before,
                                 Machine edited);

}  // namespace nmc

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

/// The machine that has these modules. An axis that was set for another type begins anew (usable()), and
/// leaves the points: positions are in counts of the chip as well. Where the type was not heard yet, and
/// beyond these modules, the former one stays expected, so that no numbers lose their type.
[[nodiscard]] Machine withModules(const std::vector<ModuleIdentity>& there, Machine machine);

/// The machine after an edit by the user of these modules. A place that isSetUp() is for the module that is
/// there if it expects none, or one of another type for which nothing was set up before; and then places
/// before it that expect none are for theirs.
[[nodiscard]] Machine forModules(const std::vector<ModuleIdentity>& there, const Machine& before,
                                 Machine edited);

}  // namespace nmc

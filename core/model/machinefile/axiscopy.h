// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/machinefile/machinecompare.h"

namespace nmc {

/// Settings of one axis that others are to get. Numbers are copied as those of the chip: an axis with another
/// unit shows the same counts as another length. Never copied: the name of an axis, its expected module, its
/// work offsets, and the limit pins of an SC to another PIC-SERVO or the other way round.
struct AxisCopy {
    ModuleIndex from;
    AxisSettings settings;           ///< of that axis, when the user chose
    std::vector<ModuleIndex> to;     ///< those with another type of module stay as they are
    std::vector<MachinePart> parts;  ///< empty: all that differ
};

/// The axes that can get settings of that axis: those with the same type of module, if both are the expected
/// ones. Pure, as are the others here.
[[nodiscard]] std::vector<ModuleIndex> copyTargets(ModuleIndex from, const Machine& machine,
                                                   const std::vector<ModuleState>& modules);

/// The machine as if all settings were copied, to be compared with `now` and applied in part, like a file.
[[nodiscard]] Machine withCopy(const AxisCopy& copy, Machine now, const std::vector<ModuleState>& modules);
/// What the copy would change, and nothing else that differs between the panel and the modules.
[[nodiscard]] std::vector<Difference> copyDifferences(const AxisCopy& copy, const Machine& now,
                                                      const std::vector<ModuleState>& modules);

}  // namespace nmc

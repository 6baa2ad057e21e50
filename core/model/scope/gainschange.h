// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/strong.h"
#include "base/time.h"
#include "protocol/servocommands.h"

namespace nmc {

/// A change of the gains in force, confirmed by the module.
struct GainsChange {
    ModuleIndex module;
    TimePoint time;
    std::optional<servo::SetGain> gains;  ///< nothing: the module has lost them, or another host may have set
                                          ///< them

    bool operator==(const GainsChange&) const = default;
};

}  // namespace nmc

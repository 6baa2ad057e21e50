// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/strong.h"
#include "base/time.h"
#include "protocol/servocommands.h"

namespace nmc {

/// From then on these gains are in force: the module has confirmed them.
struct GainsChange {
    ModuleIndex module;
    TimePoint time;
    std::optional<servo::SetGain> gains;  ///< nothing: it has forgotten them, or another may have set them

    bool operator==(const GainsChange&) const = default;
};

}  // namespace nmc

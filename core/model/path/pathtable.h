// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "base/strong.h"
#include "protocol/pathpoint.h"

namespace nmc {

/// Positions of one or more axes, in counts, at a fixed rate.
struct PathTable {
    struct Column {
        ModuleIndex module;
        std::vector<std::int32_t> points;
        bool operator==(const Column&) const = default;
    };
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<Column> columns;  ///< all with the same number of points
    bool operator==(const PathTable&) const = default;
};

}  // namespace nmc

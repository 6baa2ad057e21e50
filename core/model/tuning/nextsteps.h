// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// How far steps should go that a motor is to be found from: friction and load differ by direction, gain and
/// friction by size. Distances in counts, signed. Pure.
namespace nmc {

/// Both ways, and in two sizes.
[[nodiscard]] bool informative(std::span<const std::int32_t> made);

/// There and back by that distance, then by twice as much; where that would be too long (kLongestStep), by
/// the longest and by half of it. The motor ends where it was.
[[nodiscard]] std::vector<std::int32_t> stepSeries(std::int32_t distance);

/// The one that goes on with steps that tell much: back again, or by the other size.
[[nodiscard]] std::int32_t nextStep(std::span<const std::int32_t> made);

}  // namespace nmc

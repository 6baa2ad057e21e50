// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Step distances from which a motor can be identified: friction and load differ by direction, gain and
/// friction by size. Distances are signed counts. Pure.
namespace nmc {

/// True when the steps made go both ways and have two sizes.
[[nodiscard]] bool informative(std::span<const std::int32_t> made);

/// Steps there and back by `distance`, then by twice as much; where that would exceed kLongestStep, by half
/// of kLongestStep and by all of it. The motor ends where it started.
[[nodiscard]] std::vector<std::int32_t> stepSeries(std::int32_t distance);

/// The next step of a series with both directions and sizes: back again, or by the other size.
[[nodiscard]] std::int32_t nextStep(std::span<const std::int32_t> made);

}  // namespace nmc

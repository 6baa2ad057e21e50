// SPDX-License-Identifier: MIT
#include "model/tuning/nextsteps.h"

#include <algorithm>
#include <cstdlib>

#include "model/intent/looptestplan.h"

namespace nmc {

namespace {

struct Sizes {
    std::int32_t least = 0, largest = 0;
};

[[nodiscard]] Sizes sizesOf(std::span<const std::int32_t> made) {
    Sizes sizes{std::abs(made.front()), 0};
    for (const std::int32_t counts : made)
        sizes = {std::min(sizes.least, std::abs(counts)), std::max(sizes.largest, std::abs(counts))};
    return sizes;
}

}  // namespace

bool informative(std::span<const std::int32_t> made) {
    const auto goesBack = [](std::int32_t counts) { return counts < 0; };
    if (made.empty() || std::all_of(made.begin(), made.end(), goesBack) ||
        std::none_of(made.begin(), made.end(), goesBack))
        return false;
    const Sizes sizes = sizesOf(made);
    return sizes.largest >= 3 * sizes.least / 2;
}

std::vector<std::int32_t> stepSeries(std::int32_t distance) {
    const std::int32_t once = std::clamp(distance, -kLongestStep / 2, kLongestStep / 2);
    return {once, -once, 2 * once, -2 * once};
}

std::int32_t nextStep(std::span<const std::int32_t> made) {
    const std::int32_t last = made.back();
    const std::int32_t before = made[made.size() - 2];
    if (before != -last)
        return -last;
    const Sizes sizes = sizesOf(made);
    const std::int32_t other = std::abs(last) == sizes.least ? sizes.largest : sizes.least;
    return before < 0 ? -other : other;
}

}  // namespace nmc

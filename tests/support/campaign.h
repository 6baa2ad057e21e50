// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>

namespace nmc::test {

/// How much a campaign does: what the environment variable says (scripts/test nightly sets it), or as much as
/// every run has time for.
[[nodiscard]] inline std::uint64_t campaignSize(const char* variable, std::uint64_t everyRun) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : everyRun;
}

}  // namespace nmc::test

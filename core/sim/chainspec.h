// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "protocol/moduletype.h"

namespace nmc::sim {

/// Longest chain on one RS-485 line (DS-V 6.1).
inline constexpr std::size_t kMaxModules = 32;

/// What is simulated when nobody says otherwise.
inline constexpr std::string_view kDefaultChain = "servo,servo,step";

/// Reads "servo,servo@1,step": a comma list in the order of addressing (farthest from the host first).
/// The error is one sentence that names the item and what is allowed.
[[nodiscard]] tl::expected<std::vector<ModuleIdentity>, std::string> parseChain(std::string_view text);

}  // namespace nmc::sim

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "protocol/moduletype.h"

namespace nmc::sim {

/// The chain that is simulated by default.
inline constexpr std::string_view kDefaultChain = "servo,servo,step";

/// Parses a comma-separated list such as "servo,servo@1,step", in addressing order (farthest from the host
/// first). The error is one sentence that names the item and what is allowed.
[[nodiscard]] tl::expected<std::vector<ModuleIdentity>, std::string> parseChain(std::string_view text);

}  // namespace nmc::sim

// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "protocol/moduletype.h"
#include "sim/fault.h"

namespace nmc::sim {

/// Parses the words that follow `fault`:
///
///     <bus|module K[,K...]> <kind> [cmd|status] [on=<command>] [p=PROB] [n=COUNT] [t=A..B] [at=TIME]
///     [for=DURATION] [bit=B]
///
/// Times are in seconds, or have a unit: 5ms, 300us, 2s. Modules count from 1. The error is one sentence that
/// says why a combination is not possible and what is.
[[nodiscard]] tl::expected<FaultSpec, std::string> parseFault(std::span<const std::string_view> words,
                                                              std::span<const ModuleIdentity> chain);

}  // namespace nmc::sim

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "model/machinefile/fileproblem.h"
#include "model/settings/machine.h"

namespace nmc {

/// Longer files are not read.
inline constexpr std::size_t kMaxMachineFile = 1'000'000;
/// File name extension of machine files.
inline constexpr std::string_view kMachineFileSuffix = "json";

/// The contents of a file that this program does not know: keys of newer programs, or of people. They are
/// written back in place.
struct UnknownKeys {
    std::string text{};  ///< the whole file as read; empty: nothing to preserve
    bool operator==(const UnknownKeys&) const = default;
};

struct ParsedMachine {
    Machine machine;
    UnknownKeys unknown;
};

/// Returns the whole machine or the problem: nothing is taken from a file with an error anywhere. Numbers are
/// in the chips' units and the ranges of their data sheets. Pure.
[[nodiscard]] tl::expected<ParsedMachine, FileProblem> parseMachine(std::string_view text);

/// Writes JSON that people can read: one key per line. Reading it yields exactly the same machine.
[[nodiscard]] std::string writeMachine(const Machine& machine, const UnknownKeys& unknown = {});

}  // namespace nmc

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
/// How the name of a machine file ends.
inline constexpr std::string_view kMachineFileSuffix = "json";

/// What a file has beside what this program knows: keys of newer programs, or of people. It is written again
/// where it stood.
struct UnknownKeys {
    std::string text{};  ///< the whole file as it was read; empty: nothing is there to be kept
    bool operator==(const UnknownKeys&) const = default;
};

struct ParsedMachine {
    Machine machine;
    UnknownKeys unknown;
};

/// The whole machine, or why not: nothing is taken from a file that is wrong somewhere. Numbers keep the
/// chips' units and their data sheets' ranges. Pure.
[[nodiscard]] tl::expected<ParsedMachine, FileProblem> parseMachine(std::string_view text);

/// JSON for people, too: one key a line. Reading it gives the same machine again, to the last bit.
[[nodiscard]] std::string writeMachine(const Machine& machine, const UnknownKeys& unknown = {});

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/frame.h"
#include "protocol/moduletype.h"

namespace nmc {

/// One command of one chip: the single place that says which versions have it, what it is called and how long
/// it may be.
struct CommandRow {
    ModuleType type;
    std::uint8_t firstVersion;
    std::uint8_t lastVersion;
    CommandCode code;
    std::string_view key;   ///< snake case, as in nmcsim's `stats`
    std::string_view name;  ///< the data sheet's name
    std::uint8_t minData;   ///< data bytes
    std::uint8_t maxData;
};

/// All commands of a module in the order of their codes; empty for one that is not known (isKnown).
[[nodiscard]] std::vector<CommandRow> commandTable(const ModuleIdentity& module);

/// The row for a code, or nothing when the module has no such command or is not known.
[[nodiscard]] std::optional<CommandRow> findCommand(const ModuleIdentity& module, CommandCode code);

}  // namespace nmc

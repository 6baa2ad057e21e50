// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "protocol/frame.h"
#include "protocol/moduletype.h"

namespace nmc {

/// One command of one chip. This is the single place that defines which versions have it, its name and its
/// length.
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

/// All commands of a module in the order of their codes; empty for an unknown module (isKnown).
[[nodiscard]] std::vector<CommandRow> commandTable(const ModuleIdentity& module);

/// The row for a code, or nothing when the module is unknown or has no such command.
[[nodiscard]] std::optional<CommandRow> findCommand(const ModuleIdentity& module, CommandCode code);

}  // namespace nmc

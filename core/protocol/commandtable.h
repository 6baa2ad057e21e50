// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/frame.h"
#include "protocol/moduletype.h"

namespace nmc {

/// One command of one chip: the single place that says what it is called and how long it may be.
struct CommandRow {
    CommandCode code;
    std::string_view key;   ///< snake case, as in nmcsim's `stats`
    std::string_view name;  ///< the data sheet's name
    std::uint8_t minData;   ///< data bytes
    std::uint8_t maxData;
};

/// All commands of a chip in the order of their codes; empty for a type without a data sheet here.
[[nodiscard]] std::span<const CommandRow> commandTable(ModuleType type);

/// The row for a code, or nothing when the chip has no such command.
[[nodiscard]] std::optional<CommandRow> findCommand(ModuleType type, CommandCode code);

}  // namespace nmc

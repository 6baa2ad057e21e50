// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/frame.h"
#include "protocol/moduletype.h"

namespace nmc {

/// Whether a command is allowed while the motor moves (DS-V 5.1).
enum class InMotion : std::uint8_t {
    Allowed,
    Forbidden,
    VelocityModeOnly,  ///< Load Trajectory with start, and Start Motion
};

/// One command of one chip: the single place that says what it is called and how long it may be.
struct CommandRow {
    CommandCode code;
    std::string_view key;   ///< snake case, as in nmcsim's `stats`
    std::string_view name;  ///< the data sheet's name
    std::uint8_t minData;   ///< data bytes
    std::uint8_t maxData;
    InMotion inMotion;
    bool replies;    ///< false: Hard Reset
    bool groupOnly;  ///< Set Baud
};

/// All commands of a chip in the order of their codes; empty for a type without a data sheet here.
[[nodiscard]] std::span<const CommandRow> commandTable(ModuleType type);

/// The row for a code, or nothing when the chip has no such command.
[[nodiscard]] std::optional<CommandRow> findCommand(ModuleType type, CommandCode code);

}  // namespace nmc

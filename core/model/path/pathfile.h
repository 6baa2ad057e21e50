// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "model/intent/travel.h"
#include "model/module/modulestate.h"
#include "model/path/pathtable.h"
#include "model/settings/axisscale.h"

/// Path files: CSV with one column of positions per axis and one line per point.
///
///     # rate 60
///     X, Y
///     0, 0
///     1.25, -0.5
///
/// The first line that is not a comment names the columns; they are axes, in any order. Positions are plain
/// decimal numbers with a point, absolute, in the axis's display unit. `# rate` is 30, 60 or 120; the default
/// is 60. Empty lines are allowed only at the end. Pure.
namespace nmc {

/// An axis as named in a file, and the limits for its points.
struct PathColumn {
    std::string name;
    ModuleIndex module;
    AxisScale scale{};
    std::optional<TravelRange> travel{};
    double fastest = 0.0;  ///< counts per tick; 0: as fast as a point can express
    bool operator==(const PathColumn&) const = default;
};
/// The name of an axis in files: its own name, or "Module 1" if it has none, or one with a comma.
[[nodiscard]] std::string pathName(ModuleIndex module, const std::string& name);
/// Describes an axis with the present state of its module.
[[nodiscard]] PathColumn pathColumn(const std::string& name, const ModuleState& module,
                                    const AxisScale& scale);

/// Axes with the same name, which a file could not tell apart, are named after their modules instead.
void nameApart(std::vector<PathColumn>& axes);

/// The axes of the table's columns, in order; `axes` must contain each of them.
[[nodiscard]] std::vector<PathColumn> columnsOf(const PathTable& table, std::span<const PathColumn> axes);

struct PathProblem {
    enum class Kind : std::uint8_t {
        Rate,           ///< not one of the available rates
        NoColumns,      ///< the file contains only comments
        UnknownColumn,  ///< `text` is not an axis that can follow a path
        ColumnTwice,
        Gap,           ///< an empty line, or an empty cell `text`
        CellCount,     ///< `value` cells instead of `allowed`
        NotANumber,    ///< `text`
        OutOfRange,    ///< beyond the chip's 32 bits
        Jump,          ///< `value` counts from the point before; `allowed` in one segment at this rate
        TooFast,       ///< `value` counts per tick; `allowed` for this axis
        BeyondTravel,  ///< at `value` counts; the limit is `allowed`
        TooFewPoints,  ///< a path has at least two points
        TooManyPoints,
    };
    Kind kind = Kind::NoColumns;
    std::size_t line = 0;  ///< from 1; 0: concerns the file as a whole
    std::string column{};  ///< name of the column, if the problem concerns one
    std::string text{};    ///< the text in the file
    double value = 0.0;
    double allowed = 0.0;
    bool operator==(const PathProblem&) const = default;
};

/// An hour at 120 Hz.
inline constexpr std::size_t kMaxPathPoints = 450'000;
/// The maximum number of problems reported; the search ends there.
inline constexpr std::size_t kMaxPathProblems = 20;

/// Returns the points, or all problems, by line.
[[nodiscard]] tl::expected<PathTable, std::vector<PathProblem>> readPath(std::string_view text,
                                                                         std::span<const PathColumn> axes);
/// Writes the path as a file that reads back to the exact count. `axes` must include those of the table.
[[nodiscard]] std::string pathText(const PathTable& table, std::span<const PathColumn> axes);

}  // namespace nmc

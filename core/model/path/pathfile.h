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

/// Path files: CSV with a column of positions for each axis, a line for each point.
///
///     # rate 60
///     X, Y
///     0, 0
///     1.25, -0.5
///
/// The first line that is no comment names the columns; they are axes, in any order. Positions are plain
/// decimal numbers with a point, absolute, in the unit that the axis is read in. `# rate` is 30, 60 or 120,
/// and 60 where it is not said. Empty lines may stand at the end only. Pure.
namespace nmc {

/// An axis as a file may name it, and what its points have to keep.
struct PathColumn {
    std::string name;
    ModuleIndex module;
    AxisScale scale{};
    std::optional<TravelRange> travel{};
    double fastest = 0.0;  ///< counts per tick; 0: as fast as a point can tell
    bool operator==(const PathColumn&) const = default;
};
/// What a file calls an axis: its name, or "Module 1" for one that has none, or one with a comma.
[[nodiscard]] std::string pathName(ModuleIndex module, const std::string& name);
/// As its module is now.
[[nodiscard]] PathColumn pathColumn(const std::string& name, const ModuleState& module,
                                    const AxisScale& scale);

/// Those of the table's columns, in their order; `axes` has each of them.
[[nodiscard]] std::vector<PathColumn> columnsOf(const PathTable& table, std::span<const PathColumn> axes);

struct PathProblem {
    enum class Kind : std::uint8_t {
        Rate,           ///< none that there is
        NoColumns,      ///< nothing but comments
        UnknownColumn,  ///< `text` is no axis that takes a path
        ColumnTwice,
        Gap,           ///< an empty line, or a cell of `text` without a number
        CellCount,     ///< `value` cells instead of `allowed`
        NotANumber,    ///< `text`
        OutOfRange,    ///< beyond the chip's 32 bits
        Jump,          ///< `value` counts from the point before; `allowed` in one segment at this rate
        TooFast,       ///< `value` counts per tick; `allowed` for this axis
        BeyondTravel,  ///< at `value` counts; the limit is `allowed`
        TooFewPoints,  ///< a path has two at least
        TooManyPoints,
    };
    Kind kind = Kind::NoColumns;
    std::size_t line = 0;  ///< from 1; 0: of the file as a whole
    std::string column{};  ///< its name, where it is one column's
    std::string text{};    ///< as it stands in the file
    double value = 0.0;
    double allowed = 0.0;
    bool operator==(const PathProblem&) const = default;
};

/// An hour at 120 Hz.
inline constexpr std::size_t kMaxPathPoints = 450'000;
/// Problems that are told; those behind them are not looked for.
inline constexpr std::size_t kMaxPathProblems = 20;

/// The points, or all that is wrong, by line.
[[nodiscard]] tl::expected<PathTable, std::vector<PathProblem>> readPath(std::string_view text,
                                                                         std::span<const PathColumn> axes);
/// The same path as a file that reads back to the count. `axes`: those of the table.
[[nodiscard]] std::string pathText(const PathTable& table, std::span<const PathColumn> axes);

}  // namespace nmc

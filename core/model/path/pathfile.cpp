// SPDX-License-Identifier: MIT
#include "model/path/pathfile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "base/numbertext.h"
#include "base/text.h"

namespace nmc {

namespace {

constexpr std::string_view kBlank = " \t\r";

[[nodiscard]] std::vector<std::string_view> cellsOf(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const auto comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma), kBlank));
        if (comma == std::string_view::npos)
            return cells;
        line.remove_prefix(comma + 1);
    }
}

[[nodiscard]] std::string_view withoutPlus(std::string_view number) {
    return number.substr(number.starts_with('+') && !number.starts_with("+-") ? 1 : 0);
}

class PathReader {
public:
    explicit PathReader(std::span<const PathColumn> axes) : m_axes(axes) {}

    tl::expected<PathTable, std::vector<PathProblem>> read(std::string_view text) {
        while (!text.empty() && m_problems.size() < kMaxPathProblems && !m_tooMany) {
            ++m_line;
            const auto end = text.find('\n');
            take(trimmed(text.substr(0, end), kBlank));
            text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        }
        if (m_columns.empty() && m_problems.empty())
            add({.kind = PathProblem::Kind::NoColumns});
        else if (m_points < 2 && m_problems.empty())
            add({.kind = PathProblem::Kind::TooFewPoints,
                 .line = m_line,
                 .value = static_cast<double>(m_points)});
        if (!m_problems.empty())
            return tl::unexpected(std::move(m_problems));
        return std::move(m_table);
    }

private:
    void add(PathProblem problem) {
        if (m_problems.size() < kMaxPathProblems)
            m_problems.push_back(std::move(problem));
    }

    void take(std::string_view line) {
        if (line.empty()) {
            m_gap = m_gap == 0 ? m_line : m_gap;
            return;
        }
        if (line.starts_with('#'))
            return takeComment(trimmed(line.substr(1), kBlank));
        if (!m_header)
            return takeHeader(line);
        if (m_gap > 0 && m_points > 0)
            add({.kind = PathProblem::Kind::Gap, .line = m_gap});
        m_gap = 0;
        takePoints(line);
    }

    void takeComment(std::string_view comment) {
        constexpr std::string_view kRate = "rate";
        if (!comment.starts_with(kRate) || m_header)
            return;
        const std::string_view said = trimmed(comment.substr(kRate.size()), kBlank);
        const auto hertz = numberIn<int>(withoutPlus(said));
        if (hertz == 30)
            m_table.rate = servo::PathRate::Hz30;
        else if (hertz == 60)
            m_table.rate = servo::PathRate::Hz60;
        else if (hertz == 120)
            m_table.rate = servo::PathRate::Hz120;
        else
            add({.kind = PathProblem::Kind::Rate, .line = m_line, .text = std::string(said)});
    }

    void takeHeader(std::string_view line) {
        m_header = true;
        m_gap = 0;
        for (const std::string_view name : cellsOf(line)) {
            const PathColumn* axis = nullptr;
            for (const PathColumn& candidate : m_axes)
                if (candidate.name == name)
                    axis = &candidate;
            if (axis == nullptr)
                add({.kind = PathProblem::Kind::UnknownColumn, .line = m_line, .text = std::string(name)});
            for (const PathColumn* other : m_columns)
                if (axis != nullptr && other == axis)
                    add({.kind = PathProblem::Kind::ColumnTwice, .line = m_line, .column = axis->name});
            m_columns.push_back(axis);
            m_table.columns.push_back({axis != nullptr ? axis->module : ModuleIndex(), {}});
        }
        m_before.resize(m_columns.size());
    }

    void takePoints(std::string_view line) {
        ++m_points;
        if (m_points > kMaxPathPoints) {
            m_tooMany = true;
            return add({.kind = PathProblem::Kind::TooManyPoints,
                        .line = m_line,
                        .allowed = static_cast<double>(kMaxPathPoints)});
        }
        const auto cells = cellsOf(line);
        if (cells.size() != m_columns.size()) {
            m_before.assign(m_columns.size(), std::nullopt);
            return add({.kind = PathProblem::Kind::CellCount,
                        .line = m_line,
                        .value = static_cast<double>(cells.size()),
                        .allowed = static_cast<double>(m_columns.size())});
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (m_columns[i] == nullptr)
                continue;
            const auto counts = countsIn(cells[i], *m_columns[i]);
            if (counts) {
                verify(*counts, m_before[i], *m_columns[i]);
                m_table.columns[i].points.push_back(*counts);
            }
            m_before[i] = counts;
        }
    }

    [[nodiscard]] std::optional<std::int32_t> countsIn(std::string_view cell, const PathColumn& axis) {
        const auto of = [&](PathProblem::Kind kind) {
            add({.kind = kind, .line = m_line, .column = axis.name, .text = std::string(cell)});
            return std::nullopt;
        };
        if (cell.empty())
            return of(PathProblem::Kind::Gap);
        const auto position = numberIn<double>(withoutPlus(cell));
        if (!position || !std::isfinite(*position))
            return of(PathProblem::Kind::NotANumber);
        const double counts = std::round(axis.scale.counts(*position));
        if (!(std::abs(counts) <= std::numeric_limits<std::int32_t>::max()))
            return of(PathProblem::Kind::OutOfRange);
        return static_cast<std::int32_t>(counts);
    }

    /// Checks a segment; of the first point only the position is checked, because the start of the path is
    /// unknown here.
    void verify(std::int64_t point, std::optional<std::int64_t> before, const PathColumn& axis) {
        const auto of = [&](PathProblem::Kind kind, double value, double allowed) {
            add({.kind = kind, .line = m_line, .column = axis.name, .value = value, .allowed = allowed});
        };
        const auto distance = static_cast<double>(std::abs(point - before.value_or(point)));
        if (const int most = servo::maxPathCounts(m_table.rate); distance > most)
            of(PathProblem::Kind::Jump, distance, most);
        else if (axis.fastest > 0.0 && distance > longestSegment(axis.fastest, m_table.rate))
            of(PathProblem::Kind::TooFast, distance / servo::ticksPerPoint(m_table.rate), axis.fastest);
        if (const auto beyond = axis.travel ? beyondTravel(point, *axis.travel) : std::nullopt)
            of(PathProblem::Kind::BeyondTravel, static_cast<double>(point), *beyond);
    }

    /// Returns the limit that is exceeded.
    [[nodiscard]] static std::optional<double> beyondTravel(std::int64_t point, const TravelRange& range) {
        if (range.lowest && point < *range.lowest)
            return *range.lowest;
        if (range.highest && point > *range.highest)
            return *range.highest;
        return std::nullopt;
    }

    std::span<const PathColumn> m_axes;
    PathTable m_table;
    std::vector<const PathColumn*> m_columns;  ///< null for a column that is not an axis
    std::vector<std::optional<std::int64_t>> m_before;
    std::vector<PathProblem> m_problems;
    std::size_t m_line = 0;
    std::size_t m_points = 0;
    std::size_t m_gap = 0;  ///< the first of the empty lines before this line
    bool m_header = false;
    bool m_tooMany = false;
};

}  // namespace

std::string pathName(ModuleIndex module, const std::string& name) {
    const std::string_view said = trimmed(name, kBlank);  // as in the cell that is read
    const bool sayable = !said.empty() && said.find(',') == std::string::npos && !said.starts_with('#');
    return sayable ? std::string(said) : "Module " + std::to_string(module.value() + 1);
}

PathColumn pathColumn(const std::string& name, const ModuleState& module, const AxisScale& scale) {
    return {name, module.info.index, scale, travelRange(module), module.travel.fastest};
}

void nameApart(std::vector<PathColumn>& axes) {
    std::multiset<std::string> names;
    do {  // again if the name of a module is that of another axis
        names.clear();
        for (const PathColumn& axis : axes)
            names.insert(axis.name);
        for (PathColumn& axis : axes)
            if (names.count(axis.name) > 1)
                axis.name = pathName(axis.module, {});
    } while (std::ranges::any_of(names, [&](const std::string& name) { return names.count(name) > 1; }));
}

std::vector<PathColumn> columnsOf(const PathTable& table, std::span<const PathColumn> axes) {
    std::vector<PathColumn> columns;
    for (const PathTable::Column& column : table.columns)
        columns.push_back(*std::ranges::find(axes, column.module, &PathColumn::module));
    return columns;
}

tl::expected<PathTable, std::vector<PathProblem>> readPath(std::string_view text,
                                                           std::span<const PathColumn> axes) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    return PathReader(axes).read(text);
}

std::string pathText(const PathTable& table, std::span<const PathColumn> axes) {
    const std::vector<PathColumn> columns = columnsOf(table, axes);
    std::string text = "# rate " + std::to_string(servo::nominalHertz(table.rate)) + '\n';
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += (i == 0 ? "" : ", ") + columns[i].name;
    text += '\n';
    for (std::size_t point = 0; point < table.columns.front().points.size(); ++point) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            text += i == 0 ? "" : ", ";
            appendNumber(text, columns[i].scale.position(table.columns[i].points[point]));
        }
        text += '\n';
    }
    return text;
}

}  // namespace nmc

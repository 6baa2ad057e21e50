// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a path file: a path that was read respects the limits of its axes, and is the same after it
// was written; anything else is refused with the numbers of existing lines.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "model/path/pathfile.h"
#include "protocol/pathpoint.h"

namespace {

using namespace nmc;

constexpr std::int32_t kLowest = -2'000;
constexpr std::int32_t kHighest = 50'000;
constexpr double kFastest = 8.0;  ///< counts per tick
constexpr int kCountsPerMillimetre = 200;

void require(bool condition) {
    if (!condition)
        std::abort();
}

/// X in millimetres with limits, Y in counts without any.
std::vector<PathColumn> axes() {
    return {{"X", ModuleIndex(0), AxisScale::servo({UnitKind::Millimetres, kCountsPerMillimetre, {}}, 1),
             TravelRange{kLowest, kHighest}, kFastest},
            {"Y", ModuleIndex(1)}};
}

/// The magnitude of a point has 14, 13 or 12 bits (docs/family.md, Path points).
std::int64_t longestSegment(servo::PathRate rate) {
    return rate == servo::PathRate::Hz30 ? 16'383 : rate == servo::PathRate::Hz60 ? 8'191 : 4'095;
}

/// Plain decimals without rounding: a count is 0.005 mm.
std::string cell(ModuleIndex module, std::int32_t counts) {
    if (module == ModuleIndex(1))
        return std::to_string(counts);
    const std::int64_t thousandths = std::int64_t{counts} * 1'000 / kCountsPerMillimetre;
    std::string digits = std::to_string(std::abs(thousandths));
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    digits.insert(digits.size() - 3, 1, '.');
    return (thousandths < 0 ? "-" : "") + digits;
}

std::string written(const PathTable& table) {
    const int rate = table.rate == servo::PathRate::Hz30   ? 30
                     : table.rate == servo::PathRate::Hz60 ? 60
                                                           : 120;
    std::string text = "# rate " + std::to_string(rate) + '\n';
    for (const PathTable::Column& column : table.columns)
        text += std::string(column.module == ModuleIndex(0) ? "X" : "Y") +
                (&column == &table.columns.back() ? '\n' : ',');
    for (std::size_t i = 0; i < table.columns.front().points.size(); ++i)
        for (const PathTable::Column& column : table.columns)
            text += cell(column.module, column.points[i]) + (&column == &table.columns.back() ? '\n' : ',');
    return text;
}

void keepsItsLimits(const PathTable& table) {
    require(!table.columns.empty() && table.columns.size() <= 2);
    require(table.columns.size() == 1 || table.columns[0].module != table.columns[1].module);
    for (const PathTable::Column& column : table.columns) {
        const auto& points = column.points;
        require(points.size() >= 2 && points.size() <= kMaxPathPoints);
        require(points.size() == table.columns.front().points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::int64_t way = i > 0 ? std::int64_t{points[i]} - points[i - 1] : 0;
            require(std::abs(way) <= longestSegment(table.rate));
            if (column.module == ModuleIndex(0)) {
                require(points[i] >= kLowest && points[i] <= kHighest);
                require(std::abs(static_cast<double>(way)) <= kFastest * servo::ticksPerPoint(table.rate));
            }
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const auto read = readPath(text, axes());
    if (!read) {
        require(!read.error().empty() && read.error().size() <= kMaxPathProblems);
        const auto lines = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        for (const PathProblem& problem : read.error())
            require(problem.line <= lines);
        return 0;
    }
    keepsItsLimits(*read);
    const auto again = readPath(written(*read), axes());
    require(again && *again == *read);
    return 0;
}

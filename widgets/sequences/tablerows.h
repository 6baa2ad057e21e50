// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace nmc {

/// The rows to insert or remove to turn a table into another one: equal rows at the top and bottom stay, and
/// so does the selection there.
struct RowChange {
    int at = 0;
    int removed = 0;
    int inserted = 0;
};

template <typename Row>
[[nodiscard]] RowChange rowChange(const std::vector<Row>& before, const std::vector<Row>& now) {
    const auto fromTop = std::ranges::mismatch(before, now).in1 - before.begin();
    std::ptrdiff_t fromBottom = 0;
    const auto shorter = static_cast<std::ptrdiff_t>(std::min(before.size(), now.size()));
    while (fromTop + fromBottom < shorter &&
           before[before.size() - 1 - static_cast<std::size_t>(fromBottom)] ==
               now[now.size() - 1 - static_cast<std::size_t>(fromBottom)])
        ++fromBottom;
    const auto common = std::min(before.size(), now.size());
    const auto changed = static_cast<int>(static_cast<std::ptrdiff_t>(common) - fromTop - fromBottom);
    const int more = static_cast<int>(now.size()) - static_cast<int>(before.size());
    return {static_cast<int>(fromTop) + changed, std::max(0, -more), std::max(0, more)};
}

/// Changes the number of `rows` to that of `now`, between begin...() and end...() of the model; the caller
/// has to update the other rows that have changed, and to signal that.
template <typename Model, typename Row>
void changeRowCount(Model& model, std::vector<Row>& rows, const std::vector<Row>& now) {
    const RowChange change = rowChange(rows, now);
    const auto at = rows.begin() + change.at;
    if (change.removed > 0) {
        model.beginRemoveRows({}, change.at, change.at + change.removed - 1);
        rows.erase(at, at + change.removed);
        model.endRemoveRows();
    } else if (change.inserted > 0) {
        model.beginInsertRows({}, change.at, change.at + change.inserted - 1);
        const auto from = now.begin() + change.at;
        rows.insert(at, from, from + change.inserted);
        model.endInsertRows();
    }
}

}  // namespace nmc

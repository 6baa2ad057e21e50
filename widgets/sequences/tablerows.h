// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace nmc {

/// Changes the number of `rows` to that of `now`, between begin...() and end...() of the model: equal rows at
/// the top and bottom stay, and so does the selection there. The caller has to update the other rows that
/// have changed, and to signal that.
template <typename Model, typename Row>
void changeRowCount(Model& model, std::vector<Row>& rows, const std::vector<Row>& now) {
    const auto fromTop = std::ranges::mismatch(rows, now).in1 - rows.begin();
    const auto fromBottom =
        std::mismatch(rows.rbegin(), rows.rend(), now.rbegin(), now.rend()).first - rows.rbegin();
    const std::ptrdiff_t more = std::ssize(now) - std::ssize(rows);
    const std::ptrdiff_t common = std::min(std::ssize(rows), std::ssize(now));
    const std::ptrdiff_t at = std::max(fromTop, common - fromBottom);
    const int first = static_cast<int>(at);
    if (more < 0) {
        model.beginRemoveRows({}, first, first - static_cast<int>(more) - 1);
        rows.erase(rows.begin() + at, rows.begin() + at - more);
        model.endRemoveRows();
    } else if (more > 0) {
        model.beginInsertRows({}, first, first + static_cast<int>(more) - 1);
        rows.insert(rows.begin() + at, now.begin() + at, now.begin() + at + more);
        model.endInsertRows();
    }
}

}  // namespace nmc

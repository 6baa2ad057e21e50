// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model/sequence/sequencewalk.h"

/// Changes that keep a program's rows and names in step: a repeat goes back to the row it was told of
/// wherever that is now, and a new name is one everywhere. Pure.
namespace nmc {

/// Before row `at`, which may be one behind the last.
void insertRow(Sequence& sequence, std::size_t at, Action row);
/// A repeat that went back to it goes back to the row behind it, or away where none is left to repeat.
void removeRow(Sequence& sequence, std::size_t at);
/// False, and nothing is changed, where there is no such row, or where a repeat would come to stand above the
/// row that it goes back to.
[[nodiscard]] bool moveRow(Sequence& sequence, std::size_t from, std::size_t to);

void renamePoint(Program& program, const std::string& from, const std::string& to);
void renameSequence(Program& program, const std::string& from, const std::string& to);

/// The first row that moves to it; nothing: it can go.
[[nodiscard]] std::optional<RowPlace> userOfPoint(const Program& program, const std::string& name);
/// The first row that calls it.
[[nodiscard]] std::optional<RowPlace> userOfSequence(const Program& program, const std::string& name);
/// `base`, or `base` with the first number behind it that is not taken by one of `all`.
template <typename Named>
[[nodiscard]] std::string freeName(const std::vector<Named>& all, const std::string& base) {
    std::string name = base;
    for (int number = 2; std::ranges::find(all, name, &Named::name) != all.end(); ++number)
        name = base + ' ' + std::to_string(number);
    return name;
}

}  // namespace nmc

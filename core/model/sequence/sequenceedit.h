// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model/sequence/sequencewalk.h"

/// Changes that keep a program's rows and names consistent: a repeat keeps going back to the same row
/// wherever that row moves, and a renamed point or sequence is renamed in every row that uses it. Pure.
namespace nmc {

/// Inserts a row before row `at`, which may be one past the last.
void insertRow(Sequence& sequence, std::size_t at, Action row);
/// Removes a row. A repeat that went back to it goes back to the following row instead, and is itself removed
/// if no row is left to repeat.
void removeRow(Sequence& sequence, std::size_t at);
/// Returns false and changes nothing if there is no such row, or if a repeat would end up above the row that
/// it goes back to.
[[nodiscard]] bool moveRow(Sequence& sequence, std::size_t from, std::size_t to);

void renamePoint(Program& program, const std::string& from, const std::string& to);
void renameSequence(Program& program, const std::string& from, const std::string& to);

/// The first row that moves to the point; empty if the point can be removed.
[[nodiscard]] std::optional<RowPlace> userOfPoint(const Program& program, const std::string& name);
/// The first row that calls the sequence; empty if the sequence can be removed.
[[nodiscard]] std::optional<RowPlace> userOfSequence(const Program& program, const std::string& name);
/// The first row that sets, homes or waits for one of the modules; empty if they can be removed from the
/// machine.
[[nodiscard]] std::optional<RowPlace> userOfModules(const Program& program,
                                                    const std::vector<ModuleIndex>& modules);
/// Returns `base`, or `base` followed by the first number from 2 that yields a name not used in `all`.
template <typename Named>
[[nodiscard]] std::string freeName(const std::vector<Named>& all, const std::string& base) {
    std::string name = base;
    for (int number = 2; std::ranges::find(all, name, &Named::name) != all.end(); ++number)
        name = base + ' ' + std::to_string(number);
    return name;
}

}  // namespace nmc

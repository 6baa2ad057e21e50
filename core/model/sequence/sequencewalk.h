// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/sequence/sequence.h"

/// In what order the rows of a sequence come, with those of the sequences that it calls. Pure.
namespace nmc {

struct RowPlace {
    std::string sequence;
    std::size_t row = 0;
    std::map<std::size_t, unsigned> rounds{};  ///< by the row of a repeat: how often its rows were done
    bool operator==(const RowPlace&) const = default;
};

/// Null: behind the last row.
[[nodiscard]] const Action* rowAt(const Program& program, const RowPlace& place);

/// From a row that is done to the one that a run comes to then. `places`: the sequence that was started, then
/// those that it called, each with the row that it is at; behind the last row of the first one the run ends.
void goOn(const Program& program, std::vector<RowPlace>& places);

/// All rows that a run from this place on may come to, as it comes to them first. Repeats are not followed,
/// and each sequence is gone into once.
[[nodiscard]] std::vector<RowPlace> rowsFrom(const Program& program, const RowPlace& place);
/// All rows that were done when a run from the top comes to this place, the last first, likewise once each.
[[nodiscard]] std::vector<RowPlace> rowsAbove(const Program& program, const RowPlace& place);

/// All modules that a sequence moves, sets or waits for, with those that it calls.
[[nodiscard]] std::set<ModuleIndex> modulesOf(const Program& program, const std::string& sequence);

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/sequence/sequence.h"

/// Defines the order in which rows run, including the rows of called sequences. Pure.
namespace nmc {

struct RowPlace {
    std::string sequence;
    std::size_t row = 0;
    std::map<std::size_t, unsigned> rounds{};  ///< by row of a repeat: how often its rows were run
    bool operator==(const RowPlace&) const = default;
};

/// Returns null past the last row.
[[nodiscard]] const Action* rowAt(const Program& program, const RowPlace& place);

/// Advances from a completed row to the next one of a run. `places`: the sequence that was started, then the
/// called sequences, each with its current row. The run ends past the last row of the first one.
void goOn(const Program& program, std::vector<RowPlace>& places);

/// All rows that a run from this place on may reach, in the order in which it first reaches them: also those
/// above it to which a repeat goes back. Each sequence is entered once.
[[nodiscard]] std::vector<RowPlace> rowsFrom(const Program& program, const RowPlace& place);
/// All rows that a run from the top has completed when it reaches this place, last row first. Repeats are not
/// followed, and each sequence is entered once.
[[nodiscard]] std::vector<RowPlace> rowsAbove(const Program& program, const RowPlace& place);

/// All modules that a sequence, or a sequence called by it, moves, homes, sets or waits for.
[[nodiscard]] std::set<ModuleIndex> modulesOf(const Program& program, const std::string& sequence);

}  // namespace nmc

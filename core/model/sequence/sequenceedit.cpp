// SPDX-License-Identifier: MIT
#include "model/sequence/sequenceedit.h"

#include <utility>

namespace nmc {

namespace {

/// Updates every repeat with the new place of the row that it goes back to.
template <typename NewPlace>
void follow(Sequence& sequence, NewPlace newPlace) {
    for (Action& row : sequence.rows)
        if (auto* repeat = std::get_if<action::Repeat>(&row))
            repeat->from = newPlace(repeat->from);
}

template <typename Kind, std::string Kind::*Name>
void rename(Program& program, const std::string& from, const std::string& to) {
    for (Sequence& sequence : program.sequences)
        for (Action& row : sequence.rows)
            if (auto* user = std::get_if<Kind>(&row); user != nullptr && user->*Name == from)
                user->*Name = to;
}

template <typename Uses>
std::optional<RowPlace> firstRow(const Program& program, Uses uses) {
    for (const Sequence& sequence : program.sequences)
        for (std::size_t row = 0; row < sequence.rows.size(); ++row)
            if (uses(sequence.rows[row]))
                return RowPlace{sequence.name, row};
    return std::nullopt;
}

template <typename Kind, std::string Kind::*Name>
std::optional<RowPlace> userOf(const Program& program, const std::string& name) {
    return firstRow(program, [&name](const Action& row) {
        const auto* user = std::get_if<Kind>(&row);
        return user != nullptr && user->*Name == name;
    });
}

/// The first repeat that goes back to itself or to a row below.
std::optional<std::size_t> strayRepeat(const Sequence& sequence) {
    for (std::size_t row = 0; row < sequence.rows.size(); ++row)
        if (const auto* repeat = std::get_if<action::Repeat>(&sequence.rows[row]);
            repeat != nullptr && repeat->from >= row)
            return row;
    return std::nullopt;
}

}  // namespace

void insertRow(Sequence& sequence, std::size_t at, Action row) {
    follow(sequence, [at](std::size_t place) { return place >= at ? place + 1 : place; });
    sequence.rows.insert(sequence.rows.begin() + static_cast<std::ptrdiff_t>(at), std::move(row));
}

void removeRow(Sequence& sequence, std::size_t at) {
    sequence.rows.erase(sequence.rows.begin() + static_cast<std::ptrdiff_t>(at));
    follow(sequence, [at](std::size_t place) { return place > at ? place - 1 : place; });
    if (const auto stray = strayRepeat(sequence))
        removeRow(sequence, *stray);
}

bool moveRow(Sequence& sequence, std::size_t from, std::size_t to) {
    if (std::max(from, to) >= sequence.rows.size())
        return false;
    Sequence moved = sequence;
    const auto begin = moved.rows.begin();
    const auto at = [begin](std::size_t row) { return begin + static_cast<std::ptrdiff_t>(row); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
    follow(moved, [from, to](std::size_t place) {
        if (place == from)
            return to;
        if (from < place && place <= to)
            return place - 1;
        return to <= place && place < from ? place + 1 : place;
    });
    if (strayRepeat(moved))
        return false;
    sequence = std::move(moved);
    return true;
}

void renamePoint(Program& program, const std::string& from, const std::string& to) {
    for (Point& point : program.points)
        if (point.name == from)
            point.name = to;
    rename<action::MoveTo, &action::MoveTo::point>(program, from, to);
}

void renameSequence(Program& program, const std::string& from, const std::string& to) {
    for (Sequence& sequence : program.sequences)
        if (sequence.name == from)
            sequence.name = to;
    rename<action::Call, &action::Call::sequence>(program, from, to);
}

std::optional<RowPlace> userOfPoint(const Program& program, const std::string& name) {
    return userOf<action::MoveTo, &action::MoveTo::point>(program, name);
}

std::optional<RowPlace> userOfSequence(const Program& program, const std::string& name) {
    return userOf<action::Call, &action::Call::sequence>(program, name);
}

std::optional<RowPlace> userOfModules(const Program& program, const std::vector<ModuleIndex>& modules) {
    return firstRow(program, [&modules](const Action& row) {
        const auto module = moduleOf(row);
        return module && std::ranges::find(modules, *module) != modules.end();
    });
}

}  // namespace nmc

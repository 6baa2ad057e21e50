// SPDX-License-Identifier: MIT
#include "model/sequence/sequencewalk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace nmc {

namespace {

constexpr auto kToTheEnd = std::numeric_limits<std::size_t>::max();

class EachRowOnce {
public:
    EachRowOnce(const Program& program, bool upward) : m_program(program), m_upward(upward) {}

    [[nodiscard]] std::vector<RowPlace> between(const std::string& name, std::size_t first,
                                                std::size_t end) && {
        add(name, first, end);
        return std::move(m_rows);
    }

private:
    void add(const std::string& name, std::size_t first, std::size_t end) {
        const Sequence* sequence = m_program.sequence(name);
        if (sequence == nullptr || !m_seen.insert(name).second)
            return;
        std::size_t lowest = first;
        addRows(*sequence, first, std::min(end, sequence->rows.size()), lowest);
    }
    /// `lowest`: all rows from this one on are in the list, or about to be.
    void addRows(const Sequence& sequence, std::size_t first, std::size_t end, std::size_t& lowest) {
        for (std::size_t i = first; i < end; ++i) {
            const std::size_t row = m_upward ? first + (end - 1 - i) : i;
            m_rows.push_back({sequence.name, row});
            if (const auto* call = std::get_if<action::Call>(&sequence.rows[row]))
                add(call->sequence, 0, kToTheEnd);
            const auto* repeat = std::get_if<action::Repeat>(&sequence.rows[row]);
            if (!m_upward && repeat != nullptr && repeat->times != 1 && repeat->from < lowest)
                addRows(sequence, repeat->from, std::exchange(lowest, repeat->from), lowest);
        }
    }

    const Program& m_program;
    bool m_upward;
    std::set<std::string> m_seen;
    std::vector<RowPlace> m_rows;
};

}  // namespace

const Action* rowAt(const Program& program, const RowPlace& place) {
    const Sequence* sequence = program.sequence(place.sequence);
    return sequence != nullptr && place.row < sequence->rows.size() ? &sequence->rows[place.row] : nullptr;
}

void goOn(const Program& program, std::vector<RowPlace>& places) {
    RowPlace& place = places.back();
    const Action* done = rowAt(program, place);
    const auto* repeat = std::get_if<action::Repeat>(done);
    if (const auto* call = std::get_if<action::Call>(done)) {
        places.push_back({call->sequence});
    } else if (repeat != nullptr && (++place.rounds[place.row] < repeat->times || repeat->times == 0)) {
        place.row = repeat->from;
    } else {
        place.rounds.erase(place.row);
        ++place.row;
    }
    while (places.size() > 1 && rowAt(program, places.back()) == nullptr) {
        places.pop_back();
        ++places.back().row;
    }
}

std::vector<RowPlace> rowsFrom(const Program& program, const RowPlace& place) {
    return EachRowOnce(program, false).between(place.sequence, place.row, kToTheEnd);
}

std::vector<RowPlace> rowsAbove(const Program& program, const RowPlace& place) {
    return EachRowOnce(program, true).between(place.sequence, 0, place.row);
}

std::set<ModuleIndex> modulesOf(const Program& program, const std::string& sequence) {
    std::set<ModuleIndex> modules;
    for (const RowPlace& place : rowsFrom(program, {sequence})) {
        const Action& row = *rowAt(program, place);
        const auto* move = std::get_if<action::MoveTo>(&row);
        if (const Point* point = move != nullptr ? program.point(move->point) : nullptr)
            for (const PointAxis& axis : point->axes)
                modules.insert(axis.module);
        if (const auto module = moduleOf(row))
            modules.insert(*module);
    }
    return modules;
}

}  // namespace nmc

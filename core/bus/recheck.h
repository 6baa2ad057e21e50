// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// The numbers that were sent while addresses were assigned (addressing.h) but at which no module was heard.
/// One may have been taken all the same, and the answers lost or too late, so before the chain is considered
/// complete, each is queried once more. Pure.
class Recheck {
public:
    /// No module was heard at this number.
    void add(BusAddress number) { m_numbers.push_back(number); }
    [[nodiscard]] bool empty() const { return m_numbers.empty(); }
    [[nodiscard]] bool contains(BusAddress number) const {
        return std::ranges::find(m_numbers, number) != m_numbers.end();
    }

    /// Begins a round of queries: one for each number.
    void begin() {
        m_left = m_numbers.size();
        m_found = false;
    }
    /// The number to query; empty at the end of the round. The last number comes first: if the answer to its
    /// Set Address is only late, it is noticed here.
    [[nodiscard]] std::optional<BusAddress> next() const {
        return m_left > 0 ? std::optional(m_numbers[m_left - 1]) : std::nullopt;
    }
    /// The answer to that query. Returns true if there is a module at that number.
    bool onReply(const ReplyEnd& end) {
        --m_left;
        const bool there = !unanswered(end.result);
        if (there)
            m_numbers.erase(m_numbers.begin() + static_cast<std::ptrdiff_t>(m_left));
        m_found = m_found || there;
        m_doubtful = m_doubtful || (!there && !end.bytes.empty());
        return there;
    }
    /// An answer was too late: silence shows nothing, neither before nor in this round.
    void onLateBytes() { m_doubtful = true; }

    /// A module has been found in this round: the silence of numbers after it does not mean the end, either.
    [[nodiscard]] bool found() const { return m_found; }
    /// An answer was late or wrong since the last round that has shown nothing, or since the beginning.
    [[nodiscard]] bool doubtful() const { return m_doubtful; }
    /// This round has shown nothing.
    void noteInVain() {
        m_doubtful = false;
        ++m_inVain;
    }
    /// Too many rounds have shown nothing.
    [[nodiscard]] bool exhausted() const { return m_inVain >= kMostRounds; }

private:
    std::vector<BusAddress> m_numbers;  ///< ascending
    std::size_t m_left = 0;             ///< numbers that are still to be queried in this round
    bool m_found = false;
    bool m_doubtful = false;
    unsigned m_inVain = 0;
};

}  // namespace nmc::bus

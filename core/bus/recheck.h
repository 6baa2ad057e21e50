// SPDX-License-Identifier: MIT
#pragma once

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
    [[nodiscard]] bool contains(BusAddress number) const;

    /// Begins a round of queries: one for each number.
    void begin();
    /// The number to query; empty at the end of the round.
    [[nodiscard]] std::optional<BusAddress> next() const;
    /// The answer to that query. Returns true if there is a module at that number.
    bool onReply(const ReplyEnd& end);
    /// An answer was too late: silence shows nothing, neither before nor in this round.
    void onLateBytes() { m_doubtful = true; }

    /// A module has been found in this round: the silence of numbers after it does not mean the end, either.
    [[nodiscard]] bool found() const { return m_found; }
    /// An answer was late or wrong since the last round that has shown nothing, or since the beginning.
    [[nodiscard]] bool doubtful() const { return m_doubtful; }
    /// This round has shown nothing.
    void noteInVain();
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

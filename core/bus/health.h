// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstddef>

#include "bus/types.h"

namespace nmc::bus {

/// How far a link can be trusted: a leaky bucket (link.md 2.5). A wrong exchange fills it ten times as much
/// as a right one empties it, so it begins to fill at a tenth of wrong exchanges. Lost is final. Pure.
class Health {
public:
    static constexpr int kPerWrong = 10;
    static constexpr int kMarginal = 30;
    static constexpr int kLost = 100;
    /// Number of recent exchanges considered.
    static constexpr std::size_t kWindow = 200;

    void good() { add(false, -1); }
    void wrong() { add(true, kPerWrong); }

    [[nodiscard]] LinkHealth level() const { return m_level; }
    /// How many of the last exchanges() went wrong.
    [[nodiscard]] unsigned wrongLately() const { return static_cast<unsigned>(m_window.count()); }
    [[nodiscard]] unsigned exchanges() const { return static_cast<unsigned>(m_seen); }

private:
    void add(bool wrong, int change);

    int m_bucket = 0;
    LinkHealth m_level = LinkHealth::Good;
    std::bitset<kWindow> m_window;
    std::size_t m_next = 0;
    std::size_t m_seen = 0;
};

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstddef>

#include "bus/types.h"

namespace nmc::bus {

/// How far a link is to be trusted: a leaky bucket (link.md 2.5). What goes wrong fills it ten times as fast
/// as what goes well empties it, so a tenth of wrong exchanges is where it begins to fill. Lost is for good.
/// Pure.
class Health {
public:
    static constexpr int kPerWrong = 10;
    static constexpr int kDoubtful = 30;
    static constexpr int kLost = 100;
    /// Exchanges that are looked back on.
    static constexpr std::size_t kWindow = 200;

    void good() { add(false, -1); }
    void wrong() { add(true, kPerWrong); }

    [[nodiscard]] LinkHealth level() const { return m_level; }
    /// Of the last exchanges(): how many went wrong.
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

// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "base/strong.h"

namespace nmc::bus {

/// Distinguishes a module that does not answer from a dead line: silence, without a single byte, from all
/// modules in a row. Pure.
class Silence {
public:
    /// This many consecutive silent modules make it likely; the others are then queried at once.
    static constexpr int kLikely = 3;
    /// Number of consecutive queries without a byte.
    static constexpr unsigned kQuestions = 4;

    /// A byte was received.
    void heard() { m_inRow = 0, m_asked = 0; }
    void onSilence(ModuleIndex module) {
        ++m_inRow;
        m_asked |= std::uint32_t{1} << module.value() % 32U;
    }
    [[nodiscard]] bool asked(ModuleIndex module) const { return (m_asked >> module.value() % 32U & 1U) != 0; }
    [[nodiscard]] bool likelyDead() const { return std::popcount(m_asked) >= kLikely; }
    /// `answering`: the number of modules not known to be silent.
    [[nodiscard]] bool dead(std::size_t answering) const {
        return answering > 1 && m_inRow >= kQuestions &&
               std::popcount(m_asked) >= static_cast<int>(answering);
    }

private:
    unsigned m_inRow = 0;
    std::uint32_t m_asked = 0;
};

}  // namespace nmc::bus

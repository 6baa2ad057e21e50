// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "base/strong.h"

namespace nmc::bus {

/// Tells a module that does not answer from a line that is dead: nothing but silence, not one byte, from all
/// modules in a row. Pure.
class Silence {
public:
    /// So many silent modules in a row make it likely, and the others are asked at once.
    static constexpr int kLikely = 3;
    /// So many questions in a row without a byte.
    static constexpr unsigned kQuestions = 4;

    /// A byte came in.
    void heard() { m_inRow = 0, m_asked = 0; }
    void onSilence(ModuleIndex module) {
        ++m_inRow;
        m_asked |= std::uint32_t{1} << module.value() % 32U;
    }
    [[nodiscard]] bool asked(ModuleIndex module) const { return (m_asked >> module.value() % 32U & 1U) != 0; }
    [[nodiscard]] bool likelyDead() const { return std::popcount(m_asked) >= kLikely; }
    /// `answering`: how many modules are not known to be silent.
    [[nodiscard]] bool dead(std::size_t answering) const {
        return answering > 1 && m_inRow >= kQuestions &&
               std::popcount(m_asked) >= static_cast<int>(answering);
    }

private:
    unsigned m_inRow = 0;
    std::uint32_t m_asked = 0;
};

}  // namespace nmc::bus

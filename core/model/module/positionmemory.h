// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/module/linkstate.h"

namespace nmc {

/// The last known position of an axis, counted from its home. It outlives the session, because a module that
/// restarts begins counting at 0 (DS-V 5.2, DS-S 5.1 Hard Reset).
struct RememberedPosition {
    ModuleIdentity identity;
    std::int32_t fromHome = 0;                           ///< counts (steps), at rest
    std::int32_t counter = 0;                            ///< value of the chip's counter
    HomeFact::Source source = HomeFact::Source::Search;  ///< how that home was determined
    std::int64_t seen = 0;                               ///< s since 1970, UTC
    bool moving = false;  ///< it was moving, so where it came to rest is unknown
    bool operator==(const RememberedPosition&) const = default;
};

using RememberedPositions = std::map<ModuleIndex, RememberedPosition>;

/// Tracks the axes of a port and computes where the home of each would be if what was remembered still holds.
/// It does not apply that; HomeFact keeps it as an offer. There is no offer for an axis that was moving when
/// last seen, or whose counter was set unseen. Pure.
class PositionMemory {
public:
    struct Offer {
        ModuleIndex module;
        std::int32_t home = 0;  ///< in terms of the chip's present counter
        RememberedPosition remembered;
        bool operator==(const Offer&) const = default;
    };

    void begin(RememberedPositions remembered) { m_remembered = std::move(remembered); }
    /// A chain was found; `attached` as in bus::ChainFound: counters continue where they were.
    void found(const std::vector<bus::ModuleInfo>& modules, bool attached);
    /// The module answers at its address again and counts from 0.
    void restarted(ModuleIndex module) { m_new[module] = Counter::Began; }
    /// Call after every change of the link. The caller must store each returned offer in the home of its
    /// module before the next call. `now`: s since 1970, UTC.
    [[nodiscard]] std::vector<Offer> look(const LinkState& link, std::int64_t now);

    /// The positions to store.
    [[nodiscard]] const RememberedPositions& remembered() const { return m_remembered; }

private:
    enum class Counter : std::uint8_t { Began, GoesOn };

    [[nodiscard]] std::optional<std::int32_t> homeOf(const ModuleState& module, Counter counter) const;
    void follow(const ModuleState& module, std::int64_t now);

    RememberedPositions m_remembered;
    std::map<ModuleIndex, Counter> m_new;            ///< found, but not yet seen with a position
    std::map<ModuleIndex, std::int64_t> m_settling;  ///< since when at rest, until it has settled
};

}  // namespace nmc

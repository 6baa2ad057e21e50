// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/module/linkstate.h"

namespace nmc {

/// Where an axis was seen last, counted from its home. Kept beyond the session: a module that restarts has
/// forgotten it, because its counter begins at 0 then (DS-V 5.2, DS-S 5.1 Hard Reset).
struct RememberedPosition {
    ModuleIdentity identity;
    std::int32_t fromHome = 0;                           ///< counts (steps), at rest
    std::int32_t counter = 0;                            ///< as the chip counted
    HomeFact::Source source = HomeFact::Source::Search;  ///< of that home
    std::int64_t seen = 0;                               ///< s since 1970, UTC
    bool moving = false;                                 ///< then: where it came to rest is not known
    bool operator==(const RememberedPosition&) const = default;
};

using RememberedPositions = std::map<ModuleIndex, RememberedPosition>;

/// Follows the axes of a port, and says where home of each would be if what was remembered is still true. It
/// does not apply that: HomeFact holds it as an offer. Nothing is said of an axis that moved when it was seen
/// last, nor of one whose counter was set unseen. Pure.
class PositionMemory {
public:
    struct Offer {
        ModuleIndex module;
        std::int32_t home = 0;  ///< counts, as the chip counts now
        RememberedPosition remembered;
        bool operator==(const Offer&) const = default;
    };

    void begin(RememberedPositions remembered) { m_remembered = std::move(remembered); }
    /// A chain was found; `attached` as in bus::ChainFound: counters go on where they were.
    void found(const std::vector<bus::ModuleInfo>& modules, bool attached);
    /// This one answers at its address again, and counts from 0.
    void restarted(ModuleIndex module) { m_new[module] = Counter::Began; }
    /// Of everything that is told of the link. What is offered now is to be put into the home of its module
    /// before the next look; `now`: s since 1970, UTC.
    [[nodiscard]] std::vector<Offer> look(const LinkState& link, std::int64_t now);

    /// To be kept.
    [[nodiscard]] const RememberedPositions& remembered() const { return m_remembered; }

private:
    enum class Counter : std::uint8_t { Began, GoesOn };

    [[nodiscard]] std::optional<std::int32_t> homeOf(const ModuleState& module, Counter counter) const;
    void follow(const ModuleState& module, std::int64_t now);

    RememberedPositions m_remembered;
    std::map<ModuleIndex, Counter> m_new;  ///< since it was found nothing has been said of it
};

/// What is remembered of the chain at one port.
struct RememberedChain {
    std::string machine;  ///< its name; empty: it had none
    RememberedPositions positions;
    bool operator==(const RememberedChain&) const = default;
};

/// As text, for a file; what is no such text is nothing.
[[nodiscard]] std::string writeRemembered(const RememberedChain& chain);
[[nodiscard]] RememberedChain readRemembered(std::string_view text);

}  // namespace nmc

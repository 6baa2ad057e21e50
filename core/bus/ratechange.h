// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "bus/exchange.h"
#include "bus/line.h"

namespace nmc::bus {

/// Takes a chain to another rate: Set Baud to every group in use, the host follows, and each module has to
/// answer a No Operation there (protocol.md 1). When nobody does, the command was lost: once more from the
/// old rate. When some do not, all go back, where that is wanted. Says what to do next and is told what came
/// of it; changes the rate only, never an address, a position or a gain. Pure.
class RateChange {
public:
    /// A module, and what it answers to a No Operation.
    struct Target {
        BusAddress address;
        ReplyLayout reply;
    };
    enum class WayBack : std::uint8_t { None, Wanted };

    /// `groups`: everybody is in one of them, and none has a leader, which would answer at the new rate
    /// (faults.md F-26). The chips can make both rates (findBrd).
    RateChange(std::vector<Target> chain, std::vector<BusAddress> groups, std::uint32_t from,
               std::uint32_t to, WayBack wayBack);

    struct Ask {
        Request request;
        std::uint8_t silentRepeats = 2;
    };
    /// It is over. Indices of `chain`.
    struct Ended {
        bool reached = false;
        bool interrupted = false;
        std::vector<std::size_t> deaf;  ///< did not answer at the new rate
        std::vector<std::size_t> lost;  ///< nor at the old one, after all were told to go back
    };
    using Next = std::variant<Line::Script, Ask, Ended>;
    [[nodiscard]] Next next();
    /// The end of the last Ask, after its repeats.
    void onReply(const ReplyEnd& end);

    [[nodiscard]] std::uint32_t from() const { return m_from; }
    [[nodiscard]] std::uint32_t to() const { return m_to; }
    /// Takes back to the old rate whoever is at the new one; the port may be at either, and ends at the old.
    [[nodiscard]] Line::Script goBack() const;
    /// Somebody else has gone back meanwhile: all that is left is to see whether everybody is there.
    void interrupt();

private:
    enum class Phase : std::uint8_t {
        Change,
        Verify,
        LookBack,  ///< nobody heard the change: is the chain there at the old rate?
        Recheck,
        Return,  ///< some did not hear it
        Settle,  ///< are all of them there again?
        Ended
    };
    [[nodiscard]] Line::Script sendToAll(std::uint32_t rate) const;
    [[nodiscard]] Ask ask() const;
    void onAll();
    void enter(Phase phase);

    std::vector<Target> m_chain;
    std::vector<BusAddress> m_groups;
    std::uint32_t m_from;
    std::uint32_t m_to;
    WayBack m_wayBack;
    Phase m_phase = Phase::Change;
    std::size_t m_at = 0;                ///< module that is being asked
    std::vector<std::size_t> m_unheard;  ///< in this phase
    bool m_lookedBack = false;           ///< nobody heard it: Change is tried once more, not twice
    unsigned m_returns = 0;
    Ended m_ended;
};

}  // namespace nmc::bus

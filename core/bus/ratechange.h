// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include "bus/task.h"

namespace nmc::bus {

/// Switches a chain to another rate: sends Set Baud to every group in use, the host follows, and each module
/// must answer a No Operation at the new rate (protocol.md 1). If none does, the command was lost, or read
/// too late, and it is tried once more from the old rate, with patience. If some do not, all are switched
/// back, if wanted. Returns the next action and is informed of its outcome; changes only the rate, never an
/// address, a position or a gain. Pure.
class RateChange {
public:
    /// A module, and its reply to a No Operation.
    struct Target {
        BusAddress address;
        ReplyLayout reply;
    };
    enum class WayBack : std::uint8_t { None, Wanted };

    /// `groups`: every module is in one of them, and none has a leader, which would answer at the new rate
    /// (faults.md F-26). Both rates must be supported by the chips (findBrd).
    RateChange(std::vector<Target> chain, std::vector<BusAddress> groups, std::uint32_t from,
               std::uint32_t to, WayBack wayBack);

    /// The change has ended. Indices are those of `chain`.
    struct Ended {
        bool reached = false;
        bool interrupted = false;
        std::vector<std::size_t> deaf;  ///< did not answer at the new rate
        std::vector<std::size_t> lost;  ///< did not answer at the old rate either, after all were sent back
    };
    using Next = std::variant<Line::Script, Ask, Ended>;
    [[nodiscard]] Next next();
    /// The end of the last Ask, after its retries.
    void onReply(const ReplyEnd& end);

    [[nodiscard]] std::uint32_t from() const { return m_from; }
    [[nodiscard]] std::uint32_t to() const { return m_to; }
    /// Switches modules at the new rate back to the old one; the port may be at either rate, and ends at the
    /// old one.
    [[nodiscard]] Line::Script goBack() const;
    /// The modules were switched back elsewhere: what remains is to verify that all of them answer.
    void interrupt();

private:
    enum class Phase : std::uint8_t {
        Change,
        Verify,
        LookBack,  ///< no module answered at the new rate: is the chain at the old one?
        Recheck,
        Return,  ///< some modules did not follow
        Settle,  ///< do all of them answer again?
        Ended
    };
    [[nodiscard]] Line::Script sendToAll(std::uint32_t rate) const;
    [[nodiscard]] Ask ask() const;
    [[nodiscard]] Duration patience() const;
    void onAll();
    void enter(Phase phase);

    std::vector<Target> m_chain;
    std::vector<BusAddress> m_groups;
    std::uint32_t m_from;
    std::uint32_t m_to;
    WayBack m_wayBack;
    Phase m_phase = Phase::Change;
    std::size_t m_at = 0;                ///< the module being queried
    std::vector<std::size_t> m_unheard;  ///< in this phase
    bool m_lookedBack = false;           ///< no module followed: it is tried once more, but not twice
    unsigned m_returns = 0;
    Ended m_ended;
};

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "base/time.h"
#include "protocol/commandcode.h"
#include "sim/fault.h"
#include "sim/frameedit.h"
#include "sim/random.h"

namespace nmc::sim {

/// The injected faults, and the decision whether one strikes now. This class knows the line and its frames;
/// the chain does what it decides. Each fault has its own random sequence, so that the same faults strike the
/// same frames regardless of what else is injected.
class FaultInjector {
public:
    /// More faults than this are taken for a mistake.
    static constexpr std::size_t kMaxFaults = 100;

    /// Actions on the chain that fall due at a certain time.
    struct PowerCycle {
        std::uint8_t module;
    };
    struct GiveAddress {
        std::uint8_t from, to;
    };
    struct DefineItems {
        std::uint8_t module, mask;
    };
    struct NoiseByte {
        FaultSides sides;
        std::uint8_t value;
    };
    struct ForeignPacket {
        std::uint8_t module;  ///< the module whose address is used
        CommandCode code;
        std::uint8_t items;
    };
    struct BreakBegins {
        FaultSides sides;
    };
    struct HoldsChange {};  ///< the chain must query isOn() again for Stall and Reverse
    using Act = std::variant<PowerCycle, GiveAddress, DefineItems, NoiseByte, ForeignPacket, BreakBegins,
                             HoldsChange>;

    FaultInjector(std::uint64_t seed, std::size_t modules) : m_seed(seed), m_modules(modules) {}

    /// False while there are no faults to consult.
    [[nodiscard]] bool any() const { return !m_faults.empty(); }
    [[nodiscard]] std::size_t size() const { return m_faults.size(); }
    /// Returns the fault's number.
    unsigned add(const FaultSpec& spec, TimePoint now);
    void clear() { m_faults.clear(); }
    [[nodiscard]] std::vector<FaultReport> reports(TimePoint now) const;

    // Frames.
    /// Damage to a packet for all modules, or for `module` alone when it is set.
    std::optional<FrameEdit> strikePacket(std::optional<std::uint8_t> module, CommandCode code,
                                          const FrameInSight& packet, TimePoint now);
    /// True when the module refuses a good packet (Cksum), or misses it (Ignore).
    bool strikesCommand(FaultKind kind, std::uint8_t module, CommandCode code, TimePoint now);

    struct ReplyFate {
        bool sent = true;
        Duration begunLater{};  ///< delay by the module
        Duration heldUp{};      ///< delay on the line
    };
    /// Decides the fate of a reply; `bytes` may be changed.
    ReplyFate strikeReply(std::uint8_t module, CommandCode code, std::vector<std::uint8_t>& bytes,
                          TimePoint now);

    // The line and the module.
    /// True while a lasting fault is active: a mute, an echo, a stall, a reversal.
    [[nodiscard]] bool isOn(FaultKind kind, std::uint8_t module, TimePoint now) const;
    [[nodiscard]] bool breaks(bool FaultSides::*side, TimePoint now) const;
    /// True while a mute or an echo is active for a byte, which is counted as struck: a byte of `module`, or
    /// without a module a byte of the host.
    bool strikesByte(FaultKind kind, std::optional<std::uint8_t> module, TimePoint now);

    // Time.
    [[nodiscard]] TimePoint nextEvent() const;
    [[nodiscard]] std::vector<Act> takeDue(TimePoint now);

private:
    struct Fault {
        FaultSpec spec;
        unsigned number;
        Random random;
        TimePoint begins;
        TimePoint ends;
        TimePoint next;  ///< time of its next action
        std::uint64_t struck = 0;
        std::vector<std::vector<std::uint8_t>> stuckReplies;

        [[nodiscard]] bool isActive(TimePoint now) const;
        [[nodiscard]] bool hits(std::uint8_t module) const;
        [[nodiscard]] bool concerns(CommandCode code) const;
        /// Draws the fault's random number; the caller counts the strike.
        [[nodiscard]] bool strikes(TimePoint now);
        [[nodiscard]] Duration between();
    };

    void act(Fault& fault, std::vector<Act>& acts);

    std::uint64_t m_seed;
    std::size_t m_modules;
    unsigned m_lastNumber = 0;
    std::vector<Fault> m_faults;
};

}  // namespace nmc::sim

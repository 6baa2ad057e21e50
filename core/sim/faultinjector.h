// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "base/time.h"
#include "protocol/commandcode.h"
#include "sim/fault.h"
#include "sim/frameedit.h"
#include "sim/random.h"

namespace nmc::sim {

/// The injected faults, and the decision whether one strikes here and now. It knows the line and its frames;
/// the chain does what it decides. Each fault has a random sequence of its own, so that the same faults
/// strike the same frames whatever else is injected.
class FaultInjector {
public:
    /// A chain with more is a mistake.
    static constexpr std::size_t kMaxFaults = 100;

    /// What is to be done to the chain when a time has come.
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
        std::uint8_t module;  ///< whose address
        CommandCode code;
        std::uint8_t items;
    };
    struct BreakBegins {
        FaultSides sides;
    };
    struct HoldsChange {};  ///< ask isOn() again for Stall and Reverse
    using Act = std::variant<PowerCycle, GiveAddress, DefineItems, NoiseByte, ForeignPacket, BreakBegins,
                             HoldsChange>;

    FaultInjector(std::uint64_t seed, std::size_t modules) : m_seed(seed), m_modules(modules) {}

    /// False while there is nothing to ask.
    [[nodiscard]] bool any() const { return !m_faults.empty(); }
    [[nodiscard]] std::size_t size() const { return m_faults.size(); }
    /// Its number.
    unsigned add(const FaultSpec& spec, TimePoint now);
    void clear() { m_faults.clear(); }
    [[nodiscard]] std::vector<FaultReport> reports(TimePoint now) const;

    // Frames.
    /// Damage to a packet for all modules, or for `module` if it is meant for it.
    std::optional<FrameEdit> strikePacket(std::optional<std::uint8_t> module, CommandCode code,
                                          const FrameInSight& packet, TimePoint now);
    /// Whether a module refuses or misses a good packet.
    bool refuses(std::uint8_t module, CommandCode code, TimePoint now);
    bool ignores(std::uint8_t module, CommandCode code, TimePoint now);

    struct ReplyFate {
        bool sent = true;
        Duration begunLater{};  ///< by the module
        Duration heldUp{};      ///< on the line
    };
    /// What becomes of a reply; `bytes` may be changed.
    ReplyFate strikeReply(std::uint8_t module, CommandCode code, std::vector<std::uint8_t>& bytes,
                          TimePoint now);

    // The line and the module.
    /// Whether a fault that lasts is on: a mute, an echo, a stall, a reversal.
    [[nodiscard]] bool isOn(FaultKind kind, std::uint8_t module, TimePoint now) const;
    [[nodiscard]] bool breaks(bool FaultSides::*side, TimePoint now) const;
    /// The same of a mute or an echo of a byte, which counts: one of `module`, or without one a byte of the
    /// host.
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
        TimePoint next;  ///< its next act
        std::uint64_t struck = 0;
        std::vector<std::vector<std::uint8_t>> stuckReplies;

        [[nodiscard]] bool isActive(TimePoint now) const;
        [[nodiscard]] bool hits(std::uint8_t module) const;
        [[nodiscard]] bool concerns(CommandCode code) const;
        /// Throws the dice; the caller counts the strike.
        [[nodiscard]] bool strikes(TimePoint now);
        [[nodiscard]] Duration between();
    };

    bool strikesCommand(FaultKind kind, std::uint8_t module, CommandCode code, TimePoint now);
    void act(Fault& fault, std::vector<Act>& acts);

    std::uint64_t m_seed;
    std::size_t m_modules;
    unsigned m_lastNumber = 0;
    std::vector<Fault> m_faults;
};

}  // namespace nmc::sim

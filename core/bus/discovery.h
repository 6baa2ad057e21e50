// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "bus/addressing.h"
#include "bus/chainlook.h"
#include "bus/engineconfig.h"
#include "bus/exchange.h"
#include "bus/line.h"
#include "bus/ratechange.h"
#include "bus/task.h"
#include "bus/types.h"

namespace nmc::bus {

/// Finds the chain: either an existing one, which is left as it is (chainlook.h), or a fresh one, to which it
/// assigns addresses (addressing.h), after a Hard Reset if requested. On a read-only connection it does only
/// the former, starting with a search, and uses Read Status instead of Define Status. It ends with three
/// replies with different items from each module, which two modules at one address cannot all give correctly.
/// Returns the next action and is informed of its outcome; retries of a query, and the resync
/// before them, are left to the engine. Pure.
class Discovery {
public:
    enum class Start : std::uint8_t { Look, Restart };
    Discovery(const EngineConfig& config, Start start);

    using Next = std::variant<Line::Script, Ask, ChainFound, ConnectFailed>;

    [[nodiscard]] Next next();
    /// The end of the last Ask, after its retries.
    void onReply(const ReplyEnd& end);
    /// Bytes have arrived that answer no query: an answer was too late, so a silence may have been none.
    void onLateBytes() { m_phase == Phase::Look ? m_look.onLateBytes() : m_addressing.onLateBytes(); }
    /// The next query may be answered later than usual.
    [[nodiscard]] bool expectsLateAnswers() const {
        return m_look.patient() || m_silentInRow > 0 ||
               (m_phase == Phase::Addressing && m_addressing.expectsLateAnswers());
    }
    /// Continues, also after a failure, with what follows addressing. Requires addressed().
    void queryModules();

    /// Returns a value once for each step forward.
    [[nodiscard]] std::optional<ConnectProgress> takeProgress() {
        return std::exchange(m_progress, std::nullopt);
    }
    /// Whatever was in progress on the line was discarded, and the port may be at another rate. Returns true
    /// if discovery continues where it was: in the middle of assigning addresses, a new search would take the
    /// modules that have one for the whole chain.
    [[nodiscard]] bool resume();
    /// True once the first address has been assigned.
    [[nodiscard]] bool givesAddresses() const { return m_addressing.begun(); }
    /// True once the last one has.
    [[nodiscard]] bool addressed() const { return m_addressing.done(); }
    /// The identity of a module without an address that answers in addition to the chain.
    [[nodiscard]] std::optional<ModuleIdentity> unaddressedIdentity() const {
        return m_look.unaddressedIdentity();
    }
    [[nodiscard]] std::size_t seen() const {
        return std::max({m_modules.size(), m_look.addresses().size(), m_addressing.addresses().size()});
    }
    /// The modules of the chain, also after a failure, as far as they are known.
    [[nodiscard]] const std::vector<ModuleInfo>& modules() const { return m_modules; }
    struct Heard {
        ModuleIndex module;
        ReplyEnd end;
    };
    /// The last two replies of each module with a data sheet, in order; their layouts differ.
    [[nodiscard]] const std::vector<Heard>& heard() const { return m_heard; }

private:
    enum class Phase : std::uint8_t {
        Look,
        Restart,
        Addressing,
        Identify,
        ChangeRate,
        Define,
        Confirm,
        Done,
        Failed
    };

    [[nodiscard]] Next look();
    [[nodiscard]] Next lookedUp();
    [[nodiscard]] Line::Script restartScript() const;
    [[nodiscard]] Next changeRate();
    [[nodiscard]] Next addressing();
    [[nodiscard]] Ask defineItems(StatusItems items) const;
    [[nodiscard]] Ask askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const;
    void onIdentity(const ReplyEnd& end);
    void onLook(const ReplyEnd& end);
    void onAddressing(const ReplyEnd& end);
    void takeModules(const std::vector<BusAddress>& addresses, std::optional<GroupPlace> group);
    void nextModule(Phase after);
    void enterModules(Phase phase);
    void skipUnknown();
    void failAnswer(const ReplyEnd& end);
    void fail(ConnectFailure reason, std::vector<ModuleIndex> modules = {});
    void enter(Phase phase, std::optional<ConnectStage> stage = {});

    [[nodiscard]] std::uint32_t rate() const { return m_attached ? *m_look.rate() : m_config.baud; }

    EngineConfig m_config;
    ChainLook m_look;
    Addressing m_addressing;
    Phase m_phase;
    bool m_attached = false;  ///< once true, no address, rate or reset is sent
    std::vector<ModuleInfo> m_modules;
    std::vector<Heard> m_heard;
    std::size_t m_at = 0;        ///< the module being queried
    unsigned m_silentInRow = 0;  ///< queries to that module, unanswered since its address was assigned
    bool m_resumed = false;      ///< the port must first be set to the power-up rate
    std::optional<RateChange> m_rateChange;
    ConnectFailed m_failure{};
    std::optional<ConnectProgress> m_progress;
};

}  // namespace nmc::bus

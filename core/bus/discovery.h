// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/chainlook.h"
#include "bus/engineconfig.h"
#include "bus/exchange.h"
#include "bus/line.h"
#include "bus/ratechange.h"
#include "bus/task.h"
#include "bus/types.h"

namespace nmc::bus {

/// Finds the chain: the one that is there, left as it is (chainlook.h); or a fresh one, which it gives
/// addresses (DS-V 4.1, protocol.md 1), after a Hard Reset where that is wanted. Of a read-only connection
/// only the former, to be begun with a look, and with Read Status in the place of Define Status. Ends with
/// three replies of different items from each module, which two modules at one address do not survive. Says
/// what to do next and is told what came of it; repeats within one question, and the resync before them, are
/// the engine's. Pure.
class Discovery {
public:
    static constexpr std::uint8_t kMaxModules = 32;

    enum class Start : std::uint8_t { Look, Restart };
    Discovery(const EngineConfig& config, Start start);

    using Next = std::variant<Line::Script, Ask, ChainFound, ConnectFailed>;

    [[nodiscard]] Next next();
    /// The end of the last Ask, after its repeats.
    void onReply(const ReplyEnd& end);

    /// Once for each step forward.
    [[nodiscard]] std::optional<ConnectProgress> takeProgress();
    /// What was under way on the line is gone, and the port may be at another rate. True when it goes on
    /// where it was: in the midst of giving addresses a look would take those that have one for the whole
    /// chain.
    [[nodiscard]] bool resume();
    /// The first address has been given.
    [[nodiscard]] bool givesAddresses() const { return m_number > 0; }
    /// What a module without an address says it is, where one answers beside the chain.
    [[nodiscard]] std::optional<ModuleIdentity> unaddressedIdentity() const {
        return m_look.unaddressedIdentity();
    }
    [[nodiscard]] std::size_t seen() const { return std::max(m_modules.size(), m_look.addresses().size()); }
    /// Those that were seen so far.
    [[nodiscard]] const std::vector<ModuleInfo>& modules() const { return m_modules; }
    struct Heard {
        ModuleIndex module;
        ReplyEnd end;
    };
    /// The last two replies of each module with a data sheet, whose layouts differ, in their order.
    [[nodiscard]] const std::vector<Heard>& heard() const { return m_heard; }

private:
    enum class Phase : std::uint8_t {
        Look,
        Restart,
        Set,
        Probe,
        Alive,    ///< nobody took a number: is that the end of the chain, or is the line disturbed?
        Recheck,  ///< numbers that were sent and that nobody has answered at
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
    [[nodiscard]] Ask setAddress();
    [[nodiscard]] Ask probe(BusAddress address, std::uint8_t repeats) const;
    [[nodiscard]] Ask stillThere() const;
    [[nodiscard]] Ask defineItems(StatusItems items) const;
    [[nodiscard]] Ask askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const;
    void onIdentity(const ReplyEnd& end);
    void onLook(const ReplyEnd& end);
    void onAddress(const ReplyEnd& end);
    void onProbe(const ReplyEnd& end);
    void onAlive(const ReplyEnd& end);
    void onNumberUnheard();
    void onRecheck(const ReplyEnd& end);
    void found(BusAddress address);
    void endOfAddressing();
    void endOfChain();
    void nextModule(Phase after);
    void enterModules(Phase phase);
    void skipUnknown();
    void failAnswer(const ReplyEnd& end);
    void fail(ConnectFailure reason, std::vector<ModuleIndex> modules = {});
    void enter(Phase phase, std::optional<ConnectStage> stage = {});

    [[nodiscard]] std::uint32_t rate() const { return m_attached ? *m_look.rate() : m_config.baud; }

    EngineConfig m_config;
    ChainLook m_look;
    Phase m_phase;
    bool m_attached = false;  ///< once true, no address, rate or reset goes out
    std::vector<ModuleInfo> m_modules;
    std::vector<Heard> m_heard;
    std::size_t m_at = 0;         ///< module that is being asked
    std::uint8_t m_number = 0;    ///< the address that was sent last; none is ever sent twice
    unsigned m_unheardInRow = 0;  ///< numbers that nobody seems to have heard
    unsigned m_aliveInVain = 0;   ///< questions in a row that a module which has answered did not
    std::vector<BusAddress> m_unheard;
    std::vector<BusAddress> m_stillUnheard;  ///< of these, in this recheck
    bool m_recheckFound = false;             ///< one of them has answered in it
    bool m_heardNoise = false;               ///< while giving addresses: then nobody found is Garbled
    bool m_resumed = false;                  ///< the port has to be taken to the rate of power-up first
    std::optional<RateChange> m_rateChange;
    ConnectFailed m_failure{};
    std::optional<ConnectProgress> m_progress;
};

}  // namespace nmc::bus

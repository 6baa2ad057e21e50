// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/restartsearch.h"
#include "bus/task.h"

namespace nmc::bus {

/// Gives a module that restarted its address back, and takes it to the rate of the chain; or resets one
/// first, alone (DS-V 5.2, DS-S 5.1 Hard Reset). The others keep what they have. The module itself has lost
/// everything but its type. Or gives a module that answers another address, and it keeps all it has: whether
/// somebody is there already is asked first, and where it is by then when its answer got lost (link.md 2.3).
/// Ends in Readdressed, AddressChanged or ReaddressFailed.
class ReaddressTask : public Task {
public:
    ReaddressTask(const EngineConfig& config, Chain& chain, RestartSearch& restarts, const Line& line,
                  std::vector<Event>& events)
        : m_config(config), m_chain(chain), m_restarts(restarts), m_line(line), m_events(events) {}

    /// Of one that has restarted by itself. `busy`: something else is going on. Refused with an event when it
    /// cannot be done: only while nothing moves, since the chain is left alone for as long as it takes.
    void begin(ModuleIndex module, bool busy);
    /// Of one that answers, and is told this Hard Reset first; likewise.
    void beginReset(ModuleIndex module, const Payload& reset, bool busy);
    /// Another address, likewise.
    void beginMove(ModuleIndex module, BusAddress address, bool busy);
    [[nodiscard]] bool active() const { return m_module.has_value(); }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return active(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    enum class Stage : std::uint8_t {
        Reset,
        Forget,
        Address,
        Probe,
        Rate,
        Identify,
        // of another address
        Free,
        Move,
        There,
        Still,
        Over
    };
    [[nodiscard]] bool anythingMoves() const;
    void begin(ModuleIndex module, Stage stage, bool fits, bool busy);
    void fail(ReaddressFailed::Reason reason);
    [[nodiscard]] Ask question(BusAddress address, const Payload& payload, StatusItems items) const;
    void end(bool done);
    void moved();

    const EngineConfig& m_config;
    Chain& m_chain;
    RestartSearch& m_restarts;
    const Line& m_line;
    std::vector<Event>& m_events;
    std::optional<ModuleIndex> m_module;
    Payload m_reset;                 ///< of Stage::Reset
    std::optional<BusAddress> m_to;  ///< another address
    unsigned m_moves = 0;            ///< so often it was told
    unsigned m_looks = 0;            ///< at the module where it should be, in vain
    Stage m_stage = Stage::Over;
    bool m_done = false;  ///< what the stages so far have shown; Over tells it
};

}  // namespace nmc::bus

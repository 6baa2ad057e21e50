// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/restartsearch.h"
#include "bus/task.h"

namespace nmc::bus {

/// Gives a module that restarted its address back, and switches it to the chain's rate; or first resets one
/// module alone (DS-V 5.2, DS-S 5.1 Hard Reset). The other modules are unaffected; the module itself has lost
/// everything but its type. Another module without an address would take the address, so it is verified
/// first that there is none. Or gives a module that answers another address, while it keeps everything else:
/// it is verified first that the address is free, and where the module is if its answer was lost (link.md
/// 2.3). Ends in Readdressed, AddressChanged or ReaddressFailed.
class ReaddressTask : public Task {
public:
    ReaddressTask(const Shared& shared, const EngineConfig& config, RestartSearch& restarts)
        : Task(shared), m_config(config), m_restarts(restarts) {}

    /// For a module that has restarted by itself. `busy`: this task, or something else, is in progress.
    /// Refused with an event if not possible: only while nothing moves, because the chain is not polled in
    /// the meantime.
    void begin(ModuleIndex module, bool busy);
    /// For a module that answers, and is sent this Hard Reset first; under the same conditions as begin().
    void beginReset(ModuleIndex module, const Payload& reset, bool busy);
    /// Gives a module another address; under the same conditions as begin().
    void beginMove(ModuleIndex module, BusAddress address, bool busy);
    [[nodiscard]] bool active() const { return m_module.has_value(); }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return active(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    enum class Stage : std::uint8_t {
        Alone,
        Reset,
        Forget,
        Address,
        Probe,
        Rate,
        Identify,
        // for another address
        Free,
        Move,
        There,
        Still,
        Over
    };
    [[nodiscard]] bool anythingMoves() const;
    void begin(ModuleIndex module, const std::optional<Payload>& reset, bool fits, bool busy);
    void onAlone(const ReplyEnd& end);
    void fail(ReaddressFailed::Reason reason);
    [[nodiscard]] Ask question(BusAddress address, const Payload& payload, StatusItems items) const;
    void end(bool done);
    void moved();

    const EngineConfig& m_config;
    RestartSearch& m_restarts;
    std::optional<ModuleIndex> m_module;
    std::optional<Payload> m_reset;  ///< sent to the module first, which still has its address
    std::optional<BusAddress> m_to;  ///< the other address
    unsigned m_moves = 0;            ///< number of times it was sent
    unsigned m_looks = 0;            ///< queries in a row that have not decided
    Stage m_stage = Stage::Over;
    bool m_done = false;  ///< the result of the stages so far; reported in Over
    ReaddressFailed::Reason m_failure = ReaddressFailed::Reason::NoAnswer;  ///< if it is not done
};

}  // namespace nmc::bus

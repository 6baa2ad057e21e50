// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// Why does a module not answer any more? One that restarted has no address and the rate of power-up
/// (faults.md F-15, F-16). Nobody else has no address, so one question tells; at another rate the chain is
/// left alone for as long as that takes. Who it is follows from who is silent: so all others are asked first
/// whether they still answer.
class RestartSearch : public Task {
public:
    RestartSearch(Chain& chain, Recovery& recovery, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_recovery(recovery), m_line(line), m_events(events) {}

    /// A module has just failed its challenge.
    void onLost(ModuleIndex module);
    /// A silent module did not answer again.
    void onProbeFailed();
    /// A search has found out that this is what became of the module.
    void setRestarted(ModuleIndex module, TimePoint now);
    /// A module has restarted on a chain at another rate, to which every packet is noise: no more of them.
    /// Once.
    [[nodiscard]] bool takeQuiet() { return std::exchange(m_quiet, false); }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return m_stage != Stage::None; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override {
        if (change.kind == Change::Kind::Search || change.kind == Change::Kind::GivenUp)
            m_stage = Stage::None;
        return false;
    }
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    enum class Stage : std::uint8_t {
        None,
        Ask,     ///< at the rate of power-up: is there a module without an address?
        Back,    ///< to the rate of the chain
        Others,  ///< there is one: do the others still answer?
    };
    void onUnaddressed(const ReplyEnd& end);
    void name();
    void report(ModuleIndex module, bool quiet);

    Chain& m_chain;
    Recovery& m_recovery;
    const Line& m_line;
    std::vector<Event>& m_events;
    Stage m_stage = Stage::None;
    std::optional<ModuleIndex> m_lookedFor;
    std::optional<ModuleIdentity> m_unaddressed;
    std::vector<ModuleIndex> m_others;
    bool m_again = false;  ///< the module in front of them has been asked once
    unsigned m_asks = 0;   ///< at the rate of power-up, in vain, in a row
    unsigned m_probes = 0;
    bool m_quiet = false;  ///< until takeQuiet(); never at the rate of power-up
};

}  // namespace nmc::bus

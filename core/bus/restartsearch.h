// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// Determines why a module no longer answers. One that restarted has no address and is at the power-up rate
/// (faults.md F-15, F-16). No other module is without an address, so a query shows it; if the chain is
/// at another rate, it is not polled in the meantime. Which module it is follows from which one is silent, so
/// all others are queried first to verify that they still answer.
class RestartSearch : public Task {
public:
    RestartSearch(const Shared& shared, Recovery& recovery) : Task(shared), m_recovery(recovery) {}

    /// A module has just failed its challenge. One that was silent before it is looked for again only at the
    /// power-up rate: at another, the others would be out of reach too often.
    void onLost();
    /// A silent module did not answer again.
    void onProbeFailed();
    /// A search has found that the module has restarted.
    void setRestarted(ModuleIndex module, TimePoint now);
    /// A module has restarted on a chain at another rate; it receives every packet as noise, so no more are
    /// sent. Returned once.
    [[nodiscard]] bool takeQuiet() { return std::exchange(m_quiet, false); }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return m_stage != Stage::None; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    enum class Stage : std::uint8_t {
        None,
        Ask,     ///< at the power-up rate, twice: is there a module without an address?
        Back,    ///< switches back to the chain's rate
        Others,  ///< there is one: do the others still answer?
    };
    void begin() {
        m_stage = Stage::Ask;
        m_asks = m_answers = 0;
    }
    void onUnaddressed(const ReplyEnd& end);
    void name();
    void report(ModuleIndex module, bool quiet);

    Recovery& m_recovery;
    Stage m_stage = Stage::None;
    std::optional<ModuleIdentity> m_unaddressed;  ///< as it has answered, once or twice
    std::vector<ModuleIndex> m_others;
    bool m_again = false;    ///< the next of these modules has been queried once
    unsigned m_asks = 0;     ///< consecutive unanswered ones at the power-up rate
    unsigned m_answers = 0;  ///< right ones since begin()
    unsigned m_probes = 0;
    bool m_quiet = false;  ///< until takeQuiet(); never set at the power-up rate
};

}  // namespace nmc::bus

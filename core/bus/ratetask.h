// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/ratechange.h"
#include "bus/recovery.h"
#include "bus/stoptask.h"
#include "bus/task.h"

namespace nmc::bus {

/// Takes a chain that runs to another rate (ratechange.h). Ends in RateChanged or RateChangeFailed.
class RateTask : public Task {
public:
    /// The rate in `config` follows: the next search goes for it.
    RateTask(EngineConfig& config, Chain& chain, std::vector<Event>& events)
        : m_config(config), m_chain(chain), m_events(events) {}

    /// `busy`: something else is going on. Refused with an event when it cannot be done.
    void begin(std::uint32_t baud, bool busy);
    [[nodiscard]] bool active() const { return m_change || m_abandoned; }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return m_change.has_value(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    friend class WayBack;
    [[nodiscard]] std::optional<RateChangeFailed::Reason> obstacle(std::uint32_t baud,
                                                                   std::vector<ModuleIndex>& modules) const;
    void finish(const RateChange::Ended& ended);

    EngineConfig& m_config;
    Chain& m_chain;
    std::vector<Event>& m_events;
    std::optional<RateChange> m_change;     ///< under way
    std::optional<RateChange> m_abandoned;  ///< all go back to the old rate
};

/// A stop in the midst of a change of the rate: each module is at one of the two rates, and nobody knows at
/// which. So it is told at both, and then everybody goes back to the old one, where the stop is confirmed as
/// usual. Comes before everything, the stop included.
class WayBack : public Task {
public:
    WayBack(RateTask& rate, Chain& chain, StopTask& stop, Recovery& recovery, const Line& line)
        : m_rate(rate), m_chain(chain), m_stop(stop), m_recovery(recovery), m_line(line) {}

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return m_rate.m_abandoned.has_value(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override {
        m_underWay = m_underWay && change.kind != Change::Kind::Interrupted;
        return false;
    }

private:
    RateTask& m_rate;
    Chain& m_chain;
    StopTask& m_stop;
    Recovery& m_recovery;
    const Line& m_line;
    bool m_underWay = false;  ///< its script is on the line; so something is abandoned
};

}  // namespace nmc::bus

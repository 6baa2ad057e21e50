// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/ratechange.h"
#include "bus/recovery.h"
#include "bus/stoplane.h"
#include "bus/task.h"

namespace nmc::bus {

/// Switches a running chain to another rate (ratechange.h). Ends in RateChanged or RateChangeFailed.
class RateTask : public Task {
public:
    /// Updates the rate in `config`, which the next search uses.
    RateTask(const Shared& shared, EngineConfig& config) : Task(shared), m_config(config) {}

    /// `busy`: something else is in progress. Refused with an event if the change is not possible.
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
    std::optional<RateChange> m_change;     ///< in progress
    std::optional<RateChange> m_abandoned;  ///< all modules are switched back to the old rate
};

/// A stop in the middle of a rate change: each module is at one of the two rates, and it is unknown at which.
/// The stop is therefore sent at both, after which all modules are switched back to the old rate, where the
/// stop is confirmed as usual. Takes precedence over everything, including the stop.
class WayBack : public Task {
public:
    WayBack(const Shared& shared, RateTask& rate, StopLane& stops, Recovery& recovery)
        : Task(shared), m_rate(rate), m_stops(stops), m_recovery(recovery) {}

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return m_rate.m_abandoned.has_value(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override {
        m_underWay = m_underWay && change.kind != Change::Kind::Interrupted;
        return false;
    }

private:
    RateTask& m_rate;
    StopLane& m_stops;
    Recovery& m_recovery;
    bool m_underWay = false;  ///< its script is on the line, so a change is abandoned
};

}  // namespace nmc::bus

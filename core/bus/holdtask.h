// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/holdlane.h"
#include "bus/task.h"

namespace nmc::bus {

/// Held motion: starts and changes it while the evidence comes, and owes its module a stop as soon as it does
/// not. One with a goal starts from standstill: what moves is stopped first, and a goal that has changed ends
/// it.
class HoldTask : public Task {
public:
    HoldTask(const EngineConfig& config, Chain& chain, std::vector<Event>& events)
        : m_chain(chain), m_events(events), m_lane(config.holdTimeout) {}

    /// Nothing when that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// It cannot be had now.
    void refuse(const HoldToMove& hold) { m_lane.refuse(hold); }
    void release() { end(StopCause::HoldReleased); }
    /// Ends a hold whose evidence stopped coming. True when one did.
    bool expire(TimePoint now);
    /// When that would be.
    [[nodiscard]] std::optional<TimePoint> expiry() const { return m_lane.deadline(); }
    /// Somebody else stops the motor.
    void clear();
    [[nodiscard]] bool holds(ModuleIndex module) const {
        return m_lane.wanted() && m_lane.wanted()->module == module;
    }
    [[nodiscard]] bool active() const { return m_lane.wanted().has_value(); }
    /// While it is active().
    [[nodiscard]] ModuleIndex module() const { return m_lane.wanted()->module; }

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] bool pipelines() const override { return true; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    void end(StopCause cause);
    void giveUp();
    /// Whether a motion to `goal` goes the way that is held, and leads anywhere.
    [[nodiscard]] bool leadsTo(std::int32_t goal, const Belief& module) const;
    /// Of a hold with a goal: its load, then its start.
    [[nodiscard]] Next nextTowards(std::int32_t goal, const Order& load);
    [[nodiscard]] Next sendOrder(const Order& order);

    Chain& m_chain;
    std::vector<Event>& m_events;
    HoldLane m_lane;
    std::optional<HoldToMove>
        m_sentBefore;         ///< what it was told before, to go back to when the start is refused
    unsigned m_refusals = 0;  ///< in a row
};

}  // namespace nmc::bus

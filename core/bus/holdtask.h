// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/holdlane.h"
#include "bus/task.h"

namespace nmc::bus {

/// Held motion: starts and changes it while the evidence comes, and owes its module a stop as soon as it does
/// not. A hold with a goal starts from standstill: a moving motor is stopped first, and a change of goal ends
/// the hold. At a change of its velocity, a PIC-SERVO's becomes a run, which TravelWatch ends; where the goal
/// is too near for that, and with a PIC-STEP, it keeps the velocity that it has.
class HoldTask : public Task {
public:
    HoldTask(const Shared& shared, const EngineConfig& config) : Task(shared), m_lane(config.holdTimeout) {}

    /// Has no effect if that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// The motion is not possible now.
    void refuse(const HoldToMove& hold) { m_lane.refuse(hold); }
    void release() { end(StopCause::HoldReleased); }
    /// Ends a hold whose evidence has stopped coming.
    void expire(TimePoint now);
    /// The time at which expire() would end the hold.
    [[nodiscard]] std::optional<TimePoint> expiry() const { return m_lane.deadline(); }
    /// Something else stops the motor.
    void clear();
    [[nodiscard]] bool holds(ModuleIndex module) const {
        return m_lane.wanted() && m_lane.wanted()->module == module;
    }
    [[nodiscard]] bool active() const { return m_lane.wanted().has_value(); }
    /// Only while active().
    [[nodiscard]] ModuleIndex module() const { return m_lane.wanted()->module; }

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] bool pipelines() const override { return true; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    void end(StopCause cause);
    void giveUp();
    /// True if a motion to `goal` goes in the direction held, and is not negligible.
    [[nodiscard]] bool leadsTo(std::int32_t goal, const Belief& module) const;
    /// True if that motion may go on as a run instead of a move to its goal.
    [[nodiscard]] bool mayRunOn(const HoldToMove& wanted) const;
    /// For a hold with a goal: its load, then its start.
    [[nodiscard]] Next nextTowards(std::int32_t goal, const Order& load);
    [[nodiscard]] Next sendOrder(const Order& order);

    HoldLane m_lane;
    std::optional<HoldToMove> m_sentBefore;  ///< sent before, restored if the start is refused
    unsigned m_refusals = 0;                 ///< consecutive
};

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/task.h"

namespace nmc::bus {

/// Held motion: starts and changes it while the evidence comes, and owes its module a stop as soon as it does
/// not. A press that has ended is over: late evidence of it moves nothing. A hold with a goal starts from
/// standstill: a moving motor is stopped first, and a change of goal ends the hold. At a change of its
/// velocity, a PIC-SERVO's becomes a run, which TravelWatch ends; where the goal is too near for that, and
/// with a PIC-STEP, it keeps the velocity that it has.
class HoldTask : public Task {
public:
    HoldTask(const Shared& shared, const EngineConfig& config)
        : Task(shared), m_timeout(config.holdTimeout) {}

    /// Has no effect if that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// The motion is not possible now: this press is over before it began.
    void refuse(const HoldToMove& hold) { endPress(hold.press); }
    void release() { end(StopCause::HoldReleased); }
    /// Ends a hold whose evidence has stopped coming.
    void expire(TimePoint now);
    /// The time at which expire() would end the hold.
    [[nodiscard]] std::optional<TimePoint> expiry() const {
        return m_wanted ? std::optional(m_until) : std::nullopt;
    }
    [[nodiscard]] bool holds(ModuleIndex module) const { return m_wanted && m_wanted->module == module; }
    [[nodiscard]] bool active() const { return m_wanted.has_value(); }
    /// Only while active().
    [[nodiscard]] ModuleIndex module() const { return m_wanted->module; }

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] bool pipelines() const override { return true; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    /// True if that press has ended, or a later one.
    [[nodiscard]] bool over(std::uint32_t press) const { return m_over && press <= *m_over; }
    void endPress(std::uint32_t press);
    /// Ends the hold. Returns the motion that was sent, or only loaded; a stop is owed for it, because a load
    /// left waiting would run with the next start of its group.
    std::optional<HoldToMove> leave();
    void end(StopCause cause);
    /// The user is still holding, and must be informed that the hold is over.
    void giveUp(HoldExpired::Reason reason);
    /// True if a motion to `goal` goes in the direction held, and is not negligible.
    [[nodiscard]] bool leadsTo(std::int32_t goal, const Belief& module) const;
    /// True if that motion may go on as a run instead of a move to its goal.
    [[nodiscard]] bool mayRunOn(const HoldToMove& wanted) const;
    /// The command to be sent, if the module was not sent what is wanted: the start, or, for the first motion
    /// with a goal, its load, which startLoaded() must follow. A PIC-SERVO cannot change the velocity of a
    /// move to a goal (DS-V 4.4), so from then on it is a run.
    [[nodiscard]] std::optional<Order> toSend() const;
    [[nodiscard]] Order startLoaded() const;
    /// For a hold with a goal: its load, then its start.
    [[nodiscard]] Next nextTowards(std::int32_t goal, const Order& load);
    [[nodiscard]] Next sendOrder(const Order& order);

    Duration m_timeout;
    std::optional<HoldToMove> m_wanted;
    std::optional<HoldToMove> m_sent;        ///< sent, whatever the outcome
    std::optional<HoldToMove> m_sentBefore;  ///< sent before, restored if the start is refused
    bool m_loaded = false;                   ///< a load without a start was sent, whatever the outcome
    TimePoint m_until;
    std::optional<std::uint32_t> m_over;  ///< the last press that has ended
    unsigned m_refusals = 0;              ///< consecutive
};

}  // namespace nmc::bus

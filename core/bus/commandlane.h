// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "bus/sinerun.h"
#include "bus/types.h"

namespace nmc::bus {

/// Operations that wait, and the one that is being carried out, order by order. Pure bookkeeping: what goes
/// out and when is the engine's business.
class CommandLane {
public:
    static constexpr std::size_t kCapacity = 256;

    /// False when the lane is full; the operation was not taken.
    [[nodiscard]] bool submit(Operation operation);
    [[nodiscard]] bool submit(GroupOperation operation);
    [[nodiscard]] bool empty() const { return m_waiting.empty(); }
    [[nodiscard]] bool concerns(ModuleIndex module) const;

    /// The operation to carry out now, when it is one of groups. It has no orders before plan() gives it
    /// some.
    [[nodiscard]] const GroupOperation* group() const;
    [[nodiscard]] bool planned() const { return !m_waiting.front().orders.empty(); }
    void plan(std::vector<Order> orders) { m_waiting.front().orders = std::move(orders); }

    /// The order to carry out now, and when it became that. The lane must not be empty.
    [[nodiscard]] const Order& order() const { return m_waiting.front().orders[m_order]; }
    /// Notes that somebody looks at the order for the first time; later calls change nothing. A sine goes to
    /// where it is now.
    void beginStep(TimePoint now);
    [[nodiscard]] TimePoint stepBegan() const { return m_began; }

    /// The operation to carry out now is a sine.
    [[nodiscard]] bool swings() const { return m_sine.has_value(); }
    /// A poll of that module was answered.
    void notePoll(ModuleIndex module, const ReplyEnd& end) {
        if (m_sine && order().module == module)
            m_sine->notePoll(end);
    }
    /// The operation to carry out now is a sine, and something else is asked for.
    [[nodiscard]] bool sineOver() const { return m_sine && m_waiting.size() > 1; }
    /// It is a sine, and its chip goes on no more.
    [[nodiscard]] bool endedByChip() const { return m_sine && m_sine->endedByChip(); }
    /// When there is something to do; at once, but between two steps of a sine.
    [[nodiscard]] std::optional<TimePoint> due() const;
    /// The order was accepted: on to the next. The event of the end when it was the last. `end`: of its
    /// exchange.
    [[nodiscard]] std::optional<Event> accepted(const ReplyEnd& end);
    /// The order ended the operation.
    [[nodiscard]] Event failed(Outcome outcome);
    /// The operation of groups has ended.
    [[nodiscard]] GroupFinished finishGroup(Outcome outcome, std::vector<GroupMember> members = {});
    /// Everything that waits or runs.
    [[nodiscard]] std::vector<Event> cancelAll();
    /// The same of what is for one of these, or for a group.
    [[nodiscard]] std::vector<Event> cancelFor(const std::vector<ModuleIndex>& modules);
    /// The operation to carry out now is such a one.
    [[nodiscard]] bool isFor(const std::vector<ModuleIndex>& modules) const {
        return !empty() && concerns(m_waiting.front(), modules);
    }

private:
    struct Waiting {
        OperationId id;
        std::vector<Order> orders;
        std::optional<GroupOperation> group;
        std::optional<Sine> sine{};
    };
    [[nodiscard]] static bool concerns(const Waiting& waiting, const std::vector<ModuleIndex>& modules);
    [[nodiscard]] bool push(Waiting waiting);
    Event finish(Outcome outcome);
    [[nodiscard]] std::vector<GroupMember> membersOfChange(Outcome outcome) const;
    void next();
    void beginFront();

    std::deque<Waiting> m_waiting;
    std::size_t m_order = 0;
    std::optional<SineRun> m_sine;  ///< of the operation to carry out now
    bool m_begun = false;           ///< the present order has its time, and is not answered yet
    TimePoint m_began;
};

/// The event for an operation that never got into the lane.
[[nodiscard]] OperationFinished rejected(const Operation& operation, Outcome outcome);

}  // namespace nmc::bus

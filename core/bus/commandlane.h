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

/// The waiting operations, and the one being carried out, order by order. Pure bookkeeping: the engine
/// decides what is sent and when.
class CommandLane {
public:
    static constexpr std::size_t kCapacity = 256;

    /// Returns false if the lane is full; the operation was not accepted.
    [[nodiscard]] bool submit(Operation operation);
    [[nodiscard]] bool submit(GroupOperation operation);
    [[nodiscard]] bool empty() const { return m_waiting.empty(); }
    [[nodiscard]] bool concerns(ModuleIndex module) const;

    /// The current operation if it is a group operation. It has no orders until plan() provides them.
    [[nodiscard]] const GroupOperation* group() const;
    [[nodiscard]] bool planned() const { return !m_waiting.front().orders.empty(); }
    void plan(std::vector<Order> orders) { m_waiting.front().orders = std::move(orders); }

    /// The current order, and the time at which it became current. The lane must not be empty.
    [[nodiscard]] const Order& order() const { return m_waiting.front().orders[m_order]; }
    /// Notes that the order is handled for the first time; later calls have no effect. A sine is set to its
    /// present position.
    void beginStep(TimePoint now);
    [[nodiscard]] TimePoint stepBegan() const { return m_began; }
    /// The order is being sent.
    void noteSent() { m_sent = true; }

    /// True if the current operation is a sine.
    [[nodiscard]] bool swings() const { return m_sine.has_value(); }
    /// A poll of this module was answered.
    void notePoll(ModuleIndex module, const ReplyEnd& end) {
        if (m_sine && order().module == module)
            m_sine->notePoll(end);
    }
    /// True if the current operation is a sine and another operation is waiting.
    [[nodiscard]] bool sineOver() const { return m_sine && m_waiting.size() > 1; }
    /// True if it is a sine that the chip has ended.
    [[nodiscard]] bool endedByChip() const { return m_sine && m_sine->endedByChip(); }
    /// When there is something to do: at once, except between two steps of a sine.
    [[nodiscard]] std::optional<TimePoint> due() const;
    /// The order was accepted; the next one becomes current. Returns the final event if it was the last.
    /// `end`: of its exchange.
    [[nodiscard]] std::optional<Event> accepted(const ReplyEnd& end);
    /// Ends the operation.
    [[nodiscard]] Event finish(Outcome outcome);
    /// The group operation has ended.
    [[nodiscard]] GroupFinished finishGroup(Outcome outcome, std::vector<GroupMember> members = {});
    /// Cancels everything that is waiting or running.
    [[nodiscard]] std::vector<Event> cancelAll();
    /// Cancels what concerns one of these modules, or a group.
    [[nodiscard]] std::vector<Event> cancelFor(const std::vector<ModuleIndex>& modules);
    /// True if the current operation concerns one of these modules, or a group.
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
    /// The modules for which the current operation has loaded a motion that it has not started.
    [[nodiscard]] std::vector<ModuleIndex> loaded() const;
    [[nodiscard]] std::vector<GroupMember> membersOfChange(Outcome outcome) const;
    void next();
    void beginFront();

    std::deque<Waiting> m_waiting;
    std::size_t m_order = 0;
    std::optional<SineRun> m_sine;  ///< of the current operation
    bool m_begun = false;           ///< the present order has its start time, and is not answered yet
    bool m_sent = false;            ///< the present order was sent, and is not answered yet
    TimePoint m_began;
};

/// The event for an operation that was not accepted into the lane.
[[nodiscard]] OperationFinished rejected(const Operation& operation, Outcome outcome);

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/commandlane.h"
#include "bus/groupwork.h"
#include "bus/task.h"
#include "bus/verification.h"

namespace nmc::bus {

/// What the operator asks for, one operation after the other, order by order: each is judged by the command
/// gate, sent, and looked at where its answer got lost (verification.h). Each ends in exactly one
/// OperationFinished or GroupFinished.
class OperationTask : public Task {
public:
    OperationTask(Chain& chain, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_events(events), m_group(chain, line, m_commands, events) {}

    /// False when there are too many; nothing was taken.
    [[nodiscard]] bool submit(Operation operation) { return m_commands.submit(std::move(operation)); }
    [[nodiscard]] bool submit(const GroupOperation& operation) { return m_commands.submit(operation); }
    /// Cancels those that are for one of these modules, or for a group. True when one was under way.
    bool cancelFor(const std::vector<ModuleIndex>& modules);
    /// A poll of that module was answered.
    void notePoll(ModuleIndex module, const ReplyEnd& end) { m_commands.notePoll(module, end); }
    /// A sine is under way.
    [[nodiscard]] bool swings() const { return m_commands.swings(); }
    /// With it.
    [[nodiscard]] bool swings(ModuleIndex module) const {
        return m_commands.swings() && m_commands.isFor({module});
    }
    [[nodiscard]] bool empty() const { return m_commands.empty(); }
    /// Something that it waits for, or is told just now, is for that module.
    [[nodiscard]] bool concerns(ModuleIndex module) const { return m_commands.concerns(module); }
    /// Half a group has started: its members have to be stopped. Once.
    [[nodiscard]] std::vector<GroupMember> takeHalfStarted() { return m_group.takeHalfStarted(); }

    [[nodiscard]] bool wants(TimePoint now) const override {
        return m_verification || (!m_commands.empty() && *m_commands.due() <= now);
    }
    /// Of a sine; all others want the line at once.
    [[nodiscard]] std::optional<TimePoint> due() const override {
        return m_commands.swings() ? m_commands.due() : std::nullopt;
    }
    [[nodiscard]] bool pipelines() const override { return m_commands.group() == nullptr; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    void onAnswer(const Ask& ask, const ReplyEnd& end) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    [[nodiscard]] Next send();
    [[nodiscard]] Next look(ModuleIndex module) const { return m_chain.look(Purpose::Check, module); }
    [[nodiscard]] Next verifyStep();
    void onStepEnd(const Ask& ask, const ReplyEnd& end);
    void accept(const ReplyEnd& end);
    void fail(const ReplyEnd& end);

    Chain& m_chain;
    std::vector<Event>& m_events;
    CommandLane m_commands;
    GroupWork m_group;
    std::optional<Verification> m_verification;
    std::optional<std::int32_t> m_positionBefore;  ///< of the order that is on its way
    unsigned m_attempts = 0;                       ///< of the present order, after looks
};

}  // namespace nmc::bus

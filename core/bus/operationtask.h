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

/// The user's commands, one operation after the other, order by order: each is checked by the command gate,
/// sent, and verified if its answer was lost (verification.h). Each operation ends in exactly one
/// OperationFinished or GroupFinished.
class OperationTask : public Task {
public:
    explicit OperationTask(const Shared& shared) : Task(shared), m_group(shared, m_commands) {}

    /// Returns false if too many are waiting; the operation was not accepted.
    [[nodiscard]] bool submit(Operation operation) { return m_commands.submit(std::move(operation)); }
    [[nodiscard]] bool submit(const GroupOperation& operation) { return m_commands.submit(operation); }
    /// Cancels what concerns one of these modules, or a group. Returns true if one such operation was in
    /// progress.
    bool cancelFor(const std::vector<ModuleIndex>& modules);
    /// A poll of that module was answered.
    void notePoll(ModuleIndex module, const ReplyEnd& end) { m_commands.notePoll(module, end); }
    /// A sine is in progress.
    [[nodiscard]] bool swings() const { return m_commands.swings(); }
    /// A sine is in progress on this module.
    [[nodiscard]] bool swings(ModuleIndex module) const {
        return m_commands.swings() && m_commands.isFor({module});
    }
    [[nodiscard]] bool empty() const { return m_commands.empty(); }
    /// An operation that is waiting or in progress is for that module.
    [[nodiscard]] bool concerns(ModuleIndex module) const { return m_commands.concerns(module); }
    /// Only part of a group has started: its members must be stopped. Returned once.
    [[nodiscard]] std::vector<GroupMember> takeHalfStarted() { return m_group.takeHalfStarted(); }

    [[nodiscard]] bool wants(TimePoint now) const override {
        return m_verification || (!m_commands.empty() && *m_commands.due() <= now);
    }
    /// For a sine; all other operations need the line at once.
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
    [[nodiscard]] Next forbid();
    void report(Event event);
    [[nodiscard]] Next look(ModuleIndex module) const { return m_chain.look(Purpose::Check, module); }
    [[nodiscard]] Next verifyStep();
    void onStepEnd(const Ask& ask, const ReplyEnd& end);
    void accept(const ReplyEnd& end);
    void fail(const ReplyEnd& end);
    void oweStop();

    CommandLane m_commands;
    GroupWork m_group;
    std::optional<Verification> m_verification;
    std::optional<std::int32_t> m_positionBefore;  ///< at the time of the order in progress
    bool m_stoodBefore = true;                     ///< likewise: the motor stood
    unsigned m_attempts = 0;                       ///< for the present order, after verifications
};

}  // namespace nmc::bus

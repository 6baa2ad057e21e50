// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/commandlane.h"
#include "bus/gate.h"
#include "bus/grouprun.h"
#include "bus/task.h"

namespace nmc::bus {

/// The part of OperationTask for groups: it provides the orders of membership changes, and verifies commands
/// to a group for all members, sends them once, and checks the outcome at each member (grouprun.h).
class GroupWork {
public:
    GroupWork(const Shared& shared, CommandLane& commands)
        : m_chain(shared.chain), m_line(shared.line), m_commands(commands), m_events(shared.events) {}

    /// Something else comes first, and stops these modules. Whether all members have carried out a start that
    /// was sent is not found out any more, so the others must be stopped (takeHalfStarted()).
    void cancel(const std::vector<ModuleIndex>& stopped);
    /// All motors are stopped.
    void drop() { m_run.reset(); }
    /// Only some of these members have, or may have, started: returned once, after the operation has ended.
    [[nodiscard]] std::vector<GroupMember> takeHalfStarted() { return std::exchange(m_halfStarted, {}); }

    /// The current operation is a group operation. Returns nothing if its next order is an ordinary one.
    [[nodiscard]] std::optional<Next> next(TimePoint now);
    void onAnswer(const Ask& ask, const ReplyEnd& end);
    /// Returns false if the exchange was not its own.
    [[nodiscard]] bool onEnd(const Ask& ask, const ReplyEnd& end);
    /// A change of group was not answered, or ends before its answer.
    void reportUnknown();

private:
    struct GroupPermit {
        Permission verdict;
        std::optional<ModuleIndex> module;  ///< the one that decides
    };
    [[nodiscard]] std::optional<ModuleIndex> planChange(const GroupChange& change);
    [[nodiscard]] bool reachable(ModuleIndex module) const;
    [[nodiscard]] GroupPermit permitGroup(const GroupCommand& command) const;
    [[nodiscard]] Next tryCommand(const GroupCommand& command, TimePoint now);
    [[nodiscard]] Next send(const GroupCommand& command, TimePoint now);
    [[nodiscard]] Next lookAtMembers(TimePoint now);
    void finish();

    Chain& m_chain;
    const Line& m_line;
    CommandLane& m_commands;
    std::vector<Event>& m_events;
    std::optional<GroupRun> m_run;  ///< a command to a group is in progress
    std::vector<GroupMember> m_halfStarted;
};

}  // namespace nmc::bus

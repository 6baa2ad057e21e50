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

/// The part of OperationTask that is about groups: changes of membership get their orders, commands to a
/// group are permit for all members, sent once, and looked after at each of them (grouprun.h).
class GroupWork {
public:
    GroupWork(Chain& chain, const Line& line, CommandLane& commands, std::vector<Event>& events)
        : m_chain(chain), m_line(line), m_commands(commands), m_events(events) {}

    void cancel() { m_run.reset(); }
    /// Only some members have started: once, and the operation is over by then.
    [[nodiscard]] std::vector<GroupMember> takeHalfStarted() { return std::exchange(m_halfStarted, {}); }

    /// The operation in front is one of groups; nothing when its next order is an ordinary one.
    [[nodiscard]] std::optional<Next> next(TimePoint now);
    void onAnswer(const Ask& ask, const ReplyEnd& end);
    /// False when that exchange was not its own.
    [[nodiscard]] bool onEnd(const Ask& ask, const ReplyEnd& end);
    /// The change of a group was not answered.
    void reportUnknown();

private:
    struct GroupPermit {
        Permission verdict;
        std::optional<ModuleIndex> module;  ///< that it hangs on
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
    std::optional<GroupRun> m_run;  ///< a command to a group is out
    std::vector<GroupMember> m_halfStarted;
};

}  // namespace nmc::bus

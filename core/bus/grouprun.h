// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// The command to a group in the form for a member's chip; for stops, a command that stops nothing.
[[nodiscard]] ModuleCommand commandFor(GroupCommand::Action action, ModuleType type);

/// Determines the outcome of a command sent to a group once, which only the leader answers, if there is one:
/// each member is queried until two replies show whether it carried the command out, or time is up. Pure; the
/// engine sends the queries.
class GroupRun {
public:
    /// How long a member is queried that shows nothing, for example a slow one in velocity mode.
    static constexpr Duration kLimit = std::chrono::milliseconds(250);
    /// Distance in counts after which a motion must be visible.
    static constexpr double kShows = 20;

    /// `members`: the beliefs just before the command is latched.
    GroupRun(GroupCommand command, std::vector<Belief> members, TimePoint latched);

    /// The leader's own answer. A result other than accepted or refused shows nothing.
    void onLeader(ModuleIndex leader, ReplyResult result);
    /// The next module to query; empty when it is over.
    [[nodiscard]] std::optional<ModuleIndex> next(TimePoint now);
    /// A member's reply. Returns true if it settles that the member carried the command out.
    [[nodiscard]] bool onLook(ModuleIndex module, const StatusReport& report, TimePoint latched);
    void onSilence(ModuleIndex module);

    [[nodiscard]] std::vector<GroupMember> members() const;
    [[nodiscard]] const Belief& before(ModuleIndex module) const;
    [[nodiscard]] TimePoint latched() const { return m_latched; }
    [[nodiscard]] bool starts() const { return m_command.action == GroupCommand::Action::StartMotion; }
    /// Some members have started, and others have not, or may not have.
    [[nodiscard]] bool partly() const;

private:
    struct Member {
        Belief before;
        bool stood = false;  ///< at rest before the command
        unsigned looks = 0;
        unsigned done = 0;     ///< consecutive replies that show the command carried out
        unsigned notDone = 0;  ///< consecutive replies that show the contrary
        unsigned silences = 0;
        std::optional<MemberOutcome> outcome{};
    };
    [[nodiscard]] Member& at(ModuleIndex module);
    [[nodiscard]] std::optional<MemberOutcome> shows(const Member& member, const StatusReport& report,
                                                     TimePoint latched) const;
    [[nodiscard]] static std::optional<MemberOutcome> reset(const Member& member, const StatusReport& report);
    [[nodiscard]] static std::optional<MemberOutcome> cleared(const StatusReport& report);
    [[nodiscard]] std::optional<MemberOutcome> putOut(const Member& member, const StatusReport& report) const;
    [[nodiscard]] std::optional<MemberOutcome> started(const Member& member, const StatusReport& report,
                                                       TimePoint latched) const;

    GroupCommand m_command;
    TimePoint m_latched;
    std::vector<Member> m_members;
};

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// The command to a group in the words of a member's chip; of stops, nothing that would stop.
[[nodiscard]] ModuleCommand commandFor(GroupCommand::Action action, ModuleType type);

/// What became of a command that went to a group, once, and that only its leader answers if it has one: each
/// member is looked at until it has shown twice whether it carried it out, or time is up. Pure; the engine
/// asks.
class GroupRun {
public:
    /// How long a member is looked at that does not show it, a slow one in velocity mode say.
    static constexpr Duration kLimit = std::chrono::milliseconds(250);
    /// A motion shows when it should have gone so far.
    static constexpr double kShows = 20;

    /// `members`: what is believed of them just before the command is latched.
    GroupRun(GroupCommand command, std::vector<Belief> members, TimePoint latched);

    /// The leader's own answer. What is neither accepted nor refused tells nothing.
    void onLeader(ModuleIndex leader, ReplyResult result);
    /// Whom to look at; nothing when it is over.
    [[nodiscard]] std::optional<ModuleIndex> next(TimePoint now);
    /// What a member says. True when that settles that it carried the command out.
    [[nodiscard]] bool onLook(ModuleIndex module, const StatusReport& report, TimePoint latched);
    void onSilence(ModuleIndex module);

    [[nodiscard]] std::vector<GroupMember> members() const;
    [[nodiscard]] const Belief& before(ModuleIndex module) const;
    [[nodiscard]] TimePoint latched() const { return m_latched; }
    /// Started by some and certainly or perhaps not by others.
    [[nodiscard]] bool partly() const;

private:
    struct Member {
        Belief before;
        bool stood = false;  ///< before the command
        unsigned looks = 0;
        unsigned done = 0;     ///< looks in a row that show it
        unsigned notDone = 0;  ///< looks in a row that show the contrary
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

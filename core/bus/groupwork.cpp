// SPDX-License-Identifier: MIT
#include "bus/groupwork.h"

#include <algorithm>

#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

/// True if sent to the address of the group, whose leader answers.
[[nodiscard]] bool toGroup(const Ask& ask) {
    return ask.request.address.value() >= kFirstGroup;
}

}  // namespace

void GroupWork::cancel(const std::vector<ModuleIndex>& stopped) {
    const std::optional<GroupRun> run = std::exchange(m_run, std::nullopt);
    if (!run)
        return;
    for (const GroupMember& member : run->members())
        if (!run->starts())
            m_chain.takeUnanswered(member.module, run->latched());  // its outcome remains unknown
        else if (std::ranges::find(stopped, member.module) == stopped.end())
            m_halfStarted.push_back(member);
}

std::optional<Next> GroupWork::next(TimePoint now) {
    const GroupOperation& operation = *m_commands.group();
    if (m_run)
        return lookAtMembers(now);
    if (const auto* command = std::get_if<GroupCommand>(&operation.what))
        return tryCommand(*command, now);
    if (m_commands.planned())
        return std::nullopt;
    if (const auto obstacle = planChange(std::get<GroupChange>(operation.what)))
        m_events.emplace_back(
            m_commands.finishGroup(Outcome::Forbidden, {{*obstacle, MemberOutcome::Withheld}}));
    return Again{};
}

/// Provides the orders of the change: first the old leader becomes a plain member, so that there are never
/// two leaders. Returns the module that makes it impossible, if any.
std::optional<ModuleIndex> GroupWork::planChange(const GroupChange& change) {
    if (!reachable(change.module) || change.place.group < kFirstGroup)
        return change.module;
    // All modules are in group FF by default: its stops and rate changes must not be answered.
    if (change.place.leader && BusAddress(change.place.group) == kEverybody)
        return change.module;
    const auto orderTo = [&](ModuleIndex module, GroupPlace place) {
        const SetAddress set{m_chain.belief(module).info().address, BusAddress(place.group), place.leader};
        return Order{module, forChip(m_chain.belief(module).info().identity.type, set)};
    };
    std::vector<Order> orders;
    for (const Chain::Module& other : m_chain.modules()) {
        const ModuleInfo& info = other.belief.info();
        if (!change.place.leader || info.index == change.module)
            continue;
        // This module may be the leader of that group.
        if (!info.group)
            return info.index;
        if (!info.group->leader || info.group->group != change.place.group)
            continue;
        if (!reachable(info.index))
            return info.index;
        orders.push_back(orderTo(info.index, {info.group->group, false}));
    }
    orders.push_back(orderTo(change.module, change.place));
    m_commands.plan(std::move(orders));
    return std::nullopt;
}

bool GroupWork::reachable(ModuleIndex module) const {
    return m_chain.has(module) && isKnown(m_chain.belief(module).info().identity) &&
           !m_chain.belief(module).restarted() && m_chain.answers(module);
}

/// Verifies whether the command may be sent to the group; otherwise includes the module that prevents it.
GroupWork::GroupPermit GroupWork::permitGroup(const GroupCommand& command) const {
    GroupPermit worst{Permission::Allowed, {}};
    bool anybody = false;
    for (const Chain::Module& module : m_chain.modules()) {
        const ModuleInfo& info = module.belief.info();
        const bool everybody = BusAddress(command.group) == kEverybody;
        // It may be a member; and a module that restarted unnoticed is in group FF.
        if (!info.group || (everybody && !m_chain.answers(info.index)))
            return {Permission::Never, info.index};
        if (info.group->group != command.group)
            continue;
        anybody = true;
        if (!reachable(info.index))
            return {Permission::Never, info.index};
        const ModuleCommand own = commandFor(command.action, info.identity.type);
        Permission verdict = permit(module.belief, own);
        if (mayStartMotion(own) && module.forbidsStart())
            verdict = Permission::Never;
        // With nothing stored, it is unknown what Synch Output would set.
        if (info.identity.type == ModuleType::Io && command.action == GroupCommand::Action::StartMotion &&
            !module.belief.outputs().stored())
            verdict = Permission::Never;
        if (verdict == Permission::Never)
            return {verdict, info.index};
        if (verdict == Permission::InMotion && module.belief.looksSince(m_commands.stepBegan()) < 2)
            verdict = Permission::NeedsStatus;
        if (verdict == Permission::Allowed && !module.belief.items())
            verdict = Permission::NeedsStatus;
        if (verdict == Permission::NeedsStatus || (verdict == Permission::InMotion && !worst.module))
            worst = {verdict, info.index};
    }
    return anybody ? worst : GroupPermit{Permission::Never, {}};
}

Next GroupWork::tryCommand(const GroupCommand& command, TimePoint now) {
    m_commands.beginStep(now);
    const GroupPermit permit = permitGroup(command);
    switch (permit.verdict) {
        case Permission::Allowed:
            return send(command, now);
        case Permission::NeedsStatus:
            return m_chain.look(Purpose::Check, *permit.module);
        case Permission::InMotion:
        case Permission::Never:
            break;
    }
    std::vector<GroupMember> withheld;
    if (permit.module)
        withheld.push_back({*permit.module, MemberOutcome::Withheld});
    m_events.emplace_back(m_commands.finishGroup(Outcome::Forbidden, std::move(withheld)));
    return Again{};
}

/// Sends the command once. Every member counts as having received it until it shows the contrary.
Next GroupWork::send(const GroupCommand& command, TimePoint now) {
    const Payload payload = payloadOf(commandFor(command.action, ModuleType::Servo));
    const BusAddress group(command.group);
    const PacketBytes packet = toPacket({group, payload});
    const TimePoint latched = m_line.latchTime(packet.size(), now);
    std::vector<Belief> members;
    std::optional<ModuleIndex> leader;
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleInfo& info = module.belief.info();
        if (info.group->group != command.group)
            continue;
        if (mayStartMotion(commandFor(command.action, info.identity.type)))
            module.owed.reset();  // the user wants it to move again
        members.push_back(module.belief);
        if (info.group->leader)
            leader = info.index;
    }
    m_run.emplace(command, members, latched);
    for (const Belief& member : members) {
        const ModuleIndex index = member.info().index;
        if (index != leader)
            m_chain.noteSent(index, commandFor(command.action, member.info().identity.type), latched);
    }
    if (!leader)
        return Line::Script{Line::Packet{packet}, Line::Spacer{}};
    Ask ask =
        m_chain.command(Purpose::Operation,
                        {*leader, commandFor(command.action, m_chain.belief(*leader).info().identity.type)});
    ask.request.address = group;
    ask.reported = true;
    ask.silentRepeats = 0;
    ask.refusedAttempts = 1;
    return ask;
}

Next GroupWork::lookAtMembers(TimePoint now) {
    while (const auto module = m_run->next(now)) {
        if (m_chain.answers(*module))
            return m_chain.look(Purpose::Check, *module);
        m_run->onSilence(*module);
    }
    finish();
    return Again{};
}

/// Called before the reply is published, because the calculated command position depends on it.
void GroupWork::onAnswer(const Ask& ask, const ReplyEnd& end) {
    if (!m_run || toGroup(ask) || !m_run->onLook(*ask.module, end.report, end.latched))
        return;
    const auto& command = std::get<GroupCommand>(m_commands.group()->what);
    Belief& belief = m_chain.at(*ask.module).belief;
    const ModuleCommand carriedOut = commandFor(command.action, belief.info().identity.type);
    belief.onExecuted(carriedOut);
    const TimePoint latched = m_run->latched();
    m_events.emplace_back(
        CommandExecuted{*ask.module, latched, carriedOut, {}, m_chain.takeUnanswered(*ask.module, latched)});
}

bool GroupWork::onEnd(const Ask& ask, const ReplyEnd& end) {
    if (!m_run)
        return false;
    if (toGroup(ask))
        m_run->onLeader(*ask.module, end.result);
    else if (end.result != ReplyResult::Accepted)
        m_run->onSilence(*ask.module);
    return true;
}

void GroupWork::reportUnknown() {
    if (m_commands.group() == nullptr || !m_commands.planned())
        return;
    const ModuleIndex module = m_commands.order().module;
    m_chain.takeUnanswered(module, {});
    if (!m_chain.belief(module).info().group)
        m_events.emplace_back(GroupChanged{module, std::nullopt});
}

void GroupWork::finish() {
    const GroupRun run = *std::exchange(m_run, std::nullopt);
    const std::vector<GroupMember> members = run.members();
    const bool all = std::ranges::all_of(
        members, [](const GroupMember& member) { return member.outcome == MemberOutcome::Done; });
    for (const GroupMember& member : members) {
        m_chain.takeUnanswered(member.module, run.latched());
        if (member.outcome == MemberOutcome::NotDone)
            m_chain.at(member.module).belief.onNotExecuted(run.before(member.module));
    }
    GroupFinished event = m_commands.finishGroup(all ? Outcome::Done : Outcome::NoAnswer, members);
    // Half a group in motion is what groups are meant to prevent (faults.md M-27).
    event.stopped = run.partly();
    m_events.emplace_back(std::move(event));
    if (run.partly())
        m_halfStarted = members;
}

}  // namespace nmc::bus

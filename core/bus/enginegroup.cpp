// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"
#include "bus/gate.h"

namespace nmc::bus {

namespace {

constexpr std::uint8_t kFirstGroup = 0x80;

}  // namespace

void Engine::Private::submit(const GroupOperation& operation, TimePoint now) {
    if (m_phase != Phase::Running || m_stop || !m_commands.submit(operation)) {
        events.emplace_back(GroupFinished{operation.id, Outcome::Cancelled, operation.what, {}, false});
        return;
    }
    proceed(now);
}

/// The operation in front is one of groups. False when its next step is an ordinary one.
bool Engine::Private::dispatchGroup(TimePoint now) {
    const GroupOperation& operation = *m_commands.group();
    if (m_groupRun) {
        lookAtMembers(now);
        return true;
    }
    if (const auto* command = std::get_if<GroupCommand>(&operation.what)) {
        tryGroupCommand(*command, now);
        return true;
    }
    if (m_commands.planned())
        return false;
    if (const auto obstacle = planChange(std::get<GroupChange>(operation.what)))
        events.emplace_back(
            m_commands.finishGroup(Outcome::Forbidden, {{*obstacle, MemberOutcome::Withheld}}));
    return true;
}

/// Gives the change its steps: first the old leader becomes a member, so that there are never two. Or whom it
/// fails for.
std::optional<ModuleIndex> Engine::Private::planChange(const GroupChange& change) {
    if (!reachable(change.module) || change.place.group < kFirstGroup)
        return change.module;
    // Group FF is everybody's: its stops and rates must not be answered.
    if (change.place.leader && BusAddress(change.place.group) == kEverybody)
        return change.module;
    const auto stepTo = [&](ModuleIndex module, GroupPlace place) {
        const SetAddress set{belief(module).info().address, BusAddress(place.group), place.leader};
        const bool stepper = belief(module).info().identity.type == ModuleType::Step;
        return stepper ? Step{module, StepCommand(set)} : Step{module, ServoCommand(set)};
    };
    std::vector<Step> steps;
    for (const Module& other : m_modules) {
        const ModuleInfo& info = other.belief.info();
        if (!change.place.leader || info.index == change.module)
            continue;
        // It may lead that group.
        if (!info.group)
            return info.index;
        if (!info.group->leader || info.group->group != change.place.group)
            continue;
        if (!reachable(info.index))
            return info.index;
        steps.push_back(stepTo(info.index, {info.group->group, false}));
    }
    steps.push_back(stepTo(change.module, change.place));
    m_commands.plan(std::move(steps));
    return std::nullopt;
}

bool Engine::Private::reachable(ModuleIndex module) const {
    return module.value() < m_modules.size() && knownType(belief(module).info().identity.type) &&
           !belief(module).restarted() && !m_schedule.silent(module);
}

/// Whether the command may go to the group, and whom it hangs on if it may not.
Engine::Private::GroupVerdict Engine::Private::judgeGroup(const GroupCommand& command) const {
    GroupVerdict worst{Verdict::Allowed, {}};
    bool anybody = false;
    for (const Module& module : m_modules) {
        const ModuleInfo& info = module.belief.info();
        const bool everybody = BusAddress(command.group) == kEverybody;
        // It may be a member; and one that restarted unseen is in group FF.
        if (!info.group || (everybody && m_schedule.silent(info.index)))
            return {Verdict::Never, info.index};
        if (info.group->group != command.group)
            continue;
        anybody = true;
        if (!reachable(info.index))
            return {Verdict::Never, info.index};
        Verdict verdict = judge(module.belief, commandFor(command.action, info.identity.type));
        if (verdict == Verdict::Never)
            return {verdict, info.index};
        if (verdict == Verdict::InMotion && module.belief.looksSince(m_commands.stepBegan()) < 2)
            verdict = Verdict::NeedsStatus;
        if (verdict == Verdict::Allowed && !module.belief.items())
            verdict = Verdict::NeedsStatus;
        if (verdict == Verdict::NeedsStatus || (verdict == Verdict::InMotion && !worst.module))
            worst = {verdict, info.index};
    }
    return anybody ? worst : GroupVerdict{Verdict::Never, {}};
}

void Engine::Private::tryGroupCommand(const GroupCommand& command, TimePoint now) {
    m_commands.beginStep(now);
    const GroupVerdict judged = judgeGroup(command);
    switch (judged.verdict) {
        case Verdict::Allowed:
            return sendToGroup(command, now);
        case Verdict::NeedsStatus:
            return check(*judged.module, Lane::Check, now);
        case Verdict::InMotion:
        case Verdict::Never:
            break;
    }
    std::vector<GroupMember> withheld;
    if (judged.module)
        withheld.push_back({*judged.module, MemberOutcome::Withheld});
    events.emplace_back(m_commands.finishGroup(Outcome::Forbidden, std::move(withheld)));
}

/// Once. Every member counts as having heard it until it shows the contrary.
void Engine::Private::sendToGroup(const GroupCommand& command, TimePoint now) {
    const Payload payload = payloadOf(commandFor(command.action, ModuleType::Servo));
    const BusAddress group(command.group);
    const PacketBytes packet = toPacket({group, payload});
    const TimePoint latched = line.latchTime(packet.size(), now);
    std::vector<Belief> members;
    std::optional<ModuleIndex> leader;
    for (const Module& module : m_modules) {
        const ModuleInfo& info = module.belief.info();
        if (info.group->group != command.group)
            continue;
        members.push_back(module.belief);
        if (info.group->leader)
            leader = info.index;
    }
    m_groupRun.emplace(command, members, latched);
    for (const Belief& member : members) {
        const ModuleIndex index = member.info().index;
        if (index != leader)
            tell(index, commandFor(command.action, member.info().identity.type), latched);
    }
    if (!leader)
        return line.run({Line::Packet{packet}, Line::Pause{kTurnaround}}, now);
    Work work =
        commandWork(Lane::Group, {*leader, commandFor(command.action, belief(*leader).info().identity.type)});
    work.request.address = group;
    work.silentRepeats = 0;
    work.refusedAttempts = 1;
    begin(std::move(work), now);
}

void Engine::Private::lookAtMembers(TimePoint now) {
    while (const auto module = m_groupRun->next(now)) {
        if (!m_schedule.silent(*module))
            return check(*module, Lane::GroupLook, now);
        m_groupRun->onSilence(*module);
    }
    finishGroupCommand();
}

/// Before what it says is shown: the calculated command position goes by it.
void Engine::Private::noteGroupLook(ModuleIndex module, const ReplyEnd& end) {
    if (!m_groupRun || !m_groupRun->onLook(module, end.report, end.latched))
        return;
    const auto& command = std::get<GroupCommand>(m_commands.group()->what);
    const ModuleCommand carriedOut = commandFor(command.action, belief(module).info().identity.type);
    belief(module).onExecuted(carriedOut);
    events.emplace_back(CommandExecuted{module, m_groupRun->latched(), carriedOut});
}

void Engine::Private::finishGroupCommand() {
    const GroupRun run = *std::exchange(m_groupRun, std::nullopt);
    const std::vector<GroupMember> members = run.members();
    const auto all = [&](MemberOutcome outcome) {
        return std::all_of(members.begin(), members.end(),
                           [&](const GroupMember& member) { return member.outcome == outcome; });
    };
    for (const GroupMember& member : members)
        if (member.outcome == MemberOutcome::NotDone)
            belief(member.module).onNotExecuted(run.before(member.module));
    GroupFinished event =
        m_commands.finishGroup(all(MemberOutcome::Done) ? Outcome::Done : Outcome::NoAnswer, members);
    // Half a group in motion is what it was made to prevent (faults.md M-27). On a dead line stops go out
    // anyway.
    event.stopped = run.partly() && !m_lost;
    events.emplace_back(std::move(event));
    if (run.partly() && !m_lost)
        stopMembers(members);
}

void Engine::Private::stopMembers(const std::vector<GroupMember>& members) {
    cancelOperations();
    m_hold.clear();
    for (const GroupMember& member : members)
        if (const auto stop = stopFor(belief(member.module)))
            m_guards.push_back({member.module, *stop});
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "bus/grouprun.h"

#include <algorithm>

#include "bus/standstill.h"

namespace nmc::bus {

namespace {

/// Number of agreeing replies required for an outcome.
constexpr unsigned kVotes = 2;
/// Number of consecutive queries without an answer.
constexpr unsigned kSilences = 2;

/// The goal of the load; empty without one.
[[nodiscard]] std::optional<std::int32_t> goalOf(const Belief& before) {
    if (const auto& load = before.stepperLoad())
        return load->position ? std::optional(load->position->value()) : std::nullopt;
    const auto& load = before.servoLoad();
    return load && load->isTrapezoidal() && load->position ? std::optional(load->position->value())
                                                           : std::nullopt;
}

/// The distance in counts that a velocity mode load covers within `time` after standstill, as far as the load
/// specifies it. `servoRate`: empty if unknown.
[[nodiscard]] double distanceOf(const servo::LoadTrajectory& load, Duration time,
                                std::optional<int> servoRate) {
    if (!load.isVelocityMode() || !load.velocity || !load.acceleration)
        return 0;
    const double ticks = toSeconds(time) / secondsPerTick(servoRate.value_or(kLongestServoRate));
    const double v = toCounts(*load.velocity);
    const double a = toCounts(*load.acceleration);
    return std::min(v * ticks, a * ticks * ticks / 2) / 2;  // half of it, to allow for friction
}

}  // namespace

ModuleCommand commandFor(GroupCommand::Action action, ModuleType type) {
    switch (action) {
        case GroupCommand::Action::StartMotion:
            return type == ModuleType::Io ? IoCommand(io::SynchOutput{}) : forChip(type, StartMotion{});
        case GroupCommand::Action::SaveAsHome:
            return type == ModuleType::Io ? IoCommand(io::SynchInput{}) : forChip(type, SaveAsHome{});
        case GroupCommand::Action::ResetPosition:
            return forChip(type, ResetPosition{});
        case GroupCommand::Action::ClearStickyBits:
            return ServoCommand(servo::ClearStickyBits{});  // the gate withholds it from the others
        case GroupCommand::Action::StopSmoothly:
        case GroupCommand::Action::StopAbruptly:
        case GroupCommand::Action::MotorOff:
            break;  // GroupWork stops each member according to its state
    }
    return forChip(type, Nop{});
}

GroupRun::GroupRun(GroupCommand command, std::vector<Belief> members, TimePoint latched)
    : m_command(command), m_latched(latched) {
    for (Belief& member : members) {
        const bool stood = member.standsStill();
        m_members.push_back({std::move(member), stood});
    }
}

void GroupRun::onLeader(ModuleIndex leader, ReplyResult result) {
    if (result == ReplyResult::Accepted)
        at(leader).outcome = MemberOutcome::Done;
    else if (result == ReplyResult::Refused)
        at(leader).outcome = MemberOutcome::NotDone;
}

std::optional<ModuleIndex> GroupRun::next(TimePoint now) {
    const Member* first = nullptr;
    for (Member& member : m_members) {
        if (!member.outcome && member.looks >= kVotes && now - m_latched >= kLimit)
            member.outcome = MemberOutcome::Unknown;
        if (!member.outcome && (first == nullptr || member.looks < first->looks))
            first = &member;
    }
    return first != nullptr ? std::optional(first->before.info().index) : std::nullopt;
}

bool GroupRun::onLook(ModuleIndex module, const StatusReport& report, TimePoint latched) {
    Member& member = at(module);
    if (member.outcome)
        return false;
    ++member.looks;
    member.silences = 0;
    const auto shown = shows(member, report, latched);
    if (!shown)
        return false;
    member.done = *shown == MemberOutcome::Done ? member.done + 1 : 0;
    member.notDone = *shown == MemberOutcome::NotDone ? member.notDone + 1 : 0;
    if (member.done == kVotes || member.notDone == kVotes || *shown == MemberOutcome::Unknown)
        member.outcome = shown;
    return member.outcome == MemberOutcome::Done;
}

void GroupRun::onSilence(ModuleIndex module) {
    Member& member = at(module);
    if (!member.outcome && ++member.silences == kSilences)
        member.outcome = MemberOutcome::NoAnswer;
}

std::vector<GroupMember> GroupRun::members() const {
    std::vector<GroupMember> all;
    for (const Member& member : m_members)
        all.push_back({member.before.info().index, member.outcome.value_or(MemberOutcome::NoAnswer)});
    return all;
}

const Belief& GroupRun::before(ModuleIndex module) const {
    return std::ranges::find_if(m_members, [&](const Member& m) { return m.before.info().index == module; })
        ->before;
}

bool GroupRun::partly() const {
    const auto any = [&](auto... outcomes) {
        return std::ranges::any_of(m_members, [&](const Member& member) {
            return ((member.outcome.value_or(MemberOutcome::NoAnswer) == outcomes) || ...);
        });
    };
    return starts() && any(MemberOutcome::Done, MemberOutcome::Unknown, MemberOutcome::NoAnswer) &&
           any(MemberOutcome::NotDone, MemberOutcome::NoAnswer);
}

GroupRun::Member& GroupRun::at(ModuleIndex module) {
    return *std::ranges::find_if(m_members, [&](const Member& m) { return m.before.info().index == module; });
}

/// Returns nothing if this reply is not conclusive; another one may be.
std::optional<MemberOutcome> GroupRun::shows(const Member& member, const StatusReport& report,
                                             TimePoint latched) const {
    if (member.before.info().identity.type == ModuleType::Io)
        return putOut(member, report);
    switch (m_command.action) {
        case GroupCommand::Action::StartMotion:
            return started(member, report, latched);
        case GroupCommand::Action::ResetPosition:
            return reset(member, report);
        case GroupCommand::Action::ClearStickyBits:
            return cleared(report);
        case GroupCommand::Action::SaveAsHome:
        case GroupCommand::Action::StopSmoothly:
        case GroupCommand::Action::StopAbruptly:
        case GroupCommand::Action::MotorOff:
            break;
    }
    if (!report.home || !report.position)
        return std::nullopt;
    if (member.stood)
        return samePlace(*report.home, *report.position) ? MemberOutcome::Done : MemberOutcome::NotDone;
    // The member was moving, so its home must differ from the previous one.
    const auto& home = member.before.home();
    return home && *home != *report.home ? MemberOutcome::Done : MemberOutcome::Unknown;
}

/// Reads the outputs back. A command that changes none of them, or a latched value, is not visible: only a
/// leader's answer shows it.
std::optional<MemberOutcome> GroupRun::putOut(const Member& member, const StatusReport& report) const {
    const IoOutputs& outputs = member.before.outputs();
    const unsigned changed =
        outputs.stored() && outputs.levels() ? unsigned{outputs.stored()->outputs} ^ *outputs.levels() : 0U;
    if (m_command.action != GroupCommand::Action::StartMotion || changed == 0)
        return member.looks >= kVotes ? std::optional(MemberOutcome::Unknown) : std::nullopt;
    if (!report.pins)
        return std::nullopt;
    const unsigned off = (*report.pins ^ outputs.stored()->outputs) & changed;
    return off == 0 ? MemberOutcome::Done : MemberOutcome::NotDone;
}

/// The member stood still, which the gate has verified.
std::optional<MemberOutcome> GroupRun::reset(const Member& member, const StatusReport& report) {
    if (!report.position)
        return std::nullopt;
    if (samePlace(*report.position, 0))
        return MemberOutcome::Done;
    const auto& from = member.before.position();
    return from && samePlace(*report.position, *from) ? MemberOutcome::NotDone : MemberOutcome::Unknown;
}

/// A persistent cause sets its bit again at once, which looks the same as a command that was not received.
std::optional<MemberOutcome> GroupRun::cleared(const StatusReport& report) {
    if (!report.aux || anySticky(report.servoStatus(), servo::AuxByte{*report.aux}))
        return std::nullopt;
    return MemberOutcome::Done;
}

std::optional<MemberOutcome> GroupRun::started(const Member& member, const StatusReport& report,
                                               TimePoint latched) const {
    // From one velocity to another: a command that was not received cannot be distinguished from a slow
    // change.
    if (!member.stood)
        return member.looks >= kVotes ? std::optional(MemberOutcome::Unknown) : std::nullopt;
    const auto& from = member.before.position();
    if (!report.position || !from)
        return std::nullopt;
    const auto goal = goalOf(member.before);
    const bool there = goal && samePlace(*report.position, *goal);
    if (there || !samePlace(*report.position, *from))
        return MemberOutcome::Done;
    if (member.before.info().identity.type == ModuleType::Stepper)
        return report.stepperStatus().moving() ? MemberOutcome::Done : MemberOutcome::NotDone;
    if (!report.servoStatus().moveDone())
        return MemberOutcome::Done;
    // The servo went off by itself in the meantime, so the motion may have begun.
    if (report.aux && member.before.on() && !servo::AuxByte{*report.aux}.servoOn())
        return MemberOutcome::Unknown;
    const auto& load = member.before.servoLoad();
    const bool wouldShow = goal || (load && distanceOf(*load, latched - m_latched,
                                                       member.before.servoRegisters().servoRate) >= kShows);
    return wouldShow ? std::optional(MemberOutcome::NotDone) : std::nullopt;
}

}  // namespace nmc::bus

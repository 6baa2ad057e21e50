// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about groups and about the baud rate of the whole chain.
#include <algorithm>

#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

QString groupNumber(quint8 group) {
    return u"%1"_s.arg(group, 2, 16, QChar(u'0')).toUpper();
}

std::vector<ModuleIndex> those(const bus::GroupFinished& finished, bus::MemberOutcome outcome) {
    std::vector<ModuleIndex> modules;
    for (const bus::GroupMember& member : finished.members)
        if (member.outcome == outcome)
            modules.push_back(member.module);
    return modules;
}

/// Lists the outcomes that occurred, each with its modules.
QString membersSentence(const bus::GroupFinished& finished) {
    using enum bus::MemberOutcome;
    QStringList parts;
    const auto add = [&](bus::MemberOutcome outcome, const QString& text) {
        if (const auto modules = those(finished, outcome); !modules.empty())
            parts += text.arg(listOfModules(modules));
    };
    add(Done, Texts::tr("Carried out by: %1."));
    add(NotDone, Texts::tr("Not carried out by: %1."));
    add(Unknown, Texts::tr("Unknown for: %1."));
    add(NoAnswer, Texts::tr("No answer from: %1."));
    return parts.join(u' ');
}

Words startFailed(const bus::GroupFinished& finished, quint8 group) {
    const auto started = those(finished, bus::MemberOutcome::Done).size();
    return {
        finished.stopped
            ? Texts::tr("%1 of %2 modules of group %3 started. All of them were commanded to stop.")
                  .arg(QString::number(started), QString::number(finished.members.size()), groupNumber(group))
        : started == 0 && those(finished, bus::MemberOutcome::NotDone).size() == finished.members.size()
            ? Texts::tr("No module of group %1 started. Nothing was moved.").arg(groupNumber(group))
            : Texts::tr("Not all modules of group %1 confirmed their start.").arg(groupNumber(group)),
        membersSentence(finished) + u' ' +
            Texts::tr(
                "Look at the motors. The start is never repeated: load the moves again, then start the group again. Usually noise on the cable."),
        Severity::Fault};
}

/// In the text returned, %1 is the group.
QString notByAll(bus::GroupCommand::Action action) {
    using enum bus::GroupCommand::Action;
    switch (action) {
        case ResetPosition:
            return Texts::tr("Not all modules of group %1 confirmed setting their position to 0.");
        case ClearStickyBits:
            return Texts::tr(
                "Not all modules of group %1 confirmed clearing their sticky bits. A persistent fault sets its bit again at once.");
        case SaveAsHome:
            return Texts::tr("Not all modules of group %1 confirmed saving home.");
        case StartMotion:
        case StopSmoothly:
        case StopAbruptly:
        case MotorOff:
            break;
    }
    return Texts::tr("Not all modules of group %1 confirmed the command.");
}

Words withheld(const bus::GroupFinished& finished, const bus::GroupCommand& command) {
    const auto modules = those(finished, bus::MemberOutcome::Withheld);
    if (modules.empty())
        return {Texts::tr("Group %1 is empty. Nothing was sent.").arg(groupNumber(command.group)),
                Texts::tr("Add modules to the group first.")};
    return {
        Texts::tr("Module %2 blocks the command to group %1. Nothing was sent.")
            .arg(groupNumber(command.group), listOfModules(modules)),
        command.action == bus::GroupCommand::Action::StartMotion
            ? Texts::tr(
                  "A group starts only when every member answers, has confirmed its load and can start, and the group of every module is known. Load this module again, or set its group again.")
            : Texts::tr(
                  "A group command requires that every member answers and can carry it out in its present state, and that the group of every module is known. Command the modules one by one, or set this module's group again.")};
}

Words commandFailed(const bus::GroupFinished& finished, const bus::GroupCommand& command) {
    using bus::Outcome;
    const QString number = groupNumber(command.group);
    if (finished.outcome == Outcome::Forbidden)
        return withheld(finished, command);
    if (finished.outcome == Outcome::Cancelled)
        return {Texts::tr("The command to group %1 was cancelled.").arg(number), {}};
    if (finished.outcome == Outcome::QueueFull)
        return {Texts::tr("Too many commands are waiting. Nothing was sent to group %1.").arg(number),
                Texts::tr("Wait until they are carried out, or press STOP ALL to discard them.")};
    if (command.action == bus::GroupCommand::Action::StartMotion)
        return startFailed(finished, command.group);
    return {notByAll(command.action).arg(number),
            membersSentence(finished) + u' ' + Texts::tr("No motor was moved.")};
}

/// True for a PIC-I/O that is not the leader of its group: what it latches or puts out by PWM is not read
/// back.
bool followsUnread(ModuleIndex index, const std::vector<ModuleState>& modules) {
    const auto module = std::ranges::find(modules, index, [](const ModuleState& m) { return m.info.index; });
    return module != modules.end() && module->isIo() && !(module->info.group && module->info.group->leader);
}

/// Why all modules stay at the baud rate that they have, and what to do.
QString whyRateKept(const bus::RateChangeFailed& failed) {
    using Reason = bus::RateChangeFailed::Reason;
    const QString modules = listOfModules(failed.modules);
    switch (failed.reason) {
        case Reason::NoSuchRate:
            return Texts::tr("The modules do not support %1 Bd. Choose another baud rate.")
                .arg(rate(failed.wanted));
        case Reason::PortCannot:
            return Texts::tr("This computer's port does not support %1 Bd. Choose another baud rate.")
                .arg(rate(failed.wanted));
        case Reason::NotNow:
            return Texts::tr("A motor is moving, or about to move. Stop all motors, then try again.");
        case Reason::Missing:
            return Texts::tr("Module %1 does not answer and would be left behind. Connect again first.")
                .arg(modules);
        case Reason::GroupsUnknown:
            return Texts::
                tr("Another program may have changed the group of module %1, which would then miss the new baud rate. Set its group again, or restart the network.")
                    .arg(modules);
        case Reason::Leader:
            return Texts::
                tr("Module %1 is a group leader and would answer at the new baud rate. Make it an ordinary member first.")
                    .arg(modules);
        case Reason::NotHeard:
            return Texts::
                tr("Module %2 did not answer at %1 Bd, so all modules went back to the old rate. Try another baud rate, a shorter cable, or termination at both ends.")
                    .arg(rate(failed.wanted), modules);
        case Reason::Interrupted:
            return Texts::tr("A stop took priority.");
    }
    return {};
}

}  // namespace

Message groupFailed(const bus::GroupFinished& finished, const std::vector<ModuleState>& modules) {
    if (const auto* change = std::get_if<bus::GroupChange>(&finished.what))
        return about(
            u"group"_s, change->module,
            {(finished.outcome == bus::Outcome::NoAnswer
                  ? Texts::tr("Module %1 did not confirm its new group, so its group is unknown.")
                  : Texts::tr("Could not change the group of module %1."))
                 .arg(moduleNumber(change->module)),
             Texts::tr(
                 "Nothing was moved. A group has at most one leader, group FF has none, and the groups of all modules must be known. Check this, then try again.")});
    const auto& command = std::get<bus::GroupCommand>(finished.what);
    Words words = commandFailed(finished, command);
    const auto unread = those(finished, bus::MemberOutcome::Unknown);
    if (std::ranges::any_of(unread, [&](ModuleIndex module) { return followsUnread(module, modules); }))
        words.body +=
            u' ' +
            Texts::tr(
                "A PIC-I/O confirms latched inputs and stored PWM values only as the leader: make it the leader of the group.");
    return {.key = u"group%1"_s.arg(command.group),
            .severity = words.severity,
            .headline = words.headline,
            .body = words.body};
}

Message groupCommandedToStop(const bus::GroupFinished& finished) {
    const auto& command = std::get<bus::GroupCommand>(finished.what);
    const bool off = command.action == bus::GroupCommand::Action::MotorOff;
    const QString text = off ? Texts::tr("Group %1 was commanded to switch its motors off: module %2.")
                             : Texts::tr("Group %1 was commanded to stop: module %2.");
    return {.key = u"groupStop%1"_s.arg(command.group),
            .headline = text.arg(groupNumber(command.group),
                                 listOfModules(those(finished, bus::MemberOutcome::Done)))};
}

Message rateChanged(const bus::RateChanged& changed) {
    return {.key = u"rate"_s,
            .headline = Texts::tr("All modules now run at %1 Bd. Positions and gains are unchanged.")
                            .arg(rate(changed.baud))};
}

Message rateNotChanged(const bus::RateChangeFailed& failed) {
    if (!failed.lost.empty())
        return {
            .key = u"rate"_s,
            .severity = Severity::Fault,
            .headline =
                Texts::tr("Module %1 has not answered since the baud rate changed. No motor was moving.")
                    .arg(listOfModules(failed.lost)),
            .body =
                Texts::tr(
                    "It may still be at %1 Bd; the others are at %2 Bd. Scan again. If the module is not found, restart the network: positions and gains are lost.")
                    .arg(rate(failed.wanted), rate(failed.baud)),
            .actions = {scanAgain(), restartNetwork()}};
    return {
        .key = u"rate"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("Could not change the baud rate: the chain stays at %1 Bd. No motor was moved.")
                        .arg(rate(failed.baud)),
        .body = whyRateKept(failed)};
}

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about stops: what was sent a stop, and what is known to have stopped.
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// The modules that did not answer the stop because they have restarted, which has switched their motors
/// off; or the others that did not answer.
std::vector<ModuleIndex> unreached(const bus::StopFinished& finished, const std::vector<ModuleState>& modules,
                                   bool restarted) {
    std::vector<ModuleIndex> some;
    for (const ModuleIndex index : finished.unreached) {
        const ModuleState* module = moduleAt(index, modules);
        if ((module != nullptr && module->hasRestarted) == restarted)
            some.push_back(index);
    }
    return some;
}

/// Which modules are not known to be at rest, and why; empty if all are.
QStringList missing(const bus::StopFinished& finished, const std::vector<ModuleState>& modules) {
    QStringList parts;
    if (const auto silent = unreached(finished, modules, false); !silent.empty())
        parts << Texts::tr("Modules %1 do not answer", nullptr, howMany(silent)).arg(listOfModules(silent));
    if (!finished.unconfirmed.empty())
        parts << Texts::tr("Modules %1 were commanded to stop but were not seen at rest", nullptr,
                           howMany(finished.unconfirmed))
                     .arg(listOfModules(finished.unconfirmed));
    if (!finished.noStopKnown.empty())
        parts << Texts::tr("No stop command is known for modules %1", nullptr, howMany(finished.noStopKnown))
                     .arg(listOfModules(finished.noStopKnown));
    return parts;
}

/// The state of the motors that have stopped: one that holds resists being pushed, one that is off does not.
QString howStopped(const bus::StopFinished& finished, const std::vector<ModuleState>& modules) {
    int holding = 0;
    int switchedOff = 0;
    int wereOff = 0;
    int io = 0;
    for (const ModuleIndex index : finished.stopped) {
        const ModuleState* module = moduleAt(index, modules);
        if (module != nullptr && module->isIo())
            ++io;
        else if (module != nullptr && module->driveOn())
            ++holding;
        else if (std::ranges::find(finished.wereOff, index) != finished.wereOff.end())
            ++wereOff;
        else
            ++switchedOff;
    }
    QStringList parts;
    if (holding > 0)
        parts << Texts::tr("%n stopped and holding", nullptr, holding);
    if (switchedOff > 0)
        parts << Texts::tr("%n switched off", nullptr, switchedOff);
    if (wereOff > 0)
        parts << Texts::tr("%n were off", nullptr, wereOff);
    if (io > 0)
        parts << Texts::tr("%n I/O modules in their stop state", nullptr, io);
    return parts.join(u", "_s);
}

/// Why a jog has ended, and what to do.
Words wordsFor(const bus::HoldExpired& expired) {
    using Reason = bus::HoldExpired::Reason;
    const QString number = moduleNumber(expired.module);
    switch (expired.reason) {
        case Reason::Expired:
            return {
                Texts::tr("Module %1 was commanded to stop jogging: nothing held it for over 250 ms.")
                    .arg(number),
                Texts::tr(
                    "The computer was busy, or the program that jogs it has stopped calling. Press and hold again.")};
        case Reason::NoAnswer:
            return {
                (expired.started
                     ? Texts::tr("Module %1 was commanded to stop jogging: it did not confirm the command.")
                     : Texts::tr("Module %1 did not confirm the command to jog. Nothing was started."))
                    .arg(number),
                Texts::tr(
                    "The command or its answer was lost or garbled: if this recurs, check the cable. Press and hold again.")};
        case Reason::NotPossible:
            return {
                (expired.started
                     ? Texts::tr("Module %1 was commanded to stop jogging: its state no longer permits it.")
                     : Texts::tr("Module %1 cannot jog in its present state. Nothing was started."))
                    .arg(number),
                Texts::tr(
                    "Its state says why: for example, its motor is off. Press and hold again once it may move.")};
        case Reason::GoalChanged:
            return {Texts::tr("Module %1 was commanded to stop jogging: its travel limit has changed.")
                        .arg(number),
                    Texts::tr("Press and hold again to jog within the present limits.")};
    }
    return {};
}

}  // namespace

bool allStopped(const bus::StopFinished& finished, const std::vector<ModuleState>& modules) {
    return !finished.reachedNobody() && missing(finished, modules).isEmpty();
}

Message stopResult(const bus::StopFinished& finished, const std::vector<ModuleState>& modules) {
    const QString stopped = QString::number(finished.stopped.size());
    const QString all = QString::number(finished.stopped.size() + finished.unreached.size() +
                                        finished.unconfirmed.size() + finished.noStopKnown.size());
    QStringList sentences;
    if (const auto off = unreached(finished, modules, true); !off.empty())
        sentences << Texts::tr("Modules %1 are off after a restart.", nullptr, howMany(off))
                         .arg(listOfModules(off));
    if (allStopped(finished, modules)) {
        const auto ms = std::llround(toSeconds(finished.took) * 1000);
        if (!finished.stopped.empty())
            sentences.prepend(
                Texts::tr("%1, %2 ms.").arg(howStopped(finished, modules), QString::number(ms)));
        // A separate key, so that a successful stop does not count as a repeat of one that failed.
        return {
            .key = key::kStopped, .headline = sentences.join(u' '), .relation = Message::Relation::Repeat};
    }
    QStringList parts = missing(finished, modules);
    if (parts.isEmpty())
        parts << Texts::tr("No module is known");
    parts.last() += Texts::tr(": use the hardware stop.");
    const QString first = finished.stopped.empty() ? Texts::tr("No stop was confirmed.")
                                                   : Texts::tr("%1 of %2 stopped.").arg(stopped, all);
    sentences.prepend(first);
    sentences << parts.join(u". "_s);
    return {.key = key::kStop, .severity = Severity::Fault, .headline = sentences.join(u' ')};
}

Message stopWaits() {
    return {.key = key::kStopWaits,
            .severity = Severity::Fault,
            .headline = Texts::tr("No stop can be sent now: use the hardware stop."),
            .body = Texts::tr("It is sent as soon as you connect to the same modules again."),
            .actions = {retry()}};
}

QString stopReach(int reachable, int modules) {
    return Texts::tr("reaches %1 of %2").arg(reachable).arg(modules);
}

QString commandedToStop(const std::vector<ModuleIndex>& modules) {
    return Texts::tr("Modules %1 were commanded to stop.", nullptr, howMany(modules))
        .arg(listOfModules(modules));
}

QString stopConfirmed(const bus::OwedStopConfirmed& confirmed) {
    // These messages are about several modules.
    return confirmed.cause == bus::StopCause::StopAll ||
                   confirmed.cause == bus::StopCause::GroupHalfStarted ||
                   confirmed.cause == bus::StopCause::GroupStop ||
                   confirmed.cause == bus::StopCause::PathEnded ||
                   confirmed.cause == bus::StopCause::ForeignTraffic ||
                   confirmed.cause == bus::StopCause::ConnectionEnded
               ? Texts::tr("Module %1 has stopped.").arg(moduleNumber(confirmed.module))
               : Texts::tr("It has stopped.");
}

Message holdExpired(const bus::HoldExpired& expired) {
    return about(u"hold"_s, expired.module, wordsFor(expired));
}

Message motionSuspect(const bus::MotionSuspect& suspect) {
    const auto suspicion = [&suspect](const QString& headline, const QString& body) {
        return about(
            u"suspect"_s, suspect.module,
            {headline.arg(moduleNumber(suspect.module), grouped(suspect.position)), body, Severity::Fault});
    };
    switch (suspect.reason) {
        case bus::MotionSuspect::Reason::WrongWay:
            return suspicion(
                Texts::tr(
                    "Module %1 was commanded to switch off: one answer reported a move in the wrong direction, to %2 counts."),
                Texts::tr(
                    "If it did, encoder or motor wires are swapped, or the gains make it oscillate. If it did not, the answer was wrong: check the cable."));
        case bus::MotionSuspect::Reason::Overshot:
            return suspicion(
                Texts::tr(
                    "Module %1 was commanded to stop: one answer reported that it went past its goal, to %2 counts."),
                Texts::tr(
                    "Check the position before the next move. If it went there, the command was corrupted in transit, or the gains cause a large overshoot. If it did not, the answer was wrong: check the cable."));
        case bus::MotionSuspect::Reason::Frozen:
            return suspicion(
                Texts::tr(
                    "Module %1 was commanded to stop: it reports motion, but its position stays at %2 counts."),
                Texts::tr("Motor state unknown. Look at the motor; stop all if in doubt."));
    }
    return {};
}

Message foreignTraffic(const bus::ForeignTraffic& traffic) {
    QString headline = Texts::tr("Another host is sending on this line.");
    if (!traffic.commandedToStop.empty())
        headline += u' ' + commandedToStop(traffic.commandedToStop);
    return {
        .key = u"foreign"_s,
        .severity = Severity::Fault,
        .headline = headline,
        .body = Texts::tr(
            "Modules answer commands that this panel did not send; running tasks were cancelled. Close the other program, or disconnect its computer from the line, before you continue.")};
}

Message foreignMotion(const bus::ForeignMotion& motion) {
    return about(
        u"foreign"_s, motion.module,
        {Texts::tr("Module %1 moves without a command from this panel.").arg(moduleNumber(motion.module)),
         Texts::tr(
             "Another host on this line started it, or a load drives it. The panel does not stop it unless you do; the other host may start it again."),
         Severity::Fault},
        {{MessageAction::StopAll, Common::tr("STOP ALL")}});
}

}  // namespace nmc::texts

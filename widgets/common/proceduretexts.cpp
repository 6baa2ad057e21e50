// SPDX-License-Identifier: GPL-3.0-or-later
// What the table of texts has to say of procedures: homing, moves by N, changes of a motion, step responses.
#include <QDir>
#include <cstdlib>

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    QString headline;
    QString body;
    Severity severity = Severity::Attention;
};

/// The motor is free to turn, or nobody knows what it does.
bool freeOrUnknown(ProcedureFailure failure) {
    using enum ProcedureFailure;
    return failure == WentOff || failure == Unstable || failure == ModuleSilent;
}

/// `who`: "Module 1".
Words homingFailed(const ProcedureReport& report, const QString& who, const AxisScale& scale) {
    switch (*report.failure) {
        case ProcedureFailure::SwitchActive:
            return {
                Texts::tr("%1 was stopped: its switch stayed active while it backed off.").arg(who),
                Texts::tr(
                    "The switch may be stuck, or the search goes the wrong way. Move the motor off the switch, or change the direction, then try again.")};
        case ProcedureFailure::NotFound:
            return {
                Texts::tr("%1 stopped before it found home.").arg(who),
                Texts::tr(
                    "A limit or the E-stop input ended its motion. Check the direction of the search and the switches, then try again.")};
        case ProcedureFailure::TravelLimit:
            return {Texts::tr("%1 was stopped: no home within the travel limit.").arg(who),
                    Texts::tr("Check the switch and its cable, the direction of the search, and the limit.")};
        case ProcedureFailure::SoftLimit:
            return {
                Texts::tr("%1 was stopped: no home within its limits of travel, nor where home was.")
                    .arg(who),
                Texts::tr(
                    "Check the switch and its cable, and the direction of the search. If the position is wrong, say so on the page Axis (Position in doubt): the search then goes by its own travel limit.")};
        case ProcedureFailure::TimeLimit:
            return {
                Texts::tr("%1 was stopped: no home within the time limit.").arg(who),
                Texts::tr(
                    "Check the switch and its cable, the direction and the speed of the search, and the limit.")};
        case ProcedureFailure::LinkSuspect:
            return {
                Texts::tr("%1 is not homed and was told to stop: the link was in doubt meanwhile.").arg(who),
                Texts::tr(
                    "What was said of home then may be wrong. See to the link, then repeat the search.")};
        case ProcedureFailure::ModuleSilent:
            return {Texts::tr("%1 is not homed and does not answer. Motor state unknown.").arg(who),
                    Texts::tr("It was told to stop. Use the hardware stop if it moves."), Severity::Fault};
        case ProcedureFailure::WentOff:
            return {
                Texts::tr("%1 is not homed: its motor went off by itself, and is free to turn.").arg(who),
                Texts::tr(
                    "The motor was too far from where it should be, or lost its power. Check for a jam, enable it, then repeat the search."),
                Severity::Fault};
        case ProcedureFailure::Refused:
            return {
                Texts::tr(
                    "%1 is not homed and was told to stop: a command was not carried out, or its answer was lost.")
                    .arg(who),
                Texts::tr("Usually noise on the cable. Repeat the search.")};
        case ProcedureFailure::ReadingsDiffer:
            return {Texts::tr("%1 stands still and is not homed: two readings of its home differ.").arg(who),
                    Texts::tr("Usually noise on the cable. Repeat the search.")};
        case ProcedureFailure::NotStill:
        case ProcedureFailure::Unstable:
        case ProcedureFailure::Swings:
        case ProcedureFailure::StoppedShort:
        case ProcedureFailure::NotStarted:
        case ProcedureFailure::UnderRun:
        case ProcedureFailure::OffPath:
            return {};  // of others
        case ProcedureFailure::NotAtHome:
            return {
                Texts::tr("%1 has found its home and holds close to it, but nothing was made zero.").arg(who),
                Texts::tr(
                    "It rests %1 off its home, and zero would be off by as much: friction keeps it there. Raise Ki and IL on the page Gains, or clear \"Make it zero\" on the page Homing. What is close enough follows from the unit on the page Axis.")
                    .arg(position(scale, std::abs(report.offHome)))};
    }
    return {};
}

Words stepResponseFailed(ProcedureFailure failure, const QString& who) {
    switch (failure) {
        case ProcedureFailure::TravelLimit:
            return {
                Texts::tr("%1 holds again: it went the wrong way, or farther than twice its step.").arg(who),
                Texts::tr(
                    "The servo swings, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.")};
        case ProcedureFailure::Unstable:
            return {
                Texts::tr("%1 was switched off and is free to turn: it did not calm down after its step.")
                    .arg(who),
                Texts::tr(
                    "The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it."),
                Severity::Fault};
        case ProcedureFailure::NotStill:
            return {
                Texts::tr("%1 does not stand still; its servo stays on.").arg(who),
                Texts::tr(
                    "It swings, or is turned from outside. Lower Kp and Ki, or raise Kd; Motor off ends it at once.")};
        case ProcedureFailure::WentOff:
            return {
                Texts::tr("%1 made no whole step: its motor went off by itself, and is free to turn.")
                    .arg(who),
                Texts::tr(
                    "The motor was too far from where it should be, or lost its power. Check for a jam, raise EL or make the step shorter, then enable it."),
                Severity::Fault};
        case ProcedureFailure::ModuleSilent:
            return {
                Texts::tr("%1 does not answer, so its step is not recorded. Motor state unknown.").arg(who),
                Texts::tr("It was told to hold. Use the hardware stop if it moves."), Severity::Fault};
        case ProcedureFailure::LinkSuspect:
            return {Texts::tr(
                        "%1 was told to hold, and its step is not recorded: the link was in doubt meanwhile.")
                        .arg(who),
                    Texts::tr("See to the link, then step again.")};
        case ProcedureFailure::Refused:
            return {
                Texts::tr(
                    "%1 has no step recorded and was told to hold: a command was not carried out, or its answer was lost.")
                    .arg(who),
                Texts::tr("Usually noise on the cable. Step again.")};
        case ProcedureFailure::SwitchActive:
        case ProcedureFailure::NotFound:
        case ProcedureFailure::TimeLimit:
        case ProcedureFailure::SoftLimit:
        case ProcedureFailure::ReadingsDiffer:
        case ProcedureFailure::NotAtHome:
        case ProcedureFailure::Swings:
        case ProcedureFailure::StoppedShort:
        case ProcedureFailure::NotStarted:
        case ProcedureFailure::UnderRun:
        case ProcedureFailure::OffPath:
            return {};  // of others
    }
    return {};
}

Words tryFailed(ProcedureFailure failure, const QString& who) {
    switch (failure) {
        case ProcedureFailure::Swings:
            return {Texts::tr("%1 has the gains from before again: it began to swing.").arg(who),
                    Texts::tr("Lower Kp and Ki, or raise Kd, then try again.")};
        case ProcedureFailure::TravelLimit:
            return {
                Texts::tr("%1 has the gains from before again: it left the place where it stood.").arg(who),
                Texts::tr("These gains do not hold its load, or something else turned it.")};
        case ProcedureFailure::WentOff:
            return {Texts::tr("%1 went off by itself while gains were tried, and is free to turn.").arg(who),
                    Texts::tr("The gains from before were sent again. Check for a jam, then enable it."),
                    Severity::Fault};
        case ProcedureFailure::ModuleSilent:
            return {Texts::tr("%1 does not answer while gains are tried. Motor state unknown.").arg(who),
                    Texts::tr("The gains from before were sent. Use the hardware stop if it moves."),
                    Severity::Fault};
        case ProcedureFailure::LinkSuspect:
            return {Texts::tr("%1 was sent the gains from before: the link was in doubt meanwhile.").arg(who),
                    Texts::tr("See to the link, then try again.")};
        case ProcedureFailure::Refused:
            return {
                Texts::tr(
                    "%1 was sent the gains from before: a command was not carried out, or its answer was lost.")
                    .arg(who),
                Texts::tr("Usually noise on the cable. Try again.")};
        case ProcedureFailure::SwitchActive:
        case ProcedureFailure::NotFound:
        case ProcedureFailure::TimeLimit:
        case ProcedureFailure::SoftLimit:
        case ProcedureFailure::ReadingsDiffer:
        case ProcedureFailure::NotStill:
        case ProcedureFailure::Unstable:
        case ProcedureFailure::NotAtHome:
        case ProcedureFailure::StoppedShort:
        case ProcedureFailure::NotStarted:
        case ProcedureFailure::UnderRun:
        case ProcedureFailure::OffPath:
            return {};  // of others
    }
    return {};
}

Words directionFailed(ProcedureFailure failure, const QString& who) {
    const QString off = Texts::tr("%1 has no verdict on its direction, and its motor is off.").arg(who);
    const QString told =
        Texts::tr("%1 has no verdict on its direction, and its motor was told to switch off.").arg(who);
    switch (failure) {
        case ProcedureFailure::TravelLimit:
            return {
                off,
                Texts::tr(
                    "It was turned farther than the check allows: something else turns it, or it runs on for long. See that it stands still, then check again.")};
        case ProcedureFailure::NotStill:
            return {
                off,
                Texts::tr(
                    "It does not stand still although nothing drives it. See what turns it, then check again.")};
        case ProcedureFailure::LinkSuspect:
            return {told, Texts::tr("The link was in doubt meanwhile. See to the link, then check again.")};
        case ProcedureFailure::ModuleSilent:
            return {Texts::tr("%1 has no verdict on its direction and does not answer. Motor state unknown.")
                        .arg(who),
                    Texts::tr("It was told to switch off. Use the hardware stop if it moves."),
                    Severity::Fault};
        case ProcedureFailure::Refused:
            return {told, Texts::tr("A command was not carried out, or its answer was lost. Check again.")};
        case ProcedureFailure::SwitchActive:
        case ProcedureFailure::NotFound:
        case ProcedureFailure::TimeLimit:
        case ProcedureFailure::SoftLimit:
        case ProcedureFailure::WentOff:
        case ProcedureFailure::ReadingsDiffer:
        case ProcedureFailure::Unstable:
        case ProcedureFailure::NotAtHome:
        case ProcedureFailure::Swings:
        case ProcedureFailure::StoppedShort:
        case ProcedureFailure::NotStarted:
        case ProcedureFailure::UnderRun:
        case ProcedureFailure::OffPath:
            return {};  // of other kinds
    }
    return {};
}

/// Which axis it was, the modules tell.
QString pathFailure(ProcedureFailure failure) {
    if (failure != ProcedureFailure::StoppedShort)
        return procedureFailure(failure);
    return Texts::tr(
        "A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of "
        "the path were told to stop.");
}

/// `who`: "Module 1".
QString directionHeadline(const DirectionFound& found, const QString& who) {
    switch (found.verdict) {
        case DirectionVerdict::Right:
            return Texts::tr("%1: motor and encoder go the same way.").arg(who);
        case DirectionVerdict::Reversed:
            return Texts::tr("%1: motor or encoder is reversed. Do not enable it.").arg(who);
        case DirectionVerdict::NoMovement:
            return Texts::tr("%1 did not move when it was pushed.").arg(who);
        case DirectionVerdict::LimitClosed:
            return Texts::tr("%1 closed a limit switch, so it was not pushed on.").arg(who);
        case DirectionVerdict::NoPower:
            return Texts::tr("%1 lost its motor power while it was pushed.").arg(who);
        case DirectionVerdict::Unclear:
            return Texts::tr("%1 did not move one way and the other.").arg(who);
    }
    return {};
}

QString homingStage(ProcedureStage stage) {
    switch (stage) {
        case ProcedureStage::Preparing:
            return Texts::tr("Preparing");
        case ProcedureStage::BackingOff:
            return Texts::tr("Backing off from the active switch");
        case ProcedureStage::Searching:
            return Texts::tr("Searching");
        case ProcedureStage::SearchingIndex:
            return Texts::tr("Searching the index");
        case ProcedureStage::Stopping:
            return Texts::tr("Stopping");
        case ProcedureStage::Reading:
            return Texts::tr("Reading home twice");
        case ProcedureStage::GoingHome:
            return Texts::tr("Going to home");
        case ProcedureStage::Zeroing:
            return Texts::tr("Making home zero");
        case ProcedureStage::TakingUpBacklash:
            return Texts::tr("Taking up backlash");
        case ProcedureStage::Moving:
            return Texts::tr("Moving");
        case ProcedureStage::Pausing:
            return Texts::tr("Pausing");
        case ProcedureStage::Trying:
            return Texts::tr("Trying gains");
        case ProcedureStage::Done:
            return Texts::tr("Done");
        case ProcedureStage::Failed:
            return Texts::tr("Failed");
        case ProcedureStage::Cancelled:
            return Texts::tr("Cancelled");
    }
    return {};
}

}  // namespace

std::optional<Message> procedureEnded(const ProcedureReport& report, const AxisScale& scale) {
    const QString who = moduleName(report.module);
    Message message{.key = ofModule(u"procedure"_s, report.module), .module = report.module};
    if (report.stage == ProcedureStage::Failed && report.failure) {
        Words words;
        if (report.kind == ProcedureKind::Homing)
            words = homingFailed(report, who, scale);
        else if (report.kind == ProcedureKind::StepResponse)
            words = stepResponseFailed(*report.failure, who);
        else if (report.kind == ProcedureKind::SquareWave || report.kind == ProcedureKind::FrequencyResponse)
            words = {Texts::tr("%1: the test of its loop has ended early.").arg(who),
                     loopTestFailure(*report.failure),
                     freeOrUnknown(*report.failure) ? Severity::Fault : Severity::Attention};
        else if (report.kind == ProcedureKind::TryGains)
            words = tryFailed(*report.failure, who);
        else if (report.kind == ProcedureKind::DirectionCheck)
            words = directionFailed(*report.failure, who);
        else if (report.kind == ProcedureKind::FollowPath)
            words = {Texts::tr("%1 has not finished its path.").arg(who), pathFailure(*report.failure),
                     freeOrUnknown(*report.failure) ? Severity::Fault : Severity::Attention};
        else
            words = {Texts::tr("%1 has not finished its moves.").arg(who), procedureFailure(*report.failure)};
        message.headline = words.headline;
        message.body = words.body;
        message.severity = words.severity;
        return message;
    }
    if (report.stage == ProcedureStage::Done && report.kind == ProcedureKind::DirectionCheck &&
        report.direction) {
        message.headline = directionHeadline(*report.direction, who);
        message.body = directionFound(*report.direction);
        message.severity =
            report.direction->verdict == DirectionVerdict::Right ? Severity::Normal : Severity::Attention;
        return message;
    }
    if (report.stage == ProcedureStage::Done && report.kind == ProcedureKind::TryGains && !report.kept) {
        message.headline = Texts::tr("%1 has the gains from before again: the try is over.").arg(who);
        return message;
    }
    if (report.stage != ProcedureStage::Done || report.kind != ProcedureKind::Homing || !report.home)
        return std::nullopt;
    message.headline =
        Texts::tr("%1 has found its home: it was at %2.").arg(who, position(scale, *report.home));
    if (report.offHome != 0)
        message.body = Texts::tr("It rests %1 off its home, and is zero there.")
                           .arg(position(scale, std::abs(report.offHome)));
    return message;
}

QString loopTestFailure(ProcedureFailure failure) {
    if (failure != ProcedureFailure::TravelLimit)
        return procedureFailure(failure);
    return Texts::tr(
        "The motor went farther than the test allows, and was told to hold. Look for a load that pulls it, or choose gentler gains.");
}

QString procedureStage(const ProcedureReport& report) {
    const QString stage = homingStage(report.stage);
    if (report.rounds < 2 || report.over())
        return stage;
    return Texts::tr("%1, %2 of %3").arg(stage).arg(report.round).arg(report.rounds);
}

QString procedureFailure(ProcedureFailure failure) {
    switch (failure) {
        case ProcedureFailure::SwitchActive:
            return Texts::tr("The switch stayed active while the motor backed off. It was stopped.");
        case ProcedureFailure::NotFound:
            return Texts::tr("The motion ended before home was found.");
        case ProcedureFailure::TravelLimit:
            return Texts::tr("The travel limit was reached. The motor was stopped.");
        case ProcedureFailure::TimeLimit:
            return Texts::tr("The time limit was reached. The motor was stopped.");
        case ProcedureFailure::SoftLimit:
            return Texts::tr("The way on leads beyond the limits of travel. The motor was stopped.");
        case ProcedureFailure::LinkSuspect:
            return Texts::tr("The link was in doubt meanwhile. The motor was told to stop.");
        case ProcedureFailure::ModuleSilent:
            return Texts::tr("The module does not answer. Motor state unknown.");
        case ProcedureFailure::WentOff:
            return Texts::tr("The motor went off by itself, and is free to turn.");
        case ProcedureFailure::Refused:
            return Texts::tr("A command was not carried out or not answered. The motor was told to stop.");
        case ProcedureFailure::ReadingsDiffer:
            return Texts::tr("Two readings of home differ. The motor stands still.");
        case ProcedureFailure::NotStill:
            return Texts::tr(
                "The motor does not stand still; its servo stays on. Lower the gains, or switch it off.");
        case ProcedureFailure::Unstable:
            return Texts::tr(
                "The motor swung by more than the whole step and did not calm down, so it was switched off and is free to turn. Lower Kp and Ki, or raise Kd.");
        case ProcedureFailure::StoppedShort:
            return Texts::tr(
                "A limit switch, heat or the E-stop input ended the move. The motor stands still.");
        case ProcedureFailure::Swings:
            return Texts::tr("The motor began to swing. The gains from before are back.");
        case ProcedureFailure::NotAtHome:
            return Texts::tr("It rests too far from its home for a zero. See Ki and IL on the page Gains.");
        case ProcedureFailure::NotStarted:
            return Texts::tr("The path was not started by all of its axes. They were told to stop.");
        case ProcedureFailure::UnderRun:
            return Texts::tr(
                "The points of the path did not come in time, so the motor stopped at the last one it had.");
        case ProcedureFailure::OffPath:
            return Texts::tr("The motor was not led where the path goes. It was told to stop.");
    }
    return {};
}

QString directionFound(const DirectionFound& found) {
    constexpr double kWhole = 255.0;
    const int percent = qRound(found.strongestPush * 100.0 / kWhole);
    switch (found.verdict) {
        case DirectionVerdict::Right:
            return Texts::tr("All right: driven forward it counts up, in reverse down. It can be enabled.");
        case DirectionVerdict::Reversed:
            return Texts::tr(
                "Reversed: driven forward it counts down. Enabled like this it would run away. Swap the motor's two leads, or the encoder's A and B, then check again.");
        case DirectionVerdict::NoMovement:
            return Texts::tr(
                       "No movement with %1 % of the supply, and motor power is there: look for a jam or a brake, at the cables of motor and encoder, or for a load that is too heavy.")
                       .arg(percent) +
                   (found.limit1 || found.limit2
                        ? u' ' +
                              Texts::tr(
                                  "A limit input is active: it may stand in a switch that takes its power away.")
                        : QString());
        case DirectionVerdict::LimitClosed:
            return (found.limit1 ? Texts::tr("Limit 1 closed on the way.")
                                 : Texts::tr("Limit 2 closed on the way.")) +
                   u' ' + Texts::tr("Turn the motor away from its end by hand, then check again.");
        case DirectionVerdict::NoPower:
            return Texts::tr("Motor power went away. Switch it on, then check again.");
        case DirectionVerdict::Unclear:
            return Texts::tr(
                "Not clear: it moved one way only, or the same way twice. Something blocks or turns it. Turn it away from its end by hand, take the load off, then check again.");
    }
    return {};
}

}  // namespace nmc::texts

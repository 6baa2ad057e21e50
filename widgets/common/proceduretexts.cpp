// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about procedures: homing, moves by N, changes of a motion, direction checks.
#include <cstdlib>

#include "widgets/common/looptesttexts.h"
#include "widgets/common/pathtexts.h"
#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// `who`: "Module 1".
Words homingFailed(const ProcedureReport& report, const QString& who, const AxisScale& scale) {
    if (*report.failure == ProcedureFailure::SwitchActive)
        return {
            Texts::tr("%1 was stopped: its switch stayed active while backing off.").arg(who),
            Texts::tr(
                "The switch may be stuck, or the search direction is wrong. Move the motor off the switch, or change the direction, then try again.")};
    if (*report.failure == ProcedureFailure::NotFound)
        return {
            Texts::tr("%1 stopped before it found home.").arg(who),
            Texts::tr(
                "A limit switch or the E-stop input ended the motion. Check the search direction and the switches, then try again.")};
    if (*report.failure == ProcedureFailure::TravelLimit)
        return {Texts::tr("%1 was stopped: home not found within the search distance.").arg(who),
                Texts::tr("Check the switch and its cable, the search direction and the search distance.")};
    if (*report.failure == ProcedureFailure::SoftLimit)
        return {
            Texts::tr(
                "%1 was stopped: home not found within its travel limits or at its last known position.")
                .arg(who),
            Texts::tr(
                "Check the switch and its cable, and the search direction. If the position is wrong, choose Position in doubt on the Axis page: the next search then uses only its search distance.")};
    if (*report.failure == ProcedureFailure::TimeLimit)
        return {
            Texts::tr("%1 was stopped: home not found within the time limit.").arg(who),
            Texts::tr(
                "Check the switch and its cable, the search direction and velocity, and the time limit.")};
    if (*report.failure == ProcedureFailure::LinkSuspect)
        return {Texts::tr("%1 is not homed and was commanded to stop: the link was unreliable.").arg(who),
                Texts::tr("The home position found may be wrong. Check the link, then repeat the search.")};
    if (*report.failure == ProcedureFailure::ModuleUnresponsive)
        return {Texts::tr("%1 is not homed and does not answer. Motor state unknown.").arg(who),
                Texts::tr("It was commanded to stop. Use the hardware stop if it moves."), Severity::Fault};
    if (*report.failure == ProcedureFailure::WentOff)
        return {
            Texts::tr("%1 is not homed: its motor switched itself off and is free to turn.").arg(who),
            Texts::tr(
                "The position error was too large, or motor power failed. Check for a jam, enable the motor, then repeat the search."),
            Severity::Fault};
    if (*report.failure == ProcedureFailure::Refused)
        return {
            Texts::tr("%1 is not homed and was commanded to stop: a command failed, or its answer was lost.")
                .arg(who),
            Texts::tr("Usually noise on the cable. Repeat the search.")};
    if (*report.failure == ProcedureFailure::ReadingsDiffer)
        return {Texts::tr("%1 is at rest but not homed: two readings of home differ.").arg(who),
                Texts::tr("Usually noise on the cable. Repeat the search.")};
    if (*report.failure == ProcedureFailure::NotAtHome)
        return {
            Texts::tr("%1 found home and holds close to it, but the position was not set to 0.").arg(who),
            Texts::tr(
                "Friction holds it %1 off home, too far to set the position to 0. Raise Ki and IL on the Gains page, or clear \"Set position to 0\" on the Homing page. The tolerance follows from the unit on the Axis page.")
                .arg(distance(scale, std::abs(report.offHome)))};
    return {Texts::tr("%1 stopped before it found home.").arg(who), procedureFailure(*report.failure)};
}

Words directionFailed(ProcedureFailure failure, const QString& who) {
    const QString off = Texts::tr("Direction check of %1 inconclusive; its motor is off.").arg(who);
    const QString headline =
        Texts::tr("Direction check of %1 inconclusive; its motor was commanded to switch off.").arg(who);
    if (failure == ProcedureFailure::TravelLimit)
        return {
            off,
            Texts::tr(
                "It turned farther than the check allows: something else turns it, or it coasts for a long time. Wait until it is at rest, then check again.")};
    if (failure == ProcedureFailure::NotStill)
        return {
            off,
            Texts::tr(
                "It does not come to rest although nothing drives it. Find what turns it, then check again.")};
    if (failure == ProcedureFailure::LinkSuspect)
        return {headline,
                Texts::tr("The link was unreliable. Check the link, then repeat the direction check.")};
    if (failure == ProcedureFailure::ModuleUnresponsive)
        return {Texts::tr("Direction check of %1 inconclusive: it does not answer. Motor state unknown.")
                    .arg(who),
                Texts::tr("It was commanded to switch off. Use the hardware stop if it moves."),
                Severity::Fault};
    if (failure == ProcedureFailure::Refused)
        return {headline, Texts::tr("A command failed, or its answer was lost. Repeat the direction check.")};
    return {headline, procedureFailure(failure)};
}

/// `who`: "Module 1".
QString directionHeadline(const DirectionFound& found, const QString& who) {
    switch (found.verdict) {
        case DirectionVerdict::Right:
            return Texts::tr("%1: motor and encoder directions match.").arg(who);
        case DirectionVerdict::Reversed:
            return Texts::tr("%1: motor or encoder is reversed. Do not enable it.").arg(who);
        case DirectionVerdict::NoMovement:
            return Texts::tr("%1 did not move when driven.").arg(who);
        case DirectionVerdict::LimitClosed:
            return Texts::tr("%1 closed a limit switch; the check has ended.").arg(who);
        case DirectionVerdict::NoPower:
            return Texts::tr("%1 lost motor power while being driven.").arg(who);
        case DirectionVerdict::Unclear:
            return Texts::tr("%1 did not move in both directions.").arg(who);
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
            return Texts::tr("Searching for the index");
        case ProcedureStage::Stopping:
            return Texts::tr("Stopping");
        case ProcedureStage::Reading:
            return Texts::tr("Verifying home");
        case ProcedureStage::GoingHome:
            return Texts::tr("Going to home");
        case ProcedureStage::Zeroing:
            return Texts::tr("Setting position to 0");
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

/// `who`: "Module 1".
Words failed(const ProcedureReport& report, const QString& who, const AxisScale& scale) {
    const ProcedureFailure failure = *report.failure;
    const Severity severity = freeOrUnknown(failure) ? Severity::Fault : Severity::Attention;
    if (report.kind == ProcedureKind::Homing)
        return homingFailed(report, who, scale);
    if (isTest(report.kind))
        return testFailed(report, who);
    if (report.kind == ProcedureKind::DirectionCheck)
        return directionFailed(failure, who);
    if (report.kind == ProcedureKind::Repeatability)
        return {Texts::tr("%1 did not finish its approaches.").arg(who), repeatabilityFailure(failure),
                severity};
    if (report.kind == ProcedureKind::FollowPath)
        return {Texts::tr("%1 has not finished its path.").arg(who), pathFailure(failure), severity};
    return {Texts::tr("%1 did not finish its moves.").arg(who), procedureFailure(failure)};
}

}  // namespace

std::optional<Message> procedureEnded(const ProcedureReport& report, const AxisScale& scale) {
    const QString who = moduleName(report.module);
    const auto ended = [&report](const Words& words) { return about(key::kProcedure, report.module, words); };
    if (report.stage == ProcedureStage::Failed && report.failure)
        return ended(failed(report, who, scale));
    if (report.stage != ProcedureStage::Done)
        return std::nullopt;
    if (report.kind == ProcedureKind::DirectionCheck && report.direction)
        return ended(
            {directionHeadline(*report.direction, who), directionFound(*report.direction),
             report.direction->verdict == DirectionVerdict::Right ? Severity::Normal : Severity::Attention});
    if (report.kind == ProcedureKind::TryGains && !report.kept)
        return ended({Texts::tr("The previous gains of %1 are restored: the trial has ended.").arg(who),
                      {},
                      Severity::Normal});
    if (report.kind != ProcedureKind::Homing || !report.home)
        return std::nullopt;
    return ended({Texts::tr("%1 found home at %2.").arg(who, position(scale, *report.home)),
                  report.offHome == 0 ? QString()
                                      : Texts::tr("It is at rest %1 from home; its position there is 0.")
                                            .arg(distance(scale, std::abs(report.offHome))),
                  Severity::Normal});
}

QString procedureStage(const ProcedureReport& report) {
    const bool captured =
        report.kind == ProcedureKind::Repeatability && report.stage == ProcedureStage::Reading;
    const QString stage = captured ? Texts::tr("Reading the captured position") : homingStage(report.stage);
    if (report.rounds < 2 || report.over())
        return stage;
    return Texts::tr("%1, %2 of %3").arg(stage).arg(report.round).arg(report.rounds);
}

QString procedureFailure(ProcedureFailure failure) {
    switch (failure) {
        case ProcedureFailure::SwitchActive:
            return Texts::tr("The switch stayed active while the motor backed off. The motor was stopped.");
        case ProcedureFailure::NotFound:
            return Texts::tr(
                "The motion ended before home was found. Check the search direction and the switches.");
        case ProcedureFailure::TravelLimit:
            return Texts::tr("No home within the search distance. The motor was stopped.");
        case ProcedureFailure::TimeLimit:
            return Texts::tr("No home within the time limit. The motor was stopped.");
        case ProcedureFailure::SoftLimit:
            return Texts::tr("The move would exceed the travel limits. The motor was stopped.");
        case ProcedureFailure::LinkSuspect:
            return Texts::tr("The link was unreliable. The motor was commanded to stop.");
        case ProcedureFailure::ModuleUnresponsive:
            return Texts::tr("The module does not answer. Motor state unknown.");
        case ProcedureFailure::WentOff:
            return Texts::tr("The motor switched itself off and is free to turn.");
        case ProcedureFailure::Refused:
            return Texts::tr("A command failed or was not answered. The motor was commanded to stop.");
        case ProcedureFailure::ReadingsDiffer:
            return Texts::tr("Two readings of home differ. The motor is at rest.");
        case ProcedureFailure::NotStill:
            return Texts::tr(
                "The motor does not come to rest; its servo stays on. Lower the gains, or switch the motor off.");
        case ProcedureFailure::Unstable:
            return Texts::tr(
                "The motor kept oscillating by more than the whole step. It was switched off and is free to turn. Lower Kp and Ki, or raise Kd.");
        case ProcedureFailure::StoppedShort:
            return Texts::tr(
                "A limit switch, overheating or the E-stop input ended the move. The motor is at rest.");
        case ProcedureFailure::Swings:
            return Texts::tr("The motor began to oscillate. The previous gains are restored.");
        case ProcedureFailure::Saturates:
            return Texts::tr("The output reached its limit. The previous gains are restored.");
        case ProcedureFailure::NotAtHome:
            return Texts::tr(
                "It rests too far from home to set the position to 0. Raise Ki and IL on the Gains page.");
        case ProcedureFailure::NotStarted:
            return Texts::tr("Not all axes started the path. All of them were commanded to stop.");
        case ProcedureFailure::UnderRun:
            return Texts::tr("The path points did not arrive in time, so the motor stopped at the last one.");
        case ProcedureFailure::OffPath:
            return Texts::tr("The command position left the path. The motor was commanded to stop.");
        case ProcedureFailure::NotFollowing:
            return Texts::tr(
                "The motor did not follow the sine wave, and was commanded to hold. Check for a jam, a hard stop, a slipping coupling or missing motor power, or use another amplitude.");
        case ProcedureFailure::Reversed:
            return Texts::tr(
                "The motor swung so far that it reversed, and was commanded to hold. Raise the speed, or lower the amplitude.");
        case ProcedureFailure::Bounced:
            return Texts::tr(
                "The switch changed again while the motor stopped beyond it: it bounces, or its cam is too short. The motor is at rest. Move more slowly, or raise the acceleration.");
    }
    return {};
}

QString repeatabilityFailure(ProcedureFailure failure) {
    if (failure == ProcedureFailure::TravelLimit || failure == ProcedureFailure::TimeLimit)
        return Texts::tr(
            "The switch or index did not change within the search distance and the time limit. It may be stuck, closed on both sides, or in the other direction; above 1 count per tick, an index can be missed. The motor was stopped.");
    if (failure == ProcedureFailure::SoftLimit)
        return Texts::tr(
            "The switch or index did not change within the travel limits. The motor was stopped.");
    if (failure == ProcedureFailure::NotFound)
        return Texts::tr(
            "A limit switch or the E-stop input ended the motion before the switch changed. The motor is at rest.");
    return procedureFailure(failure);
}

QString directionFound(const DirectionFound& found) {
    constexpr double kWhole = 255.0;
    const int percent = qRound(found.strongestPush * 100.0 / kWhole);
    switch (found.verdict) {
        case DirectionVerdict::Right:
            return Texts::tr("OK: it counts up when driven forward and down in reverse. You can enable it.");
        case DirectionVerdict::Reversed:
            return Texts::tr(
                "Reversed: it counts down when driven forward and would run away when enabled. Swap the two motor leads, or encoder A and B, then check again.");
        case DirectionVerdict::NoMovement:
            return Texts::tr(
                       "No movement at %1 % of the supply, with motor power present. Check for a jam, a brake or too heavy a load, and check the motor and encoder cables.")
                       .arg(percent) +
                   (found.limit1 || found.limit2
                        ? u' ' + Texts::tr("A limit switch is active: it may cut the motor's power.")
                        : QString());
        case DirectionVerdict::LimitClosed:
            return (found.limit1 ? Texts::tr("Limit switch 1 closed during the move.")
                                 : Texts::tr("Limit switch 2 closed during the move.")) +
                   u' ' +
                   Texts::tr("Turn the motor away from the end of its travel by hand, then check again.");
        case DirectionVerdict::NoPower:
            return Texts::tr("Motor power failed. Switch it on, then check again.");
        case DirectionVerdict::Unclear:
            return Texts::tr(
                "Unclear: it moved in one direction only, or twice in the same direction. Something blocks or turns it. Remove the load, turn the motor away from the end of its travel by hand, then check again.");
    }
    return {};
}

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about step responses, square waves, frequency responses and gain trials.
#include "widgets/common/looptesttexts.h"

namespace nmc::texts {

namespace {

QString limitStopAdvice() {
    return Texts::tr(
        "A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.");
}

QString wrongWayAdvice() {
    return Texts::tr("If it moved the wrong way, run the direction check on the Axis page.");
}

/// What to do after a square wave or a frequency response has failed; follows the reason.
QString testAdvice(ProcedureFailure failure) {
    if (failure == ProcedureFailure::WentOff)
        return Texts::tr(
            "The position error was too large, or motor power failed. Check for a jam, raise EL or make the test smaller, then enable the motor.");
    if (failure == ProcedureFailure::Unstable)
        return wrongWayAdvice();
    if (failure == ProcedureFailure::ModuleUnresponsive)
        return Texts::tr("It was commanded to hold. Use the hardware stop if it moves.");
    if (failure == ProcedureFailure::LinkSuspect)
        return Texts::tr("Check the link, then start the test again.");
    if (failure == ProcedureFailure::Refused)
        return Texts::tr("Usually noise on the cable. Start the test again.");
    return {};
}

/// `who`: "Module 1".
Words endedEarly(ProcedureFailure failure, const QString& who) {
    return {Texts::tr("The loop test of %1 ended early.").arg(who), loopTestFailure(failure),
            freeOrUnknown(failure) ? Severity::Fault : Severity::Attention};
}

Words responseFailed(ProcedureFailure failure, const QString& who) {
    if (failure == ProcedureFailure::TravelLimit)
        return {
            Texts::tr("%1 was stopped and holds: it moved the wrong way, or by more than twice the step.")
                .arg(who),
            Texts::tr(
                "The servo oscillates, or something else turns the motor. Lower Kp and Ki, or raise Kd, then step again.") +
                u' ' + wrongWayAdvice()};
    if (failure == ProcedureFailure::Unstable)
        return {
            Texts::tr("%1 was switched off and is free to turn: it kept oscillating after its step.")
                .arg(who),
            Texts::tr(
                "The servo is not stable with these gains. Lower Kp and Ki, or raise Kd, apply them, then enable it.") +
                u' ' + wrongWayAdvice(),
            Severity::Fault};
    if (failure == ProcedureFailure::NotStill)
        return {
            Texts::tr("%1 does not come to rest; its servo stays on.").arg(who),
            Texts::tr(
                "It oscillates, or an external force turns it. Lower Kp and Ki, or raise Kd. Choose Motor off to end it at once.")};
    if (failure == ProcedureFailure::StoppedShort)
        return {Texts::tr("%1 did not complete its step: its limit stop ended it.").arg(who),
                limitStopAdvice()};
    if (failure == ProcedureFailure::WentOff)
        return {
            Texts::tr("%1 did not complete its step: its motor switched itself off and is free to turn.")
                .arg(who),
            Texts::tr(
                "The position error was too large, or motor power failed. Check for a jam, raise EL or shorten the step, then enable the motor."),
            Severity::Fault};
    if (failure == ProcedureFailure::ModuleUnresponsive)
        return {Texts::tr("%1 does not answer, so its step was not recorded. Motor state unknown.").arg(who),
                Texts::tr("It was commanded to hold. Use the hardware stop if it moves."), Severity::Fault};
    if (failure == ProcedureFailure::LinkSuspect)
        return {Texts::tr("%1 was commanded to hold, and its step was not recorded: the link was unreliable.")
                    .arg(who),
                Texts::tr("Check the link, then step again.")};
    if (failure == ProcedureFailure::Refused)
        return {
            Texts::tr(
                "%1 was commanded to hold, and its step was not recorded: a command failed, or its answer was lost.")
                .arg(who),
            Texts::tr("Usually noise on the cable. Step again.")};
    return endedEarly(failure, who);
}

Words tryFailed(const ProcedureReport& report, const QString& who) {
    const ProcedureFailure failure = *report.failure;
    if (failure == ProcedureFailure::Swings)
        return {Texts::tr("The previous gains of %1 are restored: it began to oscillate.").arg(who),
                Texts::tr("Lower Kp and Ki, or raise Kd, then try again.")};
    if (failure == ProcedureFailure::Saturates)
        return {Texts::tr("The previous gains of %1 are restored: its output reached the limit OL.").arg(who),
                Texts::tr("It oscillates, or was pushed. Lower Kp, or raise Kd, then try again.")};
    if (failure == ProcedureFailure::TravelLimit)
        return {Texts::tr("The previous gains of %1 are restored: it left its position.").arg(who),
                Texts::tr("These gains do not hold its load, or something else turned it.")};
    if (failure == ProcedureFailure::WentOff)
        return {
            Texts::tr("%1 switched itself off while gains were being tried, and is free to turn.").arg(who),
            Texts::tr("Its previous gains were sent again. Check for a jam, then enable it."),
            Severity::Fault};
    if (failure == ProcedureFailure::ModuleUnresponsive)
        return {Texts::tr("%1 does not answer while gains are being tried. Motor state unknown.").arg(who),
                Texts::tr("Its previous gains were sent. Use the hardware stop if it moves."),
                Severity::Fault};
    if (report.kept)
        return {Texts::tr("The new gains of %1 are in force; OL may still be lowered.").arg(who),
                Texts::tr("A command failed, or its answer was lost. Apply the gains again.")};
    if (failure == ProcedureFailure::LinkSuspect)
        return {Texts::tr("The previous gains of %1 were sent again: the link was unreliable.").arg(who),
                Texts::tr("Check the link, then try again.")};
    if (failure == ProcedureFailure::Refused)
        return {
            Texts::tr("The previous gains of %1 were sent again: a command failed, or its answer was lost.")
                .arg(who),
            Texts::tr("Usually noise on the cable. Try again.")};
    return endedEarly(failure, who);
}

}  // namespace

Words testFailed(const ProcedureReport& report, const QString& who) {
    if (makesSteps(report.kind))
        return responseFailed(*report.failure, who);
    if (report.kind == ProcedureKind::TryGains)
        return tryFailed(report, who);
    return endedEarly(*report.failure, who);
}

QString loopTestFailure(ProcedureFailure failure) {
    if (failure == ProcedureFailure::StoppedShort)
        return Texts::tr("Its limit stop ended the test.") + u' ' + limitStopAdvice();
    if (failure == ProcedureFailure::TravelLimit)
        return Texts::tr(
                   "The motor moved farther than the test allows, and was commanded to hold. Check for a load that pulls it, or use lower gains.") +
               u' ' + wrongWayAdvice();
    const QString advice = testAdvice(failure);
    return advice.isEmpty() ? procedureFailure(failure) : procedureFailure(failure) + u' ' + advice;
}

}  // namespace nmc::texts

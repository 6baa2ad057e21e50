// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/texts.h"

#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

Message::Action retry() {
    return {MessageAction::Retry, Texts::tr("Retry")};
}
Message::Action scanAgain() {
    return {MessageAction::ScanAgain, Texts::tr("Scan again")};
}
Message::Action useSimulator() {
    return {MessageAction::UseSimulator, Texts::tr("Use simulator")};
}
Message::Action restartNetwork() {
    return {MessageAction::RestartNetwork, Texts::tr("Restart the network…")};
}
Message::Action connectFully() {
    return {MessageAction::ConnectFully, Common::tr("Connect fully")};
}
Message::Action lookFirst() {
    return {MessageAction::LookFirst, Texts::tr("Look first (read-only)")};
}
Message::Action choosePort() {
    return {MessageAction::ChoosePort, Texts::tr("Choose another port")};
}

QString ofModule(const QString& what, ModuleIndex module) {
    return what + u'.' + QString::number(module.value() + 1);
}

Message about(const QString& what, ModuleIndex module, const Words& words,
              const QList<Message::Action>& actions) {
    return {.key = ofModule(what, module),
            .module = module,
            .severity = words.severity,
            .headline = words.headline,
            .body = words.body,
            .actions = actions};
}

QString movingSentence(const std::vector<ModuleIndex>& moving) {
    if (moving.empty())
        return Texts::tr("Motor state unknown; no motor was moving when last seen.");
    QStringList names;
    for (const ModuleIndex module : moving)
        names << moduleName(module);
    return (names.size() == 1 ? Texts::tr("Motor state unknown: %1 was moving.")
                              : Texts::tr("Motor state unknown: %1 were moving."))
        .arg(listOf(names));
}

namespace {

/// `number`: of the module.
Words outcomeWords(bus::Outcome outcome, const QString& number) {
    switch (outcome) {
        case bus::Outcome::Done:
            return {Texts::tr("Module %1: done.").arg(number), {}, Severity::Normal};
        case bus::Outcome::Refused:
            return {Texts::tr("Module %1 received the command garbled and did not carry it out.").arg(number),
                    Texts::tr("Sent 3 times; later commands were not sent. Usually noise on the cable.")};
        case bus::Outcome::NoAnswer:
            return {
                Texts::tr("Module %1 did not answer the command. Motor state unknown.").arg(number),
                Texts::tr(
                    "The command may or may not have been carried out; later commands were not sent. Look at the motor; stop all if in doubt."),
                Severity::Fault};
        case bus::Outcome::Forbidden:
            return {Texts::tr("Module %1 cannot do this in its present state. Nothing was sent.").arg(number),
                    Texts::tr("Stop the motor, then try again.")};
        case bus::Outcome::Cancelled:
            return {Texts::tr("The command for module %1 was cancelled.").arg(number), {}, Severity::Normal};
        case bus::Outcome::QueueFull:
            return {Texts::tr("Too many commands are waiting. Nothing was sent to module %1.").arg(number),
                    Texts::tr("Wait until they are carried out, or press STOP ALL to discard them.")};
    }
    return {};
}

}  // namespace

Message operationFailed(const bus::OperationFinished& finished) {
    Message m =
        about(u"operation"_s, finished.module, outcomeWords(finished.outcome, moduleNumber(finished.module)));
    m.details = Texts::tr("Command byte %1").arg(finished.commandByte, 2, 16, QChar(u'0')).toUpper();
    return m;
}

namespace {

/// Names the field to change, and its page.
QString tripAdvice(TripCause cause) {
    switch (cause) {
        case TripCause::Unknown:
            return Texts::tr("Check for a jam, or raise EL on the Gains page.");
        case TripCause::Reversed:
            return Texts::tr(
                "It ran away from its goal: motor or encoder is probably reversed. Run the direction check on the Axis page before you enable it again.");
        case TripCause::Jam:
            return Texts::tr(
                "It was driven but did not move: check for a jam, a brake or a hard stop, and check the motor cable. If it is only hard to turn, raise OL on the Gains page.");
        case TripCause::Limit1:
            return Texts::tr(
                "Limit switch 1 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.");
        case TripCause::Limit2:
            return Texts::tr(
                "Limit switch 2 closed: it is probably at the end of its travel. Move it the other way. To stop in time, arm a limit stop on the Homing page.");
        case TripCause::OffAtLimit1:
        case TripCause::OffAtLimit2:
            return Texts::tr(
                "Enable it, then move it the other way. The Amplifier page sets what a closed limit does.");
        case TripCause::Behind:
            return Texts::tr(
                "It moved correctly but could not keep up: lower its velocity or acceleration, or raise OL and EL on the Gains page.");
    }
    return {};
}

}  // namespace

Message tripped(ModuleIndex module, std::optional<int> limit, TripCause cause) {
    const QString number = moduleNumber(module);
    const bool atLimit = cause == TripCause::OffAtLimit1 || cause == TripCause::OffAtLimit2;
    const QString headline =
        atLimit ? Texts::tr("Limit switch %1 closed, and module %2 switched its motor off.")
                      .arg(cause == TripCause::OffAtLimit1 ? 1 : 2)
                      .arg(number)
        : limit
            ? Texts::tr(
                  "Module %1 switched its servo off because the motor was more than %2 counts from where it should be.")
                  .arg(number, QString::number(*limit))
            : Texts::tr(
                  "Module %1 switched its servo off because the motor was too far from where it should be.")
                  .arg(number);
    return about(u"tripped"_s, module, {headline, tripAdvice(cause), Severity::Fault},
                 {{MessageAction::ClearAndStayOff, Texts::tr("Clear and stay off")}});
}

Message powerLost(ModuleIndex module) {
    return about(u"power"_s, module,
                 {Texts::tr("Module %1 has no motor power, so its servo is off.").arg(moduleNumber(module)),
                  Texts::tr("It stays off when power returns.")});
}

Message currentLimited(ModuleIndex module) {
    return about(
        u"current"_s, module,
        {Texts::tr("Overcurrent: module %1 limits its motor current.").arg(moduleNumber(module)),
         Texts::tr(
             "The motor may fail to reach its goal or hold its load. Check for a jam or too heavy a load, or raise the limit. This message stays until you clear the sticky bits.")});
}

Message amplifierWentOff(ModuleIndex module, Activity activity) {
    const QString number = moduleNumber(module);
    if (activity == Activity::PowerLost)
        return about(u"power"_s, module,
                     {Texts::tr("Module %1 has no motor power, so its motor is off.").arg(number),
                      Texts::tr("It stays off when power returns.")});
    if (activity == Activity::Overheated)
        return about(
            u"overheated"_s, module,
            {Texts::tr("Module %1 is too hot and switched its motor off.").arg(number),
             Texts::tr(
                 "The A/D value fell below the thermal limit. Let the motor cool down; then check the currents and the limit on the Parameters page."),
             Severity::Fault});
    if (activity == Activity::EstopActive)
        return about(
            u"estop"_s, module,
            {Texts::tr("Module %1 switched its motor off because its E-stop input is active.").arg(number),
             Texts::tr("It stays off when the input is released.")});
    if (activity == Activity::StoppedByLimit)
        return about(
            u"limitOff"_s, module,
            {Texts::tr("Module %1 switched its motor off because a limit switch is active.").arg(number),
             Texts::tr("Enable it again, then move in the other direction.")});
    return about(u"tripped"_s, module,
                 {Texts::tr("Module %1 switched its motor off by itself.").arg(number),
                  Texts::tr("The cause is unknown. Check its power and inputs, then enable it again."),
                  Severity::Fault});
}

Message stoppedBeforeLimit(ModuleIndex module) {
    return about(
        u"travel"_s, module,
        {Texts::tr("Module %1 was commanded to stop just before its travel limit.").arg(moduleNumber(module)),
         Texts::tr(
             "The chip does not end this kind of motion by itself, so the panel did. Check the position before you continue.")});
}

Message notPossible(ModuleIndex module, const QString& reason) {
    return about(
        u"notPossible"_s, module,
        {Texts::tr("Module %1 cannot do this now; nothing was sent.").arg(moduleNumber(module)), reason});
}

QString closing(int movingMotors) {
    if (movingMotors == 0)
        return Texts::tr("No motor is moving. All motors are commanded to stop before the port closes.");
    return Texts::tr("%n motors are moving. They will be stopped before the port closes.", nullptr,
                     movingMotors);
}

QString beforeRestart(int movingMotors) {
    const QString loss =
        Texts::tr("Every module loses its position, gains and address, and switches its motor off.");
    if (movingMotors == 0)
        return loss;
    return Texts::tr("%n motors are moving. They will be stopped first.", nullptr, movingMotors) + u'\n' +
           loss;
}

QString stoppingBeforeClose() {
    return Texts::tr("Stopping the motors, then closing.");
}

Message safety() {
    return {
        .key = key::kSafety,
        .headline = Texts::tr("Fit a hardware emergency stop that removes motor power."),
        .body = Texts::tr(
            "These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses power, a running motor keeps running, and no program can stop it. STOP ALL and Esc work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs."),
        .actions = {{MessageAction::Understood, Texts::tr("Understood")}}};
}

Message questionWaits(const QString& title, const QString& text) {
    return {.key = key::kQuestion,
            .severity = Severity::Attention,
            .headline = Texts::tr("A question is waiting for your answer: %1").arg(title),
            .body = text,
            .actions = {{MessageAction::ShowQuestion, Texts::tr("Show the question")}},
            .stands = true};
}

QString simulatorDid(const QString& line) {
    return Texts::tr("Done: %1").arg(line);
}

QString simulatorRefused(const QString& line) {
    return Texts::tr("Failed: %1").arg(line);
}

QString simulatorAnswered(const QString& line) {
    return Texts::tr("Answer to: %1").arg(line);
}

QString key::endedWhileMoving(const QString& file) {
    return u"endedWhileMoving."_s + file;
}

}  // namespace nmc::texts

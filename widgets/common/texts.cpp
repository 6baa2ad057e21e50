// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/texts.h"

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
    return {MessageAction::ConnectFully, Texts::tr("Connect fully")};
}
Message::Action lookFirst() {
    return {MessageAction::LookFirst, Texts::tr("Look first (read-only)")};
}
Message::Action choosePort() {
    return {MessageAction::ChoosePort, Texts::tr("Choose another port")};
}

QString rate(quint32 baud) {
    return grouped(baud).replace(QChar(0x202F), u' ');
}

QString ofModule(const QString& what, ModuleIndex module) {
    return what + u'.' + QString::number(module.value() + 1);
}

QString movingSentence(const std::vector<ModuleIndex>& moving) {
    if (moving.empty())
        return Texts::tr("Motor state unknown; no motor was moving at the last word.");
    QStringList names;
    for (const ModuleIndex module : moving)
        names << moduleName(module);
    return (names.size() == 1 ? Texts::tr("Motor state unknown: %1 was moving.")
                              : Texts::tr("Motor state unknown: %1 were moving."))
        .arg(listOf(names));
}

Message operationFailed(const bus::OperationFinished& finished) {
    const QString number = moduleNumber(finished.module);
    Message m{.key = ofModule(u"operation"_s, finished.module),
              .module = finished.module,
              .severity = Severity::Attention};
    m.details = Texts::tr("Command byte %1").arg(finished.commandByte, 2, 16, QChar(u'0')).toUpper();
    switch (finished.outcome) {
        case bus::Outcome::Done:
            m.severity = Severity::Normal;
            m.headline = Texts::tr("Module %1: done.").arg(number);
            break;
        case bus::Outcome::Refused:
            m.headline =
                Texts::tr("Module %1 did not understand the command, so it was not carried out.").arg(number);
            m.body = Texts::tr("It was sent 3 times. Usually noise on the cable. Nothing after it was sent.");
            break;
        case bus::Outcome::NoAnswer:
            m.severity = Severity::Fault;
            m.headline = Texts::tr("Module %1 did not answer the command. Motor state unknown.").arg(number);
            m.body = Texts::tr(
                "The command may or may not have been carried out. Look at the motor; stop all if in doubt. Nothing after it was sent.");
            break;
        case bus::Outcome::Forbidden:
            m.headline = Texts::tr("Module %1 does not allow this in its present state. Nothing was sent.")
                             .arg(number);
            m.body = Texts::tr("Stop the motor, then try again.");
            break;
        case bus::Outcome::Cancelled:
            m.severity = Severity::Normal;
            m.headline =
                Texts::tr("The command for module %1 was dropped because a stop came first.").arg(number);
            break;
    }
    return m;
}

namespace {

/// Names the box to change: its page and its field.
QString tripAdvice(TripCause cause) {
    switch (cause) {
        case TripCause::Unknown:
            return Texts::tr("Check for a jam, or raise EL on the page Gains.");
        case TripCause::Reversed:
            return Texts::tr(
                "It ran away from where it was told to be: motor or encoder is probably reversed. Make the direction check on the page Axis before you enable it again.");
        case TripCause::Jam:
            return Texts::tr(
                "It was driven and did not move: look for a jam, a brake or an end stop, and at the motor's cable. If it is only hard to turn, raise OL on the page Gains.");
        case TripCause::Limit1:
            return Texts::tr(
                "Limit 1 closed on the way: it is probably at the end of its travel. Drive it the other way; a limit stop on the page Homing ends a motion in time.");
        case TripCause::Limit2:
            return Texts::tr(
                "Limit 2 closed on the way: it is probably at the end of its travel. Drive it the other way; a limit stop on the page Homing ends a motion in time.");
        case TripCause::OffAtLimit1:
        case TripCause::OffAtLimit2:
            return Texts::tr(
                "Enable it, then drive it the other way. The page Amplifier sets what a closed limit does.");
        case TripCause::Behind:
            return Texts::tr(
                "It moved as it was told, and could not keep up: lower its velocity or acceleration, or raise OL and EL on the page Gains.");
    }
    return {};
}

}  // namespace

Message tripped(ModuleIndex module, std::optional<int> limit, TripCause cause) {
    const QString number = moduleNumber(module);
    if (cause == TripCause::OffAtLimit1 || cause == TripCause::OffAtLimit2)
        return {.key = key::tripped(module),
                .module = module,
                .severity = Severity::Fault,
                .headline = Texts::tr("Limit %1 closed, and module %2 switched its motor off.")
                                .arg(cause == TripCause::OffAtLimit1 ? 1 : 2)
                                .arg(number),
                .body = tripAdvice(cause),
                .actions = {{MessageAction::ClearAndStayOff, Texts::tr("Clear and stay off")}}};
    return {
        .key = key::tripped(module),
        .module = module,
        .severity = Severity::Fault,
        .headline =
            limit.has_value()
                ? Texts::tr(
                      "Module %1 switched its servo off because the motor was more than %2 counts from where it should be.")
                      .arg(number)
                      .arg(*limit)
                : Texts::tr(
                      "Module %1 switched its servo off because the motor was too far from where it should be.")
                      .arg(number),
        .body = tripAdvice(cause),
        .actions = {{MessageAction::ClearAndStayOff, Texts::tr("Clear and stay off")}}};
}

Message powerLost(ModuleIndex module) {
    return {
        .key = key::power(module),
        .module = module,
        .severity = Severity::Attention,
        .headline = Texts::tr("Module %1 has no motor power, so its servo is off.").arg(moduleNumber(module)),
        .body = Texts::tr("It stays off when power returns.")};
}

Message currentLimited(ModuleIndex module) {
    return {
        .key = key::current(module),
        .module = module,
        .severity = Severity::Attention,
        .headline =
            Texts::tr("Module %1 limits the current of its motor: overcurrent.").arg(moduleNumber(module)),
        .body = Texts::tr(
            "The motor may not reach its goal, or not hold its load. Check for a jam or too heavy a load, or raise the limit. It says so until the sticky bits are cleared.")};
}

Message amplifierWentOff(ModuleIndex module, Activity activity) {
    const QString number = moduleNumber(module);
    Message message{.key = key::tripped(module), .module = module, .severity = Severity::Fault};
    switch (activity) {
        case Activity::PowerLost:
            message.key = key::power(module);
            message.severity = Severity::Attention;
            message.headline = Texts::tr("Module %1 has no motor power, so its motor is off.").arg(number);
            message.body = Texts::tr("It stays off when power returns.");
            break;
        case Activity::Overheated:
            message.key = ofModule(u"overheated"_s, module);
            message.headline =
                Texts::tr("Module %1 switched its motor off because it is too hot.").arg(number);
            message.body = Texts::tr(
                "The A/D value fell below the thermal limit. Let the motor cool down; then look at the currents and the limit on the Parameters page.");
            break;
        case Activity::EstopActive:
            message.key = ofModule(u"estop"_s, module);
            message.severity = Severity::Attention;
            message.headline =
                Texts::tr("Module %1 switched its motor off because its E-stop input is active.").arg(number);
            message.body = Texts::tr("It stays off when the input is released.");
            break;
        case Activity::StoppedByLimit:
            message.key = ofModule(u"limitOff"_s, module);
            message.severity = Severity::Attention;
            message.headline =
                Texts::tr("Module %1 switched its motor off because a limit switch is active.").arg(number);
            message.body = Texts::tr("Enable it again, then move in the other direction.");
            break;
        case Activity::Unknown:
        case Activity::Silent:
        case Activity::Restarted:
        case Activity::NoPower:
        case Activity::ServoOff:
        case Activity::Tripped:
        case Activity::PwmMode:
        case Activity::Turned:
        case Activity::Holding:
        case Activity::Limited:
        case Activity::Accelerating:
        case Activity::AtSpeed:
        case Activity::Decelerating:
        case Activity::OnPath:
        case Activity::AmplifierOff:
        case Activity::Ready:
        case Activity::WentOff:
            message.headline = Texts::tr("Module %1 switched its motor off by itself.").arg(number);
            message.body =
                Texts::tr("It does not say why. Check its power and its inputs, then enable it again.");
            break;
    }
    return message;
}

Message stoppedBeforeLimit(ModuleIndex module) {
    return {
        .key = ofModule(u"travel"_s, module),
        .module = module,
        .severity = Severity::Attention,
        .headline = Texts::tr("Module %1 was told to stop: it was about to leave its limits of travel.")
                        .arg(moduleNumber(module)),
        .body = Texts::tr(
            "The chip does not end this kind of motion by itself, so the panel did. See where it stands before you go on.")};
}

Message notPossible(ModuleIndex module, const QString& reason) {
    return {
        .key = ofModule(u"notPossible"_s, module),
        .module = module,
        .severity = Severity::Attention,
        .headline = Texts::tr("Not possible for module %1 now; nothing was sent.").arg(moduleNumber(module)),
        .body = reason};
}

QString closing(int movingMotors) {
    if (movingMotors == 0)
        return Texts::tr("No motor moves any more. All are told to stop before the port closes.");
    return movingMotors == 1 ? Texts::tr("1 motor is moving. It will be stopped before the port closes.")
                             : Texts::tr("%1 motors are moving. They will be stopped before the port closes.")
                                   .arg(movingMotors);
}

QString beforeRestart(int movingMotors) {
    const QString loss =
        Texts::tr("Every module forgets its position, its gains and its address, and lets go of its motor.");
    if (movingMotors == 0)
        return loss;
    const QString moving =
        movingMotors == 1 ? Texts::tr("1 motor is moving. It will be stopped first.")
                          : Texts::tr("%1 motors are moving. They will be stopped first.").arg(movingMotors);
    return moving + u'\n' + loss;
}

QString stoppingBeforeClose() {
    return Texts::tr("Stopping the motors, then closing.");
}

Message safety() {
    return {
        .key = key::safety(),
        .headline = Texts::tr("Fit a hardware emergency stop that removes motor power."),
        .body = Texts::tr(
            "These modules have no link watchdog: when the cable is cut, the adapter hangs or this computer loses its power, a motor that runs keeps running, and no program can stop it. Stop all, and Esc, work only while the link works. A guardian stops the motors when this program is killed, crashes or hangs."),
        .actions = {{MessageAction::Understood, Texts::tr("Understood")}}};
}

QString simulatorDid(const QString& line) {
    return Texts::tr("Done: %1").arg(line);
}

QString simulatorRefused(const QString& line) {
    return Texts::tr("Not done: %1").arg(line);
}

QString simulatorTold(const QString& line) {
    return Texts::tr("Answer to: %1").arg(line);
}

namespace key {
QString port() {
    return u"port"_s;
}
QString link() {
    return u"link"_s;
}
QString unaddressed() {
    return u"unaddressed"_s;
}
QString badLink() {
    return u"badLink"_s;
}
QString silent(ModuleIndex module) {
    return ofModule(u"silent"_s, module);
}
QString refused(ModuleIndex module) {
    return ofModule(u"refused"_s, module);
}
QString garbled(ModuleIndex module) {
    return ofModule(u"garbled"_s, module);
}
QString tripped(ModuleIndex module) {
    return ofModule(u"tripped"_s, module);
}
QString power(ModuleIndex module) {
    return ofModule(u"power"_s, module);
}
QString current(ModuleIndex module) {
    return ofModule(u"current"_s, module);
}
QString restarted(ModuleIndex module) {
    return ofModule(u"restarted"_s, module);
}
QString stop() {
    return u"stop"_s;
}
QString gone() {
    return u"gone"_s;
}
QString endedWhileMoving(const QString& file) {
    return u"endedWhileMoving."_s + file;
}
QString safety() {
    return u"safety"_s;
}
}  // namespace key

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/words.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "link/ports/linktypes.h"
#include "model/intent/rights.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {
QStringList g_moduleNames;

QString familyMember(ModuleType type) {
    const std::string_view name = familyName(type);
    return name.empty() ? Texts::tr("type %1").arg(static_cast<int>(type)) : QString::fromUtf8(name);
}

/// What the window says of an activity.
struct ActivityTexts {
    QString word;
    QString meaning;
};
ActivityTexts textsOf(Activity activity, ModuleType type) {
    const bool io = type == ModuleType::Io;
    switch (activity) {
        case Activity::Unknown:
            return {Texts::tr("Unknown"), Texts::tr("No status received from this module yet.")};
        case Activity::Unresponsive:
            return {Texts::tr("No answer"),
                    io ? refusal(Refusal::Unresponsive)
                       : Texts::tr("The module does not answer. Motor state unknown.")};
        case Activity::NotAsked:
            return {
                Texts::tr("Not asked"),
                Texts::tr(
                    "Sending has stopped because another module restarted, so what this one does now is not known. Scan again, or restart the network.")};
        case Activity::Restarted:
            return {
                Texts::tr("Restarted"),
                io ? Texts::tr(
                         "The module restarted: its pins are inputs again, its outputs release what they drove, and its address is lost. Assign its address again if offered, or restart the network.")
                : type == ModuleType::Stepper
                    ? Texts::tr(
                          "The module restarted: its motor is off, and its position, parameters and address are lost. Assign its address again if offered, or restart the network.")
                    : Texts::tr(
                          "The module restarted: its motor is off, and its position, gains and address are lost. Assign its address again if offered, or restart the network.")};
        case Activity::NoPower:
            return {Texts::tr("No motor power"),
                    Texts::tr("The module has no motor power, so its motor is off.")};
        case Activity::ServoOff:
            return {Texts::tr("Servo off"),
                    Texts::tr("The motor is free to turn. This is normal: the servo is switched off.")};
        case Activity::Tripped:
            return {
                Common::tr("Position error"),
                Texts::tr(
                    "The servo switched itself off because the motor was too far from where it should be.")};
        case Activity::PowerLost:
            return {Texts::tr("Power was lost"),
                    Texts::tr("The module switched its motor off when motor power failed. It stays off.")};
        case Activity::PwmMode:
            return {
                Texts::tr("PWM mode"),
                Texts::tr(
                    "A fixed PWM value drives the motor; the servo does not control it. After a loss of motor power, the motor may turn again by itself.")};
        case Activity::MaybeOff:
            return {
                Texts::tr("Maybe off"),
                Texts::tr("One answer says that the motor is off. The next answer will show whether it is.")};
        case Activity::MaybeMoving:
            return {
                Texts::tr("Maybe moving"),
                Texts::tr(
                    "The last answers show the motor at rest, but it is not yet known whether it was started.")};
        case Activity::Turned:
            return {
                Texts::tr("Off, but turning"),
                Texts::tr(
                    "The shaft moves while the motor is off: a load turns it, or it is still coasting. A stop cannot hold it; use a brake, or enable the servo.")};
        case Activity::Holding:
            return {Texts::tr("Holding"), Common::tr("The motor holds its position.")};
        case Activity::Limited:
            return {
                Texts::tr("Overcurrent"),
                Texts::tr(
                    "The motor is at rest, but its current was limited: it may not hold its load. This stays until you clear the sticky bits.")};
        case Activity::Accelerating:
            return {Texts::tr("Accelerating"), Texts::tr("The motor is changing its speed.")};
        case Activity::AtSpeed:
            return {Texts::tr("At speed"), Texts::tr("The motor moves at its goal velocity.")};
        case Activity::Decelerating:
            return {Texts::tr("Decelerating"), Texts::tr("The motor is slowing down.")};
        case Activity::OnPath:
            return {Texts::tr("On a path"), Common::tr("The motor follows the points of a path.")};
        case Activity::AmplifierOff:
            return {Texts::tr("Amplifier off"),
                    Texts::tr("The motor is free to turn. This is normal: the amplifier is switched off.")};
        case Activity::Ready:
            return {Texts::tr("Ready"),
                    Texts::tr("The module answers. It has inputs and outputs, but no motor.")};
        case Activity::StoppedByLimit:
            return {Texts::tr("Stopped by a limit"),
                    Texts::tr("A limit switch stopped the motor. It can move in the other direction.")};
        case Activity::EstopActive:
            return {Common::tr("E-stop input"),
                    Texts::tr("The module's E-stop input stopped the motor, or prevents it from moving.")};
        case Activity::Overheated:
            return {
                Texts::tr("Too hot"),
                Texts::tr(
                    "The module switched its motor off because the A/D value fell below the thermal limit. It stays off.")};
        case Activity::WentOff:
            return {Texts::tr("Switched itself off"),
                    Texts::tr("The module switched its motor off; the cause is unknown.")};
    }
    return {};
}
}  // namespace

QString moduleName(ModuleIndex module) {
    return Texts::tr("Module %1").arg(moduleNumber(module));
}

QString moduleNumber(ModuleIndex module) {
    const QString name = g_moduleNames.value(module.value());
    const QString number = QString::number(module.value() + 1);
    return name.isEmpty() ? number : u"%1 \"%2\""_s.arg(number, name);
}

void setModuleNames(const QStringList& names) {
    g_moduleNames = names;
}

QString moduleType(const ModuleIdentity& identity) {
    return Texts::tr("%1 v%2").arg(familyMember(identity.type)).arg(identity.version);
}

QString activity(Activity activity) {
    return textsOf(activity, ModuleType::Servo).word;
}

QString activityMeaning(Activity activity, ModuleType type) {
    return textsOf(activity, type).meaning;
}

QString refusal(Refusal refusal) {
    switch (refusal) {
        case Refusal::NotConnected:
            return Texts::tr("Not connected. Choose a port and connect first.");
        case Refusal::ReadOnly:
            return Texts::tr("This connection is read-only. Connect fully first.");
        case Refusal::Lent:
            return Texts::tr("The line is lent to a program.");
        case Refusal::OperatorMode:
            return Texts::tr("Not allowed in operator mode. Leave operator mode first.");
        case Refusal::NotAServo:
            return Texts::tr("This module is not a PIC-SERVO.");
        case Refusal::NoMotor:
            return Texts::tr("This module drives no motor.");
        case Refusal::NotAnIoModule:
            return Texts::tr("This module is not a PIC-I/O.");
        case Refusal::Unresponsive:
            return Texts::tr("The module does not answer, so its state is unknown.");
        case Refusal::NotAsked:
            return activityMeaning(Activity::NotAsked);
        case Refusal::Looking:
            return Texts::tr("Looking for modules… Until they are found, only stop commands work.");
        case Refusal::OtherType:
            return Texts::tr(
                "This is not the type of module that the machine has here, so its settings do not apply. Only stop commands work until you accept the chain as found (Chain doctor).");
        case Refusal::NoPower:
            return Texts::tr("The module has no motor power.");
        case Refusal::GainsUnknown:
            return Texts::tr("The gains are 0 or unknown, so the motor would not hold. Apply gains first.");
        case Refusal::ServoRateUnknown:
            return Texts::tr(
                "The servo rate of this module is unknown, so speeds per second cannot be calculated. Apply its gains first: they include SR.");
        case Refusal::CommandUnknown:
            return Texts::tr(
                "The exact position that the servo holds is unknown. Choose Hold here first, or move the motor.");
        case Refusal::ServoOff:
            return Texts::tr("The servo is off. Enable it first.");
        case Refusal::Moving:
            return Texts::tr(
                "The motor is moving. Stop it first: a move to a position starts from standstill.");
        case Refusal::NoAcceleration:
            return Texts::tr(
                "The acceleration is 0 or unknown: the motor might not start or stop. Enter an acceleration.");
        case Refusal::NoVelocity:
            return Texts::tr(
                "The velocity is 0 or unknown: the motor might not move, or move too fast. Enter a velocity.");
        case Refusal::NothingLoaded:
            return Texts::tr("Load a move first.");
        case Refusal::PositionUnknown:
            return Texts::tr("The position is unknown.");
        case Refusal::HomeUnknown:
            return Texts::tr("Home is unknown: search for it, or save it.");
        case Refusal::ServoOn:
            return Texts::tr("The servo is on. Switch the motor off first.");
        case Refusal::VersionLacksIt:
            return Texts::tr("This chip version does not support it.");
        case Refusal::NothingToFind:
            return Texts::tr("Select at least one home condition.");
        case Refusal::NoSingleInput:
            return Texts::tr("Choose one switch or the index, and nothing else.");
        case Refusal::TooFewOrMany:
            return Texts::tr("Approach it 2 to 100 times from each side.");
        case Refusal::NoSearchLimits:
            return Texts::tr("Enter a search distance and a time limit above 0.");
        case Refusal::LimitActive:
            return Texts::tr("The limit switch is already active. Move the motor off it first.");
        case Refusal::LimitClosed:
            return Texts::tr("The limit in that direction is closed. Move the motor the other way.");
        case Refusal::LimitIsOutput:
            return Texts::tr("This limit pin is set as an output.");
        case Refusal::StartApart:
            return Texts::tr(
                "Load the move first, then choose Start: this way a garbled load never moves the motor.");
        case Refusal::StepTooShort:
            return Texts::tr("Enter a distance other than 0.");
        case Refusal::StepTooLong:
            return Texts::tr("Too far for a step response: at most 2000 counts.");
        case Refusal::StepWouldTrip:
            return Texts::tr(
                "The motor would come too close to the position error limit, which switches the servo off. Make the step, the amplitude or the speed smaller, or raise EL.");
        case Refusal::GoalOutOfRange:
            return Texts::tr("The goal is outside the chip's position range.");
        case Refusal::BeyondTravel:
            return Texts::tr("That is beyond this axis's travel limits (Axis page).");
        case Refusal::AtTravelEnd:
            return Texts::tr("Travel limit reached. Move in the other direction.");
        case Refusal::TooSlow:
            return Texts::tr(
                "The chip cannot turn the motor this slowly in its speed mode. Enter a higher velocity, or choose another speed mode.");
        case Refusal::TooFast:
            return Texts::tr("That exceeds this axis's highest velocity (Axis page).");
        case Refusal::RunNeedsStop:
            return Texts::tr(
                "Stop first: a run towards a travel limit must start from standstill, so that the chip can end it there.");
        case Refusal::LimitStopDue:
            return Texts::tr("Wait until the limit stop of this axis is armed.");
        case Refusal::NoCurrentLimit:
            return Texts::tr(
                "The current limit CL is 0 or unknown, so current cannot stop the motor. Apply a CL first.");
        case Refusal::RecordTime:
            return Texts::tr("A record must be 0.02 s to 3 s long.");
        case Refusal::MoveTooLong:
            return Texts::tr(
                "The move and the record after it would take more than 6 s. Shorten the move or the record, or move faster.");
        case Refusal::PathNotPossible:
            return Texts::tr("The path cannot be followed from here.");
        case Refusal::TestOutOfRange:
            return Texts::tr("A value of this test is out of range.");
        case Refusal::TestTooSlow:
            return Texts::tr(
                "At this speed the motor would reverse. Raise the speed, or lower the amplitude or the highest frequency.");
        case Refusal::NotAStepper:
            return Texts::tr("This module is not a PIC-STEP.");
        case Refusal::ParametersUnknown:
            return Texts::tr("Apply parameters first.");
        case Refusal::AmplifierOff:
            return Texts::tr("The amplifier is off. Enable it first.");
        case Refusal::NeedsStop:
            return Texts::tr("Stop the motor first: the chip cannot change this in motion.");
        case Refusal::EstopActive:
            return Texts::tr("The module's E-stop input is active. Release it first.");
        case Refusal::Limit1Active:
            return Texts::tr("Limit switch 1 is active: the motor can only move away from it.");
        case Refusal::Limit2Active:
            return Texts::tr("Limit switch 2 is active: the motor can only move away from it.");
        case Refusal::TooHot:
            return Texts::tr(
                "The A/D value is below the thermal limit: let the motor cool down, or lower the limit.");
        case Refusal::TooFar:
            return Texts::tr("The goal is too far away: at most 2 147 483 647 counts or steps.");
    }
    return {};
}

QString whyLocked(const ModuleState& module) {
    const auto reason = whyNotEdited(module);
    return reason ? refusal(*reason) : QString();
}

QString severity(Severity severity) {
    switch (severity) {
        case Severity::Normal:
            return Texts::tr("Note");
        case Severity::Attention:
            return Texts::tr("Attention");
        case Severity::Fault:
            return Texts::tr("Fault");
    }
    return {};
}

QString stage(bus::ConnectStage stage) {
    switch (stage) {
        case bus::ConnectStage::Looking:
            return Texts::tr("looking for modules");
        case bus::ConnectStage::Restarting:
            return Texts::tr("restarting the modules");
        case bus::ConnectStage::Addressing:
            return Texts::tr("assigning addresses");
        case bus::ConnectStage::Identifying:
            return Texts::tr("reading types and versions");
        case bus::ConnectStage::ChangingRate:
            return Texts::tr("changing the baud rate");
        case bus::ConnectStage::Preparing:
            return Texts::tr("setting up status reports");
    }
    return {};
}

QString portName(const QString& port) {
    if (port == kSimulatorPort)
        return Common::tr("Simulator");
    if (port.startsWith(kSimulatorPort + u'='))
        return Texts::tr("Simulator (%1)").arg(port.mid(kSimulatorPort.size() + 1));
    return port;
}

QString link(const LinkState& state) {
    const QString port = portName(QString::fromStdString(state.port));
    switch (state.phase) {
        case LinkPhase::Disconnected:
            return Texts::tr("Not connected");
        case LinkPhase::Connecting: {
            const QString doing = Texts::tr("Connecting to %1: %2").arg(port, stage(state.stage));
            return state.found == 0 ? doing
                                    : Texts::tr("%1, %2 so far").arg(doing, countOfModules(state.found));
        }
        case LinkPhase::Connected:
            return (state.lent       ? Texts::tr("Connected to %1 at %2 Bd, %3, lent to a program")
                    : state.readOnly ? Texts::tr("Connected to %1 at %2 Bd, %3, read-only")
                                     : Texts::tr("Connected to %1 at %2 Bd, %3"))
                .arg(port, grouped(state.baud), countOfModules(static_cast<int>(state.modules.size())));
        case LinkPhase::Lost:
            if (state.modules.empty())
                return Texts::tr("%1 is open, but no module is usable").arg(port);
            if (const auto restarted = std::ranges::find(state.modules, true, &ModuleState::hasRestarted);
                state.quiet && restarted != state.modules.end())
                return Texts::tr("Sending to %1 has stopped: module %2 restarted")
                    .arg(port, moduleNumber(restarted->info.index));
            return Texts::tr("Connection to %1 lost, motor state unknown").arg(port);
    }
    return {};
}

static QString inGroups(QString digits) {
    for (qsizetype i = digits.size() - 3; i > 0; i -= 3)
        digits.insert(i, QChar(0x202F));
    return digits;
}

QString grouped(qint64 value) {
    const QString digits = inGroups(QString::number(qAbs(value)));
    return value < 0 ? QChar(0x2212) + digits : digits;
}

QString rate(quint32 baud) {
    return grouped(baud).replace(QChar(0x202F), u' ');
}

QString fixed(double value, int decimals) {
    const QString digits = QLocale::c().toString(std::abs(value), 'f', decimals).remove(u',');
    const QString whole = inGroups(digits.section(u'.', 0, 0));
    const QString fraction = digits.section(u'.', 1);
    const QString text = fraction.isEmpty() ? whole : whole + QLocale().decimalPoint() + fraction;
    const bool zero = digits.count(u'0') + digits.count(u'.') == digits.size();
    return value < 0 && !zero ? QChar(0x2212) + text : text;
}

QString readout(double value, int significant) {
    if (!std::isfinite(value))
        return u"–"_s;
    const double magnitude = std::abs(value);
    const int before = magnitude < 1 ? 1 : static_cast<int>(std::floor(std::log10(magnitude))) + 1;
    const int decimals = magnitude == 0.0 ? 0 : qBound(0, significant - before, 6);
    QString text = fixed(value, decimals);
    if (decimals > 0) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(QLocale().decimalPoint()))
            text.chop(QLocale().decimalPoint().size());
    }
    return text;
}

QString countOfModules(int count) {
    return Texts::tr("%n modules", nullptr, count);
}

QString listOf(const QStringList& names) {
    if (names.size() < 2)
        return names.join(QString());
    return names.mid(0, names.size() - 1).join(u", "_s) + Texts::tr(" and ") + names.last();
}

QString listOfModules(const std::vector<ModuleIndex>& modules) {
    QStringList numbers;
    for (const ModuleIndex module : modules)
        numbers << QString::number(module.value() + 1);
    return listOf(numbers);
}

QString unitCounts() {
    return Texts::tr("counts");
}

QString unitSteps() {
    return Common::tr("steps");
}

QString unitVelocity() {
    return Texts::tr("counts/tick");
}

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/texts.h"

#include <QCoreApplication>
#include <cmath>

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

class Texts {
    Q_DECLARE_TR_FUNCTIONS(Texts)
};

Message::Action retry() {
    return {action::kRetry, Texts::tr("Retry")};
}
Message::Action scanAgain() {
    return {action::kScanAgain, Texts::tr("Scan again")};
}
Message::Action useSimulator() {
    return {action::kUseSimulator, Texts::tr("Use simulator")};
}
Message::Action choosePort() {
    return {action::kChoosePort, Texts::tr("Choose another port")};
}

/// A rate in running text, with plain spaces as in interface.md.
QString rate(quint32 baud) {
    return grouped(baud).replace(QChar(0x202F), u' ');
}

QString ofModule(const QString& what, ModuleIndex module) {
    return what + u'.' + QString::number(module.value() + 1);
}

QString movingSentence(int moving) {
    if (moving == 0)
        return Texts::tr("Motor state unknown; no motor was moving at the last word.");
    return moving == 1 ? Texts::tr("Motor state unknown: 1 motor was moving.")
                       : Texts::tr("Motor state unknown: %1 motors were moving.").arg(moving);
}

Message noPermission(const PortError& error) {
    Message m;
    m.headline = Texts::tr("Your user account may not use %1.").arg(error.port);
    if (error.group.isEmpty()) {
        m.body = Texts::tr("Ask whoever looks after this computer for access to it.");
        m.actions = {choosePort(), useSimulator()};
        return m;
    }
    m.command = u"sudo usermod -aG %1 %2"_s.arg(error.group, error.user.isEmpty() ? u"$USER"_s : error.user);
    m.body = Texts::tr("It belongs to the group %1. Run %2, then log out and in again.")
                 .arg(error.group, m.command);
    m.actions = {{action::kCopyCommand, Texts::tr("Copy command")}, choosePort(), useSimulator()};
    return m;
}

Message portMessage(const PortError& error) {
    Message m;
    switch (error.problem) {
        case PortProblem::NoPermission:
            return noPermission(error);
        case PortProblem::InUse:
            m.headline = Texts::tr("%1 is used by another program.").arg(error.port);
            m.body = Texts::tr("Close it and try again.");
            m.actions = {retry(), choosePort()};
            return m;
        case PortProblem::NotFound:
            m.headline = Texts::tr("There is no %1.").arg(error.port);
            m.body = Texts::tr("Most often the adapter is not plugged in, or it has another name now.");
            m.actions = {retry(), choosePort(), useSimulator()};
            return m;
        case PortProblem::NotASerialPort:
            m.headline = Texts::tr("%1 is not a serial port.").arg(error.port);
            m.body = Texts::tr("Choose the port of the adapter, for example /dev/ttyUSB0.");
            m.actions = {choosePort(), useSimulator()};
            return m;
        case PortProblem::RateNotPossible:
            m.headline = Texts::tr("%1 cannot run at the chosen rate.").arg(error.port);
            m.body = Texts::tr("Choose another rate; every adapter can do 19 200 Bd.");
            m.actions = {retry(), choosePort()};
            return m;
        case PortProblem::Gone:
            m.severity = Severity::Fault;
            m.headline = Texts::tr("The adapter at %1 was unplugged. %2")
                             .arg(error.port, movingSentence(error.movingMotors));
            m.body = Texts::tr("Use the hardware stop if needed, then plug it in again.");
            m.actions = {retry()};
            return m;
        case PortProblem::Other:
            m.headline = Texts::tr("%1 could not be opened.").arg(error.port);
            m.body = Texts::tr("The system says: %1").arg(error.detail);
            m.actions = {retry(), choosePort(), useSimulator()};
            return m;
    }
    return m;
}

}  // namespace

Message portProblem(const PortError& error) {
    Message m = portMessage(error);
    m.key = key::port();
    m.details = error.detail;
    if (m.severity == Severity::Normal)
        m.severity = Severity::Attention;
    return m;
}

Message connectFailed(const bus::ConnectFailed& failed, const QString& port) {
    Message m{.key = key::port(), .severity = Severity::Attention, .actions = {scanAgain(), useSimulator()}};
    switch (failed.reason) {
        case bus::ConnectFailure::NobodyAnswers:
            m.headline =
                Texts::tr("The port is open, but no module answered (19 200, 57 600 and 115 200 Bd tried).");
            m.body = Texts::tr(
                "Check, in this order: module power; every cable in the chain, one loose cable hides all "
                "modules; the "
                "ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex "
                "(4-wire) "
                "adapter.");
            break;
        case bus::ConnectFailure::RateChange:
            m.headline =
                failed.modules.empty()
                    ? Texts::tr("Not every module answered at %1 Bd, so the modules cannot be used yet.")
                          .arg(rate(failed.baud))
                    : Texts::tr("Module %1 did not answer at %2 Bd, so the modules cannot be used yet.")
                          .arg(listOfModules(failed.modules), rate(failed.baud));
            m.body =
                Texts::tr(
                    "Usually the cable is too long for this rate, or termination is missing. Choose a lower "
                    "rate for %1 and scan again.")
                    .arg(portName(port));
            break;
        case bus::ConnectFailure::Garbled:
            m.headline =
                Texts::tr("Modules answered at %1, but their answers could not be read.").arg(portName(port));
            m.body = Texts::tr(
                "Usually noise on the cable, or two modules answer at once. Check the cable, its "
                "termination and the ADDR_IN jumpers.");
            break;
    }
    m.details = Texts::tr("Port %1, %2 Bd").arg(port).arg(failed.baud);
    return m;
}

Message fewerThanExpected(int found, int expected, const QString& lastName) {
    Message m{.key = key::port(), .severity = Severity::Attention};
    m.headline = Texts::tr("%1 of %2 modules answered.").arg(found).arg(expected);
    const QString last = lastName.isEmpty() ? Texts::tr("module %1").arg(found)
                                            : Texts::tr("module %1 \"%2\"").arg(found).arg(lastName);
    m.body =
        Texts::tr(
            "Numbering starts at the far end, so look at the next module towards the PC after %1: its power "
            "first, then the plug between the two.")
            .arg(last);
    m.actions = {scanAgain(), {action::kWorkWith, Texts::tr("Work with %1").arg(found)}};
    return m;
}

Message connected(const QString& port, quint32 baud, int modules) {
    return {.key = u"connected"_s,
            .headline = Texts::tr("Connected to %1: %2 at %3 Bd.")
                            .arg(portName(port), countOfModules(modules), rate(baud)),
            .body = Texts::tr("Nothing moves until you ask for it. Gains are unknown until you apply them.")};
}

Message disconnected(const QString& port) {
    return {.key = u"connected"_s, .headline = Texts::tr("Disconnected from %1.").arg(portName(port))};
}

Message linkLost(const QString& port, int movingMotors) {
    return {.key = key::link(),
            .severity = Severity::Fault,
            .headline = Texts::tr("No module answers on %1 any more. %2")
                            .arg(portName(port), movingSentence(movingMotors)),
            .body = Texts::tr(
                "Use the hardware stop if needed. Then check the power of the modules and the cable at "
                "the PC."),
            .actions = {scanAgain()}};
}

Message badLink(int wrong, int of) {
    return {
        .key = key::badLink(),
        .severity = Severity::Fault,
        .headline =
            Texts::tr("The link is unreliable: %1 of the last %2 exchanges went wrong.").arg(wrong).arg(of),
        .body = Texts::tr(
            "Motors were stopped. Try a lower rate, a shorter cable, or termination at both ends.")};
}

Message slowAdapter(int updatesPerSecond, int latencyMs) {
    return {
        .key = u"slowAdapter"_s,
        .severity = Severity::Attention,
        .headline =
            Texts::tr("Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing "
                      "data on.")
                .arg(updatesPerSecond)
                .arg(latencyMs),
        .body = Texts::tr("Set its latency timer to 1 ms."),
        .actions = {{action::kHow, Texts::tr("How")}}};
}

Message moduleSilent(ModuleIndex module, double secondsSinceAnswer, bool wasMoving) {
    const QString since = readout(std::round(secondsSinceAnswer * 10) / 10, 2);
    return {.key = key::silent(module),
            .severity = Severity::Fault,
            .headline =
                wasMoving
                    ? Texts::tr("Module %1 has not answered for %2 s. Motor state unknown: it was moving.")
                          .arg(module.value() + 1)
                          .arg(since)
                    : Texts::tr("Module %1 has not answered for %2 s. Motor state unknown; it was stopped "
                                "at the last word.")
                          .arg(module.value() + 1)
                          .arg(since),
            .body = Texts::tr(
                "Use the hardware stop if needed. Usually its power or the plug next to it; it is asked "
                "again all the time.")};
}

Message restarted(ModuleIndex module, int modulesInChain) {
    const int number = module.value() + 1;
    QString body;
    if (number < modulesInChain)
        body = Texts::tr("Module %1 may not answer until module %2 has its address again.")
                   .arg(number + 1)
                   .arg(number);
    return {.key = key::restarted(module),
            .severity = Severity::Fault,
            .headline = Texts::tr("Module %1 restarted: its position and gains are lost.").arg(number),
            .body = body,
            .actions = {{action::kRestartNetwork, Texts::tr("Restart the network…")}}};
}

Message refused(const bus::CommandRefused& refused) {
    return {.key = key::refused(refused.module),
            .severity = Severity::Attention,
            .headline = Texts::tr("Module %1 did not understand the last command, so it was not carried out.")
                            .arg(refused.module.value() + 1),
            .body = Texts::tr("Sent again (%1 of 3). Usually noise on the cable.").arg(refused.attempt)};
}

Message garbled(ModuleIndex module) {
    return {
        .key = key::garbled(module),
        .severity = Severity::Attention,
        .headline = Texts::tr("The answer from module %1 was garbled.").arg(module.value() + 1),
        .body = Texts::tr("The command may or may not have been carried out; position is being read again.")};
}

Message operationFailed(const bus::OperationFinished& finished) {
    const int number = finished.module.value() + 1;
    Message m{.key = ofModule(u"operation"_s, finished.module), .severity = Severity::Attention};
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
                "The command may or may not have been carried out. Look at the motor; stop all if in "
                "doubt. Nothing after it was sent.");
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

Message tripped(ModuleIndex module, std::optional<int> limit) {
    const int number = module.value() + 1;
    return {.key = key::tripped(module),
            .severity = Severity::Fault,
            .headline = limit.has_value()
                            ? Texts::tr("Module %1 switched its servo off because the motor was more than "
                                        "%2 counts from where it should be.")
                                  .arg(number)
                                  .arg(*limit)
                            : Texts::tr("Module %1 switched its servo off because the motor was too far "
                                        "from where it should be.")
                                  .arg(number),
            .body = Texts::tr("Check for a jam, or raise the limit."),
            .actions = {{action::kClearAndStayOff, Texts::tr("Clear and stay off")}}};
}

Message powerLost(ModuleIndex module) {
    return {
        .key = key::power(module),
        .severity = Severity::Attention,
        .headline = Texts::tr("Module %1 has no motor power, so its servo is off.").arg(module.value() + 1),
        .body = Texts::tr("It stays off when power returns.")};
}

Message holdExpired(ModuleIndex module) {
    return {.key = ofModule(u"hold"_s, module),
            .severity = Severity::Attention,
            .headline =
                Texts::tr("Module %1 was stopped: the button was held, but the panel was too slow to say so.")
                    .arg(module.value() + 1),
            .body = Texts::tr("The computer was busy for more than 250 ms. Press and hold again.")};
}

Message notPossible(ModuleIndex module, Refusal reason) {
    return {
        .key = ofModule(u"notPossible"_s, module),
        .severity = Severity::Attention,
        .headline = Texts::tr("Not possible for module %1 now; nothing was sent.").arg(module.value() + 1),
        .body = refusal(reason)};
}

Message stopResult(const bus::StopFinished& finished, bool holding) {
    // Of its own, so that a stop that went well does not count as a repeat of one that did not.
    Message m{.key = finished.unreached.empty() ? u"stopped"_s : key::stop()};
    const auto stopped = static_cast<int>(finished.stopped.size());
    const int all = stopped + static_cast<int>(finished.unreached.size());
    if (finished.unreached.empty()) {
        const auto ms = std::llround(toSeconds(finished.took) * 1000);
        const QString text = holding ? Texts::tr("%1 of %2 stopped, %3 ms. Still holding.")
                                     : Texts::tr("%1 of %2 stopped, %3 ms. Every servo is off.");
        m.headline = text.arg(stopped).arg(all).arg(ms);
        return m;
    }
    m.severity = Severity::Fault;
    const QString who = listOfModules(finished.unreached);
    m.headline = finished.unreached.size() == 1
                     ? Texts::tr("%1 of %2 stopped. Module %3 does not answer: use the hardware stop.")
                           .arg(stopped)
                           .arg(all)
                           .arg(who)
                     : Texts::tr("%1 of %2 stopped. Modules %3 do not answer: use the hardware stop.")
                           .arg(stopped)
                           .arg(all)
                           .arg(who);
    return m;
}

QString stopReach(int reachable, int modules) {
    return Texts::tr("reaches %1 of %2").arg(reachable).arg(modules);
}

QString closing(int movingMotors) {
    return movingMotors == 1 ? Texts::tr("1 motor is moving. It will be stopped before the port closes.")
                             : Texts::tr("%1 motors are moving. They will be stopped before the port closes.")
                                   .arg(movingMotors);
}

QString stoppingBeforeClose() {
    return Texts::tr("Stopping the motors, then closing.");
}

Message safety() {
    return {.key = key::safety(),
            .headline = Texts::tr("Fit a hardware emergency stop that removes motor power."),
            .body = Texts::tr(
                "These modules have no link watchdog: when the cable, the adapter or this computer fails, "
                "a motor that runs keeps running. Stop all, and Esc, work only while the link works."),
            .actions = {{action::kUnderstood, Texts::tr("Understood")}}};
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
QString restarted(ModuleIndex module) {
    return ofModule(u"restarted"_s, module);
}
QString stop() {
    return u"stop"_s;
}
QString safety() {
    return u"safety"_s;
}
}  // namespace key

}  // namespace nmc::texts

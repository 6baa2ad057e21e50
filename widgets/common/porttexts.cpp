// SPDX-License-Identifier: GPL-3.0-or-later
// The port's part of the table of texts.
#include "link/ports/networkline.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

QString shown(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

Message::Action copyCommand() {
    return {MessageAction::CopyCommand, Texts::tr("Copy command")};
}

/// `actions`: besides copying the command, if there is one.
Message trouble(const QString& headline, const QString& body, QList<Message::Action> actions,
                const QString& command = {}) {
    if (!command.isEmpty())
        actions.prepend(copyCommand());
    return {.headline = headline, .body = body, .actions = actions, .command = command};
}

Message noPermission(const PortError& error) {
    const QString headline =
        Texts::tr("Your user account has no permission to use %1.").arg(shown(error.port));
    const QList<Message::Action> actions{choosePort(), useSimulator()};
    if (error.group.empty())
        return trouble(headline, Texts::tr("Ask your system administrator for access."), actions);
    const QString command = u"sudo usermod -aG %1 %2"_s.arg(
        shown(error.group), error.user.empty() ? u"$USER"_s : shown(error.user));
    return trouble(headline,
                   Texts::tr("It belongs to the group %1. Run %2, then log out and in again.")
                       .arg(shown(error.group), command),
                   actions, command);
}

/// The command that adds a rule to udev. It is for the user to run, because rules belong to the system.
QString intoUdev(const QString& rule) {
    return u"echo '%1' | sudo tee -a /etc/udev/rules.d/99-nmcpanel.rules"_s.arg(rule);
}

Message inUse(const PortError& error) {
    const QString headline =
        error.pid == 0 ? Texts::tr("%1 is used by another program.").arg(shown(error.port))
        : error.program.empty()
            ? Texts::tr("%1 is used by another program (pid %2).")
                  .arg(shown(error.port), QString::number(error.pid))
            : Texts::tr("%1 is used by %2 (pid %3).")
                  .arg(shown(error.port), shown(error.program), QString::number(error.pid));
    const QList<Message::Action> actions{retry(), choosePort()};
    if (error.program == "ModemManager") {
        const QString command =
            intoUdev(uR"(ACTION=="add", SUBSYSTEM=="tty", KERNEL=="ttyUSB*", ENV{ID_MM_PORT_IGNORE}="1")"_s);
        return trouble(
            headline,
            Texts::tr(
                "It probes a newly connected adapter for a modem for a few seconds; wait, then try again. To keep it away from USB adapters, run %1, then plug the adapter in again.")
                .arg(command),
            actions, command);
    }
    if (error.program.rfind("brltty", 0) == 0) {
        const QString command = u"sudo ln -s /dev/null /etc/udev/rules.d/90-brltty-usb-generic.rules"_s;
        return trouble(
            headline,
            Texts::tr(
                "It mistakes many serial adapters for a Braille display. If you have none, run %1, then plug the adapter in again.")
                .arg(command),
            actions, command);
    }
    if (error.program == "nmcpanel")
        return trouble(
            headline,
            Texts::tr(
                "Close it and try again. Or use nmcctl through it: in its Chain menu, switch on \"Let programs in\", and leave out --port."),
            actions);
    return trouble(headline, Texts::tr("Close it and try again."), actions);
}

Message staleLock(const PortError& error) {
    const QString command = u"sudo rm "_s + shown(error.lockFile);
    return trouble(Texts::tr("%1 is free, but a stale lock file marks it as in use.").arg(shown(error.port)),
                   Texts::tr("%2 left the lock file %1 behind. Remove it with %3, then try again.")
                       .arg(shown(error.lockFile), shown(error.user), command),
                   {retry(), choosePort()}, command);
}

Message portMessage(const PortError& error) {
    const QString port = shown(error.port);
    switch (error.problem) {
        case PortProblem::NoPermission:
            return noPermission(error);
        case PortProblem::InUse:
            return inUse(error);
        case PortProblem::StaleLock:
            return staleLock(error);
        case PortProblem::NoLockFolder:
            return trouble(
                Texts::tr("Could not open %1: no lock file can be created for it.").arg(port),
                Texts::tr(
                    "Your user account has no write access to %1 or any other folder for lock files. Ask your system administrator for access.")
                    .arg(shown(error.lockFile)),
                {retry(), useSimulator()});
        case PortProblem::TooManyFiles:
            return trouble(Texts::tr("Could not open %1: this program has too many open files.").arg(port),
                           Texts::tr("Close files that you do not need, or restart the program."), {retry()});
        case PortProblem::NotFound:
            return trouble(Texts::tr("%1 not found.").arg(port),
                           Texts::tr("Check that the adapter is plugged in. Its name may have changed."),
                           {retry(), choosePort(), useSimulator()});
        case PortProblem::NotASerialPort:
            return trouble(Texts::tr("%1 is not a serial port.").arg(port),
                           Texts::tr("Choose the adapter's port, for example /dev/ttyUSB0."),
                           {choosePort(), useSimulator()});
        case PortProblem::RateNotPossible:
            return trouble(Texts::tr("%1 does not support the selected baud rate.").arg(port),
                           Texts::tr("Choose another baud rate; every adapter supports 19 200 Bd."),
                           {retry(), choosePort()});
        case PortProblem::NotANetworkLine:
            return trouble(
                Texts::tr("%1 is not a line behind a network.").arg(port),
                Texts::tr(
                    "Write tcp://HOST:PORT, or rfc2217://HOST:PORT if the device server lets the rate be set."),
                {choosePort(), useSimulator()});
        case PortProblem::HostNotFound:
            return trouble(Texts::tr("The computer or device server in %1 was not found.").arg(port),
                           Texts::tr("Check its name, and the network."),
                           {retry(), choosePort(), useSimulator()});
        case PortProblem::NotReached:
            return trouble(
                Texts::tr("Nothing accepts connections at %1.").arg(port),
                Texts::tr(
                    "Check that the device server is on, that its TCP port is this one, and that no other program has it."),
                {retry(), choosePort(), useSimulator()});
        case PortProblem::NotRfc2217:
            return trouble(
                Texts::tr("%1 does not let the serial port be controlled.").arg(port),
                Texts::tr(
                    "Enable RFC 2217 in the device server, or set it to 19 200 Bd, 8N1, and connect with tcp:// instead."),
                {retry(), choosePort()});
        case PortProblem::Gone:
            return trouble(
                (isNetworkName(error.port) ? Texts::tr("The connection to %1 is lost. %2")
                                           : Texts::tr("The adapter at %1 was unplugged. %2"))
                    .arg(port, movingSentence(error.moving)),
                isNetworkName(error.port)
                    ? Texts::tr(
                          "Use the hardware stop if needed, then check the network and the device server.")
                    : Texts::tr("Use the hardware stop if needed, then plug the adapter in again."),
                {retry()});
        case PortProblem::Other:
            return trouble(Texts::tr("Could not open %1.").arg(port),
                           Texts::tr("System message: %1").arg(shown(error.detail)),
                           {retry(), choosePort(), useSimulator()});
    }
    return {};
}

}  // namespace

Message portProblem(const PortError& error) {
    Message m = portMessage(error);
    // A separate key: that the state of the motors is unknown remains true whatever is tried next with the
    // port.
    const bool gone = error.problem == PortProblem::Gone;
    m.key = gone ? key::kGone : key::kPort;
    m.severity = gone ? Severity::Fault : Severity::Attention;
    m.details = shown(error.detail);
    return m;
}

Message slowAdapter(int updatesPerSecond, int latencyMs) {
    return {
        .key = key::kSlowAdapter,
        .severity = Severity::Attention,
        .headline =
            Texts::tr(
                "Updates are slow (%1 per second) because the USB adapter waits %2 ms before passing data on.")
                .arg(updatesPerSecond)
                .arg(latencyMs),
        .body = Texts::tr("Set its latency timer to 1 ms."),
        .actions = {{MessageAction::How, Common::tr("How")}}};
}

Message latencyCure(const QString& file) {
    const QString command = u"echo 1 | sudo tee "_s + file;
    return {
        .key = u"latencyCure"_s,
        .headline = Texts::tr("Set the latency timer of the USB adapter to 1 ms, then connect again."),
        .body =
            Texts::tr("Run %1. This lasts until the adapter is unplugged. To make it permanent, also run %2.")
                .arg(command, intoUdev(uR"(ACTION=="add", SUBSYSTEM=="usb-serial", DRIVER=="ftdi_sio", )"
                                       uR"(ATTR{latency_timer}="1")"_s)),
        .actions = {copyCommand()},
        .command = command};
}

Message adapterBack(const QString& port, bool sameSerial) {
    const QString text = sameSerial ? Texts::tr("The adapter is back as %1 (same serial number). Reconnect?")
                                    : Texts::tr("A similar adapter was found as %1. Reconnect?");
    return {.key = key::kPort,
            .severity = Severity::Fault,
            .headline = text.arg(port),
            .body = Texts::tr(
                "Motors may still be moving. Reconnecting moves nothing and repeats no earlier command."),
            .actions = {{MessageAction::ConnectOffered, Texts::tr("Reconnect")}, choosePort()}};
}

Message differentAdapter(const QString& port) {
    return {.key = key::kPort,
            .severity = Severity::Attention,
            .headline = Texts::tr("A different adapter is on %1.").arg(port),
            .body = Texts::tr("The panel was connected to another adapter before. Nothing was sent."),
            .actions = {{MessageAction::ConnectOffered, Texts::tr("Connect anyway")}, choosePort()}};
}

}  // namespace nmc::texts

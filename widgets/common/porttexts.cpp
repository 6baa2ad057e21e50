// SPDX-License-Identifier: GPL-3.0-or-later
// The port's part of the table of texts.
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

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

}  // namespace nmc::texts

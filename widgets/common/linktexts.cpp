// SPDX-License-Identifier: GPL-3.0-or-later
// The link's and the chain's part of the table of texts.
#include <algorithm>
#include <cmath>

#include "model/sequence/sequencewalk.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

Message connectFailed(const bus::ConnectFailed& failed, const QString& port) {
    Message m{.key = key::kPort,
              .severity = Severity::Attention,
              .actions = {scanAgain(), restartNetwork(), useSimulator()}};
    switch (failed.reason) {
        case bus::ConnectFailure::NobodyAnswers:
            m.headline =
                failed.fixedRate
                    ? Texts::tr("The port is open, but no module answered (19 200 Bd tried).")
                    : Texts::tr(
                          "The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).");
            m.body = Texts::tr(
                "Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. If another program left the chain at an unusual baud rate, restart the network.");
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
                    "Usually the cable is too long for this baud rate, or termination is missing. Choose a lower baud rate for %1 and scan again.")
                    .arg(portName(port));
            break;
        case bus::ConnectFailure::Garbled:
            m.headline =
                Texts::tr("Modules answered at %1, but their answers were garbled.").arg(portName(port));
            m.body = Texts::tr(
                "Usually noise on the cable, or two modules answering at once. Check the cable, its termination and the ADDR_IN jumpers.");
            break;
        case bus::ConnectFailure::Collision:
            m.headline = Texts::tr("Two modules on %1 have the same address, so the modules cannot be used.")
                             .arg(portName(port));
            m.body = Texts::tr(
                "No motor was moved. Usually two ADDR_IN inputs are grounded; ground only that of the module farthest from the PC.");
            break;
        case bus::ConnectFailure::HeldLow:
            m.headline = Texts::tr("The line at %1 is held low: only zero bytes arrive.").arg(portName(port));
            m.body = Texts::tr(
                "Motor state unknown; commands may not get through. Usually a short circuit, swapped wires of a pair, or a module without power.");
            break;
        case bus::ConnectFailure::Echo:
            m.headline = Texts::tr("Only the adapter's echo came back from %1: no module answered.")
                             .arg(portName(port));
            m.body = Texts::tr(
                "The echo is harmless. Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the modules' transmit pair is wired to the adapter.");
            break;
        case bus::ConnectFailure::Disturbed:
            m.headline = Texts::tr("The line at %1 was disturbed while the modules were given addresses.")
                             .arg(portName(port));
            m.body = Texts::tr(
                "A module that had answered stopped answering, so the number of modules is unknown. No motor was moved. Check the cable and the adapter, then scan again.");
            break;
        case bus::ConnectFailure::Unaddressed:
            m.headline = Texts::tr("The modules on %1 have no addresses yet.").arg(portName(port));
            m.body = Texts::tr("A read-only connection cannot assign addresses. Choose Connect fully.");
            m.actions = {connectFully(), scanAgain()};
            break;
    }
    m.details = Texts::tr("Port %1, %2 Bd").arg(port, QString::number(failed.baud));
    return m;
}

Message fewerThanExpected(int found, int expected, const QString& lastName) {
    const QString last = lastName.isEmpty() ? Texts::tr("module %1").arg(found)
                                            : Texts::tr("module %1 \"%2\"").arg(found).arg(lastName);
    return {
        .key = key::kPort,
        .severity = Severity::Attention,
        .headline = Common::tr("%1 of %2 modules answered.").arg(found).arg(expected),
        .body =
            Texts::tr(
                "Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.")
                .arg(last),
        .actions = {scanAgain(), {MessageAction::WorkWith, Texts::tr("Work with %1").arg(found)}}};
}

Message moduleMissing(ModuleIndex module, int answering, ModuleType type) {
    return about(
        key::kSilent, module,
        {type == ModuleType::Io ? Texts::tr("%1 does not answer.").arg(moduleName(module))
                                : Texts::tr("Module %1 of this chain does not answer. Motor state unknown.")
                                      .arg(moduleNumber(module)),
         Texts::tr(
             "Check its power and the plug next to it; the panel keeps trying. If you removed it on purpose, work with the others: the panel then forgets it and its settings."),
         Severity::Fault},
        {scanAgain(), {MessageAction::WorkWith, Texts::tr("Work with %1").arg(answering)}});
}

Message chainNotAccepted() {
    return {.key = u"chainNotAccepted"_s,
            .severity = Severity::Attention,
            .headline = Texts::tr("A motor is moving, so the chain was not changed."),
            .body = Texts::tr("Forgetting a module rescans the chain. Stop all motors, then try again.")};
}

Message moduleStillUsed(const RowPlace& row, ModuleIndex module, bool otherType) {
    return {
        .key = u"chainNotAccepted"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("Row %1 of \"%2\" uses module %3, so the chain was not changed.")
                        .arg(QString::number(row.row + 1), QString::fromStdString(row.sequence),
                             moduleNumber(module)),
        .body =
            otherType
                ? Texts::tr(
                      "The row is for another type of module than the one found there. Change or remove it first, then try again.")
                : Texts::tr(
                      "Forgetting a module removes its axis from the machine. Change or remove that row first, then try again.")};
}

Message connected(const bus::ChainFound& found, const QString& port, bool knownAgain) {
    const int modules = static_cast<int>(found.modules.size());
    Message m{.key = u"connected"_s};
    if (found.readOnly) {
        m.headline = Texts::tr("Connected to %1 read-only: %2 at %3 Bd, left running.")
                         .arg(portName(port), countOfModules(modules), rate(found.baud));
        m.body = Texts::tr(
            "The modules carry on, even after you disconnect. Only status requests are sent. STOP ALL still works.");
        return m;
    }
    if (found.attached && found.commandedToStop.size() < found.modules.size()) {
        m.headline = Texts::tr("Connected to %1: %2 at %3 Bd, left running.")
                         .arg(portName(port), countOfModules(modules), rate(found.baud));
        m.body = Texts::tr("The modules carry on with what they were doing.");
        if (!knownAgain)
            m.body +=
                u' ' +
                Texts::tr(
                    "Gains are unknown until you apply them. Stop a motor before you move it: its last command is unknown.");
    } else {
        m.headline = Texts::tr("Connected to %1: %2 at %3 Bd.")
                         .arg(portName(port), countOfModules(modules), rate(found.baud));
        m.body = Texts::tr("Nothing moves until you command it. Gains are unknown until you apply them.");
    }
    if (!found.commandedToStop.empty()) {
        m.headline += u' ' + commandedToStop(found.commandedToStop);
        m.body.prepend(Texts::tr("An earlier stop was not confirmed, so it was sent now.") + u' ');
    }
    return m;
}

Message echoNoticed(const QString& port) {
    return {.key = u"echo"_s,
            .headline = Texts::tr("The adapter at %1 echoes everything it sends. The panel ignores the echo.")
                            .arg(portName(port)),
            .body = Texts::tr("This is normal for a 2-wire adapter. No action needed.")};
}

Message repliesInPieces(const QString& port, int gapMs) {
    return {
        .key = u"pieces"_s,
        .headline = Texts::tr("The adapter at %1 passes answers on in pieces, up to %2 ms apart.")
                        .arg(portName(port), QString::number(gapMs)),
        .body = Texts::tr(
            "USB hubs, Bluetooth and device servers do that. The panel waits for the rest, so updates are slower. No action needed.")};
}

Message unaddressed() {
    return {
        .key = key::kUnaddressed,
        .severity = Severity::Attention,
        .headline = Texts::tr("A module without an address also answered; it cannot be used yet."),
        .body = Texts::tr(
            "Its motor is off. Either a module has restarted, or a new one was added. Restart the network to give it an address."),
        .actions = {restartNetwork()}};
}

Message disconnected(const QString& port) {
    return {.key = u"connected"_s, .headline = Texts::tr("Disconnected from %1.").arg(portName(port))};
}

Message openAlready() {
    return {.key = u"openAlready"_s,
            .severity = Severity::Attention,
            .headline = Texts::tr("A port is already open."),
            .body = Texts::tr("Disconnect first, then try again. Closing the port may stop motors.")};
}

Message linkLost(const QString& port, const std::vector<ModuleIndex>& moving) {
    return {
        .key = key::kLink,
        .severity = Severity::Fault,
        .headline =
            Texts::tr("All modules on %1 stopped answering. %2").arg(portName(port), movingSentence(moving)),
        .body = Texts::tr(
            "Use the hardware stop if needed. Then check the power of the modules and the cable at the PC."),
        .actions = {scanAgain()}};
}

Message badLink(const bus::HealthChanged& health) {
    Message m{.key = key::kBadLink, .module = health.module, .stands = true};
    if (health.health == bus::LinkHealth::Lost) {
        m.severity = Severity::Fault;
        m.headline =
            health.module
                ? Texts::tr("The link to module %1 is unreliable: %2 of its last %3 exchanges failed.")
                      .arg(moduleNumber(*health.module), QString::number(health.wrong),
                           QString::number(health.of))
                : Texts::tr("The link is unreliable: %1 of the last %2 exchanges failed.")
                      .arg(health.wrong)
                      .arg(health.of);
        m.body = Texts::tr(
            "Motors were commanded to stop. Until answers have been correct for 2 s, only presence queries are sent; then the panel looks for the modules again. Try a lower baud rate, a shorter cable, or termination at both ends.");
        m.actions = {{MessageAction::Reconnect, Texts::tr("Reconnect")}};
        return m;
    }
    m.severity = Severity::Attention;
    m.headline = health.module
                     ? Texts::tr("The link to module %1 is marginal: %2 of its last %3 exchanges failed.")
                           .arg(moduleNumber(*health.module), QString::number(health.wrong),
                                QString::number(health.of))
                     : Texts::tr("The link is marginal: %1 of the last %2 exchanges failed.")
                           .arg(health.wrong)
                           .arg(health.of);
    m.body = Texts::tr(
        "Nothing was lost: the panel detects wrong answers and retries. If it gets worse, motors are commanded to stop. Usually noise on the cable.");
    return m;
}

Message moduleUnresponsive(ModuleIndex module, double secondsSinceAnswer, bool wasMoving, ModuleType type) {
    // An answer that came too late may have been its last a moment ago.
    const QString since = readout(std::max(0.1, std::round(secondsSinceAnswer * 10) / 10), 2);
    return about(
        key::kSilent, module,
        {(type == ModuleType::Io
              ? Texts::tr("Module %1 has not answered for %2 s. The state of its outputs is unknown.")
          : wasMoving
              ? Texts::tr("Module %1 has not answered for %2 s. Motor state unknown: it was moving.")
              : Texts::tr(
                    "Module %1 has not answered for %2 s. Motor state unknown; it was stopped when last seen."))
             .arg(moduleNumber(module), since),
         Texts::tr(
             "Use the hardware stop if needed. Check its power and the plug next to it; the panel keeps trying."),
         Severity::Fault});
}

QString lostByRestart(ModuleIndex module, ModuleType type) {
    return (type == ModuleType::Io
                ? Texts::tr(
                      "%1 restarted: its pins are inputs again, and its outputs release what they drove.")
            : type == ModuleType::Stepper ? Texts::tr("%1 restarted: its position and parameters are lost.")
                                          : Texts::tr("%1 restarted: its position and gains are lost."))
        .arg(moduleName(module));
}

Message restarted(const bus::ModuleRestarted& restarted, int modulesInChain, ModuleType type) {
    const QString number = moduleNumber(restarted.module);
    QStringList body{type == ModuleType::Io ? Texts::tr("Set its outputs again once it has its address.")
                                            : Texts::tr("Its motor is off.")};
    const int next = restarted.module.value() + 2;
    if (next <= modulesInChain)
        body << Texts::tr("Module %1 may not answer until module %2 has its address again.")
                    .arg(next)
                    .arg(number);
    if (restarted.quiet)
        body << Texts::tr(
            "It listens at 19 200 Bd and may misread the other modules' traffic: all motors were commanded to stop, and sending has stopped.");
    QList<Message::Action> actions{restartNetwork()};
    if (!restarted.quiet) {
        body << Texts::tr(
            "You can assign just its address: the other modules keep their positions and gains.");
        actions.prepend({MessageAction::Readdress, Texts::tr("Assign the address of module %1").arg(number)});
    } else {
        actions.prepend(scanAgain());
    }
    return about(u"restarted"_s, restarted.module,
                 {lostByRestart(restarted.module, type), body.join(u' '), Severity::Fault}, actions);
}

Message readdressed(const bus::Readdressed& readdressed) {
    const ModuleIndex module = readdressed.module.index;
    const ModuleType type = readdressed.module.identity.type;
    const bool io = type == ModuleType::Io;
    const bool stepper = type == ModuleType::Stepper;
    return about(
        u"restarted"_s, module,
        {(io ? Texts::tr(
                   "Module %1 has its address again. Its pins are inputs, and its outputs drive nothing.")
          : stepper
              ? Texts::tr(
                    "Module %1 has its address again. Its motor is off, its position is 0, and it has no parameters.")
              : Texts::tr(
                    "Module %1 has its address again. Its motor is off, its position is 0, and it has no gains."))
             .arg(moduleNumber(module)),
         io ? Texts::tr("The other modules are unchanged. Set its outputs again before you use it.")
         : stepper
             ? Texts::tr(
                   "The other modules are unchanged. Apply its parameters and home it before you use it.")
             : Texts::tr("The other modules are unchanged. Apply its gains and home it before you use it."),
         Severity::Normal});
}

Message addressChanged(const bus::AddressChanged& changed) {
    return {.key = u"readdress"_s,
            .headline = Texts::tr("Module %1 now has address %2. Position, gains and group are unchanged.")
                            .arg(moduleNumber(changed.module), QString::number(changed.address.value()))};
}

Message notReaddressed(const bus::ReaddressFailed& failed) {
    using Reason = bus::ReaddressFailed::Reason;
    Message m{.key = u"readdress"_s,
              .severity = Severity::Attention,
              .headline = Texts::tr("Could not assign the address of module %1. No motor was moved.")
                              .arg(moduleNumber(failed.module)),
              .actions = {scanAgain(), restartNetwork()}};
    switch (failed.reason) {
        case Reason::NotNow:
            m.body = Texts::tr("A motor is moving, or about to move. Stop all motors, then try again.");
            break;
        case Reason::NoAnswer:
            m.body = Texts::tr("The module does not answer. Scan again, or restart the network.");
            break;
        case Reason::Taken:
            m.body = Texts::tr(
                "The address is used by another module or not allowed. Choose a free address from 1 to 127.");
            m.actions.clear();
            break;
        case Reason::GroupUnknown:
            m.body = Texts::tr(
                "Its group is unknown and would change with the address. Set its group first, or none.");
            m.actions.clear();
            break;
        case Reason::Unaddressed:
            m.body = Texts::tr(
                "Another module without an address would take it. Assign that module's address first, or restart the network.");
            break;
    }
    return m;
}

Message refused(const bus::CommandRefused& refused) {
    return about(u"refused"_s, refused.module,
                 {Texts::tr("Module %1 received a garbled command and did not carry it out.")
                      .arg(moduleNumber(refused.module)),
                  Texts::tr("Sending again (%1 of 3). Usually noise on the cable.").arg(refused.attempt)});
}

Message garbled(ModuleIndex module) {
    return about(
        u"garbled"_s, module,
        {Texts::tr("The answer from module %1 was garbled.").arg(moduleNumber(module)),
         Texts::tr(
             "The command may or may not have been carried out; the panel is reading the position again.")});
}

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
// The link's and the chain's part of the table of texts.
#include <cmath>

#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

Message connectFailed(const bus::ConnectFailed& failed, const QString& port) {
    Message m{.key = key::port(),
              .severity = Severity::Attention,
              .actions = {scanAgain(), restartNetwork(), useSimulator()}};
    switch (failed.reason) {
        case bus::ConnectFailure::NobodyAnswers:
            m.headline = Texts::tr(
                "The port is open, but no module answered (9600, 19 200, 57 600 and 115 200 Bd tried).");
            m.body = Texts::tr(
                "Check, in this order: module power; every cable in the chain, one loose cable hides all modules; the ADDR_IN jumper of the module farthest from the PC; TX and RX not swapped; a full-duplex (4-wire) adapter. A chain that another program left at a rate of its own can be restarted.");
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
                    "Usually the cable is too long for this rate, or termination is missing. Choose a lower rate for %1 and scan again.")
                    .arg(portName(port));
            break;
        case bus::ConnectFailure::Garbled:
            m.headline =
                Texts::tr("Modules answered at %1, but their answers could not be read.").arg(portName(port));
            m.body = Texts::tr(
                "Usually noise on the cable, or two modules answer at once. Check the cable, its termination and the ADDR_IN jumpers.");
            break;
        case bus::ConnectFailure::Collision:
            m.headline =
                Texts::tr("Two modules answer at the same address on %1, so the modules cannot be used.")
                    .arg(portName(port));
            m.body = Texts::tr(
                "Nothing was moved. Usually two ADDR_IN inputs are grounded: only that of the module farthest from the PC may be.");
            break;
        case bus::ConnectFailure::HeldLow:
            m.headline =
                Texts::tr("The line at %1 is held low: nothing but zero bytes comes in.").arg(portName(port));
            m.body = Texts::tr(
                "Usually a short circuit, swapped wires of a pair, or a module without power. Motor state unknown; commands may not arrive either.");
            break;
        case bus::ConnectFailure::Echo:
            m.headline = Texts::tr("Only the echo of the adapter at %1 came back: no module answered.")
                             .arg(portName(port));
            m.body = Texts::tr(
                "The echo itself does no harm. Check, in this order: module power; every cable in the chain, one loose cable hides all modules; that the transmit pair of the modules is wired to the adapter, too.");
            break;
        case bus::ConnectFailure::Unaddressed:
            m.headline = Texts::tr("No module at %1 has an address yet.").arg(portName(port));
            m.body = Texts::tr(
                "A read-only connection changes nothing, so it gives no addresses. Connect without read-only.");
            m.actions = {connectFully(), scanAgain()};
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
            "Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two.")
            .arg(last);
    m.actions = {scanAgain(), {MessageAction::WorkWith, Texts::tr("Work with %1").arg(found)}};
    return m;
}

Message moduleMissing(ModuleIndex module, int answering) {
    return {
        .key = key::silent(module),
        .module = module,
        .severity = Severity::Fault,
        .headline = Texts::tr("Module %1 of the chain known here does not answer. Motor state unknown.")
                        .arg(moduleNumber(module)),
        .body = Texts::tr(
            "Its place is kept for it. Usually its power or the plug next to it; it is asked again all the time. If it was taken out on purpose, work with the others: then it is forgotten."),
        .actions = {scanAgain(), {MessageAction::WorkWith, Texts::tr("Work with %1").arg(answering)}}};
}

Message chainNotAccepted() {
    return {.key = u"chainNotAccepted"_s,
            .severity = Severity::Attention,
            .headline = Texts::tr("A motor is moving, so the chain stays as it is known."),
            .body = Texts::tr(
                "To forget a module, the chain is looked for anew. Stop all motors, then try again.")};
}

Message connected(const bus::ChainFound& found, const QString& port) {
    const int modules = static_cast<int>(found.modules.size());
    Message m{.key = u"connected"_s};
    if (found.readOnly) {
        m.headline = Texts::tr("Looking at %1 read-only: %2 at %3 Bd, left as they were.")
                         .arg(portName(port), countOfModules(modules), rate(found.baud));
        m.body = Texts::tr(
            "What they are doing goes on, also when this connection ends. Nothing is sent but questions; STOP ALL acts.");
        return m;
    }
    if (found.attached) {
        m.headline = Texts::tr("Attached to %1: %2 at %3 Bd, left as they were.")
                         .arg(portName(port), countOfModules(modules), rate(found.baud));
        m.body = Texts::tr(
            "What they were doing goes on. Gains are unknown until you apply them. Stop a motor before you move it: what it was told last cannot be asked.");
        return m;
    }
    m.headline = Texts::tr("Connected to %1: %2 at %3 Bd.")
                     .arg(portName(port), countOfModules(modules), rate(found.baud));
    m.body = Texts::tr("Nothing moves until you ask for it. Gains are unknown until you apply them.");
    return m;
}

Message echoNoticed(const QString& port) {
    return {.key = u"echo"_s,
            .headline = Texts::tr("The adapter at %1 returns what is sent to it. The panel ignores it.")
                            .arg(portName(port)),
            .body = Texts::tr("That is how a 2-wire adapter works. Nothing needs to be done.")};
}

Message unaddressed() {
    return {
        .key = key::unaddressed(),
        .severity = Severity::Attention,
        .headline = Texts::tr("A module without an address answers, too, and cannot be used yet."),
        .body = Texts::tr(
            "Either one of the chain has restarted, or a new one was added. Its motor is off. A restart of the network gives it an address."),
        .actions = {restartNetwork()}};
}

Message disconnected(const QString& port) {
    return {.key = u"connected"_s, .headline = Texts::tr("Disconnected from %1.").arg(portName(port))};
}

Message openAlready() {
    return {.key = u"openAlready"_s,
            .severity = Severity::Attention,
            .headline = Texts::tr("A port is open already."),
            .body = Texts::tr("Disconnect first; closing it may stop motors. Then look again.")};
}

Message linkLost(const QString& port, const std::vector<ModuleIndex>& moving) {
    return {
        .key = key::link(),
        .severity = Severity::Fault,
        .headline =
            Texts::tr("No module answers on %1 any more. %2").arg(portName(port), movingSentence(moving)),
        .body = Texts::tr(
            "Use the hardware stop if needed. Then check the power of the modules and the cable at the PC."),
        .actions = {scanAgain()}};
}

Message badLink(const bus::HealthChanged& health) {
    Message m{.key = key::badLink(), .module = health.module, .stands = true};
    if (health.health == bus::LinkHealth::Lost) {
        m.severity = Severity::Fault;
        m.headline =
            health.module
                ? Texts::tr("The link to module %1 is unreliable: %2 of its last %3 exchanges went wrong.")
                      .arg(moduleNumber(*health.module))
                      .arg(health.wrong)
                      .arg(health.of)
                : Texts::tr("The link is unreliable: %1 of the last %2 exchanges went wrong.")
                      .arg(health.wrong)
                      .arg(health.of);
        m.body = Texts::tr(
            "Motors were told to stop. Try a lower rate, a shorter cable, or termination at both ends.");
        m.actions = {{MessageAction::Reconnect, Texts::tr("Reconnect")}};
        return m;
    }
    m.severity = Severity::Attention;
    m.headline = health.module
                     ? Texts::tr("The link to module %1 is doubtful: %2 of its last %3 exchanges went wrong.")
                           .arg(moduleNumber(*health.module))
                           .arg(health.wrong)
                           .arg(health.of)
                     : Texts::tr("The link is doubtful: %1 of the last %2 exchanges went wrong.")
                           .arg(health.wrong)
                           .arg(health.of);
    m.body = Texts::tr(
        "Nothing was lost: wrong answers are recognised and asked for again. Motors are told to stop if it gets worse. Usually noise on the cable.");
    return m;
}

Message moduleSilent(ModuleIndex module, double secondsSinceAnswer, bool wasMoving) {
    const QString since = readout(std::round(secondsSinceAnswer * 10) / 10, 2);
    return {
        .key = key::silent(module),
        .module = module,
        .severity = Severity::Fault,
        .headline =
            wasMoving
                ? Texts::tr("Module %1 has not answered for %2 s. Motor state unknown: it was moving.")
                      .arg(moduleNumber(module))
                      .arg(since)
                : Texts::tr(
                      "Module %1 has not answered for %2 s. Motor state unknown; it was stopped at the last word.")
                      .arg(moduleNumber(module))
                      .arg(since),
        .body = Texts::tr(
            "Use the hardware stop if needed. Usually its power or the plug next to it; it is asked again all the time.")};
}

Message restarted(const bus::ModuleRestarted& restarted, int modulesInChain) {
    const QString number = moduleNumber(restarted.module);
    QStringList body{Texts::tr("Its motor is off.")};
    const int next = restarted.module.value() + 2;
    if (next <= modulesInChain)
        body << Texts::tr("Module %1 may not answer until module %2 has its address again.")
                    .arg(next)
                    .arg(number);
    if (restarted.quiet)
        body << Texts::tr(
            "It listens at 19 200 Bd, where the others' traffic is noise to it: all motors were told to stop, and nothing is sent any more.");
    QList<Message::Action> actions{restartNetwork()};
    if (!restarted.quiet) {
        body << Texts::tr("The others keep their positions and gains when it is only given its address.");
        actions.prepend({MessageAction::Readdress, Texts::tr("Give module %1 its address").arg(number)});
    } else {
        actions.prepend(scanAgain());
    }
    return {.key = key::restarted(restarted.module),
            .module = restarted.module,
            .severity = Severity::Fault,
            .headline = Texts::tr("Module %1 restarted: its position and gains are lost.").arg(number),
            .body = body.join(u' '),
            .actions = actions};
}

Message readdressed(const bus::Readdressed& readdressed) {
    return {
        .key = key::restarted(readdressed.module.index),
        .module = readdressed.module.index,
        .severity = Severity::Normal,
        .headline = Texts::tr("Module %1 has its address again. It is off, at position 0 and without gains.")
                        .arg(moduleNumber(readdressed.module.index)),
        .body =
            Texts::tr("The other modules are as they were. Send its gains and home it before you use it.")};
}

Message addressChanged(const bus::AddressChanged& changed) {
    return {
        .key = u"readdress"_s,
        .headline = Texts::tr("Module %1 has address %2 now. Position, gains and group are what they were.")
                        .arg(moduleNumber(changed.module))
                        .arg(changed.address.value())};
}

Message notReaddressed(const bus::ReaddressFailed& failed) {
    using Reason = bus::ReaddressFailed::Reason;
    Message m{.key = u"readdress"_s,
              .severity = Severity::Attention,
              .headline = Texts::tr("Module %1 was not given its address. No motor moved by it.")
                              .arg(moduleNumber(failed.module)),
              .actions = {scanAgain(), restartNetwork()}};
    switch (failed.reason) {
        case Reason::NotNow:
            m.body = Texts::tr("Something moves, or is about to. Stop all motors, then try again.");
            break;
        case Reason::NoAnswer:
            m.body = Texts::tr("It does not answer. Scan again, or restart the network.");
            break;
        case Reason::Taken:
            m.body = Texts::tr(
                "Another module answers there, or no module may have that address. Choose one of 1 to 127 that is free.");
            m.actions.clear();
            break;
        case Reason::GroupUnknown:
            m.body = Texts::tr(
                "Its group is not known here and would be changed with the address. Give it a group first, or none.");
            m.actions.clear();
            break;
    }
    return m;
}

Message refused(const bus::CommandRefused& refused) {
    return {.key = key::refused(refused.module),
            .module = refused.module,
            .severity = Severity::Attention,
            .headline = Texts::tr("Module %1 did not understand the last command, so it was not carried out.")
                            .arg(moduleNumber(refused.module)),
            .body = Texts::tr("Sent again (%1 of 3). Usually noise on the cable.").arg(refused.attempt)};
}

Message garbled(ModuleIndex module) {
    return {
        .key = key::garbled(module),
        .module = module,
        .severity = Severity::Attention,
        .headline = Texts::tr("The answer from module %1 was garbled.").arg(moduleNumber(module)),
        .body = Texts::tr("The command may or may not have been carried out; position is being read again.")};
}

}  // namespace nmc::texts

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messageactions.h"

#include <QAction>

#include "protocol/baud.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "widgets/mainwindow/connectionbar.h"

namespace nmc {

MessageActions::MessageActions(MainWindow& window, BusStore& store, BusWorker& worker, Connection& connection,
                               PortController& ports, MachineController& machine, MotionKeeper& motions,
                               FlightController& flight, MessageController& messages)
    : m_window(window),
      m_store(store),
      m_worker(worker),
      m_connection(connection),
      m_ports(ports),
      m_machine(machine),
      m_motions(motions),
      m_flight(flight),
      m_messages(messages) {
    connect(&m_window, &MainWindow::messageAction, this, &MessageActions::act);
}

void MessageActions::act(const Message& message, MessageAction action) {
    switch (action) {
        case MessageAction::ShowRecord:
            m_flight.show(message.record);
            return;  // the condition persists
        case MessageAction::Retry:
            // The message ends when the chain is found.
            return message.key == texts::key::kPort ? m_connection.reopen() : m_connection.reopenUnplugged();
        case MessageAction::ScanAgain:
        case MessageAction::Reconnect:
            return m_connection.searchAgain();
        case MessageAction::UseSimulator:
            m_window.connectionBar().choosePort(kSimulatorPort, kPowerUpBaud);
            return m_connection.open({kSimulatorPort, kPowerUpBaud});
        case MessageAction::LookFirst:
            return lookFirst(message.key);  // until the user has looked, or the motor was seen at rest
        case MessageAction::Readdress:
            return m_worker.ask(Readdress{*message.module});  // the message remains until it is done
        case MessageAction::WorkWith:
            return m_connection.acceptChain();  // ends the message if this is allowed now
        case MessageAction::ConnectOffered:
            if (const auto& offer = m_ports.offered())
                m_window.connectionBar().choosePort(offer->port, offer->baud);
            m_connection.openOffered();
            break;
        case MessageAction::How:
            m_messages.report(texts::latencyCure(m_ports.latencyFile()));
            break;
        case MessageAction::ConnectFully:
            m_connection.reopenFully();
            break;
        case MessageAction::LookedAt:
            m_motions.lookedAt(message.key);
            break;
        case MessageAction::ClearAndStayOff:
            emit intentRequested(*message.module, intent::MotorOff{});
            emit intentRequested(*message.module, intent::ClearStickyBits{});
            return;  // the message ends when the motor is off
        case MessageAction::SwitchOff:
            emit intentRequested(*message.module, intent::MotorOff{});
            return;
        case MessageAction::GainsBefore:
            if (const ModuleState* module = m_store.module(*message.module); module && module->gainsBefore)
                emit intentRequested(*message.module, intent::ApplyGains{*module->gainsBefore});
            return;
        case MessageAction::TakePosition:
            return takePosition(*message.module);  // the message ends when the position is accepted
        case MessageAction::ForgetPosition:
            return m_store.dropHome(*message.module);  // the message ends when the offer is dropped
        case MessageAction::RestoreWork:
            m_machine.restoreWork();
            break;
        case MessageAction::DiscardWork:
            m_machine.discardWork();
            break;
        case MessageAction::ChoosePort:
        case MessageAction::CopyCommand:
        case MessageAction::RestartNetwork:
        case MessageAction::StopAll:
        case MessageAction::Understood:
        case MessageAction::ShowQuestion:
            break;  // done by the window
    }
    m_messages.end(message.key);
}

/// Connects read-only to the motors that another session left.
void MessageActions::lookFirst(const QString& key) {
    if (m_worker.isOpen())
        return m_messages.report(texts::openAlready());  // closing the open connection might stop the motors
    if (const MotionKeeper::Left* left = m_motions.reportedBy(key))
        m_window.connectionBar().choosePort(left->port, left->baud);
    m_window.connectionBar().readOnlyAction()->trigger();
}

/// Sets home like a search, and therefore requires the operator right for homing.
void MessageActions::takePosition(ModuleIndex module) {
    const ModuleState* state = m_store.module(module);
    if (state == nullptr)
        return;
    if (const auto refusal = whyInaccessible(IntentKind::SaveAsHome, *state))
        m_messages.reportOf(texts::notPossible(module, texts::refusal(*refusal)));
    else
        m_store.takeHome(module);
}

}  // namespace nmc

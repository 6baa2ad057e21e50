// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>

#include "app/guardianplace.h"
#include "link/clock.h"
#include "widgets/common/apitexts.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/messages/messagemodel.h"
#include "widgets/monitor/monitordock.h"
#include "widgets/simulator/simulatordock.h"

namespace nmc {

namespace {

/// Begins a new session.
PacketSession packetSession(const QString& port, bool simulated) {
    PacketSession session;
    session.program = "NMC Panel " + QCoreApplication::applicationVersion().toStdString();
    session.startedAt = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    session.port = port.toStdString();
    session.simulated = simulated;
    session.zero = monotonicNow();
    return session;
}

}  // namespace

Composition::Composition(QSettings& settings, PortController::Places places, const QString& dataFolder,
                         const FileWriter::Disk& disk)
    : m_settings(settings),
      m_folder(dataFolder.isEmpty() ? guardFolder(settings) : dataFolder),
      m_guardian(guardianPlace(settings)),
      m_window(settings),
      m_ports(std::move(places)),
      m_machine(settings, m_window, m_store, dataFolder, disk),
      m_recordings(m_window, m_store, disk),
      m_positions(QDir(m_folder).filePath(QStringLiteral("positions")), m_store, disk),
      m_messages(m_window, m_store, m_commander.procedures(), m_positions, m_flight, m_recordings,
                 QDir(m_folder).filePath(QStringLiteral("log"))),
      m_motions(m_folder, disk, m_store, m_commander, m_messages),
      m_runs(QDir(m_folder).filePath(QStringLiteral("runs")), m_window, disk) {
    m_worker.addGuard(m_guardian);
    wirePrograms();
    wireWindow();
    wireConnection();
    wireMachine();
    connect(&m_store, &BusStore::happened, this, &Composition::take);
    connect(&m_messages, &MessageController::aboutToReport, &m_updater, &WindowUpdater::catchUp);
    m_sleep.follow(m_store);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_worker, &BusWorker::stopAll);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_commander, &Commander::endRuns);
    // When the desktop session ends: at once, while the program may still run, and without a question.
    connect(
        qApp, &QGuiApplication::commitDataRequest, this, [this] { stopAndQuit(); }, Qt::DirectConnection);
}

void Composition::show(const Start& start) {
    m_connection.enableFaults(start.enableFaults);
    m_window.show();
    if (start.quitAfterFirstPaint) {
        // The first turn of the event loop paints; the second one quits.
        QTimer::singleShot(0, this,
                           [this] { QTimer::singleShot(0, &m_window, [] { QCoreApplication::exit(0); }); });
        return;
    }
    m_motions.reportSessionsBefore(guardFolder(m_settings));
    m_settings.sync();
    if (!m_settings.isWritable() || m_settings.status() == QSettings::AccessError)
        m_messages.report(texts::settingsNotSaved(m_settings.fileName()));
    m_machine.start(start.machine);
    m_window.connectionBar().showPorts(m_ports.ports());
    if (start.programs != Start::Programs::KeptOut)
        m_api.letIn(true);
    if (start.programs == Start::Programs::MayMove)
        m_api.grantUnasked();
    if (start.port) {
        m_window.connectionBar().choosePort(*start.port, start.baud);
        m_connection.open({*start.port, start.baud, start.readOnly});
    }
}

void Composition::quit() {
    m_window.finishClose();
    QCoreApplication::quit();
}

void Composition::wirePrograms() {
    connect(&m_api, &ApiController::changed, &m_window, &MainWindow::showPrograms);
    connect(&m_api, &ApiController::controlAsked, this,
            [this](ApiServer::Client client, const QString& program) {
                m_window.askForControl(
                    program, [this, client] { return m_api.isAsking(client); },
                    [this, client](bool may) { m_api.decide(client, may); });
            });
    connect(&m_api, &ApiController::askingEnded, &m_window, [this] { AskDialog::reviewAll(m_window); });
    connect(&m_api, &ApiController::reported, &m_messages, &MessageController::report);
    connect(&m_api, &ApiController::ended, &m_messages, &MessageController::end);
    connect(&m_window.messageModel(), &MessageModel::reported, &m_api,
            [this](const MessageEntry& entry) { m_api.publish(entry.message); });

    const Requests* requests = &m_window.requests();
    connect(requests, &Requests::letProgramsIn, &m_api, &ApiController::letIn);
    connect(requests, &Requests::endProgramControl, &m_api,
            [this] { m_api.endControl(texts::ControlLost::TakenBack); });
    connect(&m_window, &MainWindow::stopAllRequested, &m_api,
            [this] { m_api.endControl(texts::ControlLost::Stopped); });
}

void Composition::wireWindow() {
    connect(&m_window, &MainWindow::connectRequested, &m_connection,
            [this](const QString& port, quint32 baud, bool readOnly) {
                m_connection.open({port, baud, readOnly});
            });
    connect(&m_window, &MainWindow::disconnectRequested, &m_connection, &Connection::close);
    connect(&m_window, &MainWindow::closeConfirmed, &m_connection, &Connection::end);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_commander, &Commander::endRuns);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_worker, &BusWorker::restart);
    connect(&m_window, &MainWindow::stopAllRequested, &m_worker, &BusWorker::stopAll);
    connect(&m_window, &MainWindow::stopAllRequested, &m_commander, &Commander::endRuns);
    connect(&m_window.simulator(), &SimulatorDock::lineEntered, &m_worker,
            [this](const QString& line) { m_worker.ask(ControlLine{line.toStdString()}); });
    connect(&m_window.monitor(), &MonitorDock::recordingChanged, &m_worker, &BusWorker::setRecording);
    connect(&m_commander.procedures(), &ProcedureController::reported, &m_window, &MainWindow::showProcedure);

    const Requests* requests = &m_window.requests();
    connect(requests, &Requests::intent, this, &Composition::carryOut);
    connect(requests, &Requests::hold, this, [this](const bus::HoldToMove& hold) {
        noteCommand({hold.module});
        if (!m_commander.hold(hold))
            m_window.endHold();  // the button shows why
    });
    connect(requests, &Requests::holdReleased, &m_worker, &BusWorker::release);
    connect(requests, &Requests::axisEdited, &m_machine, &MachineController::edit);
    connect(requests, &Requests::workOffset, &m_store, &BusStore::useWorkOffset);
    connect(requests, &Requests::copyAxis, &m_machine, &MachineController::copy);
    connect(requests, &Requests::connectFully, &m_connection, &Connection::reopenFully);
    connect(requests, &Requests::scan, &m_connection, &Connection::searchAgain);
    connect(requests, &Requests::groupCommand, this, [this](const bus::GroupCommand& command) {
        const std::vector<ModuleIndex> members = m_commander.membersOf(command.group);
        noteCommand({members.begin(), members.end()});
    });
    // ProgramController has carried these out by now.
    const auto several = [this] {
        m_api.noteSequenceCommand();
        m_connection.dropSearch();
    };
    connect(requests, &Requests::homeAll, this, several);
    connect(requests, &Requests::goToPoint, this, several);
    connect(requests, &Requests::goToPlace, this, several);
    connect(requests, &Requests::startSequence, this, several);
    connect(requests, &Requests::resumeSequence, this, several);
    connect(requests, &Requests::stepSequence, this, several);
    // A search may be waiting for just that.
    connect(requests, &Requests::stopSequence, &m_api, &ApiController::noteSequenceCommand);
    connect(requests, &Requests::lend, &m_connection, &Connection::lend);
    connect(requests, &Requests::letProgramThrough, &m_worker, &BusWorker::letThrough);
    connect(requests, &Requests::endLending, &m_worker, &BusWorker::endLending);
    connect(requests, &Requests::acceptChain, &m_connection, &Connection::acceptChain);
    connect(requests, &Requests::rate, this, [this](std::uint32_t baud) { m_worker.ask(ChangeRate{baud}); });
    connect(requests, &Requests::address, this, [this](ModuleIndex module, BusAddress address) {
        m_worker.ask(Readdress{module, address});
    });
    connect(requests, &Requests::groupChange, this, &Composition::change);
    connect(requests, &Requests::groupNamed, &m_machine, &MachineController::nameGroup);
    connect(requests, &Requests::groupCommand, &m_commander, &Commander::command);
    OperatorLock& lock = m_window.operatorLock();
    connect(&lock, &OperatorLock::rightsEdited, &m_machine, &MachineController::setOperatorRights);
    connect(&lock, &OperatorLock::changed, &m_store, [this, &lock] { m_store.setRights(lock.rights()); });
    m_store.setRights(lock.rights());
}

void Composition::wireConnection() {
    ConnectionBar& bar = m_window.connectionBar();
    connect(&bar, &ConnectionBar::portsRequested, this, [this, &bar] { bar.showPorts(m_ports.ports()); });
    connect(&m_ports, &PortController::portsChanged, &bar, &ConnectionBar::showPorts);
    connect(&m_ports, &PortController::ended, &m_window, &MainWindow::endMessage);
    connect(&m_ports, &PortController::reported, &m_window, &MainWindow::showMessage);
    connect(&m_updater, &WindowUpdater::ratesMeasured, &m_ports,
            [this](const LinkFigures& figures) { m_ports.noteRate(figures.exchangesPerSecond); });
    connect(&m_connection, &Connection::opening, this, &Composition::open);
    connect(&m_connection, &Connection::searching, this, [this] { m_messages.end(texts::key::kPort); });
    connect(&m_connection, &Connection::recovered, this, [this] {
        m_messages.end(texts::key::kGone);
        if (!m_store.link().readOnly)
            m_messages.end(texts::key::kStopWaits);
        m_messages.end(texts::key::kLink);
    });
    connect(&m_connection, &Connection::accepted, this,
            [this](const std::vector<ModuleIdentity>& present, const std::vector<ModuleIndex>& missing) {
                m_machine.acceptChain(present, missing);
                m_messages.end(texts::key::kPort);
                if (missing.empty())
                    return;
                m_positions.leaveOut(missing);
                m_runs.leaveOut(missing);
                for (const ModuleIndex module : missing)
                    m_messages.end(texts::ofModule(texts::key::kSilent, module));
            });
    connect(&m_connection, &Connection::reported, &m_messages, &MessageController::report);
    connect(&m_connection, &Connection::reportedOfChain, &m_messages, &MessageController::reportOfChain);
    connect(&m_connection, &Connection::ended, this, &Composition::quit);
}

void Composition::wireMachine() {
    connect(&m_commander, &Commander::refused, &m_messages, &MessageController::refused);
    connect(&m_commander, &Commander::stoppedBeyondTravel, &m_messages,
            &MessageController::stoppedBeyondTravel);
    connect(&m_commander, &Commander::sent, &m_machine, &MachineController::noteSent);
    connect(&m_actions, &MessageActions::intentRequested, this, &Composition::carryOut);
    connect(&m_machine, &MachineController::intentRequested, this, &Composition::carryOut);
    connect(&m_machine, &MachineController::groupChangeRequested, this, &Composition::change);
    connect(&m_machine, &MachineController::machineChanged, this, [this] {
        m_positions.setMachine(machine().name);
        m_store.setMachine(machine());
    });
    connect(&m_machine, &MachineController::taken, this,
            [this](const QString& file) { m_runs.open(file, machine()); });
    connect(&m_machine, &MachineController::hasFile, &m_runs, &RunKeeper::follow);
}

/// The user has commanded these motors: a program loses control, and a search that waits for motors to stop
/// is dropped.
void Composition::noteCommand(const std::set<ModuleIndex>& modules) {
    m_api.noteCommand(modules);
    m_connection.dropSearch();
}

void Composition::carryOut(ModuleIndex module, const Intent& intent) {
    noteCommand({module});
    m_commander.carryOut(module, intent);
}

void Composition::change(const bus::GroupChange& change) {
    m_commander.change(change);
    m_machine.noteGroup(change);
}

void Composition::open(const ConnectTarget& target, bool simulated) {
    const bool owns = !simulated && !target.readOnly;
    m_messages.end(texts::key::kPort);
    m_motions.begin(target, owns);
    m_positions.begin(target.port, owns);
    m_window.monitor().begin(packetSession(target.port, simulated));
    m_updater.begin();
}

void Composition::take(const StoreEvent& event) {
    m_messages.look();
    if (endsHold(event))
        m_window.endHold();
    m_motions.take(event);
    if (m_commander.take(event))
        return;
    m_updater.take(event);
    m_positions.take(event);
    m_recordings.take(event);
    m_messages.take(event);
    m_connection.take(event);
}

}  // namespace nmc

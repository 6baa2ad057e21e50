// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/knownchain.h"
#include "link/clock.h"
#include "link/connection/serialtransport.h"
#include "link/connection/simulatortransport.h"
#include "link/guardian/guardreport.h"
#include "model/module/modulescale.h"
#include "model/settings/pinsof.h"
#include "protocol/baud.h"
#include "sim/chainspec.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagepanel.h"
#include "widgets/paths/pathsdock.h"

namespace nmc {

namespace {

constexpr int kFrameIntervalMs = 16;
constexpr int kFiguresIntervalMs = 1'000;

/// The chain after '=', or the default one.
auto simulatedChain(const QString& port) {
    const std::string chain = port.mid(kSimulatorPort.size() + 1).toStdString();
    return sim::parseChain(chain.empty() ? sim::kDefaultChain : std::string_view(chain));
}

/// A name of this form that does not specify a valid chain is not a port at all.
bool isSimulator(const QString& port) {
    return port == kSimulatorPort ||
           (port.startsWith(kSimulatorPort + QLatin1Char('=')) && simulatedChain(port).has_value());
}

QString markerFolder(const QString& data, const QSettings& settings) {
    return data.isEmpty() ? QFileInfo(settings.fileName()).absolutePath() : data;
}

/// Begins a new session.
PacketSession packetSession(const QString& port) {
    PacketSession session;
    session.program = "NMC Panel " + QCoreApplication::applicationVersion().toStdString();
    session.startedAt = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    session.port = port.toStdString();
    session.simulated = isSimulator(port);
    session.zero = monotonicNow();
    return session;
}

/// Beside the settings, in the folder that also records which motors move.
QString guardFolder(const QSettings& settings) {
    return QFileInfo(settings.fileName()).absolutePath();
}

GuardianPlace guardianPlace(const QSettings& settings) {
    const QString folder = guardFolder(settings);
    QDir().mkpath(folder);
    const QString program =
        QCoreApplication::applicationDirPath() + QStringLiteral("/" NMC_GUARD_FOLDER "/nmcguard");
    return {QDir::cleanPath(program).toStdString(), guardReportFile(folder.toStdString())};
}

}  // namespace

Composition::Composition(QSettings& settings, PortController::Places places, const QString& dataFolder,
                         const FileWriter::Disk& disk, QObject* parent)
    : QObject(parent),
      m_settings(settings),
      m_guardian(guardianPlace(settings)),
      m_window(settings),
      m_ports(std::move(places)),
      m_machine(settings, m_window, m_store, dataFolder, disk),
      m_recordings(m_window, m_store, disk),
      m_motionMarker(markerFolder(dataFolder, settings), disk),
      m_log(QDir(markerFolder(dataFolder, settings)).filePath(QStringLiteral("log"))),
      m_positions(QDir(markerFolder(dataFolder, settings)).filePath(QStringLiteral("positions")), m_store,
                  disk),
      m_runs(QDir(markerFolder(dataFolder, settings)).filePath(QStringLiteral("runs")), m_window, disk) {
    m_worker.addGuard(m_guardian);
    keepMessages();
    keepPositions();
    keepRuns();
    wireWindow();
    wireStore();
    m_frameTimer.setInterval(kFrameIntervalMs);
    connect(&m_frameTimer, &QTimer::timeout, this, &Composition::showFrame);
    m_figuresTimer.setInterval(kFiguresIntervalMs);
    connect(&m_figuresTimer, &QTimer::timeout, this, [this] {
        if (!m_worker.isOpen())
            return m_window.showTime(monotonicNow());
        const LinkFigures figures = m_store.pullFigures(monotonicNow());
        m_window.showFigures(figures);
        if (m_store.link().phase == LinkPhase::Connected)
            m_ports.noteRate(figures.exchangesPerSecond);
    });
}

void Composition::show(const Start& start) {
    m_enableFaults = start.enableFaults;
    m_window.show();
    if (start.quitAfterFirstPaint) {
        // The first turn of the event loop paints; the second one quits.
        QTimer::singleShot(0, this,
                           [this] { QTimer::singleShot(0, &m_window, [] { QCoreApplication::exit(0); }); });
        return;
    }
    reportSessionsBefore();
    checkSettings();
    m_machine.start();
    m_runs.open({}, m_machine.machine());
    if (start.machine)
        m_machine.open(QFileInfo(*start.machine).absoluteFilePath());
    m_window.showPorts(m_ports.ports());
    if (start.port) {
        m_window.choosePort(*start.port, start.baud);
        connectTo({*start.port, start.baud, start.readOnly});
    }
}

void Composition::stopAndQuit() {
    if (!m_worker.isOpen()) {
        quit();
        return;
    }
    m_quitWhenClosed = true;
    m_openNext.reset();
    m_commander.endRuns();
    m_worker.close();
}

void Composition::quit() {
    m_window.finishClose();
    QCoreApplication::quit();
}

void Composition::wireWindow() {
    const Requests* requests = &m_window.requests();
    connect(&m_window, &MainWindow::portsRequested, this, [this] { m_window.showPorts(m_ports.ports()); });
    connect(&m_ports, &PortController::portsChanged, &m_window, &MainWindow::showPorts);
    connect(&m_ports, &PortController::ended, &m_window, &MainWindow::endMessage);
    connect(&m_ports, &PortController::reported, &m_window, &MainWindow::showMessage);
    connect(&m_window, &MainWindow::connectRequested, this,
            [this](const QString& port, quint32 baud, bool readOnly) {
                connectTo({port, baud, readOnly});
            });
    connect(&m_window, &MainWindow::connectFullyRequested, this, &Composition::connectFully);
    connect(&m_window, &MainWindow::disconnectRequested, this, &Composition::disconnectFromPort);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_commander, &Commander::endRuns);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_worker, &BusWorker::restart);
    connect(&m_window, &MainWindow::stopAllRequested, &m_worker, &BusWorker::stopAll);
    connect(&m_window, &MainWindow::stopAllRequested, &m_commander, &Commander::endRuns);
    connect(requests, &Requests::intent, this, &Composition::carryOut);
    connect(requests, &Requests::hold, this, &Composition::hold);
    wireChain();
    OperatorLock& lock = m_window.operatorLock();
    connect(&lock, &OperatorLock::rightsEdited, &m_machine, &MachineController::setOperatorRights);
    connect(&lock, &OperatorLock::changed, &m_store, [this, &lock] { m_store.setRights(lock.rights()); });
    m_store.setRights(lock.rights());
    wireSequences();
    connect(requests, &Requests::axisEdited, &m_machine, &MachineController::edit);
    connect(&m_machine, &MachineController::intentRequested, this, &Composition::carryOut);
    connect(&m_machine, &MachineController::machineChanged, this, [this] {
        m_store.setMachine(m_machine.machine());
        sendStopOutputs();
    });
    connect(requests, &Requests::holdReleased, &m_worker, &BusWorker::release);
    connect(&m_window, &MainWindow::simulatorLineEntered, this,
            [this](const QString& line) { m_worker.control(line.toStdString()); });
    connect(&m_window, &MainWindow::scopeFrameWanted, this, &Composition::showFrameSoon);
    connect(&m_window, &MainWindow::packetRecordingWanted, &m_worker, &BusWorker::setRecording);
    connect(&m_window, &MainWindow::messageAction, this, &Composition::act);
    connect(&m_window, &MainWindow::closeConfirmed, this, &Composition::stopAndQuit);
    // When the desktop session ends: at once, while the program may still run, and without a question.
    connect(
        qApp, &QGuiApplication::commitDataRequest, this, [this] { stopAndQuit(); }, Qt::DirectConnection);
}

void Composition::keepMessages() {
    MessagePanel& messages = m_window.messages();
    const auto keep = [this, &messages](const QString& line) {
        const QDateTime now = QDateTime::currentDateTime();
        m_log.write(line.toStdString(), now);
        messages.showLogFile(m_log.file(now));
    };
    connect(&messages.list(), &MessageList::told, this,
            [keep](const MessageEntry& entry) { keep(messageLine(entry)); });
    connect(&messages.list(), &MessageList::ended, this,
            [keep](const MessageEntry& entry) { keep(overLine(entry)); });
    connect(&m_log, &DayLog::failed, this, [this, &messages](const FileError& error) {
        m_messages.report(texts::messagesNotKept(error));
        messages.showLogFile({});
    });
    messages.showLogFile(m_log.file(QDateTime::currentDateTime()));
}

void Composition::keepPositions() {
    connect(&m_store, &BusStore::linkChanged, &m_positions, &PositionKeeper::look);
    connect(&m_machine, &MachineController::machineChanged, &m_positions,
            [this] { m_positions.setMachine(m_machine.machine().name); });
    connect(&m_positions, &PositionKeeper::offered, this, [this](const PositionMemory::Offer& offer) {
        const ModuleState* module = m_store.module(offer.module);
        m_messages.report(
            texts::positionRemembered(offer, scaleOf(*module, m_machine.machine().axis(offer.module))));
    });
    connect(&m_positions, &PositionKeeper::over, this,
            [this](ModuleIndex module) { m_messages.end(texts::key::position(module)); });
}

void Composition::keepRuns() {
    connect(&m_machine, &MachineController::taken, this,
            [this](const QString& file) { m_runs.open(file, m_machine.machine()); });
    connect(&m_machine, &MachineController::hasFile, &m_runs, &RunKeeper::follow);
}

/// Sets home like a search, and therefore requires the operator right for homing.
void Composition::takePosition(ModuleIndex module) {
    const ModuleState* state = m_store.module(module);
    if (state == nullptr)
        return;
    if (const auto refusal = whyInaccessible(IntentKind::SaveAsHome, *state))
        m_messages.reportOf(texts::notPossible(module, texts::refusal(*refusal)));
    else
        m_store.takeHome(module);
}

void Composition::wireStore() {
    m_linkTimer.setSingleShot(true);
    connect(&m_linkTimer, &QTimer::timeout, this, &Composition::showLink);
    connect(&m_store, &BusStore::linkChanged, this, [this] {
        showLinkSoon();
        endLeft(m_motionMarker.update(m_store.link()));
        m_messages.look();
    });
    connect(&m_messages, &MessageController::aboutToReport, this, [this] {
        if (m_linkTimer.isActive())
            showLink();
    });
    m_sleep.follow(m_store);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_worker, &BusWorker::stopAll);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_commander, &Commander::endRuns);
    connect(&m_store, &BusStore::happened, this, &Composition::take);
    connect(&m_commander, &Commander::refused, this, &Composition::refuse);
    connect(&m_commander, &Commander::sent, &m_machine, &MachineController::noteSent);
    connect(&m_commander, &Commander::aboutToMove, this,
            [this](bus::OperationId id, const std::vector<ModuleIndex>& modules) {
                m_motionMarker.asked(id, modules);
            });
    connect(&m_commander, &Commander::aboutToHold, this,
            [this](ModuleIndex module) { m_motionMarker.held(module, monotonicNow()); });
    connect(&m_commander.procedures(), &ProcedureController::reported, this, &Composition::showProcedure);
    connect(&m_commander.procedures(), &ProcedureController::idle, this, [this] {
        if (m_scanWhenIdle)
            scanAgain();
    });
}

void Composition::connectTo(const ConnectTarget& target) {
    if (m_ports.mayConnect(target))
        connectAnyway(target);
}

void Composition::connectAnyway(const ConnectTarget& target) {
    m_openNext = target;
    if (m_worker.isOpen()) {
        m_commander.endRuns();
        m_worker.close();  // PortClosed opens the next one
    } else
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Composition::openNow(const ConnectTarget& target) {
    m_target = target;
    const QString port = target.port;
    bus::EngineConfig config;
    config.baud = target.baud;
    config.readOnly = target.readOnly;
    BusWorker::TransportFactory factory;
    if (isSimulator(port)) {
        config.adapterLatency = Duration::zero();
        sim::ChainOptions options;
        options.enableFaults = m_enableFaults;
        factory = [modules = simulatedChain(port).value(), options] {
            return std::make_unique<SimulatorTransport>(modules, options);
        };
    } else {
        config.adapterLatency = m_ports.adapterLatency(port);
        config.known = knownChain(m_settings, port);
        config.knownBaud = knownRate(m_settings, port);
        factory = [port, baud = target.baud] { return std::make_unique<SerialTransport>(port, baud); };
        m_ports.opening(target);
    }
    m_messages.end(texts::key::port());
    m_motionMarker.begin(port, target.baud, !isSimulator(port) && !target.readOnly);
    m_positions.begin(port, !isSimulator(port) && !target.readOnly);
    m_store.begin(port, isSimulator(port), target.baud, target.readOnly);
    m_window.paths().setLatency(config.adapterLatency);
    m_window.beginPackets(packetSession(port));
    m_worker.open(m_transports ? m_transports(target) : std::move(factory), config);
    m_frameTimer.start();
    m_figuresTimer.start();
}

void Composition::connectFully() {
    if (m_target)
        connectTo({m_target->port, m_target->baud, false});
}

void Composition::lookFirst(const QString& key) {
    if (m_worker.isOpen())
        return m_messages.report(texts::openAlready());  // closing the open connection might stop the motors
    for (const MotionMarker::Left& left : m_motionMarker.left())
        if (texts::key::endedWhileMoving(left.file) == key)
            m_window.choosePort(left.port, left.baud);
    m_window.connectReadOnly();
}

void Composition::disconnectFromPort() {
    m_openNext.reset();
    m_commander.endRuns();
    m_worker.close();
}

void Composition::act(const Message& message, MessageAction action) {
    switch (action) {
        case MessageAction::ShowRecord:
            m_flight.show(message.key);
            return;  // the condition persists
        case MessageAction::Retry:
            return m_target ? connectTo(*m_target) : void();  // the message ends when the chain is found
        case MessageAction::ScanAgain:
        case MessageAction::Reconnect:
            return scanAgain();
        case MessageAction::UseSimulator:
            m_window.choosePort(kSimulatorPort, kPowerUpBaud);
            return connectTo({kSimulatorPort, kPowerUpBaud});
        case MessageAction::LookFirst:
            return lookFirst(message.key);  // until the user has looked, or the motor was seen at rest
        case MessageAction::Readdress:
            return m_worker.readdress(*message.module);  // the message remains until it is done
        case MessageAction::WorkWith:
            return acceptChain();  // ends the message if this is allowed now
        case MessageAction::ConnectOffered:
            connectOffered();
            break;
        case MessageAction::How:
            m_messages.report(texts::latencyCure(m_ports.latencyFile()));
            break;
        case MessageAction::ConnectFully:
            connectFully();
            break;
        case MessageAction::LookedAt:
            for (const MotionMarker::Left& left : std::vector(m_motionMarker.left()))
                if (texts::key::endedWhileMoving(left.file) == message.key)
                    m_motionMarker.forget(left.file);
            break;
        case MessageAction::ClearAndStayOff:
            carryOut(*message.module, intent::MotorOff{});
            carryOut(*message.module, intent::ClearStickyBits{});
            return;  // the message ends when the motor is off
        case MessageAction::SwitchOff:
            return carryOut(*message.module, intent::MotorOff{});
        case MessageAction::GainsBefore:
            if (const ModuleState* module = m_store.module(*message.module); module && module->gainsBefore)
                carryOut(*message.module, intent::ApplyGains{*module->gainsBefore});
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
            break;  // handled by the window
    }
    m_messages.end(message.key);
}

void Composition::connectOffered() {
    if (!m_ports.offered())
        return;
    const ConnectTarget offer = *m_ports.offered();
    m_window.choosePort(offer.port, offer.baud);
    if (m_lostPort)
        m_lostPort = offer.port;  // the same adapter under another name
    connectAnyway(offer);
}

void Composition::endLeft(const QStringList& files) {
    for (const QString& file : files)
        m_messages.end(texts::key::endedWhileMoving(file));
}

void Composition::showFrame() {
    m_window.showPackets(m_worker.takeRecords());
    std::vector<ModuleIndex> watched = m_window.watchedModules();
    for (const ModuleIndex module : m_commander.sequences().parts())
        if (!std::ranges::count(watched, module))
            watched.push_back(module);  // its arrival is awaited
    if (watched != m_watched) {
        m_watched = watched;
        m_worker.watch(watched);
    }
    // When no more data arrives, time stops where the data ended.
    const History& history = m_store.history();
    const TimePoint now = m_worker.isOpen() ? monotonicNow() : history.end().value_or(TimePoint{});
    m_flight.keep(now);
    m_window.showHistory(history, now);
}

/// The bus thread must know what STOP ALL takes low before the button is pressed.
void Composition::sendStopOutputs() {
    std::vector<bus::StopOutputs> outputs;
    for (const AxisSettings& axis : m_machine.machine().axes) {
        const PinSettings& pins = pinsOf(axis);
        outputs.push_back(
            {PinSettings::offAtStop(pins.pins), static_cast<std::uint8_t>(PinSettings::offAtStop(pins.pwm))});
    }
    if (outputs == m_stopOutputs)
        return;
    m_stopOutputs = outputs;
    m_worker.setStopOutputs(std::move(outputs));
}

/// Statuses arrive faster than numbers can be read, but changes of a module's activity and requests are shown
/// at once, because controls depend on them.
void Composition::showLinkSoon() {
    constexpr int kReadable = 40;  // ms
    const bool due = !m_linkShown.isValid() || m_linkShown.elapsed() >= kReadable;
    if (due || m_shown != Shown(m_store.link()))
        showLink();
    else if (!m_linkTimer.isActive())
        m_linkTimer.start(kReadable - static_cast<int>(m_linkShown.elapsed()));
}

void Composition::showLink() {
    m_linkTimer.stop();
    m_linkShown.start();
    m_shown = Shown(m_store.link());
    m_window.showLink(m_store.link());
}

Composition::Shown::Shown(const LinkState& link) : phase(link.phase), connection(link.connection) {
    for (const ModuleState& module : link.modules)
        modules.push_back({module.activity(), module.awaited, module.gains});
}

void Composition::showFrameSoon() {
    if (!m_frameTimer.isActive())
        QTimer::singleShot(0, this, &Composition::showFrame);
}

void Composition::reportSessionsBefore() {
    std::map<QString, std::vector<ModuleIndex>> toldByGuardian;
    for (const GuardReport& report : takeGuardReports(guardFolder(m_settings).toStdString())) {
        std::vector<ModuleIndex> modules;
        for (const std::uint8_t address : report.modules)
            modules.emplace_back(static_cast<std::uint8_t>(address - 1));
        if (const MotionMarker::Left* left = m_motionMarker.lastOf(report.process))
            toldByGuardian[left->file] = std::move(modules);
        else
            m_messages.report(texts::guardianStoppedBefore(modules));
    }
    for (const MotionMarker::Left& left : m_motionMarker.left()) {
        const auto told = toldByGuardian.find(left.file);
        m_messages.report(texts::endedWhileMoving(
            {left.modules.begin(), left.modules.end()}, left.port, left.file,
            told != toldByGuardian.end() ? std::optional(told->second) : std::nullopt));
    }
}

void Composition::checkSettings() {
    m_settings.sync();
    if (!m_settings.isWritable() || m_settings.status() == QSettings::AccessError)
        m_messages.report(texts::settingsNotSaved(m_settings.fileName()));
}

}  // namespace nmc

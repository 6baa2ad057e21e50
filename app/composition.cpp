// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition.h"

#include <QApplication>
#include <QDateTime>
#include <QWindow>

#include "link/clock.h"
#include "link/serialtransport.h"
#include "link/simulatortransport.h"
#include "model/procedures.h"
#include "protocol/baud.h"
#include "sim/chainspec.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

constexpr int kFrameIntervalMs = 33;
constexpr int kFiguresIntervalMs = 1'000;

bool isSimulator(const QString& port) {
    return port == kSimulatorPort || port.startsWith(kSimulatorPort + QLatin1Char('='));
}

/// The chain behind '=', or the default one.
std::vector<ModuleIdentity> simulatedChain(const QString& port) {
    const std::string chain = port.mid(kSimulatorPort.size() + 1).toStdString();
    // The command line has checked what a user typed; the window offers only the default.
    return sim::parseChain(chain.empty() ? sim::kDefaultChain : std::string_view(chain)).value();
}

/// A session that begins now.
PacketSession packetSession(const QString& port) {
    PacketSession session;
    session.program = "NMC Panel " + QCoreApplication::applicationVersion().toStdString();
    session.startedAt = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
    session.port = port.toStdString();
    session.simulated = isSimulator(port);
    session.zero = monotonicNow();
    return session;
}

bool isStop(const Intent& intent) {
    return std::holds_alternative<intent::StopSmoothly>(intent) ||
           std::holds_alternative<intent::StopAbruptly>(intent) ||
           std::holds_alternative<intent::MotorOff>(intent);
}

/// Where the settings remember how long the chain at a port was.
QString chainLengthKey(const QString& port) {
    return QStringLiteral("chainLength/") + QString(port).replace(QLatin1Char('/'), QLatin1Char('_'));
}

}  // namespace

Composition::Composition(QSettings& settings, PortController::Places places, QObject* parent)
    : QObject(parent),
      m_settings(settings),
      m_window(settings),
      m_ports(std::move(places)),
      m_motionMarker(settings) {
    wireWindow();
    wireStore();
    m_frameTimer.setInterval(kFrameIntervalMs);
    connect(&m_frameTimer, &QTimer::timeout, this, &Composition::showFrame);
    m_figuresTimer.setInterval(kFiguresIntervalMs);
    connect(&m_figuresTimer, &QTimer::timeout, this, [this] {
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
        // The first turn of the event loop paints; the second one ends.
        QTimer::singleShot(0, this,
                           [this] { QTimer::singleShot(0, &m_window, [] { QCoreApplication::exit(0); }); });
        return;
    }
    if (!m_motionMarker.left().empty())
        m_window.showMessage(texts::endedWhileMoving(m_motionMarker.left()));
    checkSettings();
    m_window.showPorts(m_ports.ports());
    if (start.port) {
        m_window.choosePort(*start.port, start.baud);
        connectTo(*start.port, start.baud);
    }
}

void Composition::stopAndQuit() {
    if (!m_worker.isOpen()) {
        quit();
        return;
    }
    m_quitWhenClosed = true;
    m_openNext.reset();
    m_procedures.stopAll();
    m_worker.close();
}

bool Composition::eventFilter(QObject* watched, QEvent* event) {
    // Everything is painted before the expose event is done with; the end comes after that.
    if (watched == m_window.windowHandle() && event->type() == QEvent::Expose)
        QTimer::singleShot(0, this, [] { QCoreApplication::exit(0); });
    return QObject::eventFilter(watched, event);
}

void Composition::quit() {
    m_motionMarker.clear();
    m_window.finishClose();
    QCoreApplication::quit();
}

void Composition::wireWindow() {
    connect(&m_window, &MainWindow::portsRequested, this, [this] { m_window.showPorts(m_ports.ports()); });
    connect(&m_ports, &PortController::portsChanged, &m_window, &MainWindow::showPorts);
    connect(&m_ports, &PortController::ended, &m_window, &MainWindow::endMessage);
    connect(&m_ports, &PortController::told, &m_window, &MainWindow::showMessage);
    connect(&m_window, &MainWindow::connectRequested, this, &Composition::connectTo);
    connect(&m_window, &MainWindow::disconnectRequested, this, &Composition::disconnectFromPort);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_procedures, &ProcedureController::stopAll);
    connect(&m_window, &MainWindow::restartNetworkRequested, &m_worker, &BusWorker::restart);
    connect(&m_window, &MainWindow::stopAllRequested, &m_worker, &BusWorker::stopAll);
    connect(&m_window, &MainWindow::stopAllRequested, &m_procedures, &ProcedureController::stopAll);
    connect(&m_window, &MainWindow::intentRequested, this, &Composition::carryOut);
    connect(&m_window, &MainWindow::axisEdited, this, &Composition::editAxis);
    connect(&m_window, &MainWindow::holdRequested, this,
            [this](const bus::HoldToMove& hold) { m_procedures.cancel(hold.module); });
    connect(&m_window, &MainWindow::holdRequested, &m_worker, &BusWorker::hold);
    connect(&m_window, &MainWindow::holdReleased, &m_worker, &BusWorker::release);
    connect(&m_window, &MainWindow::simulatorLineEntered, this,
            [this](const QString& line) { m_worker.control(line.toStdString()); });
    connect(&m_window, &MainWindow::packetRecordingWanted, &m_worker, &BusWorker::setRecording);
    connect(&m_window, &MainWindow::messageAction, this, &Composition::act);
    connect(&m_window, &MainWindow::closeConfirmed, this, &Composition::stopAndQuit);
    // The end of the session: at once, while the program may still run, and without a question.
    connect(
        qApp, &QGuiApplication::commitDataRequest, this, [this] { stopAndQuit(); }, Qt::DirectConnection);
}

void Composition::wireStore() {
    connect(&m_store, &BusStore::linkChanged, this, [this] {
        m_window.showLink(m_store.link());
        m_motionMarker.update(m_store.link());
    });
    connect(&m_store, &BusStore::happened, this, &Composition::tell);
    connect(&m_procedures, &ProcedureController::reported, this, &Composition::showProcedure);
}

void Composition::connectTo(const QString& port, quint32 baud) {
    if (m_ports.mayConnect(port, baud))
        connectAnyway(port, baud);
}

void Composition::connectAnyway(const QString& port, quint32 baud) {
    m_openNext = Target{port, baud};
    if (m_worker.isOpen()) {
        m_procedures.stopAll();
        m_worker.close();  // PortClosed opens the next
    } else
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Composition::openNow(const Target& target) {
    m_target = target;
    const QString port = target.port;
    bus::EngineConfig config;
    config.baud = target.baud;
    BusWorker::TransportFactory factory;
    if (isSimulator(port)) {
        config.adapterLatency = Duration::zero();
        sim::ChainOptions options;
        options.enableFaults = m_enableFaults;
        factory = [modules = simulatedChain(port), options] {
            return std::make_unique<SimulatorTransport>(modules, options);
        };
    } else {
        config.adapterLatency = m_ports.adapterLatency(port);
        factory = [port, baud = target.baud] { return std::make_unique<SerialTransport>(port, baud); };
        m_ports.opening(port, target.baud);
    }
    m_window.endMessage(texts::key::port());
    m_window.endMessage(texts::key::link());
    m_store.begin(port, isSimulator(port), target.baud);
    m_window.beginPackets(packetSession(port));
    m_worker.open(std::move(factory), config);
    m_frameTimer.start();
    m_figuresTimer.start();
}

void Composition::disconnectFromPort() {
    m_openNext.reset();
    m_procedures.stopAll();
    m_worker.close();
}

void Composition::carryOut(ModuleIndex index, const Intent& intent) {
    const ModuleState* module = m_store.module(index);
    if (module == nullptr)
        return;
    const bool stops = isStop(intent);
    if (!stops)
        m_procedures.cancel(index);
    if (std::holds_alternative<intent::CancelProcedure>(intent))
        return;
    if (auto procedure = procedureFor(intent, *module)) {
        // The one before is still stopping its motor: nothing waits in a queue to move.
        if (!m_procedures.begin(std::move(procedure)))
            m_window.showMessage(texts::notPossible(index, Refusal::Moving));
        return;
    }
    auto steps = plan(intent, *module);
    if (!steps) {
        m_procedures.cancel(index);
        m_window.showMessage(texts::notPossible(index, steps.error()));
        return;
    }
    submit(std::move(*steps));
    if (stops)
        m_procedures.overtake(index);
}

bus::OperationId Composition::submit(std::vector<bus::Step> steps) {
    const bus::OperationId id(++m_lastOperation);
    m_worker.submit({id, std::move(steps)});
    return id;
}

void Composition::showProcedure(const ProcedureReport& report) {
    m_window.showProcedure(report);
    const ModuleState* module = m_store.module(report.module);
    if (!report.over() || module == nullptr)
        return;
    const AxisUnit unit = m_machine.axis(report.module).unit;
    const AxisScale scale = module->isServo() ? AxisScale::servo(unit, module->gains ? module->gains->sr : 1)
                                              : AxisScale::step(unit);
    if (const auto message = texts::procedureEnded(report, scale))
        m_window.showMessage(*message);
}

void Composition::editAxis(ModuleIndex module, const AxisSettings& settings) {
    if (m_machine.axes.size() <= module.value())
        m_machine.axes.resize(module.value() + std::size_t{1});
    m_machine.axes[module.value()] = settings;
    m_window.showMachine(m_machine);
}

void Composition::act(const QString& key, const QString& action) {
    if (action == texts::action::kRetry && m_target)
        connectTo(m_target->port, m_target->baud);
    else if ((action == texts::action::kScanAgain || action == texts::action::kReconnect) &&
             m_worker.isOpen()) {
        if (m_procedures.anyRunning())
            return m_procedures.cancelAll();  // nothing is left running unwatched: their motors stop first
        m_worker.connectAgain();
    } else if ((action == texts::action::kScanAgain || action == texts::action::kReconnect) && m_target)
        connectTo(m_target->port, m_target->baud);
    else if (action == texts::action::kConnectOffered && m_ports.offered()) {
        const PortController::Offer offer = *m_ports.offered();
        m_window.choosePort(offer.port, offer.baud);
        connectAnyway(offer.port, offer.baud);
    } else if (action == texts::action::kHow) {
        m_window.showMessage(texts::latencyCure(m_ports.latencyFile()));
    } else if (action == texts::action::kUseSimulator) {
        m_window.choosePort(kSimulatorPort, kPowerUpBaud);
        connectTo(kSimulatorPort, kPowerUpBaud);
    } else if (action == texts::action::kClearAndStayOff) {
        clearTrip(key);
    } else if (action == texts::action::kWorkWith && m_target)
        m_settings.setValue(chainLengthKey(m_target->port), static_cast<int>(m_store.link().modules.size()));
    m_window.endMessage(key);
}

void Composition::clearTrip(const QString& key) {
    for (const ModuleState& module : m_store.link().modules)
        if (texts::key::tripped(module.info.index) == key) {
            carryOut(module.info.index, intent::MotorOff{});
            carryOut(module.info.index, intent::ClearStickyBits{});
        }
}

void Composition::showFrame() {
    m_window.showPackets(m_worker.takeRecords());
    const auto selected = m_window.selectedModule();
    if (!selected)
        return;
    if (selected != m_watched) {
        m_watched = selected;
        m_worker.watch({*selected});
    }
    if (const ModuleHistory* history = m_store.history(*selected))
        m_window.showHistory(*history, monotonicNow());
}

void Composition::tell(const StoreEvent& event) {
    // What became of a procedure's operation is for the procedure to say.
    if (m_procedures.take(event) && std::holds_alternative<bus::OperationFinished>(event))
        return;
    std::visit([this](const auto& news) { told(news); }, event);
}

void Composition::told(const bus::ChainFound& found) {
    m_window.endMessage(texts::key::link());
    const int modules = static_cast<int>(found.modules.size());
    const QString key = chainLengthKey(m_target->port);
    const int expected = m_settings.value(key, modules).toInt();
    if (modules < expected)
        m_window.showMessage(texts::fewerThanExpected(modules, expected));
    else
        m_settings.setValue(key, modules);
    m_watched.reset();
    m_window.showMessage(texts::connected(found, m_target->port));
    m_window.endMessage(texts::key::badLink());
    if (found.unaddressed)
        m_window.showMessage(texts::unaddressed());
    else
        m_window.endMessage(texts::key::unaddressed());
}

void Composition::told(const bus::ConnectFailed& failed) {
    m_window.showMessage(texts::connectFailed(failed, m_target->port));
}

void Composition::told(const bus::OperationFinished& finished) {
    if (finished.outcome != bus::Outcome::Done)
        m_window.showMessage(texts::operationFailed(finished));
}

void Composition::told(const bus::StopFinished& finished) {
    m_window.showStopResult(finished);
}

void Composition::told(const bus::ModuleSilence& silence) {
    if (!silence.silent) {
        m_window.endMessage(texts::key::silent(silence.module));
        m_window.endMessage(texts::key::link());
        return;
    }
    const ModuleState* module = m_store.module(silence.module);
    if (module == nullptr)
        return;
    const double seconds = toSeconds(monotonicNow() - module->latestTime);
    m_window.showMessage(texts::moduleSilent(silence.module, seconds, module->moving()));
}

void Composition::told(const bus::CommandRefused& refused) {
    m_window.showMessage(texts::refused(refused));
}

void Composition::told(const bus::LinkLost&) {
    // One text for one cause: the modules' own silences are part of it.
    for (const ModuleState& module : m_store.link().modules)
        m_window.endMessage(texts::key::silent(module.info.index));
    m_window.showMessage(texts::linkLost(m_target->port, m_store.movingMotors()));
}

void Composition::told(const bus::HoldExpired& expired) {
    m_window.showMessage(texts::holdExpired(expired.module));
}

void Composition::told(const bus::HealthChanged& changed) {
    if (changed.health == bus::LinkHealth::Good)
        m_window.endMessage(texts::key::badLink());
    else
        m_window.showMessage(texts::badLink(changed));
}

void Composition::told(const bus::ModuleRestarted& restarted) {
    m_window.endMessage(texts::key::silent(restarted.module));
    m_window.showMessage(texts::restarted(restarted, static_cast<int>(m_store.link().modules.size())));
}

void Composition::told(const bus::MotionSuspect& suspect) {
    m_window.showMessage(texts::motionSuspect(suspect));
}

void Composition::told(const PortClosed& closed) {
    m_window.showPackets(m_worker.takeRecords());
    m_frameTimer.stop();
    m_figuresTimer.stop();
    m_window.showFigures({});
    if (closed.error) {
        PortError error = *closed.error;
        error.port = m_target->port;
        m_window.showMessage(texts::portProblem(error));
        m_ports.closed(error);
    } else
        m_window.showMessage(texts::disconnected(m_target->port));
    if (m_quitWhenClosed)
        quit();
    else if (m_openNext)
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Composition::told(const SimulatorAnswered& answer) {
    m_window.showSimulatorAnswer(QString::fromStdString(answer.line), QByteArray::fromStdString(answer.json));
}

void Composition::told(const PanelFroze& froze) {
    // The store still has what moved before.
    if (froze.stopped || m_store.movingMotors() > 0)
        m_window.showMessage(texts::panelFroze(toSeconds(froze.length), froze.stopped));
}

void Composition::told(const MachineSlept& slept) {
    m_window.showMessage(texts::machineSlept(toSeconds(slept.length)));
}

void Composition::checkSettings() {
    m_settings.sync();
    if (!m_settings.isWritable() || m_settings.status() == QSettings::AccessError)
        m_window.showMessage(texts::settingsNotSaved(m_settings.fileName()));
}

void Composition::told(const ServoWentOff& off) {
    if (off.activity == Activity::PowerLost) {
        m_window.showMessage(texts::powerLost(off.module));
        return;
    }
    const ModuleState* module = m_store.module(off.module);
    const auto limit =
        module != nullptr && module->gains ? std::optional<int>(module->gains->el) : std::nullopt;
    m_window.showMessage(texts::tripped(off.module, limit));
}

}  // namespace nmc

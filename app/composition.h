// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSettings>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/commandline.h"
#include "app/flightcontroller.h"
#include "app/machinecontroller.h"
#include "app/messagecontroller.h"
#include "app/motionmarker.h"
#include "app/pathcontroller.h"
#include "app/portcontroller.h"
#include "app/positionkeeper.h"
#include "app/printing.h"
#include "app/recordingcontroller.h"
#include "app/runkeeper.h"
#include "app/tuningcontroller.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "link/connection/processguard.h"
#include "link/connection/sleepinhibitor.h"
#include "link/files/daylog.h"
#include "model/intent/intent.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Assembles the program; the only class that knows all layers. It converts the window's requests into
/// requests to the bus worker, and the store's events into values and messages for the window. GUI thread.
class Composition : public QObject {
    Q_OBJECT

public:
    /// `dataFolder`: holds unsaved work and records which motors move; empty: beside the settings. `disk`:
    /// can be replaced in tests.
    explicit Composition(QSettings& settings, PortController::Places places = {},
                         const QString& dataFolder = {}, const FileWriter::Disk& disk = writeFile,
                         QObject* parent = nullptr);

    /// Creates the transport that opens a port, in the bus thread.
    using Transports = std::function<BusWorker::TransportFactory(const ConnectTarget&)>;
    /// For tests, instead of the system's ports and the simulator. Call before show().
    void setTransports(Transports transports) { m_transports = std::move(transports); }

    /// Shows the window and does what the command line requests.
    void show(const Start& start);
    /// Stops the motors, closes the port and ends the program.
    void stopAndQuit();

    [[nodiscard]] BusWorker& worker() { return m_worker; }
    [[nodiscard]] MainWindow& window() { return m_window; }
    [[nodiscard]] const BusStore& store() const { return m_store; }
    [[nodiscard]] const Machine& machine() const { return m_machine.machine(); }

private:
    /// The state that the window's controls depend on.
    struct Shown {
        explicit Shown(const LinkState& link);
        LinkPhase phase;
        std::uint32_t connection;
        std::vector<std::tuple<Activity, std::optional<bus::OperationId>, std::optional<servo::SetGain>>>
            modules;
        bool operator==(const Shown&) const = default;
    };

    void quit();
    void wireWindow();
    void wireChain();
    void wireSequences();
    void wireStore();
    /// Logs messages, which outlive the session.
    void keepMessages();
    void keepPositions();
    void keepRuns();
    void takePosition(ModuleIndex module);
    void connectTo(const ConnectTarget& target);
    /// Connects without checking whether the adapter is still the same one.
    void connectAnyway(const ConnectTarget& target);
    void openNow(const ConnectTarget& target);
    /// Connects to the adapter that is back.
    void connectOffered();
    /// Connects fully to the port that is open read-only.
    void connectFully();
    /// Connects read-only to the motors that another session left, according to the message with this key.
    void lookFirst(const QString& key);
    void disconnectFromPort();
    void carryOut(ModuleIndex module, const Intent& intent);
    void refuse(ModuleIndex module, Refusal refusal, const Intent& intent);
    void hold(const bus::HoldToMove& hold);
    void showProcedure(const ProcedureReport& report);
    void showSequence(const SequenceReport& report);
    /// Passes the run to the window when it is over.
    void followSteps(const ProcedureReport& report);
    void keepRun(const ModuleState& module, const ResponseTaken& taken);
    /// Passes each edge to the window when the next one begins.
    void followSquareWave(const ProcedureReport& report);
    [[nodiscard]] std::optional<KeptResponse> recordOf(const ModuleState& module,
                                                       const ResponseTaken& taken) const;
    void act(const Message& message, MessageAction action);
    /// Ends the messages about other sessions' motors that are no longer moving.
    void endLeft(const QStringList& files);
    void scanAgain();
    /// Makes the modules that are present the expected ones; those that are missing are forgotten.
    void acceptChain();
    void showLinkSoon();
    void showLink();
    void showFrame();
    void showFrameSoon();
    void sendStopOutputs();

    void take(const StoreEvent& event);
    void on(const bus::ChainFound& found);
    /// Stores the changed addresses, so that the chain can be found again.
    void noteAddresses();
    void noteChain(const bus::ChainFound& found);
    void on(const bus::ConnectFailed& failed);
    void on(const bus::OperationFinished& finished);
    void on(const bus::StopFinished& finished);
    void on(const bus::ModuleUnresponsive& silence);
    void on(const bus::CommandRefused& refused);
    void on(const bus::LinkLost& lost);
    void on(const bus::EchoNoticed& noticed);
    void on(const bus::HoldExpired& expired);
    void on(const bus::HealthChanged& changed);
    void on(const bus::ModuleRestarted&) {}  // the module's state shows it
    void on(const bus::Readdressed& readdressed);
    void on(const bus::AddressChanged& changed);
    void on(const bus::ReaddressFailed& failed);
    void on(const bus::MotionSuspect& suspect);
    void on(const bus::StoppedBeforeLimit& stopped);
    void on(const bus::OwedStopConfirmed& confirmed);
    void on(const bus::ForeignTraffic& traffic);
    void on(const bus::ForeignMotion& motion);
    void on(const bus::GroupFinished& finished);
    void on(const bus::RateChanged& changed);
    void on(const bus::RateChangeFailed& failed);
    void on(const PortClosed& closed);
    void on(const SimulatorAnswered& answer);
    void on(const PanelFroze& froze);
    void on(const ComputerSlept& slept);
    void on(const GuardianStopped& stopped);
    void on(const GuardianMissing& missing);
    void checkSettings();
    /// Reports what earlier panels left moving, and what their guardians had to do about it.
    void reportSessionsBefore();

    QSettings& m_settings;
    ProcessGuard m_guardian;
    BusWorker m_worker;
    BusStore m_store{m_worker};
    MainWindow m_window;
    Commander m_commander{m_store, m_worker, this};
    PathController m_paths;
    PortController m_ports;
    MachineController m_machine;
    FlightController m_flight{m_window, m_store};
    RecordingController m_recordings;
    Printing m_printing{m_window, m_settings};
    MessageController m_messages{m_window, m_store, m_commander.procedures(), m_flight, m_recordings};
    MotionMarker m_motionMarker;
    DayLog m_log;
    TuningController m_tuning{m_window.stepResponses()};
    PositionKeeper m_positions;
    RunKeeper m_runs;
    SleepInhibitor m_sleep;
    QTimer m_linkTimer;
    QElapsedTimer m_linkShown;
    std::optional<Shown> m_shown;
    QTimer m_frameTimer;
    QTimer m_figuresTimer;
    Transports m_transports;
    std::optional<ConnectTarget> m_target;         ///< the present connection, or the last one
    std::optional<ConnectTarget> m_openNext;       ///< opened when the present connection has closed
    std::vector<bus::StopOutputs> m_stopOutputs;   ///< as last sent to the worker
    std::vector<ModuleIndex> m_watched;            ///< polled most by the worker: shown in panels and scope
    std::optional<QString> m_lostPort;             ///< where the state of motors became unknown
    std::map<ModuleIndex, ResponseTaken> m_steps;  ///< the last one of each module that was stored
    std::map<ModuleIndex, ResponseTaken> m_edges;  ///< the last one of each running square wave
    bool m_quitWhenClosed = false;
    bool m_scanWhenIdle = false;  ///< as soon as no procedure and no sequence is running
    bool m_enableFaults = false;
    bool m_guardianMissed = false;  ///< the message about it has been shown
};

}  // namespace nmc

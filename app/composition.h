// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <set>

#include "app/apicontroller.h"
#include "app/commandline.h"
#include "app/connection.h"
#include "app/flightcontroller.h"
#include "app/looptestcontroller.h"
#include "app/machinecontroller.h"
#include "app/messageactions.h"
#include "app/messagecontroller.h"
#include "app/motionkeeper.h"
#include "app/portcontroller.h"
#include "app/positionkeeper.h"
#include "app/printing.h"
#include "app/programcontroller.h"
#include "app/recordingcontroller.h"
#include "app/runkeeper.h"
#include "app/tuningcontroller.h"
#include "app/windowupdater.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "link/connection/processguard.h"
#include "link/connection/sleepinhibitor.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Assembles the program; the only class that knows all layers. It connects the window's requests, the bus
/// worker, and the controllers between them, and does nothing itself. GUI thread.
class Composition : public QObject {
    Q_OBJECT

public:
    /// `dataFolder`: holds unsaved work and records which motors move; empty: beside the settings. `disk`:
    /// can be replaced in tests.
    explicit Composition(QSettings& settings, PortController::Places places = {},
                         const QString& dataFolder = {}, const FileWriter::Disk& disk = writeFile);

    /// Shows the window and does what the command line requests.
    void show(const Start& start);
    /// Stops the motors, closes the port and ends the program.
    void stopAndQuit() { m_connection.end(); }

    [[nodiscard]] BusWorker& worker() { return m_worker; }
    [[nodiscard]] MainWindow& window() { return m_window; }
    [[nodiscard]] Connection& connection() { return m_connection; }
    [[nodiscard]] const BusStore& store() const { return m_store; }
    [[nodiscard]] const Machine& machine() const { return m_machine.machine(); }

private:
    void wirePrograms();
    void wireWindow();
    void wireConnection();
    void wireMachine();
    void noteCommand(const std::set<ModuleIndex>& modules);
    void carryOut(ModuleIndex module, const Intent& intent);
    void change(const bus::GroupChange& change);
    void open(const ConnectTarget& target, bool simulated);
    void take(const StoreEvent& event);
    void quit();

    // A signal reaches its receivers in the order in which they were connected, which is that of the members:
    // the window shows a state before a message about it.
    QSettings& m_settings;
    const QString m_folder;
    ProcessGuard m_guardian;
    BusWorker m_worker;
    BusStore m_store{m_worker};
    MainWindow m_window;
    Commander m_commander{m_store, m_worker, this};
    PortController m_ports;
    Connection m_connection{m_settings, m_store, m_worker, m_commander, m_ports};
    MachineController m_machine;
    FlightController m_flight{m_window, m_store};
    RecordingController m_recordings;
    WindowUpdater m_updater{m_window, m_store, m_worker, m_commander, m_flight};
    PositionKeeper m_positions;
    LoopTestController m_loopTests{m_window, m_store, m_commander.procedures()};
    MessageController m_messages;
    MotionKeeper m_motions;
    ProgramController m_program{m_window, m_store, m_machine, m_commander, m_messages};
    MessageActions m_actions{m_window,  m_store,   m_worker, m_connection, m_ports,
                             m_machine, m_motions, m_flight, m_messages};
    TuningController m_tuning{m_window};
    ApiController m_api{m_store, m_worker, m_connection, m_commander};
    RunKeeper m_runs;
    Printing m_printing{m_window, m_settings};
    SleepInhibitor m_sleep;
};

}  // namespace nmc

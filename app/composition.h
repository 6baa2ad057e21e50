// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "app/commandline.h"
#include "app/motionmarker.h"
#include "app/portcontroller.h"
#include "link/busstore.h"
#include "link/busworker.h"
#include "model/intent.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// The program, put together: the only class that knows every layer. It turns what the window asks for into
/// requests to the bus worker, and what the store tells into values and messages for the window. GUI thread.
class Composition : public QObject {
    Q_OBJECT

public:
    explicit Composition(QSettings& settings, PortController::Places places = {}, QObject* parent = nullptr);

    /// Shows the window and does what the command line asked for.
    void show(const Start& start);
    /// Stops the motors, closes the port, and ends the program.
    void stopAndQuit();

    [[nodiscard]] BusWorker& worker() { return m_worker; }
    [[nodiscard]] MainWindow& window() { return m_window; }
    [[nodiscard]] const BusStore& store() const { return m_store; }

protected:
    /// Waits for the first paint, for the start-up benchmark.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Target {
        QString port;
        quint32 baud = 0;
    };

    void quit();
    void wireWindow();
    void wireStore();
    void connectTo(const QString& port, quint32 baud);
    /// The same without asking whether that is still the adapter it was.
    void connectAnyway(const QString& port, quint32 baud);
    void openNow(const Target& target);
    void disconnectFromPort();
    void carryOut(ModuleIndex module, const Intent& intent);
    void editAxis(ModuleIndex module, const AxisSettings& settings);
    void act(const QString& key, const QString& action);
    /// Of the module that the message of this key is about.
    void clearTrip(const QString& key);
    void showFrame();

    void tell(const StoreEvent& event);
    void told(const bus::ChainFound& found);
    void told(const bus::ConnectFailed& failed);
    void told(const bus::OperationFinished& finished);
    void told(const bus::StopFinished& finished);
    void told(const bus::ModuleSilence& silence);
    void told(const bus::CommandRefused& refused);
    void told(const bus::LinkLost& lost);
    void told(const bus::HoldExpired& expired);
    void told(const bus::HealthChanged& changed);
    void told(const bus::ModuleRestarted& restarted);
    void told(const bus::MotionSuspect& suspect);
    void told(const bus::GroupFinished& finished);
    void told(const bus::RateChanged& changed);
    void told(const bus::RateChangeFailed& failed);
    void told(const PortClosed& closed);
    void told(const ServoWentOff& off);
    void told(const SimulatorAnswered& answer);
    void told(const PanelFroze& froze);
    void told(const MachineSlept& slept);
    void checkSettings();

    QSettings& m_settings;
    BusWorker m_worker;
    BusStore m_store{m_worker};
    MainWindow m_window;
    PortController m_ports;
    MotionMarker m_motionMarker;
    QTimer m_frameTimer;
    QTimer m_figuresTimer;
    Machine m_machine;                     ///< what the user has told of it
    std::optional<Target> m_target;        ///< what is connected, or was last
    std::optional<Target> m_openNext;      ///< to be opened when the present connection has closed
    std::optional<ModuleIndex> m_watched;  ///< what the worker polls most: panel and scope show it
    bool m_quitWhenClosed = false;
    bool m_enableFaults = false;
    std::uint32_t m_lastOperation = 0;
};

}  // namespace nmc

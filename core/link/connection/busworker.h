// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bus/engineconfig.h"
#include "bus/types.h"
#include "link/connection/busloop.h"

namespace nmc {

/// The bus loop (link/connection/busloop.h) as an object of the GUI thread: says by a signal that there is
/// something to take, and beats for as long as the event loop turns. All public members belong to the GUI
/// thread but for stopAll() and close(), which may be called from any and from a signal handler. What is
/// asked and told can be logged (link/connection/linklog.h). A read-only connection stops motors at stopAll()
/// only.
class BusWorker : public QObject {
    Q_OBJECT

public:
    using TransportFactory = BusLoop::TransportFactory;

    explicit BusWorker(QObject* parent = nullptr);

    /// Is told what stops the motors (BusLoop::addGuard). Before open().
    void addGuard(LoopGuard& guard) { m_loop.addGuard(guard); }

    /// Opens a connection; `factory` runs in the bus thread. Ends in PortOpened or PortClosed. A connection
    /// that is open is closed first, and what it had to tell and was not taken is dropped.
    void open(TransportFactory factory, bus::EngineConfig config);
    /// Stops the motors, closes the port; PortClosed follows.
    void close() { m_loop.close(); }
    [[nodiscard]] bool isOpen() const { return m_loop.isOpen(); }

    /// Finds the chain anew, as after open().
    void connectAgain();
    /// Restarts the network: positions and gains are lost. Motors are stopped first.
    void restart();
    /// Modules that somebody looks at are polled more often (Engine::watch).
    void watch(std::vector<ModuleIndex> modules) { m_loop.watch(std::move(modules)); }
    /// One module as fast as the wire carries, for 5 s at most; nothing: no longer (Engine::focus).
    void focus(std::optional<ModuleIndex> module) { m_loop.focus(module); }
    /// Gains that are being tried on it stay (Engine::keepTrial).
    void keepTrial(ModuleIndex module) { m_loop.keepTrial(module); }
    /// Which outputs of PIC-I/O modules a stop of all takes low, by module (Engine::setStopOutputs).
    void setStopOutputs(std::vector<bus::StopOutputs> outputs) { m_loop.setStopOutputs(std::move(outputs)); }
    /// How far each axis may go, as its chip counts now (Engine::setTravelLimits).
    void setTravelLimits(std::vector<bus::TravelLimits> limits) { m_loop.setTravelLimits(std::move(limits)); }
    /// Ends in exactly one bus::OperationFinished: Cancelled at once when too much waits already, or when
    /// nothing is connected. So do the next three, each in its own event.
    void submit(bus::Operation operation);
    /// bus::GroupFinished follows.
    void submit(bus::GroupOperation operation);
    /// Gives a module that restarted its address back; bus::Readdressed or bus::ReaddressFailed follows.
    void readdress(ModuleIndex module);
    /// Resets one module and gives it its address again; ends likewise.
    void resetModule(ModuleIndex module, const std::optional<servo::HardReset>& configuration = {});
    /// Gives a module another address; bus::AddressChanged or bus::ReaddressFailed follows.
    void changeAddress(ModuleIndex module, BusAddress address);
    /// Takes the chain to another rate; bus::RateChanged or bus::RateChangeFailed follows.
    void changeRate(std::uint32_t baud);
    /// A control line for the built-in simulator (sim/control.h); SimulatorAnswered follows. A real port
    /// neither hears nor answers it.
    void control(std::string line);
    void hold(const bus::HoldToMove& hold);
    void release();
    void stopAll() { m_loop.stopAll(); }
    /// Records every exchange from now on, of this connection and the next ones, for takeRecords(); off at
    /// first.
    void setRecording(bool on) { m_loop.setRecording(on); }

    /// Everything since the last call, oldest first; when too many samples wait, the oldest of them are gone.
    /// PortClosed is the last thing that is told of a connection.
    [[nodiscard]] std::vector<WorkerEvent> takeEvents();
    [[nodiscard]] bus::LinkStatistics statistics() const { return m_loop.statistics(); }
    /// The exchanges recorded since the last call, oldest first; when too many wait, the oldest are gone,
    /// which shows in their numbers. Nothing announces them: whoever shows them asks at his own pace.
    [[nodiscard]] std::vector<bus::ExchangeRecord> takeRecords() { return m_loop.takeRecords(); }

    /// For tests: tells how long the machine has been suspended so far, in the bus thread. Before open().
    void setSleepClock(std::function<Duration()> clock) { m_loop.setSleepClock(std::move(clock)); }

signals:
    /// There is something to take; emitted from the bus thread, without data.
    void eventsReady();

private:
    void log(const std::vector<WorkerEvent>& events);

    BusLoop m_loop{[this] { emit eventsReady(); }};
    QTimer m_beatTimer;
    std::size_t m_droppedSamples = 0;  ///< as logged
};

}  // namespace nmc

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

/// The bus loop (link/connection/busloop.h) as an object of the GUI thread: a signal reports that there are
/// events to take, and the heartbeat runs as long as the event loop does. All public members belong to the
/// GUI thread, except stopAll() and close(), which may be called from any thread and from a signal handler.
/// Requests and events can be logged (link/connection/linklog.h). A read-only connection stops motors only at
/// stopAll().
class BusWorker : public QObject {
    Q_OBJECT

public:
    using TransportFactory = BusLoop::TransportFactory;

    explicit BusWorker(QObject* parent = nullptr);

    /// Adds a guard that is kept informed of how to stop the motors (BusLoop::addGuard). Call before open().
    void addGuard(LoopGuard& guard) { m_loop.addGuard(guard); }

    /// Opens a connection; `factory` runs in the bus thread. The result is PortOpened or PortClosed. A
    /// connection that is already open is closed first, and its events not yet taken are dropped.
    void open(TransportFactory factory, bus::EngineConfig config);
    /// Stops the motors and closes the port; PortClosed follows.
    void close() { m_loop.close(); }
    [[nodiscard]] bool isOpen() const { return m_loop.isOpen(); }

    /// Searches for the chain again, as after open().
    void connectAgain();
    /// Restarts the network, which loses positions and gains. Motors are stopped first.
    void restart();
    /// Polls the modules on display more often (Engine::watch).
    void watch(std::vector<ModuleIndex> modules) {
        change([&](auto& pending) { pending.watched = std::move(modules); });
    }
    /// Polls one module as fast as the line allows, for at most 5 s; nothing ends it (Engine::focus).
    void focus(std::optional<ModuleIndex> module) {
        change([&](auto& pending) { pending.focused = module; });
    }
    /// Keeps the gains being tried on a module (Engine::keepTrial).
    void keepTrial(ModuleIndex module) {
        change([&](auto& pending) { pending.kept.push_back(module); });
    }
    /// Sets, for each module, the PIC-I/O outputs that a stop of everything takes low
    /// (Engine::setStopOutputs).
    void setStopOutputs(std::vector<bus::StopOutputs> outputs) {
        change([&](auto& pending) { pending.stopOutputs = std::move(outputs); });
    }
    /// Sets the travel limits of each axis in its chip's present counts (Engine::setTravelLimits).
    void setTravelLimits(std::vector<bus::TravelLimits> limits) {
        change([&](auto& pending) { pending.travelLimits = std::move(limits); });
    }
    /// Ends in exactly one event (link/connection/busrequest.h): at once with a refusal when too many
    /// requests are waiting, or when nothing is connected. A real port ignores a control line.
    void ask(BusRequest request);
    void hold(const bus::HoldToMove& hold);
    void release();
    void stopAll() { m_loop.stopAll(); }
    /// A stop has been requested since the last connection ended; until open().
    [[nodiscard]] bool stopWaits() const { return m_loop.stopWaits(); }
    /// Lends the line to the program that opens a terminal at `path` (docs/lending.md): LineLent or
    /// LendingProblem follows. Until it is over, every other request is refused, except for a stop of all
    /// modules, after which the program is held off until letThrough().
    void lend(std::string path);
    void letThrough();
    void endLending();
    /// Records every exchange from now on for takeRecords(), in this connection and later ones; initially
    /// off.
    void setRecording(bool on) { m_loop.setRecording(on); }

    /// Returns everything since the last call, oldest first; when too many samples wait, the oldest are
    /// dropped. PortClosed is the last event of a connection.
    [[nodiscard]] std::vector<WorkerEvent> takeEvents();
    [[nodiscard]] bus::LinkStatistics statistics() const { return m_loop.statistics(); }
    /// Returns the exchanges recorded since the last call, oldest first; when too many wait, the oldest are
    /// dropped, which leaves a gap in their numbers. There is no notification: the display polls at its own
    /// pace.
    [[nodiscard]] std::vector<bus::ExchangeRecord> takeRecords() { return m_loop.takeRecords(); }

    /// Replaces the clock of suspended time, which is read in the bus thread; for tests. Call before open().
    void setSleepClock(std::function<Duration()> clock) { m_loop.setSleepClock(std::move(clock)); }

signals:
    /// There are events to take; emitted from the bus thread, without data.
    void eventsReady();

private:
    void change(auto how) { m_loop.requestBox().change(how); }
    void log(const std::vector<WorkerEvent>& events);

    BusLoop m_loop{[this] { emit eventsReady(); }};
    QTimer m_beatTimer;
    std::size_t m_droppedSamples = 0;  ///< last number logged
};

}  // namespace nmc

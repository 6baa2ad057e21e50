// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/boundedqueue.h"
#include "base/eventqueue.h"
#include "bus/engine.h"
#include "bus/types.h"
#include "link/connection/busrequest.h"
#include "link/connection/heartbeat.h"
#include "link/connection/requestbox.h"
#include "link/connection/suspendwatch.h"
#include "link/connection/transport.h"
#include "link/connection/workerevent.h"

namespace nmc {

/// Runs one connection in a thread of its own: owns the transport and the engine there, for as long as it is
/// open. The loop blocks in Transport::receive() only; requests reach it through queues and a wake-up, so the
/// GUI never waits for the bus and a frozen GUI never delays a stop.
///
/// All public members belong to the GUI thread but for stopAll() and close(), which may be called from any
/// and from a signal handler. As long as a connection is open the GUI thread must turn its event loop: motors
/// that move are stopped when it has not for 2 s (link/connection/heartbeat.h).
class BusWorker : public QObject {
    Q_OBJECT

public:
    using TransportFactory = std::function<std::unique_ptr<Transport>()>;

    explicit BusWorker(QObject* parent = nullptr);
    /// Stops the motors and closes the port, waiting for it.
    ~BusWorker() override;

    /// Opens a connection; `factory` runs in the bus thread. Ends in PortOpened or PortClosed. A connection
    /// that is open is closed first, and what it had to tell and was not taken is dropped.
    void open(TransportFactory factory, bus::EngineConfig config);
    /// Stops the motors, closes the port; PortClosed follows.
    void close();
    [[nodiscard]] bool isOpen() const { return m_thread != nullptr; }

    /// Finds the chain anew, as after open().
    void connectAgain();
    /// Restarts the network: positions and gains are lost. Motors are stopped first.
    void restart();
    /// Modules that somebody looks at are polled more often (Engine::watch).
    void watch(std::vector<ModuleIndex> modules);
    /// One module as fast as the wire carries, for 5 s at most; nothing: no longer (Engine::focus).
    void focus(std::optional<ModuleIndex> module);
    /// Ends in exactly one bus::OperationFinished: Cancelled at once when too much waits already, or when
    /// nothing is connected; so do the next three in their events.
    void submit(bus::Operation operation);
    /// bus::GroupFinished follows.
    void submit(bus::GroupOperation operation);
    /// Takes the chain to another rate; bus::RateChanged or bus::RateChangeFailed follows.
    void changeRate(std::uint32_t baud);
    void hold(const bus::HoldToMove& hold);
    void release();
    void stopAll();
    /// A control line for the built-in simulator (sim/control.h); SimulatorAnswered follows. A real port
    /// neither hears nor answers it.
    void control(std::string line);
    /// Records every exchange from now on, of this connection and the next ones, for takeRecords(); off at
    /// first.
    void setRecording(bool on);

    /// Everything since the last call, oldest first; when too many samples wait, the oldest of them are gone.
    /// PortClosed is the last thing that is told of a connection.
    [[nodiscard]] std::vector<WorkerEvent> takeEvents();
    [[nodiscard]] bus::LinkStatistics statistics() const;
    /// The exchanges recorded since the last call, oldest first; when too many wait, the oldest are gone,
    /// which shows in their numbers. Nothing announces them: whoever shows them asks at his own pace.
    [[nodiscard]] std::vector<bus::ExchangeRecord> takeRecords() { return m_records.takeAll(); }

    /// For tests: tells how long the machine has been suspended so far, in the bus thread. Before open().
    void setSleepClock(std::function<Duration()> clock) { m_asleepSoFar = std::move(clock); }

signals:
    /// There is something to take; emitted from the bus thread, without data.
    void eventsReady();

private:
    void run(const TransportFactory& factory, const bus::EngineConfig& config);
    /// Until it is closed; otherwise tells why it could not go on.
    std::optional<PortError> converse(Transport& transport, bus::Engine& engine);
    void takeRequests(Transport& transport, bus::Engine& engine, TimePoint now);
    void take(BusRequest& request, Transport& transport, bus::Engine& engine, TimePoint now);
    void search(RequestBox::Search how, bus::Engine& engine, TimePoint now);
    tl::expected<void, PortError> perform(Transport& transport, const std::vector<bus::Output>& outputs);
    /// Stops the motors when nobody else can see to it.
    void guard(bus::Engine& engine, TimePoint now);
    /// Returns true when a stop has finished.
    bool publish(bus::Engine& engine);
    void publishStatistics(const bus::LinkStatistics& statistics);
    void beat();
    void record(bus::Engine& engine);
    void post(WorkerEvent event);
    void ask(BusRequest request);
    void joinThread();

    std::unique_ptr<QThread> m_thread;
    QTimer m_beatTimer;
    Heartbeat m_heartbeat;
    SuspendWatch m_suspendWatch;  ///< bus thread
    std::function<Duration()> m_asleepSoFar;
    RequestBox m_requests;
    OpenRequests m_openRequests;        ///< bus thread
    bool m_restartWhenStopped = false;  ///< bus thread
    EventQueue<WorkerEvent> m_events;
    std::atomic<bool> m_recording{false};
    bool m_engineRecords = false;  ///< bus thread: what the engine has been told
    BoundedQueue<bus::ExchangeRecord> m_records;
    mutable std::mutex m_statisticsMutex;
    bus::LinkStatistics m_statistics;
};

}  // namespace nmc

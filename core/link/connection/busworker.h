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
#include "bus/engine.h"
#include "bus/types.h"
#include "link/connection/heartbeat.h"
#include "link/connection/suspendwatch.h"
#include "link/connection/transport.h"
#include "link/connection/wakeup.h"
#include "link/ports/linktypes.h"

namespace nmc {

/// The port is open and discovery begins.
struct PortOpened {};
/// The connection is over: by close(), or for the reason given.
struct PortClosed {
    std::optional<PortError> error;
};

/// The built-in simulator's answer to a control line.
struct SimulatorAnswered {
    std::string line;  ///< as it was given
    std::string json;
};

/// The GUI thread did not turn its event loop for so long.
struct PanelFroze {
    Duration length{};
    bool stopped = false;  ///< motors moved, so they were stopped after Heartbeat::kStopAfter
};

/// The computer was suspended and has woken; motors were told to stop.
struct MachineSlept {
    Duration length{};
};

using WorkerEvent =
    std::variant<bus::Event, PortOpened, PortClosed, SimulatorAnswered, PanelFroze, MachineSlept>;

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

    /// Opens a connection; `factory` runs in the bus thread. Ends in PortOpened or PortClosed. An open
    /// connection must have been closed before.
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

    /// Everything since the last call, oldest first.
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
    struct Release {};
    struct ConnectAgain {};
    struct Restart {};
    struct ChangeRate {
        std::uint32_t baud;
    };
    struct Watch {
        std::vector<ModuleIndex> modules;
    };
    struct Focus {
        std::optional<ModuleIndex> module;
    };
    struct ControlLine {
        std::string text;
    };
    using Request = std::variant<bus::Operation, bus::GroupOperation, bus::HoldToMove, Release, ConnectAgain,
                                 Restart, ChangeRate, Watch, Focus, ControlLine>;

    void run(const TransportFactory& factory, const bus::EngineConfig& config);
    void converse(Transport& transport, bus::Engine& engine);
    void takeRequests(Transport& transport, bus::Engine& engine, TimePoint now);
    void restartNetwork(bus::Engine& engine, TimePoint now);
    void answer(Transport& transport, ControlLine& line);
    tl::expected<void, PortError> perform(Transport& transport, const std::vector<bus::Output>& outputs);
    /// Stops the motors when nobody else can see to it.
    void guard(bus::Engine& engine, TimePoint now);
    /// Returns true when a stop has finished.
    bool publish(bus::Engine& engine);
    void publishStatistics(const bus::Engine& engine);
    void beat();
    void record(bus::Engine& engine);
    void post(WorkerEvent event);
    void ask(Request request);
    void joinThread();

    std::unique_ptr<QThread> m_thread;
    QTimer m_beatTimer;
    Heartbeat m_heartbeat;
    SuspendWatch m_suspendWatch;  ///< bus thread
    std::function<Duration()> m_asleepSoFar;
    Wakeup m_wakeup;
    std::atomic<bool> m_stopRequested{false};
    std::atomic<bool> m_closeRequested{false};
    bool m_restartWhenStopped = false;  ///< bus thread
    BoundedQueue<Request> m_requests;
    BoundedQueue<WorkerEvent> m_events;
    std::atomic<bool> m_recording{false};
    bool m_engineRecords = false;  ///< bus thread: what the engine has been told
    BoundedQueue<bus::ExchangeRecord> m_records;
    mutable std::mutex m_statisticsMutex;
    bus::LinkStatistics m_statistics;
};

}  // namespace nmc

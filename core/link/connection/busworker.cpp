// SPDX-License-Identifier: MIT
#include "link/connection/busworker.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "link/clock.h"
#include "link/connection/crashburst.h"
#include "link/threadpriority.h"

namespace nmc {

namespace {

/// What the GUI may fall behind before the oldest samples are dropped: a minute at the wire's limit.
constexpr std::size_t kEventCapacity = 1U << 17U;
constexpr std::size_t kRequestCapacity = 1'024;
/// Half a minute of exchanges at the wire's limit.
constexpr std::size_t kRecordCapacity = 1U << 14U;
/// How often the counters are handed over while the bus is busy; they are shown once a second.
constexpr Duration kStatisticsEvery = std::chrono::milliseconds(100);
/// How long closing waits for the motors to confirm their stop.
constexpr Duration kCloseTimeout = std::chrono::seconds(1);
/// A thread with its event dispatcher, a port and its lock file. Qt aborts when there is none left.
constexpr std::size_t kDescriptorsNeeded = 8;

bool descriptorsLeft() {
    std::array<int, kDescriptorsNeeded> fds{};
    for (int& fd : fds)
        fd = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const bool enough = fds.back() >= 0;
    for (const int fd : fds)
        if (fd >= 0)
            ::close(fd);
    return enough;
}

}  // namespace

BusWorker::BusWorker(QObject* parent)
    : QObject(parent),
      m_asleepSoFar(asleepSoFar),
      m_requests(kRequestCapacity),
      m_events(kEventCapacity),
      m_records(kRecordCapacity) {
    m_beatTimer.setInterval(std::chrono::duration_cast<std::chrono::milliseconds>(Heartbeat::kInterval));
    connect(&m_beatTimer, &QTimer::timeout, this, &BusWorker::beat);
}

BusWorker::~BusWorker() {
    close();
    joinThread();
}

void BusWorker::open(TransportFactory factory, bus::EngineConfig config) {
    joinThread();
    (void)m_requests.takeAll();
    (void)m_records.takeAll();
    m_stopRequested = false;
    m_closeRequested = false;
    if (!descriptorsLeft()) {
        post(PortClosed{PortError{PortProblem::TooManyFiles, {}, {}, {}, {}, 0}});
        return;
    }
    m_heartbeat.begin(monotonicNow());
    m_beatTimer.start();
    m_suspendWatch = {};
    m_restartWhenStopped = false;
    m_thread.reset(QThread::create([this, factory = std::move(factory), config] { run(factory, config); }));
    m_thread->setObjectName(QStringLiteral("bus"));
    m_thread->start();
}

void BusWorker::close() {
    m_closeRequested = true;
    m_wakeup.wake();
}

void BusWorker::connectAgain() {
    ask(ConnectAgain{});
}

void BusWorker::watch(std::vector<ModuleIndex> modules) {
    ask(Watch{std::move(modules)});
}

void BusWorker::focus(std::optional<ModuleIndex> module) {
    ask(Focus{module});
}

void BusWorker::restart() {
    ask(Restart{});
}

void BusWorker::submit(bus::Operation operation) {
    ask(std::move(operation));
}

void BusWorker::submit(bus::GroupOperation operation) {
    ask(operation);
}

void BusWorker::changeRate(std::uint32_t baud) {
    ask(ChangeRate{baud});
}

void BusWorker::hold(const bus::HoldToMove& hold) {
    ask(hold);
}

void BusWorker::release() {
    ask(Release{});
}

void BusWorker::stopAll() {
    m_stopRequested = true;
    m_wakeup.wake();
}

void BusWorker::control(std::string line) {
    ask(ControlLine{std::move(line)});
}

void BusWorker::setRecording(bool on) {
    m_recording = on;
}

std::vector<WorkerEvent> BusWorker::takeEvents() {
    std::vector<WorkerEvent> events = m_events.takeAll();
    for (const WorkerEvent& event : events)
        if (std::holds_alternative<PortClosed>(event))
            joinThread();
    return events;
}

bus::LinkStatistics BusWorker::statistics() const {
    const std::scoped_lock lock(m_statisticsMutex);
    return m_statistics;
}

void BusWorker::run(const TransportFactory& factory, const bus::EngineConfig& config) {
    const crashburst::HandlerStack stack;
    preferThisThread();
    const std::unique_ptr<Transport> transport = factory();
    if (const auto opened = transport->open(); !opened) {
        post(PortClosed{opened.error()});
        return;
    }
    post(PortOpened{});
    bus::Engine engine(config);
    m_engineRecords = false;
    record(engine);
    engine.connect(monotonicNow());
    converse(*transport, engine);
    publishStatistics(engine);
    crashburst::disarm();
}

void BusWorker::converse(Transport& transport, bus::Engine& engine) {
    std::optional<TimePoint> closeBy;
    TimePoint published{};
    while (true) {
        const TimePoint now = monotonicNow();
        if (m_closeRequested && !closeBy) {
            closeBy = now + kCloseTimeout;
            engine.stopAll(now);
        }
        takeRequests(transport, engine, now);
        guard(engine, now);
        if (const auto deadline = engine.nextDeadline(); deadline && *deadline <= now)
            engine.onDeadline(now);
        // Before the command that changes it leaves.
        if (const auto burst = engine.changedStopBurst())
            crashburst::arm(transport.fd(), *burst);
        if (const auto performed = perform(transport, engine.takeOutput()); !performed) {
            post(PortClosed{performed.error()});
            return;
        }
        const bool stopped = publish(engine);
        if (stopped && std::exchange(m_restartWhenStopped, false))
            engine.restart(now);
        record(engine);
        if (closeBy && (stopped || now >= *closeBy)) {
            post(PortClosed{});
            return;
        }

        auto until = engine.nextDeadline();
        for (const auto& other : {closeBy, m_heartbeat.deadline(engine.anythingMoves())})
            if (other && (!until || *other < *until))
                until = other;
        // When nothing is to happen for long, they would be old for as long.
        if (now - published >= kStatisticsEvery || !until || *until - now > kStatisticsEvery) {
            publishStatistics(engine);
            published = now;
        }
        const auto bytes = transport.receive(until, m_wakeup.fd());
        if (!bytes) {
            post(PortClosed{bytes.error()});
            return;
        }
        if (!bytes->empty())
            engine.onBytes(*bytes, monotonicNow());
    }
}

void BusWorker::takeRequests(Transport& transport, bus::Engine& engine, TimePoint now) {
    m_wakeup.reset();
    if (m_stopRequested.exchange(false))
        engine.stopAll(now);
    for (Request& request : m_requests.takeAll()) {
        if (auto* operation = std::get_if<bus::Operation>(&request))
            engine.submit(std::move(*operation), now);
        else if (const auto* group = std::get_if<bus::GroupOperation>(&request))
            engine.submit(*group, now);
        else if (const auto* rate = std::get_if<ChangeRate>(&request))
            engine.changeRate(rate->baud, now);
        else if (const auto* hold = std::get_if<bus::HoldToMove>(&request))
            engine.hold(*hold, now);
        else if (std::holds_alternative<Release>(request))
            engine.release(now);
        else if (auto* line = std::get_if<ControlLine>(&request))
            answer(transport, *line);
        else if (const auto* watched = std::get_if<Watch>(&request))
            engine.watch(watched->modules);
        else if (const auto* focus = std::get_if<Focus>(&request))
            engine.focus(focus->module, now);
        else if (std::holds_alternative<ConnectAgain>(request))
            engine.connect(now);
        else
            restartNetwork(engine, now);
    }
}

void BusWorker::guard(bus::Engine& engine, TimePoint now) {
    if (m_heartbeat.missed(now, engine.anythingMoves()))
        engine.stopAll(now);
    if (const auto slept = m_suspendWatch.check(m_asleepSoFar())) {
        engine.distrust(now);
        engine.stopAll(now);
        post(MachineSlept{*slept});
    }
}

void BusWorker::restartNetwork(bus::Engine& engine, TimePoint now) {
    if (!engine.anythingMoves()) {
        engine.restart(now);
        return;
    }
    m_restartWhenStopped = true;
    engine.stopAll(now);
}

void BusWorker::answer(Transport& transport, ControlLine& line) {
    if (auto json = transport.control(line.text))
        post(SimulatorAnswered{std::move(line.text), std::move(*json)});
}

tl::expected<void, PortError> BusWorker::perform(Transport& transport,
                                                 const std::vector<bus::Output>& outputs) {
    for (const bus::Output& output : outputs) {
        // This process is dying in another thread, which has said the last word to the motors.
        while (crashburst::underWay())
            QThread::msleep(1);
        tl::expected<void, PortError> done;
        if (const auto* baud = std::get_if<bus::SetHostBaud>(&output))
            done = transport.setBaud(baud->baud);
        else if (const auto* send = std::get_if<bus::Send>(&output))
            done = transport.send(send->bytes);
        else
            transport.discardInput();
        if (!done)
            return done;
    }
    return {};
}

bool BusWorker::publish(bus::Engine& engine) {
    bool stopped = false;
    for (bus::Event& event : engine.takeEvents()) {
        stopped = stopped || std::holds_alternative<bus::StopFinished>(event);
        post(std::move(event));
    }
    return stopped;
}

void BusWorker::publishStatistics(const bus::Engine& engine) {
    const std::scoped_lock lock(m_statisticsMutex);
    m_statistics = engine.statistics();
}

void BusWorker::beat() {
    if (const auto gap = m_heartbeat.beat(monotonicNow()); gap && isOpen())
        post(PanelFroze{gap->length, gap->stopped});
}

void BusWorker::record(bus::Engine& engine) {
    if (m_engineRecords)
        for (bus::ExchangeRecord& exchange : engine.takeRecords())
            m_records.push(std::move(exchange));
    const bool wanted = m_recording.load(std::memory_order_relaxed);
    if (wanted != std::exchange(m_engineRecords, wanted))
        engine.setRecording(wanted);
}

void BusWorker::post(WorkerEvent event) {
    if (m_events.push(std::move(event)))
        emit eventsReady();
}

void BusWorker::ask(Request request) {
    m_requests.push(std::move(request));
    m_wakeup.wake();
}

void BusWorker::joinThread() {
    m_beatTimer.stop();
    if (m_thread)
        m_thread->wait();
    m_thread.reset();
}

}  // namespace nmc

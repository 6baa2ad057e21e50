// SPDX-License-Identifier: MIT
#include "link/connection/busworker.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "base/overloaded.h"
#include "link/clock.h"
#include "link/connection/crashburst.h"
#include "link/threadpriority.h"

namespace nmc {

namespace {

/// What the GUI may fall behind before the oldest samples are dropped: a minute at the wire's limit.
constexpr std::size_t kSampleCapacity = 1U << 17U;
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
    : QObject(parent), m_asleepSoFar(asleepSoFar), m_events(kSampleCapacity), m_records(kRecordCapacity) {
    m_beatTimer.setInterval(std::chrono::duration_cast<std::chrono::milliseconds>(Heartbeat::kInterval));
    connect(&m_beatTimer, &QTimer::timeout, this, &BusWorker::beat);
}

BusWorker::~BusWorker() {
    close();
    joinThread();
}

void BusWorker::open(TransportFactory factory, bus::EngineConfig config) {
    close();
    joinThread();
    (void)m_events.takeAll();
    (void)m_records.takeAll();
    publishStatistics({});
    if (!descriptorsLeft()) {
        post(PortClosed{PortError{PortProblem::TooManyFiles, {}, {}, {}, {}, 0}});
        return;
    }
    m_requests.begin();
    m_heartbeat.begin(monotonicNow());
    m_beatTimer.start();
    m_suspendWatch = {};
    m_restartWhenStopped = false;
    m_thread.reset(QThread::create([this, factory = std::move(factory), config] { run(factory, config); }));
    m_thread->setObjectName(QStringLiteral("bus"));
    m_thread->start();
}

void BusWorker::close() {
    m_requests.close();
}

void BusWorker::connectAgain() {
    m_requests.search(RequestBox::Search::Again);
}

void BusWorker::restart() {
    m_requests.search(RequestBox::Search::Restart);
}

void BusWorker::watch(std::vector<ModuleIndex> modules) {
    m_requests.watch(std::move(modules));
}

void BusWorker::focus(std::optional<ModuleIndex> module) {
    m_requests.focus(module);
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
    m_requests.hold(hold);
}

void BusWorker::release() {
    m_requests.release();
}

void BusWorker::stopAll() {
    m_requests.stopAll();
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
    PortClosed closed;
    const std::unique_ptr<Transport> transport = factory();
    if (const auto opened = transport->open()) {
        post(PortOpened{});
        bus::Engine engine(config);
        m_engineRecords = false;
        record(engine);
        engine.connect(monotonicNow());
        closed.error = converse(*transport, engine);
        publishStatistics(engine.statistics());
        crashburst::disarm();
    } else {
        closed.error = opened.error();
    }
    for (WorkerEvent& end : m_openRequests.abandon())
        post(std::move(end));
    for (const BusRequest& request : m_requests.end())
        post(refusal(request));
    post(closed);
}

std::optional<PortError> BusWorker::converse(Transport& transport, bus::Engine& engine) {
    std::optional<TimePoint> closeBy;
    TimePoint published{};
    while (true) {
        const TimePoint now = monotonicNow();
        if (m_requests.closeWanted() && !closeBy) {
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
        if (const auto performed = perform(transport, engine.takeOutput()); !performed)
            return performed.error();
        const bool stopped = publish(engine);
        if (stopped && std::exchange(m_restartWhenStopped, false))
            engine.restart(now);
        record(engine);
        if (closeBy && (stopped || now >= *closeBy))
            return std::nullopt;

        auto until = engine.nextDeadline();
        for (const auto& other : {closeBy, m_heartbeat.deadline(engine.anythingMoves())})
            if (other && (!until || *other < *until))
                until = other;
        // When nothing is to happen for long, they would be old for as long.
        if (now - published >= kStatisticsEvery || !until || *until - now > kStatisticsEvery) {
            publishStatistics(engine.statistics());
            published = now;
        }
        const auto bytes = transport.receive(until, m_requests.wakeFd());
        if (!bytes)
            return bytes.error();
        if (!bytes->empty())
            engine.onBytes(*bytes, monotonicNow());
    }
}

void BusWorker::takeRequests(Transport& transport, bus::Engine& engine, TimePoint now) {
    RequestBox::Taken taken = m_requests.take();
    if (taken.stop)
        engine.stopAll(now);
    if (taken.released)
        engine.release(now);
    if (taken.search)
        search(*taken.search, engine, now);
    for (BusRequest& request : taken.requests)
        take(request, transport, engine, now);
    if (taken.watched)
        engine.watch(*taken.watched);
    if (taken.focused)
        engine.focus(*taken.focused, now);
    if (taken.held)
        engine.hold(*taken.held, now);
}

void BusWorker::take(BusRequest& request, Transport& transport, bus::Engine& engine, TimePoint now) {
    if (!std::holds_alternative<ControlLine>(request))
        m_openRequests.begin(request);
    std::visit(Overloaded{
                   [&](bus::Operation& operation) { engine.submit(std::move(operation), now); },
                   [&](const bus::GroupOperation& operation) { engine.submit(operation, now); },
                   [&](const ChangeRate& change) { engine.changeRate(change.baud, now); },
                   [&](ControlLine& line) {
                       if (auto json = transport.control(line.text))
                           post(SimulatorAnswered{std::move(line.text), std::move(*json)});
                   },
               },
               request);
}

void BusWorker::search(RequestBox::Search how, bus::Engine& engine, TimePoint now) {
    switch (how) {
        case RequestBox::Search::Again:
            m_restartWhenStopped = false;
            engine.connect(now);
            break;
        case RequestBox::Search::Restart:
            m_restartWhenStopped = engine.anythingMoves();
            if (m_restartWhenStopped)
                engine.stopAll(now);
            else
                engine.restart(now);
            break;
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

tl::expected<void, PortError> BusWorker::perform(Transport& transport,
                                                 const std::vector<bus::Output>& outputs) {
    for (const bus::Output& output : outputs) {
        // This process is dying in another thread, which has said the last word to the motors.
        while (crashburst::underWay())
            QThread::msleep(1);
        tl::expected<void, PortError> done;
        std::visit(Overloaded{
                       [&](const bus::SetHostBaud& rate) { done = transport.setBaud(rate.baud); },
                       [&](const bus::Send& send) { done = transport.send(send.bytes); },
                       [&](const bus::DiscardInput&) { transport.discardInput(); },
                   },
                   output);
        if (!done)
            return done;
    }
    return {};
}

bool BusWorker::publish(bus::Engine& engine) {
    bool stopped = false;
    for (bus::Event& event : engine.takeEvents()) {
        stopped = stopped || std::holds_alternative<bus::StopFinished>(event);
        m_openRequests.onEvent(event);
        post(std::move(event));
    }
    return stopped;
}

void BusWorker::publishStatistics(const bus::LinkStatistics& statistics) {
    const std::scoped_lock lock(m_statisticsMutex);
    m_statistics = statistics;
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
    const bool sample = isSample(event);
    if (sample ? m_events.pushSample(std::move(event)) : m_events.pushNews(std::move(event)))
        emit eventsReady();
}

void BusWorker::ask(BusRequest request) {
    if (!m_requests.offer(request))
        post(refusal(request));
}

void BusWorker::joinThread() {
    m_beatTimer.stop();
    if (m_thread)
        m_thread->wait();
    m_thread.reset();
}

}  // namespace nmc

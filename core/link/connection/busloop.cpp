// SPDX-License-Identifier: MIT
#include "link/connection/busloop.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "link/clock.h"
#include "link/connection/bussession.h"
#include "link/connection/crashburst.h"
#include "link/threadpriority.h"
#include "protocol/baud.h"

namespace nmc {

namespace {

/// Descriptors for a thread with its event dispatcher, a port and its lock file. Qt aborts when there are
/// none left.
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

BusLoop::BusLoop(std::function<void()> eventsReady, std::size_t samples)
    : m_channel(std::move(eventsReady), samples), m_asleepSoFar(asleepSoFar) {}

BusLoop::~BusLoop() {
    close();
    join();
}

void BusLoop::open(TransportFactory factory, bus::EngineConfig config) {
    const unsigned closes = m_channel.requests.closes() + 1;  // including the close() below
    close();
    join();
    (void)m_channel.events.takeAll();
    (void)m_channel.records.takeAll();
    m_channel.publish({});
    if (!descriptorsLeft()) {
        m_channel.post(
            PortClosed{PortError{PortProblem::TooManyFiles, {}, {}, {}, {}}, std::move(config.unconfirmed)});
        return;
    }
    m_channel.requests.begin(closes);
    m_channel.heartbeat.begin();
    m_thread = std::thread([this, factory = std::move(factory), config] { run(factory, config); });
}

void BusLoop::ask(BusRequest request) {
    m_channel.heartbeat.commanded(monotonicNow());
    if (!m_channel.requests.offer(request))
        m_channel.post(refusal(request, isOpen() ? bus::Outcome::QueueFull : bus::Outcome::Cancelled));
}

void BusLoop::beat() {
    if (const auto gap = m_channel.heartbeat.beat(monotonicNow()); gap && isOpen())
        m_channel.post(PanelFroze{gap->length, gap->stopped});
}

std::vector<WorkerEvent> BusLoop::takeEvents() {
    std::vector<WorkerEvent> events = m_channel.events.takeAll();
    for (const WorkerEvent& event : events) {
        const auto* busEvent = std::get_if<bus::Event>(&event);
        if (busEvent != nullptr && std::holds_alternative<bus::ChainFound>(*busEvent))
            m_channel.heartbeat.found();
        if (std::holds_alternative<PortClosed>(event))
            join();
    }
    return events;
}

void BusLoop::run(const TransportFactory& factory, const bus::EngineConfig& config) {
    ::pthread_setname_np(::pthread_self(), "bus");
    const crashburst::HandlerStack stack;
    preferThisThread();
    PortClosed closed{{}, config.unconfirmed};
    const std::unique_ptr<Transport> transport = factory();
    if (const auto opened = transport->open()) {
        bus::EngineConfig measured = config;
        measured.adapterLatency = std::max(config.adapterLatency, transport->latency());
        measured.fixedRate = transport->hasFixedRate();
        if (measured.knownBaud != 0) {
            // The adapter may be another one than then. A rate that it cannot make would end the search.
            if (!transport->setBaud(measured.knownBaud))
                measured.knownBaud = 0;
            (void)transport->setBaud(kPowerUpBaud);  // if this fails, so does the session's first request
        }
        m_channel.post(PortOpened{measured.adapterLatency});
        BusSession session(m_channel, *transport, measured, m_guards, m_asleepSoFar);
        closed.error = session.run();
        closed.unconfirmed = session.unconfirmedStops();
        for (WorkerEvent& end : session.abandon())
            m_channel.post(std::move(end));
    } else {
        closed.error = opened.error();
    }
    for (const BusRequest& request : m_channel.requests.end())
        m_channel.post(refusal(request, bus::Outcome::Cancelled));
    m_channel.post(std::move(closed));
}

void BusLoop::join() {
    if (m_thread.joinable())
        m_thread.join();
}

}  // namespace nmc

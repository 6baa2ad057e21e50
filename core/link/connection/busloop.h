// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "bus/engineconfig.h"
#include "link/connection/buschannel.h"
#include "link/connection/crashguard.h"
#include "link/connection/loopguard.h"
#include "link/connection/transport.h"
#include "link/connection/workerevent.h"

namespace nmc {

/// Runs one connection in its own thread, which owns the transport and the engine while the connection is
/// open. The loop blocks only in Transport::receive(); requests reach it through a box and a wake-up, so the
/// requester never waits for the bus, and a frozen requester never delays a stop. This class is free of Qt;
/// BusWorker connects it to Qt.
///
/// All public members belong to one thread, the GUI's, except stopAll() and close(), which may be called from
/// any thread and from a signal handler. While a connection is open, the GUI thread must call beat() every
/// Heartbeat::kInterval: once it shows a chain or has asked for something, moving motors are stopped when it
/// has not done so for 2 s (link/connection/heartbeat.h). A read-only connection (EngineConfig::readOnly)
/// stops motors only at stopAll(): not for a missing heartbeat, not when it is closed, and not through a
/// guard.
class BusLoop {
public:
    using TransportFactory = std::function<std::unique_ptr<Transport>()>;

    /// `eventsReady`: called from either thread when takeEvents() has something again; must not block. When
    /// more than `samples` samples wait, the oldest are dropped.
    explicit BusLoop(std::function<void()> eventsReady, std::size_t samples = BusChannel::kSamples);
    /// Stops the motors, closes the port and waits until that is done.
    ~BusLoop();
    BusLoop(const BusLoop&) = delete;
    BusLoop& operator=(const BusLoop&) = delete;

    /// Adds a guard that is kept informed of how to stop the motors, besides the guard against crashes. It is
    /// borrowed and called in the bus thread. Call before open().
    void addGuard(LoopGuard& guard) { m_guards.push_back(&guard); }
    /// Replaces the clock of suspended time, which is read in the bus thread; for tests. Call before open().
    void setSleepClock(std::function<Duration()> clock) { m_asleepSoFar = std::move(clock); }

    /// Opens a connection; `factory` runs in the bus thread. The result is PortOpened or PortClosed. A
    /// connection that is already open is closed first, and its events not yet taken are dropped.
    void open(TransportFactory factory, bus::EngineConfig config);
    /// Stops the motors and closes the port; PortClosed follows.
    void close() { m_channel.requests.close(); }
    /// True until PortClosed has been taken.
    [[nodiscard]] bool isOpen() const { return m_thread.joinable(); }

    void stopAll() { m_channel.requests.stopAll(); }
    [[nodiscard]] bool stopWaits() const { return m_channel.requests.stopWaits(); }
    /// Requests of which only the latest counts, unlike those that ask() queues.
    [[nodiscard]] RequestBox& requestBox() { return m_channel.requests; }
    /// Every request ends in its event (busrequest.h): a refusal comes at once when too many requests are
    /// waiting, or when nothing is connected.
    void ask(BusRequest request);
    void setRecording(bool on) { m_channel.recording = on; }
    /// Reports that the GUI thread is alive.
    void beat();

    /// Returns everything since the last call, oldest first; when too many samples wait, the oldest are
    /// dropped. PortClosed is the last event of a connection.
    [[nodiscard]] std::vector<WorkerEvent> takeEvents();
    /// The number of samples dropped so far.
    [[nodiscard]] std::size_t droppedSamples() const { return m_channel.events.dropped(); }
    [[nodiscard]] bus::LinkStatistics statistics() const { return m_channel.statistics(); }
    [[nodiscard]] std::vector<bus::ExchangeRecord> takeRecords() { return m_channel.records.takeAll(); }

private:
    void run(const TransportFactory& factory, const bus::EngineConfig& config);
    void join();

    BusChannel m_channel;
    CrashGuard m_crashGuard;
    std::vector<LoopGuard*> m_guards{&m_crashGuard};
    std::function<Duration()> m_asleepSoFar;
    std::thread m_thread;
};

}  // namespace nmc

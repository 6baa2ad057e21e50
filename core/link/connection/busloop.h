// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bus/engineconfig.h"
#include "link/connection/buschannel.h"
#include "link/connection/crashguard.h"
#include "link/connection/loopguard.h"
#include "link/connection/transport.h"
#include "link/connection/workerevent.h"

namespace nmc {

/// Runs one connection in a thread of its own: owns the transport and the engine there, for as long as it is
/// open. The loop blocks in Transport::receive() only; requests reach it through a box and a wake-up, so who
/// asks never waits for the bus, and a frozen asker never delays a stop. Without Qt; BusWorker is its Qt
/// edge.
///
/// All public members belong to one thread, the GUI's, but for stopAll() and close(), which may be called
/// from any and from a signal handler. As long as a connection is open that thread must call beat() every
/// Heartbeat::kInterval: motors that move are stopped when it has not for 2 s (link/connection/heartbeat.h).
/// A read-only connection (EngineConfig::readOnly) stops them at stopAll() only: neither then nor when it is
/// closed, nor through a guard.
class BusLoop {
public:
    using TransportFactory = std::function<std::unique_ptr<Transport>()>;

    /// `eventsReady`: takeEvents() has something again; called from either thread, and must not wait. Of
    /// `samples` the oldest go when more wait.
    explicit BusLoop(std::function<void()> eventsReady, std::size_t samples = BusChannel::kSamples);
    /// Stops the motors and closes the port, waiting for it.
    ~BusLoop();
    BusLoop(const BusLoop&) = delete;
    BusLoop& operator=(const BusLoop&) = delete;

    /// Is told what stops the motors, beside the guard against crashes; borrowed, and called in the bus
    /// thread. Before open().
    void addGuard(LoopGuard& guard) { m_guards.push_back(&guard); }
    /// How long the machine has been suspended so far, asked in the bus thread; for tests. Before open().
    void setSleepClock(std::function<Duration()> clock) { m_asleepSoFar = std::move(clock); }

    /// Opens a connection; `factory` runs in the bus thread. Ends in PortOpened or PortClosed. A connection
    /// that is open is closed first, and what it had to tell and was not taken is dropped.
    void open(TransportFactory factory, bus::EngineConfig config);
    /// Stops the motors, closes the port; PortClosed follows.
    void close() { m_channel.requests.close(); }
    /// Until PortClosed was taken.
    [[nodiscard]] bool isOpen() const { return m_thread.joinable(); }

    void stopAll() { m_channel.requests.stopAll(); }
    void hold(const bus::HoldToMove& hold) { m_channel.requests.hold(hold); }
    void release() { m_channel.requests.release(); }
    /// Each ends in its event (busrequest.h): in a refusal at once when too much waits already, or when
    /// nothing is connected.
    void ask(BusRequest request);
    void search(RequestBox::Search how) { m_channel.requests.search(how); }
    void watch(std::vector<ModuleIndex> modules) { m_channel.requests.watch(std::move(modules)); }
    void focus(std::optional<ModuleIndex> module) { m_channel.requests.focus(module); }
    void keepTrial(ModuleIndex module) { m_channel.requests.keepTrial(module); }
    void setStopOutputs(std::vector<bus::StopOutputs> outputs) {
        m_channel.requests.setStopOutputs(std::move(outputs));
    }
    void setTravelLimits(std::vector<bus::TravelLimits> limits) {
        m_channel.requests.setTravelLimits(std::move(limits));
    }
    void setRecording(bool on) { m_channel.recording = on; }
    /// The asking thread lives.
    void beat();

    /// Everything since the last call, oldest first; when too many samples wait, the oldest of them are gone.
    /// PortClosed is the last thing that the bus thread tells of a connection.
    [[nodiscard]] std::vector<WorkerEvent> takeEvents();
    /// Samples that are gone so far.
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

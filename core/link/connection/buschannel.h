// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

#include "base/eventqueue.h"
#include "bus/exchangerecord.h"
#include "bus/types.h"
#include "link/connection/heartbeat.h"
#include "link/connection/requestbox.h"
#include "link/connection/workerevent.h"

namespace nmc {

/// Everything that the GUI thread and the bus thread share: requests, events, counters, and the heartbeat
/// that shows whether the other thread is alive.
class BusChannel {
public:
    /// How far the GUI may fall behind before the oldest samples are dropped: a minute at the limit of the
    /// line.
    static constexpr std::size_t kSamples = 1U << 17U;
    /// Half a minute of exchanges at the limit of the line.
    static constexpr std::size_t kRecords = 1U << 14U;

    /// `eventsReady`: called in the posting thread when the event queue is no longer empty; must not block.
    BusChannel(std::function<void()> eventsReady, std::size_t samples)
        : events(samples), records(kRecords), m_eventsReady(std::move(eventsReady)) {}

    RequestBox requests;
    EventQueue<WorkerEvent> events;
    EventQueue<bus::ExchangeRecord> records;  ///< all of them samples
    std::atomic<bool> recording{false};
    Heartbeat heartbeat;

    /// Any thread may call this.
    void post(WorkerEvent event) {
        const bool sample = isSample(event);
        if (sample ? events.pushSample(std::move(event)) : events.pushNews(std::move(event)))
            m_eventsReady();
    }
    void publish(const bus::LinkStatistics& statistics) {
        const std::scoped_lock lock(m_statisticsMutex);
        m_statistics = statistics;
    }
    [[nodiscard]] bus::LinkStatistics statistics() const {
        const std::scoped_lock lock(m_statisticsMutex);
        return m_statistics;
    }

private:
    std::function<void()> m_eventsReady;
    mutable std::mutex m_statisticsMutex;
    bus::LinkStatistics m_statistics;
};

}  // namespace nmc

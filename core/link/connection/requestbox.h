// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bus/iooutputs.h"
#include "bus/types.h"
#include "link/connection/busrequest.h"
#include "link/connection/wakeup.h"

namespace nmc {

/// The path from the GUI thread to the bus thread. Nothing is lost on it: pending changes, such as a stop or
/// a held motion, are state, of which the newest value counts; requests that are answered individually wait
/// in a queue and are refused when it is full.
class RequestBox {
public:
    static constexpr std::size_t kCapacity = 1'024;

    /// Requests that concern the whole chain.
    enum class Search : std::uint8_t {
        Again,   ///< search for it again
        Restart  ///< reset it
    };
    /// In order of execution: stops come first, motions last.
    struct Pending {
        bool stop = false;
        bool released = false;
        std::optional<Search> search;
        std::vector<BusRequest> requests;
        std::vector<ModuleIndex> kept;  ///< Engine::keepTrial
        std::optional<std::vector<ModuleIndex>> watched;
        std::optional<std::vector<bus::StopOutputs>> stopOutputs;
        std::optional<std::vector<bus::TravelLimits>> travelLimits;
        std::optional<std::optional<ModuleIndex>> focused;
        std::optional<bus::HoldToMove> held;
        std::optional<std::string> lendAt;  ///< the path of a terminal
        bool letThrough = false;            ///< Engine::letThrough
        bool endLending = false;

        void release() { held.reset(), released = true; }
        void stopLending() { lendAt.reset(), endLending = true; }
    };

    // From any thread, and from a signal handler.
    void stopAll();
    void close();

    // From any thread.
    /// A stop has been requested that no connection has taken, because the last one had ended.
    [[nodiscard]] bool stopWaits() const { return m_stop; }
    /// Calls `how` with what is pending.
    template <typename Change>
    void change(Change how) {
        {
            const std::scoped_lock lock(m_mutex);
            how(m_pending);
        }
        m_wakeup.wake();
    }
    /// Returns false when the request is not taken, because too many are waiting or no bus thread runs to
    /// take them; `request` is then unchanged.
    [[nodiscard]] bool offer(BusRequest& request);

    /// The number of closes requested so far, for this connection and all earlier ones.
    [[nodiscard]] unsigned closes() const { return m_closes; }
    /// Starts taking requests; anything left from the previous connection is discarded. Does not wait.
    /// `closes`: the number of closes requested for earlier connections. A further one, which a signal may
    /// have requested while this connection was being opened, counts for this one.
    void begin(unsigned closes);
    /// Bus thread: stops taking requests and returns those still waiting, which the caller must refuse.
    [[nodiscard]] std::vector<BusRequest> end();
    /// Bus thread: takes everything that is waiting.
    [[nodiscard]] Pending take();
    /// Bus thread; remains true until begin().
    [[nodiscard]] bool closeWanted() const { return m_closes != m_closesBefore; }
    /// Becomes readable when there is something to take.
    [[nodiscard]] int wakeFd() const { return m_wakeup.fd(); }

private:
    Wakeup m_wakeup;
    std::atomic<bool> m_stop{false};
    std::atomic<unsigned> m_closes{0};
    unsigned m_closesBefore = 0;  ///< set while no bus thread runs
    std::mutex m_mutex;
    bool m_begun = false;
    Pending m_pending;
};

}  // namespace nmc

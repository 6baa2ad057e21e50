// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "bus/iooutputs.h"
#include "bus/types.h"
#include "link/connection/busrequest.h"
#include "link/connection/wakeup.h"

namespace nmc {

/// The way from the GUI thread into the bus thread. Nothing is lost on it: what is wanted now, a stop or a
/// motion that is held say, is state, whose newest word counts; what is answered one by one waits in a queue,
/// and is refused when that is full.
class RequestBox {
public:
    static constexpr std::size_t kCapacity = 1'024;

    /// What is wanted of the chain as a whole.
    enum class Search : std::uint8_t {
        Again,   ///< find it anew
        Restart  ///< reset it
    };
    /// In the order in which it is to be done: what stops comes first, what moves comes last.
    struct Taken {
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
    };

    // From any thread, and from a signal handler.
    void stopAll();
    void close();

    // From any thread.
    void search(Search how);
    void watch(std::vector<ModuleIndex> modules);
    void focus(std::optional<ModuleIndex> module);
    void keepTrial(ModuleIndex module);
    void setStopOutputs(std::vector<bus::StopOutputs> outputs);
    void setTravelLimits(std::vector<bus::TravelLimits> limits);
    void hold(const bus::HoldToMove& hold);
    void release();
    /// False: it is not taken, because too many wait or because nobody is there to take them; `request` is
    /// untouched.
    [[nodiscard]] bool offer(BusRequest& request);

    /// How many closes have been asked for so far, of this connection and those before.
    [[nodiscard]] unsigned closes() const { return m_closes; }
    /// From now on requests are taken; what was left of the connection before is forgotten. Nobody waits.
    /// `closes`: of the connections before. One more, which a signal may have asked for while this one was
    /// being opened, is for this one.
    void begin(unsigned closes);
    /// Bus thread: nothing is taken any more. What waits has to be refused by the caller.
    [[nodiscard]] std::vector<BusRequest> end();
    /// Bus thread: all there is.
    [[nodiscard]] Taken take();
    /// Bus thread; stays so until begin().
    [[nodiscard]] bool closeWanted() const { return m_closes != m_closesBefore; }
    /// Readable when there is something to take.
    [[nodiscard]] int wakeFd() const { return m_wakeup.fd(); }

private:
    template <typename Change>
    void change(Change change);

    Wakeup m_wakeup;
    std::atomic<bool> m_stop{false};
    std::atomic<unsigned> m_closes{0};
    unsigned m_closesBefore = 0;  ///< set while no bus thread runs
    std::mutex m_mutex;
    bool m_begun = false;
    Taken m_waiting;
};

}  // namespace nmc

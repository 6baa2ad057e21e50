// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "bus/engine.h"
#include "link/connection/buschannel.h"
#include "link/connection/busrequest.h"
#include "link/connection/lentterminal.h"
#include "link/connection/loopguard.h"
#include "link/connection/suspendwatch.h"
#include "link/connection/transport.h"
#include "link/ports/porterror.h"

namespace nmc {

/// One connection, from an opened port to its end: turns requests from the channel, bytes from the port and
/// the passing of time into calls of the engine, and carries out the engine's output. Bus thread.
class BusSession {
public:
    /// The limit of closing, which is reached only during a search that has found modules: the longest time
    /// that a search takes.
    static constexpr Duration kLongestClose = std::chrono::seconds(5);

    /// All references are borrowed. `asleepSoFar`: see link/clock.h.
    BusSession(BusChannel& channel, Transport& transport, const bus::EngineConfig& config,
               std::vector<LoopGuard*> guards, std::function<Duration()> asleepSoFar);

    /// Returns nothing after a requested close, once the motors have confirmed their stop or the wait for it
    /// is over; otherwise the error that ended the connection. Blocks only in Transport::receive().
    [[nodiscard]] std::optional<PortError> run();
    /// Call after run().
    [[nodiscard]] std::vector<bus::UnconfirmedStop> unconfirmedStops() const {
        return m_engine.unconfirmedStops();
    }
    /// The final events of requests that the engine has taken on and not finished.
    [[nodiscard]] std::vector<WorkerEvent> abandon() { return m_open.abandon(); }

private:
    /// The last information sent to the guards.
    struct Guarded {
        std::vector<std::uint8_t> burst;
        std::uint32_t baud = 0;
        bool moving = false;
        bool operator==(const Guarded&) const = default;
    };

    std::optional<PortError> converse();
    void takeRequests(TimePoint now);
    void take(BusRequest& request, TimePoint now);
    void changeRate(const ChangeRate& change, TimePoint now);
    void search(RequestBox::Search how, TimePoint now);
    void lend(const std::string& path);
    void endLending(LineLent::State how, TimePoint now);
    /// What was requested while the modules were being stopped.
    void doWhenStopped(TimePoint now);
    /// Passes on what the program has done.
    void serveProgram(TimePoint now);
    void reportLending();
    /// It is let wait only for the end of what the panel was asking when it lent the line.
    [[nodiscard]] bool servesProgram() const {
        return m_lent && (!m_engine.passes() || m_engine.hearsForProgram());
    }
    /// Stops the motors when the user cannot, as far as the engine allows it (Engine::stopUnasked).
    void watchOver(TimePoint now);
    /// Handles news from the guards.
    tl::expected<void, PortError> hearGuards(TimePoint now);
    void informGuards();
    tl::expected<void, PortError> perform(const std::vector<bus::Output>& outputs);
    void followRate(std::uint32_t baud, tl::expected<void, PortError>& done);
    void publishEvents();
    void publishStatistics(TimePoint now, std::optional<TimePoint> next);
    void publishRecords();
    /// The time at which there is something to do even if nothing arrives.
    [[nodiscard]] std::optional<TimePoint> nextTurn(TimePoint now) const;

    BusChannel& m_channel;
    Transport& m_transport;
    std::vector<LoopGuard*> m_guards;
    std::function<Duration()> m_asleepSoFar;
    bus::Engine m_engine;
    OpenRequests m_open;
    SuspendWatch m_suspendWatch;
    Guarded m_guarded;
    std::uint32_t m_portBaud;
    std::optional<LentTerminal> m_lent;
    LineLent::State m_lentReported = LineLent::State::Ended;
    bool m_letThroughWhenStopped = false;
    bool m_engineRecords = false;
    bool m_restartWhenStopped = false;
    std::optional<TimePoint> m_closeBy;
    TimePoint m_closeAsked;
    TimePoint m_published;
};

}  // namespace nmc

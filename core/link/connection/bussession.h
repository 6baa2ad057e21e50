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
#include "link/connection/loopguard.h"
#include "link/connection/suspendwatch.h"
#include "link/connection/transport.h"
#include "link/ports/porterror.h"

namespace nmc {

/// One connection, from an open port to the end: turns what the channel asks for, what the port hears and
/// what time it is into calls of the engine, and carries out what the engine wants. Bus thread.
class BusSession {
public:
    /// Borrows all of them. `asleepSoFar`: as in link/clock.h.
    BusSession(BusChannel& channel, Transport& transport, const bus::EngineConfig& config,
               std::vector<LoopGuard*> guards, std::function<Duration()> asleepSoFar);

    /// Returns when it was told to close and the motors have confirmed their stop, or will not; otherwise
    /// with what has ended it. Waits in Transport::receive() only.
    [[nodiscard]] std::optional<PortError> run();
    /// How the requests have ended that the engine had, and has not finished.
    [[nodiscard]] std::vector<WorkerEvent> abandon() { return m_open.abandon(); }

private:
    /// What the guards have been told.
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
    /// Stops the motors when nobody else can see to it, as the engine lets it (Engine::stopUnasked).
    void watchOver(TimePoint now);
    /// What the guards have to tell.
    tl::expected<void, PortError> hearGuards(TimePoint now);
    void informGuards();
    tl::expected<void, PortError> perform(const std::vector<bus::Output>& outputs);
    void publishEvents();
    void publishStatistics(TimePoint now, std::optional<TimePoint> next);
    void publishRecords();
    /// When something is to be done even if nothing arrives.
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
    bool m_engineRecords = false;
    bool m_restartWhenStopped = false;
    std::optional<TimePoint> m_closeBy;
    TimePoint m_closeAsked;
    TimePoint m_published;
};

}  // namespace nmc

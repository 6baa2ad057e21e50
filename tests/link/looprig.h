// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include "base/overloaded.h"
#include "link/clock.h"
#include "link/connection/busloop.h"
#include "link/connection/simulatortransport.h"
#include "tests/support/gains.h"

namespace nmc::testing_support {

/// A bus loop, and a thread that listens to it as the GUI thread does, and is woken by the loop.
class LoopRig {
public:
    explicit LoopRig(std::size_t samples = BusChannel::kSamples) : loop([this] { wake(); }, samples) {}
    virtual ~LoopRig() = default;

    template <typename... Arguments>
    void openSimulator(const bus::EngineConfig& config, Arguments... arguments) {
        openTransport<SimulatorTransport>(config, std::move(arguments)...);
    }
    template <typename T, typename... Arguments>
    void openTransport(const bus::EngineConfig& config, Arguments... arguments) {
        onWaiting(true);
        loop.open([arguments...] { return std::make_unique<T>(arguments...); }, config);
        onWaiting(false);
    }

    /// All events so far.
    const std::vector<WorkerEvent>& events() {
        for (WorkerEvent& event : loop.takeEvents())
            m_events.push_back(std::move(event));
        return m_events;
    }
    /// Takes events until the condition holds, and beats in the meantime. Gives up when the test has run for
    /// far too long.
    template <typename Condition>
    [[nodiscard]] bool waitUntil(Condition condition) {
        constexpr Duration kFarTooLong = std::chrono::minutes(1);
        for (const TimePoint limit = monotonicNow() + kFarTooLong; monotonicNow() < limit;) {
            (void)events();
            if (condition())
                return true;
            loop.beat();
            onTurn();
            std::unique_lock lock(m_mutex);
            m_told.wait_for(lock, std::chrono::milliseconds(5), [this] { return m_ready; });
            m_ready = false;
        }
        return false;
    }
    template <typename Event>
    [[nodiscard]] bool waitFor() {
        return waitUntil([this] { return count<Event>() > 0; });
    }

    /// The last event of this type that was taken so far; null if there is none.
    template <typename Event>
    [[nodiscard]] const Event* last() const {
        for (auto event = m_events.rbegin(); event != m_events.rend(); ++event)
            if (const auto* found = as<Event>(*event))
                return found;
        return nullptr;
    }
    template <typename Event>
    [[nodiscard]] std::size_t count() const {
        std::size_t number = 0;
        for (const WorkerEvent& event : m_events)
            number += as<Event>(event) != nullptr ? 1U : 0U;
        return number;
    }
    template <typename Event>
    [[nodiscard]] static const Event* as(const WorkerEvent& event) {
        if constexpr (AnyOf<Event, PortOpened, PortClosed, SimulatorAnswered, PanelFroze, ComputerSlept,
                            GuardianStopped, GuardianMissing, LineLent, LendingProblem>) {
            return std::get_if<Event>(&event);
        } else {
            const auto* told = std::get_if<bus::Event>(&event);
            return told != nullptr ? std::get_if<Event>(told) : nullptr;
        }
    }

protected:
    /// Called on each turn of waitUntil(), after events were taken.
    virtual void onTurn() {}
    /// Called before and after this thread waits for that of the connection before.
    virtual void onWaiting(bool /*waits*/) {}

private:
    void wake() {
        const std::scoped_lock lock(m_mutex);
        m_ready = true;
        m_told.notify_one();
    }

    std::mutex m_mutex;
    std::condition_variable m_told;
    bool m_ready = false;
    std::vector<WorkerEvent> m_events;

public:
    BusLoop loop;
};

/// The built-in simulator has no adapter, and so no latency.
inline bus::EngineConfig simulatorConfig(std::uint32_t baud = 19'200) {
    bus::EngineConfig config;
    config.baud = baud;
    config.adapterLatency = Duration::zero();
    return config;
}

inline std::vector<ModuleIdentity> servoChain(std::size_t modules) {
    return std::vector<ModuleIdentity>(modules, {ModuleType::Servo, 4});
}

inline bus::Operation servoOperation(std::uint32_t id, std::vector<ServoCommand> commands) {
    bus::Operation operation{bus::OperationId(id), {}};
    for (ServoCommand& command : commands)
        operation.orders.push_back({ModuleIndex(0), std::move(command)});
    return operation;
}

/// Sends gains, enables the servo, and starts a motion at 4 counts per tick that does not end by itself.
inline bus::Operation runOn(std::uint32_t id) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(4U << 16U);
    load.acceleration = CountsPerTickSquared(1'311);
    load.profile = servo::ProfileMode::Velocity;
    return servoOperation(id, {testing_support::kGains,
                               servo::StopMotor{true, servo::StopManner::Abruptly, {}}, load, StartMotion{}});
}

}  // namespace nmc::testing_support

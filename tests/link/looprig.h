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

namespace nmc::testing_support {

/// A bus loop, and a thread that listens to it as the GUI's does: woken by the loop and by nothing else.
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
        loop.open([arguments...] { return std::make_unique<T>(arguments...); }, config);
    }

    /// Everything that was told so far.
    const std::vector<WorkerEvent>& events() {
        for (WorkerEvent& event : loop.takeEvents())
            m_events.push_back(std::move(event));
        return m_events;
    }
    /// Takes what is told until the condition holds; beats meanwhile. Gives up when the test itself has gone
    /// on for far too long.
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

    /// Of what was taken so far: the last one.
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
                            GuardianStopped, GuardianMissing>) {
            return std::get_if<Event>(&event);
        } else {
            const auto* told = std::get_if<bus::Event>(&event);
            return told != nullptr ? std::get_if<Event>(told) : nullptr;
        }
    }

protected:
    /// Whenever the thread has looked for what is told.
    virtual void onTurn() {}

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

/// The built-in simulator needs no time for an adapter.
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

/// Gains, on, and a motion at 4 counts a tick that does not end by itself.
inline bus::Operation runOn(std::uint32_t id) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(4U << 16U);
    load.acceleration = CountsPerTickSquared(1'311);
    load.profile = servo::ProfileMode::Velocity;
    return servoOperation(id, {servo::SetGain{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}},
                               servo::StopMotor{true, servo::StopManner::Abruptly, {}}, load, StartMotion{}});
}

}  // namespace nmc::testing_support

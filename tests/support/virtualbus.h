// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "bus/engine.h"
#include "sim/chain.h"

namespace nmc::test {

/// The bus engine and a simulated chain, coupled in virtual time: hours of traffic take seconds, without a
/// thread or a clock. Every byte, event and output is kept.
class VirtualBus {
public:
    struct Sent {
        TimePoint time;
        std::vector<std::uint8_t> bytes;
        [[nodiscard]] std::string hex() const { return toHex(bytes); }
    };

    explicit VirtualBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config = {},
                        sim::ChainOptions options = {});

    bus::Engine engine;
    sim::Chain chain;
    TimePoint now{};
    std::vector<bus::Event> events;
    std::vector<Sent> sent;
    std::vector<std::uint8_t> heard;  ///< what has reached the host
    std::uint32_t hostBaud = 19'200;  ///< rate to which the engine has set the port
    /// Bytes reach the host this much later: the latency of a serial adapter.
    Duration adapterDelay{};
    /// All bytes of a reply after its first arrive this much later: the pause that some adapters make.
    Duration tear{};
    /// May change what goes to the chain; a command that it empties is lost.
    std::function<void(std::vector<std::uint8_t>& command)> onCommand;
    /// Called with each command: how much later its last byte leaves, as on a busy machine.
    std::function<Duration()> holdsBack;
    /// Commands reach the chain this much later, at the rate that is set then: it is a process that reads
    /// late.
    Duration readLater{};
    /// Called with each command: if true, the host receives nothing until the next one.
    std::function<bool(ByteSpan command)> losesReply;
    /// Called for each byte to the host: if true, it is lost.
    std::function<bool(std::uint8_t byte)> losesByte;
    /// May change a byte on its way to the host, and returns how often it arrives there.
    std::function<unsigned(std::uint8_t& byte)> onHostByte;
    /// Called whenever time has passed, before the engine is notified.
    std::function<void()> onTime;

    /// Another program replaces the previous one, which ended without notice: the new one knows nothing about
    /// the chain.
    void newHost(bus::EngineConfig config = {});

    void runFor(Duration time) { run(now + time); }

    /// Runs until the condition holds; false if it does not within the limit.
    [[nodiscard]] bool runUntil(const std::function<bool()>& condition, Duration limit);

    /// Finds the chain; false if that fails.
    [[nodiscard]] bool connect();
    /// Restarts the network.
    [[nodiscard]] bool restart();
    [[nodiscard]] bool begin(const std::function<void()>& how);

    /// Submits the steps as one operation and runs until it has ended.
    [[nodiscard]] std::optional<bus::Outcome> perform(std::vector<bus::Order> steps);
    bus::OperationId submit(std::vector<bus::Order> steps, const std::optional<bus::Sine>& sine = {},
                            std::shared_ptr<const bus::PathPlan> path = {});
    bus::OperationId submit(bus::Operation operation);
    [[nodiscard]] std::optional<bus::Outcome> outcomeOf(bus::OperationId id) const;

    /// Stops everything, and runs until the stop has ended.
    [[nodiscard]] std::optional<bus::StopFinished> stopAll();

    template <typename T>
    [[nodiscard]] std::vector<T> all() const {
        std::vector<T> found;
        for (const bus::Event& event : events)
            if (const T* e = std::get_if<T>(&event))
                found.push_back(*e);
        return found;
    }
    template <typename T>
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(std::count_if(
            events.begin(), events.end(), [](const bus::Event& e) { return std::holds_alternative<T>(e); }));
    }
    template <typename T>
    [[nodiscard]] std::optional<T> last() const {
        for (auto it = events.rbegin(); it != events.rend(); ++it)
            if (const T* e = std::get_if<T>(&*it))
                return *e;
        return std::nullopt;
    }
    [[nodiscard]] std::optional<bus::Sample> lastSample(std::uint8_t module) const;
    [[nodiscard]] std::size_t samplesOf(std::uint8_t module) const;
    /// Number of packets that begin with these bytes, from the given entry of `sent` on.
    [[nodiscard]] std::size_t sends(const std::string& prefix, std::size_t from = 0) const;

    [[nodiscard]] sim::ServoSnapshot servo(std::uint8_t module);

    /// Expects that the host did nothing that a real chip would not tolerate.
    void expectNoViolations() const;

private:
    void run(TimePoint end);
    void step(TimePoint end);
    [[nodiscard]] std::optional<TimePoint> arrival() const;
    [[nodiscard]] std::optional<TimePoint> departure() const;
    void pump();
    void carryOut(bus::Output& output);

    std::deque<sim::HostByte> m_arriving;
    std::deque<Sent> m_leaving;
    bool m_losesReply = false;
    std::size_t m_hostBytes = 0;  ///< since the last command
    std::uint32_t m_lastId = 0;
    unsigned m_stuck = 0;
};

/// `count` PIC-SERVOs of this version.
[[nodiscard]] inline std::vector<ModuleIdentity> servos(std::size_t count, std::uint8_t version = 4) {
    return std::vector<ModuleIdentity>(count, ModuleIdentity{ModuleType::Servo, version});
}

[[nodiscard]] inline sim::ChainOptions withFaults(sim::ChainOptions options = {}) {
    options.enableFaults = true;
    return options;
}

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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
                        sim::ChainOptions options = {})
        : engine(config), chain(modules, options) {
        run(now + std::chrono::milliseconds(100));
    }

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
    void newHost(bus::EngineConfig config = {}) {
        std::destroy_at(&engine);
        std::construct_at(&engine, config);
    }

    void runFor(Duration time) { run(now + time); }

    /// Runs until the condition holds; false if it does not within the limit.
    template <typename Condition>
    [[nodiscard]] bool runUntil(Condition condition, Duration limit) {
        const TimePoint end = now + limit;
        pump();
        while (!condition()) {
            if (now >= end)
                return false;
            step(end);
        }
        return true;
    }

    /// Finds the chain; false if that fails.
    [[nodiscard]] bool connect() {
        return begin([&] { engine.connect(now); });
    }
    /// Restarts the network.
    [[nodiscard]] bool restart() {
        return begin([&] { engine.restart(now); });
    }
    template <typename How>
    [[nodiscard]] bool begin(How how) {
        const std::size_t before = count<bus::ChainFound>();
        const std::size_t failed = count<bus::ConnectFailed>();
        how();
        return runUntil(
                   [&] { return count<bus::ChainFound>() > before || count<bus::ConnectFailed>() > failed; },
                   std::chrono::seconds(20)) &&
               count<bus::ChainFound>() > before;
    }

    /// Submits the steps as one operation and runs until it has ended.
    [[nodiscard]] std::optional<bus::Outcome> perform(std::vector<bus::Order> steps) {
        const bus::OperationId id = submit(std::move(steps));
        std::optional<bus::Outcome> outcome;
        const auto ended = [&] { return (outcome = outcomeOf(id)).has_value(); };
        return runUntil(ended, std::chrono::seconds(10)) ? outcome : std::nullopt;
    }
    bus::OperationId submit(std::vector<bus::Order> steps, const std::optional<bus::Sine>& sine = {},
                            std::shared_ptr<const bus::PathPlan> path = {}) {
        return submit({{}, std::move(steps), sine, std::move(path)});
    }
    bus::OperationId submit(bus::Operation operation) {
        const bus::OperationId id(++m_lastId);
        operation.id = id;
        engine.submit(std::move(operation), now);
        pump();
        return id;
    }
    [[nodiscard]] std::optional<bus::Outcome> outcomeOf(bus::OperationId id) const {
        for (const auto& finished : all<bus::OperationFinished>())
            if (finished.id == id)
                return finished.outcome;
        return std::nullopt;
    }

    /// Stops everything, and runs until the stop has ended.
    [[nodiscard]] std::optional<bus::StopFinished> stopAll() {
        const std::size_t before = count<bus::StopFinished>();
        engine.stopAll(now);
        if (!runUntil([&] { return count<bus::StopFinished>() > before; }, std::chrono::seconds(5)))
            return std::nullopt;
        return all<bus::StopFinished>().back();
    }

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
    [[nodiscard]] std::optional<bus::Sample> lastSample(std::uint8_t module) const {
        for (auto it = events.rbegin(); it != events.rend(); ++it)
            if (const auto* e = std::get_if<bus::Sample>(&*it); e != nullptr && e->module.value() == module)
                return *e;
        return std::nullopt;
    }
    [[nodiscard]] std::size_t samplesOf(std::uint8_t module) const {
        std::size_t n = 0;
        for (const auto& sample : all<bus::Sample>())
            n += sample.module.value() == module ? 1U : 0U;
        return n;
    }
    /// Number of packets that begin with these bytes, from the given entry of `sent` on.
    [[nodiscard]] std::size_t sends(const std::string& prefix, std::size_t from = 0) const {
        std::size_t n = 0;
        for (std::size_t i = from; i < sent.size(); ++i)
            n += sent[i].hex().rfind(prefix, 0) == 0 ? 1U : 0U;
        return n;
    }

    [[nodiscard]] sim::ServoSnapshot servo(std::uint8_t module) {
        return chain.snapshot(ModuleIndex(module), now).servo;
    }

    /// Expects that the host did nothing that a real chip would not tolerate.
    void expectNoViolations() const {
        for (const sim::Violation& v : chain.violations().entries())
            ADD_FAILURE() << "violation " << sim::toText(v.kind) << " at "
                          << toSeconds(v.time.time_since_epoch()) << " s, module " << int{v.module} << ": "
                          << toHex(v.bytes);
    }

private:
    void run(TimePoint end) {
        pump();
        while (now < end)
            step(end);
    }

    void step(TimePoint end) {
        TimePoint next = end;
        for (const auto& candidate : {engine.nextDeadline(), chain.nextEvent(), arrival(), departure()})
            if (candidate)
                next = std::min(next, *candidate);
        // A deadline that is not in the future would be a busy loop.
        m_stuck = next <= now ? m_stuck + 1 : 0;
        if (m_stuck > 1000) {
            ADD_FAILURE() << "time stands still";
            next = end;
        }
        now = std::max(now, next);
        for (; !m_leaving.empty() && m_leaving.front().time <= now; m_leaving.pop_front())
            chain.hostSends(m_leaving.front().bytes, now);
        chain.advanceTo(now);
        if (onTime)
            onTime();
        for (sim::HostByte& byte : chain.takeHostBytes()) {
            const bool lost = m_losesReply || (losesByte && losesByte(byte.value));
            for (unsigned n = lost ? 0 : onHostByte ? onHostByte(byte.value) : 1; n > 0; --n)
                m_arriving.push_back(
                    {byte.due + adapterDelay + (m_hostBytes++ > 0 ? tear : Duration{}), byte.value});
        }
        std::vector<std::uint8_t> bytes;
        for (; !m_arriving.empty() && m_arriving.front().due <= now; m_arriving.pop_front())
            bytes.push_back(m_arriving.front().value);
        heard.insert(heard.end(), bytes.begin(), bytes.end());
        if (!bytes.empty())
            engine.onBytes(bytes, now);
        pump();
        if (const auto deadline = engine.nextDeadline(); deadline && *deadline <= now)
            engine.onDeadline(now);
        pump();
    }

    [[nodiscard]] std::optional<TimePoint> arrival() const {
        return m_arriving.empty() ? std::nullopt : std::optional(m_arriving.front().due);
    }

    [[nodiscard]] std::optional<TimePoint> departure() const {
        return m_leaving.empty() ? std::nullopt : std::optional(m_leaving.front().time);
    }

    void pump() {
        for (bus::Output& output : engine.takeOutput())
            carryOut(output);
        for (bus::Event& event : engine.takeEvents())
            events.push_back(std::move(event));
    }

    void carryOut(bus::Output& output) {
        if (const auto* rate = std::get_if<bus::SetHostBaud>(&output)) {
            hostBaud = rate->baud;
            chain.setHostBaud(rate->baud);
        } else if (auto* send = std::get_if<bus::Send>(&output)) {
            sent.push_back({now, send->bytes});
            m_losesReply = losesReply && losesReply(send->bytes);
            m_hostBytes = 0;
            if (onCommand)
                onCommand(send->bytes);
            // What is read late is read in order.
            const TimePoint before = m_leaving.empty() ? now : m_leaving.back().time;
            if (const TimePoint read = std::max(now + readLater, before); read > now)
                return m_leaving.push_back({read, std::move(send->bytes)});
            const Duration held = holdsBack && !send->bytes.empty() ? holdsBack() : Duration{};
            if (held > Duration{}) {
                m_leaving.push_back({now + held, {send->bytes.back()}});
                send->bytes.pop_back();
            }
            chain.hostSends(send->bytes, now);
        } else {
            std::erase_if(m_arriving, [this](const sim::HostByte& byte) { return byte.due <= now; });
        }
    }

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

}  // namespace nmc::test

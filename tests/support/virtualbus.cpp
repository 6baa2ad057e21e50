// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtualbus.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace nmc::test {

VirtualBus::VirtualBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config,
                       sim::ChainOptions options)
    : engine(config), chain(modules, options) {
    run(now + std::chrono::milliseconds(100));
}

void VirtualBus::newHost(bus::EngineConfig config) {
    std::destroy_at(&engine);
    std::construct_at(&engine, config);
}

bool VirtualBus::runUntil(const std::function<bool()>& condition, Duration limit) {
    const TimePoint end = now + limit;
    pump();
    while (!condition()) {
        if (now >= end)
            return false;
        step(end);
    }
    return true;
}

bool VirtualBus::connect() {
    return begin([&] { engine.connect(now); });
}

bool VirtualBus::restart() {
    return begin([&] { engine.restart(now); });
}

bool VirtualBus::begin(const std::function<void()>& how) {
    const std::size_t before = count<bus::ChainFound>();
    const std::size_t failed = count<bus::ConnectFailed>();
    how();
    return runUntil([&] { return count<bus::ChainFound>() > before || count<bus::ConnectFailed>() > failed; },
                    std::chrono::seconds(20)) &&
           count<bus::ChainFound>() > before;
}

std::optional<bus::Outcome> VirtualBus::perform(std::vector<bus::Order> steps) {
    const bus::OperationId id = submit(std::move(steps));
    std::optional<bus::Outcome> outcome;
    const auto ended = [&] { return (outcome = outcomeOf(id)).has_value(); };
    return runUntil(ended, std::chrono::seconds(10)) ? outcome : std::nullopt;
}

bus::OperationId VirtualBus::submit(std::vector<bus::Order> steps, const std::optional<bus::Sine>& sine,
                                    std::shared_ptr<const bus::PathPlan> path) {
    return submit({{}, std::move(steps), sine, std::move(path)});
}

bus::OperationId VirtualBus::submit(bus::Operation operation) {
    const bus::OperationId id(++m_lastId);
    operation.id = id;
    engine.submit(std::move(operation), now);
    pump();
    return id;
}

std::optional<bus::Outcome> VirtualBus::outcomeOf(bus::OperationId id) const {
    for (const auto& finished : all<bus::OperationFinished>())
        if (finished.id == id)
            return finished.outcome;
    return std::nullopt;
}

std::optional<bus::StopFinished> VirtualBus::stopAll() {
    const std::size_t before = count<bus::StopFinished>();
    engine.stopAll(now);
    if (!runUntil([&] { return count<bus::StopFinished>() > before; }, std::chrono::seconds(5)))
        return std::nullopt;
    return all<bus::StopFinished>().back();
}

std::optional<bus::Sample> VirtualBus::lastSample(std::uint8_t module) const {
    for (auto it = events.rbegin(); it != events.rend(); ++it)
        if (const auto* e = std::get_if<bus::Sample>(&*it); e != nullptr && e->module.value() == module)
            return *e;
    return std::nullopt;
}

std::size_t VirtualBus::samplesOf(std::uint8_t module) const {
    std::size_t n = 0;
    for (const auto& sample : all<bus::Sample>())
        n += sample.module.value() == module ? 1U : 0U;
    return n;
}

std::size_t VirtualBus::sends(const std::string& prefix, std::size_t from) const {
    std::size_t n = 0;
    for (std::size_t i = from; i < sent.size(); ++i)
        n += sent[i].hex().rfind(prefix, 0) == 0 ? 1U : 0U;
    return n;
}

sim::ServoSnapshot VirtualBus::servo(std::uint8_t module) {
    return chain.snapshot(ModuleIndex(module), now).servo;
}

void VirtualBus::expectNoViolations() const {
    for (const sim::Violation& v : chain.violations().entries())
        ADD_FAILURE() << "violation " << sim::toText(v.kind) << " at " << toSeconds(v.time.time_since_epoch())
                      << " s, module " << int{v.module} << ": " << toHex(v.bytes);
}

void VirtualBus::run(TimePoint end) {
    pump();
    while (now < end)
        step(end);
}

void VirtualBus::step(TimePoint end) {
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

std::optional<TimePoint> VirtualBus::arrival() const {
    return m_arriving.empty() ? std::nullopt : std::optional(m_arriving.front().due);
}

std::optional<TimePoint> VirtualBus::departure() const {
    return m_leaving.empty() ? std::nullopt : std::optional(m_leaving.front().time);
}

void VirtualBus::pump() {
    for (bus::Output& output : engine.takeOutput())
        carryOut(output);
    for (bus::Event& event : engine.takeEvents())
        events.push_back(std::move(event));
}

void VirtualBus::carryOut(bus::Output& output) {
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

}  // namespace nmc::test

// SPDX-License-Identifier: MIT
#include "bus/engine.h"

#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"

namespace nmc::bus {

Engine::Engine(EngineConfig config) : d(std::make_unique<Private>(config)) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void Engine::connect(TimePoint now) {
    d->begin(Discovery::Start::Look, now);
}
void Engine::restart(TimePoint now) {
    d->begin(Discovery::Start::Restart, now);
}
void Engine::submit(Operation operation, TimePoint now) {
    d->submit(std::move(operation), now);
}
void Engine::submit(GroupOperation operation, TimePoint now) {
    d->submit(operation, now);
}
void Engine::changeRate(std::uint32_t baud, TimePoint now) {
    d->changeRate(baud, now);
}
void Engine::hold(const HoldToMove& hold, TimePoint now) {
    d->hold(hold, now);
}
void Engine::release(TimePoint now) {
    d->release(now);
}
void Engine::stopAll(TimePoint now) {
    d->stopAll(now);
}
void Engine::distrust(TimePoint now) {
    d->distrust(now);
}
void Engine::watch(const std::vector<ModuleIndex>& modules) {
    d->watch(modules);
}
void Engine::focus(std::optional<ModuleIndex> module, TimePoint now) {
    d->focus(module, now);
}
void Engine::onBytes(ByteSpan bytes, TimePoint now) {
    d->onBytes(bytes, now);
}
void Engine::onDeadline(TimePoint now) {
    d->onDeadline(now);
}
std::optional<TimePoint> Engine::nextDeadline() const {
    return d->nextDeadline();
}
std::vector<Output> Engine::takeOutput() {
    return d->line.takeOutput();
}
std::vector<Event> Engine::takeEvents() {
    return std::exchange(d->events, {});
}
const LinkStatistics& Engine::statistics() const {
    return d->line.statistics();
}
std::size_t Engine::stopReach() const {
    return d->stopReach();
}
bool Engine::anythingMoves() const {
    return d->anythingMoves();
}
std::vector<std::uint8_t> Engine::stopBurst() const {
    return d->stopBurst();
}
std::uint32_t Engine::stopBurstBaud() const {
    return d->stopBurstBaud();
}
std::optional<std::vector<std::uint8_t>> Engine::changedStopBurst() {
    return d->stopBurstChanged() ? std::optional(d->stopBurst()) : std::nullopt;
}
void Engine::setRecording(bool on) {
    d->setRecording(on);
}
std::vector<ExchangeRecord> Engine::takeRecords() {
    return std::exchange(d->records, {});
}

Engine::Private::Private(EngineConfig c)
    : config(c), line(c.adapterLatency, c.margin), m_hold(c.holdTimeout) {}

void Engine::Private::begin(Discovery::Start start, TimePoint now) {
    if (m_stop || m_stopDuringDiscovery)
        finishStop(now);
    cancelOperations();
    m_hold.clear();
    line.abandon();
    line.statistics() = {};
    m_works.clear();
    m_again.reset();
    m_suspect = m_resyncing = m_hurried = m_lost = m_blindStopsDue = false;
    m_doubt.reset();
    m_silence.heard();
    m_health = {};
    m_look = Look::None;
    m_lostBursts = 0;
    m_verification.reset();
    m_rateChange.reset();
    m_abandoned.reset();
    m_goingBack = false;
    m_guards.clear();
    m_blindStops.clear();
    m_holdFailures = 0;
    m_modules.clear();
    m_schedule = PollSchedule();
    m_discovery.reset();
    if (!findBaud(config.baud)) {
        m_phase = Phase::Off;  // before anything is reset for it
        events.emplace_back(ConnectFailed{ConnectFailure::RateChange, {}, config.baud});
        return;
    }
    m_phase = Phase::Discovering;
    m_discovery.emplace(config, start);
    proceed(now);
}

void Engine::Private::submit(Operation operation, TimePoint now) {
    if (operation.steps.empty()) {
        events.emplace_back(rejected(operation, Outcome::Done));
        return;
    }
    const OperationFinished cancelled = rejected(operation, Outcome::Cancelled);
    if (m_phase != Phase::Running || m_stop || !m_commands.submit(std::move(operation))) {
        events.emplace_back(cancelled);
        return;
    }
    proceed(now);
}

void Engine::Private::hold(const HoldToMove& hold, TimePoint now) {
    if (m_phase != Phase::Running || m_stop || hold.module.value() >= m_modules.size())
        return;
    m_hold.hold(hold, now);
    proceed(now);
}

void Engine::Private::release(TimePoint now) {
    m_hold.release();
    hurryHoldStop(now);
    proceed(now);
}

void Engine::Private::stopAll(TimePoint now) {
    cancelOperations();
    m_hold.clear();
    m_guards.clear();
    m_schedule.unfocus();
    if (m_phase == Phase::Off) {
        events.emplace_back(StopFinished{});
        return;
    }
    if (m_phase == Phase::Discovering) {
        if (!m_stopDuringDiscovery)
            m_stopDuringDiscovery = now;
        return proceed(now);
    }
    if (m_stop)
        m_stop->restart(beliefs(), m_schedule);
    else
        m_stop.emplace(beliefs(), m_schedule, now);
    const bool suspect = m_suspect || m_resyncing || m_hurried || m_lost || m_doubt;
    // One packet to all of them is sooner than one to each, even on a line that is free.
    m_blindStopsDue = suspect || line.busy() || m_modules.size() > 1;
    interrupt(now);
    m_suspect = suspect;
    abandonRateChange();
    proceed(now);
}

void Engine::Private::distrust(TimePoint now) {
    if (m_phase != Phase::Running || m_modules.empty())
        return;
    interrupt(now);
    abandonRateChange();
    m_suspect = true;
    for (Module& module : m_modules)
        module.trust.interrupt();
    m_doubt = Doubt{m_modules.front().belief.info().index};
    proceed(now);
}

void Engine::Private::watch(const std::vector<ModuleIndex>& modules) {
    m_watched = modules;
    m_schedule.watch(modules);
}

void Engine::Private::focus(std::optional<ModuleIndex> module, TimePoint now) {
    m_schedule.unfocus();
    if (module && m_phase == Phase::Running && !m_stop)
        m_schedule.focus(*module, now);
}

void Engine::Private::onBytes(ByteSpan bytes, TimePoint now) {
    m_silence.heard();
    line.onBytes(bytes, now);
    proceed(now);
}

void Engine::Private::onDeadline(TimePoint now) {
    line.onDeadline(now);
    expireHold(now);
    proceed(now);
}

std::optional<TimePoint> Engine::Private::nextDeadline() const {
    std::optional<TimePoint> first = line.deadline();
    const auto consider = [&](std::optional<TimePoint> other) {
        if (other && (!first || *other < *first))
            first = other;
    };
    if (m_phase == Phase::Running) {
        consider(m_hold.deadline());
        if (line.idle())
            consider(m_schedule.nextDue());
        if (line.idle() && m_lostBursts > 0)
            consider(m_nextLostBurst);
    }
    return first;
}

std::size_t Engine::Private::stopReach() const {
    return m_phase == Phase::Running || m_phase == Phase::Quiet ? m_schedule.answering() : 0;
}

bool Engine::Private::anythingMoves() const {
    return std::any_of(m_modules.begin(), m_modules.end(),
                       [](const Module& module) { return module.belief.moving(); });
}

std::vector<Belief> Engine::Private::beliefs() const {
    std::vector<Belief> all;
    for (const Module& module : m_modules)
        all.push_back(module.belief);
    return all;
}

void Engine::Private::expireHold(TimePoint now) {
    const auto held = m_hold.wanted();
    if (!held || !m_hold.expired(now))
        return;
    // Nothing had been started if there is nothing to stop.
    if (m_hold.stop())
        events.emplace_back(HoldExpired{held->module});
    hurryHoldStop(now);
}

/// The stop that a hold owes does not wait for a quarantine.
void Engine::Private::hurryHoldStop(TimePoint now) {
    if (!m_hold.stop() || !m_resyncing)
        return;
    interrupt(now);
    m_suspect = true;
}

void Engine::Private::cancelOperations() {
    for (Event& event : m_commands.cancelAll())
        events.emplace_back(std::move(event));
    m_verification.reset();
    m_groupRun.reset();
    if (m_again && m_again->lane != Lane::Discovery)
        m_again.reset();
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "link/connection/bussession.h"

#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "base/overloaded.h"
#include "link/clock.h"
#include "link/connection/crashburst.h"
#include "protocol/baud.h"

namespace nmc {

namespace {

/// How often the counters are published while the bus is busy; they are displayed once a second.
constexpr Duration kStatisticsEvery = std::chrono::milliseconds(100);
/// How long closing waits for the motors to confirm their stop.
constexpr Duration kCloseTimeout = std::chrono::seconds(1);

}  // namespace

BusSession::BusSession(BusChannel& channel, Transport& transport, const bus::EngineConfig& config,
                       std::vector<LoopGuard*> guards, std::function<Duration()> asleepSoFar)
    : m_channel(channel),
      m_transport(transport),
      m_guards(std::move(guards)),
      m_asleepSoFar(std::move(asleepSoFar)),
      m_engine(config),
      m_portBaud(kPowerUpBaud) {}

std::optional<PortError> BusSession::run() {
    for (LoopGuard* guard : m_guards)
        guard->begin(m_transport.fd());
    publishRecords();
    m_engine.connect(monotonicNow());
    auto error = converse();
    for (LoopGuard* guard : m_guards)
        guard->end();
    m_channel.publish(m_engine.statistics());
    return error;
}

std::optional<PortError> BusSession::converse() {
    std::vector<std::uint8_t> bytes;
    while (true) {
        const TimePoint now = monotonicNow();
        if (const auto heard = hearGuards(now); !heard)
            return heard.error();
        if (m_channel.requests.closeWanted() && !m_closeBy) {
            m_closeAsked = now;
            m_closeBy = now + kCloseTimeout;
            m_engine.stopUnasked(now);
        }
        takeRequests(now);
        if (servesProgram())
            serveProgram(now);
        // Bytes are handled after the requests: an answer triggers the next poll, which would otherwise be
        // sent before a stop that arrived with it.
        if (!bytes.empty())
            m_engine.onBytes(bytes, now);
        watchOver(now);
        if (const auto deadline = m_engine.nextDeadline(); deadline && *deadline <= now)
            m_engine.onDeadline(now);
        informGuards();
        if (const auto performed = perform(m_engine.takeOutput()); !performed)
            return performed.error();
        publishEvents();
        if (!m_engine.stopping())
            doWhenStopped(now);
        reportLending();
        publishRecords();
        if (m_closeBy && now >= *m_closeBy && m_engine.stopMayStillReach())
            m_closeBy = std::max(*m_closeBy, m_closeAsked + kLongestClose);
        if (m_closeBy && (!m_engine.stopping() || now >= *m_closeBy))
            return std::nullopt;

        const auto until = nextTurn(now);
        publishStatistics(now, until);
        auto received =
            m_transport.receive(until, servesProgram() ? m_lent->waitFd() : m_channel.requests.wakeFd());
        if (!received)
            return received.error();
        bytes = std::move(*received);
        if (m_lent && m_engine.hearsForProgram())
            m_lent->write(bytes);
    }
}

std::optional<TimePoint> BusSession::nextTurn(TimePoint now) const {
    const bool moving = m_engine.answersForMotion();
    return earliest({m_engine.nextDeadline(), m_closeBy,
                     m_channel.heartbeat.deadline(moving && !m_engine.lent()),
                     moving ? std::optional(now + LoopGuard::kBeatEvery) : std::nullopt});
}

void BusSession::takeRequests(TimePoint now) {
    RequestBox::Pending taken = m_channel.requests.take();
    if (taken.stop)
        m_engine.stopAll(now);
    if (taken.released)
        m_engine.release(now);
    if (taken.lendAt)
        lend(*taken.lendAt);
    if (taken.endLending && m_lent)
        endLending(LineLent::State::Ended, now);
    m_letThroughWhenStopped = (m_letThroughWhenStopped || taken.letThrough) && m_lent && !taken.stop;
    if (taken.search && !m_lent)
        search(*taken.search, now);
    for (const ModuleIndex module : taken.kept)
        m_engine.keepTrial(module, now);
    for (BusRequest& request : taken.requests)
        take(request, now);
    if (taken.watched)
        m_engine.watch(*taken.watched);
    if (taken.stopOutputs)
        m_engine.setStopOutputs(*taken.stopOutputs);
    if (taken.travelLimits)
        m_engine.setTravelLimits(*taken.travelLimits);
    if (taken.focused)
        m_engine.focus(*taken.focused, now);
    if (taken.held)
        m_engine.hold(*taken.held, now);
}

void BusSession::take(BusRequest& request, TimePoint now) {
    if (!std::holds_alternative<ControlLine>(request))
        m_open.begin(request);
    std::visit(
        Overloaded{
            [&](bus::Operation& operation) { m_engine.submit(std::move(operation), now); },
            [&](const bus::GroupOperation& operation) { m_engine.submit(operation, now); },
            [&](const ChangeRate& change) { changeRate(change, now); },
            [&](const Readdress& readdress) {
                readdress.address ? m_engine.moveTo(readdress.module, *readdress.address, now)
                                  : m_engine.readdress(readdress.module, now);
            },
            [&](const ResetModule& reset) { m_engine.resetModule(reset.module, now, reset.configuration); },
            [&](ControlLine& line) {
                if (auto json = m_transport.control(line.text))
                    m_channel.post(SimulatorAnswered{std::move(line.text), std::move(*json)});
            },
        },
        request);
}

/// This is checked before the modules are sent the new rate: at a rate that the port cannot make, they would
/// be out of reach.
void BusSession::changeRate(const ChangeRate& change, TimePoint now) {
    if (m_engine.anythingMoves() || m_engine.lent())
        return m_engine.changeRate(change.baud, now);  // which refuses
    const bool made = !m_transport.hasFixedRate() && m_transport.setBaud(change.baud).has_value();
    const bool back = m_transport.setBaud(m_portBaud).has_value();
    if (made && back)
        return m_engine.changeRate(change.baud, now);
    bus::RateChangeFailed failed{
        bus::RateChangeFailed::Reason::PortCannot, change.baud, m_engine.stopBurstBaud(), {}, {}};
    m_open.onEvent(failed);
    m_channel.post(bus::Event(std::move(failed)));
}

void BusSession::search(RequestBox::Search how, TimePoint now) {
    switch (how) {
        case RequestBox::Search::Again:
            m_restartWhenStopped = false;
            m_engine.connect(now);
            break;
        case RequestBox::Search::Restart:
            m_restartWhenStopped = m_engine.answersForMotion() && m_engine.stopUnasked(now);
            if (!m_restartWhenStopped)
                m_engine.restart(now);
            break;
    }
}

void BusSession::lend(const std::string& path) {
    auto terminal = LentTerminal::create(path, m_portBaud, m_channel.requests.wakeFd());
    if (terminal && !m_engine.lend())
        terminal = tl::unexpected(LendingProblem{LendingProblem::Kind::NotNow, path, {}});
    if (!terminal)
        return m_channel.post(terminal.error());  // by now the path is free again
    m_lent.emplace(std::move(*terminal));
}

void BusSession::endLending(LineLent::State how, TimePoint now) {
    const std::string path = m_lent->path();
    m_lentReported = LineLent::State::Ended;
    m_lent.reset();
    m_channel.post(LineLent{how, path});
    m_engine.takeBack(now);
    m_engine.connect(now);
}

void BusSession::doWhenStopped(TimePoint now) {
    if (std::exchange(m_letThroughWhenStopped, false) && m_lent) {
        m_engine.letThrough(now);
        m_engine.onProgramRate(m_lent->baud());
    }
    if (std::exchange(m_restartWhenStopped, false))
        m_engine.restart(now);
}

/// A stop that has been requested meanwhile comes first, so it was taken before.
void BusSession::serveProgram(TimePoint now) {
    const LentTerminal::Acts acts = m_lent->takeActs(m_engine.stopBurstBaud());
    m_engine.onProgram(acts.bytes, now);
    if (acts.baud)
        m_engine.onProgramRate(*acts.baud);
    m_engine.onProgram(acts.bytesAtNewRate, now);
    if (acts.left && !m_closeBy)
        endLending(LineLent::State::Left, now);
}

void BusSession::reportLending() {
    if (!m_lent)
        return;
    const LineLent::State state = !m_engine.passes() ? LineLent::State::HeldOff
                                  : m_lent->used()   ? LineLent::State::InUse
                                                     : LineLent::State::Waiting;
    if (std::exchange(m_lentReported, state) != state)
        m_channel.post(LineLent{state, m_lent->path()});
}

/// While the line is lent, a window that is frozen stops nothing: the program goes on.
void BusSession::watchOver(TimePoint now) {
    if (m_channel.heartbeat.missed(now, m_engine.answersForMotion() && !m_engine.lent()))
        m_engine.stopUnasked(now);
    if (const auto slept = m_suspendWatch.check(m_asleepSoFar())) {
        m_engine.distrust(now);
        m_channel.post(ComputerSlept{*slept, m_engine.stopUnasked(now)});
    }
}

tl::expected<void, PortError> BusSession::hearGuards(TimePoint now) {
    bool stoodStill = false;
    for (LoopGuard* guard : m_guards) {
        const LoopGuard::News news = guard->beat(now);
        stoodStill = stoodStill || news.stoppedMotors;
        if (news.problem)
            m_channel.post(GuardianMissing{*news.problem});
    }
    if (!stoodStill)
        return {};
    m_engine.distrust(now);
    m_engine.stopUnasked(now);
    m_channel.post(GuardianStopped{});
    return m_transport.setBaud(m_portBaud);
}

void BusSession::informGuards() {
    Guarded news{m_engine.stopBurst(), m_engine.stopBurstBaud(), m_engine.answersForMotion()};
    if (news == m_guarded)
        return;
    m_guarded = std::move(news);
    const auto burst = m_transport.onWire(m_guarded.burst, m_guarded.baud);
    for (LoopGuard* guard : m_guards)
        guard->arm(burst, m_guarded.baud, m_guarded.moving);
}

tl::expected<void, PortError> BusSession::perform(const std::vector<bus::Output>& outputs) {
    for (const bus::Output& output : outputs) {
        // This process is crashing in another thread, which has sent the final stop to the motors.
        while (crashburst::underWay())
            ::pause();
        tl::expected<void, PortError> done;
        std::visit(Overloaded{
                       [&](const bus::SetHostBaud& rate) {
                           if (m_engine.passes())
                               return followRate(rate.baud, done);
                           m_portBaud = rate.baud;
                           done = m_transport.setBaud(rate.baud);
                       },
                       [&](const bus::Send& send) { done = m_transport.send(send.bytes); },
                       [&](const bus::DiscardInput&) { m_transport.discardInput(); },
                   },
                   output);
        if (!done)
            return done;
    }
    return {};
}

/// The bytes that the program wrote before have the old rate. A rate that the port cannot make is not a
/// reason to disconnect: the program finds that no module answers.
void BusSession::followRate(std::uint32_t baud, tl::expected<void, PortError>& done) {
    if (m_transport.fd() >= 0)
        ::tcdrain(m_transport.fd());
    done = m_transport.setBaud(baud);
    if (done)
        m_portBaud = baud;
    else if (done.error().problem == PortProblem::RateNotPossible)
        done = m_transport.setBaud(m_portBaud);
}

void BusSession::publishEvents() {
    for (bus::Event& event : m_engine.takeEvents()) {
        m_open.onEvent(event);
        m_channel.post(std::move(event));
    }
}

/// Counters are also published before a long wait, during which they would otherwise be stale.
void BusSession::publishStatistics(TimePoint now, std::optional<TimePoint> next) {
    if (next && now - m_published < kStatisticsEvery && *next - now <= kStatisticsEvery)
        return;
    m_channel.publish(m_engine.statistics());
    m_published = now;
}

void BusSession::publishRecords() {
    if (m_engineRecords)
        for (bus::ExchangeRecord& exchange : m_engine.takeRecords())
            m_channel.records.pushSample(std::move(exchange));
    const bool wanted = m_channel.recording.load(std::memory_order_relaxed);
    if (wanted != std::exchange(m_engineRecords, wanted))
        m_engine.setRecording(wanted);
}

}  // namespace nmc

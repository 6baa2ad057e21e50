// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"
#include "bus/gate.h"
#include "bus/retrypolicy.h"

namespace nmc::bus {

void Engine::Private::proceed(TimePoint now) {
    while (line.idle() && dispatch(now)) {
    }
}

/// The lanes in their order. False when there is nothing to do.
bool Engine::Private::dispatch(TimePoint now) {
    // A resync that was under way is over. Here the challenge of link.md 2.2 will begin: two Read Status with
    // the identity, by masks of different length.
    m_resyncing = false;
    if (m_phase == Phase::Off)
        return false;
    if (m_stop) {
        dispatchStop(now);
        return true;
    }
    if (m_phase == Phase::Running) {
        if (m_again && m_again->repeatAtOnce) {
            if (std::exchange(m_suspect, false))
                flushBuffers(now);
            else
                begin(*std::exchange(m_again, std::nullopt), now);
            return true;
        }
        if (m_hold.stop()) {
            stopForHold(now);
            return true;
        }
    }
    if (m_suspect || m_hurried) {
        resync(now);
        return true;
    }
    if (m_again) {
        begin(*std::exchange(m_again, std::nullopt), now);
        return true;
    }
    if (m_phase == Phase::Discovering) {
        dispatchDiscovery(now);
        return true;
    }
    return dispatchHold(now) || dispatchOperation(now) || dispatchPoll(now);
}

void Engine::Private::dispatchDiscovery(TimePoint now) {
    if (m_stopDuringDiscovery && m_discovery->restarted())
        finishStop(now);
    const auto tellProgress = [&] {
        if (const auto progress = m_discovery->takeProgress())
            events.emplace_back(*progress);
    };
    tellProgress();
    Discovery::Next next = m_discovery->next();
    tellProgress();
    if (auto* script = std::get_if<Line::Script>(&next)) {
        line.run(std::move(*script), now);
    } else if (const auto* ask = std::get_if<Discovery::Ask>(&next)) {
        Work work;
        work.lane = Lane::Discovery;
        work.request = ask->request;
        work.silentRepeats = ask->silentRepeats;
        begin(std::move(work), now);
    } else if (auto* found = std::get_if<ChainFound>(&next)) {
        chainFound(std::move(*found));
    } else if (auto* failed = std::get_if<ConnectFailed>(&next)) {
        m_phase = Phase::Off;
        events.emplace_back(std::move(*failed));
    }
}

void Engine::Private::chainFound(ChainFound found) {
    m_phase = Phase::Running;
    line.statistics() = {};  // the silence at the end of the chain was no error
    for (const ModuleInfo& info : found.modules) {
        m_beliefs.emplace_back(info);
        if (knownType(info.identity.type))
            m_beliefs.back().onExecuted(ServoCommand(DefineStatus{kStandingItems}));
    }
    m_schedule = PollSchedule(found.modules.size());
    m_discovery.reset();
    events.emplace_back(std::move(found));
}

void Engine::Private::dispatchStop(TimePoint now) {
    if (std::exchange(m_blindStopsDue, false))
        return sendBlindStops(now);
    noteBlindStops();
    if (std::exchange(m_suspect, false))
        return flushBuffers(now);
    const auto ask = m_stop->next(now);
    if (!ask)
        return finishStop(now);
    const StatusItems items = standstillItems(belief(ask->module).info().identity.type);
    begin(ask->stop ? commandWork(Lane::Stop, {ask->module, *ask->stop})
                    : statusWork(Lane::Stop, ask->module, items),
          now);
}

bool Engine::Private::dispatchHold(TimePoint now) {
    const auto start = m_hold.start();
    if (!start)
        return false;
    const Belief& module = belief(start->module);
    if (!module.fresh() || !module.items()) {
        check(start->module, Lane::HoldCheck, now);
        return true;
    }
    // Load Trajectory would switch the servo on: that is never the hold's business.
    const bool allowed = module.info().identity.type == ModuleType::Servo && module.on() &&
                         judge(module, start->command) == Verdict::Allowed;
    if (!allowed) {
        m_hold.release();
        return m_hold.stop().has_value();
    }
    Work work = commandWork(Lane::Hold, *start);
    work.toldBefore = m_hold.told();
    m_hold.onStartSent();
    begin(std::move(work), now);
    return true;
}

bool Engine::Private::dispatchOperation(TimePoint now) {
    if (m_commands.empty())
        return false;
    m_commands.beginStep(now);
    const Step& step = m_commands.step();
    const bool known = step.module.value() < m_beliefs.size();
    Verdict verdict = known ? judge(belief(step.module), step.command) : Verdict::Never;
    // What forbids may be over by now: one more look before saying no.
    if (verdict == Verdict::InMotion && belief(step.module).statusTime() < m_commands.stepBegan())
        verdict = Verdict::NeedsStatus;
    const bool lengthUnknown = known && !belief(step.module).items();
    if (verdict == Verdict::Allowed && lengthUnknown)
        verdict = Verdict::NeedsStatus;
    switch (verdict) {
        case Verdict::Allowed:
            begin(commandWork(Lane::Operation, step), now);
            break;
        case Verdict::NeedsStatus:
            check(step.module, Lane::Check, now);
            break;
        case Verdict::InMotion:
        case Verdict::Never:
            events.emplace_back(m_commands.failed(Outcome::Forbidden));
            break;
    }
    return true;
}

bool Engine::Private::dispatchPoll(TimePoint now) {
    const auto turn = m_schedule.next(now);
    if (!turn)
        return false;
    const Belief& module = belief(turn->module);
    std::optional<StatusItems> items;  // none: No Operation, which answers with the defined ones
    if (!knownType(module.info().identity.type))
        items = StatusItems(StatusItems::Identity);
    else if (turn->full)
        items = StatusItems(StatusItems::All);
    Work work = statusWork(Lane::Poll, turn->module, items);
    if (m_schedule.silent(turn->module))
        work.silentRepeats = 0;
    begin(std::move(work), now);
    return true;
}

/// link.md 2.2, steps 2 and 3. The challenge comes next; dispatch() has its place.
void Engine::Private::resync(TimePoint now) {
    m_resyncing = true;
    m_suspect = m_hurried = false;
    line.run({Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{},
              Line::Pause{kAfterNulls + line.timing().adapter()}, DiscardInput{}},
             now);
}

/// Empties half-filled command buffers without the quarantine: a stop does not wait for late answers.
void Engine::Private::flushBuffers(TimePoint now) {
    m_hurried = true;
    line.run({Line::Nulls{}, Line::Pause{kAfterNulls}, DiscardInput{}}, now);
}

/// A status that is newer than whatever was sent, for the gate; or first of all a known reply length.
void Engine::Private::check(ModuleIndex module, Lane lane, TimePoint now) {
    const bool known = belief(module).items().has_value();
    begin(statusWork(lane, module, known ? std::optional(StatusItems(StatusItems::All)) : std::nullopt), now);
}

Engine::Private::Work Engine::Private::commandWork(Lane lane, const Step& step) const {
    const Belief& module = belief(step.module);
    const Payload payload = payloadOf(step.command);
    const RetryRule rule = retryRule(payload);
    Work work;
    work.lane = lane;
    work.module = step.module;
    work.request = {module.info().address, payload, layoutOf(module, payload)};
    work.command = step.command;
    work.silentRepeats = rule.silentRepeats;
    work.repeatAtOnce = rule.afterSilence == AfterSilence::RepeatAtOnce;
    work.refusedAttempts = rule.refusedAttempts;
    if (lane == Lane::Stop || lane == Lane::HoldStop || lane == Lane::Hold) {
        // These lanes are asked anew instead: what is wanted may have changed by the next time.
        work.silentRepeats = 0;
        work.refusedAttempts = 1;
    }
    return work;
}

/// Read Status with `items`, or No Operation. While the defined items are in doubt, defining them is the
/// question.
Engine::Private::Work Engine::Private::statusWork(Lane lane, ModuleIndex index,
                                                  std::optional<StatusItems> items) const {
    if (items)
        return commandWork(lane, {index, ServoCommand(ReadStatus{*items})});
    if (!belief(index).items())
        return commandWork(lane, {index, ServoCommand(DefineStatus{kStandingItems})});
    return commandWork(lane, {index, ServoCommand(Nop{})});
}

ReplyLayout Engine::Private::layoutOf(const Belief& module, const Payload& payload) const {
    const ModuleType type = module.info().identity.type;
    if (payload.code == CommandCode::ReadStatus || payload.code == CommandCode::DefineStatus)
        return {type, StatusItems(payload.data[0])};
    return {type, module.items().value_or(kStandingItems)};
}

void Engine::Private::begin(Work work, TimePoint now) {
    if (work.module && work.command) {
        Belief& module = belief(*work.module);
        work.before = module;
        module.onSent(*work.command, line.latchTime(work.request.payload.data.size() + 4, now));
    }
    line.begin(work.request, now);
    m_work = std::move(work);
}

}  // namespace nmc::bus

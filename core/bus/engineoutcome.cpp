// SPDX-License-Identifier: MIT
#include <utility>

#include "bus/engineprivate.h"

namespace nmc::bus {

void Engine::Private::ended(const ReplyEnd& end, TimePoint now) {
    Work work = *std::exchange(m_work, std::nullopt);
    const bool knownSilent = work.module && m_schedule.silent(*work.module);
    learn(work, end, now);
    if (unanswered(end.result)) {
        if (knownSilent && work.lane == Lane::Poll) {
            // It will not answer late: a short discard, so that the others do not wait for it.
            line.run({Line::Pause{line.timing().adapter()}, DiscardInput{}}, now);
        } else {
            m_suspect = true;
            m_quarantine = LineTiming::quarantine(line.lastTimeout());
        }
    }
    if (repeats(work, end)) {
        ++line.statistics().retries;
        m_again = std::move(work);
        return;
    }
    deliver(work, end, now);
}

/// Counts one repeat off, where the retry table grants one.
bool Engine::Private::repeats(Work& work, const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted)
        return false;
    if (end.result == ReplyResult::Refused) {
        ++work.refusals;
        if (work.module)
            events.emplace_back(CommandRefused{*work.module, work.refusals});
        return work.refusals < work.refusedAttempts;
    }
    if (work.silentRepeats == 0)
        return false;
    --work.silentRepeats;
    return true;
}

void Engine::Private::learn(const Work& work, const ReplyEnd& end, TimePoint now) {
    if (!work.module)
        return;
    const ModuleIndex index = *work.module;
    if (unanswered(end.result))
        return noteTimeout(index, now);
    noteAnswer(index, now);
    if (end.result == ReplyResult::Refused) {
        if (work.before)
            belief(index) = *work.before;
        return;
    }
    // The status first: a command's own answer does not tell what the command brought about.
    belief(index).onStatus(end.report, end.latched);
    if (work.command)
        belief(index).onExecuted(*work.command);
    if (work.lane == Lane::Stop)
        tellBlindStop(index);
    if (reported(work))
        events.emplace_back(CommandExecuted{index, end.latched, *work.command});
    events.emplace_back(Sample{index, end.latched, end.report});
}

/// The first answer after a blind stop, before what it says: a command position that went on until the stop
/// is acknowledged would be some 20 ms of travel off.
void Engine::Private::tellBlindStop(ModuleIndex module) {
    const auto stop = m_stop->stopOf(module);
    if (const auto blind = m_stop->takeBlind(module); blind && stop)
        events.emplace_back(CommandExecuted{module, *blind, *stop});
}

/// The model follows what operations, holds and stops did, not the questions.
bool Engine::Private::reported(const Work& work) {
    switch (work.lane) {
        case Lane::HoldStop:
        case Lane::Hold:
        case Lane::Operation:
            return true;
        case Lane::Stop:
            return work.request.payload.code == CommandCode::StopMotor;
        case Lane::Discovery:
        case Lane::HoldCheck:
        case Lane::Check:
        case Lane::Poll:
            break;
    }
    return false;
}

void Engine::Private::deliver(const Work& work, const ReplyEnd& end, TimePoint now) {
    switch (work.lane) {
        case Lane::Discovery:
            return m_discovery->onReply(end);
        case Lane::Stop:
            return m_stop->onReply(end, belief(*work.module), now);
        case Lane::HoldStop:
            return deliverHoldStop(end);
        case Lane::Hold:
            return deliverHold(work, end);
        case Lane::HoldCheck:
            if (end.result != ReplyResult::Accepted)
                m_hold.release();  // unknown: nothing is started, and what was is stopped
            return;
        case Lane::Check:
            if (end.result != ReplyResult::Accepted)
                deliverOperation(end);
            return;
        case Lane::Operation:
            return deliverOperation(end);
        case Lane::Poll:
            return;
    }
}

void Engine::Private::deliverOperation(const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted) {
        if (auto finished = m_commands.accepted())
            events.emplace_back(std::move(*finished));
        return;
    }
    const bool refused = end.result == ReplyResult::Refused;
    events.emplace_back(m_commands.failed(refused ? Outcome::Refused : Outcome::NoAnswer));
}

void Engine::Private::deliverHold(const Work& work, const ReplyEnd& end) {
    static constexpr unsigned kAttempts = 3;
    switch (end.result) {
        case ReplyResult::Accepted:
            m_holdFailures = 0;
            return;
        case ReplyResult::Refused:
            m_hold.onStartRefused(work.toldBefore);
            if (++m_holdFailures < kAttempts)
                return;
            break;
        case ReplyResult::Silent:
        case ReplyResult::Partial:
        case ReplyResult::BadChecksum:
            break;
    }
    // Nobody knows whether it moves as wanted: it stops.
    m_holdFailures = 0;
    if (m_hold.wanted())
        events.emplace_back(HoldExpired{*work.module});
    m_hold.release();
}

void Engine::Private::deliverHoldStop(const ReplyEnd& end) {
    static constexpr unsigned kAttempts = 10;
    if (end.result != ReplyResult::Accepted && ++m_holdFailures < kAttempts) {
        ++line.statistics().retries;
        return;
    }
    m_holdFailures = 0;
    m_hold.onStopEnded();
}

void Engine::Private::noteAnswer(ModuleIndex module, TimePoint now) {
    if (!m_schedule.onAnswer(module, now))
        return;
    m_lost = false;
    // Its replies may have another length by now: the next poll defines it.
    if (knownType(belief(module).info().identity.type))
        belief(module).forgetItems();
    events.emplace_back(ModuleSilence{module, false});
}

void Engine::Private::noteTimeout(ModuleIndex module, TimePoint now) {
    if (m_schedule.onTimeout(module, now))
        events.emplace_back(ModuleSilence{module, true});
    if (m_schedule.allSilent() && !std::exchange(m_lost, true))
        events.emplace_back(LinkLost{});
}

}  // namespace nmc::bus

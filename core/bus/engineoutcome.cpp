// SPDX-License-Identifier: MIT
#include <utility>

#include "bus/engineprivate.h"

namespace nmc::bus {

void Engine::Private::takeEnds(TimePoint now) {
    while (auto end = line.takeEnd())
        ended(std::move(*end), now);
    if (m_recording)
        recordUnanswered();
}

void Engine::Private::ended(ReplyEnd end, TimePoint now) {
    Work work = std::move(m_works.front());
    m_works.pop_front();
    const std::optional<Rejection> rejection = examine(work, end);
    record(work, end, rejection);
    count(end, rejection);
    if (m_phase == Phase::Running || m_phase == Phase::Quiet)
        noteHealth(work, end, now);
    if (work.lane == Lane::Challenge)
        return deliverChallenge(work, end, now);
    if (work.lane == Lane::Restarted)
        return deliverLook(end, now);
    const bool probe = work.module && m_schedule.silent(*work.module) && work.lane == Lane::Poll;
    if (probe)
        return deliverProbe(work, end, now);
    learn(work, end);
    if (unanswered(end.result))
        distrustAfter(work, end, now);
    if (repeats(work, end)) {
        ++line.statistics().retries;
        m_again = std::move(work);
        return;
    }
    deliver(work, end, now);
}

/// Is an answer whose sum is right to be believed?
std::optional<Rejection> Engine::Private::examine(const Work& work, ReplyEnd& end) {
    if (end.result == ReplyResult::Refused && uniform({end.bytes.data(), end.bytes.size()})) {
        end.result = ReplyResult::Rejected;
        return Rejection::Uniform;
    }
    if (end.result != ReplyResult::Accepted || !work.module || work.lane == Lane::Restarted)
        return std::nullopt;
    const auto rejection = at(*work.module).plausibility.judge(end);
    if (rejection)
        end.result = ReplyResult::Rejected;
    return rejection;
}

void Engine::Private::count(const ReplyEnd& end, std::optional<Rejection> rejection) {
    LinkStatistics& statistics = line.statistics();
    if (rejection)
        ++statistics.rejections[static_cast<std::size_t>(*rejection)];
    switch (end.result) {
        case ReplyResult::Accepted:
            ++statistics.answered;
            statistics.roundTripSum += end.arrived - end.sent;
            statistics.roundTripMax = std::max(statistics.roundTripMax, end.arrived - end.sent);
            statistics.wireTime += end.wireTime;
            return;
        case ReplyResult::Refused:
            ++statistics.refused;
            return;
        case ReplyResult::Silent:
        case ReplyResult::Partial:
            ++statistics.timeouts;
            return;
        case ReplyResult::BadChecksum:
            ++statistics.badChecksum;
            return;
        case ReplyResult::Surplus:
            ++statistics.rejections[static_cast<std::size_t>(Rejection::Surplus)];
            ++statistics.rejected;
            return;
        case ReplyResult::Rejected:
            ++statistics.rejected;
            return;
    }
}

/// The line is not trusted before a resync, and its module not before a challenge.
void Engine::Private::distrustAfter(const Work& work, const ReplyEnd& end, TimePoint now) {
    if (end.bytes.empty() && work.module)
        m_silence.onSilence(*work.module);
    using enum Discovery::Quarantine;
    const auto wanted = end.bytes.empty() ? work.quarantine : Full;
    if (wanted == None)
        return line.run({Line::Lag{}, DiscardInput{}}, now);
    m_suspect = true;
    m_quarantine = wanted == Brief ? line.lastTimeout() : LineTiming::quarantine(line.lastTimeout());
    if (!work.module || m_schedule.silent(*work.module))
        return;
    at(*work.module).trust.interrupt();
    if (!m_doubt) {
        m_doubt = Doubt{*work.module};
        m_doubt->bySilence = end.bytes.empty();
    }
}

bool Engine::Private::isStart(const Work& work) {
    return work.lane == Lane::Operation && work.request.payload.code == CommandCode::StartMotion;
}

/// Counts one repeat off, where the retry table grants one.
bool Engine::Private::repeats(Work& work, const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted)
        return false;
    if (end.result == ReplyResult::Refused) {
        ++work.refusals;
        const unsigned before = isStart(work) ? m_attempts : 0;
        if (work.module)
            events.emplace_back(
                CommandRefused{*work.module, static_cast<std::uint8_t>(work.refusals + before)});
        // That a start was refused is the module's word alone; a second start would be worse than a look.
        return !isStart(work) && work.refusals < work.refusedAttempts;
    }
    if (work.silentRepeats == 0)
        return false;
    --work.silentRepeats;
    return true;
}

void Engine::Private::learn(const Work& work, const ReplyEnd& end) {
    if (!work.module || unanswered(end.result))
        return;
    Module& module = at(*work.module);
    if (end.result == ReplyResult::Refused) {
        module.trust.interrupt();
        if (work.before)
            module.belief = *work.before;
        // What waits is not what was asked for.
        if (work.request.payload.code == CommandCode::LoadTrajectory)
            module.belief.forgetLoad();
        return;
    }
    // The status first: a command's own answer does not tell what the command brought about.
    const auto trusted = module.trust.confirm(end.report);
    if (trusted)
        module.belief.onStatus(*trusted, end.latched);
    if (work.command)
        module.belief.onExecuted(*work.command);
    if (work.lane == Lane::Stop)
        tellBlindStop(*work.module);
    if (work.lane == Lane::GroupLook)
        noteGroupLook(*work.module, end);
    if (reported(work))
        events.emplace_back(CommandExecuted{*work.module, end.latched, *work.command, end.late});
    if (work.request.payload.code == CommandCode::SetAddress)
        events.emplace_back(GroupChanged{*work.module, module.belief.info().group});
    if (trusted)
        publish(*work.module, end, *trusted);
}

void Engine::Private::publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted) {
    events.emplace_back(Sample{module, end.latched, trusted, end.late, end.report.status});
    if (const auto reason = at(module).watch.onReport(trusted))
        guard(module, *reason, trusted.position.value_or(0));
}

/// Something is wrong with a motion: its module stops, and what was to come is dropped. A motor that runs the
/// wrong way would run on with its servo on, so that is switched off.
void Engine::Private::guard(ModuleIndex module, MotionSuspect::Reason reason, std::int32_t position) {
    using servo::StopManner;
    events.emplace_back(MotionSuspect{module, reason, position});
    cancelOperations();
    m_hold.clear();
    // A servo that is off already must not be switched on by its stop.
    const bool off = reason == MotionSuspect::Reason::WrongWay || !belief(module).on();
    m_guards.push_back({module, ServoCommand(servo::StopMotor{
                                    !off, off ? StopManner::MotorOff : StopManner::Abruptly, {}})});
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
        case Lane::Guard:
        case Lane::HoldStop:
        case Lane::Hold:
        case Lane::Operation:
        case Lane::Group:
            return true;
        case Lane::Stop:
            return work.request.payload.code == CommandCode::StopMotor;
        case Lane::Discovery:
        case Lane::HoldCheck:
        case Lane::Check:
        case Lane::GroupLook:
        case Lane::Rate:
        case Lane::Challenge:
        case Lane::Restarted:
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
        case Lane::Guard:
            return deliverGuard(end);
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
                failOperation(end);
            return;
        case Lane::Operation:
            return deliverOperation(work, end);
        case Lane::Group:
            if (m_groupRun)
                m_groupRun->onLeader(*work.module, end.result);
            return;
        case Lane::GroupLook:
            if (m_groupRun && end.result != ReplyResult::Accepted)
                m_groupRun->onSilence(*work.module);
            return;
        case Lane::Rate:
            if (m_rateChange)
                m_rateChange->onReply(end);
            return;
        case Lane::Challenge:
        case Lane::Restarted:
        case Lane::Poll:
            return;
    }
}

void Engine::Private::deliverOperation(const Work& work, const ReplyEnd& end) {
    if (m_commands.empty())
        return;  // cancelled while it was on its way
    if (end.result == ReplyResult::Accepted) {
        m_attempts = 0;
        if (auto finished = m_commands.accepted())
            events.emplace_back(std::move(*finished));
        return;
    }
    const bool look = end.result == ReplyResult::Refused ? isStart(work) : canVerify(*work.command);
    if (look && !m_schedule.silent(*work.module)) {
        m_verification = Verification{end, work.before->position(), m_attempts};
        return;
    }
    failOperation(end);
}

void Engine::Private::failOperation(const ReplyEnd& end) {
    m_attempts = 0;
    m_verification.reset();
    if (m_commands.empty())
        return;
    const bool refused = end.result == ReplyResult::Refused;
    tellGroupUnknown();
    events.emplace_back(m_commands.failed(refused ? Outcome::Refused : Outcome::NoAnswer));
}

/// A change of groups was not answered.
void Engine::Private::tellGroupUnknown() {
    if (m_commands.group() == nullptr || !m_commands.planned())
        return;
    const ModuleIndex module = m_commands.step().module;
    if (!belief(module).info().group)
        events.emplace_back(GroupChanged{module, std::nullopt});
}

void Engine::Private::deliverHold(const Work& work, const ReplyEnd& end) {
    static constexpr unsigned kAttempts = 3;
    if (end.result == ReplyResult::Accepted) {
        m_holdFailures = 0;
        return;
    }
    if (end.result == ReplyResult::Refused) {
        m_hold.onStartRefused(work.toldBefore);
        if (++m_holdFailures < kAttempts)
            return;
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

void Engine::Private::deliverGuard(const ReplyEnd& end) {
    static constexpr unsigned kAttempts = 10;
    if (m_guards.empty())
        return;  // a stop of all came first
    if (end.result != ReplyResult::Accepted && ++m_guardFailures < kAttempts) {
        ++line.statistics().retries;
        return;
    }
    m_guardFailures = 0;
    m_guards.pop_front();
}

void Engine::Private::chainFound(ChainFound found, TimePoint now) {
    m_phase = Phase::Running;
    m_baud = found.baud;
    line.statistics() = {};  // the silence at the end of the chain was no error
    for (const ModuleInfo& info : found.modules) {
        m_modules.emplace_back(info);
        Belief& module = m_modules.back().belief;
        if (knownType(info.identity.type))
            module.onExecuted(ServoCommand(DefineStatus{kStandingItems}));
        if (found.attached)
            module.attach();
    }
    m_schedule = PollSchedule(found.modules.size());
    m_schedule.watch(m_watched);
    events.emplace_back(std::move(found));
    for (const Discovery::Heard& heard : m_discovery->heard()) {
        Module& module = at(heard.module);
        if (module.plausibility.judge(heard.end))
            continue;
        if (const auto trusted = module.trust.confirm(heard.end.report)) {
            module.belief.onStatus(*trusted, heard.end.latched);
            publish(heard.module, heard.end, *trusted);
        }
    }
    m_discovery.reset();
    if (m_stopDuringDiscovery) {
        // Asked for while nobody knew what there was to stop.
        m_stopDuringDiscovery.reset();
        m_stop.emplace(beliefs(), m_schedule, now);
    }
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
// What came of an exchange: is it believed, is it repeated, who has to know.
#include <algorithm>
#include <utility>

#include "bus/engine.h"

namespace nmc::bus {

void Engine::takeEnds(TimePoint now) {
    while (auto end = m_line.takeEnd()) {
        onEnd(std::move(*end), now);
        takeFindings(now);
    }
    const bool connects = m_search.active() || m_rate.active();
    m_recorder.addUnanswered(connects               ? Purpose::Connect
                             : m_operations.empty() ? Purpose::Stop
                                                    : Purpose::Operation);
}

void Engine::onEnd(ReplyEnd end, TimePoint now) {
    Work work = std::move(m_works.front());
    m_works.pop_front();
    const std::optional<Rejection> rejection = examine(work.ask, end);
    m_recorder.add(work.ask, end, rejection);
    count(end, rejection);
    if (m_connected)
        noteHealth(work.ask, end, now);
    const bool right = end.result == ReplyResult::Accepted;
    if (work.ask.believed && (right || !work.ask.handlesFailure))
        learn(work, end);
    if (work.ask.handlesFailure)
        return deliver(work, end, now);
    if (work.ask.reported && !right && end.result != ReplyResult::Refused)
        m_chain.noteUnanswered(*work.ask.module, end.latched);
    if (unanswered(end.result))
        if (Line::Script script = m_recovery.onUnanswered(work.ask, end); !script.empty())
            m_line.run(std::move(script), now);
    if (repeats(work, end)) {
        ++m_line.statistics().retries;
        m_again = std::move(work);
        return;
    }
    deliver(work, end, now);
}

/// Is what came to be believed? Why not, where it is not its sum that is wrong.
std::optional<Rejection> Engine::examine(const Ask& ask, ReplyEnd& end) {
    if (end.result == ReplyResult::Refused && uniform({end.bytes.data(), end.bytes.size()})) {
        end.result = ReplyResult::Rejected;
        return Rejection::Uniform;
    }
    if (end.result == ReplyResult::Surplus)
        return Rejection::Surplus;
    if (end.result == ReplyResult::Echo)
        return Rejection::Echo;
    if (end.result != ReplyResult::Accepted || !ask.module)
        return std::nullopt;
    const auto rejection = m_chain.at(*ask.module).plausibility.judge(end);
    if (rejection)
        end.result = ReplyResult::Rejected;
    return rejection;
}

void Engine::count(const ReplyEnd& end, std::optional<Rejection> rejection) {
    LinkStatistics& statistics = m_line.statistics();
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
        case ReplyResult::Unresponsive:
        case ReplyResult::Partial:
            ++statistics.timeouts;
            return;
        case ReplyResult::BadChecksum:
            ++statistics.badChecksum;
            return;
        case ReplyResult::Surplus:
        case ReplyResult::Rejected:
        case ReplyResult::Echo:
            ++statistics.rejected;
            return;
    }
}

/// Every exchange that was to be answered fills or empties the buckets. Silence does so only when its module
/// answers again: else it is the module that is missing, and told of as that.
void Engine::noteHealth(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    const bool right = end.result == ReplyResult::Accepted;
    if (!ask.module || (!right && end.bytes.empty()))
        return;
    for (const Recovery::GivenUp& what : m_recovery.note(*ask.module, right))
        giveUp(what, now);
}

/// Counts one repeat off, where the retry table grants one.
bool Engine::repeats(Work& work, const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted || work.task == nullptr)
        return false;
    if (end.result == ReplyResult::Refused) {
        ++work.refusals;
        const auto attempt = static_cast<std::uint8_t>(work.refusals + work.ask.refusedBefore);
        if (work.ask.module)
            m_events.emplace_back(CommandRefused{*work.ask.module, attempt});
        return work.refusals < work.ask.refusedAttempts;
    }
    if (work.ask.silentRepeats == 0)
        return false;
    --work.ask.silentRepeats;
    return true;
}

void Engine::deliver(const Work& work, const ReplyEnd& end, TimePoint now) {
    if (work.task == nullptr)
        return;
    if (Line::Script script = work.task->onEnd(work.ask, end, now); !script.empty() && m_line.idle())
        m_line.run(std::move(script), now);
}

void Engine::learn(const Work& work, const ReplyEnd& end) {
    const Ask& ask = work.ask;
    if (!ask.module || unanswered(end.result))
        return;
    Chain::Module& module = m_chain.at(*ask.module);
    if (end.result == ReplyResult::Refused) {
        module.trust.interrupt();
        if (work.before)
            static_cast<Chain::Memory&>(module) = *work.before;
        // What waits is not what was asked for.
        if (ask.command &&
            (is<servo::LoadTrajectory>(*ask.command) || is<stepper::LoadTrajectory>(*ask.command)))
            module.belief.forgetLoad();
        return;
    }
    // The status first: a command's own answer does not tell what the command brought about.
    const auto trusted = module.trust.confirm(end.report);
    if (trusted)
        module.belief.onStatus(*trusted, end.latched);
    if (ask.command)
        module.belief.onExecuted(*ask.command);
    if (ask.command && is<servo::SetGain>(*ask.command) && work.task != &m_trials)
        m_trials.forget(*ask.module);
    if (work.task != nullptr)
        work.task->onAnswer(ask, end);
    if (trusted) {
        m_path.onReport(*ask.module, end);
        m_trials.onReport(*ask.module, *trusted, end.latched);
    }
    if (ask.reported)
        m_events.emplace_back(CommandExecuted{*ask.module, end.latched, *ask.command, end.late,
                                              m_chain.takeUnanswered(*ask.module, end.latched)});
    if (ask.request.payload.code == CommandCode::SetAddress)
        m_events.emplace_back(GroupChanged{*ask.module, module.belief.info().group});
    if (trusted && ask.purpose == Purpose::Poll)
        m_operations.notePoll(*ask.module, end);
    if (trusted)
        publish(*ask.module, end, *trusted);
}

void Engine::publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted) {
    Chain::Module& known = m_chain.at(module);
    m_events.emplace_back(Sample{module, end.latched, trusted, end.late, end.report.status,
                                 known.plausibility.takeJump(), known.unanswered.has_value()});
    if (m_config.readOnly)
        return;  // whatever moves there is for others to start and to stop
    // Attached, it may move as it likes; its velocity tells.
    const bool mayMove = known.belief.mayMove() && !known.belief.pwmUnknown();
    if (known.ownMotion.onReport(end.report, end.latched, mayMove))
        m_events.emplace_back(ForeignMotion{module, trusted.position.value_or(0)});
    if (const auto manner = known.travel.onReport(trusted, end.latched, known.belief);
        manner && (!known.owed || known.owed->cause != StopCause::TravelLimit)) {
        m_events.emplace_back(StoppedBeforeLimit{module});
        haltAxes({module}, StopCause::TravelLimit, *manner);
    }
    const auto reason = known.watch.onReport(trusted);
    if (!reason)
        return;
    m_events.emplace_back(MotionSuspect{module, *reason, trusted.position.value_or(0)});
    // A motor that runs the wrong way would run on with its servo on.
    const bool off = *reason == MotionSuspect::Reason::WrongWay || !m_chain.belief(module).on();
    halt(module, StopCause::MotionSuspect, off ? StopManner::Off : StopManner::Abruptly);
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include <utility>

#include "bus/engineprivate.h"
#include "bus/gate.h"
#include "bus/retrypolicy.h"

namespace nmc::bus {

namespace {

/// How often a command is repeated that was provably not carried out.
constexpr unsigned kRepeatsAfterLook = 2;

/// A stop wants to be seen through at every module. Stop Here is a step of a motor that goes on being looked
/// at.
[[nodiscard]] bool endsFocus(const ModuleCommand& command) {
    if (const auto* servo = std::get_if<ServoCommand>(&command)) {
        const auto* stop = std::get_if<servo::StopMotor>(servo);
        return stop != nullptr && stop->manner != servo::StopManner::Here &&
               stop->manner != servo::StopManner::AmplifierOnly;
    }
    return std::holds_alternative<step::StopMotor>(std::get<StepCommand>(command));
}

}  // namespace

void Engine::Private::proceed(TimePoint now) {
    do
        takeEnds(now);
    while ((line.idle() || (line.ready() && mayPipeline())) && dispatch(now));
}

/// While the reply before may still turn out to have surplus bytes, only an ordinary exchange may begin.
bool Engine::Private::mayPipeline() const {
    return m_phase == Phase::Running && !m_stop && !m_suspect && !m_hurried && !m_doubt && !m_again &&
           m_look == Look::None && m_guards.empty() && !m_hold.stop() && m_commands.group() == nullptr &&
           !m_rateChange && !m_abandoned;
}

/// The lanes in their order. False when there is nothing to do.
bool Engine::Private::dispatch(TimePoint now) {
    m_resyncing = false;  // one that was under way is over
    if (m_phase == Phase::Off)
        return false;
    if (dispatchWayBack(now))
        return true;
    if (strayed() && !m_rateChange && stopDue(now)) {
        goBack(now);
        return true;
    }
    if (m_stop) {
        dispatchStop(now);
        return true;
    }
    if (m_phase == Phase::Quiet)
        return false;
    if (m_phase == Phase::Running && dispatchUrgent(now))
        return true;
    if (m_suspect || m_hurried) {
        resync(now);
        return true;
    }
    if (m_phase == Phase::Discovering && !m_again) {
        dispatchDiscovery(now);
        return true;
    }
    if (m_doubt) {
        dispatchChallenge(now);
        return true;
    }
    if (m_look != Look::None) {
        dispatchLook(now);
        return true;
    }
    if (m_again) {
        begin(*std::exchange(m_again, std::nullopt), now);
        return true;
    }
    if (m_rateChange) {
        dispatchRateChange(now);
        return true;
    }
    return dispatchHold(now) || dispatchOperation(now) || dispatchPoll(now);
}

/// The port is at another rate than the chain: a module without an address is being looked for.
bool Engine::Private::strayed() const {
    return (m_phase == Phase::Running || m_phase == Phase::Quiet) && line.baud() != m_baud;
}

bool Engine::Private::stopDue(TimePoint now) const {
    return m_stop || !m_guards.empty() || m_hold.stop() || lostBurstDue(now) ||
           (m_again && m_again->repeatAtOnce);
}

/// What does not wait for a link in doubt.
bool Engine::Private::dispatchUrgent(TimePoint now) {
    if (lostBurstDue(now)) {
        dispatchLostBurst(now);
        return true;
    }
    if (m_again && m_again->repeatAtOnce) {
        if (std::exchange(m_suspect, false))
            flushBuffers(now);
        else
            begin(*std::exchange(m_again, std::nullopt), now);
        return true;
    }
    if (!m_guards.empty()) {
        dispatchGuard(now);
        return true;
    }
    if (m_hold.stop()) {
        stopForHold(now);
        return true;
    }
    return false;
}

void Engine::Private::dispatchGuard(TimePoint now) {
    if (std::exchange(m_suspect, false))
        return flushBuffers(now);
    begin(commandWork(Lane::Guard, m_guards.front()), now);
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
        work.refusedAttempts = ask->refusedAttempts;
        work.quarantine = ask->quarantine;
        begin(std::move(work), now);
    } else if (auto* found = std::get_if<ChainFound>(&next)) {
        chainFound(std::move(*found), now);
    } else if (auto* failed = std::get_if<ConnectFailed>(&next)) {
        m_phase = Phase::Off;
        events.emplace_back(std::move(*failed));
        if (m_stopDuringDiscovery)
            finishStop(now);
    }
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
    begin(ask->stop ? commandWork(Lane::Stop, {ask->module, *ask->stop})
                    : statusWork(Lane::Stop, ask->module, ask->items),
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
    // Load Trajectory would switch a servo on: that is never the hold's business.
    const bool allowed = module.on() && judge(module, start->command) == Verdict::Allowed;
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
    if (m_verification)
        return dispatchVerification(now);
    if (m_commands.group() != nullptr && dispatchGroup(now))
        return true;
    m_commands.beginStep(now);
    const Step& step = m_commands.step();
    const bool known = step.module.value() < m_modules.size();
    const bool change = m_commands.group() != nullptr;  // judged when it was planned
    Verdict verdict = !known   ? Verdict::Never
                      : change ? Verdict::Allowed
                               : judge(belief(step.module), step.command);
    // What forbids may be over by now: two more looks before saying no, since one is not enough to permit.
    if (verdict == Verdict::InMotion && belief(step.module).looksSince(m_commands.stepBegan()) < 2)
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

/// Was the command that nobody answered carried out? A look at the module tells, or it stays open.
bool Engine::Private::dispatchVerification(TimePoint now) {
    const Step& step = m_commands.step();
    // Two looks: one is not enough to say that it stands still.
    if (m_verification->looks < 2) {
        ++m_verification->looks;
        check(step.module, Lane::Check, now);
        return true;
    }
    const Verification verification = *std::exchange(m_verification, std::nullopt);
    switch (verify(step, belief(step.module), verification)) {
        case Carried::Out:
            belief(step.module).onExecuted(step.command);
            m_attempts = 0;
            events.emplace_back(
                CommandExecuted{step.module, verification.end.latched, step.command, verification.end.late});
            if (auto finished = m_commands.accepted())
                events.emplace_back(std::move(*finished));
            return true;
        case Carried::NotOut:
            if (verification.attempts < kRepeatsAfterLook) {
                m_attempts = verification.attempts + 1;
                ++line.statistics().retries;
                return true;  // the gate looks at it again
            }
            break;
        case Carried::Unknown:
            break;
    }
    failOperation(verification.end);
    return true;
}

bool Engine::Private::dispatchPoll(TimePoint now) {
    const auto turn = m_schedule.next(now);
    if (!turn)
        return false;
    const Belief& module = belief(turn->module);
    std::optional<StatusItems> items;  // none: No Operation, which answers with the defined ones
    if (!knownType(module.info().identity.type))
        items = kIdentityItems;
    else if (turn->full)
        items = kAllItems;
    else if (turn->brief)
        items = kBriefItems;
    Work work = statusWork(Lane::Poll, turn->module, items);
    work.silentRepeats = 0;  // its turn comes again
    work.request.framing = Framing::Pipelined;
    begin(std::move(work), now);
    return true;
}

/// A status that is newer than whatever was sent, for the gate; or first of all a known reply length. Of
/// another length than the last one, so that two of them permit.
void Engine::Private::check(ModuleIndex module, Lane lane, TimePoint now) {
    const bool known = belief(module).items().has_value();
    begin(statusWork(lane, module, known ? std::optional(belief(module).otherItems()) : std::nullopt), now);
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
    // To its own address again, and the challenge before has shown that it is there (link.md 2.3).
    if (lane == Lane::Operation && payload.code == CommandCode::SetAddress)
        work.silentRepeats = 2;
    if (lane == Lane::Stop || lane == Lane::Guard || lane == Lane::HoldStop || lane == Lane::Hold) {
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
        const TimePoint latched = line.latchTime(work.request.payload.data.size() + 4, now);
        work.before = belief(*work.module);
        tell(*work.module, *work.command, latched);
    }
    line.begin(work.request, now);
    work.sent = now;
    m_works.push_back(std::move(work));
}

/// The command goes out: all that watch the module must reckon with it.
void Engine::Private::tell(ModuleIndex index, const ModuleCommand& command, TimePoint latched) {
    Module& module = at(index);
    module.belief.onSent(command, latched);
    module.plausibility.onSent(command, latched);
    module.watch.onSent(command);
    if (mayStartMotion(payloadOf(command)))
        module.trust.expectMotion();
    if (endsFocus(command))
        m_schedule.unfocus();
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"

namespace nmc::bus {

namespace {

/// Questions in a row that a module in doubt must answer.
constexpr unsigned kPasses = 2;
/// Failed questions until it is given up: three wrong answers, or silence to three questions with the one
/// that began it.
constexpr unsigned kFailures = 3;
constexpr unsigned kSilentFailures = 2;
/// Probes of silent modules between two looks for one that has restarted.
constexpr unsigned kLookEvery = 4;
/// A dead line may still carry commands: stops go on for five seconds (faults.md F-11).
constexpr unsigned kLostBursts = 10;
constexpr Duration kLostBurstEvery = std::chrono::milliseconds(500);

}  // namespace

/// link.md 2.2, steps 2 and 3. What is in doubt then has to show itself: dispatchChallenge().
void Engine::Private::resync(TimePoint now) {
    m_resyncing = true;
    m_suspect = m_hurried = false;
    ++line.statistics().resyncs;
    line.run(
        {Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{}, Line::Lag{kAfterNulls}, DiscardInput{}},
        now);
}

/// Empties half-filled command buffers without the quarantine: a stop does not wait for late answers.
void Engine::Private::flushBuffers(TimePoint now) {
    m_hurried = true;
    line.run({Line::Nulls{}, Line::Pause{kAfterNulls}, DiscardInput{}}, now);
}

/// link.md 2.2, steps 4 and 5: two questions whose answers differ in length and both tell who it is.
void Engine::Private::dispatchChallenge(TimePoint now) {
    Doubt& doubt = *m_doubt;
    doubt.witness = std::exchange(doubt.witnessDue, false);
    ModuleIndex asked = doubt.module;
    if (doubt.witness) {
        const auto other = witness();
        doubt.witness = other.has_value();
        asked = other.value_or(doubt.module);
    }
    const bool known = knownType(belief(asked).info().identity.type);
    const bool full = doubt.passed > 0 && known && !doubt.witness;
    Work work = statusWork(Lane::Challenge, asked, full ? kAllItems : kIdentityItems);
    work.silentRepeats = 0;
    begin(std::move(work), now);
}

/// Somebody who should answer if the bus is there at all.
std::optional<ModuleIndex> Engine::Private::witness() const {
    for (const Module& module : m_modules) {
        const ModuleIndex index = module.belief.info().index;
        if (!m_schedule.silent(index) && !m_silence.asked(index))
            return index;
    }
    return std::nullopt;
}

void Engine::Private::deliverChallenge(const Work& work, const ReplyEnd& end, TimePoint now) {
    Doubt& doubt = *m_doubt;
    if (end.result == ReplyResult::Accepted) {
        if (doubt.witness)
            return;
        learn(work, end);
        const bool known = knownType(belief(doubt.module).info().identity.type);
        if (++doubt.passed == (known ? kPasses : 1))
            passed(doubt.module, now);
        return;
    }
    m_suspect = true;
    at(*work.module).trust.interrupt();
    const bool silent = end.result == ReplyResult::Silent;
    if (silent)
        m_silence.onSilence(*work.module);
    if (m_silence.dead(m_schedule.answering()))
        return loseAll(now);
    const bool likelyDead = silent && m_silence.likelyDead();
    m_quarantine = likelyDead ? line.timing().adapter() : LineTiming::quarantine(line.lastTimeout());
    doubt.witnessDue = likelyDead;
    if (doubt.witness)
        return;
    doubt.passed = 0;
    doubt.witnessDue = silent;
    doubt.silences += silent ? 1U : 0U;
    if (++doubt.failures == kFailures || doubt.silences == kSilentFailures || doubt.wasSilent)
        lose(doubt.module, now);
}

/// The module is what it was, and the answers are its own.
void Engine::Private::passed(ModuleIndex module, TimePoint now) {
    // Now it is known that an answer got lost, and not its module.
    if (m_doubt->bySilence)
        noteExchange(module, false, now);
    m_doubt.reset();
    // Its replies may have another length by now: that is defined anew before the next No Operation.
    if (knownType(belief(module).info().identity.type))
        belief(module).forgetItems();
    if (!m_schedule.silent(module))
        return;
    m_schedule.recover(module, now);
    m_lost = false;
    m_lostBursts = 0;
    events.emplace_back(ModuleSilence{module, false});
}

/// The module does not answer: it is asked rarely from now on, and the others go on.
void Engine::Private::lose(ModuleIndex module, TimePoint now) {
    m_doubt.reset();
    if (std::exchange(m_lookedAt, module) != module || m_baud == kPowerUpBaud)
        m_look = m_baud == kPowerUpBaud ? Look::Ask : Look::GoSlow;
    if (m_schedule.silent(module))
        return m_schedule.onTimeout(module, now);
    m_schedule.lose(module, now);
    events.emplace_back(ModuleSilence{module, true});
    if (m_again && m_again->module == module)
        giveUpRepeat(now);
    if (m_schedule.allSilent())
        loseAll(now);
}

/// What was to be repeated will not be answered.
void Engine::Private::giveUpRepeat(TimePoint now) {
    if (!m_again)
        return;
    const Work given = *std::exchange(m_again, std::nullopt);
    deliver(given, ReplyEnd{}, now);
}

/// Nobody answers: the line is dead, at least from the modules to here.
void Engine::Private::loseAll(TimePoint now) {
    m_doubt.reset();
    m_look = Look::None;
    m_suspect = false;  // nothing is to be expected, so nothing to be waited for
    for (const Module& module : m_modules) {
        const ModuleIndex index = module.belief.info().index;
        if (module.belief.restarted() || m_schedule.silent(index))
            continue;
        m_schedule.lose(index, now);
        events.emplace_back(ModuleSilence{index, true});
    }
    giveUpRepeat(now);
    if (std::exchange(m_lost, true))
        return;
    events.emplace_back(LinkLost{});
    // Commands may still arrive.
    m_lostBursts = kLostBursts;
    m_nextLostBurst = now;
}

bool Engine::Private::lostBurstDue(TimePoint now) const {
    return m_lostBursts > 0 && now >= m_nextLostBurst;
}

void Engine::Private::dispatchLostBurst(TimePoint now) {
    --m_lostBursts;
    m_nextLostBurst = now + kLostBurstEvery;
    const std::vector<Step> stops = stopsOwed();
    if (stops.empty()) {
        m_lostBursts = 0;
        return;
    }
    Line::Script script{Line::Gap{}, Line::Nulls{}, Line::Pause{kAfterNulls}};
    const Line::Script packets = stopScript(stops);
    script.insert(script.end(), packets.begin(), packets.end());
    line.run(std::move(script), now);
}

/// A question to a module that has not been answering.
void Engine::Private::deliverProbe(const Work& work, const ReplyEnd& end, TimePoint now) {
    const ModuleIndex module = *work.module;
    if (end.result == ReplyResult::Accepted) {
        m_doubt = Doubt{module, true};
        return;
    }
    // It will not answer late: a short discard, so that the others do not wait for it.
    line.run({Line::Lag{}, DiscardInput{}}, now);
    m_schedule.onTimeout(module, now);
    const bool turn = ++m_probes % kLookEvery == 0;
    if (turn && m_baud == kPowerUpBaud && !m_schedule.allSilent())
        m_look = Look::Ask;
}

/// A module that restarted has no address and the rate of power-up (faults.md F-15, F-16). Nobody else has no
/// address, so one question tells. At another rate the chain is left alone for as long as that takes.
void Engine::Private::dispatchLook(TimePoint now) {
    switch (m_look) {
        case Look::None:
            return;
        case Look::GoSlow:
            m_look = Look::Ask;
            return line.run(Line::toRate(kPowerUpBaud), now);
        case Look::Ask: {
            m_look = m_baud == kPowerUpBaud ? Look::None : Look::Back;
            Work work;
            work.lane = Lane::Restarted;
            work.request = {BusAddress(0), ReadStatus{kIdentityItems}.encode(), {{}, kIdentityItems}};
            return begin(std::move(work), now);
        }
        case Look::Back:
            return goBack(now);
    }
}

void Engine::Private::goBack(TimePoint now) {
    m_look = Look::None;
    line.run(Line::toRate(m_baud), now);
}

void Engine::Private::deliverLook(const ReplyEnd& end, TimePoint now) {
    const bool explained = std::any_of(m_modules.begin(), m_modules.end(),
                                       [](const Module& module) { return module.belief.restarted(); });
    if (unanswered(end.result) || !end.report.identity || explained) {
        if (m_look == Look::None)
            line.run({Line::Lag{}, DiscardInput{}}, now);
        return;
    }
    // Modules nearer the host may have gone deaf with it: it is the farthest of those that do not answer.
    const auto restarted = std::find_if(m_modules.begin(), m_modules.end(), [&](const Module& module) {
        return m_schedule.silent(module.belief.info().index) && !module.belief.restarted();
    });
    if (restarted == m_modules.end() || restarted->belief.info().identity != *end.report.identity)
        return;
    const ModuleIndex module = restarted->belief.info().index;
    restarted->belief.setRestarted();
    m_schedule.retire(module);
    const bool quiet = m_baud != kPowerUpBaud;
    events.emplace_back(ModuleRestarted{module, quiet});
    events.emplace_back(GroupChanged{module, restarted->belief.info().group});
    // What the others hear at their rate is noise to it, and might one day be a command: no more of it.
    if (quiet)
        giveUp(now);
}

/// Every exchange that was to be answered fills or empties the buckets. Silence does so only when its module
/// answers again: else it is the module that is missing, and told of as that.
void Engine::Private::noteHealth(const Work& work, const ReplyEnd& end, TimePoint now) {
    if (!work.module || work.lane == Lane::Restarted)
        return;
    const bool right = end.result == ReplyResult::Accepted;
    if (right || !end.bytes.empty())
        noteExchange(*work.module, right, now);
}

void Engine::Private::noteExchange(ModuleIndex index, bool right, TimePoint now) {
    Module& module = at(index);
    for (Health* health : {&module.health, &m_health}) {
        const LinkHealth before = health->level();
        right ? health->good() : health->wrong();
        if (health->level() == before)
            continue;
        const bool one = health == &module.health;
        events.emplace_back(HealthChanged{health->level(), health->wrongLately(), health->exchanges(),
                                          one ? std::optional(index) : std::nullopt});
        if (health->level() != LinkHealth::Lost || m_phase != Phase::Running)
            continue;
        if (!one)
            return giveUp(now);
        giveUp(index, now);
    }
}

/// The module is stopped and not asked again; the others go on.
void Engine::Private::giveUp(ModuleIndex module, TimePoint now) {
    if (const auto stop = stopFor(belief(module)))
        m_guards.push_back({module, *stop});
    if (m_doubt && m_doubt->module == module)
        m_doubt.reset();
    m_schedule.lose(module, now);
    m_schedule.retire(module);
    events.emplace_back(ModuleSilence{module, true});
}

/// All motors are stopped, and then nothing is asked any more.
void Engine::Private::giveUp(TimePoint now) {
    m_phase = Phase::Quiet;
    m_doubt.reset();
    m_look = Look::None;
    cancelOperations();
    m_hold.clear();
    m_guards.clear();
    m_again.reset();
    m_suspect = true;
    if (!m_stop)
        m_stop.emplace(beliefs(), m_schedule, now);
}

}  // namespace nmc::bus

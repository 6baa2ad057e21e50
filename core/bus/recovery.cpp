// SPDX-License-Identifier: MIT
#include "bus/recovery.h"

namespace nmc::bus {

namespace {

/// Consecutive queries that a module in doubt must answer.
constexpr unsigned kPasses = 2;
/// Failed queries until the module is given up: three wrong answers, or three silences, counting the one that
/// started the doubt.
constexpr unsigned kFailures = 3;
constexpr unsigned kSilentFailures = 2;

}  // namespace

void Recovery::reset() {
    m_state = LineState::Trusted;
    m_lost = m_givenUp = false;
    m_doubt.reset();
    m_silence.heard();
    m_health = {};
    m_findings = {};
}

/// The line is not trusted before a resync, and the module not before a challenge.
Line::Script Recovery::onUnanswered(const Ask& ask, const ReplyEnd& end) {
    if (end.bytes.empty() && ask.module)
        m_silence.onSilence(*ask.module);
    const Quarantine wanted = end.bytes.empty() ? ask.quarantine : Quarantine::Full;
    if (wanted == Quarantine::None)
        return {Line::Lag{}, DiscardInput{}};
    m_state = LineState::Suspect;
    // A patient request has already waited for late answers.
    m_quarantine = wanted == Quarantine::Brief ? m_line.lastTimeout() - ask.request.patience
                                               : LineTiming::quarantine(m_line.lastTimeout());
    if (!ask.module || !m_chain.answers(*ask.module))
        return {};
    m_chain.at(*ask.module).trust.interrupt();
    if (!m_doubt) {
        m_doubt = Doubt{*ask.module};
        m_doubt->bySilence = end.bytes.empty();
    }
    return {};
}

void Recovery::distrust() {
    m_state = LineState::Suspect;
    for (Chain::Module& module : m_chain.modules())
        module.trust.interrupt();
    m_doubt = Doubt{m_chain.modules().front().belief.info().index};
}

bool Recovery::onChange(const Change& change) {
    if (change.kind == Change::Kind::Interrupted) {
        if (suspect())  // a doubt that is not settled stays
            m_state = LineState::Suspect;
    } else if (change.kind == Change::Kind::GivenUp) {
        m_doubt.reset();
        m_state = LineState::Suspect;
        m_givenUp = true;
    }
    return false;
}

std::optional<Line::Script> Recovery::flush() {
    if (m_state != LineState::Suspect)
        return std::nullopt;
    flushed();
    return Line::Script{Line::Nulls{}, Line::Pause{kAfterNulls}, DiscardInput{}};
}

std::vector<Recovery::GivenUp> Recovery::note(ModuleIndex index, bool right) {
    Chain::Module& module = m_chain.at(index);
    std::vector<GivenUp> givenUp;
    for (Health* health : {&module.health, &m_health}) {
        const LinkHealth before = health->level();
        right ? health->good() : health->wrong();
        if (health->level() == before)
            continue;
        const auto concerned = health == &module.health ? std::optional(index) : std::nullopt;
        m_events.emplace_back(
            HealthChanged{health->level(), health->wrongLately(), health->exchanges(), concerned});
        if (health->level() == LinkHealth::Lost)
            givenUp.push_back({concerned});
    }
    return givenUp;
}

void Recovery::dropDoubt(ModuleIndex module) {
    if (m_doubt && m_doubt->module == module)
        m_doubt.reset();
}

void Recovery::lose(ModuleIndex module, TimePoint now) {
    setUnresponsive(module, now);
    if (m_chain.schedule().allUnresponsive())
        loseAll(now);
}

void Recovery::setUnresponsive(ModuleIndex module, TimePoint now) {
    if (!m_chain.answers(module))
        return;
    m_chain.schedule().lose(module, now);
    m_events.emplace_back(ModuleUnresponsive{module, true});
}

bool Recovery::wants(TimePoint /*now*/) const {
    return resyncDue() || m_doubt;
}

Next Recovery::next(TimePoint /*now*/) {
    if (resyncDue())
        return resync();
    return challenge();
}

/// Steps 2 and 3 of link.md 2.2. The module in doubt is challenged afterwards.
Line::Script Recovery::resync() {
    m_state = LineState::Resyncing;
    ++m_statistics.resyncs;
    return {Line::Pause{m_quarantine}, DiscardInput{}, Line::Nulls{}, Line::Lag{kAfterNulls}, DiscardInput{}};
}

/// Steps 4 and 5 of link.md 2.2: two queries whose replies differ in length and both contain the identity.
Ask Recovery::challenge() {
    Doubt& doubt = *m_doubt;
    doubt.witness = std::exchange(doubt.witnessDue, false);
    ModuleIndex asked = doubt.module;
    if (doubt.witness) {
        const auto other = witness();
        doubt.witness = other.has_value();
        asked = other.value_or(doubt.module);
    }
    const ModuleIdentity identity = m_chain.belief(asked).info().identity;
    const bool full = doubt.passed > 0 && isKnown(identity) && !doubt.witness;
    Ask ask = m_chain.status(Purpose::Challenge, asked, full ? fullItems(identity) : kIdentityItems);
    ask.silentRepeats = 0;
    ask.handlesFailure = true;
    ask.believed = !doubt.witness;
    return ask;
}

/// A module that should answer if the bus works at all.
std::optional<ModuleIndex> Recovery::witness() const {
    for (const Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (m_chain.answers(index) && !m_silence.asked(index))
            return index;
    }
    return std::nullopt;
}

Line::Script Recovery::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    if (!m_doubt)
        return {};
    Doubt& doubt = *m_doubt;
    if (end.result == ReplyResult::Accepted) {
        if (doubt.witness)
            return {};
        const bool known = isKnown(m_chain.belief(doubt.module).info().identity);
        if (++doubt.passed == (known ? kPasses : 1))
            passed(doubt.module, now);
        return {};
    }
    m_state = LineState::Suspect;
    m_chain.at(*ask.module).trust.interrupt();
    const bool silent = end.result == ReplyResult::Unresponsive;
    if (silent)
        m_silence.onSilence(*ask.module);
    if (m_silence.dead(m_chain.schedule().answering())) {
        loseAll(now);
        return {};
    }
    const bool likelyDead = silent && m_silence.likelyDead();
    m_quarantine = likelyDead ? m_line.timing().adapter() : LineTiming::quarantine(m_line.lastTimeout());
    doubt.witnessDue = likelyDead;
    if (doubt.witness)
        return {};
    doubt.passed = 0;
    doubt.witnessDue = silent;
    doubt.silences += silent ? 1U : 0U;
    if (++doubt.failures == kFailures || doubt.silences == kSilentFailures || doubt.wasUnresponsive)
        failed(doubt.module, now);
    return {};
}

/// The module is unchanged, and the answers are its own.
void Recovery::passed(ModuleIndex module, TimePoint now) {
    // It is now known that an answer was lost, and not the module.
    const bool gotLost = m_doubt->bySilence;
    m_doubt.reset();
    if (gotLost)
        m_findings.givenUp = note(module, false);
    // Its replies may have another length by now, so the items are defined again before the next No
    // Operation.
    Belief& belief = m_chain.at(module).belief;
    if (isKnown(belief.info().identity))
        belief.forgetItems();
    m_chain.hurryOwedStop(module, now);
    if (m_chain.answers(module))
        return;
    m_chain.schedule().recover(module, now);
    m_lost = false;
    m_events.emplace_back(ModuleUnresponsive{module, false});
}

/// The module does not answer: it is polled rarely from now on, and the others continue.
void Recovery::failed(ModuleIndex module, TimePoint now) {
    m_doubt.reset();
    m_findings.lost = module;
    m_lostAnswering = m_chain.answers(module);
    if (!m_lostAnswering)
        return m_chain.schedule().onTimeout(module, now);
    lose(module, now);
}

/// No module answers: the line is dead, at least from the modules to the host.
void Recovery::loseAll(TimePoint now) {
    m_doubt.reset();
    if (m_state == LineState::Suspect)
        m_state = LineState::Trusted;  // no reply is expected, so there is nothing to wait for
    for (const Chain::Module& module : m_chain.modules())
        if (!module.belief.restarted())
            setUnresponsive(module.belief.info().index, now);
    if (std::exchange(m_lost, true))
        return;
    m_findings.allLost = true;
    if (!m_givenUp)
        m_events.emplace_back(LinkLost{});
}

}  // namespace nmc::bus

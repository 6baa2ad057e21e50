// SPDX-License-Identifier: MIT
#include "bus/restartsearch.h"

#include <utility>

namespace nmc::bus {

namespace {

/// Number of probes of silent modules between two queries for one that has restarted.
constexpr unsigned kLookEvery = 4;
/// The module may be in the middle of what it took for a packet in the others' bytes, and take the first
/// query for the rest of that; and an answer may be lost.
constexpr unsigned kAsks = 3;
/// A late answer of another module fits at most one of two queries whose replies differ in length.
constexpr unsigned kAnswers = 2;

}  // namespace

void RestartSearch::onLost() {
    if (m_recovery.lostAnswering() || m_chain.rate() == kPowerUpBaud)
        begin();
}

bool RestartSearch::onChange(const Change& change) {
    if (change.kind == Change::Kind::Search || change.kind == Change::Kind::GivenUp)
        m_stage = Stage::None;
    else if (change.kind == Change::Kind::Interrupted && m_stage == Stage::Back)
        begin();  // the answer was dropped with the query, and the module may not be lost again
    return false;
}

void RestartSearch::onProbeFailed() {
    const bool turn = ++m_probes % kLookEvery == 0;
    if (turn && m_chain.rate() == kPowerUpBaud && !m_chain.schedule().allUnresponsive())
        begin();
}

Next RestartSearch::next(TimePoint /*now*/) {
    switch (m_stage) {
        case Stage::None:
            return Idle{};
        case Stage::Ask: {
            if (m_line.baud() != kPowerUpBaud)
                return Line::toRate(kPowerUpBaud);
            m_stage = Stage::Back;
            // The answer to an earlier search says nothing of this one, whose query a stop may drop.
            if (m_answers == 0)
                m_unaddressed.reset();
            const ModuleIdentity identity = m_unaddressed.value_or(ModuleIdentity{});
            const StatusItems items = m_unaddressed ? fullItems(identity) : kIdentityItems;
            bus::Ask ask;
            ask.purpose = Purpose::Challenge;
            ask.request = {BusAddress(0), encode(ReadStatus{items}), {identity, items}};
            ask.handlesFailure = true;
            ask.believed = false;
            return ask;
        }
        case Stage::Back:
            m_stage = m_unaddressed ? Stage::Others : Stage::None;
            if (m_line.baud() != m_chain.rate())
                return Line::toRate(m_chain.rate());
            return Again{};
        case Stage::Others:
            break;
    }
    if (m_others.empty()) {
        m_stage = Stage::None;
        name();
        return Again{};
    }
    bus::Ask ask = m_chain.status(Purpose::Challenge, m_others.back(), kIdentityItems);
    ask.handlesFailure = true;
    ask.believed = false;
    return ask;
}

Line::Script RestartSearch::onEnd(const bus::Ask& ask, const ReplyEnd& end, TimePoint now) {
    if (!ask.module) {
        const bool again = unanswered(end.result) ? ++m_asks < kAsks : ++m_answers < kAnswers;
        if (!unanswered(end.result)) {
            m_unaddressed = end.report.identity;
            m_asks = 0;
        }
        if (again)
            m_stage = Stage::Ask;
        else
            onUnaddressed(end);
    } else if (!m_others.empty()) {
        const bool again = !unanswered(end.result) || m_again;
        if (unanswered(end.result) && m_again)
            m_recovery.lose(*ask.module, now);
        m_again = !again;
        if (again)
            m_others.pop_back();
    }
    if (unanswered(end.result))
        return {Line::Lag{}, DiscardInput{}};
    return {};
}

void RestartSearch::onUnaddressed(const ReplyEnd& end) {
    m_asks = 0;
    if (end.result == ReplyResult::Unresponsive)
        m_chain.schedule().noteSought();
    if (unanswered(end.result) || m_chain.anyRestarted())
        return m_unaddressed.reset();
    m_others.clear();
    m_again = false;
    for (const Chain::Module& module : m_chain.modules())
        if (m_chain.answers(module.belief.info().index))
            m_others.push_back(module.belief.info().index);
}

void RestartSearch::name() {
    const ModuleIdentity identity = *std::exchange(m_unaddressed, std::nullopt);
    std::vector<ModuleIndex> silent;
    for (const Chain::Module& module : m_chain.modules())
        if (!m_chain.answers(module.belief.info().index))
            silent.push_back(module.belief.info().index);
    const auto restarted = m_chain.restartedOf(silent);
    if (!restarted || m_chain.belief(*restarted).info().identity != identity)
        return;
    m_quiet = m_chain.rate() != kPowerUpBaud;
    report(*restarted, m_quiet);
}

void RestartSearch::setRestarted(ModuleIndex module, TimePoint now) {
    m_chain.schedule().lose(module, now);
    report(module, false);
}

void RestartSearch::report(ModuleIndex index, bool quiet) {
    Chain::Module& module = m_chain.at(index);
    module.belief.setRestarted();
    module.owed.reset();  // its motor is off
    m_chain.schedule().retire(index);
    m_events.emplace_back(ModuleRestarted{index, quiet});
    m_events.emplace_back(GroupChanged{index, module.belief.info().group});
}

}  // namespace nmc::bus

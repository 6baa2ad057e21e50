// SPDX-License-Identifier: MIT
#include "bus/stoptask.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

void StopTask::begin(TimePoint now) {
    if (!active())
        m_pressed = now;
    m_waiting = false;
    m_unasked = false;
    if (m_run)
        m_run->restart(m_chain);
    else
        m_run.emplace(m_chain, now);
    m_asked = nullptr;
    // A single packet to all modules is faster than one to each, even on a free line.
    m_blindDue =
        m_recovery.suspect() || m_line.busy() || m_chain.size() > 1 || m_line.baud() != m_chain.rate();
}

void StopTask::beginAfterSearch(TimePoint now) {
    if (!active())
        m_pressed = now;
    m_unasked = false;
    m_waiting = true;
}

void StopTask::onSearchOver(TimePoint now) {
    if (!std::exchange(m_waiting, false))
        return;
    m_run.emplace(m_chain, now);
    m_asked = nullptr;
    m_blindDue = false;
}

bool StopTask::allSent() const {
    return m_run && !m_blindDue && m_run->allSent();
}

std::vector<Order> StopTask::blindStops() const {
    return m_run ? m_run->blindStops(m_chain) : std::vector<Order>{};
}

void StopTask::onBlindSent() {
    m_blind = blindStops();
    m_blindDue = m_blindHeard = false;
}

Next StopTask::next(TimePoint now) {
    if (std::exchange(m_blindDue, false))
        return blindScript();
    if (m_line.baud() != m_chain.rate())
        return Line::toRate(m_chain.rate());
    noteBlindStops();
    if (auto nulls = m_recovery.flush())
        return std::move(*nulls);
    m_asked = m_run->next(now);
    if (m_asked == nullptr) {
        finish(now);
        return Again{};
    }
    return m_chain.next(*m_asked);
}

/// Sends stops without waiting for answers: a reply may still be arriving, and could be taken for the answer
/// to the stop.
Line::Script StopTask::blindScript() {
    Line::Script script{Line::Gap{}};
    const bool strayed = m_line.baud() != m_chain.rate();
    if (strayed)
        script.emplace_back(SetHostBaud{m_chain.rate()});
    m_blindHeard = !m_recovery.suspect() && !strayed;
    if (!m_blindHeard) {
        m_recovery.flushed();
        script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
    }
    m_blind = m_run->blindStops(m_chain);
    const Line::Script packets = m_chain.stopScript(m_blind);
    script.insert(script.end(), packets.begin(), packets.end());
    const Duration underWay =
        byteTimeAtBaud(m_chain.rate()) * static_cast<Duration::rep>(m_chain.longestReply());
    script.insert(script.end(), {Line::Lag{underWay}, DiscardInput{}});
    return script;
}

/// The blind stops have been sent: their possible effect is believed from now on.
void StopTask::noteBlindStops() {
    const std::vector<Order> orders = std::exchange(m_blind, {});
    const std::vector<TimePoint>& latches = m_line.scriptLatches();
    for (std::size_t i = 0; i < orders.size() && !latches.empty(); ++i) {
        const TimePoint latched = latches[std::min(i, latches.size() - 1)];
        m_chain.noteSent(orders[i].module, orders[i].command, latched);
        m_chain.noteUnanswered(orders[i].module, latched);
        if (StopTarget* target = m_run->find(orders[i].module))
            target->onBlindSent(m_blindHeard ? std::optional(StopTarget::Blind{orders[i].command, latched})
                                             : std::nullopt);
    }
}

/// Handles the first answer after a blind stop, before its content is published: otherwise the calculated
/// command position would continue until the stop is acknowledged, and be some 20 ms of travel off.
void StopTask::onAnswer(const Ask& /*ask*/, const ReplyEnd& /*end*/) {
    if (m_asked == nullptr)
        return;
    if (auto executed = m_chain.takeBlindStop(*m_asked))
        m_events.emplace_back(std::move(*executed));
}

Line::Script StopTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    if (m_asked != nullptr)
        m_run->onReply(*m_asked, end, m_chain.belief(*ask.module), now);
    return {};
}

void StopTask::finish(TimePoint now) {
    StopFinished event = std::exchange(m_run, std::nullopt)->finished();
    event.took = now - m_pressed;
    event.unasked = std::exchange(m_unasked, false);
    m_asked = nullptr;
    for (const ModuleIndex module : event.stopped)
        if (const auto owed = std::exchange(m_chain.at(module).owed, std::nullopt))
            m_events.emplace_back(OwedStopConfirmed{module, owed->cause});
    for (const auto* open : {&event.unreached, &event.unconfirmed})
        for (const ModuleIndex module : *open)
            m_chain.owe(module, StopCause::StopAll);
    for (const ModuleIndex module : event.unreached)
        m_recovery.lose(module, now);
    m_events.emplace_back(std::move(event));
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "bus/owedstops.h"

#include <algorithm>
#include <utility>

#include "bus/commandlane.h"

namespace nmc::bus {

namespace {

/// For a module that answers, stops are repeated at once this often; after that, the line needs its way back.
constexpr unsigned kAtOnce = 3;
constexpr Duration kAfterSilence = std::chrono::milliseconds(100);
/// Time between two queries of a motor that is decelerating; kBetweenLateLooks applies later, to one that
/// does not stop.
constexpr Duration kBetweenLooks = std::chrono::milliseconds(20);
constexpr Duration kBetweenLateLooks = std::chrono::milliseconds(250);
constexpr unsigned kEarlyLooks = 100;
/// Commands may get through even if no answer does (faults.md F-11, F-19).
constexpr Duration kBlindEvery = std::chrono::milliseconds(500);

}  // namespace

bool OwedStops::anyUnsent() const {
    return std::any_of(m_chain.modules().begin(), m_chain.modules().end(), [&](const Chain::Module& module) {
        return module.owed && module.owed->target.needsStop() && !blindly(module.belief.info().index);
    });
}

std::optional<TimePoint> OwedStops::due() const {
    std::optional<TimePoint> first;
    for (const Chain::Module& module : m_chain.modules())
        if (module.owed && (!first || module.owed->due < *first))
            first = module.owed->due;
    return first;
}

bool OwedStops::wants(TimePoint now) const {
    const auto first = due();
    return first && *first <= now;
}

bool OwedStops::blindly(ModuleIndex module) const {
    // A module that was given up because of errors is still queried: only this can confirm its stop.
    const bool silent = !m_chain.answers(module) && !m_chain.schedule().retired(module);
    return m_blind || m_line.baud() != m_chain.rate() || silent;
}

Next OwedStops::next(TimePoint now) {
    if (Line::Script script = groupScript(now); !script.empty())
        return script;
    Chain::Module* asked = nullptr;
    for (Chain::Module& module : m_chain.modules()) {
        if (!module.owed || module.owed->due > now)
            continue;
        if (blindly(module.belief.info().index))
            return blindScript(now);
        if (asked == nullptr || module.owed->due < asked->owed->due)
            asked = &module;
    }
    if (asked == nullptr)
        return Idle{};
    if (auto nulls = m_recovery.flush())
        return std::move(*nulls);
    Ask ask = m_chain.next(asked->owed->target);
    ask.retry = asked->owed->target.silences() > 0;
    ask.handlesFailure = !m_chain.answers(asked->owed->target.module());
    return ask;
}

/// The leader's answer is dropped: each member answers for itself.
Line::Script OwedStops::groupScript(TimePoint now) {
    std::vector<Order> stops;
    for (const ModuleIndex module : std::exchange(m_together, {})) {
        const auto& owed = m_chain.at(module).owed;
        if (const auto stop = owed ? owed->target.stop(m_chain.belief(module)) : std::nullopt)
            stops.push_back({module, *stop});
    }
    const bool here = !m_blind && m_line.baud() == m_chain.rate() && !m_recovery.suspect();
    const auto group = m_chain.groupOf(stops);
    if (!here || !group)
        return {};
    for (const Order& stop : stops) {
        const PacketBytes packet = toPacket({*group, payloadOf(stop.command)});
        const TimePoint latched = m_line.latchTime(packet.size(), now);
        m_chain.noteSent(stop.module, stop.command, latched);
        m_chain.at(stop.module).owed->target.onBlindSent(StopTarget::Blind{stop.command, latched});
    }
    Line::Script script{Line::Gap{}};
    const Line::Script packets = m_chain.stopScript(stops);
    script.insert(script.end(), packets.begin(), packets.end());
    script.insert(script.end(), {Line::Lag{}, DiscardInput{}});
    return script;
}

/// Sends all stops that are due, together, at the chain's rate; the port then returns to its previous rate.
Next OwedStops::blindScript(TimePoint now) {
    std::vector<Order> stops;
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (!module.owed || !blindly(index) || module.owed->due > now)
            continue;
        module.owed->due = now + kBlindEvery;
        if (const auto stop = module.owed->target.stop(module.belief))
            stops.push_back({index, *stop});
    }
    if (stops.empty())
        return Again{};
    for (const Order& stop : stops)  // nothing is answered before the script ends
        m_chain.noteSent(stop.module, stop.command, m_line.latchTime(0, now));
    const std::uint32_t here = m_line.baud();
    Line::Script script{Line::Gap{}};
    if (here != m_chain.rate())
        script.emplace_back(SetHostBaud{m_chain.rate()});
    script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
    const Line::Script packets = m_chain.stopScript(stops);
    script.insert(script.end(), packets.begin(), packets.end());
    script.insert(script.end(), {Line::Lag{}, DiscardInput{}});
    if (here != m_chain.rate()) {
        const Line::Script back = Line::toRate(here);
        script.insert(script.end(), back.begin(), back.end());
    }
    return script;
}

/// Handles the first answer after a stop that was sent to the whole group.
void OwedStops::onAnswer(const Ask& ask, const ReplyEnd& /*end*/) {
    auto& owed = m_chain.at(*ask.module).owed;
    if (auto executed = owed ? m_chain.takeBlindStop(owed->target) : std::nullopt)
        m_events.emplace_back(std::move(*executed));
}

Line::Script OwedStops::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    auto& owed = m_chain.at(*ask.module).owed;
    if (!owed)
        return {};  // superseded while its query was in progress
    owed->target.onReply(end, m_chain.belief(*ask.module), now);
    if (owed->target.stopped()) {
        m_events.emplace_back(OwedStopConfirmed{*ask.module, owed->cause});
        owed.reset();
        return {};
    }
    const bool looked = !ask.reported && end.result == ReplyResult::Accepted;
    const bool moves = looked && !owed->target.needsStop() && !owed->target.almostStopped();
    owed->looks += moves ? 1U : 0U;
    owed->due = ask.handlesFailure && unanswered(end.result) ? now + kBlindEvery
                : owed->target.silences() > kAtOnce          ? now + kAfterSilence
                : moves ? now + (owed->looks < kEarlyLooks ? kBetweenLooks : kBetweenLateLooks)
                        : now;
    if (ask.handlesFailure && unanswered(end.result))
        return {Line::Lag{}, DiscardInput{}};
    return {};
}

}  // namespace nmc::bus

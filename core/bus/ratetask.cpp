// SPDX-License-Identifier: MIT
#include "bus/ratetask.h"

#include <algorithm>
#include <utility>

#include "protocol/baud.h"

namespace nmc::bus {

void RateTask::begin(std::uint32_t baud, bool busy) {
    RateChangeFailed failed{};
    failed.wanted = baud;
    failed.baud = m_chain.rate();
    auto reason = obstacle(baud, failed.modules);
    if (busy && reason != RateChangeFailed::Reason::NoSuchRate) {
        reason = RateChangeFailed::Reason::NotNow;
        failed.modules.clear();
    }
    if (reason) {
        failed.reason = *reason;
        m_events.emplace_back(std::move(failed));
        return;
    }
    std::vector<RateChange::Target> chain;
    std::vector<BusAddress> groups;
    for (const Chain::Module& module : m_chain.modules()) {
        chain.push_back({module.belief.info().address, m_chain.layoutOf(module.belief, encode(Nop{}))});
        groups.emplace_back(module.belief.info().group->group);
    }
    // FF comes last, and is always included: a module without an address is in it.
    groups.push_back(kEverybody);
    std::ranges::sort(groups);
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    m_change.emplace(std::move(chain), std::move(groups), m_chain.rate(), baud, RateChange::WayBack::Wanted);
}

/// Why the rate cannot be changed now, and which modules prevent it.
std::optional<RateChangeFailed::Reason> RateTask::obstacle(std::uint32_t baud,
                                                           std::vector<ModuleIndex>& modules) const {
    using enum RateChangeFailed::Reason;
    if (!findBrd(baud))
        return NoSuchRate;
    if (m_chain.empty())
        return NotNow;
    const auto collect = [&](auto unfit) {
        for (const Chain::Module& module : m_chain.modules())
            if (unfit(module.belief))
                modules.push_back(module.belief.info().index);
        return !modules.empty();
    };
    if (collect([&](const Belief& b) { return b.restarted() || !m_chain.answers(b.info().index); }))
        return Missing;
    if (collect([](const Belief& b) { return b.moving(); }))
        return NotNow;
    if (collect([](const Belief& b) { return !b.info().group; }))
        return GroupsUnknown;
    if (collect([](const Belief& b) { return b.info().group->leader; }))
        return Leader;
    return std::nullopt;
}

bool RateTask::onChange(const Change& change) {
    using enum Change::Kind;
    const bool stopsSome = change.kind == Stopped && !change.modules.empty();
    // Something goes before it: everybody is taken back to the old rate (WayBack).
    if (m_change && (change.kind == StopAll || change.kind == Interrupted || stopsSome))
        m_abandoned = std::exchange(m_change, std::nullopt);
    if (change.kind == Search || change.kind == GivenUp)
        for (auto* ended : {&m_change, &m_abandoned})
            if (const auto dropped = std::exchange(*ended, std::nullopt))
                m_events.emplace_back(RateChangeFailed{
                    RateChangeFailed::Reason::Interrupted, dropped->to(), dropped->from(), {}, {}});
    return stopsSome;
}

Next RateTask::next(TimePoint /*now*/) {
    auto next = m_change->next();
    if (auto* script = std::get_if<Line::Script>(&next))
        return std::move(*script);
    if (auto* ask = std::get_if<Ask>(&next)) {
        ask->quarantine = Quarantine::Brief;  // the reply to a No Operation changes nothing
        return std::move(*ask);
    }
    finish(std::get<RateChange::Ended>(next));
    return Again{};
}

Line::Script RateTask::onEnd(const Ask& /*ask*/, const ReplyEnd& end, TimePoint /*now*/) {
    if (m_change)
        m_change->onReply(end);
    return {};
}

void RateTask::finish(const RateChange::Ended& ended) {
    const RateChange change = *std::exchange(m_change, std::nullopt);
    if (ended.reached) {
        m_chain.setRate(change.to());
        m_config.baud = change.to();
        m_events.emplace_back(RateChanged{change.to()});
        return;
    }
    const auto reason =
        ended.interrupted ? RateChangeFailed::Reason::Interrupted : RateChangeFailed::Reason::NotHeard;
    RateChangeFailed failed{reason, change.to(), change.from(), {}, {}};
    for (const std::size_t i : ended.deaf)
        failed.modules.push_back(m_chain.modules()[i].belief.info().index);
    for (const std::size_t i : ended.lost)
        failed.lost.push_back(m_chain.modules()[i].belief.info().index);
    m_events.emplace_back(std::move(failed));
}

Next WayBack::next(TimePoint /*now*/) {
    std::optional<RateChange>& change = m_rate.m_abandoned;
    if (std::exchange(m_underWay, true)) {
        m_underWay = false;
        change->interrupt();
        m_rate.m_change = std::exchange(change, std::nullopt);
        return Again{};
    }
    const std::uint32_t here = m_line.baud();
    const std::uint32_t there = here == change->from() ? change->to() : change->from();
    Line::Script script{Line::Gap{}};
    const auto add = [&](const Line::Script& more) { script.insert(script.end(), more.begin(), more.end()); };
    const std::vector<Order> stops = m_stops.blindStops();
    if (m_stops.stopping() || !stops.empty())
        m_stops.onBlindSent();
    if (!stops.empty()) {
        script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
        add(m_chain.stopScript(stops));
        // Like Line::toRate(), but without waiting for replies that are not read.
        add({Line::Lag{}, SetHostBaud{there}, Line::Nulls{}, Line::Pause{kAfterNulls}});
        add(m_chain.stopScript(stops));
    }
    add(change->goBack());
    m_recovery.flushed();  // the nulls are part of the script
    return script;
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"

namespace nmc::bus {

void Engine::Private::changeRate(std::uint32_t baud, TimePoint now) {
    RateChangeFailed failed{};
    failed.wanted = baud;
    failed.baud = m_baud;
    if (const auto reason = rateObstacle(baud, failed.modules)) {
        failed.reason = *reason;
        events.emplace_back(std::move(failed));
        return;
    }
    std::vector<RateChange::Target> chain;
    std::vector<BusAddress> groups;
    for (const Module& module : m_modules) {
        chain.push_back({module.belief.info().address, layoutOf(module.belief, Nop{}.encode())});
        groups.emplace_back(module.belief.info().group->group);
    }
    // FF comes last, and always: a module that has no address is in it.
    groups.push_back(kEverybody);
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    m_rateChange.emplace(std::move(chain), std::move(groups), m_baud, baud, RateChange::WayBack::Wanted);
    proceed(now);
}

/// Why the rate cannot be changed now, and because of whom.
std::optional<RateChangeFailed::Reason> Engine::Private::rateObstacle(
    std::uint32_t baud, std::vector<ModuleIndex>& modules) const {
    using enum RateChangeFailed::Reason;
    if (!findBaud(baud))
        return NoSuchRate;
    const bool busy = m_stop || m_rateChange || m_abandoned || !m_commands.empty() || !m_guards.empty() ||
                      m_hold.wanted() || m_hold.stop();
    if (m_phase != Phase::Running || m_modules.empty() || busy)
        return NotNow;
    const auto collect = [&](auto unfit) {
        for (const Module& module : m_modules)
            if (unfit(module.belief))
                modules.push_back(module.belief.info().index);
        return !modules.empty();
    };
    if (collect([&](const Belief& b) { return b.restarted() || m_schedule.silent(b.info().index); }))
        return Missing;
    if (collect([](const Belief& b) { return b.moving(); }))
        return NotNow;
    if (collect([](const Belief& b) { return !b.info().group; }))
        return GroupsUnknown;
    if (collect([](const Belief& b) { return b.info().group->leader; }))
        return Leader;
    return std::nullopt;
}

void Engine::Private::dispatchRateChange(TimePoint now) {
    auto next = m_rateChange->next();
    if (auto* script = std::get_if<Line::Script>(&next))
        return line.run(std::move(*script), now);
    if (const auto* ask = std::get_if<RateChange::Ask>(&next)) {
        Work work;
        work.lane = Lane::Rate;
        work.request = ask->request;
        work.silentRepeats = ask->silentRepeats;
        work.quarantine = Discovery::Quarantine::Brief;  // the answer to a No Operation changes nothing
        return begin(std::move(work), now);
    }
    finishRateChange(std::get<RateChange::Ended>(next));
}

void Engine::Private::finishRateChange(const RateChange::Ended& ended) {
    const RateChange change = *std::exchange(m_rateChange, std::nullopt);
    if (ended.reached) {
        m_baud = config.baud = change.to();
        events.emplace_back(RateChanged{m_baud});
        return;
    }
    const auto reason =
        ended.interrupted ? RateChangeFailed::Reason::Interrupted : RateChangeFailed::Reason::NotHeard;
    RateChangeFailed failed{reason, change.to(), change.from(), {}, {}};
    for (const std::size_t i : ended.deaf)
        failed.modules.push_back(m_modules[i].belief.info().index);
    for (const std::size_t i : ended.lost)
        failed.lost.push_back(m_modules[i].belief.info().index);
    events.emplace_back(std::move(failed));
}

void Engine::Private::abandonRateChange() {
    if (!m_rateChange)
        return;
    m_abandoned = std::exchange(m_rateChange, std::nullopt);
    m_again.reset();
}

/// A stop in the midst of it: each module is at one of the two rates, and nobody knows at which. So it is
/// told at both, and then everybody goes back to the old one, where the stop is confirmed as usual. False
/// when that is done.
bool Engine::Private::dispatchWayBack(TimePoint now) {
    if (!m_abandoned)
        return false;
    if (std::exchange(m_goingBack, true)) {
        m_goingBack = false;
        m_abandoned->interrupt();
        m_rateChange = std::exchange(m_abandoned, std::nullopt);
        return false;
    }
    const std::uint32_t here = line.baud();
    const std::uint32_t there = here == m_abandoned->from() ? m_abandoned->to() : m_abandoned->from();
    Line::Script script{Line::Gap{}};
    const auto add = [&](const Line::Script& more) { script.insert(script.end(), more.begin(), more.end()); };
    if (m_stop) {
        m_blindStops = m_stop->blindStops();
        m_blindStopsDue = m_blindStopsHeard = false;
        script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
        add(stopScript(m_blindStops));
        add(Line::toRate(there));
        add(stopScript(m_blindStops));
    }
    add(m_abandoned->goBack());
    m_suspect = false;
    m_hurried = true;  // the nulls are part of it, the quarantine is still owed
    line.run(std::move(script), now);
    return true;
}

}  // namespace nmc::bus

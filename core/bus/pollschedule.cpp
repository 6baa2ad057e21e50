// SPDX-License-Identifier: MIT
#include "bus/pollschedule.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

void PollSchedule::watch(const std::vector<ModuleIndex>& modules) {
    for (Module& module : m_modules)
        module.watched = false;
    for (const ModuleIndex index : modules)
        if (index.value() < m_modules.size())
            at(index).watched = true;
}

void PollSchedule::focus(ModuleIndex index, TimePoint now) {
    const TimePoint othersAsked = m_focus ? m_focus->othersAsked : now;
    m_focus.reset();
    if (index.value() < m_modules.size() && !silent(index))
        m_focus = Focus{index.value(), now + kFocus, othersAsked};
}

PollSchedule::Turn PollSchedule::take(std::size_t index, TimePoint now) {
    Module& module = m_modules[index];
    module.asked = now;
    module.order = ++m_turns;
    module.full = !module.full;
    return Turn{ModuleIndex(static_cast<std::uint8_t>(index)), module.full};
}

std::optional<PollSchedule::Turn> PollSchedule::next(TimePoint now) {
    if (m_focus && (now >= m_focus->until || m_modules[m_focus->module].silent))
        m_focus.reset();
    if (m_focus)
        return nextInFocus(now);
    const auto turn = [&](std::size_t index) { return take(index, now); };
    if (const auto probe = silentTurn(now)) {
        m_lastProbe = now;
        // The next reply is a full one, whose layout does not depend on the module's memory.
        m_modules[*probe].full = false;
        return turn(*probe);
    }
    const auto rest = longestAgo([](const Module& m) { return !m.silent && !m.watched; });
    const auto watched = longestAgo([](const Module& m) { return !m.silent && m.watched; });
    if (!rest || !watched)
        return rest ? std::optional(turn(*rest)) : watched ? std::optional(turn(*watched)) : std::nullopt;
    // If the line cannot carry five polls per second for each of them, watched modules still get every other
    // turn.
    const auto& asked = m_modules[*rest].asked;
    const bool due = !asked || now - *asked >= kBackground;
    const bool theirTurn = due && !m_backgroundLast;
    m_backgroundLast = theirTurn;
    return turn(theirTurn ? *rest : *watched);
}

/// Polls one of the others now and then, evenly spaced: all of them at once would be a gap in the focused
/// module's data.
PollSchedule::Turn PollSchedule::nextInFocus(TimePoint now) {
    const std::size_t focused = m_focus->module;
    const auto others = static_cast<Duration::rep>(answering()) - 1;
    const bool due = others > 0 && now - m_focus->othersAsked >= kInSight / others;
    m_backgroundLast = due && !m_backgroundLast;
    if (m_backgroundLast) {
        m_focus->othersAsked = now;
        const Module* const module = &m_modules[focused];
        return take(*longestAgo([module](const Module& m) { return !m.silent && &m != module; }), now);
    }
    Turn turn = take(focused, now);
    turn.brief = std::exchange(turn.full, false);
    return turn;
}

std::optional<std::size_t> PollSchedule::silentTurn(TimePoint now) const {
    return longestAgo([&](const Module& m) { return m.silent && !m.retired && now >= dueTime(m); });
}

/// The module that has waited longest.
template <typename Wanted>
std::optional<std::size_t> PollSchedule::longestAgo(Wanted wanted) const {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < m_modules.size(); ++i)
        if (wanted(m_modules[i]) && (!first || m_modules[i].order < m_modules[*first].order))
            first = i;
    return first;
}

std::optional<TimePoint> PollSchedule::nextDue() const {
    std::optional<TimePoint> first;
    for (const Module& module : m_modules) {
        if (module.retired)
            continue;
        first = earliest({first, module.silent ? dueTime(module) : TimePoint::min()});
    }
    return first;
}

void PollSchedule::lose(ModuleIndex index, TimePoint now) {
    Module& module = at(index);
    module.silent = true;
    module.interval = kFirstProbe;
    module.due = now + kFirstProbe;
}

void PollSchedule::onTimeout(ModuleIndex index, TimePoint now) {
    Module& module = at(index);
    module.interval =
        allUnresponsive() ? kFirstProbe : std::min<Duration>(2 * module.interval, kSlowestProbe);
    module.due = now + module.interval;
}

void PollSchedule::recover(ModuleIndex index, TimePoint now) {
    Module& module = at(index);
    module.silent = module.sought = module.retired = false;
    module.full = false;
    // Whatever restored this one, for example a cable, may have restored the others: they are probed without
    // waiting while that succeeds.
    m_lastProbe.reset();
    for (Module& other : m_modules)
        if (other.silent) {
            other.interval = kFirstProbe;
            other.due = now;
        }
}

std::size_t PollSchedule::answering() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(m_modules, [](const Module& m) { return !m.silent; }));
}

TimePoint PollSchedule::dueTime(const Module& module) const {
    if (!m_lastProbe)
        return module.due;
    const Duration spacing = allUnresponsive() ? kFirstProbe : kProbeSpacing;
    return std::max(module.due, *m_lastProbe + spacing);
}

}  // namespace nmc::bus

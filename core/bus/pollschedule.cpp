// SPDX-License-Identifier: MIT
#include "bus/pollschedule.h"

#include <algorithm>

namespace nmc::bus {

std::optional<PollSchedule::Turn> PollSchedule::next(TimePoint now) {
    for (std::size_t i = 0; i < m_modules.size(); ++i) {
        const std::size_t at = (m_next + i) % m_modules.size();
        Module& module = m_modules[at];
        if (module.silent && now < dueTime(module))
            continue;
        m_next = at + 1;
        const ModuleIndex index(static_cast<std::uint8_t>(at));
        if (!module.silent)
            return Turn{index, module.turns++ % kFullEvery == 0};
        // In full: that reply's layout does not hang on what the module remembers.
        m_lastProbe = now;
        return Turn{index, true};
    }
    return std::nullopt;
}

std::optional<TimePoint> PollSchedule::nextDue() const {
    std::optional<TimePoint> first;
    for (const Module& module : m_modules) {
        const TimePoint due = module.silent ? dueTime(module) : TimePoint::min();
        first = first ? std::min(*first, due) : due;
    }
    return first;
}

bool PollSchedule::onAnswer(ModuleIndex index, TimePoint now) {
    Module& module = m_modules[index.value()];
    module.timeouts = 0;
    if (!module.silent)
        return false;
    module.silent = false;
    module.turns = 0;  // a full status first: much may have happened
    // What woke this one, a cable say, may have woken the others: no waiting while that goes well.
    m_lastProbe.reset();
    for (Module& other : m_modules)
        if (other.silent) {
            other.interval = kFirstProbe;
            other.due = now;
        }
    return true;
}

bool PollSchedule::onTimeout(ModuleIndex index, TimePoint now) {
    Module& module = m_modules[index.value()];
    ++module.timeouts;
    if (module.silent) {
        module.interval = allSilent() ? kFirstProbe : std::min<Duration>(2 * module.interval, kSlowestProbe);
        module.due = now + module.interval;
        return false;
    }
    if (module.timeouts < kSilentAfter)
        return false;
    module.silent = true;
    module.interval = kFirstProbe;
    module.due = now + kFirstProbe;
    return true;
}

std::size_t PollSchedule::answering() const {
    return static_cast<std::size_t>(
        std::count_if(m_modules.begin(), m_modules.end(), [](const Module& m) { return !m.silent; }));
}

TimePoint PollSchedule::dueTime(const Module& module) const {
    if (!m_lastProbe)
        return module.due;
    const Duration spacing = allSilent() ? kFirstProbe : kProbeSpacing;
    return std::max(module.due, *m_lastProbe + spacing);
}

}  // namespace nmc::bus

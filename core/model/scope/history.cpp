// SPDX-License-Identifier: MIT
#include "model/scope/history.h"

namespace nmc {

// ---- one module ----

void ModuleHistory::append(const ScopeSample& sample) {
    if (!m_samples.empty() && sample.time < m_samples.back().time)
        return;
    m_samples.push_back(sample);
    ++m_count;
    sumUp(0, ScopeSpan::of(sample));
}

void ModuleHistory::sumUp(std::size_t level, ScopeSpan span) {
    if (level == m_levels.size())
        m_levels.emplace_back();
    Level& above = m_levels[level];
    if (above.filled == 0)
        above.open = span;
    else
        above.open.add(span);
    if (++above.filled < kFan)
        return;
    above.filled = 0;
    above.spans.push_back(above.open);
    sumUp(level + 1, above.open);
}

std::optional<TimePoint> ModuleHistory::begin() const {
    std::optional<TimePoint> first;
    for (std::size_t level = 0; level <= m_levels.size(); ++level)
        if (entries(level) > 0)
            first = first ? std::min(*first, oldest(level)) : oldest(level);
    return first;
}

std::optional<TimePoint> ModuleHistory::keptSince() const {
    if (m_samples.empty())
        return std::nullopt;
    return m_samples.front().time;
}

std::optional<ScopeSample> ModuleHistory::last() const {
    if (m_samples.empty())
        return std::nullopt;
    return m_samples.back();
}

namespace {
constexpr auto kIsBefore = [](const ScopeSample& sample, TimePoint time) { return sample.time < time; };
constexpr auto kAfter = [](TimePoint time, const auto& entry) {
    if constexpr (std::is_same_v<std::decay_t<decltype(entry)>, ScopeSample>)
        return time < entry.time;
    else
        return time < entry.first;
};
}  // namespace

std::size_t ModuleHistory::countBetween(TimePoint from, TimePoint to, ScopeSignal signal) const {
    const auto first = std::upper_bound(m_samples.begin(), m_samples.end(), from, kAfter);
    const auto end = std::upper_bound(first, m_samples.end(), to, kAfter);
    // Checking the last sample is enough: checking each one would take time in proportion to their number.
    if (first == end || !valueOf(*std::prev(end), signal))
        return 0;
    return static_cast<std::size_t>(end - first);
}

std::vector<ScopeSample> ModuleHistory::samples(TimePoint from, TimePoint to) const {
    const auto first = std::lower_bound(m_samples.begin(), m_samples.end(), from, kIsBefore);
    return {first, std::upper_bound(first, m_samples.end(), to, kAfter)};
}

ModuleHistory::Neighbours ModuleHistory::around(TimePoint time) const {
    Neighbours neighbours;
    const auto after = std::upper_bound(m_samples.begin(), m_samples.end(), time, kAfter);
    if (after != m_samples.end())
        neighbours.after = *after;
    if (after != m_samples.begin())
        neighbours.before = *std::prev(after);
    return neighbours;
}

std::optional<double> ModuleHistory::valueAt(TimePoint time, ScopeSignal signal) const {
    const auto [before, after] = around(time);
    if (!before)
        return std::nullopt;
    const auto first = valueOf(*before, signal);
    if (before->time == time)
        return first;
    if (!after || after->gapBefore)
        return std::nullopt;
    const auto second = valueOf(*after, signal);
    if (!first || !second)
        return std::nullopt;
    return *first +
           (*second - *first) * (toSeconds(time - before->time) / toSeconds(after->time - before->time));
}

std::size_t ModuleHistory::entries(std::size_t level) const {
    return level == 0 ? m_samples.size() : m_levels[level - 1].spans.size();
}

TimePoint ModuleHistory::oldest(std::size_t level) const {
    return level == 0 ? m_samples.front().time : m_levels[level - 1].spans.front().first;
}

/// The number of the first sample of the entry that reaches back to `time`, in the finest level that has one;
/// the oldest of all if none does.
std::uint64_t ModuleHistory::numberAt(TimePoint time) const {
    std::uint64_t first = m_firstSample;
    if (m_samples.empty() || oldest(0) <= time) {
        const auto after = std::upper_bound(m_samples.begin(), m_samples.end(), time, kAfter);
        const auto index = after - m_samples.begin();
        return m_firstSample + static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(index - 1, 0));
    }
    std::uint64_t size = 1;
    for (const Level& level : m_levels) {
        size *= kFan;
        if (level.spans.empty())
            break;
        first = std::min(first, level.firstIndex * size);
        if (level.spans.front().first > time)
            continue;
        const auto after = std::upper_bound(level.spans.begin(), level.spans.end(), time, kAfter);
        return (level.firstIndex + static_cast<std::uint64_t>(after - level.spans.begin()) - 1) * size;
    }
    return first;
}

/// The span of a level, from 1 on, that begins with this sample; null if there is none.
const ScopeSpan* ModuleHistory::spanFrom(std::size_t level, std::uint64_t number) const {
    const Level& spans = m_levels[level - 1];
    const std::uint64_t index = number >> (kFanBits * level);
    if (index << (kFanBits * level) != number || index < spans.firstIndex ||
        index - spans.firstIndex >= spans.spans.size())
        return nullptr;
    return &spans.spans[index - spans.firstIndex];
}

ModuleHistory::Entry ModuleHistory::entryAt(std::uint64_t number, Duration widest, std::size_t& level) const {
    const auto fits = [widest](TimePoint first, TimePoint last) { return last - first <= widest; };
    const ScopeSpan* span = nullptr;
    for (; level > 0; --level)
        if (span = spanFrom(level, number); span != nullptr && fits(span->first, span->last))
            break;
    if (level == 0)
        span = nullptr;
    // Where data have been coarsened, use the finest level left.
    while (span == nullptr && number < m_firstSample && level < m_levels.size())
        span = spanFrom(++level, number);
    while (level < m_levels.size()) {
        const ScopeSpan* wider = spanFrom(level + 1, number);
        if (wider == nullptr || !fits(wider->first, wider->last))
            break;
        span = wider;
        ++level;
    }
    if (span == nullptr)
        return {ScopeSpan::of(m_samples[number - m_firstSample]), 1};
    Entry entry{*span, std::uint64_t{1} << (kFanBits * level)};
    // Two adjacent spans are merged if both fit; like all levels, pairs are counted from the first sample on.
    if (number % (2 * entry.samples) == 0) {
        const ScopeSpan* twin = spanFrom(level, number + entry.samples);
        if (twin != nullptr && fits(span->first, twin->last)) {
            entry.span.add(*twin);
            entry.samples *= 2;
        }
    }
    return entry;
}

void ModuleHistory::coarsen(std::size_t level) {
    if (level == 0) {
        m_samples.erase(m_samples.begin(), m_samples.begin() + kBatch);
        m_firstSample += kBatch;
    } else {
        Level& spans = m_levels[level - 1];
        spans.spans.erase(spans.spans.begin(), spans.spans.begin() + kBatch);
        spans.firstIndex += kBatch;
    }
}

// ---- all modules ----

History::History(std::size_t modules, std::size_t budget) : m_modules(modules), m_budget(budget) {}

void History::append(ModuleIndex module, const ScopeSample& sample) {
    if (module.value() >= m_modules.size())
        return;
    if (!m_zero)
        m_zero = sample.time;
    ModuleHistory& history = m_modules[module.value()];
    history.append(sample);
    if (history.m_count % ModuleHistory::kBatch == 0)
        for (std::size_t level = 0; level <= history.m_levels.size(); ++level)
            trim(level);
}

void History::noteGains(const GainsChange& change) {
    m_gains.push_back(change);
}

const ModuleHistory* History::module(ModuleIndex index) const {
    return index.value() < m_modules.size() ? &m_modules[index.value()] : nullptr;
}

std::optional<TimePoint> History::begin() const {
    std::optional<TimePoint> first;
    for (const ModuleHistory& module : m_modules)
        if (const auto begin = module.begin())
            first = first ? std::min(*first, *begin) : *begin;
    return first;
}

std::optional<TimePoint> History::end() const {
    std::optional<TimePoint> latest;
    for (const ModuleHistory& module : m_modules)
        if (const auto last = module.last())
            latest = latest ? std::max(*latest, last->time) : last->time;
    return latest;
}

std::size_t History::bytes() const {
    std::size_t sum = 0;
    for (const ModuleHistory& module : m_modules)
        for (std::size_t level = 0; level <= module.m_levels.size(); ++level)
            sum += module.entries(level) * (level == 0 ? sizeof(ScopeSample) : sizeof(ScopeSpan));
    return sum;
}

History History::cut(TimePoint from, TimePoint to) const {
    History part(m_modules.size(), m_budget);
    for (std::size_t i = 0; i < m_modules.size(); ++i)
        for (const ScopeSample& sample : m_modules[i].samples(from, to))
            part.m_modules[i].append(sample);
    for (const GainsChange& change : m_gains) {
        if (change.time > to)
            break;
        if (change.time <= from)
            std::erase_if(part.m_gains,
                          [&](const GainsChange& before) { return before.module == change.module; });
        part.m_gains.push_back(change);
    }
    part.m_zero = m_zero;
    return part;
}

/// A level's share of the budget, in bytes: 3/8 for the samples, and for each further level half of what the
/// levels before it have left, so that each reaches back twice as long as the one below and together they
/// never exceed the budget.
std::size_t History::share(std::size_t level) const {
    return level == 0 ? m_budget / 8 * 3 : (m_budget / 8 * 5) >> std::min<std::size_t>(level, 60);
}

void History::trim(std::size_t level) {
    const std::size_t entrySize = level == 0 ? sizeof(ScopeSample) : sizeof(ScopeSpan);
    const auto has = [level](const ModuleHistory& module) {
        return level <= module.m_levels.size() ? module.entries(level) : 0;
    };
    std::size_t used = 0;
    for (const ModuleHistory& module : m_modules)
        used += has(module) * entrySize;
    while (used > share(level)) {
        ModuleHistory* victim = nullptr;
        for (ModuleHistory& module : m_modules)
            // Some entries must remain for the levels above to be built from.
            if (has(module) >= 2 * ModuleHistory::kBatch &&
                (victim == nullptr || module.oldest(level) < victim->oldest(level)))
                victim = &module;
        if (victim == nullptr)
            return;
        victim->coarsen(level);
        used -= ModuleHistory::kBatch * entrySize;
    }
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "model/scope/scopespan.h"
#include "protocol/servocommands.h"

namespace nmc {

/// A change of the gains in force, confirmed by the module.
struct GainsChange {
    ModuleIndex module;
    TimePoint time;
    std::optional<servo::SetGain> gains;  ///< nothing: the module has lost them, or another host may have set
                                          ///< them

    bool operator==(const GainsChange&) const = default;
};

/// The samples of one module, with a pyramid of spans above them: each level combines four entries of the
/// level below, counted from the first sample on, so that a scrolling picture is always divided at the same
/// places and does not shimmer. Appending and drawing cost the same however much data there is. Pure; one
/// thread.
class ModuleHistory {
public:
    /// Times must not go back; a sample earlier than the last is dropped.
    void append(const ScopeSample& sample);

    [[nodiscard]] bool empty() const { return m_count == 0; }
    /// The number of samples appended so far.
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    /// The time of the oldest data in any form.
    [[nodiscard]] std::optional<TimePoint> begin() const;
    /// The time of the oldest sample still kept individually.
    [[nodiscard]] std::optional<TimePoint> keptSince() const;
    [[nodiscard]] std::optional<ScopeSample> last() const;
    /// The number of samples with a value of `signal` kept in (from, to], for the achieved rate. A calculated
    /// signal that is unknown at the end counts as none.
    [[nodiscard]] std::size_t countBetween(TimePoint from, TimePoint to, ScopeSignal signal) const;

    /// Visits everything in [from, to], oldest first, and one span beyond each end, so that lines reach the
    /// edge of a plot. Spans are as wide as possible up to `widest`; otherwise single samples are visited.
    /// Old data have the width to which they were coarsened.
    template <typename Visit>
    void visit(TimePoint from, TimePoint to, Duration widest, Visit&& visit) const;

    /// Visits the samples that arrived after the first `count`, as far as they are still kept individually,
    /// but at most `most`. Returns the `count` to continue from.
    template <typename Visit>
    std::uint64_t visitSince(std::uint64_t count, Visit&& visit, std::uint64_t most = UINT64_MAX) const;
    /// Visits the samples in [from, to] that are still kept individually.
    template <typename Visit>
    void visitKept(TimePoint from, TimePoint to, Visit&& visit) const;
    /// Returns the samples in [from, to] that are still kept individually.
    [[nodiscard]] std::vector<ScopeSample> samples(TimePoint from, TimePoint to) const;
    /// The kept samples around `time`: the last one not after it, and the first one after it.
    struct Neighbours {
        std::optional<ScopeSample> before, after;
    };
    [[nodiscard]] Neighbours around(TimePoint time) const;
    /// Interpolates linearly between the two neighbours; nothing where one of them is missing or unknown.
    [[nodiscard]] std::optional<double> valueAt(TimePoint time, ScopeSignal signal) const;

private:
    friend class History;
    static constexpr unsigned kFanBits = 2;
    static constexpr std::uint64_t kFan = 1U << kFanBits;
    /// Entries of a level are removed in batches of this size, so that the rest begins where a span above
    /// begins.
    static constexpr std::size_t kBatch = 1024;

    struct Level {
        std::deque<ScopeSpan> spans;
        std::uint64_t firstIndex = 0;  ///< index of spans.front()
        ScopeSpan open;                ///< the span being filled
        unsigned filled = 0;           ///< number of entries of the level below in it
    };

    [[nodiscard]] std::uint64_t numberAt(TimePoint time) const;
    struct Entry {
        ScopeSpan span;
        std::uint64_t samples = 0;
    };
    /// The widest span that begins at sample `number` and fits, or the narrowest one left. `level`: the level
    /// to try first, and on return the one used; neighbours mostly have the same level.
    [[nodiscard]] Entry entryAt(std::uint64_t number, Duration widest, std::size_t& level) const;
    [[nodiscard]] const ScopeSpan* spanFrom(std::size_t level, std::uint64_t number) const;
    void sumUp(std::size_t level, ScopeSpan span);
    /// Removes the oldest entries of a level; level 0 is the samples.
    void coarsen(std::size_t level);
    [[nodiscard]] std::size_t entries(std::size_t level) const;
    [[nodiscard]] TimePoint oldest(std::size_t level) const;

    std::deque<ScopeSample> m_samples;
    std::uint64_t m_firstSample = 0;  ///< number of m_samples.front()
    std::uint64_t m_count = 0;
    std::vector<Level> m_levels;  ///< [0] combines kFan samples, [1] kFan^2, ...
};

/// The samples of a session, of all its modules, in bounded memory: when a level of the pyramids has used up
/// its share, its oldest entries are removed, whichever module they belong to, and the coarser levels still
/// show them. At the full speed of one module at 115 200 Bd, samples are kept for 20 minutes. Pure; one
/// thread.
class History {
public:
    static constexpr std::size_t kBudget = 64U << 20U;  ///< bytes

    explicit History(std::size_t modules = 0, std::size_t budget = kBudget);

    void append(ModuleIndex module, const ScopeSample& sample);
    /// Gains changes must be in order of time.
    void noteGains(const GainsChange& change);
    [[nodiscard]] const std::vector<GainsChange>& gains() const { return m_gains; }

    [[nodiscard]] std::size_t modules() const { return m_modules.size(); }
    /// Returns null if there is no such module.
    [[nodiscard]] const ModuleHistory* module(ModuleIndex index) const;
    /// True if there is no sample; part of a history may have the zero of the whole all the same.
    [[nodiscard]] bool empty() const { return !end(); }
    /// The time of the very first sample; plots and recordings count their seconds from here.
    [[nodiscard]] std::optional<TimePoint> zero() const { return m_zero; }
    [[nodiscard]] std::optional<TimePoint> begin() const;
    [[nodiscard]] std::optional<TimePoint> end() const;
    [[nodiscard]] std::size_t bytes() const;
    /// Returns the individually kept samples in [from, to] and the gains in force during that time; the zero
    /// time is kept.
    [[nodiscard]] History cut(TimePoint from, TimePoint to) const;

private:
    [[nodiscard]] std::size_t share(std::size_t level) const;
    void trim(std::size_t level);

    std::vector<ModuleHistory> m_modules;
    std::vector<GainsChange> m_gains;
    std::size_t m_budget;
    std::optional<TimePoint> m_zero;
};

template <typename Visit>
void ModuleHistory::visit(TimePoint from, TimePoint to, Duration widest, Visit&& visit) const {
    std::size_t level = 0;
    for (std::uint64_t number = numberAt(from); number < m_count;) {
        const Entry entry = entryAt(number, widest, level);
        visit(entry.span);
        if (entry.span.last > to)
            return;
        number += entry.samples;
    }
}

template <typename Visit>
std::uint64_t ModuleHistory::visitSince(std::uint64_t count, Visit&& visit, std::uint64_t most) const {
    std::uint64_t number = std::max(count, m_firstSample);
    for (; number < m_count && most > 0; ++number, --most)
        visit(m_samples[number - m_firstSample]);
    return number;
}

template <typename Visit>
void ModuleHistory::visitKept(TimePoint from, TimePoint to, Visit&& visit) const {
    auto sample = std::lower_bound(m_samples.begin(), m_samples.end(), from,
                                   [](const ScopeSample& one, TimePoint time) { return one.time < time; });
    for (; sample != m_samples.end() && sample->time <= to; ++sample)
        visit(*sample);
}

}  // namespace nmc

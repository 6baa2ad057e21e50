// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/scope/derivedsignals.h"
#include "model/scope/motionstart.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

/// A recording under the live traces, and its place in time: its first motion begins where the last live one
/// did, so that a motion is shown over the same motion of another day. Until both have a motion, the
/// recording ends at the time at which it was placed. GUI thread.
class Underlay {
public:
    explicit Underlay(std::shared_ptr<const ScopeRecord> record) : m_record(std::move(record)) {}

    [[nodiscard]] const ScopeRecord& record() const { return *m_record; }
    /// Call once per frame with the live history; `module`: the module whose motions count. Returns false if
    /// another frame is needed.
    bool follow(const History& live, std::optional<ModuleIndex> module, TimePoint now,
                const std::vector<ModuleSignal>& shown, std::vector<CustomSignal> custom);
    /// Call when the live history is replaced.
    void forget();
    /// Moves the recording by hand, in addition to its automatic place; later is positive.
    void shift(double seconds) { m_shift += fromSeconds(seconds); }

    /// The time in the recording that is shown at the live history's zero.
    [[nodiscard]] TimePoint zero() const { return m_zero; }
    /// None if the recorded module, which may be of another type, has no such signal.
    [[nodiscard]] SignalSource source(const ModuleSignal& of) const {
        return has(of) ? m_derived.source(m_record->history, of) : SignalSource{};
    }

private:
    [[nodiscard]] bool has(const ModuleSignal& of) const;
    bool followMotions(const History& live);

    std::shared_ptr<const ScopeRecord> m_record;
    DerivedSignals m_derived;
    std::optional<ModuleIndex> m_module;
    MotionStart m_recorded, m_live;
    std::optional<TimePoint> m_laid;  ///< the time at which the recording was placed
    Duration m_shift{};
    TimePoint m_zero;
};

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/scope/derivedsignals.h"
#include "model/scope/motionstart.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

/// A recording that lies under the live traces, and where: its first motion begins where the last live one
/// did, so that a motion is seen over the same motion of another day. Until there is one the recording ends
/// at the present in which it was laid. GUI thread.
class Underlay {
public:
    explicit Underlay(std::shared_ptr<const ScopeRecord> record) : m_record(std::move(record)) {}

    [[nodiscard]] const ScopeRecord& record() const { return *m_record; }
    /// One frame of the live history; `module`: whose motions count. False: another frame is wanted.
    bool follow(const History& live, std::optional<ModuleIndex> module, TimePoint now,
                const std::vector<ModuleSignal>& shown);
    /// The live history is another one.
    void forget();
    /// By hand, on top of all that; later is positive.
    void shift(double seconds) { m_shift += fromSeconds(seconds); }

    /// The time in the recording that lies under the live history's zero.
    [[nodiscard]] TimePoint zero() const { return m_zero; }
    [[nodiscard]] DerivedSignals::Source source(const ModuleSignal& of) const {
        return m_derived.source(m_record->history, of);
    }

private:
    bool followMotions(const History& live);

    std::shared_ptr<const ScopeRecord> m_record;
    DerivedSignals m_derived;
    std::optional<ModuleIndex> m_module;
    MotionStart m_recorded, m_live;
    std::optional<TimePoint> m_laid;  ///< the present then
    Duration m_shift{};
    TimePoint m_zero;
};

}  // namespace nmc

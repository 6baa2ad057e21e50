// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// New gains for a PIC-SERVO that holds still (DS-V 4.3), under the bus's net: those from before are back
/// when the time is over, at a stop, and at once when it begins to swing, goes away from where it stood, or
/// its servo goes off; unless they were kept by then (bus::Engine::keepTrial). Wants the bus's focus while it
/// runs.
///
/// They are tried with a lower output limit, since a loop swings as far as that lets it: a part of OL, but
/// more than what holds its load. Reaching it ends the trial, so it never makes bad gains look good.
class TryGainsRun : public Procedure {
public:
    /// `wanted` is possible now.
    TryGainsRun(const intent::TryGains& wanted, const ModuleState& module);

    void keep() override { awaitEnd(); }

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    void whileItLasts(const ModuleState& module) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next conclude(bus::TrialEnd end);
    [[nodiscard]] bus::Order set(const servo::SetGain& gains) const;

    servo::SetGain m_wanted;
    servo::SetGain m_before;
    double m_seconds;
    bool m_kept = false;
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Tries new gains on a PIC-SERVO at rest (DS-V 4.3), with the bus as a safety net: the old gains are
/// restored when the time is over, at a stop, and at once when the motor begins to oscillate, moves away from
/// where it stood, or its servo goes off, unless the new gains have been kept by then
/// (bus::Engine::keepTrial). Needs the bus's focus while it runs.
///
/// The gains are tried with a lower output limit, because an unstable loop oscillates as far as that allows:
/// a fraction of OL, but more than the load requires. Reaching the limit ends the trial, so it never makes
/// bad gains look good.
class TryGainsRun : public Procedure {
public:
    /// `wanted` must be possible now.
    TryGainsRun(const intent::TryGains& wanted, const ModuleState& module);

    void keep() override;
    /// Takes gains that are applied after those on trial were kept: they are sent in their place.
    [[nodiscard]] bool take(const servo::SetGain& gains) override;

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    void whileItLasts(const ModuleState& module) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next conclude(bus::TrialEnd end);
    [[nodiscard]] Next sendWanted();
    [[nodiscard]] bus::Order set(const servo::SetGain& gains) const;

    servo::SetGain m_wanted;
    servo::SetGain m_before;
    double m_seconds;
    bool m_keeps = false;
    std::optional<servo::SetGain> m_sent;  ///< with all of OL
};

}  // namespace nmc

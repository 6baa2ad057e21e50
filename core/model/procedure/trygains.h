// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// New gains for a PIC-SERVO that holds still (DS-V 4.3), under a net: those from before are back when the
/// time is over, at a stop, and at once when it begins to swing, goes away from where it stood, or its servo
/// goes off; unless they were kept by then. Wants the bus's focus while it runs.
class TryGainsRun : public Procedure {
public:
    /// `wanted` is possible now.
    TryGainsRun(const intent::TryGains& wanted, const ModuleState& module);

    void keep() override { m_report.kept = true; }

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) override;
    /// The gains that are tried.
    [[nodiscard]] bool mayBeInForce() const;
    [[nodiscard]] Next watch(const ModuleState& module, TimePoint now);
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const;
    [[nodiscard]] std::vector<bus::Order> set(const servo::SetGain& gains) const;

    servo::SetGain m_wanted;
    servo::SetGain m_before;
    double m_seconds;
    std::int32_t m_stood;              ///< counts, when the try began
    std::optional<TimePoint> m_until;  ///< once they are in force
    std::optional<TimePoint> m_backSince;
};

}  // namespace nmc

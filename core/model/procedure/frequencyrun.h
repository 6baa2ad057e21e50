// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/intent/intent.h"
#include "model/procedure/looptest.h"

namespace nmc {

/// Measures how the loop of a PIC-SERVO follows sines of the command position, from slow to fast, from the
/// positions at each frequency (DS-V 4.3; bus::Sine). It ends before the first frequency for which the line
/// is too slow, that is, for which it carries fewer than kCommandsPerPeriod commands per period. A motor that
/// oscillates by several amplitudes has gone too far; one that stays still, or moves otherwise than in a
/// sine, has no response. With a speed, the sines ride on a ramp, to and fro, and it ends where it began.
class FrequencyRun : public LoopTest {
public:
    static constexpr double kCommandsPerPeriod = 4.0;

    /// `wanted` must be possible now.
    FrequencyRun(const intent::FrequencyResponse& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next begin(const ModuleState& module) override;
    [[nodiscard]] Next goOn(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const override;
    [[nodiscard]] std::int32_t span() const override { return 2 * m_wanted.amplitude; }
    [[nodiscard]] Next swingNext(const ModuleState& module);
    [[nodiscard]] Next ride(const ModuleState& module, const bus::Sine& sine);
    [[nodiscard]] Next goBack(const ModuleState& module);
    [[nodiscard]] bool follows(const FrequencyPoint& point) const;

    intent::FrequencyResponse m_wanted;
    std::vector<double> m_frequencies;  ///< Hz, ascending
    double m_ramp = 0.0;                ///< counts/s, of the next sine; 0: at rest
    double m_centre = 0.0;              ///< counts, where the next sine begins
    bool m_goesBack = false;            ///< the last frequency has been measured
    int m_missed = 0;                   ///< failed measurements at the present frequency
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/standstill.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// One step of the command position of a PIC-SERVO that holds still, to see how the motor follows (DS-V 4.3).
/// It begins at the position that the servo holds, waits for the record to be over, and ends with a
/// stop, by which the chip forgets the step's velocity (an acceleration every motion brings along itself),
/// and a Stop Here at its goal, so that this is held to the count; version 1 has no Stop Here.
///
/// A motor that goes the wrong way, or twice the step, is told to hold; if that does not calm it the servo
/// itself keeps it going, and is switched off. Any stop ends it. Wants the bus's focus while it runs.
class StepResponseRun : public Procedure {
public:
    /// `wanted` is possible now.
    StepResponseRun(const intent::StepResponse& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Step> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next prepare(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next step(const ModuleState& module);
    [[nodiscard]] Next record(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next settle(const ModuleState& module, TimePoint now);
    [[nodiscard]] std::vector<bus::Step> steps(std::vector<ServoCommand> commands) const;
    [[nodiscard]] std::vector<bus::Step> hold(const ModuleState& module) const;
    [[nodiscard]] std::vector<bus::Step> holdGoal(const ModuleState& module) const;
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const;
    [[nodiscard]] bool stands(const ModuleState& module, TimePoint now);

    intent::StepResponse m_wanted;
    StepTaken m_taken;
    std::int32_t m_stood = 0;  ///< when it was taken
    bool m_gainsSent = false;
    bool m_calming = false;
    std::optional<TimePoint> m_since;  ///< when it was first looked at for standing still
    Standstill m_standstill;
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"
#include "model/procedure/standstill.h"

namespace nmc {

/// Trapezoidal moves of a PIC-SERVO by N counts, from where the last move was to go: what a servo is off by
/// does not add up. Each waits for the one before to stand still. Any stop ends it.
class StepByRun : public Procedure {
public:
    StepByRun(const intent::StepBy& wanted, const ModuleState& module);

    [[nodiscard]] Next next(const ModuleState& module, TimePoint now) override;
    void onFinished(bus::Outcome outcome) override;
    void onLinkSuspect() override;
    void cancel() override;
    [[nodiscard]] ProcedureReport report() const override { return m_report; }

private:
    [[nodiscard]] Next move(const ModuleState& module);
    [[nodiscard]] Next moving(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next giveUp(const ModuleState& module);
    void fail(ProcedureFailure failure);

    intent::StepBy m_wanted;
    ProcedureReport m_report;
    std::optional<std::int64_t> m_goal;  ///< of the last move
    unsigned m_moves = 0;
    bool m_inFlight = false;
    bool m_started = false;
    bool m_stopSent = false;
    bool m_mayStop =
        true;  ///< false: whoever cancelled the commands has stopped the motor, or switched it off
    TimePoint m_startedAt;
    TimePoint m_pausedAt;
    Standstill m_standstill;
    std::optional<ProcedureStage> m_end;
};

}  // namespace nmc

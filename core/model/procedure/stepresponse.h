// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"
#include "model/procedure/standstill.h"

namespace nmc {

/// Longest step, counts: "test motions should be small motions" (DS-V 4.3).
inline constexpr std::int32_t kLongestStep = 2'000;
inline constexpr std::int32_t kFirstStep = 100;
/// Seconds; the bus can be given to one module for 5 s (bus::Engine::focus).
inline constexpr double kShortestRecord = 0.02;
inline constexpr double kLongestRecord = 3.0;

/// Whatever makes it impossible is found before anything is sent. The position error is the whole step when
/// the command has jumped, so the position error limit must be above it with a margin.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module);

/// One step of the command position of a PIC-SERVO that holds still, to see how the motor follows (DS-V 4.3).
/// It begins where the motor stands, waits for the record to be over, and ends with a stop that holds: by
/// that the chip forgets the step's velocity, too; an acceleration every motion brings along itself.
///
/// A motor that goes the wrong way, or twice the step, is told to hold; if that does not calm it the servo
/// itself keeps it going, and is switched off. Any stop ends it. Wants the bus's focus while it runs.
class StepResponseRun : public Procedure {
public:
    /// `wanted` is possible now.
    StepResponseRun(const intent::StepResponse& wanted, const ModuleState& module);

    [[nodiscard]] Next next(const ModuleState& module, TimePoint now) override;
    void onFinished(bus::Outcome outcome) override;
    void onLinkSuspect() override;
    void cancel() override;
    [[nodiscard]] ProcedureReport report() const override { return m_report; }

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next prepare(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next step(const ModuleState& module);
    [[nodiscard]] Next record(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next settle(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next giveUp(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next calm(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next send(std::vector<ServoCommand> commands);
    [[nodiscard]] Next hold(const ModuleState& module);
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const;
    [[nodiscard]] bool stands(const ModuleState& module, TimePoint now);
    void fail(ProcedureFailure failure);

    intent::StepResponse m_wanted;
    ProcedureReport m_report;
    StepTaken m_taken;
    bool m_inFlight = false;
    bool m_mayStop = false;  ///< it may have been set in motion by this, and nobody else has stopped it
    bool m_holdSent = false;
    std::optional<TimePoint> m_since;  ///< when it was first looked at for standing still
    Standstill m_standstill;
    std::optional<ProcedureStage> m_end;  ///< Failed or Cancelled, once the hold is out
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/standstill.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// A procedure that consists of moves to a goal, one after the other, each from standstill. Any stop, and any
/// motion that is not its own, ends it.
class GoalMoves : public Procedure {
protected:
    GoalMoves(ProcedureKind kind, const ModuleState& module);

    /// One move of the chip's own kind.
    [[nodiscard]] virtual Intent moveTo(std::int32_t goal) const = 0;
    /// What comes when the motor stands, at the first time or at the goal of the move before.
    [[nodiscard]] virtual Next standing(const ModuleState& module, TimePoint now) = 0;
    [[nodiscard]] Next go(ProcedureStage stage, std::int64_t goal, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) final;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const final;
    /// Nothing: it has arrived.
    [[nodiscard]] std::optional<Next> underWay(const ModuleState& module, TimePoint now);

    std::int32_t m_heading = 0;  ///< goal of the move under way
    bool m_moves = false;
    std::optional<TimePoint> m_startedAt;
    Standstill m_standstill;
};

}  // namespace nmc

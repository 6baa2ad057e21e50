// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"
#include "model/procedure/standstillwait.h"

namespace nmc {

/// A procedure that consists of successive moves to a goal, each from standstill. Any stop, and any motion
/// that is not its own, ends it.
class GoalMoves : public Procedure {
protected:
    GoalMoves(ProcedureKind kind, const ModuleState& module);

    /// Returns the intent for one move, of the kind that the chip supports.
    [[nodiscard]] virtual Intent moveTo(std::int32_t goal) const = 0;
    /// Called when the motor stands, initially or at the goal of the previous move.
    [[nodiscard]] virtual Next standing(const ModuleState& module, TimePoint now) = 0;
    [[nodiscard]] Next go(ProcedureStage stage, std::int64_t goal, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) final;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const final;
    /// Returns nothing when the motor has arrived.
    [[nodiscard]] std::optional<Next> underWay(const ModuleState& module, TimePoint now);

    std::int32_t m_heading = 0;  ///< goal of the current move
    bool m_moves = false;
    StandstillWait m_rest;
};

}  // namespace nmc

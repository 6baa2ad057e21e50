// SPDX-License-Identifier: MIT
#include "model/procedure/goalmoves.h"

#include "model/intent/backlash.h"
#include "model/intent/homingplan.h"
#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"

namespace nmc {

GoalMoves::GoalMoves(ProcedureKind kind, const ModuleState& module) : Procedure(module.info.index, kind) {
    m_mayRun = true;
}

GoalMoves::Next GoalMoves::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (!module.driveOn())
        return fail(ProcedureFailure::WentOff);
    if (m_moves)
        if (auto next = underWay(module, now))
            return *next;
    return standing(module, now);
}

GoalMoves::Next GoalMoves::go(ProcedureStage stage, std::int64_t goal, const ModuleState& module) {
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return fail(ProcedureFailure::TravelLimit);
    m_heading = static_cast<std::int32_t>(goal);
    const Intent next = moveTo(m_heading);
    // A turn to take up the backlash is one of these moves, and no reason to turn another time.
    ModuleState straight = withoutBacklash(module);
    if (travelProblem(next, straight))
        return fail(ProcedureFailure::SoftLimit);
    // Due if the motor has left a closed limit switch; while a procedure runs, nothing else arms it.
    Orders steps;
    if (const auto arm = limitStopDue(module)) {
        steps = orders({limitStop(*arm)});
        straight.limitStop.eachMotion = false;
    }
    const auto move = plan(next, straight);
    if (!move)
        return fail(ProcedureFailure::Refused);
    steps.insert(steps.end(), move->begin(), move->end());
    m_report.stage = stage;
    m_moves = true;
    m_travel = travelRange(module);
    m_rest.restart();
    return send(std::move(steps));
}

std::optional<GoalMoves::Next> GoalMoves::underWay(const ModuleState& module, TimePoint now) {
    // If the goal is no longer this procedure's, something else moves the motor or has stopped it. A motor
    // whose chip has stopped it short still has this goal.
    if (!module.headsFor(m_heading)) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    if (passesNewLimit(m_heading, module))
        return fail(ProcedureFailure::SoftLimit);
    if (!m_rest.over(module, now))
        return Wait{};
    if (module.isStepper() && *module.latest->position != m_heading)
        return fail(ProcedureFailure::StoppedShort);
    m_moves = false;
    return std::nullopt;
}

std::vector<bus::Order> GoalMoves::lastWord(const ModuleState& module) const {
    // To a servo that is off, a stop would switch it on.
    if (!m_mayRun || !module.driveOn())
        return {};
    return {smoothStop(module)};
}

}  // namespace nmc

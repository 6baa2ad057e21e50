// SPDX-License-Identifier: MIT
#include "model/procedure/stepby.h"

#include <algorithm>
#include <utility>

#include "base/overloaded.h"
#include "model/intent/backlash.h"
#include "model/intent/stepplan.h"
#include "model/intent/travel.h"

namespace nmc {

StepByRun::StepByRun(const Wanted& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::StepBy),
      m_wanted(wanted),
      m_moves(std::visit([](const auto& one) { return one.moves; }, wanted)) {
    m_report.rounds = std::max(m_moves.rounds, 1U);
    m_mayRun = true;
}

StepByRun::Next StepByRun::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    if (!module.driveOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Moving || m_report.stage == ProcedureStage::TakingUpBacklash)
        return moving(module, now);
    const bool pausing = m_report.stage == ProcedureStage::Pausing;
    if (pausing && toSeconds(now - m_pausedAt) < m_moves.pause)
        return Wait{};
    return move(module);
}

StepByRun::Next StepByRun::move(const ModuleState& module) {
    if (!module.latest->position)
        return fail(ProcedureFailure::Refused);
    if (!m_goal)
        m_goal = module.goal().value_or(*module.latest->position);
    const bool back = m_moves.backAndForth && m_made % 2 == 1;
    const std::int64_t from = *m_goal;
    const std::int64_t goal = from + (back ? -std::int64_t{m_moves.counts} : m_moves.counts);
    m_goal = goal;
    ++m_made;
    m_report.round = m_moves.backAndForth ? (m_made + 1) / 2 : m_made;
    const auto turn = turningPoint(from, goal, module);
    m_report.stage = turn ? ProcedureStage::TakingUpBacklash : ProcedureStage::Moving;
    return go(turn.value_or(goal), module);
}

Intent StepByRun::moveTo(std::int32_t goal) const {
    return std::visit(
        Overloaded{
            [goal](const intent::StepBy& by) -> Intent {
                return intent::GoTo{Counts(goal), by.velocity, by.acceleration};
            },
            [goal](const stepintent::StepBy& by) -> Intent {
                return stepintent::Move{stepmotion::Trapezoid{goal, false, by.speed, by.accelerationTime}};
            },
        },
        m_wanted);
}

StepByRun::Next StepByRun::go(std::int64_t goal, const ModuleState& module) {
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return fail(ProcedureFailure::TravelLimit);
    const Intent next = moveTo(static_cast<std::int32_t>(goal));
    if (travelProblem(next, module))
        return fail(ProcedureFailure::SoftLimit);
    m_heading = goal;
    m_started = false;
    const auto steps = plan(next, module);
    return steps ? send(*steps) : fail(ProcedureFailure::Refused);
}

StepByRun::Next StepByRun::moving(const ModuleState& module, TimePoint now) {
    if (!std::exchange(m_started, true)) {
        m_startedAt = now;
        m_standstill.reset();
    }
    // Its goal is not ours any more: something else moves or has stopped it.
    if ((module.isStepper() ? module.stepper.goal() : module.goal()) !=
        static_cast<std::int32_t>(m_heading)) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    return arrived(module, now);
}

StepByRun::Next StepByRun::arrived(const ModuleState& module, TimePoint now) {
    if (module.isStepper() && *module.latest->position != m_heading)
        return fail(ProcedureFailure::StoppedShort);
    if (m_report.stage == ProcedureStage::TakingUpBacklash) {
        m_report.stage = ProcedureStage::Moving;
        return go(*m_goal, module);
    }
    const unsigned moves = m_report.rounds * (m_moves.backAndForth ? 2 : 1);
    if (m_made >= moves)
        return finish();
    m_report.stage = ProcedureStage::Pausing;
    m_pausedAt = now;
    return Wait{};
}

std::vector<bus::Step> StepByRun::lastWord(const ModuleState& module) const {
    // To a servo that is off the stop would be what switches it on.
    if (!m_mayRun || !module.driveOn())
        return {};
    return {smoothStop(module)};
}

}  // namespace nmc

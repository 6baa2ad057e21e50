// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/programrequests.h"

#include <utility>

#include "widgets/common/apitexts.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

[[nodiscard]] bool leadsToGoal(const Intent& intent) {
    return std::visit(
        [](const auto& one) { return AnyOf<std::decay_t<decltype(one)>, intent::Move, intent::GoHome>; },
        intent);
}

}  // namespace

void ProgramRequests::begin(ModuleIndex module, const Intent& intent) {
    forget(module);
    if (leadsToGoal(intent))
        m_goals[module];
}

void ProgramRequests::forget(ModuleIndex module) {
    m_operations.erase(module);
    m_failures.erase(module);
    m_goals.erase(module);
    m_procedures.erase(module);
}

void ProgramRequests::sequenceBegun() {
    m_runs = m_awaitsEnd;
    if (m_awaitsEnd)
        m_sequenceFailure.reset();
}

void ProgramRequests::onFinished(const bus::OperationFinished& finished, const ModuleState* module) {
    const auto own = m_operations.find(finished.module);
    if (own == m_operations.end() || own->second != finished.id)
        return;
    if (finished.outcome != bus::Outcome::Done)
        m_failures[finished.module] = texts::operationFailed(finished).headline;
    else if (const auto goal = m_goals.find(finished.module); goal != m_goals.end() && module != nullptr)
        goal->second = module->goal();
}

void ProgramRequests::onProcedureOver(ModuleIndex module, const std::optional<QString>& failure) {
    if (m_procedures.erase(module) != 0 && failure)
        m_failures[module] = *failure;
}

void ProgramRequests::onSequenceOver(const std::optional<QString>& failure) {
    m_runs = false;
    if (std::exchange(m_awaitsEnd, false))
        m_sequenceFailure = failure;
}

std::optional<QString> ProgramRequests::failure(const ModuleState& module) const {
    if (const auto failure = m_failures.find(module.info.index); failure != m_failures.end())
        return failure->second;
    const auto goal = m_goals.find(module.info.index);
    // Whatever has stopped the motor, or commanded it since, has replaced the goal.
    const bool replaced = goal != m_goals.end() && goal->second && goal->second != module.goal();
    return replaced ? std::optional(texts::wasCancelled()) : std::nullopt;
}

}  // namespace nmc

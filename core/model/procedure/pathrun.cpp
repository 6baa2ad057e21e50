// SPDX-License-Identifier: MIT
#include "model/procedure/pathrun.h"

#include "model/path/pathplan.h"

namespace nmc {

namespace {

/// The failure for an end that the user did not cause.
[[nodiscard]] ProcedureFailure failureOf(bus::PathEnd end) {
    switch (end) {
        case bus::PathEnd::NotStarted:
            return ProcedureFailure::NotStarted;
        case bus::PathEnd::UnderRun:
            return ProcedureFailure::UnderRun;
        case bus::PathEnd::StoppedShort:
            return ProcedureFailure::StoppedShort;
        case bus::PathEnd::OffPath:
            return ProcedureFailure::OffPath;
        case bus::PathEnd::Uncertain:
            return ProcedureFailure::LinkSuspect;
        case bus::PathEnd::NoAnswer:
            return ProcedureFailure::ModuleUnresponsive;
        case bus::PathEnd::Done:
        case bus::PathEnd::Stopped:
        case bus::PathEnd::NotReady:
            break;
    }
    return ProcedureFailure::Refused;
}

}  // namespace

PathRun::PathRun(const intent::FollowPath& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::FollowPath), m_plan(wanted.plan) {}

PathRun::Next PathRun::proceed(const ModuleState& module, TimePoint /*now*/) {
    look(module);
    if (m_report.stage == ProcedureStage::Moving)
        return finish();
    if (whyNot(intent::FollowPath{m_plan}, module))
        return fail(ProcedureFailure::Refused);
    m_report.stage = ProcedureStage::Moving;
    m_mayRun = true;
    std::vector<bus::Order> starts;
    for (const bus::PathAxis& axis : m_plan->axes)
        starts.push_back({axis.module, ServoCommand(servo::AddPathPoints())});
    return follow(std::move(starts), m_plan);
}

/// The progress of a previous path is ignored.
void PathRun::look(const ModuleState& module) {
    if (module.path && module.path->plan == m_plan)
        m_report.path = module.path;
}

/// To a servo that is off, a stop would switch it on; when a path has ended, the bus has taken care of the
/// stops.
std::vector<bus::Order> PathRun::lastWord(const ModuleState& module) const {
    const bool ended = module.path && module.path->plan == m_plan && module.path->end;
    if (!m_mayRun || ended || !module.servoOn())
        return {};
    const auto manner = m_plan->smoothStop ? servo::StopManner::Smoothly : servo::StopManner::Abruptly;
    return {{m_report.module, ServoCommand(servo::StopMotor{module.amplifierKept(), manner, {}})}};
}

PathRun::Next PathRun::afterLastWord(const ModuleState& module, TimePoint /*now*/) {
    look(module);
    if (m_report.failure == ProcedureFailure::Refused && m_report.path && m_report.path->end)
        m_report.failure = failureOf(*m_report.path->end);
    return End{};
}

}  // namespace nmc

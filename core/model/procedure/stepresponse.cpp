// SPDX-License-Identifier: MIT
#include "model/procedure/stepresponse.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/intent/gainsplan.h"
#include "model/intent/stepresponseplan.h"

namespace nmc {

namespace {

/// Of velocity and acceleration: the profile is at the goal of the longest step in one tick. The highest that
/// can be loaded would do the same, but their sum would not fit into the chip's 32 bits.
constexpr std::uint32_t kAtOnce = 4'096U << 16U;
/// For the motor to stand still, before the step and after it.
constexpr Duration kStillWithin = std::chrono::seconds(2);
/// For a hold to calm a motor that has gone too far.
constexpr Duration kCalmWithin = std::chrono::milliseconds(500);

}  // namespace

StepResponseRun::StepResponseRun(const intent::StepResponse& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::StepResponse), m_wanted(wanted) {}

StepResponseRun::Next StepResponseRun::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    if (!module.servoOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Preparing)
        return prepare(module, now);
    return m_report.stage == ProcedureStage::Moving ? record(module, now) : settle(module, now);
}

StepResponseRun::Next StepResponseRun::prepare(const ModuleState& module, TimePoint now) {
    if (m_wanted.gains && !std::exchange(m_gainsSent, true))
        return send(steps({gainsFor(module, *m_wanted.gains)}));
    if (stands(module, now))
        return step(module);
    return now - *m_since > kStillWithin ? fail(ProcedureFailure::NotStill) : Next(Wait{});
}

StepResponseRun::Next StepResponseRun::step(const ModuleState& module) {
    // Something may have changed while it was waited for standstill.
    if (whyNot(m_wanted, module))
        return fail(ProcedureFailure::Refused);
    m_stood = *module.latest->position;
    const std::int32_t from = *module.goal();
    m_taken = {{}, from, from + m_wanted.counts, m_wanted.record, m_wanted.way, *module.gains};
    m_report.stage = ProcedureStage::Moving;
    m_mayRun = true;
    const Counts goal(m_taken.goal);
    if (m_wanted.way == StepWay::StopHere)
        return send(steps({servo::StopMotor{module.amplifierEnabled, servo::StopManner::Here, goal}}));
    servo::LoadTrajectory load;
    load.position = goal;
    load.velocity = CountsPerTick(kAtOnce);
    load.acceleration = CountsPerTickSquared(kAtOnce);
    return send(steps({load, StartMotion{}}));
}

StepResponseRun::Next StepResponseRun::record(const ModuleState& module, TimePoint now) {
    if (!m_report.step) {
        m_taken.at = module.motionCommandedAt;
        m_report.step = m_taken;
    }
    if (module.motionCommandedAt != m_taken.at) {  // something else moves or has stopped it
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    if (goneTooFar(module))
        return fail(ProcedureFailure::TravelLimit);
    if (toSeconds(now - m_taken.at) < m_taken.record)
        return Wait{};
    m_report.stage = ProcedureStage::Stopping;
    m_since.reset();
    return send(holdGoal(module));
}

StepResponseRun::Next StepResponseRun::settle(const ModuleState& module, TimePoint now) {
    if (stands(module, now))
        return finish();
    if (now - *m_since <= kStillWithin)
        return Wait{};
    m_mayRun = false;  // it has been told
    return fail(ProcedureFailure::NotStill);
}

std::vector<bus::Step> StepResponseRun::lastWord(const ModuleState& module) const {
    // To a servo that is off the hold would be what switches it on.
    return m_mayRun && module.servoOn() ? hold(module) : std::vector<bus::Step>{};
}

/// What a hold does not calm the servo itself keeps going.
StepResponseRun::Next StepResponseRun::afterLastWord(const ModuleState& module, TimePoint now) {
    if (!m_mayRun || !module.servoOn() || m_report.failure != ProcedureFailure::TravelLimit)
        return End{};
    if (!std::exchange(m_calming, true))
        m_since.reset();
    if (stands(module, now))
        return End{};
    if (now - *m_since < kCalmWithin)
        return Wait{};
    m_mayRun = false;
    m_report.failure = ProcedureFailure::Unstable;
    return send(steps({servo::StopMotor{false, servo::StopManner::MotorOff, {}}}));
}

std::vector<bus::Step> StepResponseRun::hold(const ModuleState& module) const {
    return steps({servo::StopMotor{module.amplifierEnabled, servo::StopManner::Abruptly, {}}});
}

std::vector<bus::Step> StepResponseRun::holdGoal(const ModuleState& module) const {
    std::vector<bus::Step> both = hold(module);
    if (module.info.identity.version >= servo::kStopHereVersion)
        both.push_back(
            {m_report.module, ServoCommand(servo::StopMotor{module.amplifierEnabled, servo::StopManner::Here,
                                                            Counts(m_taken.goal)})});
    return both;
}

std::vector<bus::Step> StepResponseRun::steps(std::vector<ServoCommand> commands) const {
    std::vector<bus::Step> steps;
    for (ServoCommand& command : commands)
        steps.push_back({m_report.module, std::move(command)});
    return steps;
}

/// No stable servo overshoots by a whole step, nor swings back to where it came from.
bool StepResponseRun::goneTooFar(const ModuleState& module) const {
    if (module.latestTime <= m_taken.at)
        return false;
    const std::int64_t step = std::abs(std::int64_t{m_wanted.counts});
    const std::int64_t gone = countsBetween(m_stood, *module.latest->position);
    const std::int64_t way = m_wanted.counts < 0 ? -gone : gone;
    return way > 2 * step + kStillCounts || way < -step / 4 - kStillCounts;
}

bool StepResponseRun::stands(const ModuleState& module, TimePoint now) {
    if (!m_since) {
        m_since = now;
        m_standstill.reset();
    }
    return module.latestTime > *m_since &&
           m_standstill.look(module.latestTime, *module.latest->position, module.moving());
}

}  // namespace nmc

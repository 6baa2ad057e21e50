// SPDX-License-Identifier: MIT
#include "model/procedure/stepresponse.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace nmc {

namespace {

/// Of velocity and acceleration: the profile is at the goal of the longest step in one tick. The highest that
/// can be loaded would do the same, but their sum would not fit into the chip's 32 bits.
constexpr std::uint32_t kAtOnce = 4'096U << 16U;
/// For the motor to stand still, before the step and after it.
constexpr Duration kStillWithin = std::chrono::seconds(2);
/// For a hold to calm a motor that has gone too far.
constexpr Duration kCalmWithin = std::chrono::milliseconds(500);

/// A step that would trip, or come close to it: a tenth, and what a servo swings at standstill.
[[nodiscard]] bool wouldTrip(std::int64_t step, std::int64_t errorLimit) {
    return step + step / 10 + Standstill::kStill > errorLimit;
}

}  // namespace

std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module) {
    if (const auto refusal = whyNot(Request::Move, module))
        return refusal;
    if (!module.gains)
        return Refusal::GainsUnknown;
    if (!module.latest->position)
        return Refusal::PositionUnknown;
    if (wanted.way == StepWay::StopHere && module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    if (wanted.counts == 0)
        return Refusal::StepTooShort;
    const std::int64_t step = std::abs(std::int64_t{wanted.counts});
    if (step > kLongestStep)
        return Refusal::StepTooLong;
    if (wouldTrip(step, module.gains->el))
        return Refusal::StepWouldTrip;
    const std::int64_t goal = std::int64_t{*module.latest->position} + wanted.counts;
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return Refusal::GoalOutOfRange;
    if (!(wanted.record >= kShortestRecord && wanted.record <= kLongestRecord))
        return Refusal::RecordTime;
    return std::nullopt;
}

StepResponseRun::StepResponseRun(const intent::StepResponse& wanted, const ModuleState& module)
    : m_wanted(wanted) {
    m_report.module = module.info.index;
    m_report.kind = ProcedureKind::StepResponse;
}

StepResponseRun::Next StepResponseRun::next(const ModuleState& module, TimePoint now) {
    if (m_inFlight)
        return Wait{};
    if (!m_end && module.silent)
        fail(ProcedureFailure::ModuleSilent);
    else if (!m_end && !module.servoOn())
        fail(ProcedureFailure::WentOff);
    if (!m_end) {
        Next next = proceed(module, now);
        if (!m_end)
            return next;
    }
    return giveUp(module, now);
}

StepResponseRun::Next StepResponseRun::proceed(const ModuleState& module, TimePoint now) {
    if (m_report.stage == ProcedureStage::Preparing)
        return prepare(module, now);
    return m_report.stage == ProcedureStage::Moving ? record(module, now) : settle(module, now);
}

StepResponseRun::Next StepResponseRun::prepare(const ModuleState& module, TimePoint now) {
    if (stands(module, now))
        return step(module);
    if (now - *m_since > kStillWithin)
        fail(ProcedureFailure::NotStill);
    return Wait{};
}

StepResponseRun::Next StepResponseRun::step(const ModuleState& module) {
    // Something may have changed while it was waited for standstill.
    if (whyNot(m_wanted, module)) {
        fail(ProcedureFailure::Refused);
        return Wait{};
    }
    const std::int32_t from = *module.latest->position;
    m_taken = {{}, from, from + m_wanted.counts, m_wanted.record, m_wanted.way, *module.gains};
    m_report.stage = ProcedureStage::Moving;
    m_mayStop = true;
    const Counts goal(m_taken.goal);
    if (m_wanted.way == StepWay::StopHere)
        return send({servo::StopMotor{module.amplifierEnabled, servo::StopManner::Here, goal}});
    servo::LoadTrajectory load;
    load.position = goal;
    load.velocity = CountsPerTick(kAtOnce);
    load.acceleration = CountsPerTickSquared(kAtOnce);
    return send({load, StartMotion{}});
}

StepResponseRun::Next StepResponseRun::record(const ModuleState& module, TimePoint now) {
    if (!m_report.step) {
        m_taken.at = module.motionCommandedAt;
        m_report.step = m_taken;
    }
    if (module.motionCommandedAt != m_taken.at) {  // something else moves or has stopped it
        m_mayStop = false;
        m_end = ProcedureStage::Cancelled;
        return Wait{};
    }
    if (goneTooFar(module)) {
        fail(ProcedureFailure::TravelLimit);
        return Wait{};
    }
    if (toSeconds(now - m_taken.at) < m_taken.record)
        return Wait{};
    m_report.stage = ProcedureStage::Stopping;
    return hold(module);
}

StepResponseRun::Next StepResponseRun::settle(const ModuleState& module, TimePoint now) {
    if (stands(module, now)) {
        m_report.stage = ProcedureStage::Done;
        return End{};
    }
    if (now - *m_since > kStillWithin) {
        m_mayStop = false;  // it has been told
        fail(ProcedureFailure::NotStill);
    }
    return Wait{};
}

StepResponseRun::Next StepResponseRun::giveUp(const ModuleState& module, TimePoint now) {
    // To a servo that is off the hold would be what switches it on.
    if (m_mayStop && module.servoOn()) {
        if (!std::exchange(m_holdSent, true))
            return hold(module);
        if (m_report.failure == ProcedureFailure::TravelLimit)
            return calm(module, now);
    }
    m_report.stage = *m_end;
    return End{};
}

StepResponseRun::Next StepResponseRun::calm(const ModuleState& module, TimePoint now) {
    if (stands(module, now)) {
        m_mayStop = false;
        return giveUp(module, now);
    }
    if (now - *m_since < kCalmWithin)
        return Wait{};
    m_mayStop = false;
    m_report.failure = ProcedureFailure::Unstable;
    return send({servo::StopMotor{false, servo::StopManner::MotorOff, {}}});
}

StepResponseRun::Next StepResponseRun::hold(const ModuleState& module) {
    m_since.reset();
    return send({servo::StopMotor{module.amplifierEnabled, servo::StopManner::Abruptly, {}}});
}

StepResponseRun::Next StepResponseRun::send(std::vector<ServoCommand> commands) {
    m_inFlight = true;
    Send send;
    for (ServoCommand& command : commands)
        send.steps.push_back({m_report.module, std::move(command)});
    return send;
}

/// No stable servo overshoots by a whole step, nor swings back to where it came from.
bool StepResponseRun::goneTooFar(const ModuleState& module) const {
    if (module.latestTime <= m_taken.at)
        return false;
    const std::int64_t step = std::abs(std::int64_t{m_wanted.counts});
    const std::int64_t gone = countsBetween(m_taken.from, *module.latest->position);
    const std::int64_t way = m_wanted.counts < 0 ? -gone : gone;
    return way > 2 * step + Standstill::kStill || way < -step / 4 - Standstill::kStill;
}

bool StepResponseRun::stands(const ModuleState& module, TimePoint now) {
    if (!m_since) {
        m_since = now;
        m_standstill.reset();
    }
    return module.latestTime > *m_since &&
           m_standstill.look(module.latestTime, *module.latest->position, module.moving());
}

void StepResponseRun::fail(ProcedureFailure failure) {
    m_end = ProcedureStage::Failed;
    m_report.failure = failure;
}

void StepResponseRun::onFinished(bus::Outcome outcome) {
    m_inFlight = false;
    if (outcome == bus::Outcome::Cancelled)
        m_mayStop = false;  // whoever did that has stopped the motor, or switched it off
    if (m_end || outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled)
        m_end = ProcedureStage::Cancelled;
    else
        fail(ProcedureFailure::Refused);
}

void StepResponseRun::onLinkSuspect() {
    if (!m_end && !m_report.over())
        fail(ProcedureFailure::LinkSuspect);
}

void StepResponseRun::cancel() {
    if (m_holdSent)
        m_mayStop = false;  // and whoever cancels sees to the rest
    if (!m_end && !m_report.over())
        m_end = ProcedureStage::Cancelled;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "model/procedure/directioncheck.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/intent/directionplan.h"

namespace nmc {

namespace {

/// Motor off, with AMP_EN set or cleared; neither form switches the servo on.
[[nodiscard]] servo::StopMotor off(bool amplifier) {
    return {amplifier, servo::StopManner::MotorOff, {}};
}

[[nodiscard]] DirectionVerdict diagnose(std::int32_t forward, std::int32_t reverse) {
    if (forward == 0 && reverse == 0)
        return DirectionVerdict::NoMovement;
    if (forward > 0 && reverse < 0)
        return DirectionVerdict::Right;
    return forward < 0 && reverse > 0 ? DirectionVerdict::Reversed : DirectionVerdict::Unclear;
}

}  // namespace

DirectionCheck::DirectionCheck(const intent::CheckDirection& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::DirectionCheck), m_wanted(wanted) {
    m_report.rounds = 2;
}

DirectionCheck::Next DirectionCheck::proceed(const ModuleState& module, TimePoint now) {
    if (m_concluded)
        return finish();
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (module.servoOn()) {
        cancel();
        return Wait{};
    }
    if (!m_rest.over(module, now))
        return m_rest.lasted(now) > kStillWithin ? fail(ProcedureFailure::NotStill) : Next(Wait{});
    return m_report.stage == ProcedureStage::Preparing ? begin(module) : look(module);
}

DirectionCheck::Next DirectionCheck::begin(const ModuleState& module) {
    // The state may have changed during the wait for standstill.
    if (whyNot(IntentKind::CheckDirection, module))
        return fail(ProcedureFailure::Refused);
    const servo::StatusByte status = module.latest->servoStatus();
    m_start = m_from = *module.latest->position;
    m_limit1 = status.limit1();
    m_limit2 = status.limit2();
    m_push = kFirstPush;
    m_report.stage = ProcedureStage::Moving;
    m_report.round = 1;
    return push();
}

DirectionCheck::Next DirectionCheck::look(const ModuleState& module) {
    const servo::StatusByte status = module.latest->servoStatus();
    if (!status.powerOn())
        return conclude(DirectionVerdict::NoPower, module);
    if ((status.limit1() && !m_limit1) || (status.limit2() && !m_limit2))
        return conclude(DirectionVerdict::LimitClosed, module);
    const std::int32_t position = *module.latest->position;
    if (std::abs(std::int64_t{countsBetween(m_start, position)}) > m_wanted.reach)
        return fail(ProcedureFailure::TravelLimit);
    const std::int32_t moved = countsBetween(m_from, position);
    const bool seen = std::abs(std::int64_t{moved}) >= kMovedCounts;
    if (!seen && m_push + kPushStep <= kStrongestPush) {
        m_push = static_cast<std::uint8_t>(m_push + kPushStep);
        return push();
    }
    (m_reverse ? m_found.reverse : m_found.forward) = seen ? moved : 0;
    if (std::exchange(m_reverse, true))
        return conclude(diagnose(m_found.forward, m_found.reverse), module);
    m_from = position;
    m_push = kFirstPush;
    m_report.round = 2;
    return push();
}

/// The bridge shorts the motor until the next command is answered, and is then switched off: this brakes the
/// motion that the push started. The reads in between make the push long enough to move a load.
DirectionCheck::Next DirectionCheck::push() {
    m_found.strongestPush = std::max(m_found.strongestPush, m_push);
    m_pushed = true;
    m_rest.restart();
    servo::LoadTrajectory load;
    load.servo = false;
    load.pwm = m_push;
    load.reverse = m_reverse;
    const ReadStatus read{StatusItems(StatusItems::Position | StatusItems::Aux)};
    return send(orders({off(true), load, StartMotion{}, read, read, read, read, off(true), off(false)}));
}

DirectionCheck::Next DirectionCheck::conclude(DirectionVerdict verdict, const ModuleState& module) {
    const servo::StatusByte status = module.latest->servoStatus();
    m_found.verdict = verdict;
    m_found.limit1 = status.limit1();
    m_found.limit2 = status.limit2();
    m_report.direction = m_found;
    m_report.stage = ProcedureStage::Stopping;
    m_concluded = true;
    return send(orders({off(false)}));
}

std::vector<bus::Order> DirectionCheck::lastWord(const ModuleState& module) const {
    return m_pushed && !module.servoOn() ? orders({off(false)}) : std::vector<bus::Order>{};
}

}  // namespace nmc

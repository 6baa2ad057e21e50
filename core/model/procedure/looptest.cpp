// SPDX-License-Identifier: MIT
#include "model/procedure/looptest.h"

#include <cstdlib>
#include <utility>

#include "model/intent/homingplan.h"
#include "model/intent/looptestplan.h"
#include "module/profiledload.h"

namespace nmc {

namespace {

/// The time for a hold to calm a motor that has gone too far.
constexpr Duration kCalmWithin = std::chrono::milliseconds(500);

/// Reaches the goal of the longest step in one tick. The largest loadable values would do so too, but their
/// sum would exceed the chip's 32 bits.
constexpr std::uint32_t kInOneTick = 4'096U << 16U;
static_assert(kInOneTick >= std::uint32_t{kLongestStep} << 16U);
constexpr ServoPace kQuickestPace{CountsPerTick(kInOneTick), CountsPerTickSquared(kInOneTick)};

}  // namespace

ResponseMethod LoopTest::methodOf(ResponseMethod wanted, const ModuleState& module) {
    const bool keepsVelocity = hasPathBuffer(module.info.identity);
    return keepsVelocity && wanted == ResponseMethod::Profile ? ResponseMethod::StopHere : wanted;
}

LoopTest::Next LoopTest::proceed(const ModuleState& module, TimePoint now) {
    if (const auto failure = trouble(module))
        return fail(*failure);
    if (m_arms)
        return start(module);
    if (m_report.stage == ProcedureStage::Preparing)
        return prepare(module, now);
    return m_report.stage == ProcedureStage::Moving ? goOn(module, now) : settle(module, now);
}

std::optional<ProcedureFailure> LoopTest::trouble(const ModuleState& module) const {
    if (module.silent)
        return ProcedureFailure::ModuleUnresponsive;
    if (m_limited && module.homing.state() == HomeWatch::State::Tripped)
        return ProcedureFailure::StoppedShort;
    return module.servoOn() ? std::nullopt : std::optional(ProcedureFailure::WentOff);
}

void LoopTest::whileItLasts(const ModuleState& module) {
    if (const auto failure = trouble(module))
        std::ignore = fail(*failure);
    else if (goneTooFar(module))
        std::ignore = fail(ProcedureFailure::TravelLimit);
}

LoopTest::Next LoopTest::prepare(const ModuleState& module, TimePoint now) {
    if (auto next = beforeStandstill(module))
        return std::move(*next);
    if (!m_rest.over(module, now))
        return m_rest.lasted(now) > kStillWithin ? fail(ProcedureFailure::NotStill) : Next(Wait{});
    return start(module);
}

LoopTest::Next LoopTest::start(const ModuleState& module) {
    // Due if the motor has left a closed limit switch; while a procedure runs, nothing else arms it.
    const auto arm = limitStopDue(module);
    m_arms = arm && !m_arms;
    if (m_arms)
        return send(orders({limitStop(*arm)}));
    // The state may have changed during the wait for standstill.
    if (!module.goal() || !module.gains)
        return fail(ProcedureFailure::Refused);
    m_stood = *module.latest->position;
    m_from = *module.goal();
    m_limited = module.homing.state() == HomeWatch::State::Armed && module.homing.stops();
    Next next = begin(module);
    if (!std::holds_alternative<Send>(next))
        return next;
    m_report.stage = ProcedureStage::Moving;
    m_mayRun = true;
    return next;
}

std::vector<bus::Order> LoopTest::jump(const ModuleState& module, std::int32_t goal, ResponseMethod method,
                                       const std::optional<ServoPace>& pace) const {
    if (method == ResponseMethod::StopHere)
        return orders({servo::StopMotor{module.amplifierKept(), servo::StopManner::Here, Counts(goal)}});
    const auto [velocity, acceleration] = pace.value_or(kQuickestPace);
    return orders({profiledLoad(velocity, acceleration, goal), StartMotion{}});
}

LoopTest::Next LoopTest::conclude(const ModuleState& module, std::int32_t goal) {
    m_report.stage = ProcedureStage::Stopping;
    m_rest.restart();
    m_heldAt.reset();
    std::vector<bus::Order> both = hold(module);
    if (module.info.identity.version >= servo::kStopHereVersion)
        both.push_back(jump(module, goal, ResponseMethod::StopHere).front());
    return send(std::move(both));
}

std::optional<LoopTest::Next> LoopTest::record(const ModuleState& module, TimePoint now,
                                               const ResponseTaken& taken) {
    if (module.motionCommandedAt != taken.at)
        return overtaken();
    if (module.goal() != taken.goal)  // an SC that observes its limits
        return fail(ProcedureFailure::StoppedShort);
    if (goneTooFar(module))
        return fail(ProcedureFailure::TravelLimit);
    return toSeconds(now - taken.at) < taken.record ? std::optional(Next(Wait{})) : std::nullopt;
}

/// Something else moves the motor, or has stopped it.
LoopTest::Next LoopTest::overtaken() {
    m_mayRun = false;
    cancel();
    return Wait{};
}

LoopTest::Next LoopTest::settle(const ModuleState& module, TimePoint now) {
    if (!m_heldAt)
        m_heldAt = module.motionCommandedAt;
    if (m_heldAt != module.motionCommandedAt)
        return overtaken();
    if (m_rest.over(module, now))
        return settled(module, true);
    if (m_rest.lasted(now) <= kStillWithin)
        return Wait{};
    if (swingsFar(module))
        return fail(ProcedureFailure::TravelLimit);
    m_mayRun = false;  // the stop has been sent
    return settled(module, false);
}

LoopTest::Next LoopTest::settled(const ModuleState& /*module*/, bool stands) {
    return stands ? finish() : fail(ProcedureFailure::NotStill);
}

/// True when the oscillation exceeds the hunting that a fine encoder and an integral can cause.
bool LoopTest::swingsFar(const ModuleState& module) const {
    const auto& swing = module.swing.swing();
    return swing && swing->amplitude > std::abs(span()) / 4.0;
}

std::vector<bus::Order> LoopTest::lastWord(const ModuleState& module) const {
    // To a servo that is off, the hold would switch it on.
    return m_mayRun && module.servoOn() ? hold(module) : std::vector<bus::Order>{};
}

/// The reason why a chip ended a sine shows only now. An oscillation that a hold does not calm is kept up by
/// the servo itself.
LoopTest::Next LoopTest::afterLastWord(const ModuleState& module, TimePoint now) {
    if (m_report.failure == ProcedureFailure::Refused)
        m_report.failure = trouble(module).value_or(ProcedureFailure::Refused);
    const bool wild = m_report.failure == ProcedureFailure::TravelLimit ||
                      m_report.failure == ProcedureFailure::NotFollowing;
    if (!m_mayRun || !module.servoOn() || !wild)
        return End{};
    if (!std::exchange(m_calming, true))
        m_rest.restart();
    if (m_rest.over(module, now))
        return End{};
    if (m_rest.lasted(now) < kCalmWithin)
        return Wait{};
    m_mayRun = false;
    m_report.failure = ProcedureFailure::Unstable;
    return send(orders({servo::StopMotor{false, servo::StopManner::MotorOff, {}}}));
}

std::vector<bus::Order> LoopTest::hold(const ModuleState& module) const {
    return orders({servo::StopMotor{module.amplifierKept(), servo::StopManner::Abruptly, {}}});
}

}  // namespace nmc

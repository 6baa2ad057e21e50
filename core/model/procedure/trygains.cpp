// SPDX-License-Identifier: MIT
#include "model/procedure/trygains.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/intent/gainsplan.h"

namespace nmc {

namespace {
/// Fraction of EL: a servo that is this far off is about to trip.
constexpr double kOfErrorLimit = 0.5;
constexpr double kOfOutputLimit = 0.25;
/// PWM counts beyond those that hold the load.
constexpr double kToSpare = 32;

/// Upper bound of the PWM counts that hold the load, by the present gains; all of them where that is unknown.
double holding(const ModuleState& module) {
    const servo::SetGain& gains = *module.gains;
    const auto goal = module.goal();
    if (!goal)
        return gains.ol;
    const auto error = std::abs(static_cast<double>(countsBetween(*module.latest->position, *goal)));
    return (gains.kp * error + 1.0 * gains.ki * gains.il) / 256;
}
}  // namespace

TryGainsRun::TryGainsRun(const intent::TryGains& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::TryGains),
      m_wanted(gainsFor(module, wanted.gains)),
      m_before(*module.gains),
      m_seconds(wanted.seconds) {
    m_report.gains = m_before;
}

void TryGainsRun::keep() {
    if (m_report.stage != ProcedureStage::Trying)
        return;
    m_keeps = true;
    m_report.gains = m_wanted;
    awaitEnd();
}

bool TryGainsRun::take(const servo::SetGain& gains) {
    if (!m_keeps || ends())
        return false;
    m_report.gains = m_wanted = gains;
    m_report.kept = true;  // whatever the end of the trial
    return true;
}

TryGainsRun::Next TryGainsRun::proceed(const ModuleState& module, TimePoint /*now*/) {
    if (m_sent)
        return m_sent == m_wanted ? finish() : sendWanted();
    if (m_report.stage == ProcedureStage::Trying)
        return conclude(tried().value_or(bus::TrialEnd::TimeOver));
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (!module.servoOn())
        return fail(ProcedureFailure::WentOff);
    if (module.latestTime - module.motionCommandedAt < SwingWatch::kCalm)
        return Wait{};  // the aftermath of the last motion would be taken for an oscillation
    m_report.stage = ProcedureStage::Trying;
    servo::SetGain tried = m_wanted;
    tried.ol = static_cast<std::uint8_t>(std::min<double>(
        m_wanted.ol, std::max(kOfOutputLimit * m_wanted.ol, std::ceil(holding(module) + kToSpare))));
    return tryOut(set(tried), {.back = m_before,
                               .stood = *module.latest->position,
                               .reach = kOfErrorLimit * std::min(m_before.el, m_wanted.el),
                               .lasts = fromSeconds(m_seconds)});
}

void TryGainsRun::whileItLasts(const ModuleState& module) {
    if (module.silent)
        std::ignore = fail(ProcedureFailure::ModuleUnresponsive);
}

TryGainsRun::Next TryGainsRun::sendWanted() {
    m_sent = m_wanted;
    return send({set(m_wanted)});
}

TryGainsRun::Next TryGainsRun::conclude(bus::TrialEnd end) {
    if (m_report.kept)
        return sendWanted();
    switch (end) {
        case bus::TrialEnd::Kept:  // dealt with above
        case bus::TrialEnd::TimeOver:
            return finish();
        case bus::TrialEnd::Swings:
            return fail(ProcedureFailure::Swings);
        case bus::TrialEnd::Saturates:
            return fail(ProcedureFailure::Saturates);
        case bus::TrialEnd::TooFar:
            return fail(ProcedureFailure::TravelLimit);
        case bus::TrialEnd::WentOff:
            return fail(ProcedureFailure::WentOff);
    }
    return finish();
}

/// If the trial has ended by itself, the old gains are already back. If the new gains were kept but another
/// command came first, they are still in force with a lower output limit.
std::vector<bus::Order> TryGainsRun::lastWord(const ModuleState& /*module*/) const {
    if (m_report.kept)
        return {set(m_wanted)};
    const bool sent = m_report.stage == ProcedureStage::Trying;
    return sent && !tried() ? std::vector{set(m_before)} : std::vector<bus::Order>{};
}

/// The first attempt to send all of OL may have failed, and the last word not.
TryGainsRun::Next TryGainsRun::afterLastWord(const ModuleState& module, TimePoint /*now*/) {
    if (!m_report.failure || !m_report.kept || module.gains != m_wanted)
        return End{};
    m_report.failure.reset();
    return finish();
}

bus::Order TryGainsRun::set(const servo::SetGain& gains) const {
    return {m_report.module, ServoCommand(gains)};
}

}  // namespace nmc

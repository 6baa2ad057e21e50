// SPDX-License-Identifier: MIT
#include "model/procedure/trygains.h"

#include <algorithm>
#include <cstdlib>

#include "model/intent/gainsplan.h"

namespace nmc {

namespace {
/// Counts to either side of where it stood, from which on a swing counts: samples miss the peaks of one of 8.
/// A good servo that creeps by a few, for friction and Ki, does not come by from both sides.
constexpr double kGate = 6.0;
constexpr int kTurns = 2;  ///< three half cycles
/// Of EL: a servo that is that far off is on its way to trip.
constexpr int kOfErrorLimit = 2;
/// A link that has gone bad may be good again by then.
constexpr Duration kBackWithin = std::chrono::seconds(3);
}  // namespace

TryGainsRun::TryGainsRun(const intent::TryGains& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::TryGains),
      m_wanted(gainsFor(module, wanted.gains)),
      m_before(*module.gains),
      m_seconds(wanted.seconds),
      m_stood(*module.latest->position) {}

TryGainsRun::Next TryGainsRun::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (!module.servoOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Preparing) {
        if (module.latestTime - module.motionCommandedAt < SwingWatch::kCalm)
            return Wait{};  // the net would not see it yet
        m_report.stage = ProcedureStage::Trying;
        return send(set(m_wanted));
    }
    return m_report.stage == ProcedureStage::Trying ? watch(module, now) : finish();
}

TryGainsRun::Next TryGainsRun::watch(const ModuleState& module, TimePoint now) {
    if (!m_until)
        m_until = now + fromSeconds(m_seconds);
    if (m_report.kept)
        return finish();
    if (module.swing.turnsAbout(m_stood, kGate) >= kTurns)
        return fail(ProcedureFailure::Swings);
    if (goneTooFar(module))
        return fail(ProcedureFailure::TravelLimit);
    if (now < *m_until)
        return Wait{};
    m_report.stage = ProcedureStage::Stopping;
    return send(set(m_before));
}

bool TryGainsRun::goneTooFar(const ModuleState& module) const {
    return std::abs(countsBetween(m_stood, *module.latest->position)) >
           std::min(m_before.el, m_wanted.el) / kOfErrorLimit;
}

std::vector<bus::Order> TryGainsRun::lastWord(const ModuleState& /*module*/) const {
    return mayBeInForce() ? set(m_before) : std::vector<bus::Order>{};
}

/// Until the module has confirmed those from before, or has others by now; one that has restarted has none.
TryGainsRun::Next TryGainsRun::afterLastWord(const ModuleState& module, TimePoint now) {
    m_backSince = m_backSince.value_or(now);
    const bool others = module.awaited || (module.gains != m_before && module.gains != m_wanted);
    if (!mayBeInForce() || outcome() == bus::Outcome::Done || others || now - *m_backSince > kBackWithin)
        return End{};
    return send(set(m_before));
}

bool TryGainsRun::mayBeInForce() const {
    return m_report.stage != ProcedureStage::Preparing && !m_report.kept;
}

std::vector<bus::Order> TryGainsRun::set(const servo::SetGain& gains) const {
    return {{m_report.module, ServoCommand(gains)}};
}

}  // namespace nmc

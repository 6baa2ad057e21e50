// SPDX-License-Identifier: MIT
#include "bus/stoptarget.h"

#include "bus/standstill.h"

namespace nmc::bus {

namespace {

/// Number of consecutive unanswered stops after which the module is queried.
constexpr unsigned kStopsInVain = 2;

/// The velocity item has no fraction: slow motion shows only in the position.
[[nodiscard]] bool standsStill(const StatusReport& report, ModuleType type,
                               const std::optional<std::int32_t>& before) {
    if (showsMotion(type, report))
        return false;
    return type != ModuleType::Servo || !before || samePlace(*report.position, *before);
}

/// Items that show whether the module stands still; `second`: also in a reply of different length.
[[nodiscard]] StatusItems standstillItems(ModuleType type, bool second) {
    const StatusItems more = second ? kIdentityItems : StatusItems();
    switch (type) {
        case ModuleType::Servo:
            return more | StatusItems(StatusItems::Position | StatusItems::Velocity | StatusItems::Aux);
        case ModuleType::Stepper:
            return more | StatusItems(StatusItems::Position | StatusItems::Inputs);
        case ModuleType::Io:
            return more | StatusItems(StatusItems::Pins);
        case ModuleType::Adc:
            break;
    }
    return kIdentityItems;
}

}  // namespace

std::optional<ModuleCommand> stopFor(const Belief& belief, StopManner manner) {
    const ModuleType type = belief.info().identity.type;
    switch (type) {
        case ModuleType::Servo:
            if (belief.mayBeOn())
                return stopMotor(type, manner, !belief.amplifierOff());
            if (belief.pwmMayRun() || belief.pwmUnknown())
                return stopMotor(type, StopManner::Off, false);
            return std::nullopt;
        case ModuleType::Stepper:
            // On a module in an unknown state, a stop would lower AMP_EN, so it is queried first.
            if (belief.mayBeOn() || (belief.statusTime() && belief.mayMove()))
                return stopMotor(type, manner, belief.mayBeOn());
            return std::nullopt;
        case ModuleType::Io:
            if (const auto stop = belief.outputs().stop())
                return ModuleCommand(*stop);
            return std::nullopt;
        case ModuleType::Adc:
            break;
    }
    return std::nullopt;
}

std::optional<ModuleCommand> StopTarget::stop(const Belief& belief) const {
    if (m_silences == 0 || belief.statusTime())
        return stopFor(belief, m_manner);
    const bool motor = m_type == ModuleType::Servo || m_type == ModuleType::Stepper;
    return motor ? std::optional(stopMotor(m_type, StopManner::Off, false)) : std::nullopt;
}

StopTarget::StopTarget(const Belief& belief, StopManner manner)
    : m_module(belief.info().index),
      m_type(belief.info().identity.type),
      m_manner(manner),
      m_needsStop(stopFor(belief, manner).has_value()),
      m_unknown(!belief.statusTime() && !m_needsStop) {}

StopTarget::Question StopTarget::next(const Belief& belief) {
    const auto toSend = m_needsStop ? stop(belief) : std::nullopt;
    m_asked = true;
    m_asksStop = m_needsStop = toSend.has_value();
    if (m_asksStop)
        return {toSend, {}};
    m_second = !m_second;
    return {std::nullopt, standstillItems(m_type, m_second)};
}

void StopTarget::onReply(const ReplyEnd& end, const Belief& belief, TimePoint now) {
    if (!std::exchange(m_asked, false))
        return;  // it was requested before this stop was
    if (unanswered(end.result)) {
        ++m_silences;
        m_confirmed = 0;
        // Its stop may not have been received either. But a module that only fails to receive stops still
        // reports its state.
        m_inVain = m_asksStop ? m_inVain + 1 : 0;
        m_needsStop = stop(belief) && m_inVain < kStopsInVain;
        return;
    }
    m_heard = true;
    m_silences = 0;
    if (end.result == ReplyResult::Refused)
        return;
    if (!m_asksStop)
        return onLook(end.report, belief, now);
    // A PIC-I/O must take its pins low, and then its PWM outputs.
    m_needsStop = m_type == ModuleType::Io && stop(belief);
    m_lastStop = now;
}

void StopTarget::onLook(const StatusReport& report, const Belief& belief, TimePoint now) {
    const bool still =
        standsStill(report, belief.info().identity.type, m_confirmed > 0 ? m_position : std::nullopt);
    m_position = report.position;
    m_unknown = !belief.statusTime();
    m_confirmed = still ? m_confirmed + 1 : 0;
    const bool neverSent = !m_lastStop;
    const Duration patience = m_manner == StopManner::Smoothly ? kSmoothPatience : kPatience;
    const bool movesOn = !still && (!m_lastStop || now - *m_lastStop >= patience);
    // After blind stops, and if the motor continues to move, the stop is repeated if the motor is still on.
    if (stop(belief) && (neverSent || movesOn)) {
        m_needsStop = true;
        m_confirmed = 0;
    }
}

void StopTarget::onBlindSent(std::optional<Blind> certain) {
    m_needsStop = false;
    m_blind = std::move(certain);
}

}  // namespace nmc::bus

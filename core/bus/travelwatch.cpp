// SPDX-License-Identifier: MIT
#include "bus/travelwatch.h"

#include <algorithm>
#include <cmath>

#include "module/stepperspeed.h"

namespace nmc::bus {

namespace {

/// Time for a command and its reply, including the servo tick after which it takes effect.
constexpr Duration kCommand = std::chrono::milliseconds(30);

/// Direction of a motion without an end, -1 or 1; 0: there is none, or it is unknown.
[[nodiscard]] int endless(const Belief& belief, double speed) {
    if (!belief.mayMove())
        return 0;
    if (belief.info().identity.type == ModuleType::Stepper) {
        const StepperMode mode = belief.stepperMode();
        if (mode != StepperMode::VelocityProfile && mode != StepperMode::Unprofiled)
            return 0;
        return belief.runsReverse() ? -1 : 1;
    }
    if (belief.pwmUnknown())
        return 0;
    if (belief.pwmMayRun())
        return speed < 0 ? -1 : speed > 0 ? 1 : 0;
    if (!belief.velocityGoal())
        return 0;
    return belief.runsReverse() ? -1 : 1;
}

/// Deceleration of a smooth stop in counts (steps) per second squared; 0: it has no ramp. `ticks`: per
/// second.
[[nodiscard]] double rampOf(const Belief& belief, double ticks) {
    if (belief.info().identity.type == ModuleType::Stepper) {
        const StepperRegisters& registers = belief.stepperRegisters();
        return registers.accelerationTime && registers.parameters
                   ? StepperSpeed(registers.parameters->speedMode).acceleration(*registers.accelerationTime)
                   : 0.0;
    }
    const auto& acceleration = belief.servoRegisters().runningAcceleration;
    return acceleration && !belief.pwmMayRun() ? toCounts(*acceleration) * ticks * ticks : 0.0;
}

[[nodiscard]] double wayToStop(double speed, double ramp) {
    return ramp > 0.0 ? speed * speed / (2.0 * ramp) : 0.0;
}

}  // namespace

Duration TravelWatch::latency() const {
    return std::max(kLatency, m_between + kCommand);
}

void TravelWatch::measure(std::int32_t position, TimePoint latched) {
    m_between = m_reported ? latched - *m_reported : Duration{};
    m_reported = latched;
    if (m_from && latched - m_from->time < kSpeedOver)
        return;
    if (m_from)
        m_speed = countsBetween(m_from->counts, position) / toSeconds(latched - m_from->time);
    m_from = Place{latched, position};
}

std::optional<StopManner> TravelWatch::onReport(const StatusReport& report, TimePoint latched,
                                                const Belief& belief) {
    if (!report.position)
        return std::nullopt;
    measure(*report.position, latched);
    const int direction = endless(belief, m_speed);
    const auto& limit = direction < 0 ? m_limits.lowest : m_limits.highest;
    if (direction == 0 || !limit)
        return std::nullopt;
    // While SR is unknown, the shortest tick is assumed: a ramp takes the same number of counts at any tick
    // length, and the motor covers the most distance before the stop arrives.
    const ServoRegisters& registers = belief.servoRegisters();
    const double ticks = ticksPerSecond(registers.servoRate.value_or(1));
    const double wanted = belief.velocityGoal() && registers.runningVelocity
                              ? toCounts(*registers.runningVelocity) * ticks
                              : 0.0;
    const double fast = std::max(std::abs(m_speed), wanted);
    const double ramp = rampOf(belief, ticks);
    const double needs = fast * toSeconds(latency()) + wayToStop(fast, ramp);
    if ((static_cast<double>(*limit) - *report.position) * direction > needs)
        return std::nullopt;
    return belief.pwmMayRun() ? StopManner::Off : ramp > 0.0 ? StopManner::Smoothly : StopManner::Abruptly;
}

bool TravelWatch::mayRunOn(bool reverse, double velocity, const Belief& belief) const {
    const auto& limit = reverse ? m_limits.lowest : m_limits.highest;
    if (!limit || !belief.position())
        return false;
    const double room = (static_cast<double>(*limit) - *belief.position()) * (reverse ? -1 : 1);
    const double fast = std::max(std::abs(m_speed), velocity);
    const double ramp = rampOf(belief, ticksPerSecond(belief.servoRegisters().servoRate.value_or(1)));
    return room > fast * toSeconds(2 * latency()) + wayToStop(fast, ramp);
}

}  // namespace nmc::bus

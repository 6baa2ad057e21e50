// SPDX-License-Identifier: MIT
#include "bus/holdlane.h"

#include <algorithm>

namespace nmc::bus {

void HoldLane::end(std::uint32_t press) {
    m_over = std::max(press, m_over.value_or(press));
}

void HoldLane::refuse(const HoldToMove& hold) {
    end(hold.press);
}

void HoldLane::hold(const HoldToMove& hold, TimePoint now) {
    if (m_over && hold.press <= *m_over)
        return;
    if (m_wanted && m_wanted->module != hold.module)
        release();
    m_wanted = hold;
    if (m_told)
        m_told->press = hold.press;  // the same motion need not be told twice
    m_until = now + m_timeout;
}

void HoldLane::release() {
    if (m_wanted)
        end(m_wanted->press);
    m_wanted.reset();
    if (m_told)
        m_owed = m_told;
    m_told.reset();
}

bool HoldLane::expired(TimePoint now) {
    if (!m_wanted || now < m_until)
        return false;
    release();
    return true;
}

void HoldLane::clear() {
    if (m_wanted)
        end(m_wanted->press);
    m_wanted.reset();
    m_told.reset();
    m_owed.reset();
}

std::optional<TimePoint> HoldLane::deadline() const {
    return m_wanted ? std::optional(m_until) : std::nullopt;
}

std::optional<Step> HoldLane::start() const {
    if (!m_wanted || m_wanted == m_told)
        return std::nullopt;
    if (m_wanted->pace) {
        step::LoadTrajectory load;
        load.speed = m_wanted->pace->speed;
        load.accelerationTime = m_wanted->pace->accelerationTime;
        load.reverse = m_wanted->reverse;
        load.startNow = true;
        return Step{m_wanted->module, StepCommand(load)};
    }
    servo::LoadTrajectory load;
    load.velocity = m_wanted->velocity;
    load.acceleration = m_wanted->acceleration;
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = m_wanted->reverse;
    load.startNow = true;
    return Step{m_wanted->module, ServoCommand(load)};
}

std::optional<Step> HoldLane::stop() const {
    if (!m_owed)
        return std::nullopt;
    if (m_owed->pace)
        return Step{m_owed->module, StepCommand(step::StopMotor{true, step::StopManner::Smoothly})};
    // With acceleration 0 the chip cannot slow down (link.md 2.6).
    const auto manner =
        m_owed->acceleration.value() == 0 ? servo::StopManner::Abruptly : servo::StopManner::Smoothly;
    return Step{m_owed->module, ServoCommand(servo::StopMotor{true, manner, {}})};
}

}  // namespace nmc::bus

// SPDX-License-Identifier: MIT
#include "bus/holdlane.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

void HoldLane::end(std::uint32_t press) {
    m_over = std::max(press, m_over.value_or(press));
}

void HoldLane::hold(const HoldToMove& hold, TimePoint now) {
    if (over(hold.press))
        return;
    m_wanted = hold;
    if (m_sent)
        m_sent->press = hold.press;  // the same motion need not be sent twice
    m_until = now + m_timeout;
}

std::optional<HoldToMove> HoldLane::release() {
    if (m_wanted)
        end(m_wanted->press);
    m_wanted.reset();
    return std::exchange(m_sent, std::nullopt);
}

void HoldLane::clear() {
    (void)release();
}

std::optional<TimePoint> HoldLane::deadline() const {
    return m_wanted ? std::optional(m_until) : std::nullopt;
}

std::optional<Order> HoldLane::start() const {
    if (!m_wanted || m_wanted == m_sent)
        return std::nullopt;
    const std::optional<Counts> goal = m_wanted->goal ? std::optional<Counts>(*m_wanted->goal) : std::nullopt;
    if (m_wanted->pace) {
        stepper::LoadTrajectory load;
        load.position = goal;
        load.speed = m_wanted->pace->speed;
        load.accelerationTime = m_wanted->pace->accelerationTime;
        load.reverse = !goal && m_wanted->reverse;
        load.startNow = !goal;
        return Order{m_wanted->module, StepperCommand(load)};
    }
    servo::LoadTrajectory load;
    load.velocity = m_wanted->velocity;
    load.acceleration = m_wanted->acceleration;
    load.position = goal;
    load.profile = goal ? servo::ProfileMode::Trapezoidal : servo::ProfileMode::Velocity;
    load.reverse = !goal && m_wanted->reverse;
    load.startNow = !goal;
    return Order{m_wanted->module, ServoCommand(load)};
}

Order HoldLane::startLoaded() const {
    if (m_wanted->pace)
        return {m_wanted->module, StepperCommand(StartMotion{})};
    return {m_wanted->module, ServoCommand(StartMotion{})};
}

}  // namespace nmc::bus

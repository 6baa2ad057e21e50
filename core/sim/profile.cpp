// SPDX-License-Identifier: MIT
#include "sim/profile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace nmc::sim {

namespace {

std::int64_t wrap48(std::int64_t value) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(value) << 16U) >> 16;
}

std::int64_t fine(std::int32_t counts) {
    return std::int64_t{counts} * 65536;
}

}  // namespace

std::int64_t stoppingVelocity(std::int64_t distance, std::int64_t acceleration) {
    // Stopping from v takes n+1 ticks, which cover (n+1)v - a n(n+1)/2. The smallest n with distance <=
    // a(n+1)(n+2)/2 makes the last velocity at most a, so that the stop itself is also within the
    // acceleration.
    const auto reach = [acceleration](std::int64_t n) { return acceleration * ((n + 1) * (n + 2) / 2); };
    const double ratio = static_cast<double>(distance) / static_cast<double>(acceleration);
    std::int64_t n = static_cast<std::int64_t>((std::sqrt(1.0 + 8.0 * ratio) - 3.0) * 0.5);
    n = std::max<std::int64_t>(n, 0);
    while (reach(n) < distance)
        ++n;
    while (n > 0 && reach(n - 1) >= distance)
        --n;
    return (2 * distance + acceleration * (n * (n + 1))) / (2 * (n + 1));
}

void Profile::follow(std::int32_t position, std::int32_t countsPerTick) {
    m_mode = Mode::Hold;
    m_position = fine(position);
    m_velocity = fine(countsPerTick);
    m_done = true;
    m_accelerating = false;
    m_slewing = true;
}

void Profile::hold(std::int32_t position) {
    follow(position, 0);
}

void Profile::rename(std::int32_t position) {
    m_position = fine(position);
}

void Profile::shift(std::int32_t counts) {
    m_position = wrap48(m_position + fine(counts));
}

void Profile::startTrapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration,
                             Start start) {
    m_mode = Mode::Trapezoidal;
    m_goalPosition = fine(goal);
    m_goalVelocity = velocity;
    m_acceleration = acceleration;
    m_halfInverseAcceleration = acceleration == 0 ? 0.0 : 0.5 / static_cast<double>(acceleration);
    if (start == Start::AtZero)
        m_velocity = 0;
    m_done = m_position == m_goalPosition && m_velocity == 0;
    m_accelerationDone = m_done;
    m_slewDone = m_done;
}

void Profile::startVelocity(std::int64_t goalVelocity, std::uint32_t acceleration) {
    m_mode = Mode::Velocity;
    m_goalVelocity = goalVelocity;
    m_acceleration = acceleration;
    m_done = m_velocity == m_goalVelocity;
    m_accelerationDone = false;
    m_slewDone = false;
}

void Profile::stopAbruptly() {
    m_mode = Mode::Velocity;
    m_velocity = 0;
    m_goalVelocity = 0;
    m_done = true;
}

void Profile::stopSmoothly() {
    m_mode = Mode::Velocity;
    m_goalVelocity = 0;
    m_done = m_velocity == 0;
}

void Profile::stepPath(std::int64_t velocity) {
    const std::int64_t before = std::abs(m_velocity);
    m_mode = Mode::Path;
    m_velocity = velocity;
    m_position = wrap48(m_position + m_velocity);
    m_done = false;
    m_accelerating = std::abs(m_velocity) > before;
    m_slewing = std::abs(m_velocity) == before;
}

void Profile::endPath() {
    m_mode = Mode::Hold;
    m_velocity = 0;
    m_done = true;
}

int Profile::direction() const {
    const auto sign = [](std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; };
    if (m_velocity != 0)
        return sign(m_velocity);
    switch (m_mode) {
        case Mode::Hold:
        case Mode::Path:
            return 0;
        case Mode::Trapezoidal:
            return m_done ? 0 : sign(wrap48(m_goalPosition - m_position));
        case Mode::Velocity:
            return sign(m_goalVelocity);
    }
    return 0;
}

void Profile::step() {
    const std::int64_t before = std::abs(m_velocity);
    if (m_mode == Mode::Trapezoidal && !m_done)
        stepTrapezoid();
    else if (m_mode == Mode::Velocity)
        stepVelocity();
    m_accelerating = std::abs(m_velocity) > before;
    m_slewing = std::abs(m_velocity) == before;
}

std::int64_t Profile::approach(std::int64_t distance, std::int64_t wanted) const {
    // Stopping from w takes at most w^2/2a + w/2 + a/8. Far from the goal, this test decides without a square
    // root.
    const double w = static_cast<double>(wanted);
    const double enough = w * w * m_halfInverseAcceleration + w + static_cast<double>(m_acceleration);
    if (static_cast<double>(distance) > enough)
        return wanted;
    return std::min(wanted, stoppingVelocity(distance, m_acceleration));
}

void Profile::stepTrapezoid() {
    if (m_acceleration == 0) {  // without acceleration the move never starts, or never ends
        m_position = wrap48(m_position + m_velocity);
        return;
    }
    const std::int64_t signedDistance = wrap48(m_goalPosition - m_position);
    const std::int64_t sign = signedDistance < 0 ? -1 : 1;
    const std::int64_t distance = signedDistance * sign;
    const std::int64_t speed = m_velocity * sign;

    const std::int64_t wanted = std::max<std::int64_t>(0, std::min(speed + m_acceleration, m_goalVelocity));
    const std::int64_t target = approach(distance, wanted);
    // From the wrong direction, it takes several ticks to reach the target velocity.
    const std::int64_t next = std::min(std::max(target, speed - m_acceleration), speed + m_acceleration);

    m_accelerationDone = m_accelerationDone || next < speed + m_acceleration || next >= m_goalVelocity;
    m_slewDone = m_slewDone || (m_accelerationDone && next < m_goalVelocity);
    m_velocity = next * sign;
    m_position = wrap48(m_position + m_velocity);
    if (m_position == m_goalPosition && std::abs(next) <= m_acceleration) {
        m_velocity = 0;
        m_done = true;
        m_accelerationDone = true;
        m_slewDone = true;
    }
}

void Profile::stepVelocity() {
    m_velocity = std::clamp(m_goalVelocity, m_velocity - m_acceleration, m_velocity + m_acceleration);
    m_position = wrap48(m_position + m_velocity);
    m_done = m_velocity == m_goalVelocity;
}

}  // namespace nmc::sim

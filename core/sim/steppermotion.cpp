// SPDX-License-Identifier: MIT
#include "sim/steppermotion.h"

#include <algorithm>

namespace nmc::sim {

namespace {

/// DS-S 4.2: acceleration times are in units of 0.25 ms.
constexpr std::int64_t kAccelerationUnit = 250'000;

constexpr std::int64_t dividedUp(std::int64_t value, std::int64_t by) {
    return (value + by - 1) / by;
}

}  // namespace

// ---- Starting and stopping ----

bool StepperMotion::wouldReverse(StepperMode goal, const StepperTrajectory& loaded) const {
    if (!hasGoal(goal))
        return loaded.has(StepperTrajectory::kReverse);
    if (isMoving())
        return m_reverse;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(loaded.position) - m_position) < 0;
}

void StepperMotion::start(StepperMode goal, const StepperTrajectory& loaded) {
    const StepperMode from = m_mode;
    const bool fresh = from == StepperMode::Stopped;
    const bool wasRamping = from == StepperMode::Velocity && isRamping();
    if (fresh) {
        m_reverse = wouldReverse(goal, loaded);
        m_phase = 0;
        m_goal = static_cast<std::uint32_t>(loaded.position);
        if (hasGoal(goal) && m_goal == m_position)  // it goes nowhere
            return;
    }
    m_mode = goal;
    m_slowingDown = m_peaked = m_stopAtMinimum = false;
    m_perSpeed = kAccelerationUnit * loaded.accelerationTime;
    if (!isProfiled() || loaded.has(StepperTrajectory::kTimer)) {
        m_speed = std::max<unsigned>(loaded.nearestSpeed, 1);
    }
    if (!isProfiled()) {
        setRate(rateOfCount(m_speedMode, loaded.timerCount));
        m_count = loaded.timerCount;
        return;
    }
    m_commanded = std::max(loaded.speed, m_minimum);
    m_toNextSpeed = wasRamping ? std::min(m_toNextSpeed, m_perSpeed) : m_perSpeed;
    setSpeed(fresh ? m_minimum : m_speed);
}

void StepperMotion::stopAbruptly() {
    m_mode = StepperMode::Stopped;
    m_phase = 0;
}

/// "Effectively setting the goal speed to zero": whatever the mode was, it is now a velocity profile, which
/// ignores a trapezoid's goal.
void StepperMotion::stopSmoothly() {
    if (!isMoving() || m_stopAtMinimum)
        return;
    m_mode = StepperMode::Velocity;
    m_commanded = m_minimum;
    m_stopAtMinimum = true;
    m_toNextSpeed = m_perSpeed;
    if (m_speed <= m_minimum)
        return stopAbruptly();
    setSpeed(m_speed);
}

void StepperMotion::resetPosition() {
    m_position = 0;
    if (hasGoal(m_mode) && m_position == m_goal)
        stopAbruptly();
}

// ---- Running ----

Duration StepperMotion::advance(Duration time) {
    std::int64_t left = time.count();
    while (left > 0 && isMoving()) {
        if (m_mode == StepperMode::Trapezoidal && !m_slowingDown && m_speed > m_minimum &&
            phaseToGoal() <= phaseToSlowDown(m_speed))
            beginSlowingDown();
        const std::int64_t stretch = std::min(left, timeToNextEvent());
        makeSteps(stretch);
        left -= stretch;
        if (hasGoal(m_mode) && m_position == m_goal) {
            stopAbruptly();
        } else if (isRamping()) {
            m_toNextSpeed -= stretch;
            if (m_toNextSpeed <= 0)
                changeSpeed();
        }
    }
    return Duration(left);
}

bool StepperMotion::isRamping() const {
    if (m_mode == StepperMode::Velocity)
        return m_speed != m_commanded;
    if (m_mode != StepperMode::Trapezoidal)
        return false;
    return m_slowingDown ? m_speed > m_minimum : m_speed < m_commanded && !m_peaked;
}

std::int64_t StepperMotion::timeToNextEvent() const {
    std::int64_t time = Duration::max().count();
    if (isRamping())
        time = m_toNextSpeed;
    if (hasGoal(m_mode)) {
        const std::int64_t toGoal = phaseToGoal();
        time = std::min(time, dividedUp(toGoal, m_rate.weight));
        if (m_mode == StepperMode::Trapezoidal && !m_slowingDown && m_speed > m_minimum)
            time = std::min(time, dividedUp(toGoal - phaseToSlowDown(m_speed), m_rate.weight));
    }
    return time;
}

std::int64_t StepperMotion::phaseToGoal() const {
    const std::uint32_t steps = m_reverse ? m_position - m_goal : m_goal - m_position;
    return std::int64_t{steps} * m_rate.perStep - m_phase;
}

/// One acceleration time at each of the lower speeds, as when ramping up.
std::int64_t StepperMotion::phaseToSlowDown(std::int64_t speed) const {
    const std::int64_t minimum = m_minimum;
    return m_perSpeed * ((speed - minimum) * (speed - 1 + minimum) / 2);
}

void StepperMotion::makeSteps(std::int64_t nanoseconds) {
    const std::int64_t phase = m_phase + nanoseconds * m_rate.weight;
    const std::int64_t steps = m_reverse ? -(phase / m_rate.perStep) : phase / m_rate.perStep;
    m_phase = phase % m_rate.perStep;
    m_position += static_cast<std::uint32_t>(steps);
    m_stepsMade += steps;
}

void StepperMotion::changeSpeed() {
    m_toNextSpeed = m_perSpeed;
    if (m_mode == StepperMode::Trapezoidal) {
        if (m_slowingDown)
            setSpeed(m_speed - 1);
        else if (phaseToGoal() >= phaseToSlowDown(std::int64_t{m_speed} + 1))
            setSpeed(m_speed + 1);
        else
            m_peaked = true;
        return;
    }
    setSpeed(m_speed < m_commanded ? m_speed + 1 : m_speed - 1);
    if (m_stopAtMinimum && m_speed <= m_minimum)
        stopAbruptly();
}

void StepperMotion::beginSlowingDown() {
    m_slowingDown = true;
    m_toNextSpeed = m_perSpeed;
    setSpeed(m_speed - 1);
}

void StepperMotion::setSpeed(unsigned speed) {
    m_speed = speed;
    m_count = countOfSpeed(m_speedMode, speed);
    setRate(rateOfSpeed(m_speedMode, speed));
}

/// Keeps the fraction of a step already made.
void StepperMotion::setRate(StepperRate rate) {
    if (rate.perStep != m_rate.perStep)
        m_phase = m_phase * rate.perStep / m_rate.perStep;
    m_rate = rate;
}

bool StepperMotion::atCommandedSpeed() const {
    return isMoving() && !m_stopAtMinimum && (!isProfiled() || m_speed == m_commanded);
}

double StepperMotion::stepRate() const {
    if (!isMoving())
        return 0.0;
    const double rate = m_rate.stepsPerSecond();
    return m_reverse ? -rate : rate;
}

}  // namespace nmc::sim

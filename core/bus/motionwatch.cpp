// SPDX-License-Identifier: MIT
#include "bus/motionwatch.h"

#include <algorithm>
#include <cstdlib>

#include "bus/exchange.h"
#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

/// The 32 bits wrap; a motion that continues for hours does not reverse at that point.
[[nodiscard]] std::int64_t nextTo(std::int64_t before, std::int32_t position) {
    return before + countsBetween(static_cast<std::int32_t>(before), position);
}

}  // namespace

struct MotionWatch::Sent {
    MotionWatch& w;
    const ServoRegisters& sent;

    void operator()(const servo::LoadTrajectory& load) const {
        // If corrupted in transmission, the load of a trapezoidal move may start by itself; but a motor that
        // is already moving is still watched for its present motion.
        const bool underWay = w.m_heading || (w.m_corridor && (w.m_velocity != 0 || !w.m_done));
        if (load.startNow || (load.profile == servo::ProfileMode::Trapezoidal && !underWay))
            w.started(sent);
    }
    void operator()(const StartMotion&) const {
        w.started(sent);
        w.m_done = false;
    }
    void operator()(const servo::StopMotor& stop) const {
        if (stop.manner != servo::StopManner::AmplifierOnly)
            w.forget();
    }
    /// On a path, the motor follows its points, which PathTask monitors.
    void operator()(const servo::AddPathPoints&) const { w.forget(); }
    void operator()(const auto& /*other*/) const {}
};

void MotionWatch::onSent(const ModuleCommand& command, const ServoRegisters& sent) {
    if (setsCounter(command))
        forget();
    if (const auto* chip = std::get_if<ServoCommand>(&command))
        std::visit(Sent{*this, sent}, *chip);
}

void MotionWatch::started(const ServoRegisters& sent) {
    const servo::LoadTrajectory& load = sent.load;
    const int before = m_heading ? m_heading->direction : 0;
    forget();
    if (!load.servo || !m_position)
        return;
    if (load.profile == servo::ProfileMode::Trapezoidal) {
        const auto shown = static_cast<std::int32_t>(*m_position);
        // Relative to the command position, which is close to the position of a servo at rest.
        if (load.relative && load.position && m_velocity == 0)
            m_corridor = Corridor{*m_position, *m_position + load.position->value()};
        else if (sent.goal && !load.relative)
            m_corridor = Corridor{*m_position, *m_position + (std::int64_t{sent.goal->value()} - shown)};
        return;
    }
    const int direction = load.reverse ? -1 : 1;
    // If the motor still moves the other way, from an earlier run or stop, it must decelerate first: it is
    // watched once it moves in the new direction.
    const bool underWay = before == direction || m_velocity * direction >= 0;
    m_heading = Heading{direction, underWay, *m_position * direction};
}

void MotionWatch::forget() {
    m_corridor.reset();
    m_heading.reset();
    m_repeats = 0;
}

std::optional<MotionSuspect::Reason> MotionWatch::onReport(const StatusReport& report, TimePoint time,
                                                           std::optional<int> servoRate) {
    // If the servo is off but still turning, a load corrupted in transmission may have become a PWM output.
    if (report.aux && !servo::AuxByte{*report.aux}.servoOn() && report.velocity == 0)
        forget();
    m_done = report.servoStatus().moveDone();
    if (!report.position)
        return std::nullopt;
    const std::int16_t velocity = report.velocity.value_or(m_velocity);
    const bool isFrozen = frozen(report, time, servoRate);
    m_position = m_position ? nextTo(*m_position, *report.position) : *report.position;
    m_velocity = velocity;
    auto suspect = leaves(*m_position, velocity);
    if (!suspect && isFrozen)
        suspect = MotionSuspect::Reason::Frozen;
    if (suspect)
        forget();
    return suspect;
}

std::optional<MotionSuspect::Reason> MotionWatch::leaves(std::int64_t position, int velocity) {
    if (m_corridor) {
        const std::int64_t distance = m_corridor->goal - m_corridor->from;
        const std::int64_t gone = (position - m_corridor->from) * (distance < 0 ? -1 : 1);
        if (gone < -kWrongWay)
            return MotionSuspect::Reason::WrongWay;
        if (gone > std::abs(distance) + std::abs(distance) / 10 + kOvershoot)
            return MotionSuspect::Reason::Overshot;
    }
    if (m_heading) {
        const std::int64_t along = position * m_heading->direction;
        if (!m_heading->underWay) {
            m_heading->best = along;
            m_heading->underWay = velocity * m_heading->direction > 0;
        }
        m_heading->best = std::max(m_heading->best, along);
        if (along < m_heading->best - kWrongWay)
            return MotionSuspect::Reason::WrongWay;
    }
    return std::nullopt;
}

/// Two layouts may alternate, so each repeats its own position. A reply without a velocity does not say
/// whether its position ought to change, and neither does one of the same tick as the last one.
bool MotionWatch::frozen(const StatusReport& report, TimePoint time, std::optional<int> servoRate) {
    const Duration tick = fromSeconds(secondsPerTick(servoRate.value_or(kLongestServoRate)));
    if (!report.velocity || time - m_lastTime < tick)
        return false;
    m_lastTime = time;
    const LayoutPosition now{report.items.mask(), *report.position};
    const auto before = std::ranges::find(m_last, now.items, &LayoutPosition::items);
    const bool same = before != m_last.end() && before->position == now.position;
    m_last = {now, m_last[0]};
    m_repeats = same && *report.velocity != 0 ? m_repeats + 1 : 0;
    m_sum = m_repeats > 0 ? m_sum + *report.velocity : 0;
    const bool rests = m_done && !m_heading;
    return m_repeats > kFrozen && (!rests || std::abs(m_sum) > kFrozenAtRest);
}

}  // namespace nmc::bus

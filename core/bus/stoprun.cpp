// SPDX-License-Identifier: MIT
#include "bus/stoprun.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace nmc::bus {

namespace {

[[nodiscard]] bool standsStill(const StatusReport& report, ModuleType type,
                               const std::optional<std::int32_t>& before) {
    switch (type) {
        case ModuleType::Servo:
            if (!report.servoStatus().moveDone() || report.velocity.value_or(1) != 0)
                return false;
            // The velocity item has no fraction: slow motion shows in the position only.
            return !before || std::abs(std::int64_t{*report.position} - *before) <= StopRun::kStandstill;
        case ModuleType::Step:
            return !report.stepStatus().moving();
        case ModuleType::Adc:
        case ModuleType::Io:
            break;
    }
    return true;
}

}  // namespace

std::optional<ModuleCommand> stopFor(const Belief& belief) {
    switch (belief.info().identity.type) {
        case ModuleType::Servo:
            if (belief.mayBeOn())
                return ServoCommand(servo::StopMotor{true, servo::StopManner::Abruptly, {}});
            if (belief.pwmMayRun())
                return ServoCommand(servo::StopMotor{false, servo::StopManner::MotorOff, {}});
            return std::nullopt;
        case ModuleType::Step:
            if (belief.mayBeOn() || belief.mayMove())
                return StepCommand(step::StopMotor{belief.mayBeOn(), step::StopManner::Abruptly});
            return std::nullopt;
        case ModuleType::Adc:
        case ModuleType::Io:
            break;
    }
    return std::nullopt;
}

StatusItems standstillItems(ModuleType type, bool second) {
    const unsigned more = second ? StatusItems::Identity : 0U;
    switch (type) {
        case ModuleType::Servo:
            return StatusItems(static_cast<std::uint8_t>(StatusItems::Position | StatusItems::Velocity |
                                                         StatusItems::Aux | more));
        case ModuleType::Step:
            return StatusItems(static_cast<std::uint8_t>(StatusItems::Position | StatusItems::Inputs | more));
        case ModuleType::Adc:
        case ModuleType::Io:
            break;
    }
    return kIdentityItems;
}

StopRun::StopRun(const std::vector<Belief>& beliefs, const PollSchedule& schedule, TimePoint now)
    : m_began(now) {
    plan(beliefs, schedule);
}

void StopRun::restart(const std::vector<Belief>& beliefs, const PollSchedule& schedule) {
    plan(beliefs, schedule);
}

std::vector<Step> StopRun::blindStops() const {
    std::vector<Step> steps;
    for (const Target& target : m_targets)
        if (target.stop)
            steps.push_back({target.module, *target.stop});
    return steps;
}

void StopRun::onBlindSent(ModuleIndex module, std::optional<TimePoint> latched) {
    Target& sent = target(module);
    sent.stopOwed = false;
    sent.blind = latched;
}

std::optional<StopRun::Ask> StopRun::next(TimePoint now) {
    if (now - m_began >= kLimit)
        return std::nullopt;
    Target* first = nullptr;
    const auto rank = [](const Target& t) { return std::tuple(t.silences, !t.stopOwed, t.asks); };
    for (Target& target : m_targets)
        if (target.state == State::Open && (first == nullptr || rank(target) < rank(*first)))
            first = &target;
    if (first == nullptr)
        return std::nullopt;
    ++first->asks;
    m_asked = {first->module, std::nullopt, {}};
    if (first->stopOwed) {
        m_asked.stop = first->stop;
    } else {
        first->second = !first->second;
        m_asked.items = standstillItems(first->type, first->second);
    }
    return m_asked;
}

void StopRun::onReply(const ReplyEnd& end, const Belief& belief, TimePoint now) {
    Target& asked = target(m_asked.module);
    if (unanswered(end.result))
        return onSilence(asked, now);
    asked.silences = 0;
    if (end.result == ReplyResult::Refused)
        return;
    if (!m_asked.stop)
        return onLook(asked, end.report, belief, now);
    asked.stopOwed = false;
    asked.lastStop = now;
}

std::optional<TimePoint> StopRun::takeBlind(ModuleIndex module) {
    return std::exchange(target(module).blind, std::nullopt);
}

std::optional<ModuleCommand> StopRun::stopOf(ModuleIndex module) const {
    return target(module).stop;
}

StopFinished StopRun::finished(TimePoint now) const {
    StopFinished event;
    event.took = now - m_began;
    for (const Target& target : m_targets)
        (target.state == State::Stopped ? event.stopped : event.unreached).push_back(target.module);
    std::sort(event.stopped.begin(), event.stopped.end());
    std::sort(event.unreached.begin(), event.unreached.end());
    return event;
}

void StopRun::plan(const std::vector<Belief>& beliefs, const PollSchedule& schedule) {
    m_targets.clear();
    for (const Belief& belief : beliefs) {
        if (belief.restarted())
            continue;  // off by itself, and without an address
        Target target;
        target.type = belief.info().identity.type;
        target.module = belief.info().index;
        target.stop = stopFor(belief);
        target.stopOwed = target.stop.has_value();
        target.moving = belief.moving();
        target.wasSilent = schedule.silent(target.module);
        m_targets.push_back(target);
    }
    std::stable_sort(m_targets.begin(), m_targets.end(), [](const Target& a, const Target& b) {
        return std::tuple(a.wasSilent, !a.moving) < std::tuple(b.wasSilent, !b.moving);
    });
}

const StopRun::Target& StopRun::target(ModuleIndex module) const {
    return *std::find_if(m_targets.begin(), m_targets.end(),
                         [&](const Target& t) { return t.module == module; });
}

StopRun::Target& StopRun::target(ModuleIndex module) {
    return *std::find_if(m_targets.begin(), m_targets.end(),
                         [&](const Target& t) { return t.module == module; });
}

void StopRun::onSilence(Target& target, TimePoint now) const {
    ++target.silences;
    target.confirmed = 0;
    // Its stop may not have arrived either.
    target.stopOwed = target.stop.has_value();
    if (target.silences >= kSilences && (target.wasSilent || now - m_began >= kSilentFor))
        target.state = State::Unreached;
}

void StopRun::onLook(Target& target, const StatusReport& report, const Belief& belief, TimePoint now) const {
    const bool still = standsStill(report, belief.info().identity.type,
                                   target.confirmed > 0 ? target.position : std::nullopt);
    const bool neverTold = target.stop && target.lastStop == TimePoint{};
    target.position = report.position;
    target.stop = stopFor(belief);
    target.confirmed = still ? target.confirmed + 1 : 0;
    // After blind stops, and when it moves on: told again, if it is still on now.
    if (target.stop && (neverTold || (!still && now - target.lastStop >= kPatience))) {
        target.stopOwed = true;
        target.confirmed = 0;
    } else if (target.confirmed == 2) {
        target.state = State::Stopped;
    }
}

}  // namespace nmc::bus

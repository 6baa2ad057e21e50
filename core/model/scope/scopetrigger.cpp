// SPDX-License-Identifier: MIT
#include "model/scope/scopetrigger.h"

#include <algorithm>
#include <cmath>

#include "model/scope/measuredacceleration.h"

namespace nmc {

namespace {

/// NaN counts as the least value.
double bounded(double value, double least, double most) {
    return value > least ? std::min(value, most) : least;
}

/// Positions and counters have 32 bits on the chip and wrap.
bool wraps(const std::variant<ScopeSignal, ScopeBit>& source) {
    const auto* signal = std::get_if<ScopeSignal>(&source);
    if (signal == nullptr)
        return false;
    const SignalInfo::Place place = infoOf(*signal).place;
    return place == SignalInfo::Place::Position || place == SignalInfo::Place::Command ||
           place == SignalInfo::Place::Counter;
}

}  // namespace

void ScopeTrigger::set(const TriggerSettings& settings) {
    m_settings = settings;
    m_last.reset();
    disarm();
}

void ScopeTrigger::setWindow(double seconds) {
    m_settings.window = seconds;
    disarm();
}

void ScopeTrigger::arm(TimePoint now) {
    m_state = State::Armed;
    m_armedAt = now;
    m_firedAt.reset();
}

void ScopeTrigger::disarm() {
    m_state = State::Off;
    m_firedAt.reset();
}

void ScopeTrigger::forgetSamples() {
    m_samplesSince.reset();
    m_last.reset();
}

ScopeTrigger::State ScopeTrigger::feed(ModuleIndex module, const ScopeSample& sample) {
    if (!m_samplesSince)
        m_samplesSince = sample.time;
    if (module != m_settings.module)
        return m_state;
    if (!derivedSource())
        look(sample);
    if (m_state == State::Fired && reachesTheEnd(sample))
        m_state = State::Complete;
    return m_state;
}

ScopeTrigger::State ScopeTrigger::feedDerived(const ScopeSample& value) {
    look(value);
    if (m_state == State::Fired && value.time >= picture()->to)
        m_state = State::Complete;
    return m_state;
}

std::optional<ModuleSignal> ScopeTrigger::derivedSource() const {
    const auto* signal = std::get_if<ScopeSignal>(&m_settings.source);
    if (signal == nullptr || !isDerived(*signal))
        return std::nullopt;
    return ModuleSignal{m_settings.module, *signal};
}

void ScopeTrigger::look(const ScopeSample& value) {
    if (value.gapBefore)
        m_last.reset();
    const std::optional<Value> now = watched(value);
    if (m_state == State::Armed && now) {
        const auto met = conditionMet(*now);
        if (met && *met >= m_armedAt && *met - before() >= *m_samplesSince) {
            m_state = State::Fired;
            m_firedAt = met;
            m_behind = 0;
        }
    }
    m_last = now;
}

/// A derived value comes late, or not at all where it is unknown; the trigger then waits for as long as one
/// could take. None takes longer than a measured acceleration.
bool ScopeTrigger::reachesTheEnd(const ScopeSample& sample) {
    const TimePoint end = picture()->to;
    if (sample.time < end)
        return false;
    if (!derivedSource())
        return true;
    return ++m_behind > MeasuredAcceleration::kFewest && sample.time - end > MeasuredAcceleration::kTime;
}

std::optional<ScopeTrigger::Picture> ScopeTrigger::picture() const {
    if (!m_firedAt)
        return std::nullopt;
    const TimePoint from = *m_firedAt - before();
    return Picture{from, from + window()};
}

std::optional<ScopeTrigger::Value> ScopeTrigger::watched(const ScopeSample& sample) const {
    if (const auto* bit = std::get_if<ScopeBit>(&m_settings.source))
        return Value{sample.time, isSet(sample, *bit) ? 1.0 : 0.0};
    // Derived values are stored in the form of an error.
    const auto value =
        valueOf(sample, derivedSource() ? ScopeSignal::Error : std::get<ScopeSignal>(m_settings.source));
    if (!value)
        return std::nullopt;
    return Value{sample.time, *value};
}

std::optional<TimePoint> ScopeTrigger::conditionMet(const Value& now) const {
    using Condition = TriggerSettings::Condition;
    switch (m_settings.condition) {
        case Condition::Above:
            return now.value > level() ? std::optional(now.time) : std::nullopt;
        case Condition::Below:
            return now.value < level() ? std::optional(now.time) : std::nullopt;
        case Condition::Rising:
        case Condition::Falling:
            return crossing(now);
    }
    return std::nullopt;
}

std::optional<TimePoint> ScopeTrigger::crossing(const Value& now) const {
    if (!m_last)
        return std::nullopt;
    constexpr double kWrap = 4'294'967'296.0;
    const double difference = now.value - m_last->value;
    const double step = wraps(m_settings.source) ? std::remainder(difference, kWrap) : difference;
    const double toLevel = level() - m_last->value;
    const bool rising = m_settings.condition == TriggerSettings::Condition::Rising;
    const bool crossed = rising ? toLevel > 0 && step >= toLevel : toLevel < 0 && step <= toLevel;
    if (!crossed)
        return std::nullopt;
    if (std::holds_alternative<ScopeBit>(m_settings.source))
        return now.time;
    return m_last->time + fromSeconds(toSeconds(now.time - m_last->time) * (toLevel / step));
}

double ScopeTrigger::level() const {
    return std::holds_alternative<ScopeBit>(m_settings.source) ? 0.5 : m_settings.level;
}

Duration ScopeTrigger::before() const {
    return fromSeconds(toSeconds(window()) * bounded(m_settings.preTrigger, 0.0, 1.0));
}

Duration ScopeTrigger::window() const {
    constexpr double kMin = 1e-6;
    constexpr double kMax = 864'000.0;
    return fromSeconds(bounded(m_settings.window, kMin, kMax));
}

}  // namespace nmc

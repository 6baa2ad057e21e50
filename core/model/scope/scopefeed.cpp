// SPDX-License-Identifier: MIT
#include "model/scope/scopefeed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "module/commandfacts.h"

namespace nmc {

namespace {

/// A machine that is briefly busy does not cause a gap.
constexpr Duration kPatience = std::chrono::milliseconds(20);
constexpr double kRange = 4294967296.0;  ///< positions wrap around (DS-V 4.5)

}  // namespace

void ScopeFeed::apply(const bus::CommandExecuted& executed) {
    m_command.apply(executed);
    if (setsCounter(executed.command))
        m_recent.clear();
}

std::optional<ScopeSample> ScopeFeed::take(const bus::Sample& sample) {
    if (sample.report.pins)
        return takePins(sample);
    m_command.apply(sample);
    // A brief reply carries neither; they keep their last reported values.
    m_aux = sample.report.aux.value_or(m_aux);
    m_analog = sample.report.analog.value_or(m_analog);
    if (!sample.report.position)
        return std::nullopt;
    ScopeSample made;
    made.time = sample.time;
    made.position = *sample.report.position;
    made.analog = m_analog;
    made.status = sample.report.status;
    made.aux = m_aux;
    const bool wrapped =
        !m_recent.empty() && std::abs(std::int64_t{made.position} - m_recent.back().position) > INT32_MAX;
    made.gapBefore = missingBefore(sample.time) || wrapped || sample.jumped;
    if (made.gapBefore)
        m_recent.clear();
    made.velocity = velocity({made.time, made.position});
    const bool on = servo::AuxByte{m_aux}.servoOn();
    if (sample.report.positionError && on) {
        // This is reported by the chip itself for the same moment as its position.
        made.error = made.errorLow = made.errorHigh = static_cast<float>(*sample.report.positionError);
    } else if (const auto command = m_command.at(sample.time, sample.late)) {
        const double error = std::remainder(command->position - made.position, kRange);
        setError(made, {error, error + (command->low - command->position),
                        error + (command->high - command->position)});
    }
    return made;
}

/// A brief reply carries only the pins, and not every reply carries the counter.
ScopeSample ScopeFeed::takePins(const bus::Sample& sample) {
    ScopeSample made;
    made.time = sample.time;
    made.io = true;
    made.counted = sample.report.counter.has_value();
    for (std::size_t i = 0; i < m_analogs.size(); ++i)
        m_analogs.at(i) = sample.report.analogs.at(i).value_or(m_analogs.at(i));
    m_counter = sample.report.counter.value_or(m_counter);
    made.setCounter(m_counter);
    made.analog = m_analogs[0];
    made.error = m_analogs[1];
    made.velocity = m_analogs[2];
    made.status = static_cast<std::uint8_t>(*sample.report.pins & 0xFFU);
    made.aux = static_cast<std::uint8_t>(*sample.report.pins >> 8U);
    made.gapBefore = missingBefore(sample.time);
    m_recent.assign(1, {made.time, made.position});
    return made;
}

/// A servo that is on has an error of at most EL (DS-V 4.3); a larger calculated error is impossible.
void ScopeFeed::setError(ScopeSample& sample, CommandEstimate error) {
    const double most = m_command.errorLimit().value_or(std::numeric_limits<int>::max());
    if (error.low > most || error.high < -most)
        return m_command.contradicted();
    sample.error = static_cast<float>(std::clamp(error.position, -most, most));
    sample.errorLow = static_cast<float>(std::max(error.low, -most));
    sample.errorHigh = static_cast<float>(std::min(error.high, most));
}

void ScopeFeed::breakHere() {
    m_recent.clear();
    m_interval.reset();
}

bool ScopeFeed::missingBefore(TimePoint time) {
    if (m_recent.empty())
        return true;
    const Duration since = time - m_recent.back().time;
    const bool missing = m_interval && since > kMissingAfter * *m_interval + kPatience;
    // A slower pace is accepted as the usual one at once, a faster one gradually.
    m_interval = !m_interval || missing ? since : *m_interval + (since - *m_interval) / 8;
    return missing;
}

float ScopeFeed::velocity(const Place& here) {
    m_recent.push_back(here);
    while (m_recent.size() > 2 && here.time - m_recent[1].time >= kVelocityTime)
        m_recent.pop_front();
    const Place& before = m_recent.front();
    const Duration time = here.time - before.time;
    if (time < kVelocityTime)
        return ScopeSample::kUnknown;
    const auto way = static_cast<double>(std::int64_t{here.position} - before.position);
    return static_cast<float>(way / toSeconds(time));
}

}  // namespace nmc

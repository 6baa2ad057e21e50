// SPDX-License-Identifier: MIT
#include "model/procedure/frequencyrun.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "model/frequency/frequencyresponse.h"
#include "model/frequency/othergains.h"
#include "model/intent/looptestplan.h"

namespace nmc {

namespace {

constexpr double kPerDecade = 12.0;
/// Consecutive failed measurements, after which the line is at fault.
constexpr int kMisses = 3;
/// Amplitudes to either side; this is the highest resonance that is still measured.
constexpr std::int64_t kTooFar = 4;
/// Counts of amplitude; a shaft that oscillates by less is considered standing.
constexpr double kStands = 0.5;
/// Counts of amplitude; no motor falls from this to standing between two neighbouring frequencies.
constexpr double kSwings = 4.0;
/// Rms fraction of the amplitude that is not a sine: a triangle, which a motor at full PWM produces, has
/// 0.086, and a sine cut off half-way on one side has 0.138.
constexpr double kNoSine = 0.12;
/// Counts rms; friction and encoder cause this much in any small oscillation.
constexpr double kRough = 2.0;

}  // namespace

FrequencyRun::FrequencyRun(const intent::FrequencyResponse& wanted, const ModuleState& module)
    : LoopTest(ProcedureKind::FrequencyResponse, module), m_wanted(wanted) {
    const double ratio = wanted.to / wanted.from;
    const auto steps = std::max(1L, std::lround(std::log10(ratio) * kPerDecade));
    for (long i = 0; i <= steps; ++i)
        m_frequencies.push_back(wanted.from *
                                std::pow(ratio, static_cast<double>(i) / static_cast<double>(steps)));
    m_report.rounds = static_cast<unsigned>(m_frequencies.size());
}

FrequencyRun::Next FrequencyRun::begin(const ModuleState& module) {
    if (whyNot(m_wanted, module))
        return fail(ProcedureFailure::Refused);
    m_report.gains = *module.gains;
    m_ramp = rampOf(m_wanted, *module.gains);
    m_report.speed = std::abs(m_ramp);
    m_centre = from();
    return swingNext(module);
}

/// With a ramp, each sine leads back the way of the one before, which was no shorter: none leads farther away
/// than the first.
FrequencyRun::Next FrequencyRun::swingNext(const ModuleState& module) {
    const double hertz = m_frequencies[m_report.round++];
    return ride(module, {1.0 * m_wanted.amplitude, hertz, fromSeconds(sineLasts(hertz)),
                         std::exchange(m_ramp, -m_ramp)});
}

FrequencyRun::Next FrequencyRun::ride(const ModuleState& module, const bus::Sine& sine) {
    const auto centre = static_cast<std::int32_t>(std::lround(m_centre));
    m_centre += sine.velocity * toSeconds(sine.lasts);
    return swing(jump(module, centre, ResponseMethod::StopHere).front(), sine);
}

/// Ends at the position where it began.
FrequencyRun::Next FrequencyRun::goBack(const ModuleState& module) {
    const double away = from() - m_centre;
    if (std::abs(away) < 0.5)
        return conclude(module, from());
    m_goesBack = true;
    return ride(module, {0.0, 0.0, fromSeconds(std::abs(away / m_ramp)), std::copysign(m_ramp, away)});
}

FrequencyRun::Next FrequencyRun::goOn(const ModuleState& module, TimePoint /*now*/) {
    if (m_goesBack)
        return goBack(module);
    const double hertz = m_frequencies[m_report.round - 1];
    auto point = measureFrequency(swung(), hertz);
    if (!point) {  // the line, or this machine, was silent for a moment
        if (++m_missed > kMisses)
            return fail(ProcedureFailure::LinkSuspect);
        --m_report.round;
        return swingNext(module);
    }
    m_missed = 0;
    point->doubt = std::hypot(point->doubt, doubtOfWholePwm(*point, *m_report.gains, m_wanted.amplitude));
    point->limited = meetsLimits(swung(), *point, *m_report.gains, m_wanted.amplitude);
    if (!follows(*point))
        return fail(ProcedureFailure::NotFollowing);
    if (m_ramp != 0.0 &&
        std::abs(point->closed) * m_wanted.amplitude * 2 * std::numbers::pi * hertz > std::abs(m_ramp))
        return fail(ProcedureFailure::Reversed);
    m_report.frequencies.push_back(*point);
    const bool last = m_report.round == m_frequencies.size();
    if (last || m_frequencies[m_report.round] * kCommandsPerPeriod > commandsPerSecond(swung().commands))
        return goBack(module);
    return swingNext(module);
}

/// A response may fade from one frequency to the next; at the first frequency its two-sigma doubt must be at
/// most half of it.
bool FrequencyRun::follows(const FrequencyPoint& point) const {
    const auto swing = [this](const FrequencyPoint& of) { return std::abs(of.closed) * m_wanted.amplitude; };
    const bool swung = m_report.frequencies.empty() || swing(m_report.frequencies.back()) >= kSwings;
    const bool stands = swing(point) < kStands;
    const bool unsure = m_report.frequencies.empty() && point.doubt > std::abs(point.closed) / 4;
    return !(stands && swung) && !unsure && point.missed <= std::max(kRough, kNoSine * swing(point));
}

/// A motor on a ramp is compared with its command.
bool FrequencyRun::goneTooFar(const ModuleState& module) const {
    const std::int32_t around = m_ramp == 0.0 ? stood() : module.goal().value_or(stood());
    return std::abs(std::int64_t{countsBetween(around, *module.latest->position)}) >
           kTooFar * m_wanted.amplitude + kStillCounts +
               static_cast<std::int64_t>(std::abs(m_ramp) * kLongestLag);
}

}  // namespace nmc

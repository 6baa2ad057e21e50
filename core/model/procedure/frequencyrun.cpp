// SPDX-License-Identifier: MIT
#include "model/procedure/frequencyrun.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/frequency/frequencyresponse.h"
#include "model/intent/looptestplan.h"

namespace nmc {

namespace {

constexpr double kPerDecade = 12.0;
/// Duration at each frequency; the longer of the two applies. The first period lets the motor settle in.
constexpr double kPeriods = 5.0;
constexpr double kShortestSine = 1.0;  ///< s
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
    m_tick = toSeconds(kServoTick) * std::max<int>(module.gains->sr, 1);
    return swingNext(module);
}

FrequencyRun::Next FrequencyRun::swingNext(const ModuleState& module) {
    const double hertz = m_frequencies[m_report.round++];
    bus::Sine sine;
    sine.amplitude = m_wanted.amplitude;
    sine.frequency = hertz;
    sine.lasts = fromSeconds(std::max(kPeriods / hertz, kShortestSine));
    return swing(jump(module, from(), ResponseMethod::StopHere).front(), sine);
}

FrequencyRun::Next FrequencyRun::goOn(const ModuleState& module, TimePoint /*now*/) {
    const double hertz = m_frequencies[m_report.round - 1];
    auto point = measureFrequency(swung(), hertz, m_tick);
    if (!point) {  // the line, or this machine, was silent for a moment
        if (++m_missed > kMisses)
            return fail(ProcedureFailure::LinkSuspect);
        --m_report.round;
        return swingNext(module);
    }
    m_missed = 0;
    point->doubt = std::hypot(point->doubt, doubtOfWholePwm(*point, *module.gains, m_wanted.amplitude));
    if (!follows(*point))
        return fail(ProcedureFailure::NotFollowing);
    m_report.frequencies.push_back(*point);
    const bool last = m_report.round == m_frequencies.size();
    if (last || m_frequencies[m_report.round] * kCommandsPerPeriod > commandsPerSecond(swung().commands))
        return conclude(module, from());
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

bool FrequencyRun::goneTooFar(const ModuleState& module) const {
    return std::abs(std::int64_t{countsBetween(stood(), *module.latest->position)}) >
           kTooFar * m_wanted.amplitude + kStillCounts;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "model/intent/looptestplan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "bus/standstill.h"
#include "model/intent/moveforecast.h"
#include "model/intent/travel.h"

namespace nmc {

namespace {

/// Preconditions of every loop test: a servo that holds with known gains, whose position error may be `error`
/// counts, and which may move to `low` and `high` counts off the position that it holds.
[[nodiscard]] std::optional<Refusal> whyNotTest(const ModuleState& module,
                                                const std::optional<servo::SetGain>& gains,
                                                std::int64_t error, std::int64_t low, std::int64_t high) {
    if (const auto refusal = whyNot(IntentKind::Move, module))
        return refusal;
    if (const auto refusal = firstUnmet({{gains.has_value(), Refusal::GainsUnknown},
                                         {module.latest->position.has_value(), Refusal::PositionUnknown},
                                         {module.goal().has_value(), Refusal::CommandUnknown},
                                         {error != 0, Refusal::StepTooShort},
                                         {error <= kLongestStep, Refusal::StepTooLong},
                                         {!gains || !wouldTrip(error, gains->el), Refusal::StepWouldTrip}}))
        return refusal;
    for (const std::int64_t off : {low, high}) {
        const std::int64_t goal = *module.goal() + off;
        if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
            return Refusal::GoalOutOfRange;
        if (const auto problem = travelProblem(intent::StepResponse{static_cast<std::int32_t>(off)}, module))
            return problem->refusal;
    }
    return std::nullopt;
}

}  // namespace

bool wouldTrip(std::int64_t counts, std::int64_t errorLimit) {
    return counts + counts / 10 + kStillCounts > errorLimit;
}

std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module) {
    return whyNot(intent::StepSeries{wanted, {wanted.counts}}, module);
}

std::optional<Refusal> whyNot(const intent::StepSeries& wanted, const ModuleState& module) {
    const intent::StepResponse& each = wanted.each;
    const auto& gains = each.gains ? each.gains : module.gains;
    const bool stays =
        wanted.counts.empty() || std::ranges::any_of(wanted.counts, [](auto by) { return by == 0; });
    std::int64_t longest = 0;
    std::int64_t at = 0;
    std::int64_t low = stays ? 0 : wanted.counts.front();
    std::int64_t high = low;
    for (const std::int64_t counts : wanted.counts) {
        at += counts;
        longest = std::max(longest, std::abs(counts));
        low = std::min(low, at);
        high = std::max(high, at);
    }
    // The error of a profiled move is not known beforehand; a step's is the whole step.
    const bool moves = each.method == ResponseMethod::Move;
    const std::int64_t error = stays ? 0 : moves ? 1 : longest;
    if (const auto refusal = whyNotTest(module, gains, error, low, high))
        return refusal;
    if (const auto refusal = each.gains ? whyNot(IntentKind::ApplyGains, module) : std::nullopt)
        return refusal;
    if (const auto problem = travelProblem(wanted, module))
        return problem->refusal;
    // Without Stop Here, the exact starting position of the next step would be unknown.
    const bool stopsHere = each.method == ResponseMethod::StopHere || wanted.counts.size() > 1;
    if (stopsHere && module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    if (!(each.record >= kShortestRecord && each.record <= kLongestRecord))
        return Refusal::RecordTime;
    if (moves && (each.pace.velocity.value() == 0 || each.pace.acceleration.value() == 0))
        return Refusal::TestOutOfRange;
    if (moves &&
        forecast(static_cast<double>(longest), each.pace, gains->sr).seconds + each.record > kLongestMove)
        return Refusal::MoveTooLong;
    return std::nullopt;
}

std::optional<Refusal> whyNot(const intent::SquareWave& wanted, const ModuleState& module) {
    const std::int64_t counts = wanted.counts;
    if (const auto refusal =
            whyNotTest(module, module.gains, std::abs(counts), counts / 2 - counts, counts / 2))
        return refusal;
    if (wanted.method == ResponseMethod::StopHere && module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    const bool inRange = wanted.period >= kShortestPeriod && wanted.period <= kLongestPeriod &&
                         wanted.rounds >= 1 && wanted.rounds <= kMaxPeriods && wanted.excursion > 0;
    return inRange ? std::nullopt : std::optional(Refusal::TestOutOfRange);
}

double sineLasts(double hertz) {
    constexpr double kPeriods = 5.0;
    constexpr double kShortest = 1.0;
    return std::max(kPeriods / hertz, kShortest);
}

double rampOf(const intent::FrequencyResponse& wanted, const servo::SetGain& gains) {
    return wanted.speed * ticksPerSecond(gains.sr);
}

/// Where the motor lags the command by half a turn, the error is twice the amplitude. The first sine takes
/// the motor farthest away.
std::optional<Refusal> whyNot(const intent::FrequencyResponse& wanted, const ModuleState& module) {
    const std::int64_t amplitude = wanted.amplitude;
    const bool inRange = amplitude >= 1 && amplitude <= kWidestSine && wanted.from >= kSlowestSine &&
                         wanted.to > wanted.from && wanted.to <= kFastestSine &&
                         std::abs(wanted.speed) <= kFastestRamp;
    if (!inRange)
        return Refusal::TestOutOfRange;
    const double ramp = module.gains ? rampOf(wanted, *module.gains) : 0.0;
    const auto away = static_cast<std::int64_t>(ramp * sineLasts(wanted.from));
    if (const auto refusal =
            whyNotTest(module, module.gains, 2 * amplitude, std::min<std::int64_t>(away, 0) - amplitude,
                       std::max<std::int64_t>(away, 0) + amplitude))
        return refusal;
    if (module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    if (ramp == 0.0)
        return std::nullopt;
    if (std::abs(ramp) < 2 * std::numbers::pi * wanted.to * static_cast<double>(amplitude))
        return Refusal::TestTooSlow;
    const auto lag = static_cast<std::int64_t>(std::abs(ramp) * kLongestLag);
    return wouldTrip(2 * amplitude + lag, module.gains->el) ? std::optional(Refusal::StepWouldTrip)
                                                            : std::nullopt;
}

}  // namespace nmc

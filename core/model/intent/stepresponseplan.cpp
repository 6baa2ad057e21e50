// SPDX-License-Identifier: MIT
#include "model/intent/stepresponseplan.h"

#include <cstdlib>

#include "bus/standstill.h"
#include "model/intent/travel.h"

namespace nmc {

namespace {

/// A step that would trip, or come close to it: a tenth, and what a servo swings at standstill.
[[nodiscard]] bool wouldTrip(std::int64_t step, std::int64_t errorLimit) {
    return step + step / 10 + kStillCounts > errorLimit;
}

}  // namespace

std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module) {
    if (const auto refusal = whyNot(Request::Move, module))
        return refusal;
    const auto& gains = wanted.gains ? wanted.gains : module.gains;
    if (!gains)
        return Refusal::GainsUnknown;
    if (const auto refusal = wanted.gains ? whyNot(Request::ApplyGains, module) : std::nullopt)
        return refusal;
    if (!module.latest->position)
        return Refusal::PositionUnknown;
    if (!module.goal())
        return Refusal::CommandUnknown;
    if (wanted.way == StepWay::StopHere && module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    if (wanted.counts == 0)
        return Refusal::StepTooShort;
    const std::int64_t step = std::abs(std::int64_t{wanted.counts});
    if (step > kLongestStep)
        return Refusal::StepTooLong;
    if (wouldTrip(step, gains->el))
        return Refusal::StepWouldTrip;
    const std::int64_t goal = std::int64_t{*module.goal()} + wanted.counts;
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return Refusal::GoalOutOfRange;
    if (const auto problem = travelProblem(wanted, module))
        return problem->refusal;
    if (!(wanted.record >= kShortestRecord && wanted.record <= kLongestRecord))
        return Refusal::RecordTime;
    return std::nullopt;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "model/intent/stepresponseplan.h"

#include <cstdlib>

#include "model/intent/looptestplan.h"

namespace nmc {

std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module) {
    const auto& gains = wanted.gains ? wanted.gains : module.gains;
    const std::int64_t counts = wanted.counts;
    if (const auto refusal = whyNotTest(module, gains, std::abs(counts), counts, counts))
        return refusal;
    if (const auto refusal = wanted.gains ? whyNot(Request::ApplyGains, module) : std::nullopt)
        return refusal;
    if (wanted.way == StepWay::StopHere && module.info.identity.version < servo::kStopHereVersion)
        return Refusal::VersionLacksIt;
    if (!(wanted.record >= kShortestRecord && wanted.record <= kLongestRecord))
        return Refusal::RecordTime;
    return std::nullopt;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/procedure/stepresponse.h"

namespace nmc {

/// Successive steps or moves, each from the end of the previous one, as soon as the motor stands there. A
/// step after which it does not come to rest is the last.
class StepSeriesRun : public StepResponseRun {
public:
    /// `wanted` must be possible now.
    StepSeriesRun(const intent::StepSeries& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next settled(const ModuleState& module, bool stands) override;

    std::vector<std::int32_t> m_counts;
};

}  // namespace nmc

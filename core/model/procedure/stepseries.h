// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/procedure/stepresponse.h"

namespace nmc {

/// Steps one after the other, each from where the one before has ended and as soon as the motor stands
/// there. One after which it does not come to rest is the last.
class StepSeriesRun : public StepResponseRun {
public:
    /// `wanted` is possible now.
    StepSeriesRun(const intent::StepSeries& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next settled(const ModuleState& module, bool stands) override;

    std::vector<std::int32_t> m_counts;
};

}  // namespace nmc

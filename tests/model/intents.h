// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "model/intent/intent.h"

/// Intents that tests send to modules, and the reason why one is refused.
namespace nmc::testing_support {

/// 8 counts per tick, 0.02 counts per tick squared.
inline const servomotion::Trapezoid kTrapezoid{Counts(20'000), CountsPerTick(8 << 16),
                                               CountsPerTickSquared(1'311)};
inline const intent::Move kMove{kTrapezoid};

[[nodiscard]] inline std::optional<Refusal> refusalOf(const Intent& intent, const ModuleState& module) {
    const auto steps = plan(intent, module);
    return steps ? std::nullopt : std::optional(steps.error());
}

}  // namespace nmc::testing_support

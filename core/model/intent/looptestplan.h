// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/intent/intent.h"

/// What the longer tests of a loop need before they can be asked for. As in stepresponseplan.h, they begin at
/// the position that the servo holds. Pure.
namespace nmc {

/// Counts to either side of it.
inline constexpr std::int32_t kWidestSine = 500;
inline constexpr std::int32_t kFirstSine = 20;
/// Hz.
inline constexpr double kSlowestSine = 0.5;
inline constexpr double kFastestSine = 40.0;
/// s.
inline constexpr double kShortestPeriod = 0.1;
inline constexpr double kLongestPeriod = 5.0;
inline constexpr unsigned kMostPeriods = 200;

/// A jump of the command position by so many counts would trip, or come close to it: a tenth, and what a
/// servo swings at standstill.
[[nodiscard]] bool wouldTrip(std::int64_t counts, std::int64_t errorLimit);

/// What every test of the loop needs: a servo that holds with known gains, where its position error may be
/// `error` counts, and where it may go to `low` and `high` counts off the position that it holds.
[[nodiscard]] std::optional<Refusal> whyNotTest(const ModuleState& module,
                                                const std::optional<servo::SetGain>& gains,
                                                std::int64_t error, std::int64_t low, std::int64_t high);

[[nodiscard]] std::optional<Refusal> whyNot(const intent::SquareWave& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::FrequencyResponse& wanted,
                                            const ModuleState& module);

}  // namespace nmc

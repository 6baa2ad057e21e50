// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/intent/intent.h"

/// What the tests of a loop need before they can be asked for. Whatever makes one impossible is found before
/// anything is sent. They start from the position that the servo holds (ModuleState::goal()), not from where
/// a load or friction keeps the shaft: steps there and back end where they began. The position error is the
/// whole jump when the command has jumped, so the position error limit must be above it with a margin. Pure.
namespace nmc {

/// Longest step, counts: "test motions should be small motions" (DS-V 4.3).
inline constexpr std::int32_t kLongestStep = 2'000;
inline constexpr std::int32_t kFirstStep = 100;
/// Seconds; the bus can be given to one module for 5 s (bus::Engine::focus).
inline constexpr double kShortestRecord = 0.02;
inline constexpr double kLongestRecord = 3.0;
/// Counts to either side.
inline constexpr std::int32_t kWidestSine = 500;
inline constexpr std::int32_t kFirstSine = 20;
/// Hz.
inline constexpr double kSlowestSine = 0.5;
inline constexpr double kFastestSine = 40.0;
/// s.
inline constexpr double kShortestPeriod = 0.1;
inline constexpr double kLongestPeriod = 5.0;
inline constexpr unsigned kMaxPeriods = 200;

/// A jump of the command position by so many counts would trip, or come close to it: a tenth, and what a
/// servo swings at standstill.
[[nodiscard]] bool wouldTrip(std::int64_t counts, std::int64_t errorLimit);

[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepSeries& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::SquareWave& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::FrequencyResponse& wanted,
                                            const ModuleState& module);

}  // namespace nmc

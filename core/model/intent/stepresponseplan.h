// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/intent/intent.h"

/// What a step response needs before it can be asked for. Pure.
namespace nmc {

/// Longest step, counts: "test motions should be small motions" (DS-V 4.3).
inline constexpr std::int32_t kLongestStep = 2'000;
inline constexpr std::int32_t kFirstStep = 100;
/// Seconds; the bus can be given to one module for 5 s (bus::Engine::focus).
inline constexpr double kShortestRecord = 0.02;
inline constexpr double kLongestRecord = 3.0;

/// Whatever makes it impossible is found before anything is sent. It starts from the position that the servo
/// holds (ModuleState::goal()), not from where a load or friction keeps the shaft: steps there and back end
/// where they began. The position error is the whole step when
/// the command has jumped, so the position error limit must be above it with a margin.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module);

}  // namespace nmc

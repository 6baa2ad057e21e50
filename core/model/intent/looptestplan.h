// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/intent/intent.h"

/// Preconditions of the loop tests, all checked before anything is sent. The tests start from the position
/// that the servo holds (ModuleState::goal()), not from where a load or friction keeps the shaft, so that
/// steps there and back end where they began. Right after a jump of the command, the position error is the
/// whole jump, so the position error limit must exceed it with a margin. Pure.
namespace nmc {

/// Longest step, counts: "test motions should be small motions" (DS-V 4.3).
inline constexpr std::int32_t kLongestStep = 2'000;
inline constexpr std::int32_t kFirstStep = 100;
/// Seconds; the bus can be reserved for one module for 5 s (bus::Engine::focus).
inline constexpr double kShortestRecord = 0.02;
inline constexpr double kLongestRecord = 3.0;
/// Seconds, for a profiled move and the record after it; a run file has room for as many samples
/// (model/machinefile/responsestore.h).
inline constexpr double kLongestMove = 6.0;
/// Moves there and back.
inline constexpr unsigned kMaxMoves = 20;
/// Amplitude in counts, to either side.
inline constexpr std::int32_t kWidestSine = 500;
inline constexpr std::int32_t kFirstSine = 20;
/// Frequency in Hz.
inline constexpr double kSlowestSine = 0.5;
inline constexpr double kFastestSine = 40.0;
/// Counts per servo tick. A motor that follows a ramp lags it by less than kLongestLag, in seconds.
inline constexpr double kFastestRamp = 50.0;
inline constexpr double kLongestLag = 0.1;
/// Period in seconds.
inline constexpr double kShortestPeriod = 0.1;
inline constexpr double kLongestPeriod = 5.0;
inline constexpr unsigned kMaxPeriods = 200;

/// True if a jump of the command position by `counts` would trip the servo, or come close to it: the margin
/// is a tenth of the jump, plus the servo's swing at standstill.
[[nodiscard]] bool wouldTrip(std::int64_t counts, std::int64_t errorLimit);

/// The duration of a sine in s; its first period lets the motor settle in.
[[nodiscard]] double sineLasts(double hertz);
/// FrequencyResponse::speed in counts/s.
[[nodiscard]] double rampOf(const intent::FrequencyResponse& wanted, const servo::SetGain& gains);

[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepResponse& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::StepSeries& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::SquareWave& wanted, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNot(const intent::FrequencyResponse& wanted,
                                            const ModuleState& module);

}  // namespace nmc

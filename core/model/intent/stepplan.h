// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"

/// The rules of DS-S 5.1 and its Table 4, as they stand before a PIC-STEP is asked for anything; the bus has
/// a gate of its own behind them (bus/gate.h).
namespace nmc {

/// plan() and whyNot() of a PIC-STEP.
[[nodiscard]] tl::expected<std::vector<bus::Step>, Refusal> planStep(const Intent& intent,
                                                                     const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotStep(Request request, const ModuleState& module);

/// Why a motion cannot be started now. NeedsStop: stepintent::ChangeMotion could do it. `as`: what it is
/// asked for as, Move or Hold.
[[nodiscard]] std::optional<Refusal> whyNot(const StepMotion& motion, const ModuleState& module,
                                            Request as = Request::Move);
/// As if it stood still already.
[[nodiscard]] std::optional<Refusal> whyNotFromStandstill(const StepMotion& motion, const ModuleState& module,
                                                          Request as = Request::Move);

/// Why a load cannot be started now.
[[nodiscard]] std::optional<Refusal> whyNotStarted(const step::LoadTrajectory& load,
                                                   const ModuleState& module);

/// The load for a motion, from where the module is; a position that does not change in motion is left out.
[[nodiscard]] step::LoadTrajectory loadFor(const StepMotion& motion, const ModuleState& module);
/// Smoothly where the chip knows a ramp, with the amplifier left as it is.
[[nodiscard]] bus::Step smoothStop(const ModuleState& module);

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"

/// The rules of DS-S 5.1 and its Table 4, as they stand before a PIC-STEP is asked for anything; the bus has
/// a gate of its own behind them (bus/gate.h).
namespace nmc {

/// plan() and whyNot() of a PIC-STEP.
[[nodiscard]] tl::expected<std::vector<bus::Order>, Refusal> planStep(const Intent& intent,
                                                                      const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotStep(IntentKind kind, const ModuleState& module);

/// Why a motion cannot be started now. NeedsStop: stepperintent::ChangeMotion could do it. `as`: what it is
/// asked for as, Move or Hold.
[[nodiscard]] std::optional<Refusal> whyNot(const StepperMotion& motion, const ModuleState& module,
                                            IntentKind as = IntentKind::Move);
/// As if it stood still already.
[[nodiscard]] std::optional<Refusal> whyNotFromStandstill(const StepperMotion& motion,
                                                          const ModuleState& module,
                                                          IntentKind as = IntentKind::Move);

/// The first of its moves, and the way home; where home is not known, there is none.
[[nodiscard]] StepperMotion motionOf(const stepperintent::MoveBy& moveBy);
[[nodiscard]] std::optional<StepperMotion> motionOf(const stepperintent::GoHome& home,
                                                    const ModuleState& module);

/// Why these cannot be set now: some of them not in motion.
[[nodiscard]] std::optional<Refusal> whyNotSet(const stepper::SetParameters& parameters,
                                               const ModuleState& module);

/// Where a motion ends, in 64 bits so that too far can be told; nothing for one without an end.
[[nodiscard]] std::optional<std::int64_t> goalOf(const StepperMotion& motion, const ModuleState& module);
[[nodiscard]] bool wantsReverse(const StepperMotion& motion, const ModuleState& module);
/// Steps/s that it would get to; 0: not known.
[[nodiscard]] double speedOf(const StepperMotion& motion, const ModuleState& module);
[[nodiscard]] double speedOf(const stepper::LoadTrajectory& load, const ModuleState& module);

/// Why a load cannot be started now.
[[nodiscard]] std::optional<Refusal> whyNotStarted(const stepper::LoadTrajectory& load,
                                                   const ModuleState& module);

/// The load for a motion, from where the module is; a position that does not change in motion is left out.
[[nodiscard]] stepper::LoadTrajectory loadFor(const StepperMotion& motion, const ModuleState& module);
/// Of a motor that is on. Smoothly, where a PIC-STEP knows a ramp, with the amplifier left as it is.
[[nodiscard]] bus::Order smoothStop(const ModuleState& module);

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"

/// Preconditions of requests to a PIC-STEP, from DS-S 5.1 and its Table 4; the bus has a gate of its own
/// behind them (bus/gate.h).
namespace nmc {

/// plan() and whyNot() for a PIC-STEP.
[[nodiscard]] Plan planStep(const Intent& intent, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotStep(IntentKind kind, const ModuleState& module);

/// Why a motion cannot be started now. NeedsStop: intent::ChangeMotion can do it. `as`: the kind of
/// the request, Move or Hold.
[[nodiscard]] std::optional<Refusal> whyNot(const StepperMotion& motion, const ModuleState& module,
                                            IntentKind as = IntentKind::Move);
/// Why a motion could not be started even if the motor already stood still.
[[nodiscard]] std::optional<Refusal> whyNotFromStandstill(const StepperMotion& motion,
                                                          const ModuleState& module,
                                                          IntentKind as = IntentKind::Move);

/// Why the parameters cannot be set now: some of them cannot be changed in motion.
[[nodiscard]] std::optional<Refusal> whyNotSet(const stepper::SetParameters& parameters,
                                               const ModuleState& module);

[[nodiscard]] bool wantsReverse(const StepperMotion& motion, const ModuleState& module);
/// The speed in steps/s that the motion would reach; 0: unknown.
[[nodiscard]] double speedOf(const StepperMotion& motion, const ModuleState& module);
[[nodiscard]] double speedOf(const stepper::LoadTrajectory& load, const ModuleState& module);

/// Why a load cannot be started now.
[[nodiscard]] std::optional<Refusal> whyNotStarted(const stepper::LoadTrajectory& load,
                                                   const ModuleState& module);

/// The load for a motion, relative to the module's position; a position that does not change in motion is
/// left out.
[[nodiscard]] stepper::LoadTrajectory loadFor(const StepperMotion& motion, const ModuleState& module);
/// A stop for a motor that is on: smooth if a PIC-STEP knows a ramp; the amplifier is left as it is.
[[nodiscard]] bus::Order smoothStop(const ModuleState& module);

}  // namespace nmc

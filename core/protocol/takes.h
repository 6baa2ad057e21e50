// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/commands.h"
#include "protocol/moduletype.h"

namespace nmc {

/// True when the module knows the command as it stands (docs/family.md); otherwise the chip would ignore it
/// or take it for another.
[[nodiscard]] bool takes(const ModuleIdentity& module, const ServoCommand& command);
[[nodiscard]] bool takes(const ModuleIdentity& module, const StepperCommand& command);
[[nodiscard]] bool takes(const ModuleIdentity& module, const IoCommand& command);

/// The velocities that a PIC-SERVO can be loaded with, in 1/65536 counts per tick (DS-V 4.4, docs/family.md).
[[nodiscard]] ValueRange loadableVelocities(const ModuleIdentity& module);

}  // namespace nmc

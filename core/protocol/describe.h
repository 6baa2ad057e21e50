// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/bytes.h"
#include "protocol/commands.h"
#include "protocol/moduletype.h"
#include "protocol/status.h"

/// Describes the bytes on the wire in the words of the data sheets, which are not translated. This is for the
/// packet monitor and its exports: any bytes whatever yield a line of text.
namespace nmc {

/// Describes what the host sent: nulls, one or more packets back to back, or bytes that are no packet.
/// `module` is the addressee, needed because the chips share command codes; an unknown one is treated as a
/// PIC-SERVO of the first data sheet. Velocities are in counts/tick and accelerations in counts/tick^2, with
/// six digits. The result is empty for no bytes.
///
///     Load Trajectory: position 2000, velocity 1.5, trapezoidal, start now
///     16 nulls
[[nodiscard]] std::string describeCommand(const ModuleIdentity& module, ByteSpan bytes);

/// Describes a command when the module's version is unknown.
[[nodiscard]] std::string describeCommand(const ServoCommand& command);
[[nodiscard]] std::string describeCommand(const StepperCommand& command);
[[nodiscard]] std::string describeCommand(const IoCommand& command);

/// Describes a reply, assuming that it carries these items: the items in wire order, then the bits that are
/// set in the status byte. Damage is reported before, or instead of, the contents. The result is empty for no
/// bytes.
///
///     position 1234, velocity 2, move_done power_on
[[nodiscard]] std::string describeReply(const ModuleIdentity& module, StatusItems items, ByteSpan bytes);

}  // namespace nmc

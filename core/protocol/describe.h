// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/bytes.h"
#include "protocol/commands.h"
#include "protocol/moduletype.h"
#include "protocol/status.h"

/// What bytes on the wire say, in the data sheets' own words, which are not translated. For the packet
/// monitor and its exports: whatever the bytes are, the answer is a line of text.
namespace nmc {

/// What the host sent: nulls, one packet or several behind each other, or bytes that are none. `module` is
/// the one it is for, because the chips share command codes; an unknown one counts as a PIC-SERVO of the
/// first data sheet. Velocities in counts/tick and accelerations in counts/tick^2, with six digits. Empty for
/// no bytes.
///
///     Load Trajectory: position 2000, velocity 1.5, trapezoidal, start now
///     16 nulls
[[nodiscard]] std::string describeCommand(const ModuleIdentity& module, ByteSpan bytes);

/// What a command says, whose version is not at hand.
[[nodiscard]] std::string describeCommand(const ServoCommand& command);
[[nodiscard]] std::string describeCommand(const StepperCommand& command);
[[nodiscard]] std::string describeCommand(const IoCommand& command);

/// What came back, taken for a reply with these items: items in the order of the wire, then the bits that are
/// set in the status byte. Damage is told in front of, or instead of, what the bytes would say. Empty for no
/// bytes.
///
///     position 1234, velocity 2, move_done power_on
[[nodiscard]] std::string describeReply(const ModuleIdentity& module, StatusItems items, ByteSpan bytes);

}  // namespace nmc

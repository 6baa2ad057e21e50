// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/bytes.h"
#include "protocol/moduletype.h"
#include "protocol/status.h"

/// What bytes on the wire say, in the data sheets' own words, which are not translated. For the packet
/// monitor and its exports: whatever the bytes are, the answer is a line of text.
namespace nmc {

/// What the host sent: nulls, one packet or several behind each other, or bytes that are none. `type` is that
/// of the module it is for, because the chips share command codes. Velocities in counts/tick and
/// accelerations in counts/tick^2, with six digits. Empty for no bytes.
///
///     Load Trajectory: position 2000, velocity 1.5, trapezoidal, start now
///     16 nulls
[[nodiscard]] std::string describeCommand(ModuleType type, ByteSpan bytes);

/// What came back, taken for a reply with these items: items in the order of the wire, then the bits that are
/// set in the status byte. Damage is told in front of, or instead of, what the bytes would say. Empty for no
/// bytes.
///
///     position 1234, velocity 2, move_done power_on
[[nodiscard]] std::string describeReply(ModuleType type, StatusItems items, ByteSpan bytes);

}  // namespace nmc

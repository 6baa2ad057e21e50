// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nmc::bus {

/// Why a reply with the right sum is implausible (link.md 2.4). The 8-bit sum lets one wrong reply in some
/// hundred pass; these rules are the additional nets.
enum class Rejection : std::uint8_t {
    // Any module.
    Uniform,        ///< all bytes 00 or all FF: a line that is held low, or high
    Surplus,        ///< more bytes than the layout has, within two character times
    Echo,           ///< does not follow the exact echo of its command, or is part of an unexpected echo
    Identity,       ///< type or version other than enumerated
    UndefinedBits,  ///< a bit that the data sheet leaves undefined differs from first contact
    HomingRose,     ///< homing in progress without Set Homing Mode
    HomeChanged,    ///< the home register changed without homing or Save as Home
    PositionJump,   ///< farther from the last position than the velocities allow
    VelocityJump,   ///< a velocity change that no motor can make in the time
    // PIC-SERVO (DS-V 5.3).
    OffWithoutBits,    ///< servo off, but pos_error or move_done is not set
    OnWithoutPower,    ///< servo on without motor power (not an SC)
    SlewWithoutAccel,  ///< slew_done without accel_done
    StickyCleared,     ///< a sticky bit was cleared without Clear Sticky Bits
    // PIC-STEP (DS-S 5.2).
    BothModes,           ///< velocity and trapezoidal mode at once
    MovingWithoutPower,  ///< moving without power
    MovedWhileStopped,   ///< the position changed, although stopped before and now
    TimerCount,          ///< outside 1..65 452 in motion
};

inline constexpr std::size_t kRejections = static_cast<std::size_t>(Rejection::TimerCount) + 1;

/// The number of replies that each rule found implausible.
using RejectionCounts = std::array<std::uint64_t, kRejections>;

}  // namespace nmc::bus

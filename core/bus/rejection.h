// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nmc::bus {

/// Why a reply whose sum was right is not believed (link.md 2.4). The sum is 8 bits wide, so it lets one
/// wrong reply in some hundred through; these are the further nets.
enum class Rejection : std::uint8_t {
    // Of any module.
    Uniform,        ///< all bytes 00 or all FF: a line that is held low, or high
    Surplus,        ///< more bytes than the layout has, within two character times
    Echo,           ///< not behind the exact echo of its command, or part of one that was not expected
    Identity,       ///< type or version other than enumerated
    UndefinedBits,  ///< a bit that the data sheet leaves open is not as at first contact
    HomingRose,     ///< homing in progress without Set Homing Mode
    HomeChanged,    ///< another home register without homing and without Save as Home
    PositionJump,   ///< farther from the last position than the velocities allow
    VelocityJump,   ///< a velocity that no motor reaches in the time
    // PIC-SERVO (DS-V 5.3).
    OffWithoutBits,    ///< servo off, but pos_error or move_done is not set
    OnWithoutPower,    ///< servo on without motor power
    SlewWithoutAccel,  ///< slew_done without accel_done
    StickyCleared,     ///< a sticky bit went away without Clear Sticky Bits
    // PIC-STEP (DS-S 5.2).
    BothModes,           ///< velocity and trapezoidal mode at once
    MovingWithoutPower,  ///< moving without power
    MovedWhileStopped,   ///< another position, and stopped before and now
    TimerCount,          ///< outside 1..65 452 in motion
};

inline constexpr std::size_t kRejections = static_cast<std::size_t>(Rejection::TimerCount) + 1;

/// How often each rule rejected a reply.
using RejectionCounts = std::array<std::uint64_t, kRejections>;

}  // namespace nmc::bus

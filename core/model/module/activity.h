// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// What a module is doing, in an operator's terms. Each state has a word and a shape in the window.
enum class Activity : std::uint8_t {
    Unknown,       ///< no status yet, or a module that no data sheet here covers
    Unresponsive,  ///< does not answer; whether it moves is unknown
    NotAsked,      ///< nothing is sent to it any more, since another module restarted
    Restarted,     ///< it restarted by itself: it is off, and has lost its address and all settings
    NoPower,       ///< motor power is off, so the motor is off
    ServoOff,      ///< not a fault: it was never switched on, or was switched off
    Tripped,       ///< switched itself off: position error while it was on
    PowerLost,     ///< switched itself off: motor power was lost; it stays off even when power is back
    PwmMode,       ///< servo off; a PWM value drives the motor, or will when power returns
    MaybeOff,      ///< one reply says that it switched itself off; the next one decides
    MaybeMoving,   ///< at rest in its last replies, but whether it was started is still unknown
    Turned,        ///< off, but its shaft moves: a load turns it, or it is still coasting
    Holding,       ///< servo or amplifier on, at rest
    Limited,       ///< holding, but its current has been limited since this was last cleared
    Accelerating,  ///< includes changing from one velocity to another
    AtSpeed,       ///< velocity mode at its goal velocity, or the slew phase of a trapezoidal move
    Decelerating,
    OnPath,  ///< PIC-SERVO CMC and SC
    // PIC-STEP only
    AmplifierOff,    ///< not a fault: the amplifier was never switched on, or was switched off
    StoppedByLimit,  ///< a limit switch ended the motion
    EstopActive,     ///< the E-stop input is high, or ended the motion
    Overheated,      ///< switched itself off: the A/D value fell below the thermal limit
    WentOff,         ///< switched itself off for an unknown reason
    // PIC-I/O only
    Ready,  ///< answers; it has nothing that could move
};

/// The third indication of a state, besides its shape and word.
enum class Severity : std::uint8_t { Normal, Attention, Fault };

[[nodiscard]] Severity severityOf(Activity activity);

}  // namespace nmc

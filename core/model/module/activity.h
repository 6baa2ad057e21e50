// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// What a module is doing, as an operator would say it. Each has a word and a shape in the window.
enum class Activity : std::uint8_t {
    Unknown,       ///< no status yet, or a module without a data sheet here
    Unresponsive,  ///< does not answer: moving or not is unknown
    Restarted,     ///< by itself: it is off, and has lost its address and everything it was told
    NoPower,       ///< motor power is off, so the motor is off
    ServoOff,      ///< no fault: nobody switched it on, or it was switched off
    Tripped,       ///< it switched itself off: position error while it was on
    PowerLost,     ///< it switched itself off: motor power went away, and stays off though power is back
    PwmMode,       ///< servo off, a PWM value drives the motor
    MaybeOff,      ///< one answer says that it switched itself off; the next will tell
    MaybeMoving,   ///< it stands in its last answers, but whether it was started is not known yet
    Turned,        ///< off, but its shaft moves: a load turns it, or it is still running down
    Holding,       ///< servo or amplifier on, at rest
    Limited,       ///< as Holding, but its current has been limited since that was cleared last
    Accelerating,  ///< includes changing from one velocity to another
    AtSpeed,       ///< velocity mode at its goal velocity, or the slew phase of a trapezoidal move
    Decelerating,
    OnPath,  ///< PIC-SERVO CMC and SC
    // PIC-STEP only
    AmplifierOff,    ///< as ServoOff
    StoppedByLimit,  ///< a limit switch ended the motion
    EstopActive,     ///< the E-stop input is high, or ended the motion
    Overheated,      ///< it switched itself off: the A/D value fell below the thermal limit
    WentOff,         ///< it switched itself off, and why is not known
    // PIC-I/O only
    Ready,  ///< it answers; there is nothing that could move
};

/// Third sign of a state, after shape and word.
enum class Severity : std::uint8_t { Normal, Attention, Fault };

[[nodiscard]] Severity severityOf(Activity activity);

}  // namespace nmc

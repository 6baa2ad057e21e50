// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// The low nibble of a command byte (DS-V 5.1, DS-S 5.1). Some codes mean different things to different
/// chips; a PIC-I/O has neither 9, B nor D.
enum class CommandCode : std::uint8_t {
    ResetPosition = 0x0,  ///< PIC-I/O: Set Direction
    SetAddress = 0x1,
    DefineStatus = 0x2,
    ReadStatus = 0x3,
    LoadTrajectory = 0x4,  ///< PIC-I/O: Set PWM
    StartMotion = 0x5,     ///< PIC-I/O: Synch Output
    SetGain = 0x6,         ///< PIC-STEP: Set Parameters; PIC-I/O: Set Output
    StopMotor = 0x7,       ///< PIC-I/O: Set Synch Output
    IoControl = 0x8,       ///< PIC-STEP: Set Outputs; PIC-I/O: Set Timer Mode
    SetHoming = 0x9,
    SetBaud = 0xA,
    ClearStickyBits = 0xB,  ///< PIC-SERVO only
    SaveAsHome = 0xC,       ///< PIC-I/O: Synch Input
    AddPathPoints = 0xD,    ///< PIC-SERVO CMC and SC only
    Nop = 0xE,
    HardReset = 0xF,
};

}  // namespace nmc

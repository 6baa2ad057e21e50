// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// The low nibble of a command byte (DS-V 5.1, DS-S 5.1). 6 and 8 mean different things to the two chips.
enum class CommandCode : std::uint8_t {
    ResetPosition = 0x0,
    SetAddress = 0x1,
    DefineStatus = 0x2,
    ReadStatus = 0x3,
    LoadTrajectory = 0x4,
    StartMotion = 0x5,
    SetGain = 0x6,  ///< PIC-STEP: Set Parameters
    StopMotor = 0x7,
    IoControl = 0x8,  ///< PIC-STEP: Set Outputs
    SetHoming = 0x9,
    SetBaud = 0xA,
    ClearStickyBits = 0xB,  ///< PIC-SERVO only
    SaveAsHome = 0xC,
    Reserved = 0xD,
    Nop = 0xE,
    HardReset = 0xF,
};

}  // namespace nmc

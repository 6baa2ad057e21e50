// SPDX-License-Identifier: MIT
#include "protocol/commandtable.h"

#include <array>

namespace nmc {

namespace {

// DS-V 5.1. Set Gain takes a fifteenth byte and Reset Position a first one, both ignored (protocol.md 2).
constexpr std::array kServoCommands{
    CommandRow{CommandCode::ResetPosition, "reset_position", "Reset Position", 0, 1},
    CommandRow{CommandCode::SetAddress, "set_address", "Set Address", 2, 2},
    CommandRow{CommandCode::DefineStatus, "define_status", "Define Status", 1, 1},
    CommandRow{CommandCode::ReadStatus, "read_status", "Read Status", 1, 1},
    CommandRow{CommandCode::LoadTrajectory, "load_trajectory", "Load Trajectory", 1, 14},
    CommandRow{CommandCode::StartMotion, "start_motion", "Start Motion", 0, 0},
    CommandRow{CommandCode::SetGain, "set_gain", "Set Gain", 13, 15},
    CommandRow{CommandCode::StopMotor, "stop_motor", "Stop Motor", 1, 5},
    CommandRow{CommandCode::IoControl, "io_control", "I/O Control", 1, 1},
    CommandRow{CommandCode::SetHoming, "set_homing", "Set Homing Mode", 1, 1},
    CommandRow{CommandCode::SetBaud, "set_baud", "Set Baud Rate", 1, 1},
    CommandRow{CommandCode::ClearStickyBits, "clear_sticky_bits", "Clear Sticky Bits", 0, 0},
    CommandRow{CommandCode::SaveAsHome, "save_as_home", "Save Current Position as Home", 0, 0},
    CommandRow{CommandCode::Nop, "nop", "No Operation", 0, 0},
    CommandRow{CommandCode::HardReset, "hard_reset", "Hard Reset", 0, 0},
};

// DS-S 5.1. There is no Clear Sticky Bits.
constexpr std::array kStepCommands{
    CommandRow{CommandCode::ResetPosition, "reset_position", "Reset Position", 0, 0},
    CommandRow{CommandCode::SetAddress, "set_address", "Set Address", 2, 2},
    CommandRow{CommandCode::DefineStatus, "define_status", "Define Status", 1, 1},
    CommandRow{CommandCode::ReadStatus, "read_status", "Read Status", 1, 1},
    CommandRow{CommandCode::LoadTrajectory, "load_trajectory", "Load Trajectory", 1, 10},
    CommandRow{CommandCode::StartMotion, "start_motion", "Start Motion", 0, 0},
    CommandRow{CommandCode::SetGain, "set_parameters", "Set Parameters", 5, 5},
    CommandRow{CommandCode::StopMotor, "stop_motor", "Stop Motor", 1, 1},
    CommandRow{CommandCode::IoControl, "set_outputs", "Set Outputs", 1, 1},
    CommandRow{CommandCode::SetHoming, "set_homing", "Set Homing Mode", 1, 1},
    CommandRow{CommandCode::SetBaud, "set_baud", "Set Baud Rate", 1, 1},
    CommandRow{CommandCode::SaveAsHome, "save_as_home", "Save Current Position as Home", 0, 0},
    CommandRow{CommandCode::Nop, "nop", "No Operation", 0, 0},
    CommandRow{CommandCode::HardReset, "hard_reset", "Hard Reset", 0, 0},
};

}  // namespace

std::span<const CommandRow> commandTable(ModuleType type) {
    switch (type) {
        case ModuleType::Servo:
            return kServoCommands;
        case ModuleType::Step:
            return kStepCommands;
        case ModuleType::Adc:
        case ModuleType::Io:
            return {};
    }
    return {};
}

std::optional<CommandRow> findCommand(ModuleType type, CommandCode code) {
    for (const CommandRow& row : commandTable(type))
        if (row.code == code)
            return row;
    return std::nullopt;
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#include "protocol/commandtable.h"

#include <array>

namespace nmc {

namespace {

/// The rows of one chip, for versions `first` to `last`.
struct Rows {
    ModuleType type;
    constexpr CommandRow operator()(int first, int last, CommandCode code, std::string_view key,
                                    std::string_view name, int minData, int maxData) const {
        const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
        return {type, byte(first), byte(last), code, key, name, byte(minData), byte(maxData)};
    }
};

constexpr int kAny = 255;
constexpr Rows kServo{ModuleType::Servo};
constexpr Rows kStep{ModuleType::Stepper};
constexpr Rows kIo{ModuleType::Io};

// DS-V 5.1, DS-S 5.1, docs/family.md. A version ignores bytes that only later versions read: those of Reset
// Position and Hard Reset, and those that follow its own bytes of Set Gain.
constexpr std::array kCommands{
    kServo(1, 5, CommandCode::ResetPosition, "reset_position", "Reset Position", 0, 1),
    kServo(10, kAny, CommandCode::ResetPosition, "reset_position", "Reset Position", 0, 5),
    kServo(1, kAny, CommandCode::SetAddress, "set_address", "Set Address", 2, 2),
    kServo(1, kAny, CommandCode::DefineStatus, "define_status", "Define Status", 1, 1),
    kServo(1, kAny, CommandCode::ReadStatus, "read_status", "Read Status", 1, 1),
    kServo(1, kAny, CommandCode::LoadTrajectory, "load_trajectory", "Load Trajectory", 1, 14),
    kServo(1, kAny, CommandCode::StartMotion, "start_motion", "Start Motion", 0, 0),
    kServo(1, kAny, CommandCode::SetGain, "set_gain", "Set Gain", 13, 15),
    kServo(1, kAny, CommandCode::StopMotor, "stop_motor", "Stop Motor", 1, 5),
    kServo(1, kAny, CommandCode::IoControl, "io_control", "I/O Control", 1, 1),
    kServo(1, kAny, CommandCode::SetHoming, "set_homing", "Set Homing Mode", 1, 1),
    kServo(1, kAny, CommandCode::SetBaud, "set_baud", "Set Baud Rate", 1, 1),
    kServo(1, 5, CommandCode::ClearStickyBits, "clear_sticky_bits", "Clear Sticky Bits", 0, 0),
    kServo(10, kAny, CommandCode::ClearStickyBits, "clear_sticky_bits", "Clear Bits", 0, 0),
    kServo(1, kAny, CommandCode::SaveAsHome, "save_as_home", "Save Current Position as Home", 0, 0),
    kServo(5, kAny, CommandCode::AddPathPoints, "add_path_points", "Add Path Points", 0, 14),
    kServo(1, kAny, CommandCode::Nop, "nop", "No Operation", 0, 0),
    kServo(1, kAny, CommandCode::HardReset, "hard_reset", "Hard Reset", 0, 1),

    // A PIC-STEP has no Clear Sticky Bits.
    kStep(1, kAny, CommandCode::ResetPosition, "reset_position", "Reset Position", 0, 0),
    kStep(1, kAny, CommandCode::SetAddress, "set_address", "Set Address", 2, 2),
    kStep(1, kAny, CommandCode::DefineStatus, "define_status", "Define Status", 1, 1),
    kStep(1, kAny, CommandCode::ReadStatus, "read_status", "Read Status", 1, 1),
    kStep(1, kAny, CommandCode::LoadTrajectory, "load_trajectory", "Load Trajectory", 1, 10),
    kStep(1, kAny, CommandCode::StartMotion, "start_motion", "Start Motion", 0, 0),
    kStep(1, kAny, CommandCode::SetGain, "set_parameters", "Set Parameters", 5, 5),
    kStep(1, kAny, CommandCode::StopMotor, "stop_motor", "Stop Motor", 1, 1),
    kStep(1, kAny, CommandCode::IoControl, "set_outputs", "Set Outputs", 1, 1),
    kStep(1, kAny, CommandCode::SetHoming, "set_homing", "Set Homing Mode", 1, 1),
    kStep(1, kAny, CommandCode::SetBaud, "set_baud", "Set Baud Rate", 1, 1),
    kStep(1, kAny, CommandCode::SaveAsHome, "save_as_home", "Save Current Position as Home", 0, 0),
    kStep(1, kAny, CommandCode::Nop, "nop", "No Operation", 0, 0),
    kStep(1, kAny, CommandCode::HardReset, "hard_reset", "Hard Reset", 0, 0),

    kIo(1, kAny, CommandCode::ResetPosition, "set_direction", "Set Direction", 2, 2),
    kIo(1, kAny, CommandCode::SetAddress, "set_address", "Set Address", 2, 2),
    kIo(1, kAny, CommandCode::DefineStatus, "define_status", "Define Status", 1, 1),
    kIo(1, kAny, CommandCode::ReadStatus, "read_status", "Read Status", 1, 1),
    kIo(1, kAny, CommandCode::LoadTrajectory, "set_pwm", "Set PWM", 2, 2),
    kIo(1, kAny, CommandCode::StartMotion, "synch_output", "Synch Output", 0, 0),
    kIo(1, kAny, CommandCode::SetGain, "set_output", "Set Output", 2, 2),
    kIo(1, kAny, CommandCode::StopMotor, "set_synch_output", "Set Synch Output", 4, 4),
    kIo(1, kAny, CommandCode::IoControl, "set_timer_mode", "Set Timer Mode", 1, 1),
    kIo(1, kAny, CommandCode::SetBaud, "set_baud", "Set Baud Rate", 1, 1),
    kIo(1, kAny, CommandCode::SaveAsHome, "synch_input", "Synch Input", 0, 0),
    kIo(1, kAny, CommandCode::Nop, "nop", "No Operation", 0, 0),
    kIo(1, kAny, CommandCode::HardReset, "hard_reset", "Hard Reset", 0, 0),
};

bool isFor(const CommandRow& row, const ModuleIdentity& module) {
    return isKnown(module) && row.type == module.type && module.version >= row.firstVersion &&
           module.version <= row.lastVersion;
}

}  // namespace

std::vector<CommandRow> commandTable(const ModuleIdentity& module) {
    std::vector<CommandRow> rows;
    for (const CommandRow& row : kCommands)
        if (isFor(row, module))
            rows.push_back(row);
    return rows;
}

std::optional<CommandRow> findCommand(const ModuleIdentity& module, CommandCode code) {
    for (const CommandRow& row : kCommands)
        if (row.code == code && isFor(row, module))
            return row;
    return std::nullopt;
}

}  // namespace nmc

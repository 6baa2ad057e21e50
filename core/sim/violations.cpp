// SPDX-License-Identifier: MIT
#include "sim/violations.h"

#include <array>

namespace nmc::sim {

namespace {

using Kind = ViolationKind;

constexpr std::array kViolations{
    ViolationRow{Kind::CommandInFlight, "command_in_flight",
                 "a command sent before the previous one was answered (DS-V 4.1), unless it stops a motor"},
    ViolationRow{Kind::CommandOverwritten, "command_overwritten",
                 "a module lost a command to the next one (DS-V 4.1)"},
    ViolationRow{
        Kind::TrapezoidInMotion, "trapezoid_in_motion",
        "a trapezoidal move started or changed while the motor moved, or PWM mode while the servo moved it (DS-V 4.4, 5.1)"},
    ViolationRow{
        Kind::ResetInMotion, "reset_in_motion",
        "Reset Position in a servo's trapezoid, an SC aside, or in any motion of a stepper (DS-V 5.1, DS-S 5.1)"},
    ViolationRow{Kind::ReplyCollision, "reply_collision",
                 "two modules answered at once: two leaders of a group, or one address twice (DS-V 4.1)"},
    ViolationRow{Kind::WrongLength, "wrong_length",
                 "the command byte announced another number of data bytes than the command has"},
    ViolationRow{Kind::UnknownCommand, "unknown_command", "no such command on this chip"},
    ViolationRow{
        Kind::StopBits, "stop_bits",
        "more than one manner of stopping in Stop Motor or Set Homing Mode; motor off with others in a "
        "servo's Stop Motor is a remark"},
    ViolationRow{Kind::OutOfRange, "out_of_range", "a value outside the data sheet's range"},
    ViolationRow{
        Kind::ReservedBits, "reserved_bits",
        "a bit that is not used and to be cleared to zero is set; a remark where the sheet says ignored"},
    ViolationRow{Kind::SetBaudSingle, "set_baud_single", "Set Baud Rate to an individual address (DS-V 5.2)"},
    ViolationRow{Kind::Unsupported, "unsupported", "not available on this version"},
    ViolationRow{Kind::ModeTransition, "mode_transition",
                 "not in the stepper's mode table, or not with what was loaded (DS-S 5.1, Table 4)"},
    ViolationRow{Kind::DirectionChange, "direction_change",
                 "a stepper's direction changed without a stop (DS-S 4.1, 4.2)"},
    ViolationRow{Kind::PathOverflow, "path_overflow", "a point that found the path buffer full"},
    ViolationRow{Kind::ParametersNotSet, "parameters_not_set",
                 "a stepper started before Set Parameters (DS-S 5.1)"},
    ViolationRow{
        Kind::VelocityNotLoaded, "velocity_not_loaded",
        "a profile without a velocity: a stop has set it to zero, or a stepper has never been given one "
        "(DS-V 5.2, DS-S 5.1)"},
};

/// Each kind has a row, and the rows are in the order of the kinds.
constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kViolations.size(); ++i)
        if (kViolations[i].kind != static_cast<Kind>(i))
            return false;
    return kViolations.back().kind == Kind::VelocityNotLoaded;
}
static_assert(isInOrder());

}  // namespace

std::span<const ViolationRow> violationTable() {
    return kViolations;
}

std::string_view toText(ViolationKind kind) {
    return kViolations[static_cast<std::size_t>(kind)].name;
}

void ViolationLog::add(const Violation& violation) {
    ++m_count;
    if (m_entries.size() < kCapacity)
        m_entries.push_back(violation);
}

void ViolationLog::remark(const Violation& violation) {
    if (m_remarks.size() < kCapacity)
        m_remarks.push_back(violation);
}

}  // namespace nmc::sim

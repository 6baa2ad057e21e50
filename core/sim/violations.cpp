// SPDX-License-Identifier: MIT
#include "sim/violations.h"

namespace nmc::sim {

std::string_view toText(ViolationKind kind) {
    switch (kind) {
        case ViolationKind::CommandInFlight:
            return "command_in_flight";
        case ViolationKind::CommandOverwritten:
            return "command_overwritten";
        case ViolationKind::TrapezoidInMotion:
            return "trapezoid_in_motion";
        case ViolationKind::ResetInMotion:
            return "reset_in_motion";
        case ViolationKind::ReplyCollision:
            return "reply_collision";
        case ViolationKind::WrongLength:
            return "wrong_length";
        case ViolationKind::UnknownCommand:
            return "unknown_command";
        case ViolationKind::StopBits:
            return "stop_bits";
        case ViolationKind::OutOfRange:
            return "out_of_range";
        case ViolationKind::SetBaudSingle:
            return "set_baud_single";
        case ViolationKind::Unsupported:
            return "unsupported";
        case ViolationKind::ModeTransition:
            return "mode_transition";
        case ViolationKind::DirectionChange:
            return "direction_change";
        case ViolationKind::PathOverflow:
            return "path_overflow";
        case ViolationKind::ParametersNotSet:
            return "parameters_not_set";
    }
    return "";
}

void ViolationLog::add(const Violation& violation) {
    ++m_count;
    if (m_entries.size() < kCapacity)
        m_entries.push_back(violation);
}

}  // namespace nmc::sim

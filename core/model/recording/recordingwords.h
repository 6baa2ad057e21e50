// SPDX-License-Identifier: MIT
#pragma once

// The keywords in a recording's comments, for core/model/recording*.cpp only.

#include <array>
#include <string_view>

#include "protocol/servocommands.h"

namespace nmc::words {

inline constexpr std::string_view kBehindKey = ": ";
inline constexpr std::string_view kProgram = "program";
inline constexpr std::string_view kStarted = "started";
inline constexpr std::string_view kPort = "port";
inline constexpr std::string_view kSimulated = "simulated";
/// Followed by the module's number, a space, and one of the keys below.
inline constexpr std::string_view kModule = "module ";
inline constexpr std::string_view kType = "type";
inline constexpr std::string_view kVersion = "version";
inline constexpr std::string_view kName = "name";
inline constexpr std::string_view kUnit = "unit";
inline constexpr std::string_view kOwnSymbol = "unit symbol";
inline constexpr std::string_view kPerUnit = "counts per unit";
inline constexpr std::string_view kAnalogUnit = "analog unit";
inline constexpr std::string_view kAnalogPerCount = "analog per count";
inline constexpr std::string_view kAnalogAtZero = "analog at zero";
// PIC-I/O: the scale of the first A/D input is the one above. Followed by a number from 1, a space, and one
// of the keys.
inline constexpr std::string_view kPin = "pin ";
inline constexpr std::string_view kAnalogInput = "analog ";
inline constexpr std::string_view kInputUnit = "unit";
inline constexpr std::string_view kInputPerCount = "per count";
inline constexpr std::string_view kInputAtZero = "at zero";
/// Indexed by UnitKind.
inline constexpr std::array<std::string_view, 5> kUnits{"counts or steps", "turns", "degrees", "millimetres",
                                                        "own"};

inline constexpr std::string_view kNote = "note";
inline constexpr std::string_view kGains = "gains of module ";
inline constexpr std::string_view kUnknown = " unknown";
inline constexpr std::string_view kAt = " at ";
inline constexpr std::string_view kSeconds = " s: ";
/// Calls field(word, value, range) for each gain that every version has, in the data sheet's order.
template <typename Field, typename Gains>
void forEachGain(const Field& field, Gains& gains) {
    field("kp", gains.kp, servo::kGainRange);
    field("kd", gains.kd, servo::kGainRange);
    field("ki", gains.ki, servo::kGainRange);
    field("il", gains.il, servo::kGainRange);
    field("ol", gains.ol, servo::kByteRange);
    field("cl", gains.cl, servo::kByteRange);
    field("el", gains.el, servo::kPositionErrorRange);
    field("sr", gains.sr, servo::kServoRateRange);
}
inline constexpr std::string_view kDeadband = "db";

}  // namespace nmc::words

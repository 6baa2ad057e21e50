// SPDX-License-Identifier: MIT
#pragma once

// The keywords in a recording's comments, for core/model/recording*.cpp only.

#include <array>
#include <string_view>

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
// Two names of servo::forEachGain(): a recording may lack the first, and always lacks the second.
inline constexpr std::string_view kDeadband = "db";
inline constexpr std::string_view kNotRecorded = "sm";

}  // namespace nmc::words

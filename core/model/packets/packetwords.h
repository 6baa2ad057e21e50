// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "bus/exchangerecord.h"

/// The words of the replayable log, by enum value. They are part of its format and never change.
namespace nmc::words {

inline constexpr std::array<std::string_view, 9> kPurposes{
    "connect", "poll", "operation", "check", "hold", "stop", "challenge", "flush", "lent"};
static_assert(kPurposes.size() == static_cast<std::size_t>(bus::Purpose::Lent) + 1);

inline constexpr std::array<std::string_view, 8> kEnds{"accepted",     "refused",  "silent",    "partial",
                                                       "bad_checksum", "rejected", "abandoned", "not_asked"};
static_assert(kEnds.size() == static_cast<std::size_t>(bus::ReplyResult::NotAsked) + 1);

inline constexpr std::array<std::string_view, bus::kRejections> kRejections{"uniform",
                                                                            "surplus",
                                                                            "echo",
                                                                            "identity",
                                                                            "undefined_bits",
                                                                            "homing_rose",
                                                                            "home_changed",
                                                                            "position_jump",
                                                                            "velocity_jump",
                                                                            "off_without_bits",
                                                                            "on_without_power",
                                                                            "slew_without_accel",
                                                                            "sticky_cleared",
                                                                            "both_modes",
                                                                            "moving_without_power",
                                                                            "moved_while_stopped",
                                                                            "timer_count"};

}  // namespace nmc::words

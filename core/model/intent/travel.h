// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "model/intent/intent.h"

/// How far and how fast an axis may go (TravelSettings): the one owner of that rule. Whoever moves a motor
/// asks here: plans, procedures, held motion, the panels. Positions are the chip's, as it counts now.
///
/// Limits count from home, so they are in force only while home is known (model/module/homefact.h). From
/// within a motion ends within, and from outside it goes back towards them only. What has no end of its own,
/// a run or a held motion, is sent as a move to the limit ahead, from standstill (DS-V 4.4, DS-S Table 4):
/// the chip itself ends it there, whatever becomes of this program. Pure.
namespace nmc {

enum class TravelForce : std::uint8_t {
    NotSet,
    HomeUnknown,  ///< set, and not in force
    InForce,
};
[[nodiscard]] TravelForce travelForce(const ModuleState& module);

struct TravelRange {
    std::optional<std::int32_t> lowest;
    std::optional<std::int32_t> highest;
    bool operator==(const TravelRange&) const = default;
};
/// Nothing: no limits, or not in force. What the counter does not reach is as far as it does.
[[nodiscard]] std::optional<TravelRange> travelRange(const ModuleState& module);
/// Where a motion in that direction has to end; nothing: no limit is ahead.
[[nodiscard]] std::optional<std::int32_t> travelEnd(const ModuleState& module, bool reverse);

/// Where a motor is, seen from its limits.
enum class TravelPlace : std::uint8_t { Within, AtLowest, AtHighest, BelowLowest, AboveHighest };
/// Within where no limits are in force. A servo at rest swings by a few counts about its limit.
[[nodiscard]] TravelPlace travelPlace(const ModuleState& module);

/// Why a motion is refused, and what would not be.
struct TravelProblem {
    Refusal refusal = Refusal::BeyondTravel;
    bool lowest = false;     ///< which limit
    std::int32_t limit = 0;  ///< the limit itself, as it was set
    /// The goal nearest to what was asked for that is allowed: the limit, but for the axis' backlash.
    std::int32_t nearest = 0;
    /// Where the move would turn round to take up the backlash, where that is what is beyond the limit.
    std::optional<std::int32_t> turn{};
    double velocity = 0.0;  ///< of TooFast: native, what was asked for
    double fastest = 0.0;   ///< the same, what is allowed
    bool operator==(const TravelProblem&) const = default;
};
/// Of a move from one position to another.
[[nodiscard]] std::optional<TravelProblem> beyondTravel(std::int64_t from, std::int64_t goal,
                                                        const TravelRange& range);
/// Whatever of an intent is against the rule; nothing for one that moves nothing.
[[nodiscard]] std::optional<TravelProblem> travelProblem(const Intent& intent, const ModuleState& module);
/// Of what was loaded and waits for its start.
[[nodiscard]] std::optional<TravelProblem> loadedProblem(const ModuleState& module);

/// Held motion as it may be sent: with the limit ahead as its goal.
[[nodiscard]] tl::expected<bus::HoldToMove, TravelProblem> withinTravel(bus::HoldToMove hold,
                                                                        const ModuleState& module);
/// The same of a PIC-STEP's motion.
[[nodiscard]] StepperMotion withinTravel(const StepperMotion& motion, const ModuleState& module);

}  // namespace nmc

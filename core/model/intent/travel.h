// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "model/intent/intent.h"

/// How far and how fast an axis may move (TravelSettings); the only place that decides this. Everything that
/// moves a motor uses it: plans, procedures, held motion, the panels. Positions are in terms of the chip's
/// present counter.
///
/// Limits are relative to home, so they are in force only while home is known (model/module/homefact.h). A
/// motion that starts within the limits ends within them, and one that starts outside may only lead back
/// towards them. A motion without an end, a run or a held motion, is sent as a move to the limit ahead, from
/// standstill (DS-V 4.4, DS-S Table 4): the chip itself ends it there, whatever happens to this program.
/// Pure.
namespace nmc {

enum class TravelForce : std::uint8_t {
    NotSet,
    HomeUnknown,  ///< limits are set, but not in force
    InForce,
};
[[nodiscard]] TravelForce travelForce(const ModuleState& module);

using TravelRange = bus::TravelLimits;
/// Empty: no limits, or not in force. A limit beyond the counter's range is reduced to the range.
[[nodiscard]] std::optional<TravelRange> travelRange(const ModuleState& module);
/// The position at which a motion in this direction must end; empty: there is no limit ahead.
[[nodiscard]] std::optional<std::int32_t> travelEnd(const ModuleState& module, bool reverse);

/// The motor's place relative to its limits; on a reversed axis, the user sees the negative of it.
enum class TravelPlace : std::int8_t { BelowLowest = -2, AtLowest, Within, AtHighest, AboveHighest };
/// Within if no limits are in force. At* allows for a servo at rest, which swings by a few counts about its
/// limit.
[[nodiscard]] TravelPlace travelPlace(const ModuleState& module);

/// Why a motion is not allowed, and what would be.
struct TravelProblem {
    Refusal refusal = Refusal::BeyondTravel;
    bool lowest = false;     ///< which limit
    std::int32_t limit = 0;  ///< the limit itself, without allowance for backlash
    /// The allowed goal nearest to the requested one: the limit, except for the axis's backlash.
    std::int32_t nearest = 0;
    /// Where the move would turn round to take up the backlash, if only that is beyond the limit.
    std::optional<std::int32_t> turn{};
    double velocity = 0.0;  ///< for TooFast: the requested velocity, native
    double fastest = 0.0;   ///< for TooFast: the allowed velocity, native
    bool ofChip = false;    ///< for TooFast: the chip allows no more, whatever the user has set
    bool operator==(const TravelProblem&) const = default;
};
/// The problem of a move from one position to another.
[[nodiscard]] std::optional<TravelProblem> beyondTravel(std::int64_t from, std::int64_t goal,
                                                        const TravelRange& range);
/// The problem of an intent; empty for one that moves nothing.
[[nodiscard]] std::optional<TravelProblem> travelProblem(const Intent& intent, const ModuleState& module);
/// The problem of the load that waits for its start.
[[nodiscard]] std::optional<TravelProblem> loadedProblem(const ModuleState& module);

/// The held motion as it may be sent: with the limit ahead as its goal.
[[nodiscard]] tl::expected<bus::HoldToMove, TravelProblem> withinTravel(bus::HoldToMove hold,
                                                                        const ModuleState& module);
/// The motion as it may be sent: one without an end has the limit ahead as its goal.
[[nodiscard]] ServoMotion withinTravel(const ServoMotion& motion, const ModuleState& module);
[[nodiscard]] StepperMotion withinTravel(const StepperMotion& motion, const ModuleState& module);

}  // namespace nmc

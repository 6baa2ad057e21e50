// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/strong.h"
#include "model/sequence/sequence.h"
#include "model/settings/analogscale.h"
#include "model/settings/axisscale.h"
#include "model/settings/operatorrights.h"
#include "model/settings/pinsettings.h"
#include "module/stopmanner.h"

/// What the user tells the panel about a machine: values that cannot be read from a module. The machine file
/// contains this data. Nothing here moves a motor or is sent by itself.
namespace nmc {

/// How an axis is moved by hand. Native units (model/settings/axisscale.h), magnitudes.
struct MotionSettings {
    double velocity = 0.0;      ///< for a move to a position
    double acceleration = 0.0;  ///< PIC-SERVO
    double runVelocity = 0.0;
    double holdVelocity = 0.0;  ///< for hold to move; low again after every connect
    double holdCap = 0.0;       ///< upper limit for hold to move; 0: the panel's own limit
    double stepSize = 0.0;      ///< counts, for step by N

    bool operator==(const MotionSettings&) const = default;
};

/// How far and how fast an axis may move; model/intent/travel.h defines what that forbids.
struct TravelSettings {
    std::optional<std::int32_t> lowest;   ///< counts (steps) from home; empty: no limit on this side
    std::optional<std::int32_t> highest;  ///< above `lowest`
    double fastest = 0.0;                 ///< native, for every kind of motion; 0: as fast as the module can

    [[nodiscard]] bool limited() const { return lowest || highest; }
    bool operator==(const TravelSettings&) const = default;
};

/// How an axis finds its home (DS-V 5.2, DS-S 5.1 Set Homing Mode).
struct HomingRecipe {
    using Stop = StopManner;

    // At least one condition; any of them ends the search.
    bool onLimit1 = false;
    bool onLimit2 = false;
    bool onIndex = false;          ///< PIC-SERVO
    bool onPositionError = false;  ///< PIC-SERVO: against a hard stop
    bool onCurrentLimit = false;   ///< PIC-SERVO: against a hard stop
    bool onHomeSwitch = false;     ///< PIC-STEP
    /// PIC-SERVO: the conditions above find the neighbourhood, and a second search finds the index.
    bool thenIndex = false;
    bool reverse = true;         ///< direction of the search
    double velocity = 0.0;       ///< native
    double indexVelocity = 0.0;  ///< native, for the second search, which goes in the opposite direction
    double acceleration = 0.0;   ///< native
    Stop stop = Stop::Abruptly;
    double travelLimit = 0.0;  ///< counts, for each search; above 0
    double timeLimit = 0.0;    ///< s, for each search; above 0
    bool goToHome = true;
    bool makeZero = true;  ///< makes the home position 0, so the motor goes to home first

    bool operator==(const HomingRecipe&) const = default;
};

/// The play between motor and load, compensated by approaching every goal from the same side
/// (model/intent/backlash.h).
struct BacklashSettings {
    double distance = 0.0;   ///< counts, slightly more than the play; 0: none
    bool fromAbove = false;  ///< otherwise from below

    bool operator==(const BacklashSettings&) const = default;
};

/// When a move of a PIC-SERVO has arrived, for sequences and for programs that wait (model/module/arrival.h).
struct ArrivalSettings {
    double tolerance = 0.0;  ///< counts to either side of the goal; 0: at standstill, wherever that is
    double seconds = 0.0;    ///< for which it must stay within the tolerance

    bool operator==(const ArrivalSettings&) const = default;
};

/// What a PIC-SERVO itself stops its motor at, and how (intent::ArmLimitStop).
struct ChipStop {
    bool onLimit1 = false;
    bool onLimit2 = false;
    StopManner manner = StopManner::Abruptly;
    bool onPositionError = false;
    bool onCurrentLimit = false;

    [[nodiscard]] bool any() const { return onLimit1 || onLimit2 || onPositionError || onCurrentLimit; }
    bool operator==(const ChipStop&) const = default;
};

/// The limit stop of a PIC-SERVO, as an axis uses it for each of its motions.
struct LimitStopSettings {
    bool eachMotion = false;  ///< otherwise it is armed by hand
    ChipStop stop{.onLimit1 = true, .onLimit2 = true};

    bool operator==(const LimitStopSettings&) const = default;
};

/// A named place that displayed and typed positions of an axis can be counted from, such as a fixture.
struct WorkOffset {
    std::string name;         ///< not empty, and unique on its axis
    std::int32_t counts = 0;  ///< counts (steps) from home

    bool operator==(const WorkOffset&) const = default;
};

inline constexpr std::size_t kMaxWorkOffsets = 50;  ///< of an axis

/// The settings of one module.
struct AxisSettings {
    std::string name;                        ///< UTF-8, as the user typed it; empty: "Module 1"
    std::optional<ModuleIdentity> expected;  ///< the module present when this was set
    AxisUnit unit;
    MotionSettings motion;
    TravelSettings travel;
    BacklashSettings backlash;
    ArrivalSettings arrival;
    std::optional<HomingRecipe> homing;
    LimitStopSettings limitStop;
    std::vector<WorkOffset> workOffsets;
    AnalogScale analog;
    // PIC-SERVO
    std::optional<servo::SetGain> gains;  ///< as entered in the fields, sent or not
    std::optional<servo::IoControl> io;
    /// SC: only this bit of its I/O Control is saved; the others can destroy an amplifier and are only sent
    /// on request.
    std::optional<bool> fastPath;
    // PIC-STEP
    std::optional<stepper::SetParameters> parameters;  ///< as entered in the fields, sent or not
    double accelerationTime = 0.0;                     ///< 1..255, for profiles; 0: not set
    std::array<std::string, 5> outputNames;            ///< OUT1..OUT5
    std::array<std::string, 2> inputNames;             ///< IN1, IN2
    // PIC-I/O
    std::optional<PinSettings> pins;

    bool operator==(const AxisSettings&) const = default;
};

/// True if an axis was set for another type of module than the one that is there. Its numbers are then in the
/// units of another chip: steps/s are not counts/tick, and a step is not a count.
[[nodiscard]] inline bool isOtherType(const std::optional<ModuleIdentity>& expected,
                                      const ModuleIdentity& there) {
    return expected && expected->type != there.type && *expected != kUnheardModule && there != kUnheardModule;
}
/// What is true of an axis whichever module is there: all of it for the type that it was set for, and for
/// another type only its name, and what is expected. Pure.
[[nodiscard]] inline AxisSettings usable(const AxisSettings& axis, const ModuleIdentity& there) {
    if (!isOtherType(axis.expected, there))
        return axis;
    AxisSettings unset;
    unset.name = axis.name;
    unset.expected = axis.expected;
    return unset;
}

/// A module is in exactly one group (DS-V 4.1); FF, the initial group, is not one of these.
struct GroupSettings {
    std::uint8_t address = 0x81;  ///< 0x80..0xFE
    std::string name;
    std::vector<ModuleIndex> members;
    std::optional<ModuleIndex> leader;  ///< one of the members, which answers for the group

    bool operator==(const GroupSettings&) const = default;
};

struct Machine {
    std::string name;
    std::uint32_t baud = 0;          ///< the rate in use; 0: not specified
    std::vector<AxisSettings> axes;  ///< by ModuleIndex: the module farthest from the host first
    std::vector<GroupSettings> groups;
    Program program{};
    /// The order in which "Home all" homes the axes; axes not listed come last.
    std::vector<ModuleIndex> homeOrder{};
    std::optional<OperatorRights> operatorRights{};  ///< empty: the defaults

    /// The settings of a module, or defaults if it has none yet.
    [[nodiscard]] const AxisSettings& axis(ModuleIndex module) const {
        static const AxisSettings none;
        return module.value() < axes.size() ? axes[module.value()] : none;
    }
    bool operator==(const Machine&) const = default;
};

}  // namespace nmc

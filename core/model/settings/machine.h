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
#include "protocol/servocommands.h"
#include "protocol/status.h"
#include "protocol/steppercommands.h"

/// What a user tells the panel about a machine: values that no module can be asked for. The machine file is
/// this, written down. Nothing here moves a motor or is sent by itself.
namespace nmc {

/// How an axis is moved by hand; native units (model/settings/axisscale.h), magnitudes.
struct MotionSettings {
    double velocity = 0.0;      ///< of a move to a position
    double acceleration = 0.0;  ///< PIC-SERVO
    double runVelocity = 0.0;
    double holdVelocity = 0.0;  ///< hold to move; low again after every connect
    double holdCap = 0.0;       ///< hold to move goes no faster; 0: the panel's own cap
    double stepSize = 0.0;      ///< counts, of step by N

    bool operator==(const MotionSettings&) const = default;
};

/// How far and how fast an axis may go; model/intent/travel.h says what that forbids.
struct TravelSettings {
    std::optional<std::int32_t> lowest;   ///< counts (steps) from home; empty: no limit on that side
    std::optional<std::int32_t> highest;  ///< above `lowest`
    double fastest = 0.0;                 ///< native, of every kind of motion; 0: as fast as the module can

    [[nodiscard]] bool limited() const { return lowest || highest; }
    bool operator==(const TravelSettings&) const = default;
};

/// How an axis finds its home (DS-V 5.2, DS-S 5.1 Set Homing Mode).
struct HomingRecipe {
    enum class Stop : std::uint8_t { Abruptly, Smoothly, MotorOff };

    // At least one; any of them ends the search.
    bool onLimit1 = false;
    bool onLimit2 = false;
    bool onIndex = false;          ///< PIC-SERVO
    bool onPositionError = false;  ///< PIC-SERVO: against a hard stop
    bool onCurrentLimit = false;   ///< PIC-SERVO: against a hard stop
    bool onHomeSwitch = false;     ///< PIC-STEP
    /// PIC-SERVO: what is chosen above finds the neighbourhood, a second search the index.
    bool thenIndex = false;
    bool reverse = true;         ///< direction of the search
    double velocity = 0.0;       ///< native
    double indexVelocity = 0.0;  ///< native, of the second search; its direction is the other one
    double acceleration = 0.0;   ///< native
    Stop stop = Stop::Abruptly;
    double travelLimit = 0.0;  ///< counts, of each search; above 0
    double timeLimit = 0.0;    ///< s, of each search; above 0
    bool goToHome = true;
    bool makeZero = true;  ///< where it stands becomes 0, so it goes to home first

    bool operator==(const HomingRecipe&) const = default;
};

/// The play between motor and load, taken up by coming to every goal from the same side
/// (model/intent/backlash.h).
struct BacklashSettings {
    double distance = 0.0;   ///< counts, somewhat more than the play; 0: none
    bool fromAbove = false;  ///< otherwise from below

    bool operator==(const BacklashSettings&) const = default;
};

/// The limit stop of a PIC-SERVO (intent::ArmLimitStop) as an axis has it for each of its motions.
struct LimitStopSettings {
    bool eachMotion = false;  ///< otherwise it is armed by hand
    bool onLimit1 = true;
    bool onLimit2 = true;
    bool onPositionError = false;
    bool onCurrentLimit = false;
    HomingRecipe::Stop manner = HomingRecipe::Stop::Abruptly;

    bool operator==(const LimitStopSettings&) const = default;
};

/// One module as the user knows it.
struct AxisSettings {
    std::string name;                        ///< UTF-8, as the user typed it; empty: "Module 1"
    std::optional<ModuleIdentity> expected;  ///< what was there when this was set
    AxisUnit unit;
    MotionSettings motion;
    TravelSettings travel;
    BacklashSettings backlash;
    std::optional<HomingRecipe> homing;
    LimitStopSettings limitStop;
    AnalogScale analog;
    // PIC-SERVO
    std::optional<servo::SetGain> gains;  ///< as they stand in the fields, sent or not
    std::optional<servo::IoControl> io;
    /// SC: of its I/O Control only this is kept; the rest can destroy an amplifier, and is for the hand that
    /// asks.
    std::optional<bool> fastPath;
    // PIC-STEP
    std::optional<stepper::SetParameters> parameters;  ///< as they stand in the fields, sent or not
    double accelerationTime = 0.0;                     ///< 1..255, of profiles; 0: not set
    std::array<std::string, 5> outputNames;            ///< OUT1..OUT5
    std::array<std::string, 2> inputNames;             ///< IN1, IN2
    // PIC-I/O
    std::optional<PinSettings> pins;

    bool operator==(const AxisSettings&) const = default;
};

/// A module is in exactly one group (DS-V 4.1); FF, where all begin, is none of these.
struct GroupSettings {
    std::uint8_t address = 0x81;  ///< 0x80..0xFE
    std::string name;
    std::vector<ModuleIndex> members;
    std::optional<ModuleIndex> leader;  ///< one of the members; it answers for the group

    bool operator==(const GroupSettings&) const = default;
};

struct Machine {
    std::string name;
    std::uint32_t baud = 0;          ///< the rate it is used at; 0: not said
    std::vector<AxisSettings> axes;  ///< by ModuleIndex: the module farthest from the host first
    std::vector<GroupSettings> groups;
    Program program{};
    /// In which order "Home all" goes through the axes; those that are not in it come last.
    std::vector<ModuleIndex> homeOrder{};
    std::optional<OperatorRights> operatorRights{};  ///< not said: as they are by themselves

    /// The settings of a module that may not have any yet.
    [[nodiscard]] const AxisSettings& axis(ModuleIndex module) const {
        static const AxisSettings none;
        return module.value() < axes.size() ? axes[module.value()] : none;
    }
    bool operator==(const Machine&) const = default;
};

}  // namespace nmc

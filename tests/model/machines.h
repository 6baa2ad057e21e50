// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "model/machinefile/machinecompare.h"
#include "model/settings/machine.h"

/// Machines with something in every part; arbitrary ones are in anymachine.h.
namespace nmc::testing_support {

inline AxisSettings servoAxis() {
    AxisSettings axis;
    axis.name = "X axis";
    axis.expected = ModuleIdentity{ModuleType::Servo, 4};
    axis.unit = {UnitKind::Millimetres, 2000.0, ""};
    axis.motion = {8.0, 0.02, 4.0, 0.5, 2.0, 1000.0};
    HomingRecipe homing;
    homing.onLimit1 = true;
    homing.velocity = 1.5;
    homing.indexVelocity = 0.25;
    homing.acceleration = 0.01;
    homing.travelLimit = 50'000;
    homing.timeLimit = 30;
    axis.homing = homing;
    axis.gains = servo::SetGain{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{3}};
    axis.io = servo::IoControl{true, false, false, true};
    return axis;
}

inline AxisSettings stepAxis() {
    AxisSettings axis;
    axis.name = "Drehteller ä";
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    axis.unit = {UnitKind::Own, 17.5, "notches"};
    axis.motion.velocity = 1'200.0;
    axis.parameters = stepper::SetParameters{stepper::SpeedMode::X2, false, false, true, 3, 90, 40, 60};
    axis.accelerationTime = 100.0;
    axis.outputNames[4] = "Coolant";
    axis.inputNames[0] = "Door";
    return axis;
}

inline Machine mill() {
    return {"Mill",
            115'200,
            {servoAxis(), stepAxis()},
            {{0x81, "Table", {ModuleIndex(0), ModuleIndex(1)}, ModuleIndex(1)}},
            {},
            {},
            OperatorRights{.moves = true}};
}

/// The mill with two points and every kind of sequence row.
inline Machine taughtMill() {
    Machine machine = mill();
    constexpr ModuleIndex kX{0};
    constexpr ModuleIndex kTable{1};
    machine.program.points = {{"Pick ä", {{kX, -1'500, true}, {kTable, 40, false}}},
                              {"Place", {{kX, 0x7FFFFFFF, true}}}};
    machine.program.sequences = {
        {"Main",
         {action::Home{kX}, action::MoveTo{"Pick ä", false, true, 100}, action::SetOutput{kTable, 5, true},
          action::Wait{0.25}, action::WaitForInput{kTable, InputPin::HomeSwitch, false, 3.5},
          action::MoveTo{"Place", true, false, 7}, action::WaitForArrival{}, action::Repeat{1, 0}}},
        {"Twice", {action::Call{"Main"}, action::Repeat{0, 2}}}};
    machine.homeOrder = {kTable, kX};
    return machine;
}

/// What was found to differ.
inline std::vector<PartId> ids(const std::vector<Difference>& rows) {
    std::vector<PartId> found;
    for (const Difference& row : rows)
        found.push_back(row.id);
    return found;
}

}  // namespace nmc::testing_support

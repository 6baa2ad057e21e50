// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/intent/rounds.h"
#include "model/intent/steppermotion.h"

/// Requests of the operator to a PIC-STEP, besides those that both motor chips have (intent.h).
namespace nmc::stepperintent {

/// Sets the parameters, which is required before any motion (DS-S 5.1).
struct SetParameters {
    stepper::SetParameters parameters;
};
/// Sets OUT1..OUT5, all at once, as bits 0..4.
struct SetOutputs {
    std::uint8_t outputs = 0;
};
struct Move {
    StepperMotion motion;
};
/// A motion like Move, to be started by intent::StartLoaded.
struct LoadMove {
    StepperMotion motion;
};
/// Stops, waits for standstill, then does a Move, for changes that Table 4 does not allow in motion. A
/// procedure.
struct ChangeMotion {
    StepperMotion motion;
};
/// Makes moves by a distance, like intent::MoveBy. A procedure.
struct MoveBy {
    Rounds moves;
    std::uint8_t speed = 1;  ///< 1..250
    std::uint8_t accelerationTime = 1;
};
/// Moves to the known home, like intent::GoHome.
struct GoHome {
    std::uint8_t speed = 1;  ///< 1..250
    std::uint8_t accelerationTime = 1;
};

}  // namespace nmc::stepperintent

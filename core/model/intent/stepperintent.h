// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/intent/rounds.h"
#include "model/intent/steppermotion.h"

/// What the operator asks of one PIC-STEP, beside what both chips understand (intent.h).
namespace nmc::stepperintent {

/// Needed before any motion (DS-S 5.1).
struct SetParameters {
    stepper::SetParameters parameters;
};
/// OUT1..OUT5, all at once, as bits 0..4.
struct SetOutputs {
    std::uint8_t outputs = 0;
};
struct Move {
    StepperMotion motion;
};
/// As Move, to be started by intent::StartLoaded.
struct LoadMove {
    StepperMotion motion;
};
/// A procedure: stop, wait until it stands, then Move. For what Table 4 does not allow in motion.
struct ChangeMotion {
    StepperMotion motion;
};
/// As intent::MoveBy. A procedure.
struct MoveBy {
    Rounds moves;
    std::uint8_t speed = 1;  ///< 1..250
    std::uint8_t accelerationTime = 1;
};
/// As intent::GoHome.
struct GoHome {
    std::uint8_t speed = 1;  ///< 1..250
    std::uint8_t accelerationTime = 1;
};

}  // namespace nmc::stepperintent

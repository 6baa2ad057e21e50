// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "protocol/steppercommands.h"

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

}  // namespace nmc::stepperintent

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/iocommands.h"

/// Requests of the operator to a PIC-I/O. Pins and PWM outputs are numbered from 0.
namespace nmc::iointent {

struct SetDirection {
    std::uint16_t inputs = io::kAllPins;
};
/// Sets a single output; the others stay as they are.
struct SetOutput {
    unsigned pin = 0;
    bool high = false;
};
/// One command sets both PWM outputs: the one that is not meant stays as it is.
struct SetPwm {
    unsigned output = 0;
    std::uint8_t value = 0;
    std::optional<std::uint8_t> other{};  ///< of the other one, in case its present value is unknown
};
/// Sets the timer mode; the count starts at 0.
struct SetTimer {
    io::SetTimerMode mode;
};
/// Stores outputs for SynchOutput, of this module or of its group.
struct StoreOutputs {
    io::SetSynchOutput outputs;
};
struct SynchOutput {};
/// Latches pins and counter, and reads the latched values.
struct SynchInput {};

}  // namespace nmc::iointent

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// Moves by a distance, repeated.
struct Rounds {
    std::int32_t counts = 0;  ///< of one move, signed; steps for a PIC-STEP
    unsigned rounds = 1;
    double pause = 0.0;         ///< s, after each move
    bool backAndForth = false;  ///< each round goes there and back
};

}  // namespace nmc

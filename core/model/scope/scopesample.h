// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "base/time.h"

namespace nmc {

/// One status reply as the scope keeps it: 32 bytes, because an evening has millions of them. What is not
/// known is NaN. Counts are steps on a PIC-STEP.
struct ScopeSample {
    static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

    TimePoint time;  ///< when the module latched it (bus::Sample)
    std::int32_t position = 0;
    float error = kUnknown;      ///< calculated command position minus position, counts
    float errorLow = kUnknown;   ///< the true error is not below this...
    float errorHigh = kUnknown;  ///< ... nor above this
    float velocity = kUnknown;   ///< counts/s, from the positions of the last 20 ms
    std::uint8_t analog = 0;     ///< as last reported
    std::uint8_t status = 0;
    std::uint8_t aux = 0;  ///< as last reported; PIC-STEP: its inputs
    /// Data is missing between the sample before and this one.
    bool gapBefore = false;

    [[nodiscard]] bool errorKnown() const { return error == error; }
    [[nodiscard]] double command() const {
        return static_cast<double>(position) + static_cast<double>(error);
    }
};

static_assert(sizeof(ScopeSample) == 32);

}  // namespace nmc

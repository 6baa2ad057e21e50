// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "base/time.h"

namespace nmc {

/// One status reply as the scope keeps it: 32 bytes, because an evening has millions of them. What is not
/// known is NaN. Counts are steps on a PIC-STEP. A PIC-I/O has no motor: its values are in the places named
/// here, and ScopeSignal says which is which.
struct ScopeSample {
    static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

    TimePoint time;              ///< when the module latched it (bus::Sample)
    std::int32_t position = 0;   ///< PIC-I/O: counter or timer, less 2^31
    float error = kUnknown;      ///< calculated command position minus position, counts; PIC-I/O: A/D 2
    float errorLow = kUnknown;   ///< the true error is not below this...
    float errorHigh = kUnknown;  ///< ... nor above this
    float velocity = kUnknown;   ///< counts/s, from the positions of the last 20 ms; PIC-I/O: A/D 3
    std::uint8_t analog = 0;     ///< as last reported; PIC-I/O: A/D 1
    std::uint8_t status = 0;     ///< PIC-I/O: IO1 to IO8
    std::uint8_t aux = 0;        ///< as last reported; PIC-STEP: its inputs; PIC-I/O: IO9 to IO12
    /// Data is missing between the sample before and this one.
    bool gapBefore : 1 = false;
    bool io : 1 = false;       ///< of a PIC-I/O
    bool counted : 1 = false;  ///< PIC-I/O: this reply had the counter, which otherwise stands as it was

    [[nodiscard]] bool errorKnown() const { return error == error; }
    [[nodiscard]] double command() const {
        return static_cast<double>(position) + static_cast<double>(error);
    }
    /// PIC-I/O. Less 2^31 its 32 bits have the order of numbers with a sign.
    [[nodiscard]] std::uint32_t counter() const { return static_cast<std::uint32_t>(position) ^ kTopBit; }
    void setCounter(std::uint32_t count) { position = static_cast<std::int32_t>(count ^ kTopBit); }
    static constexpr std::uint32_t kTopBit = 0x8000'0000;
};

static_assert(sizeof(ScopeSample) == 32);

}  // namespace nmc

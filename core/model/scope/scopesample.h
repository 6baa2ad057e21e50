// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "base/time.h"

namespace nmc {

/// One status reply as the scope keeps it: 32 bytes, because an evening yields millions of them. Unknown
/// values are NaN. Counts are steps on a PIC-STEP. A PIC-I/O has no motor: its values are in the members
/// named here, and ScopeSignal defines which is which.
struct ScopeSample {
    static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

    TimePoint time;              ///< time at which the module latched it (bus::Sample)
    std::int32_t position = 0;   ///< PIC-I/O: counter or timer, minus 2^31
    float error = kUnknown;      ///< calculated command position minus position, counts; PIC-I/O: A/D 2
    float errorLow = kUnknown;   ///< the true error is not below this...
    float errorHigh = kUnknown;  ///< ... nor above this
    float velocity = kUnknown;   ///< counts/s, from the positions of the last 20 ms; PIC-I/O: A/D 3
    std::uint8_t analog = 0;     ///< last reported value; PIC-I/O: A/D 1
    std::uint8_t status = 0;     ///< PIC-I/O: IO1 to IO8
    std::uint8_t aux = 0;        ///< last reported value; PIC-STEP: its inputs; PIC-I/O: IO9 to IO12
    /// Data are missing between the previous sample and this one.
    bool gapBefore : 1 = false;
    bool io : 1 = false;       ///< sample of a PIC-I/O
    bool counted : 1 = false;  ///< PIC-I/O: this reply contained the counter; otherwise its last value is
                               ///< kept

    [[nodiscard]] bool errorKnown() const { return error == error; }
    [[nodiscard]] double command() const {
        return static_cast<double>(position) + static_cast<double>(error);
    }
    /// PIC-I/O only. Subtracting 2^31 gives the 32-bit counter the order of signed numbers.
    [[nodiscard]] std::uint32_t counter() const { return static_cast<std::uint32_t>(position) ^ kTopBit; }
    void setCounter(std::uint32_t count) { position = static_cast<std::int32_t>(count ^ kTopBit); }
    static constexpr std::uint32_t kTopBit = 0x8000'0000;
};

static_assert(sizeof(ScopeSample) == 32);

/// A value computed from samples, in the form of a calculated error, because that has bounds.
[[nodiscard]] inline ScopeSample derivedValue(TimePoint time, double likely, double low, double high,
                                              bool gapBefore) {
    return {.time = time,
            .error = static_cast<float>(likely),
            .errorLow = static_cast<float>(low),
            .errorHigh = static_cast<float>(high),
            .gapBefore = gapBefore};
}

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

namespace nmc {

/// How a loop follows a sine of its command position.
struct FrequencyPoint {
    double hertz = 0.0;
    /// T: position over command; its magnitude and phase are those of a Bode plot.
    std::complex<double> closed;
    /// One standard deviation of `closed`, in any direction, from how well the sine explains the positions.
    double doubt = 0.0;
    /// Counts, rms: what of the position is no sine of that frequency, nor the staircase of the command.
    double missed = 0.0;

    /// L = T / (1 - T): what the loop makes of its error.
    [[nodiscard]] std::complex<double> open() const { return closed / (1.0 - closed); }
    bool operator==(const FrequencyPoint&) const = default;
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <complex>

namespace nmc {

/// The response of a loop to a sine of its command position.
struct FrequencyPoint {
    double hertz = 0.0;
    /// T, position over command; its magnitude and phase form the Bode plot.
    std::complex<double> closed;
    /// One standard deviation of `closed` in any direction, from the residuals of the sine fit.
    double doubt = 0.0;
    /// Counts rms: the part of the position that is neither a sine of that frequency nor the staircase of the
    /// command.
    double missed = 0.0;
    /// OL or IL cut off part of what the filter would have put out, or may have: T is that of the amplitude.
    bool limited = false;

    /// L = T / (1 - T), the open-loop response.
    [[nodiscard]] std::complex<double> open() const { return closed / (1.0 - closed); }
    bool operator==(const FrequencyPoint&) const = default;
};

}  // namespace nmc

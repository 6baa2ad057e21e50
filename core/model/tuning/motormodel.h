// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/response/responsemetrics.h"
#include "model/tuning/loopmodel.h"

namespace nmc {

/// Hz; the range in which a resonance of the motor with its load is suspected.
inline constexpr double kLowestResonance = 40.0;
inline constexpr double kHighestResonance = 400.0;

/// A motor identified from its responses. The doubt of each constant is one standard deviation; meanings and
/// units are those of MotorConstants.
struct MotorModel {
    static constexpr std::size_t kConstants = 7;
    using Matrix = std::array<std::array<double, kConstants>, kConstants>;

    Measured gain;
    Measured timeConstant;
    Measured friction;
    Measured load;
    Measured delay;
    Measured deadband;
    Measured play;
    double noise = 0.0;  ///< counts rms, encoder noise
    /// Hz; a second mass on a spring with a higher resonance than this would not have been visible. Empty:
    /// there is no second mass.
    std::optional<double> rigidUpTo;
    /// Correlation of the errors of two constants, -1..1, in the order above: for example, when the gain was
    /// found too low, the time constant usually was too.
    Matrix correlation = independent();

    [[nodiscard]] MotorConstants constants() const;
    /// True when the gain is known to 15 %, and the friction to 15 % or one PWM count: accurate enough to
    /// base gains on.
    [[nodiscard]] bool isSure() const;
    /// Motors that explain the steps equally well, drawn from the doubts; every call returns the same ones.
    /// Pure.
    [[nodiscard]] std::vector<MotorConstants> drawn(std::size_t count) const;

private:
    [[nodiscard]] static constexpr Matrix independent() {
        Matrix one{};
        for (std::size_t i = 0; i < kConstants; ++i)
            one[i][i] = 1.0;
        return one;
    }
};

}  // namespace nmc

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/response/responsemetrics.h"
#include "model/tuning/loopmodel.h"

namespace nmc {

/// Hz; where motors are suspected of a resonance with what they drive.
inline constexpr double kLowestResonance = 40.0;
inline constexpr double kHighestResonance = 400.0;

/// A motor found from how it answered, each constant with one standard deviation as its doubt; meanings and
/// units as in MotorConstants.
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
    double noise = 0.0;  ///< counts rms, of the encoder
    /// Hz; a second mass on a spring that resonates at a higher frequency would not have shown. Empty: there
    /// is none.
    std::optional<double> rigidUpTo;
    /// How far the errors of two constants go together, -1..1, in the order above: where the gain was found
    /// too low, the time constant usually was too.
    Matrix correlation = independent();

    [[nodiscard]] MotorConstants constants() const;
    /// Gain and friction are known to 15 %, friction at least to a PWM count: gains can be built on it.
    [[nodiscard]] bool isSure() const;
    /// Motors that explain the steps as well, drawn from the doubts; the same ones with every call. Pure.
    [[nodiscard]] std::vector<MotorConstants> drawn(std::size_t count) const;

    [[nodiscard]] static MotorModel exactly(const MotorConstants& motor);

private:
    [[nodiscard]] static constexpr Matrix independent() {
        Matrix one{};
        for (std::size_t i = 0; i < kConstants; ++i)
            one[i][i] = 1.0;
        return one;
    }
};

}  // namespace nmc

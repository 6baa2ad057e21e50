// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "protocol/servocommands.h"
#include "sim/motorplant.h"

namespace nmc::testing_support {

struct TrueMargins {
    double phaseDegrees = 180.0;
    double gain = std::numeric_limits<double>::infinity();
};

/// The margins of the simulator's motor in the control loop of DS-V 4.3, from its physics: current, speed,
/// position and, if there is one, the second mass on its spring. The matrix exponential advances them by one
/// servo tick. Dry friction is left out.
[[nodiscard]] inline TrueMargins trueMargins(const sim::MotorParameters& p, const servo::SetGain& gains) {
    constexpr int kCurrent = 0, kSpeed = 1, kPosition = 2, kTwist = 3, kSecond = 4, kVolts = 5;
    const double tick = 512e-6 * std::max<int>(gains.sr, 1);
    Eigen::Matrix<double, 6, 6> rates = Eigen::Matrix<double, 6, 6>::Zero();
    rates(kCurrent, kCurrent) = -p.resistanceOhm / p.inductanceHenry;
    rates(kCurrent, kSpeed) = -p.motorConstant / p.inductanceHenry;
    rates(kCurrent, kVolts) = p.supplyVolts / (255 - p.amplifierDeadbandPwm) / p.inductanceHenry;
    rates(kSpeed, kCurrent) = p.motorConstant / p.inertiaKgM2;
    rates(kSpeed, kSpeed) = -p.viscousNmS / p.inertiaKgM2;
    rates(kPosition, kSpeed) = p.countsPerTurn / (2 * std::numbers::pi);
    if (const double second = p.elasticInertiaKgM2; second > 0) {
        const double reduced = second * p.inertiaKgM2 / (second + p.inertiaKgM2);
        const double swing = 2 * std::numbers::pi * p.resonanceHz;
        const double stiffness = swing * swing * reduced;
        const double damping = 2 * 0.02 * swing * reduced;  // a fiftieth of the critical damping
        rates(kSpeed, kTwist) = -stiffness / p.inertiaKgM2;
        rates(kSpeed, kSpeed) -= damping / p.inertiaKgM2;
        rates(kSpeed, kSecond) = damping / p.inertiaKgM2;
        rates(kTwist, kSpeed) = 1;
        rates(kTwist, kSecond) = -1;
        rates(kSecond, kTwist) = stiffness / second;
        rates(kSecond, kSpeed) = damping / second;
        rates(kSecond, kSecond) = -damping / second;
    }
    const Eigen::Matrix<double, 6, 6> next = (rates * tick).exp();
    using Complex = std::complex<double>;
    const auto loopAt = [&](double hertz) {
        const Complex z = std::polar(1.0, 2 * std::numbers::pi * hertz * tick);
        Eigen::Matrix<Complex, 5, 5> from = -next.topLeftCorner<5, 5>().cast<Complex>();
        from.diagonal().array() += z;
        const Eigen::Matrix<Complex, 5, 1> by = next.topRightCorner<5, 1>().cast<Complex>();
        const Complex motor = from.partialPivLu().solve(by)(kPosition);
        const Complex change = 1.0 - 1.0 / z;
        const double ki = gains.il > 0 ? gains.ki / 256.0 : 0.0;
        return (1.0 * gains.kp + 1.0 * gains.kd * change + ki / change) / 256.0 * motor;
    };
    TrueMargins margins;
    Complex before = loopAt(0.01);
    for (double hertz = 0.0101; hertz < 0.5 / tick; hertz *= 1.005) {
        const Complex now = loopAt(hertz);
        if (std::abs(before) >= 1 && std::abs(now) < 1)
            margins.phaseDegrees = std::min(margins.phaseDegrees, std::arg(-now) * 180 / std::numbers::pi);
        if (now.real() < 0 && before.imag() < 0 && now.imag() >= 0)
            margins.gain = std::min(margins.gain, -1 / now.real());
        before = now;
    }
    const double last = loopAt(0.5 / tick).real();
    if (last < 0)
        margins.gain = std::min(margins.gain, -1 / last);
    return margins;
}

}  // namespace nmc::testing_support

// SPDX-License-Identifier: MIT
#include "model/tuning/predict.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace nmc {

namespace {

using Complex = std::complex<double>;

/// From PWM to position over one servo tick, which begins with the rest of the delay: `late` comes from the
/// PWM value of the tick that is a whole delay ago, `early` from the one before that.
struct TickOfMotor {
    double keeps = 0.0;                          ///< part of the velocity that is left
    double coasts = 0.0;                         ///< s; counts by counts/s
    double lateSpeed = 0.0, earlySpeed = 0.0;    ///< counts/s by PWM count
    double lateTravel = 0.0, earlyTravel = 0.0;  ///< counts by PWM count
    int wholeDelay = 0;                          ///< ticks
};

[[nodiscard]] TickOfMotor tickOf(const MotorConstants& motor, double tick) {
    TickOfMotor of;
    const double delay = std::clamp(motor.delay, 0.0, tick * double{Loop::kLongestDelay});
    of.wholeDelay = static_cast<int>(delay / tick);
    const double late = tick - (delay - of.wholeDelay * tick);
    const auto gone = [&](double seconds) { return -std::expm1(-seconds / motor.timeConstant); };
    of.keeps = 1 - gone(tick);
    of.coasts = motor.timeConstant * gone(tick);
    of.lateSpeed = motor.gain * gone(late);
    of.earlySpeed = motor.gain * gone(tick) - of.lateSpeed;
    of.lateTravel = motor.gain * (late - motor.timeConstant * gone(late));
    of.earlyTravel = motor.gain * (tick - motor.timeConstant * gone(tick)) - of.lateTravel;
    return of;
}

[[nodiscard]] Complex openLoop(const TickOfMotor& motor, const servo::SetGain& gains, Complex z) {
    const Complex before = 1.0 / z;
    Complex filter = 1.0 * gains.kp + 1.0 * gains.kd * (1.0 - before);
    if (gains.ki > 0 && gains.il > 0)
        filter += gains.ki / 256.0 / (1.0 - before);
    const Complex speed = (motor.lateSpeed + motor.earlySpeed * before) / (z - motor.keeps);
    const Complex way = (motor.lateTravel + motor.earlyTravel * before + motor.coasts * speed) / (z - 1.0);
    return filter / 256.0 * way * std::pow(before, motor.wholeDelay);
}

/// Position, velocity, running sum over 256, error before, PWM values of the ticks before: what a tick makes
/// of them, for a command of 0.
[[nodiscard]] bool isStable(const TickOfMotor& motor, const servo::SetGain& gains) {
    constexpr Eigen::Index kPosition = 0, kVelocity = 1, kSum = 2, kBefore = 3, kSent = 4;
    const Eigen::Index size = kSent + motor.wholeDelay + 1;
    const bool integrates = gains.ki > 0 && gains.il > 0;
    // The PWM value of this tick, in terms of the state.
    Eigen::VectorXd sent = Eigen::VectorXd::Zero(size);
    const double ki = integrates ? gains.ki : 0.0;
    sent[kPosition] = -(gains.kp + 1.0 * gains.kd + ki / 256) / 256;
    sent[kBefore] = -1.0 * gains.kd / 256;
    sent[kSum] = ki / 256;
    const auto pwm = [&](Eigen::Index ago) {
        return ago == 0 ? sent : Eigen::VectorXd(Eigen::VectorXd::Unit(size, kSent + ago - 1));
    };
    const Eigen::VectorXd late = pwm(motor.wholeDelay);
    const Eigen::VectorXd early = pwm(motor.wholeDelay + 1);
    Eigen::MatrixXd next = Eigen::MatrixXd::Zero(size, size);
    next(kPosition, kPosition) = 1;
    next(kPosition, kVelocity) = motor.coasts;
    next.row(kPosition) += (motor.lateTravel * late + motor.earlyTravel * early).transpose();
    next(kVelocity, kVelocity) = motor.keeps;
    next.row(kVelocity) += (motor.lateSpeed * late + motor.earlySpeed * early).transpose();
    if (integrates) {
        next(kSum, kSum) = 1;
        next(kSum, kPosition) = -1.0 / 256;
    }
    next(kBefore, kPosition) = -1;
    for (Eigen::Index ago = 1; ago <= motor.wholeDelay + 1; ++ago)
        next.row(kSent + ago - 1) = pwm(ago - 1).transpose();
    return next.eigenvalues().cwiseAbs().maxCoeff() < 1;
}

}  // namespace

LoopStart standing(const MotorConstants& motor, const servo::SetGain& gains, double command, double held) {
    LoopStart start{command + 0.5, command, 0.0};
    if (gains.ki > 0)
        start.integral = std::clamp((held * motor.friction - motor.load) * 256 / gains.ki, -1.0 * gains.il,
                                    1.0 * gains.il);
    const double left = -motor.load - start.integral * gains.ki / 256;
    const double byError = std::max(0.0, std::abs(left) - motor.friction);
    if (gains.kp > 0)
        start.position -= std::copysign(std::ceil(byError * 256 / gains.kp), left);
    return start;
}

Complex openLoopAt(const MotorConstants& motor, const servo::SetGain& gains, double hertz) {
    const double tick = servoTickOf(gains);
    return openLoop(tickOf(motor, tick), gains, std::polar(1.0, 2 * std::numbers::pi * hertz * tick));
}

LoopMargins marginsOf(const MotorConstants& motor, const servo::SetGain& gains) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    constexpr double kLowest = 0.01;  // Hz
    constexpr double kStep = 1.01;
    const double tick = servoTickOf(gains);
    const TickOfMotor of = tickOf(motor, tick);
    LoopMargins margins{180.0, std::numeric_limits<double>::infinity(), 0.0, isStable(of, gains)};
    const auto at = [&](double hertz) {
        return openLoop(of, gains, std::polar(1.0, 2 * std::numbers::pi * hertz * tick));
    };
    double before = kLowest;
    Complex loopBefore = at(before);
    for (double hertz = kLowest * kStep; hertz < 0.5 / tick; hertz *= kStep) {
        const Complex loop = at(hertz);
        // A straight line between two points that are this close.
        if (std::abs(loopBefore) >= 1 && std::abs(loop) < 1) {
            const double part = (std::abs(loopBefore) - 1) / (std::abs(loopBefore) - std::abs(loop));
            const Complex there = loopBefore + part * (loop - loopBefore);
            // Less than nothing where it has gone beyond -180 degrees.
            const double margin = std::arg(-there) * kDegrees;
            if (margin < margins.phaseDegrees) {
                margins.phaseDegrees = margin;
                margins.crossover = before + part * (hertz - before);
            }
        }
        if (loopBefore.real() < 0 && loopBefore.imag() < 0 && loop.imag() >= 0) {
            const double part = loopBefore.imag() / (loopBefore.imag() - loop.imag());
            const double there = loopBefore.real() + part * (loop.real() - loopBefore.real());
            margins.gain = std::min(margins.gain, -1 / there);
        }
        before = hertz;
        loopBefore = loop;
    }
    // At half the servo rate the loop is a real number.
    const double last = openLoop(of, gains, -1.0).real();
    if (last < 0)
        margins.gain = std::min(margins.gain, -1 / last);
    return margins;
}

ResponseRecord reckonStep(const MotorConstants& motor, const servo::SetGain& gains, std::int32_t from,
                          std::int32_t goal, double record, double bandPercent) {
    ResponseRecord run;
    run.taken = {{}, from, goal, record, ResponseMethod::Profile, gains};
    Loop loop(motor, gains, standing(motor, gains, from, 0.0), goal, Rounding::Chip);
    for (double t = 0; t <= record; t += loop.tick())
        run.points.push_back({t, loop.reading(loop.at(t).position)});
    setBand(run, bandPercent);
    return run;
}

Prediction predict(const MotorConstants& motor, const servo::SetGain& gains, std::int32_t from,
                   std::int32_t goal, double record, double bandPercent) {
    Prediction prediction;
    prediction.run = reckonStep(motor, gains, from, goal, record, bandPercent);
    prediction.errorAtRest = goal - prediction.run.points.back().position;
    prediction.margins = marginsOf(motor, gains);
    return prediction;
}

}  // namespace nmc

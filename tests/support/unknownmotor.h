// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "tests/support/tunedservo.h"

namespace nmc::testing_support {

/// A random motor: inertia from the rotor of the simulator's small motor alone to a hundred times that, dry
/// friction from 0.4 to 40 mN m, 400 to 8000 counts per turn, and in every other one a load of up to 30 mN m
/// in either direction.
[[nodiscard]] inline sim::MotorParameters unknownMotor(sim::Random& random) {
    sim::MotorParameters motor;
    motor.inertiaKgM2 = 1e-5 * std::pow(100, random.unit());
    motor.coulombNm = 4e-4 * std::pow(100, random.unit());
    motor.countsPerTurn = std::round(400 * std::pow(20, random.unit()));
    const double load = 0.03 * (2 * random.unit() - 1);
    motor.loadNm = random.below(2) == 0 ? 0.0 : load;
    return motor;
}

/// A random motor in a machine. Each of the following is present in every other one: a play of 1 to 3 counts,
/// an amplifier with a deadband of up to 12 PWM counts, an encoder that is off by up to 0.4 counts rms, a
/// supply that gives a third to three times the gain, and a mass of up to half its inertia on a spring, at 60
/// to 400 Hz.
[[nodiscard]] inline sim::MotorParameters unknownMachine(sim::Random& random) {
    sim::MotorParameters motor = unknownMotor(random);
    const auto half = [&random] { return random.below(2) == 0; };
    motor.playCounts = half() ? 1 + static_cast<std::int64_t>(random.below(3)) : 0;
    motor.amplifierDeadbandPwm = half() ? static_cast<int>(random.below(13)) : 0;
    motor.encoderNoiseCounts = half() ? 0.4 * random.unit() : 0.0;
    motor.setGain(motor.gain() * (half() ? std::pow(9, random.unit()) / 3 : 1.0));
    motor.elasticInertiaKgM2 = half() ? 0.5 * random.unit() * motor.inertiaKgM2 : 0.0;
    motor.resonanceHz = 60 + 340 * random.unit();
    return motor;
}

/// Gains to begin with, followed by ones with more damping, as a person would try them if the motor swings or
/// stays far off.
[[nodiscard]] inline std::array<servo::SetGain, 4> gainsToTry() {
    const auto gains = [](std::uint16_t kp, std::uint16_t kd, std::uint16_t ki, std::uint16_t il) {
        return servo::SetGain{kp, kd, ki, il, 64, 0, 4'000, 1, std::uint8_t{0}};
    };
    return {gains(100, 1'000, 80, 50), gains(100, 5'000, 80, 50), gains(100, 5'000, 0, 0),
            gains(300, 15'000, 0, 0)};
}

/// True if it stays within 2 counts for 0.1 s, within 2 s.
[[nodiscard]] inline bool comesToRest(TunedServo& servo) {
    for (int attempt = 0; attempt < 20; ++attempt) {
        std::int32_t low = servo.position();
        std::int32_t high = low;
        for (int i = 0; i < 10; ++i) {
            servo.wait(0.01);
            low = std::min(low, servo.position());
            high = std::max(high, servo.position());
        }
        if (high - low <= 2)
            return true;
    }
    return false;
}

/// Records of a tenth of a turn there and back, and of two tenths; half a second each.
[[nodiscard]] inline std::vector<ResponseRecord> stepsOf(const sim::MotorParameters& motor,
                                                         std::uint64_t seed) {
    const auto tenth = static_cast<std::int32_t>(motor.countsPerTurn / 10);
    std::vector<ResponseRecord> runs;
    for (const servo::SetGain& gains : gainsToTry()) {
        TunedServo servo(motor, gains, seed);
        runs.clear();
        bool good = comesToRest(servo);
        for (const std::int32_t counts : {tenth, -tenth, 2 * tenth}) {
            if (!good)
                break;
            runs.push_back(servo.step(counts, 0.5));
            const auto& points = runs.back().points;
            const double moved = std::abs(points.back().position - points.front().position);
            good = moved > std::abs(counts) / 2.0 && comesToRest(servo);
        }
        if (good)
            break;
    }
    return runs;
}

inline constexpr double kMedianRecord = 0.6;

/// Settling time in s: the median of five steps to and fro, because where friction stops a shaft is a matter
/// of chance, and the best of thousands on one step is the luckiest. A step that does not settle, or does not
/// begin where it should, counts as the whole record. Returns the whole record as soon as the median cannot
/// be below `below`.
[[nodiscard]] inline double medianSettling(const sim::MotorParameters& motor, const servo::SetGain& gains,
                                           std::int32_t step, std::uint64_t seed,
                                           double below = kMedianRecord) {
    constexpr std::size_t kSteps = 5;
    TunedServo servo(motor, gains, seed);
    servo.wait(0.3);
    std::vector<double> times;
    std::size_t late = 0;
    while (times.size() < kSteps && late <= kSteps / 2) {
        const int off = std::abs(servo.command() - servo.position());
        const ResponseRecord run = servo.step(times.size() % 2 == 0 ? step : -step, kMedianRecord);
        const bool stood = off <= std::max(1.0, step * kFirstBand / 100);
        times.push_back(stood && run.metrics.settling ? run.metrics.settling->value : kMedianRecord);
        late += times.back() >= below ? 1U : 0U;
    }
    if (late > kSteps / 2)
        return kMedianRecord;
    std::nth_element(times.begin(), times.begin() + kSteps / 2, times.end());
    return times[kSteps / 2];
}

}  // namespace nmc::testing_support

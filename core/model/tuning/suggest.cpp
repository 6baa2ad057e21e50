// SPDX-License-Identifier: MIT
#include "model/tuning/suggest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/time.h"

namespace nmc {

namespace {

constexpr double kMaxGain = 32'767;  // DS-V 5.2 Set Gain
constexpr double kMaxErrorLimit = 16'383;
constexpr double kCutOff = 0.5;           ///< PWM counts that the filter cuts off on average
constexpr double kSlowestSettling = 5.0;  ///< s
constexpr double kSlowest = 0.1;          ///< of the fastest natural frequency, for a stiffness of 0

/// What of the wish does not depend on the stiffness.
struct Terms {
    MotorConstants motor;
    double zeta = 0.0;
    double noise = 0.0;    ///< at most
    double carried = 0.0;  ///< PWM counts, by the integral
    double periods = 0.0;  ///< of 1 / omega, in which the integral does what Kp does at once
    servo::SetGain now;
    std::int32_t step = 0;
};

/// SR, Kd: as low a rate as leaves Kd in its range, and lets one count not make the output jump by more than
/// a part of its limit; the latter only as far as noise permits.
[[nodiscard]] bool setDamping(const Terms& terms, double omega, servo::SetGain& gains) {
    constexpr double kJump = 0.25;
    const MotorConstants& motor = terms.motor;
    const double wanted = std::max(0.0, 2 * terms.zeta * omega * motor.timeConstant - 1) * 256 / motor.gain;
    bool found = false;
    for (const int sr : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
        servo::SetGain slower = gains;
        slower.sr = static_cast<std::uint8_t>(sr);
        const double kd = wanted / servoTickOf(slower);
        slower.kd = static_cast<std::uint16_t>(std::lround(std::min(kd, kMaxGain)));
        if (figuresOf(motor, slower).noise > terms.noise)
            break;
        if (kd > kMaxGain)
            continue;
        gains = slower;
        found = true;
        if (slower.kd <= kJump * 256 * gains.ol)
            break;
    }
    return found;
}

/// Ki, IL; or not with this natural frequency.
[[nodiscard]] bool setIntegral(const Terms& terms, double omega, servo::SetGain& gains) {
    constexpr double kFewestSteps = 5;
    gains.ki = 0;
    gains.il = 0;
    if (terms.carried * 256 < gains.kp)
        return true;
    // A slow one disturbs least, but must not be what gets the motor out of where friction holds it.
    constexpr double kBandOfStep = 0.02;
    constexpr double kSlow = 30;
    const double held = (terms.motor.friction + terms.carried) * 256 / gains.kp;
    if (terms.periods > kSlow && held > kBandOfStep * std::abs(terms.step))
        return false;
    const double fast = gains.kp * 256 * servoTickOf(gains) * omega / terms.periods;
    const double ki = std::clamp(std::min(fast, terms.carried * 256 / kFewestSteps), 1.0, kMaxGain);
    gains.ki = static_cast<std::uint16_t>(std::lround(ki));
    gains.il = static_cast<std::uint16_t>(std::min(kMaxGain, std::ceil(terms.carried * 256 / gains.ki)));
    return true;
}

[[nodiscard]] std::optional<servo::SetGain> gainsAt(const Terms& terms, double omega) {
    servo::SetGain gains = terms.now;
    const double kp = omega * omega * 256 * terms.motor.timeConstant / terms.motor.gain;
    if (kp > kMaxGain || kp < 0.5)
        return std::nullopt;
    gains.kp = static_cast<std::uint16_t>(std::lround(kp));
    if (!setDamping(terms, omega, gains) || !setIntegral(terms, omega, gains))
        return std::nullopt;
    const LoopMargins margins = marginsOf(terms.motor, gains);
    if (!margins.stable || margins.phaseDegrees < kMinPhaseMargin || margins.gain < kMinGainMargin)
        return std::nullopt;
    return gains;
}

/// It calms down: in the last part of the record it does not move by more than a count or two.
[[nodiscard]] bool isCalm(const ResponseRecord& run) {
    constexpr double kLastPart = 0.8;
    double low = run.points.back().position;
    double high = low;
    for (const ResponsePoint& point : run.points)
        if (point.seconds > kLastPart * run.points.back().seconds) {
            low = std::min(low, point.position);
            high = std::max(high, point.position);
        }
    return high - low <= 2;
}

/// s, until it stays where it belongs: the longest, for a motor that is a little stronger than was found, and
/// for one that is a little weaker. Nothing if one does not calm down, or goes far beyond its goal; where
/// friction keeps it elsewhere, all of the record. Sets EL.
[[nodiscard]] std::optional<double> settling(const Terms& terms, double omega, servo::SetGain& gains) {
    constexpr double kBand = 1.4;  // %, so that what is a little otherwise is within the usual 2
    constexpr double kPeriods = 60;
    /// %; the least damping has less. What has more does so by its integral, and may well swing for good.
    constexpr double kMaxOvershoot = 25;
    constexpr double kErrorMargin = 1.5;
    constexpr double kMinError = 20;
    const double accelerating = std::sqrt(std::abs(terms.step) * terms.motor.timeConstant /
                                          (terms.motor.gain * std::max<int>(gains.ol, 1)));
    const double record = std::clamp(kPeriods / omega + 5 * accelerating, 0.1, kSlowestSettling);
    double longest = 0.0;
    double error = 0.0;
    for (const double stronger : {-1.0, 0.0, 1.0}) {
        MotorConstants motor = terms.motor;
        motor.gain *= 1 + 0.03 * stronger;
        motor.friction *= 1 - 0.15 * stronger;
        const ResponseRecord run = reckonStep(motor, gains, 0, terms.step, record, kBand);
        if (!isCalm(run) || (run.metrics.overshoot && run.metrics.overshoot->value > kMaxOvershoot))
            return std::nullopt;
        const auto& settled = run.metrics.settling;
        longest = std::max(longest, settled ? settled->value : record);
        error = std::max(error, largestError(run));
    }
    gains.el =
        static_cast<std::uint16_t>(std::lround(std::min(kMaxErrorLimit, kErrorMargin * error + kMinError)));
    return longest;
}

}  // namespace

LoopFigures figuresOf(const MotorConstants& motor, const servo::SetGain& gains) {
    const double tick = servoTickOf(gains);
    const double push = motor.gain / (256 * motor.timeConstant);
    const double omega = std::sqrt(push * gains.kp);
    const double damping = 1 / motor.timeConstant + push * gains.kd * tick;
    return {omega, omega > 0 ? damping / (2 * omega) : 0.0, push * gains.kd * tick * tick};
}

std::optional<servo::SetGain> suggest(const MotorModel& motor, const LoopWish& wish,
                                      const servo::SetGain& now, std::int32_t step) {
    constexpr double kReserve = 1.1;
    constexpr double kMaxUnsure = 0.1;
    constexpr double kLadder = 0.94;
    Terms terms;
    terms.motor = motor.constants();
    terms.zeta = kMinDamping + std::clamp(wish.damping, 0.0, 1.0) * (kMaxDamping - kMinDamping);
    terms.noise = kMaxNoise * std::clamp(wish.noise, 0.01, 1.0);
    const double unsure = std::hypot(motor.load.doubt, motor.friction.doubt);
    terms.carried = kReserve * (std::abs(motor.load.value) + motor.friction.value + kCutOff +
                                std::min(unsure, kMaxUnsure * now.ol));
    terms.now = now;
    terms.step = step;

    // From what the noise permits at the highest rate, down to where it is the fastest with this output
    // limit. Where no overshoot leaves the band it may be much faster, so a little more or less damping is
    // tried too.
    const double wished = terms.zeta;
    const double noisiest = 1 / terms.motor.timeConstant + terms.noise / toSeconds(kServoTick);
    Terms best = terms;
    double fastest = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const double periods : {3.0, 10.0, 30.0, 100.0, 300.0})
        for (const double zeta : {wished, wished * 0.88, wished * 1.12}) {
            terms.periods = periods;
            terms.zeta = zeta;
            // None settles in less than 1 / omega.
            for (double omega = noisiest / (2 * zeta); omega * std::min(least, kSlowestSettling) > 1;
                 omega *= kLadder) {
                auto gains = gainsAt(terms, omega);
                const auto settled = gains ? settling(terms, omega, *gains) : std::nullopt;
                if (!settled || *settled >= least)
                    continue;
                fastest = omega;
                least = *settled;
                best = terms;
            }
        }
    if (fastest == 0)
        return std::nullopt;
    for (double omega = fastest * std::pow(kSlowest, 1 - std::clamp(wish.stiffness, 0.0, 1.0));
         omega * kSlowestSettling > 1; omega *= kLadder) {
        auto gains = gainsAt(best, omega);
        if (gains && settling(best, omega, *gains))
            return gains;
    }
    return std::nullopt;
}

}  // namespace nmc

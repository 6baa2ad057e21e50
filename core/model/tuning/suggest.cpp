// SPDX-License-Identifier: MIT
#include "model/tuning/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/angle.h"
#include "base/time.h"

namespace nmc {

namespace {

constexpr double kMaxGain = 32'767;  // DS-V 5.2 Set Gain
constexpr double kHighestErrorLimit = 16'383;
constexpr double kCutOff = 0.5;           ///< PWM counts truncated by the filter on average
constexpr double kSlowestSettling = 5.0;  ///< s
constexpr double kNever = 2 * kSlowestSettling;
constexpr double kLeastPart = 0.88;  ///< fraction of the wished damping
constexpr double kSlowest = 0.1;     ///< fraction of the fastest natural frequency, for a stiffness of 0

/// The parts of a wish that do not depend on the stiffness.
struct Terms {
    MotorConstants motor;
    double zeta = 0.0;
    double noise = 0.0;    ///< maximum
    double phase = 0.0;    ///< degrees, minimum
    double carried = 0.0;  ///< PWM counts carried by the integral
    double periods = 0.0;  ///< periods of 1 / omega in which the integral contributes what Kp contributes at
                           ///< once
    servo::SetGain now;
    std::int32_t step = 0;
};

/// Sets SR and Kd: the lowest servo rate divisor that keeps Kd in range and keeps the output's jump for one
/// count below a fraction of its limit; the latter only as far as noise permits.
[[nodiscard]] bool setDamping(const Terms& terms, double omega, servo::SetGain& gains) {
    constexpr double kJump = 0.25;
    const MotorConstants& motor = terms.motor;
    const double wanted = std::max(0.0, 2 * terms.zeta * omega * motor.timeConstant - 1) * 256 / motor.gain;
    bool found = false;
    for (const int sr : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64}) {
        servo::SetGain slower = gains;
        slower.sr = static_cast<std::uint8_t>(sr);
        const double kd = wanted / secondsPerTick(slower.sr);
        slower.kd = static_cast<std::uint16_t>(std::lround(std::min(kd, kMaxGain)));
        if (noiseOf(motor, slower) > terms.noise)
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

/// Sets Ki and IL.
void setIntegral(const Terms& terms, double omega, servo::SetGain& gains) {
    constexpr double kFewestSteps = 5;
    gains.ki = 0;
    gains.il = 0;
    if (terms.carried * 256 < gains.kp)
        return;
    // One increment of the integral drives no more than one count of error does: friction releases a shaft
    // with a jump of at most a count, which the integral then does not overshoot again and again.
    const double fast = gains.kp * 256 * secondsPerTick(gains.sr) * omega / terms.periods;
    const double ki = std::min({fast, 1.0 * gains.kp, terms.carried * 256 / kFewestSteps});
    gains.ki = static_cast<std::uint16_t>(std::lround(std::max(ki, 1.0)));
    gains.il = static_cast<std::uint16_t>(std::min(kMaxGain, std::ceil(terms.carried * 256 / gains.ki)));
}

[[nodiscard]] std::optional<servo::SetGain> gainsAt(const Terms& terms, double omega) {
    servo::SetGain gains = terms.now;
    const double kp = omega * omega * 256 * terms.motor.timeConstant / terms.motor.gain;
    if (kp > kMaxGain || kp < 0.5)
        return std::nullopt;
    gains.kp = static_cast<std::uint16_t>(std::lround(kp));
    if (!setDamping(terms, omega, gains))
        return std::nullopt;
    setIntegral(terms, omega, gains);
    return gains;
}

[[nodiscard]] bool hasMargins(const Terms& terms, const servo::SetGain& gains) {
    const LoopMargins margins = marginsOf(terms.motor, gains);
    // If the delay is a dead time, it shifts the phase further than the lag that the margins assume.
    const double delayed = 2 * std::numbers::pi * margins.crossover * terms.motor.delay;
    const double phase = margins.phaseDegrees - (delayed - std::atan(delayed)) * kDegrees;
    return margins.stable && phase >= terms.phase && margins.gain >= kMinGainMargin;
}

struct StepCourse {
    double settled = 0.0;  ///< s, until it stays in its band; the whole record where it does not
    double largest = 0.0;  ///< counts, largest error
};

/// Evaluates a step to `goal` that lasts `record` seconds. `held`: counts within which friction may hold the
/// shaft. Returns nothing if it is outside its band after `latest`, goes far beyond its goal, or does not
/// calm down: in the last part it may come nearer to the goal, but must not move away again.
[[nodiscard]] std::optional<StepCourse> stepCourseOf(Loop& loop, double step, double goal, double record,
                                                     double latest, double held) {
    constexpr double kBand = 0.014;  // so that small deviations still meet the usual 2 %
    /// The least damping overshoots less. More overshoot comes from the integral, and may well oscillate
    /// forever.
    constexpr double kMaxOvershoot = 0.25;
    constexpr double kLastPartFrom = 0.8;
    constexpr double kCalm = 1;  // count
    const double band = std::floor(std::max(1.0, std::abs(step) * kBand)) + 0.5;
    const double beyond = kMaxOvershoot * std::abs(step) + held + 0.5;
    StepCourse course{loop.tick(), 0.0};
    double nearest = std::numeric_limits<double>::infinity();
    const double began = loop.nextTick();
    loop.goTo(goal);
    for (double t = 0; t <= record; t += loop.tick()) {
        const double error = goal - loop.reading(loop.at(began + t).position);
        course.largest = std::max(course.largest, std::abs(error));
        if (std::abs(error) > band)
            course.settled = t + loop.tick();
        if (course.settled > latest || (step < 0 ? error : -error) > beyond)
            return std::nullopt;
        if (t <= kLastPartFrom * record)
            continue;
        nearest = std::min(nearest, std::abs(error));
        if (std::abs(error) > nearest + kCalm)
            return std::nullopt;
    }
    if (course.settled > kLastPartFrom * record)
        course.settled = record;
    return course;
}

/// Returns the mean settling time in s over steps to and fro, each of which starts where friction let the
/// previous one end, with a motor that may be a little stronger or weaker than identified. Returns nothing if
/// it is not below `most`, or if one of the steps is not acceptable. Sets EL.
[[nodiscard]] std::optional<double> settling(const Terms& terms, double omega, double most,
                                             servo::SetGain& gains) {
    constexpr std::array<double, 5> kStronger = {0, 1, -1, 0.5, -0.5};
    constexpr std::size_t kSteps = 4;
    constexpr double kRecord = 60;  // radians of the loop's natural frequency
    constexpr double kErrorMargin = 1.5;
    constexpr double kMinError = 20;
    const double accelerating = std::sqrt(std::abs(terms.step) * terms.motor.timeConstant /
                                          (terms.motor.gain * std::max<int>(gains.ol, 1)));
    const double record = std::clamp(kRecord / omega + 5 * accelerating, 0.1, kSlowestSettling);
    // The geometric mean is used because a step that sticks once just outside its band settles much later
    // without being much worse.
    const double soonest = std::log(1 / omega);
    const auto courses = static_cast<double>(kStronger.size() * kSteps);
    double left = (std::log(most) - soonest) * courses;
    double largest = 0.0;
    for (const double stronger : kStronger) {
        MotorConstants motor = terms.motor;
        motor.gain *= 1 + 0.03 * stronger;
        motor.friction *= 1 - 0.15 * stronger;
        Loop loop(motor, gains, standing(motor, gains, 0, 0), 0, Rounding::Chip);
        for (std::size_t i = 0; i < kSteps; ++i) {
            const bool back = i % 2 == 1;
            const auto course =
                stepCourseOf(loop, back ? -terms.step : terms.step, back ? 0.0 : terms.step, record,
                             std::exp(left + soonest), (motor.friction + motor.deadband) * 256 / gains.kp);
            if (!course)
                return std::nullopt;
            left -= std::log(course->settled) - soonest;
            largest = std::max(largest, course->largest);
        }
    }
    if (left <= 0)
        return std::nullopt;
    gains.el = static_cast<std::uint16_t>(
        std::lround(std::min(kHighestErrorLimit, kErrorMargin * largest + kMinError)));
    return most * std::exp(-left / courses);
}

struct Candidate {
    servo::SetGain gains;
    double settled = 0.0;  ///< s
};

/// The gains for a natural frequency that settle first, over a range of integral speeds. Settling is much
/// earlier where no overshoot leaves the band, so a little more or less damping is tried too. Of equal
/// candidates the first is chosen. Returns nothing if none settles before `most`.
[[nodiscard]] std::optional<Candidate> fastestAt(Terms terms, double omega, double most) {
    std::optional<Candidate> best;
    const double wished = terms.zeta;
    for (const double periods : {30.0, 100.0, 300.0, 10.0, 3.0})
        for (const double part : {1.0, 0.94, kLeastPart, 1.06, 1.12}) {
            terms.periods = periods;
            terms.zeta = wished * part;
            auto gains = gainsAt(terms, omega);
            const auto settled = gains ? settling(terms, omega, most, *gains) : std::nullopt;
            // Margins take longer to compute than most steps, so they are checked last.
            if (!settled || !hasMargins(terms, *gains))
                continue;
            most = *settled;
            best = {*gains, most};
        }
    return best;
}

}  // namespace

double noiseOf(const MotorConstants& motor, const servo::SetGain& gains) {
    const double tick = secondsPerTick(gains.sr);
    return motor.gain / (256 * motor.timeConstant) * gains.kd * tick * tick;
}

std::optional<servo::SetGain> suggest(const MotorModel& motor, const LoopWish& wish,
                                      const servo::SetGain& now, std::int32_t step) {
    constexpr double kReserve = 1.1;
    constexpr double kMaxUnsure = 0.1;
    constexpr double kLadder = 0.96;
    Terms terms;
    terms.motor = motor.constants();
    terms.zeta = kMinDamping + std::clamp(wish.damping, 0.0, 1.0) * (kMaxDamping - kMinDamping);
    terms.noise = kMaxNoise * std::clamp(wish.noise, 0.01, 1.0);
    // The sum of friction and deadband is known better than either of them.
    const double both = motor.correlation[2][5] * motor.friction.doubt * motor.deadband.doubt;
    const double holding = std::hypot(motor.friction.doubt, motor.deadband.doubt);
    const double unsure = std::sqrt(motor.load.doubt * motor.load.doubt + holding * holding + 2 * both);
    terms.carried = kReserve * (std::abs(motor.load.value) + motor.friction.value + motor.deadband.value +
                                kCutOff + std::min(unsure, kMaxUnsure * now.ol));
    terms.phase = std::clamp(wish.phaseMargin, kMinPhaseMargin, kMaxPhaseMargin);
    terms.now = now;
    terms.step = step;

    // Search from the frequency that the noise permits at the highest servo rate down to the fastest one with
    // this output limit; none settles in less than 1 / omega.
    const double noisiest = 1 / terms.motor.timeConstant + terms.noise / toSeconds(kServoTick);
    double fastest = 0.0;
    double least = kNever;
    for (double omega = noisiest / (2 * terms.zeta * kLeastPart);
         omega * std::min(least, kSlowestSettling) > 1; omega *= kLadder)
        if (const auto found = fastestAt(terms, omega, least)) {
            fastest = omega;
            least = found->settled;
        }
    for (double omega = fastest * std::pow(kSlowest, 1 - std::clamp(wish.stiffness, 0.0, 1.0));
         omega * kSlowestSettling > 1; omega *= kLadder)
        if (const auto found = fastestAt(terms, omega, kNever))
            return found->gains;
    return std::nullopt;
}

}  // namespace nmc

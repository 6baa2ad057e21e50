// SPDX-License-Identifier: MIT
#include "model/tuning/predict.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/angle.h"
#include "model/frequency/othergains.h"

namespace nmc {

namespace {

using Complex = std::complex<double>;

/// A motor over one servo tick, exactly: the effect of position, velocity, torque (as its equivalent PWM
/// value) and the held PWM value on one another.
struct TickOfMotor {
    double keepsSpeed = 0.0, keepsTorque = 0.0;                      ///< fractions that remain
    double travelOfSpeed = 0.0, travelOfTorque = 0.0, travel = 0.0;  ///< counts per counts/s, and per PWM
                                                                     ///< count
    double speedOfTorque = 0.0, speed = 0.0;                         ///< counts/s per PWM count
};

/// The delay is modelled as a torque that follows PWM as the current in an inductance does.
[[nodiscard]] TickOfMotor tickOf(const MotorConstants& motor, double tick) {
    const double tau = motor.timeConstant;
    // Two equal lags have a separate closed form, so they are kept slightly different.
    constexpr double kNearly = 1e-4;
    const double lag = std::clamp(motor.delay, kNearly * tick, tick * double{Loop::kLongestDelay});
    const double late = std::abs(lag / tau - 1) < kNearly ? tau * (1 + kNearly) : lag;
    const auto kept = [tick](double constant) { return std::exp(-tick / constant); };
    const auto coasts = [tick](double constant) { return -constant * std::expm1(-tick / constant); };
    TickOfMotor of;
    of.keepsSpeed = kept(tau);
    of.keepsTorque = kept(late);
    of.travelOfSpeed = coasts(tau);
    const double share = late / (tau - late);
    of.speedOfTorque = motor.gain * share * (of.keepsSpeed - of.keepsTorque);
    of.travelOfTorque = motor.gain * share * (coasts(tau) - coasts(late));
    of.speed = motor.gain * (1 - of.keepsSpeed) - of.speedOfTorque;
    of.travel = motor.gain * (tick - coasts(tau)) - of.travelOfTorque;
    return of;
}

/// The effect of a second mass on a spring on the shaft's position at a frequency: first less motion, then
/// far more, than if both were one mass.
[[nodiscard]] Complex swingOf(const MotorConstants& motor, double hertz) {
    if (motor.second == 0)
        return 1.0;
    const Complex s(0, hertz / motor.resonance);
    const Complex damping = 2 * kSpringDamping * s;
    return ((1 + motor.second) * s * s + damping + 1.0) / (s * s + damping + 1.0);
}

[[nodiscard]] Complex openLoop(const TickOfMotor& motor, const servo::SetGain& gains, double hertz) {
    const Complex z = std::polar(1.0, 2 * std::numbers::pi * hertz * secondsPerTick(gains.sr));
    const Complex torque = (1.0 - motor.keepsTorque) / (z - motor.keepsTorque);
    const Complex speed = (motor.speedOfTorque * torque + motor.speed) / (z - motor.keepsSpeed);
    const Complex position =
        (motor.travelOfSpeed * speed + motor.travelOfTorque * torque + motor.travel) / (z - 1.0);
    return filterAt(gains, hertz) / 256.0 * position;
}

/// The state is position, velocity, torque, running sum over 256, previous error; its transition over a tick
/// with a command of 0 must be stable.
[[nodiscard]] bool isStable(const TickOfMotor& motor, const servo::SetGain& gains) {
    using State = Eigen::Matrix<double, 5, 1>;
    constexpr Eigen::Index kPosition = 0, kVelocity = 1, kTorque = 2, kSum = 3, kBefore = 4;
    const double ki = gains.il > 0 ? gains.ki : 0.0;
    State sent = State::Zero();  // the PWM value of this tick as a function of the state
    sent[kPosition] = -(gains.kp + 1.0 * gains.kd + ki / 256) / 256;
    sent[kBefore] = -1.0 * gains.kd / 256;
    sent[kSum] = ki / 256;
    State heldBy = State::Zero();
    heldBy[kPosition] = motor.travel;
    heldBy[kVelocity] = motor.speed;
    heldBy[kTorque] = 1 - motor.keepsTorque;
    Eigen::Matrix<double, 5, 5> next = heldBy * sent.transpose();
    next(kPosition, kPosition) += 1;
    next(kPosition, kVelocity) += motor.travelOfSpeed;
    next(kPosition, kTorque) += motor.travelOfTorque;
    next(kVelocity, kVelocity) += motor.keepsSpeed;
    next(kVelocity, kTorque) += motor.speedOfTorque;
    next(kTorque, kTorque) += motor.keepsTorque;
    if (ki > 0) {
        next(kSum, kSum) = 1;
        next(kSum, kPosition) = -1.0 / 256;
    }
    next(kBefore, kPosition) = -1;
    return next.eigenvalues().cwiseAbs().maxCoeff() < 1;
}

}  // namespace

LoopStart standing(const MotorConstants& motor, const servo::SetGain& gains, double command, double held,
                   double within, double slack) {
    LoopStart start{command + within, command, 0.0, slack};
    const HoldingRange holds = holdingRange(motor);
    if (gains.ki > 0)
        start.integral = std::clamp(holds.at(held) * 256 / gains.ki, -1.0 * gains.il, 1.0 * gains.il);
    const double carried = start.integral * gains.ki / 256;
    const double lacking = std::clamp(carried, holds.least, holds.most) - carried;
    if (gains.kp > 0)
        start.position -= std::copysign(std::ceil(std::abs(lacking) * 256 / gains.kp), lacking);
    return start;
}

Complex openLoopAt(const MotorConstants& motor, const servo::SetGain& gains, double hertz) {
    return openLoop(tickOf(motor, secondsPerTick(gains.sr)), gains, hertz) * swingOf(motor, hertz);
}

LoopMargins marginsOf(const MotorConstants& motor, const servo::SetGain& gains) {
    constexpr double kLowest = 0.01;  // Hz
    constexpr double kStep = 1.01;
    const double tick = secondsPerTick(gains.sr);
    const TickOfMotor of = tickOf(motor, tick);
    LoopMargins margins{180.0, std::numeric_limits<double>::infinity(), 0.0, isStable(of, gains)};
    const auto at = [&](double hertz) { return openLoop(of, gains, hertz) * swingOf(motor, hertz); };
    double before = kLowest;
    Complex loopBefore = at(before);
    for (double hertz = kLowest * kStep; hertz < 0.5 / tick; hertz *= kStep) {
        const Complex loop = at(hertz);
        // Interpolation along a straight line between two points this close together.
        if (std::abs(loopBefore) >= 1 && std::abs(loop) < 1) {
            const double part = (std::abs(loopBefore) - 1) / (std::abs(loopBefore) - std::abs(loop));
            const Complex there = loopBefore + part * (loop - loopBefore);
            // Negative where the phase has gone beyond -180 degrees.
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
    const double last = (openLoop(of, gains, 0.5 / tick) * swingOf(motor, 0.5 / tick)).real();
    if (last < 0)
        margins.gain = std::min(margins.gain, -1 / last);
    return margins;
}

ResponseRecord reckonStep(const MotorConstants& motor, const ResponseTaken& taken, const LoopStart& start,
                          double bandPercent) {
    ResponseRecord run;
    run.taken = taken;
    Loop loop(motor, taken.gains, start, taken.goal, Rounding::Chip);
    for (double t = 0; t <= taken.record; t += loop.tick())
        run.points.push_back({t, loop.reading(loop.at(t).position)});
    judge(run, bandPercent);
    return run;
}

namespace {

/// A figure of the identified motor, and the rms deviation of other motors from it.
class Varying {
public:
    explicit Varying(double value) : m_value(value) {}
    void add(double other) {
        m_squares += (other - m_value) * (other - m_value);
        ++m_count;
    }
    [[nodiscard]] Measured with(double own) const {
        return {m_value, std::hypot(own, m_count > 0 ? std::sqrt(m_squares / m_count) : 0.0)};
    }

private:
    double m_value;
    double m_squares = 0.0;
    int m_count = 0;
};

/// Adds a second mass of up to half the inertia, on a spring whose resonance is anywhere above `lowest` Hz,
/// where the steps do not show it. `much`, `where`: 0..1.
void hangOn(MotorConstants& motor, double lowest, double much, double where) {
    constexpr double kMostSecond = 0.5;
    motor.second = kMostSecond * much;
    motor.resonance = lowest * std::pow(std::max(1.0, kHighestResonance / lowest), where);
}

/// The probability that a normally distributed value is farther than `limit` from 0.
[[nodiscard]] double beyond(double limit, const Measured& about) {
    const double width = about.doubt * std::numbers::sqrt2;
    return 1 - (std::erf((limit - about.value) / width) + std::erf((limit + about.value) / width)) / 2;
}

}  // namespace

Prediction predict(const MotorModel& motor, const servo::SetGain& gains, std::int32_t from, std::int32_t goal,
                   double record, double bandPercent) {
    constexpr std::size_t kDrawn = 60;
    constexpr std::size_t kOutside = 1;  // at either end
    Prediction prediction;
    const MotorConstants found = motor.constants();
    const ResponseTaken taken{{}, from, goal, record, ResponseMethod::Profile, gains};
    prediction.run = reckonStep(found, taken, standing(found, gains, from, 0.0), bandPercent);
    const LoopMargins margins = marginsOf(found, gains);
    const ResponseMetrics& metrics = prediction.run.metrics;
    const auto restOf = [goal](const ResponseRecord& run) { return goal - run.points.back().position; };
    const Measured ownOvershoot = metrics.overshoot.value_or(Measured{});
    const Measured ownSettling = metrics.settling.value_or(Measured{record, 0.0});
    Varying overshoot(ownOvershoot.value);
    Varying settling(ownSettling.value);
    Varying rest(restOf(prediction.run));
    Varying phase(margins.phaseDegrees);
    Varying gain(margins.gain);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> part;
    std::vector<std::vector<double>> positions(prediction.run.points.size());
    bool sprung = false;
    for (const MotorConstants& other : motor.drawn(kDrawn)) {
        // One draw to a statement: compilers differ in the order in which they evaluate arguments.
        MotorConstants swinging = other;
        if (motor.rigidUpTo) {
            const double where = part(random);
            const double much = part(random);
            hangOn(swinging, *motor.rigidUpTo, much, where);
        }
        // Margins describe the worst case. Steps describe what is likely: every second motor drives a spring,
        // which changes its overshoot and settling, but not where it rests.
        sprung = !sprung;
        const MotorConstants& drawn = sprung ? swinging : other;
        const double held = 2 * part(random) - 1;
        const double slack = part(random);
        const double within = part(random);
        const ResponseRecord run =
            reckonStep(drawn, taken, standing(drawn, gains, from, held, within, slack), bandPercent);
        for (std::size_t i = 0; i < positions.size(); ++i)
            positions[i].push_back(run.points[i].position);
        overshoot.add(run.metrics.overshoot.value_or(Measured{}).value);
        if (run.metrics.settling)
            settling.add(run.metrics.settling->value);
        else if (!sprung)
            prediction.unsettled += 2.0 / kDrawn;
        if (!sprung)
            rest.add(restOf(run));
        const LoopMargins its = marginsOf(swinging, gains);
        phase.add(its.phaseDegrees);
        if (std::isfinite(its.gain))
            gain.add(its.gain);
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double seconds = prediction.run.points[i].seconds;
        std::sort(positions[i].begin(), positions[i].end());
        prediction.low.push_back({seconds, positions[i][kOutside]});
        prediction.high.push_back({seconds, positions[i][kDrawn - 1 - kOutside]});
    }
    prediction.overshoot = overshoot.with(ownOvershoot.doubt);
    prediction.errorAtRest = rest.with(0.5);  // the encoder resolves no less than a count
    prediction.settling = settling.with(ownSettling.doubt);
    prediction.unsettled =
        std::max(prediction.unsettled, beyond(prediction.run.band() + 0.5, prediction.errorAtRest));
    // In these cases it may settle as late as the end of the record.
    if (prediction.unsettled > kSeldom)
        prediction.settling.doubt = std::hypot(
            prediction.settling.doubt, std::sqrt(prediction.unsettled) * (record - ownSettling.value));
    prediction.phaseMargin = phase.with(0.0);
    if (std::isfinite(margins.gain))
        prediction.gainMargin = gain.with(0.0);
    return prediction;
}

}  // namespace nmc

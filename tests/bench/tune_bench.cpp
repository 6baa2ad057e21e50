// SPDX-License-Identifier: GPL-3.0-or-later
// Unknown motors in unknown machines: each is identified from three steps and given gains, which are then
// tried on the motor (issue 16, C).
//   tune_bench [MOTORS [SEED [ONLY]]]    ONLY: the number of one motor
// First come motors alone, then such motors in machines: with play, deadband, encoder noise, and a spring
// that the steps do not show.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "model/tuning/suggest.h"
#include "tests/support/truemargins.h"
#include "tests/support/unknownmotor.h"

namespace {

using namespace nmc;
using namespace nmc::testing_support;

/// As fast as any rule permits, for comparison with the fastest possible.
constexpr LoopWish kFastest{1.0, 0.5, 1.0, kMinPhaseMargin};

struct Tally {
    int of = 0;
    int good = 0;

    void count(bool is) {
        ++of;
        good += is ? 1 : 0;
    }
    void print(const char* what) const {
        std::printf("tune: %-68s %d of %d (%.1f %%)\n", what, good, of, of == 0 ? 0.0 : 100.0 * good / of);
    }
};

[[nodiscard]] double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void printShares(const char* what, std::vector<double> values, const char* unit) {
    if (values.empty())
        return;
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    std::printf("tune: %-68s p50 %.3f p90 %.3f p95 %.3f p99 %.3f max %.3f %s\n", what, at(0.5), at(0.9),
                at(0.95), at(0.99), values.back(), unit);
}

/// True if it calms down after it is switched on, and again after a step.
[[nodiscard]] bool isStable(const sim::MotorParameters& motor, const servo::SetGain& gains, std::int32_t step,
                            std::uint64_t seed) {
    TunedServo servo(motor, gains, seed);
    if (!comesToRest(servo))
        return false;
    (void)servo.step(step, kMedianRecord);
    return comesToRest(servo);
}

struct Best {
    double settled;  ///< s
    servo::SetGain gains;
};

/// The fastest of all Kp, Kd and SR on a grid that are stable and whose noise is within the limit; the
/// integral is as suggested.
[[nodiscard]] Best bestOf(const sim::MotorParameters& motor, const servo::SetGain& suggested,
                          std::int32_t step, std::uint64_t seed) {
    Best best{kMedianRecord, suggested};
    for (const std::uint8_t sr : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{4}, std::uint8_t{8}})
        for (double noise = kMaxNoise; noise > 0.03 * kMaxNoise; noise /= 1.3) {
            servo::SetGain gains = suggested;
            gains.sr = sr;
            gains.kd = 1;
            const double kd = noise / noiseOf(physics(motor), gains);
            if (kd < 1 || kd > 32'767)
                continue;
            gains.kd = static_cast<std::uint16_t>(kd);
            for (double kp = 20; kp < 32'767; kp *= 1.25) {
                gains.kp = static_cast<std::uint16_t>(kp);
                const double settled = medianSettling(motor, gains, step, seed, best.settled);
                if (settled < best.settled && isStable(motor, gains, step, seed))
                    best = {settled, gains};
            }
        }
    return best;
}

[[nodiscard]] bool isWithinTwo(const Measured& predicted, double truth) {
    return std::abs(predicted.value - truth) <= 2 * predicted.doubt;
}

/// Counts which figures of a step with suggested gains were within two stated standard deviations of the
/// truth.
struct Predictions {
    Tally overshoot, settling, error, phase, gain;

    void count(const Prediction& predicted, const ResponseRecord& truth, const TrueMargins& margins) {
        if (truth.metrics.overshoot)
            overshoot.count(isWithinTwo(predicted.overshoot, truth.metrics.overshoot->value));
        settling.count(truth.metrics.settling ? isWithinTwo(predicted.settling, truth.metrics.settling->value)
                                              : predicted.unsettled > kSeldom);
        error.count(isWithinTwo(predicted.errorAtRest, truth.taken.goal - truth.points.back().position));
        phase.count(isWithinTwo(predicted.phaseMargin, margins.phaseDegrees));
        if (std::isfinite(margins.gain) && predicted.gainMargin)
            gain.count(isWithinTwo(*predicted.gainMargin, margins.gain));
    }
    void print() const {
        overshoot.print("overshoot within two stated standard deviations");
        settling.print("settling within two stated standard deviations, or said to be doubtful");
        error.print("error at rest within two stated standard deviations");
        phase.print("phase margin within two stated standard deviations");
        gain.print("gain margin within two stated standard deviations");
    }
};

/// True if within `part` of the truth, or within two of the stated standard deviations.
[[nodiscard]] bool isNear(const Measured& found, double truth, double part) {
    const double off = std::abs(found.value - truth);
    return off <= part * std::abs(truth) || off <= 2 * found.doubt;
}

/// `only`: the number of one motor; below 0: all of them.
void campaign(sim::MotorParameters (*draw)(sim::Random&), int motors, std::uint64_t firstSeed, int only) {
    sim::Random random(firstSeed);
    Predictions predictions;
    Tally identified, gain, tau, friction, gainSure, tauSure, frictionSure, suggested, stable, fast,
        overshoot;
    std::vector<double> identifySeconds, suggestSeconds, ratios, gainOff, tauOff, overshootOff;
    for (int i = 0; i < motors; ++i) {
        const sim::MotorParameters motor = draw(random);
        const std::uint64_t seed = random.next();
        if (only >= 0 && i != only)
            continue;
        const MotorConstants truth = physics(motor);
        const std::vector<ResponseRecord> runs = stepsOf(motor, seed);
        double began = processorSeconds();
        const auto found = identify(runs);
        identifySeconds.push_back(processorSeconds() - began);
        identified.count(found.has_value());
        if (!found) {
            std::printf("tune: motor %d not found: failure %d\n", i, static_cast<int>(found.error()));
            continue;
        }
        const MotorModel& model = found->motor;
        gain.count(std::abs(model.gain.value / truth.gain - 1) <= 0.1);
        tau.count(std::abs(model.timeConstant.value / truth.timeConstant - 1) <= 0.1);
        friction.count(std::abs(model.friction.value / truth.friction - 1) <= 0.25);
        gainSure.count(isNear(model.gain, truth.gain, 0.1));
        tauSure.count(isNear(model.timeConstant, truth.timeConstant, 0.1));
        frictionSure.count(isNear(model.friction, truth.friction, 0.25));
        if (!isNear(model.gain, truth.gain, 0.1) || !isNear(model.timeConstant, truth.timeConstant, 0.1) ||
            !isNear(model.friction, truth.friction, 0.25))
            std::printf(
                "tune: motor %d: K %.0f is %.0f +- %.0f, tau %.1f ms is %.1f +- %.1f, c %.2f is %.2f +- "
                "%.2f; "
                "missed %.2f expected %.2f\n",
                i, truth.gain, model.gain.value, model.gain.doubt, truth.timeConstant * 1e3,
                model.timeConstant.value * 1e3, model.timeConstant.doubt * 1e3, truth.friction,
                model.friction.value, model.friction.doubt, found->missed, found->expected);
        gainOff.push_back(100 * std::abs(model.gain.value / truth.gain - 1));
        tauOff.push_back(100 * std::abs(model.timeConstant.value / truth.timeConstant - 1));

        const auto step = static_cast<std::int32_t>(motor.countsPerTurn / 10);
        servo::SetGain now = gainsToTry().front();
        now.ol = 255;
        began = processorSeconds();
        const auto gains = suggest(model, kFastest, now, step);
        suggestSeconds.push_back(processorSeconds() - began);
        suggested.count(gains.has_value());
        if (!gains) {
            std::printf("tune: motor %d: no gains\n", i);
            continue;
        }
        const bool calm = isStable(motor, *gains, step, seed);
        stable.count(calm);
        TunedServo servo(motor, *gains, seed);
        servo.wait(0.3);
        const ResponseRecord run = servo.step(step, kMedianRecord);
        const Prediction predicted = predict(model, *gains, 0, step, kMedianRecord, kFirstBand);
        const double off = run.metrics.overshoot->value - predicted.overshoot.value;
        TunedServo exact(motor, *gains, seed);
        exact.wait(3);  // so that the integral carries the load, as the prediction assumes
        predictions.count(predicted, exact.trueStep(step, kMedianRecord), trueMargins(motor, *gains));
        overshoot.count(std::abs(off) <= 5);
        overshootOff.push_back(std::abs(off));
        const double settled = medianSettling(motor, *gains, step, seed);
        const Best best = bestOf(motor, *gains, step, seed);
        ratios.push_back(settled / best.settled);
        fast.count(settled <= 1.5 * best.settled);
        if (!calm || settled > 1.5 * best.settled || std::abs(off) > 5)
            std::printf(
                "tune: motor %d (K %.0f tau %.1f ms c %.2f load %.2f): %s, settles in %.1f ms, overshoot %.1f "
                "%%, predicted %.1f; Kp %d Kd %d Ki %d IL %d SR %d; best %.1f ms: Kp %d Kd %d SR %d, phase "
                "margin %.0f, gain margin %.1f\n",
                i, truth.gain, truth.timeConstant * 1e3, truth.friction, truth.load,
                calm ? "stable" : "NOT STABLE", settled * 1e3, run.metrics.overshoot->value,
                predicted.overshoot.value, gains->kp, gains->kd, gains->ki, gains->il, gains->sr,
                best.settled * 1e3, best.gains.kp, best.gains.kd, best.gains.sr,
                marginsOf(truth, best.gains).phaseDegrees, marginsOf(truth, best.gains).gain);
        std::fflush(stdout);
    }
    identified.print("motors found");
    gain.print("K within 10 %");
    tau.print("tau within 10 %");
    friction.print("c within 25 %");
    gainSure.print("K within 10 % or two stated standard deviations");
    tauSure.print("tau within 10 % or two stated standard deviations");
    frictionSure.print("c within 25 % or two stated standard deviations");
    printShares("K off by", gainOff, "%");
    printShares("tau off by", tauOff, "%");
    suggested.print("gains suggested");
    stable.print("suggested gains stable");
    fast.print("settling at most 1.5 times the best found");
    printShares("settling over the best found", ratios, "");
    predictions.print();
    overshoot.print("overshoot within 5 points of the predicted");
    printShares("overshoot off by", overshootOff, "points");
    printShares("identify: processor time", identifySeconds, "s");
    printShares("suggest: processor time", suggestSeconds, "s");
}

}  // namespace

int main(int argc, char** argv) {
    const int motors = argc > 1 ? std::atoi(argv[1]) : 300;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 16;
    const int only = argc > 3 ? std::atoi(argv[3]) : -1;
    std::printf("tune: motors by themselves\n");
    campaign(unknownMotor, motors, seed, only);
    std::printf("tune: motors in machines\n");
    campaign(unknownMachine, motors, seed, only);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The frequency response of many motors as measured over the line, compared with the analytic loop: within 1
// dB and 5 degrees, or within the spread that the measurement itself reports. Engine and simulator in virtual
// time.
#include <cmath>
#include <complex>
#include <numbers>

#include "model/frequency/frequencyresponse.h"
#include "model/frequency/othergains.h"
#include "model/tuning/predict.h"
#include "sim/random.h"
#include "tests/procedures/procedurebench.h"
#include "tests/support/campaign.h"
#include "tests/support/tunedservo.h"

namespace nmc::test {
namespace {

/// A motor without dry friction, and the loop for which its gains are calculated.
struct Plant {
    const char* name;
    double inertia;  ///< kg m^2
    double countsPerTurn;
    double hertz;    ///< natural frequency
    double damping;  ///< zeta
    std::uint8_t sr;
    std::int32_t amplitude;  ///< counts
    std::uint32_t baud;
};

void PrintTo(const Plant& plant, std::ostream* to) {
    *to << plant.name;
}

[[nodiscard]] sim::MotorParameters motorOf(const Plant& plant) {
    sim::MotorParameters motor;
    motor.inertiaKgM2 = plant.inertia;
    motor.countsPerTurn = plant.countsPerTurn;
    motor.coulombNm = 0;
    motor.viscousNmS = 0;
    return motor;
}

/// wn² = K Kp / (256 tau), 2 zeta wn = (1 + K Kd T / 256) / tau (docs/tuning.md).
[[nodiscard]] servo::SetGain gainsOf(const Plant& plant) {
    const MotorConstants motor = testing_support::physics(motorOf(plant));
    const double wn = 2 * std::numbers::pi * plant.hertz;
    const double tick = 512e-6 * plant.sr;
    const double kp = wn * wn * 256 * motor.timeConstant / motor.gain;
    const double kd = (2 * plant.damping * wn * motor.timeConstant - 1) * 256 / (motor.gain * tick);
    return {static_cast<std::uint16_t>(std::lround(kp)),
            static_cast<std::uint16_t>(std::max(0L, std::lround(kd))),
            0,
            0,
            255,
            0,
            16'000,
            plant.sr,
            std::uint8_t{0}};
}

class BodeOf : public testing::TestWithParam<Plant> {
protected:
    void measure() {
        sim::ChainOptions options;
        options.motor = motorOf(GetParam());
        gains = gainsOf(GetParam());
        motor = testing_support::physics(options.motor);
        ProcedureBench bench(servos(1, servoVersion()), options, GetParam().baud);
        ASSERT_TRUE(marginsOf(motor, gains).stable);
        ASSERT_TRUE(bench.connect() && bench.perform(intent::AskAnew{}) &&
                    bench.perform(intent::ApplyGains{gains}) && bench.perform(intent::Enable{}) &&
                    bench.perform(intent::StopHere{}));
        report = bench.run(intent::FrequencyResponse{GetParam().amplitude, 3.0, 40.0}, 120.0);
        EXPECT_TRUE(bench.truth().servoOn);
        bench.bus.expectNoViolations();
    }
    /// Deviation from the analytic loop, in dB and degrees.
    [[nodiscard]] std::pair<double, double> off(const FrequencyPoint& point) const {
        const std::complex<double> open = openLoopAt(motor, gains, point.hertz);
        const std::complex<double> closed = open / (1.0 + open);
        return {decibels(point.closed) - decibels(closed),
                std::arg(point.closed / closed) * 180 / std::numbers::pi};
    }
    servo::SetGain gains;
    MotorConstants motor;
    ProcedureReport report;
};
class BodeOfASmallAmplitude : public BodeOf {};

TEST_P(BodeOf, IsThatOfTheAnalyticLoopWithinADecibelAndFiveDegrees) {
    ASSERT_NO_FATAL_FAILURE(measure());
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_GE(report.frequencies.size(), GetParam().baud == 115'200 ? 12U : 5U);
    double decibelsOff = 0.0, degreesOff = 0.0;
    for (const FrequencyPoint& point : report.frequencies) {
        const auto [tooHigh, ahead] = off(point);
        EXPECT_NEAR(tooHigh, 0.0, 1.0) << point.hertz << " Hz";
        EXPECT_NEAR(ahead, 0.0, 5.0) << point.hertz << " Hz";
        decibelsOff = std::max(decibelsOff, std::abs(tooHigh));
        degreesOff = std::max(degreesOff, std::abs(ahead));
    }
    std::printf("%s: Kp %d, Kd %d, %zu points to %.1f Hz, off by %.2f dB and %.2f degrees\n", GetParam().name,
                gains.kp, gains.kd, report.frequencies.size(), report.frequencies.back().hertz, decibelsOff,
                degreesOff);
}

TEST_P(BodeOfASmallAmplitude, IsWithinWhatItSaysOfItself) {
    ASSERT_NO_FATAL_FAILURE(measure());
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    for (const FrequencyPoint& point : report.frequencies) {
        const FrequencySpread spread = spreadOf(point);
        const auto [tooHigh, ahead] = off(point);
        EXPECT_LE(tooHigh, std::max(1.0, decibels(point.closed) - spread.lowest)) << point.hertz << " Hz";
        EXPECT_GE(tooHigh, std::min(-1.0, decibels(point.closed) - spread.highest)) << point.hertz << " Hz";
        EXPECT_LE(std::abs(ahead), std::max(5.0, spread.degrees)) << point.hertz << " Hz";
    }
}

/// With Kp 11, an error of 20 counts gives less than one PWM count: the motor hardly moves.
TEST(BodeOfNothing, IsNotGiven) {
    ProcedureBench bench(servos(1));
    bench.set(sim::Input::Friction, 0.0);
    ASSERT_TRUE(bench.connect() && bench.perform(intent::AskAnew{}) &&
                bench.perform(intent::ApplyGains{{11, 96, 0, 0, 255, 0, 4'000, 2, std::uint8_t{0}}}) &&
                bench.perform(intent::Enable{}) && bench.perform(intent::StopHere{}));
    const ProcedureReport report = bench.run(intent::FrequencyResponse{20, 3.0, 40.0});
    EXPECT_EQ(report.failure, ProcedureFailure::NotFollowing);
    EXPECT_TRUE(report.frequencies.empty());
    EXPECT_TRUE(bench.truth().servoOn);
}

constexpr double kHighest = 25.0;  ///< Hz

/// As wide as the sine may swing without OL cutting off what the derivative makes of its steps, 6.5 ms apart.
[[nodiscard]] int amplitudeFor(const servo::SetGain& gains) {
    const double step = 2 * std::numbers::pi * kHighest * 0.0065;
    return static_cast<int>(0.8 * 255 * 256 / (gains.kp + gains.kd * step));
}

[[nodiscard]] bool isNear(double a, double b) {
    return a <= 2 * b && b <= 2 * a;
}

/// Random gains, half of them with an integral, that leave a phase margin of 45 degrees, and the sine enough
/// room between whole PWM values and OL. `near`: not more than twice those, and not less than half.
[[nodiscard]] servo::SetGain someGains(sim::Random& random, const Plant& plant,
                                       const std::optional<servo::SetGain>& near) {
    const MotorConstants motor = testing_support::physics(motorOf(plant));
    for (;;) {
        Plant wanted = plant;
        wanted.hertz = 10 + 20 * random.unit();
        wanted.damping = 0.5 + 0.7 * random.unit();
        servo::SetGain gains = gainsOf(wanted);
        if (random.unit() < 0.5) {
            gains.ki = static_cast<std::uint16_t>(std::lround(gains.kp * random.unit()));
            gains.il = 32'000;
        }
        const LoopMargins margins = marginsOf(motor, gains);
        const bool isClose = !near || (isNear(gains.kp, near->kp) && isNear(gains.kd, near->kd));
        if (isClose && margins.stable && margins.phaseDegrees >= 45 &&
            amplitudeFor(gains) * gains.kp >= 3'000)
            return gains;
    }
}

/// What is calculated for other gains from one measurement, and what another one with them then finds.
class OtherGains : public testing::Test {
protected:
    /// `nearby`: the second gains are between half and twice the first.
    void comparePairs(bool nearby) {
        const std::uint64_t pairs = campaignSize("NMC_GAIN_PAIRS", 12);
        for (std::uint64_t pair = 0; pair < pairs && !HasFatalFailure(); ++pair)
            comparePair(pair, nearby);
        std::printf("%d pairs of gains, %d points: off by up to %.2f dB and %.2f degrees\n",
                    static_cast<int>(pairs), points, decibelsOff, degreesOff);
    }
    int points = 0;
    int within = 0;  ///< what the calculation says that it does not know, or 1 dB and 5 degrees
    double decibelsOff = 0.0, degreesOff = 0.0;

private:
    void comparePair(std::uint64_t pair, bool nearby) {
        const auto sr = static_cast<std::uint8_t>(1 + pair % 2);
        const Plant plant{"Any", pair % 3 == 0 ? 6e-5 : 1.7e-5, 2'000, 0, 0, sr, 0, 115'200};
        sim::ChainOptions options;
        options.motor = motorOf(plant);
        ProcedureBench bench(servos(1), options);
        ASSERT_TRUE(bench.connect() && bench.perform(intent::AskAnew{}));
        std::array<ProcedureReport, 2> found;
        for (ProcedureReport& report : found) {
            const servo::SetGain gains = someGains(m_random, plant, nearby ? found[0].gains : std::nullopt);
            ASSERT_TRUE(bench.perform(intent::ApplyGains{gains}) && bench.perform(intent::Enable{}) &&
                        bench.perform(intent::StopHere{}));
            report = bench.run(intent::FrequencyResponse{std::min(amplitudeFor(gains), 200), 3.0, kHighest});
            ASSERT_EQ(report.stage, ProcedureStage::Done);
            ASSERT_EQ(report.gains, gains);
        }
        const auto told = withOtherGains(found[0].frequencies, *found[0].gains, *found[1].gains);
        ASSERT_GE(told.size(), 10U);
        for (std::size_t i = 0; i < told.size(); ++i)
            compare(told[i], found[1].frequencies.at(i));
    }
    void compare(const FrequencyPoint& told, const FrequencyPoint& after) {
        ASSERT_EQ(told.hertz, after.hertz);
        const double loud = std::abs(decibels(told.closed / after.closed));
        const double late = std::abs(std::arg(told.closed / after.closed)) * 180 / std::numbers::pi;
        FrequencyPoint both = told;
        both.doubt = std::hypot(told.doubt, after.doubt);
        const FrequencySpread spread = spreadOf(both);
        within += loud <= std::max(1.0, decibels(told.closed) - spread.lowest) &&
                          late <= std::max(5.0, spread.degrees)
                      ? 1
                      : 0;
        ++points;
        decibelsOff = std::max(decibelsOff, loud);
        degreesOff = std::max(degreesOff, late);
    }
    sim::Random m_random{34};
};

TEST_F(OtherGains, UpToTwiceAndHalfDoWhatIsMeasuredAfterwards) {
    comparePairs(true);
    EXPECT_LE(decibelsOff, 1.0);
    EXPECT_LE(degreesOff, 5.0);
}

/// With a far lower gain, what the measurement leaves open is larger in proportion.
TEST_F(OtherGains, OfAnySizeDoSoWithinWhatIsSaidOfThem) {
    comparePairs(false);
    EXPECT_GE(within, 0.95 * points);
    EXPECT_LE(decibelsOff, 2.0);
    EXPECT_LE(degreesOff, 10.0);
}

/// The friction of an ordinary motor, and an amplitude that is too small for it at rest.
class BodeOnARamp : public BodeOf {
protected:
    static constexpr double kTo = 25.0;  ///< Hz
    void measureAt(double speed) {
        sim::ChainOptions options;
        options.motor = motorOf(GetParam());
        options.motor.coulombNm = sim::MotorParameters{}.coulombNm;
        gains = gainsOf(GetParam());
        motor = testing_support::physics(options.motor);
        ProcedureBench bench(servos(1, servoVersion()), options, GetParam().baud);
        ASSERT_TRUE(bench.connect() && bench.perform(intent::AskAnew{}) &&
                    bench.perform(intent::ApplyGains{gains}) && bench.perform(intent::Enable{}) &&
                    bench.perform(intent::StopHere{}));
        const double from = bench.truth().commandPosition;
        report = bench.run(intent::FrequencyResponse{GetParam().amplitude, 3.0, kTo, speed}, 120.0);
        ASSERT_EQ(report.stage, ProcedureStage::Done);
        EXPECT_TRUE(bench.truth().servoOn);
        EXPECT_EQ(bench.truth().commandPosition, from);
        bench.bus.expectNoViolations();
        decibelsOff = degreesOff = 0.0;
        for (const FrequencyPoint& point : report.frequencies) {
            const auto [tooHigh, ahead] = off(point);
            decibelsOff = std::max(decibelsOff, std::abs(tooHigh));
            degreesOff = std::max(degreesOff, std::abs(ahead));
        }
        std::printf("%s at %.0f counts/s: off by %.2f dB and %.2f degrees\n", GetParam().name, report.speed,
                    decibelsOff, degreesOff);
    }
    double decibelsOff = 0.0, degreesOff = 0.0;
};

TEST_P(BodeOnARamp, IsThatOfTheLoopWithoutFriction) {
    ASSERT_NO_FATAL_FAILURE(measureAt(0.0));
    const double atRest = decibelsOff;
    const double speed = 1.3 * 2 * std::numbers::pi * kTo * GetParam().amplitude;
    for (const double way : {1.0, -1.0}) {
        ASSERT_NO_FATAL_FAILURE(measureAt(way * speed / ticksPerSecond(gains.sr)));
        ASSERT_GE(report.frequencies.size(), 10U);
        EXPECT_LE(decibelsOff, 1.0);
        EXPECT_LE(degreesOff, 5.0);
        EXPECT_GT(atRest, 2 * decibelsOff) << "at rest, friction shows";
    }
}

constexpr std::uint32_t kFast = 115'200, kSlow = 19'200;
INSTANTIATE_TEST_SUITE_P(All, BodeOf,
                         testing::Values(Plant{"Usual", 1.7e-5, 2'000, 20, 0.7, 1, 36, kFast},
                                         Plant{"Springy", 1.7e-5, 2'000, 20, 0.4, 1, 40, kFast},
                                         Plant{"Overdamped", 1.7e-5, 2'000, 12, 1.0, 1, 88, kFast},
                                         Plant{"Stiff", 1.7e-5, 2'000, 35, 0.7, 1, 20, kFast},
                                         Plant{"HalfRate", 1.7e-5, 2'000, 15, 0.8, 2, 60, kFast},
                                         Plant{"QuarterRate", 6e-5, 8'000, 8, 0.8, 4, 150, kFast},
                                         Plant{"EighthRate", 1.7e-4, 8'000, 5, 0.8, 8, 150, kFast},
                                         Plant{"CoarseEncoder", 1.7e-5, 400, 15, 0.8, 1, 14, kFast},
                                         Plant{"FineEncoder", 1.7e-5, 8'000, 20, 0.7, 1, 150, kFast},
                                         Plant{"FineEncoderHalfRate", 1.7e-5, 8'000, 20, 0.6, 2, 150, kFast},
                                         Plant{"HeavyLoad", 6e-5, 2'000, 15, 0.7, 1, 16, kFast},
                                         Plant{"HeaviestLoad", 1.7e-4, 2'000, 10, 0.4, 1, 14, kFast},
                                         Plant{"HeaviestLoadFineEncoder", 1.7e-4, 8'000, 10, 0.5, 1, 50,
                                               kFast},
                                         Plant{"UsualSlowLine", 1.7e-5, 2'000, 20, 0.7, 1, 36, kSlow},
                                         Plant{"HalfRateSlowLine", 1.7e-5, 2'000, 15, 0.8, 2, 60, kSlow},
                                         Plant{"CoarseEncoderSlowLine", 1.7e-5, 400, 10, 1.0, 1, 25, kSlow},
                                         Plant{"HeaviestLoadSlowLine", 1.7e-4, 8'000, 10, 0.4, 1, 50, kSlow}),
                         [](const auto& plant) { return std::string(plant.param.name); });

INSTANTIATE_TEST_SUITE_P(All, BodeOnARamp,
                         testing::Values(Plant{"Usual", 1.7e-5, 2'000, 20, 0.7, 1, 20, kFast},
                                         Plant{"Springy", 1.7e-5, 2'000, 20, 0.4, 1, 20, kFast},
                                         Plant{"Stiff", 1.7e-5, 2'000, 35, 0.7, 1, 12, kFast},
                                         Plant{"HalfRate", 1.7e-5, 2'000, 15, 0.8, 2, 30, kFast},
                                         Plant{"FineEncoder", 1.7e-5, 8'000, 20, 0.7, 1, 80, kFast},
                                         Plant{"HeavyLoad", 6e-5, 2'000, 15, 0.7, 1, 8, kFast}),
                         [](const auto& plant) { return std::string(plant.param.name); });

/// Amplitudes that take only a few of the whole PWM values: what is reported about them is still true.
INSTANTIATE_TEST_SUITE_P(All, BodeOfASmallAmplitude,
                         testing::Values(Plant{"Usual", 1.7e-5, 2'000, 20, 0.7, 1, 12, kFast},
                                         Plant{"Overdamped", 1.7e-5, 2'000, 12, 1.5, 1, 24, kFast},
                                         Plant{"HalfRate", 1.7e-5, 2'000, 15, 0.8, 2, 20, kFast},
                                         Plant{"HeaviestLoadSlowLine", 1.7e-4, 8'000, 6, 0.6, 1, 60, kSlow}),
                         [](const auto& plant) { return std::string(plant.param.name); });

}  // namespace
}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Suggested gains compared with their formulas, and tried on the simulator's motor.
#include "model/tuning/suggest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/campaign.h"
#include "tests/support/unknownmotor.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr servo::SetGain kNow{100, 1'000, 80, 50, 200, 33, 4'000, 1, std::uint8_t{5}};
constexpr servo::SetGain kAtFullOutput{100, 1'000, 80, 50, 255, 0, 4'000, 1, std::uint8_t{0}};

/// As fast as any rule permits.
constexpr LoopWish kFastest{1.0, 0.5, 1.0, kMinPhaseMargin};
const MotorConstants kSmallMotor{788, 0.013, 1.2, 0, 0.55e-3};

TEST(Suggest, TakesTheNoiseFromTheFormula) {
    // K / (256 tau) = 788 / 3.328 = 236.8: noise = 236.8 x 2000 x (0.512 ms)^2 = 0.1241.
    servo::SetGain gains{200, 2'000, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};
    EXPECT_NEAR(noiseOf(kSmallMotor, gains), 0.1241, 0.0002);
    gains.sr = 2;  // twice the tick: four times the noise
    EXPECT_NEAR(noiseOf(kSmallMotor, gains), 0.4966, 0.0005);
}

TEST(Suggest, KeepsWhatProtectsTheMotorAndTheMargins) {
    const auto gains = suggest(exactly(kSmallMotor), {}, kNow, 200);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->ol, kNow.ol);
    EXPECT_EQ(gains->cl, kNow.cl);
    EXPECT_EQ(gains->db, kNow.db);
    EXPECT_GT(gains->el, 200) << "a step must not trip";
    EXPECT_LE(gains->el, 800);
    const LoopMargins margins = marginsOf(kSmallMotor, *gains);
    EXPECT_TRUE(margins.stable);
    EXPECT_GE(margins.phaseDegrees, LoopWish{}.phaseMargin);
    EXPECT_GE(margins.gain, kMinGainMargin);
}

TEST(Suggest, HasThePhaseMarginThatWasWished) {
    double before = 1e9;  // Hz
    for (const double wished : {30.0, 45.0, 60.0, 70.0}) {
        LoopWish wish;
        wish.phaseMargin = wished;
        const auto gains = suggest(exactly(kSmallMotor), wish, kNow, 200);
        ASSERT_TRUE(gains);
        const LoopMargins margins = marginsOf(kSmallMotor, *gains);
        EXPECT_GE(margins.phaseDegrees, wished);
        EXPECT_LT(margins.crossover, before) << "a margin costs speed";
        before = margins.crossover;
    }
}

TEST(Suggest, IsNoLouderThanWished) {
    for (const double noise : {0.1, 0.4, 1.0}) {
        LoopWish wish;
        wish.noise = noise;
        const auto gains = suggest(exactly(kSmallMotor), wish, kNow, 200);
        ASSERT_TRUE(gains);
        EXPECT_LE(noiseOf(kSmallMotor, *gains), noise * kMaxNoise * 1.01);
    }
}

TEST(Suggest, IsStifferTheMoreItIsWished) {
    double before = 0;
    for (const double stiffness : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const auto gains = suggest(exactly(kSmallMotor), {stiffness, 0.5, 1.0}, kNow, 200);
        ASSERT_TRUE(gains);
        const double now = std::sqrt(1.0 * gains->kp);  // the natural frequency goes with it
        EXPECT_GT(now, before * 1.3) << stiffness;
        before = now;
    }
}

TEST(Suggest, HasAnIntegralOnlyForAnErrorThatItRemovesAndNoMoreThanCarriesIt) {
    // Kp is some hundreds: half a PWM count without friction leaves less than a count.
    MotorConstants motor = kSmallMotor;
    motor.friction = 0;
    auto gains = suggest(exactly(motor), {}, kNow, 200);
    ASSERT_TRUE(gains);
    EXPECT_EQ(gains->ki, 0);
    EXPECT_EQ(gains->il, 0);
    // Friction 6 and load 8 are 14 PWM counts, which is an error of more than ten counts.
    motor.friction = 6;
    motor.load = -8;
    gains = suggest(exactly(motor), {}, kNow, 200);
    ASSERT_TRUE(gains);
    const double carries = gains->ki * gains->il / 256.0;
    EXPECT_GE(carries, 14);
    EXPECT_LE(carries, 14 * 1.4);
    EXPECT_LE(std::abs(predict(exactly(motor), *gains, 0, 200, 3, 2).errorAtRest.value), 1);
}

TEST(Suggest, LowersTheServoRateForALargeInertiaAndACoarseEncoder) {
    EXPECT_EQ(suggest(exactly(kSmallMotor), {}, kNow, 200)->sr, 1);
    // Kd would not fit at SR 1: 2 zeta wn = 150 /s needs (150 x 0.5 - 1) x 256 / (160 x 0.512 ms) = 231 000.
    const MotorConstants heavy{160, 0.5, 1.2, 0, 0.55e-3};
    const auto gains = suggest(exactly(heavy), {}, kNow, 40);
    ASSERT_TRUE(gains);
    EXPECT_GT(gains->sr, 1);
    EXPECT_LE(noiseOf(heavy, *gains), kMaxNoise * 1.01);
}

TEST(Suggest, HasNothingForAMotorThatNoGainIsSmallEnoughFor) {
    // Even Kp 1 is 1e9 / 256 / 0.01 = 3.9e8: wn = 20 000 rad/s, ten times the servo rate.
    EXPECT_FALSE(suggest(exactly({1e9, 0.01, 1, 0, 0.5e-3}), {}, kNow, 200));
}

/// The simulator's motor with these constants: the inverse of physics().
[[nodiscard]] sim::MotorParameters plantOf(const MotorConstants& motor) {
    sim::MotorParameters p;
    const MotorConstants before = physics(p);
    const double nmPerPwm = p.coulombNm / before.friction;
    p.countsPerTurn *= motor.gain / before.gain;
    p.inertiaKgM2 *= motor.timeConstant / before.timeConstant;
    p.coulombNm = motor.friction * nmPerPwm;
    p.loadNm = -motor.load * nmPerPwm;
    return p;
}

/// Twice the time in which a second-order loop settles to 2 % if it is as fast as noise permits: 4 / (zeta
/// wn), with 2 zeta wn = 1 / tau + noise / T.
[[nodiscard]] double twiceTheTextbook(const MotorConstants& motor) {
    return 2 * 8 / (1 / motor.timeConstant + kMaxNoise / 512e-6);
}

[[nodiscard]] double settlingOf(const MotorConstants& motor, const servo::SetGain& gains, std::int32_t step) {
    TunedServo servo(plantOf(motor), gains, 5);
    servo.wait(2.0);
    return servo.step(step, 0.6).metrics.settling.value_or(Measured{0.6, 0}).value;
}

/// Before the step, the integral carries anything that friction permits.
TEST(SuggestOnTheMotor, SettlesWhicheverWayFrictionHeldTheLoad) {
    for (const double load : {-4.8, 4.8}) {
        const MotorConstants motor{1'025, 0.0135, 3.0, load, 0.55e-3};
        const auto gains = suggest(exactly(motor), {}, kAtFullOutput, 260);
        ASSERT_TRUE(gains);
        for (const int step : {260, -260})
            EXPECT_LT(settlingOf(motor, *gains, step), twiceTheTextbook(motor)) << load << ' ' << step;
    }
}

TEST(SuggestOnTheMotor, IsNoSlowerForALoadThatIsNotKnown) {
    const MotorConstants motor{583, 0.0088, 0.8, 0, 0.55e-3};
    MotorModel model = exactly(motor);
    model.load = {-4.4, 10.4};
    const auto gains = suggest(model, {}, kAtFullOutput, 147);
    ASSERT_TRUE(gains);
    EXPECT_LT(settlingOf(motor, *gains, 147), twiceTheTextbook(motor));
}

/// It may still come nearer, but does not move away again.
TEST(SuggestOnTheMotor, DoesNotHuntAroundItsGoal) {
    const MotorConstants motor{2'658, 0.0079, 0.9, 6.9, 0.55e-3};
    const auto gains = suggest(exactly(motor), {}, kAtFullOutput, 674);
    ASSERT_TRUE(gains);
    TunedServo servo(plantOf(motor), *gains, 5);
    servo.wait(0.3);
    (void)servo.step(674, 1.0);
    std::int32_t nearest = 674;
    for (int i = 0; i < 400; ++i) {
        servo.wait(0.01);
        const std::int32_t error = std::abs(servo.command() - servo.position());
        nearest = std::min(nearest, error);
        EXPECT_LE(error, nearest + 1);
    }
}

/// One step of the integral, an I of 256 count ticks, gives Ki (I / 256) / 256; one count gives Kp e / 256.
TEST(Suggest, PushesByOneStepOfTheIntegralNoMoreThanByOneCount) {
    for (const double friction : {0.5, 4.0, 12.0})
        for (const double tau : {0.008, 0.05, 0.5}) {
            const auto gains = suggest(exactly({800, tau, friction, 5, 0.55e-3}), {}, kNow, 200);
            ASSERT_TRUE(gains);
            EXPECT_LE(gains->ki, gains->kp) << friction << ' ' << tau;
        }
}

TEST(Suggest, HasGainsForEveryStiffnessWhereFrictionIsLarge) {
    for (const double stiffness : {0.0, 0.3, 1.0})
        EXPECT_TRUE(suggest(exactly({800, 0.012, 8, 3, 0.55e-3}), {stiffness, 0.5, 1.0}, kNow, 200))
            << stiffness;
}

/// One of the motors of tune_bench with seed 16: it has much friction and a coarse encoder, so a single count
/// decides whether the shaft stops inside its band.
struct StickingMotor {
    int number = 0;
    double fastest = 0.0;  ///< s, with the best gains of an exhaustive search under the same noise limit
};

class SuggestedForSticking : public testing::TestWithParam<StickingMotor> {};

TEST_P(SuggestedForSticking, SettleWithinOneAndAHalfTimesTheFastest) {
    sim::Random random(16);
    sim::MotorParameters motor;
    std::uint64_t seed = 0;
    for (int i = 0; i <= GetParam().number; ++i) {
        motor = unknownMotor(random);
        seed = random.next();
    }
    const auto found = identify(stepsOf(motor, seed));
    ASSERT_TRUE(found);
    servo::SetGain now = gainsToTry().front();
    now.ol = 255;
    const auto step = static_cast<std::int32_t>(motor.countsPerTurn / 10);
    const auto gains = suggest(found->motor, kFastest, now, step);
    ASSERT_TRUE(gains);
    EXPECT_LE(medianSettling(motor, *gains, step, seed), 1.5 * GetParam().fastest);
}

INSTANTIATE_TEST_SUITE_P(, SuggestedForSticking,
                         testing::Values(StickingMotor{27, 11.3e-3}, StickingMotor{121, 8.9e-3}),
                         [](const auto& given) { return "Motor" + std::to_string(given.param.number); });

TEST(SuggestedGains, SettleOnTheMotorThatWasFound) {
    sim::Random random(2'001);
    const std::uint64_t motors = test::campaignSize("NMC_MOTORS", 6);
    for (std::uint64_t i = 0; i < motors; ++i) {
        const sim::MotorParameters motor = unknownMotor(random);
        const MotorConstants truth = physics(motor);
        SCOPED_TRACE(testing::Message()
                     << "motor " << i << ": K " << truth.gain << " tau " << truth.timeConstant << " c "
                     << truth.friction << " load " << truth.load);
        const std::uint64_t seed = random.next();
        const auto found = identify(stepsOf(motor, seed));
        ASSERT_TRUE(found);
        servo::SetGain now = kNow;
        now.db = std::uint8_t{0};
        const auto step = static_cast<std::int32_t>(motor.countsPerTurn / 10);
        const auto gains = suggest(found->motor, kFastest, now, step);
        ASSERT_TRUE(gains);
        TunedServo servo(motor, *gains, seed);
        ASSERT_TRUE(comesToRest(servo));
        const ResponseRecord run = servo.step(step, 1.0);
        ASSERT_TRUE(run.metrics.settling) << "Kp " << gains->kp << " Kd " << gains->kd;
        EXPECT_LT(run.metrics.settling->value, 0.4);
        const Prediction prediction = predict(found->motor, *gains, 0, step, 1.0, kFirstBand);
        EXPECT_NEAR(run.metrics.overshoot->value, prediction.run.metrics.overshoot->value,
                    5 + run.metrics.overshoot->doubt);
    }
}

}  // namespace
}  // namespace nmc

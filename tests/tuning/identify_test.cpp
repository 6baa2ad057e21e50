// SPDX-License-Identifier: GPL-3.0-or-later
// Motors identified from steps of the simulator's motor; the truth follows from its physical constants.
#include "model/tuning/identify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/campaign.h"
#include "tests/support/unknownmotor.h"

namespace nmc {
namespace {

using namespace testing_support;

/// True if within `part` of the truth, or within two of the stated standard deviations.
[[nodiscard]] bool isNear(const Measured& found, double truth, double part) {
    const double off = std::abs(found.value - truth);
    return off <= part * std::abs(truth) || off <= 2 * found.doubt;
}

/// R 1.1 ohm, k 0.038 N m/A, 24 V, J 1.7e-5 kg m^2, friction 4 mN m, 2000 counts: K = 24 / 255 / 0.038 x 2000
/// / 2 pi = 788.4 counts/s; tau = 1.7e-5 x 1.1 / 0.038^2 = 12.95 ms; a PWM count is 24 / 255 / 1.1 x 0.038
/// = 3.251 mN m, so c = 1.230 and a load of 10 mN m that pulls back is -3.076.
TEST(Identify, FindsTheSimulatorsMotor) {
    sim::MotorParameters motor;
    motor.loadNm = 0.010;
    const auto found = identify(stepsOf(motor, 7));
    ASSERT_TRUE(found);
    const MotorModel& model = found->motor;
    EXPECT_NEAR(model.gain.value, 788.4, 78.8);
    EXPECT_NEAR(model.timeConstant.value, 0.01295, 0.0013);
    EXPECT_NEAR(model.friction.value, 1.230, std::max(0.31, 2 * model.friction.doubt));
    EXPECT_NEAR(model.load.value, -3.076, std::max(0.77, 2 * model.load.doubt));
    EXPECT_NEAR(model.delay.value, 0.6e-3 / 1.1, 0.4e-3) << "L / R";
    EXPECT_LT(model.gain.doubt, 0.2 * model.gain.value);
    EXPECT_GT(model.gain.doubt, 0);
}

TEST(Identify, SaysWhatTheMotorFoundWouldHaveDone) {
    const auto runs = stepsOf({}, 8);
    const auto found = identify(runs);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->runs.size(), runs.size());
    for (std::size_t run = 0; run < runs.size(); ++run) {
        ASSERT_EQ(found->runs[run].size(), runs[run].points.size());
        for (std::size_t i = 0; i < runs[run].points.size(); ++i) {
            EXPECT_EQ(found->runs[run][i].seconds, runs[run].points[i].seconds);
            EXPECT_NEAR(found->runs[run][i].position, runs[run].points[i].position, 12)
                << "a tick at 20 000 counts/s";
        }
    }
    EXPECT_LT(found->missed, 2 * found->expected);
}

TEST(Identify, IsContentWithOneStep) {
    const auto runs = stepsOf({}, 9);
    const auto found = identify(std::span(runs).subspan(2, 1));
    ASSERT_TRUE(found);
    EXPECT_TRUE(isNear(found->motor.gain, 788.4, 0.1)) << found->motor.gain.value;
    EXPECT_TRUE(isNear(found->motor.timeConstant, 0.01295, 0.1)) << found->motor.timeConstant.value;
}

TEST(Identify, TakesTheServoRateAndTheDeadbandIntoAccount) {
    const servo::SetGain gains{150, 700, 0, 0, 100, 0, 4'000, 2, std::uint8_t{3}};
    TunedServo servo({}, gains, 10);
    servo.wait(0.5);
    std::vector<ResponseRecord> runs;
    for (const int counts : {200, -200, 400}) {
        runs.push_back(servo.step(counts, 0.5));
        servo.wait(0.5);
    }
    const auto found = identify(runs);
    ASSERT_TRUE(found);
    EXPECT_TRUE(isNear(found->motor.gain, 788.4, 0.1)) << found->motor.gain.value;
    EXPECT_TRUE(isNear(found->motor.timeConstant, 0.01295, 0.1)) << found->motor.timeConstant.value;
    EXPECT_TRUE(isNear(found->motor.friction, 1.230, 0.25)) << found->motor.friction.value;
}

/// Friction and load are 9.9 and -4.8 PWM counts; the integral of the first gains carries 80 x 50 / 256
/// = 15.6.
TEST(Identify, FindsFrictionAndLoadThatAnIntegralCanHardlyCarry) {
    sim::MotorParameters motor;
    motor.inertiaKgM2 = 1.07e-4;
    motor.coulombNm = 0.0321;
    motor.loadNm = 0.0155;
    motor.countsPerTurn = 586;
    const auto found = identify(stepsOf(motor, 11));
    ASSERT_TRUE(found);
    const MotorConstants truth = physics(motor);
    EXPECT_TRUE(isNear(found->motor.friction, truth.friction, 0.25)) << found->motor.friction.value;
    EXPECT_TRUE(isNear(found->motor.load, truth.load, 0.25)) << found->motor.load.value;
}

/// 80 mN m are 24.6 PWM counts, of which the integral carries 15.6; an error of 23 counts holds the rest.
TEST(Identify, FindsALoadThatTheIntegralCannotCarry) {
    for (const double load : {0.080, -0.080}) {
        sim::MotorParameters motor;
        motor.loadNm = load;
        TunedServo servo(motor, gainsToTry().front(), 5);
        servo.wait(1.0);
        std::vector<ResponseRecord> runs;
        for (const int counts : {100, -100, 200}) {
            runs.push_back(servo.step(counts, 0.5));
            servo.wait(0.5);
        }
        const auto found = identify(runs);
        ASSERT_TRUE(found) << load;
        const MotorConstants truth = physics(motor);
        EXPECT_TRUE(isNear(found->motor.load, truth.load, 0.05)) << found->motor.load.value;
        EXPECT_TRUE(isNear(found->motor.gain, truth.gain, 0.1)) << found->motor.gain.value;
        EXPECT_TRUE(isNear(found->motor.friction, truth.friction, 0.25)) << found->motor.friction.value;
    }
}

/// A deadband of 8 leaves 24 V / 247 for each PWM count above it: K = 24 / 247 / 0.038 x 2000 / 2 pi = 813.9,
/// c = 0.004 x 1.1 / 0.038 x 247 / 24 = 1.192.
TEST(Identify, TellsADeadbandFromFriction) {
    sim::MotorParameters motor;
    motor.amplifierDeadbandPwm = 8;
    const auto found = identify(stepsOf(motor, 12));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->motor.deadband.value, 8, 2 * found->motor.deadband.doubt);
    EXPECT_LT(found->motor.deadband.doubt, 1);
    EXPECT_NEAR(found->motor.friction.value, 1.192, 2 * found->motor.friction.doubt);
    EXPECT_TRUE(isNear(found->motor.gain, 813.9, 0.1)) << found->motor.gain.value;
    const auto without = identify(stepsOf({}, 12));
    ASSERT_TRUE(without);
    EXPECT_NEAR(without->motor.deadband.value, 0, 1);
}

TEST(Identify, FindsAPlayOfAFewCounts) {
    for (const std::int64_t play : {2, 6}) {
        sim::MotorParameters motor;
        motor.playCounts = play;
        const auto found = identify(stepsOf(motor, 13));
        ASSERT_TRUE(found) << play;
        EXPECT_NEAR(found->motor.play.value, static_cast<double>(play), 2 * found->motor.play.doubt);
        EXPECT_LT(found->motor.play.doubt, 2);
        EXPECT_TRUE(isNear(found->motor.gain, 788.4, 0.1)) << found->motor.gain.value;
    }
}

/// 0.4 counts rms, rounded to whole counts: 21.1 % of all are off by more than half a count, which is 1.25
/// times that, and hardly any by more than one and a half: sqrt(0.211) = 0.46.
TEST(Identify, SeesTheEncodersNoiseWhereTheShaftStands) {
    sim::MotorParameters motor;
    motor.encoderNoiseCounts = 0.4;
    const auto found = identify(stepsOf(motor, 14));
    const auto without = identify(stepsOf({}, 14));
    ASSERT_TRUE(found && without);
    EXPECT_NEAR(found->motor.noise, 0.46, 0.15);
    EXPECT_EQ(without->motor.noise, 0);
}

/// A motor that is 60 times as heavy, with a fifth of the counts, shows less.
TEST(Identify, SaysUpToWhereAResonanceWouldHaveShown) {
    const auto fine = identify(stepsOf({}, 15));
    sim::MotorParameters heavy;
    heavy.inertiaKgM2 = 1e-3;
    heavy.countsPerTurn = 400;
    const auto coarse = identify(stepsOf(heavy, 15));
    ASSERT_TRUE(fine && coarse);
    ASSERT_TRUE(fine->motor.rigidUpTo && coarse->motor.rigidUpTo);
    EXPECT_GT(*fine->motor.rigidUpTo, *coarse->motor.rigidUpTo);
}

/// scripts/bench tune gives the figures of three hundred.
TEST(UnknownMotors, AreFound) {
    sim::Random random(1'001);
    const std::uint64_t motors = test::campaignSize("NMC_MOTORS", 9);
    for (std::uint64_t i = 0; i < motors; ++i) {
        const sim::MotorParameters motor = unknownMotor(random);
        const MotorConstants truth = physics(motor);
        SCOPED_TRACE(testing::Message()
                     << "motor " << i << ": K " << truth.gain << " tau " << truth.timeConstant << " c "
                     << truth.friction << " load " << truth.load);
        const auto found = identify(stepsOf(motor, random.next()));
        ASSERT_TRUE(found) << static_cast<int>(found.error());
        EXPECT_TRUE(isNear(found->motor.gain, truth.gain, 0.1))
            << found->motor.gain.value << " +- " << found->motor.gain.doubt;
        EXPECT_TRUE(isNear(found->motor.timeConstant, truth.timeConstant, 0.1))
            << found->motor.timeConstant.value << " +- " << found->motor.timeConstant.doubt;
        EXPECT_TRUE(isNear(found->motor.friction, truth.friction, 0.25))
            << found->motor.friction.value << " +- " << found->motor.friction.doubt;
    }
}

/// With play, deadband, encoder noise and springs, machines for which nothing is found are rare. tune_bench
/// gives the figures of three hundred.
TEST(UnknownMachines, AreFound) {
    sim::Random random(1'004);
    const std::uint64_t machines = test::campaignSize("NMC_MOTORS", 5);
    std::uint64_t found = 0;
    for (std::uint64_t i = 0; i < machines; ++i) {
        const sim::MotorParameters motor = unknownMachine(random);
        found += identify(stepsOf(motor, random.next())) ? 1U : 0U;
    }
    EXPECT_GE(found * 10, machines * 9);
}

}  // namespace
}  // namespace nmc

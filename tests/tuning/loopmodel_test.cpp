// SPDX-License-Identifier: GPL-3.0-or-later
// The motor's equation and the filter, compared with closed forms and with sums calculated by hand.
#include "model/tuning/loopmodel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/tunedservo.h"

namespace nmc {
namespace {

/// 1000 counts/s per PWM count, 0.1 s, 2 PWM counts of friction.
constexpr MotorConstants kMotor{1'000, 0.1, 2, 0, 0};
const double kE = std::exp(1.0);

[[nodiscard]] servo::SetGain bareGains(std::uint16_t kp, std::uint16_t kd) {
    servo::SetGain gains;
    gains.kp = kp;
    gains.kd = kd;
    gains.ol = 255;
    return gains;
}

TEST(MotorMotion, GathersSpeedAsAFirstOrderLag) {
    // Towards 1000 (10 - 2) = 8000 counts/s: 8000 (1 - 1/e) after tau, having gone 8000 tau / e.
    const MotorMotion motion = moved(kMotor, {100, 0}, 10, 0.1);
    EXPECT_NEAR(motion.velocity, 8'000 * (1 - 1 / kE), 1e-6);
    EXPECT_NEAR(motion.position, 100 + 800 / kE, 1e-6);
}

TEST(MotorMotion, EndsAtTheSpeedThatPwmLoadAndFrictionLeave) {
    MotorConstants motor = kMotor;
    motor.load = 3;
    // -1000 (10 - 3 - 2)
    EXPECT_NEAR(moved(motor, {}, -10, 10).velocity, -5'000, 1e-6);
    EXPECT_NEAR(moved(motor, {}, 10, 10).velocity, 11'000, 1e-6);
}

TEST(MotorMotion, StandsAsLongAsFrictionHoldsIt) {
    MotorConstants motor = kMotor;
    motor.load = 1.5;
    EXPECT_EQ(moved(motor, {7, 0}, 0.5, 1).position, 7) << "0.5 + 1.5 is the most that friction can hold";
    EXPECT_EQ(moved(motor, {7, 0}, -3.5, 1).position, 7);
    EXPECT_GT(moved(motor, {7, 0}, 0.51, 1).position, 7);
    EXPECT_LT(moved(motor, {7, 0}, -3.51, 1).position, 7);
}

TEST(MotorMotion, StopsWithinATickAndStays) {
    // From 2000 (e - 1) counts/s towards -2000: at 0 after tau ln(1 + (e - 1)) = tau, having gone
    // -2000 tau + 2000 e tau (1 - 1/e) = 2000 tau (e - 2).
    const MotorMotion motion = moved(kMotor, {0, 2'000 * (kE - 1)}, 0, 5);
    EXPECT_EQ(motion.velocity, 0);
    EXPECT_NEAR(motion.position, 200 * (kE - 2), 1e-6);
}

TEST(MotorMotion, TurnsRoundWithinATickWithFrictionOnTheOtherSide) {
    // Towards -12 000 from 12 000 (e - 1): at 0 after tau, 1200 (e - 2) farther on; then towards -8000 for
    // another tau.
    const MotorMotion motion = moved(kMotor, {0, 12'000 * (kE - 1)}, -10, 0.2);
    EXPECT_NEAR(motion.velocity, -8'000 * (1 - 1 / kE), 1e-6);
    EXPECT_NEAR(motion.position, 1'200 * (kE - 2) - 800 / kE, 1e-6);
}

TEST(ControlFilterModel, CutsOffLikeTheChip) {
    ControlFilter filter(bareGains(100, 200), Rounding::Chip, 0, 0);
    EXPECT_EQ(filter.output(5), 5) << "100 x 5 + 200 x 5 = 1500, / 256 = 5.9";
    EXPECT_EQ(filter.output(5), 1) << "500 / 256 = 1.95";
    EXPECT_EQ(filter.output(-5), -9) << "-500 - 2000 = -2500, / 256 = -9.8";
    EXPECT_EQ(filter.output(-2), 1) << "-200 + 600 = 400, / 256 = 1.6";
}

TEST(ControlFilterModel, LimitsTheOutputAndAddsTheDeadbandToWhatIsNotZero) {
    servo::SetGain gains = bareGains(256, 0);
    gains.ol = 20;
    gains.db = std::uint8_t{7};
    ControlFilter filter(gains, Rounding::Chip, 0, 0);
    EXPECT_EQ(filter.output(5), 12);
    EXPECT_EQ(filter.output(-90), -27);
    EXPECT_EQ(filter.output(0), 0);
    gains.ol = 252;
    EXPECT_EQ(ControlFilter(gains, Rounding::Chip, 0, 0).output(1'000), 255) << "255 is the largest output";
}

/// 7 is added to 5, and 4 of that have no effect.
TEST(ControlFilterModel, KnowsWhatTheAmplifierMakesOfIt) {
    servo::SetGain gains = bareGains(256, 0);
    ControlFilter bare(gains, Rounding::Chip, 0, 0, 4);
    EXPECT_EQ(bare.output(5), 1);
    EXPECT_EQ(bare.output(-5), -1);
    EXPECT_EQ(bare.output(3), 0);
    gains.db = std::uint8_t{7};
    EXPECT_EQ(ControlFilter(gains, Rounding::Chip, 0, 0, 4).output(5), 8);
}

/// Against a load of 3, friction of 2 holds from -5 to -1; beyond a deadband of 4, these are -9 and -5.
TEST(HoldingRangeOfAMotor, ReachesAcrossTheDeadband) {
    MotorConstants motor = kMotor;
    motor.deadband = 4;
    EXPECT_EQ(holdingRange(motor).least, -6);
    EXPECT_EQ(holdingRange(motor).most, 6);
    motor.load = 3;
    EXPECT_EQ(holdingRange(motor).least, -9);
    EXPECT_EQ(holdingRange(motor).most, -5);
    EXPECT_EQ(holdingRange(motor).at(0), -7);
}

TEST(ControlFilterModel, BoundsTheRunningSumBeforeItIsUsed) {
    servo::SetGain gains = bareGains(0, 0);
    gains.ki = 256 * 10;
    gains.il = 2;
    ControlFilter filter(gains, Rounding::Chip, 0, 0);
    EXPECT_EQ(filter.output(300), 10) << "300 / 256 is 1";
    EXPECT_EQ(filter.output(290), 20) << "590, limited to 2 x 256";
    EXPECT_EQ(filter.output(-600), 0) << "512 - 600 = -88, less than one 256th";
    EXPECT_EQ(ControlFilter(gains, Rounding::Chip, -2, 0).standing(), -20);
}

TEST(LoopModel, FirstMovesATickAfterTheCommandPlusTheDelay) {
    // Kp 256: 5 PWM counts from the first tick on, less 2: v = 3000 (1 - exp(-(t - delay) / tau)).
    MotorConstants motor = kMotor;
    motor.delay = 0.3e-3;
    Loop loop(motor, bareGains(256, 0), {0.5, 0, 0}, 5, Rounding::Chip);
    EXPECT_EQ(loop.at(-1).velocity, 0);
    EXPECT_EQ(loop.at(0.299e-3).velocity, 0);
    EXPECT_NEAR(loop.at(0.5e-3).velocity, 3'000 * (1 - std::exp(-0.002)), 1e-6);
    motor.delay = 0.512e-3 + 0.3e-3;
    Loop later(motor, bareGains(256, 0), {0.5, 0, 0}, 5, Rounding::Chip);
    EXPECT_EQ(later.at(0.8e-3).velocity, 0);
    EXPECT_NEAR(later.at(1.012e-3).velocity, 3'000 * (1 - std::exp(-0.002)), 1e-6);
}

TEST(LoopModel, TicksAtTheServoRate) {
    servo::SetGain gains = bareGains(256, 0);
    gains.sr = 4;
    EXPECT_DOUBLE_EQ(secondsPerTick(gains.sr), 4 * 512e-6);
    MotorConstants fast{1e5, 1e-3, 0, 0, 0};
    Loop loop(fast, gains, {0, 0, 0}, 5, Rounding::Chip);
    // 5 PWM counts during all of the first servo tick: 5e5 (t - tau (1 - exp(-t / tau))) counts.
    const double t = 2.04e-3;
    EXPECT_NEAR(loop.at(t).position, 5e5 * (t - 1e-3 * (1 - std::exp(-t / 1e-3))), 1e-6);
}

/// There are 10 PWM counts all the time, which accelerate both masses together by 10 000 counts/s^2. The
/// shaft is ahead of them by the second mass's share of the twist: half of 1e4 / w^2 (1 - cos w t). After
/// half a period of 50 Hz, with a damping of 0.02, this is 0.5 x 1e4 / 314.2^2 x (1 + exp(-0.02 pi)) =
/// 0.0982, and after a whole period 0.5 x 1e4 / 314.2^2 x (1 - exp(-0.04 pi)) = 0.0060.
TEST(LoopModel, ASecondMassSwingsAtTheResonance) {
    MotorConstants motor{1e6, 1'000, 0, 0, 0};
    motor.second = 0.5;
    motor.resonance = 50;
    servo::SetGain gains = bareGains(32'767, 0);
    gains.ol = 10;
    Loop loop(motor, gains, {0, 0, 0}, 2'000, Rounding::Chip);
    EXPECT_NEAR(loop.at(0.01).position, 1e4 * 0.01 * 0.01 / 2 + 0.0982, 0.002);
    EXPECT_NEAR(loop.at(0.02).position, 1e4 * 0.02 * 0.02 / 2 + 0.0060, 0.002);
}

/// The shaft has come from below. From the first tick that sees the new goal on, there are -100 PWM counts,
/// which give 1e7 counts/s in the end, with tau 0.1 ms: within 30 us it moves back by 1e7 x (30 us - tau (1 -
/// exp(-0.3))) = 40.8 counts.
TEST(LoopModel, LosesThePlayWhereItTurnsRound) {
    MotorConstants motor{1e5, 1e-4, 0, 0, 0};
    servo::SetGain gains = bareGains(256, 0);
    gains.ol = 100;
    const auto back = [&](double play) {
        motor.play = play;
        Loop loop(motor, gains, {0, 0, 0, 1.0}, -200, Rounding::Mean);
        return loop.at(30e-6).position;
    };
    EXPECT_NEAR(back(0), -40.8, 0.1);
    EXPECT_NEAR(back(30), -10.8, 0.1);
    EXPECT_EQ(back(50), 0) << "the play is more than it has turned";
}

/// Without inductance, the simulator's plant is this model: the step is the same, apart from what the unknown
/// time of the command and the fraction of a count leave open.
TEST(LoopModel, MovesLikeTheSimulatorsMotor) {
    sim::MotorParameters plain;
    plain.inductanceHenry = 1e-6;
    plain.viscousNmS = 0;
    plain.loadNm = 0.002;
    const servo::SetGain soft{100, 1'000, 80, 50, 64, 0, 4'000, 1, std::uint8_t{0}};
    const servo::SetGain stiff{300, 4'000, 0, 0, 255, 0, 4'000, 2, std::uint8_t{3}};
    const servo::SetGain loose{600, 200, 20, 100, 120, 0, 4'000, 1, std::uint8_t{0}};
    sim::MotorParameters dead = plain;
    dead.amplifierDeadbandPwm = 9;
    sim::MotorParameters playing = plain;
    playing.playCounts = 7;
    sim::MotorParameters elastic = plain;
    elastic.elasticInertiaKgM2 = 0.5 * plain.inertiaKgM2;
    elastic.resonanceHz = 30;
    using Case = std::pair<sim::MotorParameters, servo::SetGain>;
    for (const auto& [motor, gains] : {Case{plain, soft}, Case{plain, stiff}, Case{plain, loose},
                                       Case{dead, soft}, Case{playing, soft}, Case{elastic, soft}}) {
        testing_support::TunedServo servo(motor, gains, 1);
        servo.wait(1);
        const ResponseRecord run = servo.step(200, 0.3);
        MotorConstants constants = testing_support::physics(motor);
        constants.delay = 0;
        if (motor.elasticInertiaKgM2 > 0) {
            constants.second = 0.5;
            constants.resonance = motor.resonanceHz;
        }
        LoopStart start{run.points.front().position + 0.5, 0, 0, 0.0};
        if (gains.ki > 0)
            start.integral = -constants.load * 256 / gains.ki;
        Loop loop(constants, gains, start, 200, Rounding::Chip);
        double worst = 0;
        for (const ResponsePoint& point : run.points) {
            const double model = loop.at(point.seconds - gains.sr * 512e-6).position;
            const double speed = loop.at(point.seconds - gains.sr * 512e-6).velocity;
            // Half a tick for the command, half a tick for the sample, 0.1 ms for each, and the rest of a
            // long tick.
            const double allowed = 4 + std::abs(speed) * (gains.sr * 512e-6 + 0.2e-3);
            worst = std::max(worst, std::abs(point.position - model) / allowed);
        }
        EXPECT_LT(worst, 1) << "Kp " << gains.kp << " deadband " << motor.amplifierDeadbandPwm << " play "
                            << motor.playCounts << " second mass " << motor.elasticInertiaKgM2;
    }
}

}  // namespace
}  // namespace nmc

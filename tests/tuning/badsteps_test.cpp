// SPDX-License-Identifier: GPL-3.0-or-later
// Steps from which no motor can be found: each gives a reason, and no model.
#include <gtest/gtest.h>

#include "model/tuning/identify.h"
#include "tests/support/unknownmotor.h"

namespace nmc {
namespace {

using namespace testing_support;

[[nodiscard]] servo::SetGain limitedGains(std::uint16_t kp, std::uint16_t kd) {
    return {kp, kd, 0, 0, 64, 0, 4'000, 1, std::uint8_t{0}};
}

class BadSteps : public testing::Test {
protected:
    [[nodiscard]] static std::vector<ResponseRecord> thereAndBack(TunedServo& servo) {
        servo.wait(0.2);
        std::vector<ResponseRecord> runs;
        for (const int counts : {200, -200, 400}) {
            runs.push_back(servo.step(counts, 0.5));
            servo.wait(0.3);
        }
        return runs;
    }
    static void expect(const std::vector<ResponseRecord>& runs, IdentifyFailure why) {
        const auto found = identify(runs);
        ASSERT_FALSE(found) << "K " << found->motor.gain.value << " missed " << found->missed << " expected "
                            << found->expected;
        EXPECT_EQ(found.error(), why);
    }
};

TEST_F(BadSteps, OfNoRunsAtAll) {
    expect({}, IdentifyFailure::TooFewSamples);
}

TEST_F(BadSteps, WithTooFewSamples) {
    TunedServo servo({}, limitedGains(200, 2'000), 1);
    std::vector<ResponseRecord> runs = thereAndBack(servo);
    runs[1].points.resize(20);  // a few of these are from before the step
    expect(runs, IdentifyFailure::TooFewSamples);
}

TEST_F(BadSteps, OfAJammedShaft) {
    sim::MotorParameters motor;
    motor.coulombNm = 1.0;
    TunedServo servo(motor, limitedGains(200, 2'000), 2);
    expect(thereAndBack(servo), IdentifyFailure::DoesNotMove);
}

TEST_F(BadSteps, OfAMotorWithoutPower) {
    TunedServo servo({}, limitedGains(200, 2'000), 3);
    servo.setPower(false);
    expect(thereAndBack(servo), IdentifyFailure::DoesNotMove);
}

TEST_F(BadSteps, WithTheEncoderReversed) {
    TunedServo servo({}, limitedGains(200, 2'000), 4);
    servo.reverseEncoder();
    expect({servo.step(200, 0.1)}, IdentifyFailure::WrongWay);
}

TEST_F(BadSteps, ThatHitALimit) {
    sim::MotorParameters motor;
    motor.travelMaxCounts = 120;
    TunedServo servo(motor, limitedGains(200, 2'000), 5);
    expect(thereAndBack(servo), IdentifyFailure::Obstacle);
}

TEST_F(BadSteps, ThatEndAtAHardStop) {
    for (const std::uint16_t kp : {std::uint16_t{100}, std::uint16_t{700}}) {
        sim::MotorParameters motor;
        motor.travelMaxCounts = 60;
        TunedServo servo(
            motor, {kp, static_cast<std::uint16_t>(kp * 10), 80, 50, 127, 0, 4'000, 1, std::uint8_t{0}}, 5);
        servo.wait(0.2);
        expect({servo.step(100, 0.5)}, IdentifyFailure::Obstacle);
    }
}

/// Where friction holds the shaft 40 counts short of its goal, the motor slows down first.
TEST_F(BadSteps, ThatFrictionEndsAreNoObstacle) {
    sim::MotorParameters motor;
    motor.coulombNm = 0.04;  // 12.3 PWM counts; Kp e / 256 is no more than that at 31 counts
    TunedServo servo(motor, limitedGains(100, 1'000), 5);
    servo.wait(0.2);
    const auto found = identify(std::vector{servo.step(100, 0.5)});
    EXPECT_TRUE(found || found.error() != IdentifyFailure::Obstacle);
}

TEST_F(BadSteps, ThatOscillate) {
    // Ki is far beyond what Kp 100 and little damping permit.
    servo::SetGain gains{100, 100, 3'000, 2'000, 255, 0, 4'000, 1, std::uint8_t{0}};
    TunedServo servo({}, gains, 6);
    servo.wait(0.2);
    expect({servo.step(200, 0.5)}, IdentifyFailure::Oscillates);
}

TEST_F(BadSteps, WithABacklashOfSomeDegrees) {
    TunedServo servo({}, limitedGains(200, 2'000), 7);
    servo.setBacklash(30);
    expect(thereAndBack(servo), IdentifyFailure::Play);
}

}  // namespace
}  // namespace nmc

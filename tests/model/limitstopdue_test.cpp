// SPDX-License-Identifier: GPL-3.0-or-later
// What has to be armed for an axis that uses a limit stop for each of its motions (DS-V 5.2, Set Homing
// Mode).
#include <gtest/gtest.h>

#include <string>

#include "model/intent/homingplan.h"
#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

// DS-V 5.3, status byte.
constexpr unsigned kLimit1Closed = 0x20;
constexpr unsigned kLimit2Closed = 0x40;

class LimitStopDue : public testing::Test {
protected:
    LimitStopDue() { servo.limitStop.eachMotion = true; }
    /// The servo holds.
    void says(unsigned bits) {
        const auto status = static_cast<std::uint8_t>(kMoveDone | kPower | bits);
        servo.apply(sampleOf(time += 0.1, status, kServoOn));
    }
    /// As the panel arms it.
    void arm(unsigned bits = 0) {
        const auto due = limitStopDue(servo);
        ASSERT_TRUE(due);
        const Plan orders = plan(*due, servo);
        ASSERT_TRUE(orders) << "what is due can be armed";
        servo.apply(executedAt(time += 0.1, std::get<ServoCommand>(orders->front().command)));
        says(kHoming | bits);
    }
    [[nodiscard]] std::string due() const {
        const auto arm = limitStopDue(servo);
        if (!arm)
            return "nothing";
        return std::string(arm->onLimit1 ? "limit1 " : "") + (arm->onLimit2 ? "limit2 " : "") +
               (arm->onPositionError ? "error " : "") + (arm->onCurrentLimit ? "current " : "");
    }
    ModuleState servo = holdingServo();
    double time = 1.0;
};

TEST_F(LimitStopDue, ALimitOnWhichTheMotorStandsLeavesTheOtherArmed) {
    EXPECT_EQ(due(), "limit1 limit2 ");
    ASSERT_NO_FATAL_FAILURE(arm());
    EXPECT_EQ(due(), "nothing");
    says(kHoming | kLimit1Closed);
    EXPECT_EQ(due(), "nothing") << "that it has tripped shows in the following reply";
    says(kLimit1Closed);
    EXPECT_EQ(due(), "limit2 ");
    ASSERT_NO_FATAL_FAILURE(arm(kLimit1Closed));
    EXPECT_EQ(due(), "nothing");
    says(kHoming);
    EXPECT_EQ(due(), "limit1 limit2 ") << "the motor has left the switch";
    says(kLimit1Closed | kLimit2Closed);
    EXPECT_EQ(due(), "nothing");
}

/// DS-V 5.2, Set Gain: CL 0 disables current limiting.
TEST_F(LimitStopDue, ACurrentThatIsNotLimitedLeavesTheLimitsArmed) {
    servo.limitStop.stop.onCurrentLimit = true;
    servo.gains.reset();
    EXPECT_EQ(due(), "limit1 limit2 ");
    servo::SetGain gains = *holdingServo().gains;
    gains.cl = 0;
    servo.apply(executedAt(time += 0.1, gains));
    ASSERT_NO_FATAL_FAILURE(arm());
    EXPECT_EQ(due(), "nothing");
    gains.cl = 51;
    servo.apply(executedAt(time += 0.1, gains));
    EXPECT_EQ(due(), "limit1 limit2 current ");
    ASSERT_NO_FATAL_FAILURE(arm());
    servo.doubtGains();
    EXPECT_EQ(due(), "nothing") << "the chip still watches the current";
    servo.limitStop.stop.onCurrentLimit = false;
    EXPECT_EQ(due(), "limit1 limit2 ");
}

/// DS-V 5.2: the chip stops the motor in the manner of the last Set Homing Mode.
TEST_F(LimitStopDue, ItIsArmedAgainInAnotherManner) {
    for (const auto manner : {StopManner::Smoothly, StopManner::Off, StopManner::Abruptly}) {
        servo.limitStop.stop.manner = manner;
        EXPECT_EQ(due(), "limit1 limit2 ");
        ASSERT_NO_FATAL_FAILURE(arm());
        EXPECT_EQ(due(), "nothing");
    }
}

TEST_F(LimitStopDue, ALimitPinThatIsAnOutputLeavesTheOtherArmed) {
    servo.apply(executedAt(time += 0.1, servo::IoControl{.limit1IsInput = false, .limit2IsInput = true}));
    EXPECT_EQ(due(), "limit2 ");
    ASSERT_NO_FATAL_FAILURE(arm());
    EXPECT_EQ(due(), "nothing");
}

}  // namespace
}  // namespace nmc

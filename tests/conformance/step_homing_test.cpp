// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.4 and 5.1: homing, Set Homing Mode, Save Current Position as Home.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

constexpr unsigned kLimit1 = 0x01, kLimit2 = 0x02, kTurnOff = 0x04, kHomeSwitch = 0x08, kAbruptly = 0x10,
                   kSmoothly = 0x20;

class PicStepHoming : public PicStep {
protected:
    PicStepHoming() { parameters(k1x | kIgnoreLimits); }
    void home(unsigned control) { EXPECT_EQ(command(0x19, {static_cast<std::uint8_t>(control)}).size(), 2U); }
    bool inProgress() { return (status() & 0x80U) != 0; }
    void expectCapturedOn(const std::string& pin, unsigned control);
    void findAtSpeed(unsigned stopBit);
};

INSTANTIATE_TEST_SUITE_P(, PicStepHoming, kPlaces, nameOf);

/// Checks the capture at 1000 steps per second, on both changes of the switch.
void PicStepHoming::expectCapturedOn(const std::string& pin, unsigned control) {
    for (const char* level : {" 1", " 0"}) {
        home(control);
        run();
        rig->wait(milliseconds(200));
        EXPECT_TRUE(inProgress()) << pin << level;
        const std::int64_t there = position();
        set(pin + level);
        rig->wait(milliseconds(200));
        const StepperReport r = report();
        EXPECT_EQ(r.status & 0x80U, 0U) << pin << level;
        EXPECT_NEAR(r.home, static_cast<double>(there), 1);
        EXPECT_GT(r.position, there + 190) << "no manner of stopping was given";
        stop(0x05);
    }
    expectNoViolations();
}

/// Runs into a switch at 2000 with 3000 steps per second, in a profile from 20 to 120 with 1 ms for each
/// speed. Returns in the tick that finds home.
void PicStepHoming::findAtSpeed(unsigned stopBit) {
    parameters(k1x, 20);
    set("home_switch_at 2000");
    home(kHomeSwitch | stopBit);
    load({.speed = 120, .acceleration = 4});
    for (int i = 0; i < 5'000 && truth<bool>("homing"); ++i)
        rig->wait(kTick);
    // The switch is sampled once a tick, in which the motor makes 1.5 steps.
    EXPECT_NEAR(truth<double>("home"), 2'001, 1);
    expectNoViolations();
}

// ---- 4.4 ----

TEST_P(PicStepHoming, Homing1_AChangeOfALimitSwitchStoresThePosition) {
    expectCapturedOn("limit1", kLimit1);
    expectCapturedOn("limit2", kLimit2);
}

TEST_P(PicStepHoming, Homing2_AChangeOfTheHomingSwitchStoresThePosition) {
    expectCapturedOn("home_switch", kHomeSwitch);
}

TEST_P(PicStepHoming, Homing3_TheMotorOptionallyDeceleratesToAStop) {
    findAtSpeed(kSmoothly);
    EXPECT_NEAR(secondsToStop(), 0.1, 0.0006);
    // (21 + ... + 120) x 25 steps per second x 1 ms.
    EXPECT_NEAR(truth<double>("position") - truth<double>("home"), 176.25, 1);
    EXPECT_EQ(status(), 0x0CU);
}

TEST_P(PicStepHoming, Homing4_TheMotorOptionallyStopsAbruptly) {
    findAtSpeed(kAbruptly);
    EXPECT_EQ(status(), 0x0CU);
    EXPECT_EQ(truth<int>("position"), truth<int>("home"));
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStepHoming, Homing5_TheMotorIsOptionallyTurnedOff) {
    findAtSpeed(kTurnOff);
    EXPECT_EQ(status(), 0x08U);
    EXPECT_EQ(truth<int>("position"), truth<int>("home"));
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStepHoming, Homing6_OnceTheHomingBitFallsHomeCanBeReadWithReadStatus) {
    set("home_switch_at 300");
    home(kHomeSwitch);
    run();
    while (inProgress() && position() < 1'000) {
    }
    EXPECT_EQ(longAt(command(0x13, {0x10}), 1), 300) << "half a step a tick";
}

TEST_P(PicStepHoming, Homing7_TheHomingCommandDoesNotStartTheMotor) {
    load({.count = kCount, .start = false});
    home(kHomeSwitch | kAbruptly);
    EXPECT_FALSE(moving());
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    EXPECT_TRUE(inProgress());
}

TEST_P(PicStepHoming, Homing8_ALoadTrajectoryAfterItMovesInTheDesiredDirection) {
    parameters(k1x);
    set("travel_min -700");
    set("limits auto");
    home(kLimit2 | kAbruptly);
    run(true);
    static_cast<void>(secondsToStop());
    EXPECT_EQ(report().home, -700);
    expectNoViolations();
}

// ---- 5.1, Set Homing Mode ----

TEST_P(PicStepHoming, SetHomingMode1_IsCommand9WithOneByte) {
    expectForm("set_homing", 0x19, {kHomeSwitch});
}

TEST_P(PicStepHoming, SetHomingMode2_Bit0CapturesOnAChangeOfLimit1) {
    home(kLimit1);
    set("limit2 1");
    set("home_switch 1");
    EXPECT_TRUE(inProgress());
    expectCapturedOn("limit1", kLimit1);
}

TEST_P(PicStepHoming, SetHomingMode3_Bit1CapturesOnAChangeOfLimit2) {
    home(kLimit2);
    set("limit1 1");
    set("home_switch 1");
    EXPECT_TRUE(inProgress());
    expectCapturedOn("limit2", kLimit2);
}

TEST_P(PicStepHoming, SetHomingMode4_Bit2TurnsTheMotorOff) {
    home(kHomeSwitch | kTurnOff);
    run();
    set("home_switch 1");
    EXPECT_EQ(status(), 0x08U);
}

TEST_P(PicStepHoming, SetHomingMode5_Bit3CapturesOnAChangeOfTheHomeSwitch) {
    home(kHomeSwitch);
    set("limit1 1");
    set("limit2 1");
    EXPECT_TRUE(inProgress());
    expectCapturedOn("home_switch", kHomeSwitch);
}

TEST_P(PicStepHoming, SetHomingMode6_Bit4StopsAbruptly) {
    home(kHomeSwitch | kAbruptly);
    run();
    set("home_switch 1");
    rig->waitTicks(2);
    EXPECT_FALSE(moving());
    EXPECT_EQ(status(), 0x0CU);
    EXPECT_NEAR(truth<double>("position"), truth<double>("home"), 0);
}

TEST_P(PicStepHoming, SetHomingMode7_Bit5StopsSmoothly) {
    parameters(k1x | kIgnoreLimits, 20);
    load({.speed = 120, .acceleration = 40});  // 10 ms each
    rig->wait(seconds(2));
    load({.acceleration = 255, .start = false});  // without effect until Start Motion
    home(kHomeSwitch | kSmoothly);
    set("home_switch 1");
    rig->waitTicks(2);
    EXPECT_TRUE(moving());
    EXPECT_NEAR(secondsToStop(), 1.0, 0.002);
    EXPECT_EQ(status(), 0x0CU);
}

TEST_P(PicStepHoming, SetHomingMode8_Bits6And7AreNotUsed) {
    home(kHomeSwitch | 0xC0);
    run();
    rig->wait(milliseconds(200));
    EXPECT_TRUE(inProgress());
    set("home_switch 1");
    rig->waitTicks(2);
    EXPECT_FALSE(inProgress());
    EXPECT_TRUE(moving());
    expectViolations({"reserved_bits"});
}

TEST_P(PicStepHoming, SetHomingMode9_AnyOfTheFlaggedConditionsCapturesHome) {
    for (const char* pin : {"limit1 1", "limit2 1", "home_switch 1"}) {
        home(kLimit1 | kLimit2 | kHomeSwitch);
        EXPECT_TRUE(inProgress());
        moveTo(static_cast<std::int32_t>(position()) + 100);
        set(pin);
        rig->waitTicks(2);
        EXPECT_FALSE(inProgress()) << pin;
        EXPECT_EQ(report().home, position()) << pin;
    }
}

TEST_P(PicStepHoming, SetHomingMode10_HomeInProgressIsSetByTheCommandAndLoweredWhenHomeIsFound) {
    EXPECT_FALSE(inProgress());
    home(kHomeSwitch);
    rig->wait(seconds(10));
    EXPECT_TRUE(inProgress());
    set("home_switch 1");
    EXPECT_FALSE(inProgress());
    set("home_switch 0");
    EXPECT_FALSE(inProgress());
}

TEST_P(PicStepHoming, SetHomingMode11_OnlyOneOfTheMannersOfStoppingMayBeSet) {
    for (const unsigned one : {kTurnOff, kAbruptly, kSmoothly})
        home(kHomeSwitch | one);
    expectNoViolations();
    for (const unsigned two : {kTurnOff | kAbruptly, kTurnOff | kSmoothly, kAbruptly | kSmoothly})
        home(kHomeSwitch | two);
    expectViolations({"stop_bits", "stop_bits", "stop_bits"});
}

TEST_P(PicStepHoming, SetHomingMode12_ASwitchThatIsClosedAlreadyTriggersWhenItOpens) {
    set("home_switch 1");
    home(kHomeSwitch);
    rig->wait(seconds(1));
    EXPECT_TRUE(inProgress());
    set("home_switch 0");
    EXPECT_FALSE(inProgress());
}

// ---- 5.1, Save Current Position as Home ----

TEST_P(PicStepHoming, SaveCurrentPositionAsHome1_IsCommandCWithoutData) {
    expectForm("save_as_home", 0x0C, {});
}

TEST_P(PicStepHoming, SaveCurrentPositionAsHome2_SavesThePositionInTheHomeRegister) {
    for (const std::int32_t goal : {150, -20}) {
        moveTo(goal);
        EXPECT_NE(report().home, goal);
        command(0x0C);
        EXPECT_EQ(report().home, goal);
    }
}

TEST_P(PicStepHoming, SaveCurrentPositionAsHome3_ToAGroupStoresAllPositionsAtOnce) {
    fresh("step,step");
    for (const unsigned address : {1U, 2U}) {
        rig->command(address, 0x56, {k1x, 1, 0, 0, 0});
        rig->command(address, 0x44, {0x08, 0x91, 0xFD, kNearest});
    }
    rig->command(0xFF, 0x05);
    rig->wait(seconds(1));
    rig->command(0xFF, 0x0C);
    const std::int32_t first = longAt(rig->command(1, 0x13, {0x10}), 1);
    const std::int32_t second = longAt(rig->command(2, 0x13, {0x10}), 1);
    EXPECT_GT(first, 990);
    EXPECT_NEAR(first, second, 1) << "although they were read 20 ms, or 20 steps, apart";
    expectNoViolations();
}

}  // namespace
}  // namespace nmc::conformance

// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1, Table 4: each row is a goal mode, and each column a starting mode.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

enum class From { Stopped, Trapezoidal, Velocity, UnprofiledWithStop, Unprofiled };
using enum From;

constexpr std::int32_t kFar = 30'000;
constexpr std::uint16_t kFaster = kCount + 125;  // 625 000 / 500 = 1250 per second
// Loads, named by their parameters.
constexpr Load kPosition{.position = 2'000};
constexpr Load kSpeed{.speed = 30};
constexpr Load kAcceleration{.acceleration = 8};
constexpr Load kProfile{.speed = 30, .acceleration = 8};
constexpr Load kTimer{.count = kFaster, .nearest = 50};
constexpr Load kPositionTimer{.position = 2'000, .count = kFaster, .nearest = 50};
constexpr Load kNothing{};

class PicStepModeTable : public PicStep {
protected:
    /// Brings a fresh chip into a starting mode, with speed 60 and acceleration time 4 loaded before.
    void enter(From from);
    /// Checks that the cell allows each of these loads, and that they lead to `mode`.
    void expectAllowed(From from, const std::string& mode, const std::vector<Load>& loads);
    /// Checks that the cell allows none of these loads, and that the chip continues as before.
    void expectForbidden(From from, const std::vector<Load>& loads);
    /// Checks that Stop Motor ends the motion, abruptly and smoothly.
    void expectStopCommandStops(From from);
    /// Checks that the present motion ends at `goal` by itself.
    void expectEnd(std::int32_t goal) {
        static_cast<void>(secondsToStop());
        EXPECT_EQ(position(), goal);
    }
    std::string mode() { return truth<std::string>("mode"); }
};

INSTANTIATE_TEST_SUITE_P(, PicStepModeTable, kPlaces, nameOf);

void PicStepModeTable::enter(From from) {
    fresh();
    parameters(k1x, 10);
    load({.speed = 60, .acceleration = 4, .start = false});
    if (from == Trapezoidal)
        load({.position = kFar});
    if (from == Velocity)
        load({});
    if (from == UnprofiledWithStop)
        load({.position = kFar, .count = kCount, .nearest = kNearest});
    if (from == Unprofiled)
        load({.count = kCount, .nearest = kNearest});
    rig->wait(milliseconds(100));  // past the ramps
    static const std::vector<std::string> kModes{"stopped", "trapezoidal", "velocity", "unprofiled",
                                                 "unprofiled"};
    ASSERT_EQ(mode(), kModes.at(static_cast<std::size_t>(from)));
}

void PicStepModeTable::expectAllowed(From from, const std::string& mode, const std::vector<Load>& loads) {
    for (const Load& l : loads) {
        enter(from);
        load(l);
        EXPECT_EQ(truth<std::string>("mode"), mode);
        expectNoViolations();
    }
}

void PicStepModeTable::expectForbidden(From from, const std::vector<Load>& loads) {
    for (const Load& l : loads) {
        enter(from);
        const auto before = rig->state();
        load(l);
        expectViolations({"mode_transition"});
        for (const char* key : {"mode", "step_rate", "timer_count", "moving"})
            EXPECT_EQ(rig->state()[key], before[key]) << key;
    }
}

void PicStepModeTable::expectStopCommandStops(From from) {
    for (const unsigned control : {0x05U, 0x09U}) {
        enter(from);
        stop(control);
        static_cast<void>(secondsToStop());
        EXPECT_EQ(mode(), "stopped");
        EXPECT_LT(position(), 1'000) << "long before any goal";
        EXPECT_EQ(status(), 0x0CU);
        expectNoViolations();
    }
}

// ---- Goal: stopped ----

TEST_P(PicStepModeTable, ModeTable1_StoppedFromStoppedIsNoTransition) {
    expectStopCommandStops(Stopped);
    EXPECT_EQ(position(), 0);
}
TEST_P(PicStepModeTable, ModeTable2_StoppedFromTrapezoidalByTheStopCommand) {
    expectStopCommandStops(Trapezoidal);
}
TEST_P(PicStepModeTable, ModeTable3_StoppedFromVelocityProfileByTheStopCommand) {
    expectStopCommandStops(Velocity);
}
TEST_P(PicStepModeTable, ModeTable4_StoppedFromUnprofiledWithStopByTheStopCommand) {
    expectStopCommandStops(UnprofiledWithStop);
}
TEST_P(PicStepModeTable, ModeTable5_StoppedFromUnprofiledNoStopByTheStopCommand) {
    expectStopCommandStops(Unprofiled);
}

// ---- Goal: trapezoidal profile ----

TEST_P(PicStepModeTable, ModeTable6_TrapezoidalFromStoppedNeedsAPositionAndTakesNoTimerCount) {
    expectAllowed(Stopped, "trapezoidal",
                  {kPosition, kPosition + kSpeed, kPosition + kAcceleration, kPosition + kProfile});
    expectEnd(2'000);
    expectForbidden(Stopped, {kPosition + kProfile + kTimer});
}
TEST_P(PicStepModeTable, ModeTable7_TrapezoidalFromTrapezoidalIsNotAllowed) {
    expectForbidden(Trapezoidal, {kPosition, kPosition + kProfile});
    rig->wait(seconds(18));  // 1500 steps per second
    expectEnd(kFar);
}
TEST_P(PicStepModeTable, ModeTable8_TrapezoidalFromVelocityProfileIsNotAllowed) {
    expectForbidden(Velocity, {kPosition, kPosition + kProfile});
}
TEST_P(PicStepModeTable, ModeTable9_TrapezoidalFromUnprofiledWithStopIsNotAllowed) {
    expectForbidden(UnprofiledWithStop, {kPosition, kPosition + kProfile});
}
TEST_P(PicStepModeTable, ModeTable10_TrapezoidalFromUnprofiledNoStopIsNotAllowed) {
    expectForbidden(Unprofiled, {kPosition, kPosition + kProfile});
}

// ---- Goal: velocity profile ----

TEST_P(PicStepModeTable, ModeTable11_VelocityProfileFromStoppedTakesNoPositionAndNoTimerCount) {
    expectAllowed(Stopped, "velocity", {kNothing, kSpeed, kAcceleration, kProfile});
    expectForbidden(Stopped, {kProfile + kTimer});
}
// Without a speed or an acceleration time it would be cell 17.
TEST_P(PicStepModeTable, ModeTable12_VelocityProfileFromTrapezoidalNeedsATimerCountAndTakesNoPosition) {
    expectAllowed(Trapezoidal, "velocity", {kSpeed + kTimer, kAcceleration + kTimer, kProfile + kTimer});
    expectForbidden(Trapezoidal, {kSpeed, kProfile, kNothing, kPosition + kProfile + kTimer});
}
TEST_P(PicStepModeTable, ModeTable13_VelocityProfileFromVelocityProfileTakesNoPositionAndNoTimerCount) {
    expectAllowed(Velocity, "velocity", {kNothing, kSpeed, kAcceleration, kProfile});
    expectForbidden(Velocity, {kProfile + kTimer});
}
TEST_P(PicStepModeTable, ModeTable14_VelocityProfileFromUnprofiledWithStopTakesNoPositionAndNoTimerCount) {
    expectAllowed(UnprofiledWithStop, "velocity", {kNothing, kSpeed, kAcceleration, kProfile});
    expectForbidden(UnprofiledWithStop, {kProfile + kTimer});
}
TEST_P(PicStepModeTable, ModeTable15_VelocityProfileFromUnprofiledNoStopTakesNoPositionAndNoTimerCount) {
    expectAllowed(Unprofiled, "velocity", {kNothing, kSpeed, kAcceleration, kProfile});
    expectForbidden(Unprofiled, {kProfile + kTimer});
}

// ---- Goal: unprofiled velocity with stop ----

TEST_P(PicStepModeTable, ModeTable16_UnprofiledWithStopFromStoppedNeedsPositionAndTimerCount) {
    expectAllowed(Stopped, "unprofiled", {kPositionTimer});
    EXPECT_EQ(truth<double>("step_rate"), 1'250);
    expectEnd(2'000);
    expectForbidden(Stopped, {kPositionTimer + kSpeed, kPositionTimer + kAcceleration});
}
TEST_P(PicStepModeTable, ModeTable17_UnprofiledWithStopFromTrapezoidalNeedsATimerCountOnly) {
    expectAllowed(Trapezoidal, "unprofiled", {kTimer});
    EXPECT_EQ(truth<double>("step_rate"), 1'250);
    rig->wait(seconds(20));
    expectEnd(kFar);
    expectForbidden(Trapezoidal, {kPositionTimer});
}
TEST_P(PicStepModeTable, ModeTable18_UnprofiledWithStopFromVelocityProfileIsNotAllowed) {
    expectForbidden(Velocity, {kPositionTimer});
}
TEST_P(PicStepModeTable, ModeTable19_UnprofiledWithStopFromUnprofiledWithStopNeedsATimerCountOnly) {
    expectAllowed(UnprofiledWithStop, "unprofiled", {kTimer});
    EXPECT_EQ(truth<double>("step_rate"), 1'250);
    rig->wait(seconds(20));
    expectEnd(kFar);
    expectForbidden(UnprofiledWithStop, {kPositionTimer, kTimer + kSpeed, kTimer + kAcceleration});
}
TEST_P(PicStepModeTable, ModeTable20_UnprofiledWithStopFromUnprofiledNoStopIsNotAllowed) {
    expectForbidden(Unprofiled, {kPositionTimer});
}

// ---- Goal: unprofiled velocity, no stop ----

TEST_P(PicStepModeTable, ModeTable21_UnprofiledNoStopFromStoppedNeedsATimerCountOnly) {
    expectAllowed(Stopped, "unprofiled", {kTimer});
    EXPECT_NEAR(stepsIn(kEightSeconds * 10), 100'000, 1) << "past any goal";
    expectForbidden(Stopped, {kTimer + kSpeed, kTimer + kAcceleration});
}
// A timer count alone keeps the stop (cell 17), so no load leads there.
TEST_P(PicStepModeTable, ModeTable22_UnprofiledNoStopFromTrapezoidalIsNotAllowed) {
    enter(Trapezoidal);
    load(kTimer);
    rig->wait(seconds(60));
    EXPECT_EQ(position(), kFar) << "the stop has remained in force";
}
TEST_P(PicStepModeTable, ModeTable23_UnprofiledNoStopFromVelocityProfileNeedsATimerCountOnly) {
    expectAllowed(Velocity, "unprofiled", {kTimer});
    EXPECT_NEAR(stepsIn(kEightSeconds * 10), 100'000, 1);
    expectForbidden(Velocity, {kTimer + kSpeed, kTimer + kAcceleration});
}
// A timer count alone keeps the stop (cell 19), so no load leads there.
TEST_P(PicStepModeTable, ModeTable24_UnprofiledNoStopFromUnprofiledWithStopIsNotAllowed) {
    enter(UnprofiledWithStop);
    load(kTimer);
    rig->wait(seconds(60));
    EXPECT_EQ(position(), kFar);
}
TEST_P(PicStepModeTable, ModeTable25_UnprofiledNoStopFromUnprofiledNoStopNeedsATimerCountOnly) {
    expectAllowed(Unprofiled, "unprofiled", {kTimer});
    EXPECT_EQ(truth<double>("step_rate"), 1'250);
    EXPECT_NEAR(stepsIn(kEightSeconds * 10), 100'000, 1);
    expectForbidden(Unprofiled, {kTimer + kSpeed, kTimer + kAcceleration});
}

}  // namespace
}  // namespace nmc::conformance

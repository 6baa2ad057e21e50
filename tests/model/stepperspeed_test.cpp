// SPDX-License-Identifier: GPL-3.0-or-later
// Expected values are from the tables of DS-S 4.1 and 4.2, or calculated by hand.
#include "module/stepperspeed.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using stepper::SpeedMode;

TEST(StepperSpeed, HasTheResolutionAndTheMaximumOfTable3) {
    const struct {
        SpeedMode mode;
        double unit;
        double fastest;
    } rows[] = {{SpeedMode::X1, 25, 6'250},
                {SpeedMode::X2, 50, 12'500},
                {SpeedMode::X4, 100, 25'000},
                {SpeedMode::X8, 200, 50'000}};
    for (const auto& row : rows) {
        EXPECT_EQ(StepperSpeed(row.mode).unit(), row.unit);
        EXPECT_EQ(StepperSpeed(row.mode).slowest(), row.unit);
        EXPECT_EQ(StepperSpeed(row.mode).fastest(), row.fastest);
    }
}

// 65 536 - 625 000 / 500 + 2 = 64 288; 65 536 - 1 250 000 / 500 + 4 = 63 040;
// 65 536 - 2 500 000 / 500 + 8 = 60 544; 65 536 - 5 000 000 / 500 + 16 = 55 552.
TEST(StepperSpeed, ComputesTimerCountsByTheFormulasOfTheDataSheet) {
    EXPECT_EQ(StepperSpeed(SpeedMode::X1).timerFor(500).count, 64'288);
    EXPECT_EQ(StepperSpeed(SpeedMode::X2).timerFor(500).count, 63'040);
    EXPECT_EQ(StepperSpeed(SpeedMode::X4).timerFor(500).count, 60'544);
    EXPECT_EQ(StepperSpeed(SpeedMode::X8).timerFor(500).count, 55'552);
    EXPECT_DOUBLE_EQ(StepperSpeed(SpeedMode::X4).ofCount(60'544), 500);
}

// 500 / 25 = 20, 500 / 200 = 2.5: halves round up; 9.5 steps/s are below speed 1.
TEST(StepperSpeed, GivesATimerCountItsNearestIntegerSpeed) {
    EXPECT_EQ(StepperSpeed(SpeedMode::X1).timerFor(500).nearestSpeed, 20);
    EXPECT_EQ(StepperSpeed(SpeedMode::X8).timerFor(500).nearestSpeed, 3);
    EXPECT_EQ(StepperSpeed(SpeedMode::X1).timerFor(9.6).nearestSpeed, 1);
    EXPECT_EQ(StepperSpeed(SpeedMode::X1).timerFor(7'000).nearestSpeed, 250);
}

// Count 1: 625 000 / 65 537; count 65 452: 625 000 / 86, 5 000 000 / 100.
TEST(StepperSpeed, KeepsTimerCountsWithinTheirLimits) {
    const StepperSpeed slow(SpeedMode::X1);
    EXPECT_DOUBLE_EQ(slow.slowestTimed(), 625'000.0 / 65'537);
    EXPECT_DOUBLE_EQ(slow.fastestTimed(), 625'000.0 / 86);
    EXPECT_DOUBLE_EQ(StepperSpeed(SpeedMode::X8).fastestTimed(), 50'000);
    EXPECT_EQ(slow.timerFor(1).count, 1);
    EXPECT_EQ(slow.timerFor(0).count, 1);
    EXPECT_EQ(slow.timerFor(1e6).count, 65'452);
}

// At 1x count 65 442 is 625 000 / 96 = 6 510.42 steps/s and 65 443 is 625 000 / 95 = 6 578.95; the middle is
// 6 544.68.
TEST(StepperSpeed, TakesTheCountWhoseSpeedIsNearest) {
    const StepperSpeed mode(SpeedMode::X1);
    EXPECT_EQ(mode.timerFor(6'544).count, 65'442);
    EXPECT_EQ(mode.timerFor(6'545).count, 65'443);
}

TEST(StepperSpeed, TakesTheNearestIntegerSpeed) {
    const StepperSpeed mode(SpeedMode::X4);
    EXPECT_EQ(mode.speedFor(1'149), 11);
    EXPECT_EQ(mode.speedFor(1'151), 12);
    EXPECT_EQ(mode.speedFor(10), 1);
    EXPECT_EQ(mode.speedFor(1e9), 250);
    EXPECT_EQ(mode.ofSpeed(12), 1'200);
}

// One unit of 25 steps/s every 4 x 0.25 ms is 25 000 steps/s^2; one of 200 steps/s every 0.25 ms is 800 000;
// one of 25 steps/s every 63.75 ms is 392.16.
TEST(StepperSpeed, TurnsAccelerationTimesIntoAccelerations) {
    EXPECT_DOUBLE_EQ(StepperSpeed(SpeedMode::X1).acceleration(4), 25'000);
    EXPECT_DOUBLE_EQ(StepperSpeed(SpeedMode::X8).acceleration(1), 800'000);
    EXPECT_NEAR(StepperSpeed(SpeedMode::X1).acceleration(255), 392.157, 1e-3);
}

// From speed 25 to 125 at 1 ms each takes 100 ms (the data sheet's own example) and, at 1x, 0.001 x 25 x (25
// + ... + 124) = 0.025 x 7 450 = 186.25 steps; both ramps take 372.5. The remaining 2 752.5 at 3 125 steps/s
// take 0.8808 s.
TEST(StepperForecast, AddsRampsAndSlew) {
    const StepperForecast move = forecastMove(StepperSpeed(SpeedMode::X1), 25, 125, 4, 3'125);
    EXPECT_NEAR(move.seconds, 0.2 + 0.8808, 1e-9);
    EXPECT_EQ(move.peak, 3'125);
    EXPECT_FALSE(move.triangular);
}

// From speed 1 at 1 ms each and 1x, both ramps together take 0.05 steps up to speed 2, 0.15 up to 3, 0.3 up
// to 4, 0.5 up to 5 ... and 0.025 v (v - 1) up to v. In 10 steps, 0.025 x 20 x 19 = 9.5 fits, and 0.025 x 21
// x 20 = 10.5 does not. That takes 2 x 19 ms, plus half a step at 500 steps/s.
TEST(StepperForecast, RecognisesAMoveThatIsTooShortForItsSpeed) {
    const StepperForecast move = forecastMove(StepperSpeed(SpeedMode::X1), 1, 100, 4, -10);
    EXPECT_TRUE(move.triangular);
    EXPECT_EQ(move.peak, 500);
    EXPECT_NEAR(move.seconds, 0.038 + 0.001, 1e-9);
}

TEST(StepperForecast, NeverGoesBelowTheMinimumProfileSpeed) {
    const StepperForecast move = forecastMove(StepperSpeed(SpeedMode::X2), 10, 4, 100, 1'000);
    EXPECT_EQ(move.peak, 500);
    EXPECT_FALSE(move.triangular);
    EXPECT_DOUBLE_EQ(move.seconds, 2.0);
}

TEST(StepperForecast, OfNoDistanceIsNothing) {
    const StepperForecast move = forecastMove(StepperSpeed(SpeedMode::X1), 1, 100, 4, 0);
    EXPECT_EQ(move.seconds, 0);
    EXPECT_EQ(move.peak, 0);
}

}  // namespace
}  // namespace nmc

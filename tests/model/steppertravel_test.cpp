// SPDX-License-Identifier: GPL-3.0-or-later
// How far and how fast a PIC-STEP's axis may go (model/intent/travel.h). Expected values are calculated by
// hand.
#include <gtest/gtest.h>

#include "model/intent/homingplan.h"
#include "model/intent/jog.h"
#include "model/intent/pace.h"
#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "model/module/stepperdefaults.h"
#include "tests/model/stepperfixture.h"

namespace nmc {
namespace {

using namespace testing_support;

Stepper limitedStepper(std::int32_t position = 0) {
    Stepper stepper = Stepper::holding();
    stepper.position = position;
    stepper.says(kAmplifier | kStepPower);
    stepper.module.home.found(0, stepper.time);
    stepper.module.travel.lowest = -1'000;
    stepper.module.travel.highest = 2'000;
    return stepper;
}

TEST(StepperTravel, ARunOfAStepperIsAMoveToTheLimit) {
    const Stepper stepper = limitedStepper();
    EXPECT_EQ(withinTravel(steppermotion::VelocityProfile{40, 4, false}, stepper.module),
              StepperMotion(steppermotion::Trapezoid{2'000, false, 40, 4}));
    EXPECT_EQ(withinTravel(steppermotion::UnprofiledRun{{60'000, 8}, true}, stepper.module),
              StepperMotion(steppermotion::UnprofiledMove{-1'000, false, {60'000, 8}}));
    const auto timed = plan(intent::Move{steppermotion::UnprofiledRun{{60'000, 8}, true}}, stepper.module);
    ASSERT_TRUE(timed.has_value());
    const auto& bounded = std::get<stepper::LoadTrajectory>(std::get<StepperCommand>(timed->front().command));
    EXPECT_EQ(bounded.position, Counts(-1'000));
    EXPECT_TRUE(bounded.reverse) << "DS-S 4.1: the direction is specified with a bit";
    const auto steps = plan(intent::Move{steppermotion::VelocityProfile{40, 4, true}}, stepper.module);
    ASSERT_TRUE(steps.has_value());
    const auto& load = std::get<stepper::LoadTrajectory>(std::get<StepperCommand>(steps->front().command));
    EXPECT_EQ(load.position, Counts(-1'000));
    EXPECT_EQ(load.speed, 40);
}

/// Minimum profile speed 4 at 25 steps/s each; 149 steps/s are speed 5, not 6.
TEST(StepperTravel, AJogIsRefusedAtTheEndAndIsNeverFasterThanRequested) {
    const AxisSettings axis;
    const Stepper end = limitedStepper(2'000);
    EXPECT_EQ(jogRange(end.module, axis), (JogRange{100, 1'000, 100}));
    const auto forward = jog(end.module, axis, 149, false);
    ASSERT_TRUE(forward);
    EXPECT_EQ(forward->pace, (bus::StepperPace{5, 40}));
    EXPECT_EQ(whyNot(*forward, end.module), Refusal::AtTravelEnd);
    EXPECT_FALSE(whyNot(*jog(end.module, axis, 149, true), end.module));
    Stepper unknown;
    unknown.says(kStepPower);
    EXPECT_FALSE(jog(unknown.module, axis, 149, true)) << "speed 5 of what?";
}

TEST(StepperTravel, StepsBeyondAreRefusedAlsoRelativeOnes) {
    const Stepper stepper = limitedStepper(1'500);
    EXPECT_EQ(whyNot(steppermotion::Trapezoid{2'001, false, 40, 4}, stepper.module), Refusal::BeyondTravel);
    EXPECT_EQ(whyNot(steppermotion::Trapezoid{501, true, 40, 4}, stepper.module), Refusal::BeyondTravel);
    EXPECT_FALSE(whyNot(steppermotion::Trapezoid{500, true, 40, 4}, stepper.module));
    EXPECT_EQ(travelProblem(intent::Move{steppermotion::Trapezoid{501, true, 40, 4}}, stepper.module)->limit,
              2'000);
    const Stepper atEnd = limitedStepper(2'000);
    EXPECT_EQ(whyNot(steppermotion::VelocityProfile{40, 4, false}, atEnd.module), Refusal::AtTravelEnd);
    EXPECT_FALSE(whyNot(steppermotion::VelocityProfile{40, 4, true}, atEnd.module));
}

/// DS-S 5.1: below the minimum profile speed, 4, the minimum is used. In mode 1x that is 100 steps/s, in 8x
/// 800.
TEST(StepperTravel, ASearchForHomeIsNotFasterThanRequested) {
    Stepper stepper = limitedStepper();
    HomingRecipe recipe = firstRecipe(stepper.module.info.identity);
    recipe.onHomeSwitch = true;
    recipe.velocity = 99.0;
    EXPECT_EQ(whyNotHome(recipe, stepper.module), Refusal::TooSlow);
    recipe.velocity = 100.0;
    EXPECT_EQ(whyNotHome(recipe, stepper.module), std::nullopt);
    stepper.module.stepper.parameters->speedMode = stepper::SpeedMode::X8;
    recipe.velocity = 799.0;
    EXPECT_EQ(whyNotHome(recipe, stepper.module), Refusal::TooSlow);
    recipe.velocity = 800.0;
    EXPECT_EQ(whyNotHome(recipe, stepper.module), std::nullopt);
}

/// DS-S 5.1, Table 4: a speed that is not loaded is the one loaded before. Speed 40 is 1000 steps/s, and a
/// smooth stop sets it to 0.
TEST(StepperTravel, ALoadWithoutASpeedIsAsFastAsTheOneBefore) {
    Stepper stepper = limitedStepper();
    stepper::LoadTrajectory load;
    load.position = Counts(200);
    const Intent start = intent::Direct{StepperCommand(StartMotion{})};
    stepper.was(load);
    EXPECT_EQ(plan(start, stepper.module).error(), Refusal::NoVelocity) << "none was ever loaded";
    stepper.was(Stepper::trapezoid(100));
    stepper.was(load);
    EXPECT_TRUE(plan(start, stepper.module).has_value());
    stepper.module.travel.fastest = 999;
    EXPECT_EQ(plan(start, stepper.module).error(), Refusal::TooFast);
    stepper.wasStopped(stepper::StopManner::Smoothly);
    stepper.was(load);
    EXPECT_EQ(plan(start, stepper.module).error(), Refusal::NoVelocity);
}

/// DS-S 5.1, Table 4: from a trapezoid, a ramp begins at a timer count and ends at a speed, 200 x 25 steps/s.
TEST(StepperTravel, ARampFromATimerCountIsAsFastAsItsEnd) {
    Stepper stepper = limitedStepper();
    stepper.module.home.forget();
    stepper::LoadTrajectory move = Stepper::trapezoid(1'000);
    move.startNow = true;
    stepper.was(move);
    stepper.says(kStepOn | kMoving | kTrapezoidalMode);
    stepper::LoadTrajectory ramp;
    ramp.timer = stepper::TimerCount{60'000, 4};
    ramp.speed = std::uint8_t{200};
    ramp.accelerationTime = std::uint8_t{4};
    ramp.startNow = true;
    const Intent start = intent::Direct{StepperCommand(ramp)};
    stepper.module.travel.fastest = 5'000;
    EXPECT_TRUE(plan(start, stepper.module).has_value());
    stepper.module.travel.fastest = 4'999;
    EXPECT_EQ(plan(start, stepper.module).error(), Refusal::TooFast);
}

/// It would turn round at -1 030, but only a move that is started with its load does so.
TEST(StepperTravel, ALoadedMoveIsNotRefusedForATurnThatItDoesNotMake) {
    Stepper stepper = limitedStepper();
    stepper.module.backlash.distance = 50;
    const steppermotion::Trapezoid move{-980, false, 40, 4};
    EXPECT_EQ(plan(intent::Move{move}, stepper.module).error(), Refusal::BeyondTravel);
    EXPECT_TRUE(plan(intent::LoadMove{move}, stepper.module).has_value());
    EXPECT_EQ(plan(intent::LoadMove{steppermotion::Trapezoid{-1'001, false, 40, 4}}, stepper.module).error(),
              Refusal::BeyondTravel);
}

// The speed unit is 25 steps/s, so speed 4 is 100 steps/s, and no profile is slower here (minimum 4).
TEST(StepperTravel, AStepperGoesNoFasterEither) {
    Stepper stepper = limitedStepper();
    stepper.module.travel.fastest = 100;
    EXPECT_FALSE(whyNot(steppermotion::Trapezoid{100, false, 4, 4}, stepper.module));
    EXPECT_FALSE(whyNot(steppermotion::Trapezoid{100, false, 1, 4}, stepper.module));
    EXPECT_EQ(whyNot(steppermotion::Trapezoid{100, false, 5, 4}, stepper.module), Refusal::TooFast);
    EXPECT_EQ(
        travelProblem(intent::Move{steppermotion::Trapezoid{100, false, 5, 4}}, stepper.module)->velocity,
        125);
    stepper.module.travel.fastest = 99;
    EXPECT_EQ(whyNot(steppermotion::Trapezoid{100, false, 1, 4}, stepper.module), Refusal::TooFast)
        << "the minimum profile speed";
    bus::HoldToMove hold;
    hold.pace = bus::StepperPace{1, 4};
    EXPECT_EQ(withinTravel(hold, stepper.module).error().refusal, Refusal::TooFast);
}

/// An axis without a velocity of its own goes at 400 steps/s. Of 115 steps/s, the nearest speed is 5, which
/// is 125 steps/s, and the one below is 4.
TEST(StepperTravel, APaceIsNoFasterThanTheAxisMayMove) {
    Stepper stepper = limitedStepper();
    AxisSettings axis;
    const auto speed = [&](double share = 1.0) {
        return std::get<bus::StepperPace>(paceOf(stepper.module, axis, share)).speed;
    };
    const auto goes = [&] {
        return plan(intent::Move{moveTo(500, paceOf(stepper.module, axis))}, stepper.module).has_value();
    };
    EXPECT_EQ(speed(), 16);
    EXPECT_EQ(speed(0.5), 8);
    axis.travel.fastest = stepper.module.travel.fastest = 200;
    EXPECT_EQ(speed(), 8);
    EXPECT_TRUE(goes());
    axis.travel.fastest = stepper.module.travel.fastest = 115;
    EXPECT_EQ(speed(), 4);
    axis.motion.velocity = 115;
    EXPECT_EQ(speed(), 4);
    EXPECT_TRUE(goes());
    axis.motion.velocity = 200;
    EXPECT_FALSE(goes()) << "that is set, and too fast";
    axis.motion.velocity = 115;
    axis.travel.fastest = stepper.module.travel.fastest = 0;
    EXPECT_EQ(speed(), 5) << "no limit is set";
}

// At 1x, count 64 913 is 625 000 / 625 = 1 000 steps/s, and 64 912 is 625 000 / 626 = 998.4.
TEST(StepperTravel, ATimerCountIsNoFasterThanTheAxisMayMove) {
    const Stepper stepper = limitedStepper();
    AxisSettings axis;
    EXPECT_EQ(stepperdefaults::timerFor(999.5, stepper.module.stepper, axis).count, 64'913);
    axis.travel.fastest = 999.5;
    EXPECT_EQ(stepperdefaults::timerFor(999.5, stepper.module.stepper, axis).count, 64'912);
}

}  // namespace
}  // namespace nmc

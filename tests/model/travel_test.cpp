// SPDX-License-Identifier: GPL-3.0-or-later
// How far and how fast an axis may go (model/intent/travel.h). Expected values are calculated by hand.
#include "model/intent/travel.h"

#include <gtest/gtest.h>

#include "model/intent/backlash.h"
#include "model/intent/homingplan.h"
#include "model/intent/jog.h"
#include "model/intent/rights.h"
#include "tests/model/servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr CountsPerTick kOne{1 << 16};
constexpr CountsPerTickSquared kGentle{131};

intent::Move to(std::int32_t position, CountsPerTick velocity = kOne) {
    return {servomotion::Trapezoid{Counts(position), velocity, kGentle}};
}

/// A servo at `position`, with home at 1000 and travel limits at -200 and 500 from there: 800 to 1500.
ModuleState limited(std::int32_t position = 1'000) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(0.3, kMoveDone | kPower, kServoOn, position));
    module.apply(executedAt(0.3, servo::StopMotor{true, servo::StopManner::Here, Counts(position)}));
    module.home.found(1'000, atSeconds(0.3));
    module.travel.lowest = -200;
    module.travel.highest = 500;
    return module;
}

TEST(Travel, CountsFromHomeAndIsInForceWhileHomeIsKnown) {
    ModuleState module = limited();
    EXPECT_EQ(travelForce(module), TravelForce::InForce);
    EXPECT_EQ(travelRange(module), (TravelRange{800, 1'500}));
    module.home.forget();
    EXPECT_EQ(travelForce(module), TravelForce::HomeUnknown);
    EXPECT_FALSE(travelRange(module));
    EXPECT_TRUE(plan(to(1'000'000), module).has_value()) << "the limits are not in force";
    module.home.declare(module.latestTime);
    EXPECT_EQ(module.home.place()->source, HomeFact::Source::Declared);
    EXPECT_EQ(travelRange(module), (TravelRange{-200, 500})) << "home is where the counter is 0";
    module.travel = {};
    EXPECT_EQ(travelForce(module), TravelForce::NotSet);
}

/// On a chain that another program left, 10 mm/s would be sent as if SR were 1.
TEST(Travel, NothingRunsByUnitsPerSecondWhileTheServoRateIsUnknown) {
    const Intent run = intent::Move{servomotion::VelocityProfile{kOne, kGentle, false}};
    ModuleState module = holdingServo();
    module.servoRate.reset();
    EXPECT_TRUE(plan(run, module).has_value()) << "the chip itself takes counts per tick";
    module.unit = UnitKind::Millimetres;
    for (const Intent& intent : {run, Intent(to(100)), Intent(intent::LoadMove{to(100).motion})}) {
        const auto orders = plan(intent, module);
        ASSERT_FALSE(orders.has_value());
        EXPECT_EQ(orders.error(), Refusal::ServoRateUnknown);
    }
    EXPECT_EQ(whyNotHome(module), Refusal::ServoRateUnknown);
    EXPECT_EQ(whyNot(IntentKind::Hold, module), Refusal::ServoRateUnknown);
    EXPECT_FALSE(whyNot(IntentKind::StopMotion, module));
    module.servoRate = 5;
    EXPECT_TRUE(plan(run, module).has_value());
}

TEST(Travel, IsNotInForceAfterARestart) {
    ModuleState module = limited();
    module.restarted();
    EXPECT_EQ(travelForce(module), TravelForce::HomeUnknown);
}

TEST(Travel, WhatTheCounterDoesNotReachIsAsFarAsItDoes) {
    ModuleState module = limited();
    module.home.found(0x7FFFFF00, atSeconds(1));
    EXPECT_EQ(travelRange(module), (TravelRange{0x7FFFFF00 - 200, 0x7FFFFFFF}));
}

TEST(Travel, FromOutsideTheWayBackIsAllowedAndNoOther) {
    const TravelRange range{800, 1'500};
    EXPECT_FALSE(beyondTravel(1'000, 800, range));
    EXPECT_FALSE(beyondTravel(1'000, 1'500, range));
    EXPECT_EQ(beyondTravel(1'000, 1'501, range)->limit, 1'500);
    EXPECT_FALSE(beyondTravel(1'000, 1'501, range)->lowest);
    EXPECT_EQ(beyondTravel(1'000, 799, range)->limit, 800);
    EXPECT_TRUE(beyondTravel(1'000, 799, range)->lowest);
    // From above, it may move down to anywhere within the limits or a part of the way, but not farther up,
    // and not beyond the other end.
    EXPECT_FALSE(beyondTravel(1'700, 1'600, range));
    EXPECT_FALSE(beyondTravel(1'700, 900, range));
    EXPECT_EQ(beyondTravel(1'700, 1'701, range)->limit, 1'500);
    EXPECT_EQ(beyondTravel(1'700, 700, range)->limit, 800);
    EXPECT_FALSE(beyondTravel(600, 700, range));
    EXPECT_TRUE(beyondTravel(600, 500, range)->lowest);
    // With a limit on one side only.
    EXPECT_FALSE(beyondTravel(0, -1'000'000, {std::nullopt, 1'500}));
    EXPECT_FALSE(beyondTravel(0, 1'000'000, {800, std::nullopt}));
}

TEST(Travel, MovesBeyondAreRefusedBeforeTheyAreSent) {
    ModuleState module = limited();
    EXPECT_TRUE(plan(to(1'500), module).has_value());
    EXPECT_EQ(plan(to(1'501), module).error(), Refusal::BeyondTravel);
    EXPECT_EQ(plan(intent::LoadMove{to(799).motion}, module).error(), Refusal::BeyondTravel);
    // 3 x 200 from 1000 is 1600; moves there and back reach 1200 at most.
    intent::MoveBy steps{{200, 3}, ServoPace{kOne, kGentle}};
    EXPECT_EQ(plan(steps, module).error(), Refusal::BeyondTravel);
    steps.moves.backAndForth = true;
    EXPECT_TRUE(plan(steps, module).has_value());
    module.apply(
        bus::CommandExecuted{module.info.index, module.latestTime,
                             ServoCommand(servo::StopMotor{true, servo::StopManner::Here, Counts(1'000)})});
    EXPECT_EQ(plan(intent::StepResponse{501, ResponseMethod::Profile, 0.1}, module).error(),
              Refusal::BeyondTravel);
    EXPECT_TRUE(plan(intent::StepResponse{500, ResponseMethod::Profile, 0.1}, module).has_value());
}

TEST(Travel, GoHomeIsRefusedWhereHomeIsOutside) {
    ModuleState module = limited(1'100);
    EXPECT_TRUE(plan(intent::GoHome{ServoPace{kOne, kGentle}}, module).has_value());
    module.travel.lowest = 50;
    EXPECT_EQ(plan(intent::GoHome{ServoPace{kOne, kGentle}}, module).error(), Refusal::BeyondTravel);
}

TEST(Travel, WhatWasLoadedIsJudgedAgainAtItsStart) {
    ModuleState module = limited();
    module.apply(executedAt(1, trapezoid(1'400, 1 << 16, 131)));
    EXPECT_FALSE(whyNot(IntentKind::StartLoaded, module));
    module.travel.highest = 300;
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, module), Refusal::BeyondTravel);
    module.travel.highest = 500;
    module.travel.fastest = 0.5;
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, module), Refusal::TooFast);
}

TEST(Travel, ARunTowardsALimitIsAMoveThere) {
    const ModuleState module = limited();
    const auto steps = plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, true}}, module);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 2U);
    EXPECT_EQ(std::get<servo::LoadTrajectory>(std::get<ServoCommand>(steps->at(0).command)),
              trapezoid(800, 1 << 16, 131));
    EXPECT_TRUE(std::holds_alternative<StartMotion>(std::get<ServoCommand>(steps->at(1).command)));
    const auto loaded = plan(intent::LoadMove{servomotion::VelocityProfile{kOne, kGentle, true}}, module);
    ASSERT_TRUE(loaded.has_value());
    EXPECT_EQ(payloadOf(loaded->front().command), payloadOf(steps->front().command))
        << "also if it waits for its start";
    ModuleState open = module;
    open.travel.lowest.reset();
    const auto run = plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, true}}, open);
    EXPECT_EQ(std::get<servo::LoadTrajectory>(std::get<ServoCommand>(run->at(0).command)).profile,
              servo::ProfileMode::Velocity)
        << "no limit is ahead";
}

TEST(Travel, AtTheEndThereIsNoWayOn) {
    // A servo at rest swings by up to four counts.
    for (const std::int32_t position : {1'496, 1'500, 1'504, 1'600}) {
        const ModuleState module = limited(position);
        EXPECT_EQ(plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, false}}, module).error(),
                  Refusal::AtTravelEnd);
        EXPECT_TRUE(
            plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, true}}, module).has_value());
    }
    EXPECT_TRUE(
        plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, false}}, limited(1'495)).has_value());
    EXPECT_EQ(travelPlace(limited(1'504)), TravelPlace::AtHighest);
    EXPECT_EQ(travelPlace(limited(1'505)), TravelPlace::AboveHighest);
    EXPECT_EQ(travelPlace(limited(800)), TravelPlace::AtLowest);
    EXPECT_EQ(travelPlace(limited(700)), TravelPlace::BelowLowest);
    EXPECT_EQ(travelPlace(limited(1'000)), TravelPlace::Within);
}

TEST(Travel, ARunThatIsUnderWayHasToStopFirst) {
    ModuleState module = limited();
    module.travel.lowest.reset();
    module.apply(executedAt(1, velocityMode(1 << 16, 131, true)));
    module.apply(sampleOf(1.1, kMoveDone | kPower, kServoOn | kAccelDone, 990));
    ASSERT_TRUE(module.moving());
    EXPECT_EQ(plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, false}}, module).error(),
              Refusal::RunNeedsStop);
    EXPECT_TRUE(plan(intent::Move{servomotion::VelocityProfile{kOne, kGentle, true}}, module).has_value());
}

/// CMC and SC can be given at most 1280 counts per tick (docs/family.md).
TEST(Travel, NothingIsFasterThanTheChipCanBeGiven) {
    const CountsPerTick most(1'280U << 16U);
    const CountsPerTick more((1'280U << 16U) + 1);
    for (const std::uint8_t version : {kPathVersion, kScVersion}) {
        ModuleState module = limited();
        module.info.identity.version = version;
        EXPECT_TRUE(plan(to(1'400, most), module).has_value());
        EXPECT_EQ(plan(to(1'400, more), module).error(), Refusal::TooFast);
        EXPECT_TRUE(travelProblem(to(1'400, more), module)->ofChip);
        module.travel.fastest = 2'000;
        EXPECT_EQ(travelProblem(to(1'400, more), module)->fastest, 1'280.0);
        module.travel.fastest = 1'000;
        EXPECT_EQ(travelProblem(to(1'400, more), module)->fastest, 1'000.0);
        EXPECT_FALSE(travelProblem(to(1'400, more), module)->ofChip);
    }
    EXPECT_TRUE(plan(to(1'400, more), limited()).has_value()) << "version 4";
}

TEST(Travel, NothingIsFasterThanTheAxisMayGo) {
    ModuleState module = limited();
    module.travel.fastest = 1.0;
    EXPECT_TRUE(plan(to(1'400), module).has_value());
    const CountsPerTick fast((1 << 16) + 2);
    EXPECT_EQ(plan(to(1'400, fast), module).error(), Refusal::TooFast);
    EXPECT_EQ(travelProblem(to(1'400, fast), module)->fastest, 1.0);
    EXPECT_EQ(plan(intent::Move{servomotion::VelocityProfile{fast, kGentle, true}}, module).error(),
              Refusal::TooFast);
    EXPECT_EQ(plan(intent::MoveBy{{10}, ServoPace{fast, kGentle}}, module).error(), Refusal::TooFast);
    HomingRecipe recipe = firstRecipe(module.info.identity);
    EXPECT_FALSE(whyNotHome(recipe, module));
    recipe.velocity = 1.01;
    EXPECT_EQ(whyNotHome(recipe, module), Refusal::TooFast);
    bus::HoldToMove hold;
    hold.velocity = fast;
    EXPECT_EQ(withinTravel(hold, module).error().refusal, Refusal::TooFast);
    module.home.forget();
    EXPECT_EQ(plan(to(1'400, fast), module).error(), Refusal::TooFast)
        << "the maximum speed does not depend on home";
}

/// DS-V 5.2: a velocity that is not loaded is the one loaded before, which nobody has started yet.
TEST(Travel, ALoadWithoutAVelocityIsAsFastAsTheOneBefore) {
    ModuleState module = limited();
    module.home.forget();
    servo::LoadTrajectory load = velocityMode(3 << 16, 131);
    load.startNow = false;
    module.apply(executedAt(1, load));
    load.velocity.reset();
    load.startNow = true;
    const Intent start = intent::Direct{ServoCommand(load)};
    EXPECT_TRUE(plan(start, module).has_value());
    module.travel.fastest = 2.9;
    EXPECT_EQ(plan(start, module).error(), Refusal::TooFast);
    EXPECT_EQ(travelProblem(start, module)->velocity, 3.0);
}

/// Nor is it known whether it is too fast.
TEST(Travel, NothingStartsAtAVelocityThatAnotherHostHasLoaded) {
    ModuleState module = holdingServo();
    module.attached();
    servo::LoadTrajectory load = velocityMode(0, 131);
    load.velocity.reset();
    EXPECT_EQ(plan(intent::Direct{ServoCommand(load)}, module).error(), Refusal::NoVelocity);
    load.startNow = false;
    module.apply(executedAt(1, load));
    EXPECT_EQ(plan(intent::StartLoaded{}, module).error(), Refusal::NoVelocity);
    load.velocity = kOne;
    module.apply(executedAt(2, load));
    EXPECT_TRUE(plan(intent::StartLoaded{}, module).has_value());
}

TEST(Travel, HeldMotionHasTheLimitAheadAsItsGoal) {
    const ModuleState module = limited();
    bus::HoldToMove hold;
    hold.velocity = kOne;
    EXPECT_EQ(withinTravel(hold, module)->goal, 1'500);
    hold.reverse = true;
    EXPECT_EQ(withinTravel(hold, module)->goal, 800);
    ModuleState open = module;
    open.home.forget();
    EXPECT_FALSE(withinTravel(hold, open)->goal);
    EXPECT_EQ(withinTravel(hold, limited(802)).error().refusal, Refusal::AtTravelEnd);
}

TEST(Travel, AJogIsRefusedAtTheEndAndHasNoOtherSpeedThanThatOfItsAxis) {
    AxisSettings axis;
    const ModuleState end = limited(1'500);
    const auto forward = jog(end, axis, 0.25, false);
    ASSERT_TRUE(forward);
    EXPECT_EQ(forward->velocity.value(), 16'384U) << "a quarter of 65 536";
    EXPECT_EQ(forward->acceleration.value(), 131U) << "0.002 of 65 536, until it is set";
    EXPECT_EQ(whyNot(*forward, end), Refusal::AtTravelEnd);
    EXPECT_FALSE(whyNot(*jog(end, axis, 0.25, true), end));
    EXPECT_EQ(jogRange(end, axis), (JogRange{1.0 / 65'536, 2.0, 0.25}));
    axis.travel.fastest = 0.125;
    EXPECT_EQ(jogRange(end, axis), (JogRange{1.0 / 65'536, 0.125, 0.125}));
}

TEST(Travel, PwmAndPushesAreRefusedAtTheEnd) {
    ModuleState module = limited(1'500);
    module.apply(executedAt(1, stopWith(servo::StopManner::MotorOff, false)));
    module.apply(sampleOf(1.1, kMoveDone | kPower | kPosError, 0, 1'500));
    EXPECT_EQ(plan(intent::DrivePwm{20, false}, module).error(), Refusal::AtTravelEnd);
    EXPECT_TRUE(plan(intent::DrivePwm{20, true}, module).has_value());
    EXPECT_TRUE(plan(intent::DrivePwm{0, false}, module).has_value());
    servo::LoadTrajectory loaded;
    loaded.servo = false;
    loaded.pwm = std::uint8_t{20};
    module.apply(executedAt(2, loaded));
    EXPECT_EQ(plan(intent::StartLoaded{}, module).error(), Refusal::AtTravelEnd);
    loaded.reverse = true;
    module.apply(executedAt(3, loaded));
    EXPECT_TRUE(plan(intent::StartLoaded{}, module).has_value());
    EXPECT_EQ(plan(intent::CheckDirection{250}, module).error(), Refusal::BeyondTravel);
    module.travel.highest = 800;
    EXPECT_TRUE(plan(intent::CheckDirection{250}, module).has_value());
}

// ---- backlash ----

TEST(Backlash, AMoveFromTheWrongSideTurnsRoundBeyondItsGoal) {
    ModuleState module = holdingServo();
    EXPECT_FALSE(turningPoint(1'000, 0, module)) << "not set";
    module.backlash.distance = 50;
    EXPECT_EQ(turningPoint(1'000, 0, module), -50);
    EXPECT_FALSE(turningPoint(0, 50, module));
    EXPECT_FALSE(turningPoint(0, 1'000, module));
    EXPECT_EQ(turningPoint(0, 49, module), -1) << "shorter than the play, which may not be taken up";
    EXPECT_FALSE(turningPoint(7, 7, module));
    module.backlash.fromAbove = true;
    EXPECT_EQ(turningPoint(0, 1'000, module), 1'050);
    EXPECT_FALSE(turningPoint(1'000, 0, module));
}

TEST(Backlash, TheWayRoundRespectsTheLimitsToo) {
    ModuleState module = limited(1'200);
    module.backlash.distance = 50;
    EXPECT_TRUE(plan(to(850), module).has_value()) << "turns at 800";
    EXPECT_EQ(plan(to(849), module).error(), Refusal::BeyondTravel);
    const auto problem = travelProblem(to(849), module);
    EXPECT_EQ(problem->nearest, 850) << "the nearest goal that can be reached from below";
    EXPECT_EQ(problem->limit, 800) << "as it was set";
    EXPECT_EQ(problem->turn, 799);
    EXPECT_EQ(travelProblem(to(700), module)->nearest, 850);
    EXPECT_FALSE(travelProblem(to(700), module)->turn) << "the goal itself is beyond it";
}

/// A servo at `position`, with home at 0, travel limits at 0 and 1000, and 20 counts of play.
ModuleState playing(std::int32_t position) {
    ModuleState module = limited(position);
    module.home.found(0, atSeconds(0.4));
    module.travel.lowest = 0;
    module.travel.highest = 1'000;
    module.backlash.distance = 20;
    return module;
}

TEST(Backlash, TheWayBackRespectsTheLimitsToo) {
    intent::MoveBy moves{{100, 1, 0, true}, ServoPace{kOne, kGentle}};
    EXPECT_TRUE(plan(moves, playing(20)).has_value()) << "it turns at 0 on its way back";
    EXPECT_EQ(plan(moves, playing(10)).error(), Refusal::BeyondTravel);
    const auto problem = travelProblem(moves, playing(10));
    EXPECT_EQ(problem->turn, -10) << "it goes straight to 110, and would arrive at 10 from below";
    EXPECT_EQ(problem->limit, 0);
    moves.moves.backAndForth = false;
    EXPECT_TRUE(plan(moves, playing(10)).has_value());
    // From outside, it may lead to the limits, and not away from them again: from 1100 to 1050 it turns at
    // 1030.
    moves = {{-50, 1, 0, true}, moves.pace};
    EXPECT_EQ(travelProblem(moves, playing(1'100))->limit, 1'000);
    moves.moves.backAndForth = false;
    EXPECT_TRUE(plan(moves, playing(1'100)).has_value());
}

/// 5 moves by 10 counts lead 50 counts on, but the first one is shorter than the play.
TEST(Backlash, TheFirstOfSeveralStepsMayTurnRound) {
    const intent::MoveBy moves{{10, 5}, ServoPace{kOne, kGentle}};
    EXPECT_TRUE(plan(moves, playing(10)).has_value()) << "it turns at 0 on its way to 20";
    EXPECT_EQ(plan(moves, playing(9)).error(), Refusal::BeyondTravel);
    EXPECT_EQ(travelProblem(moves, playing(9))->turn, -1);
}

TEST(Backlash, WhatKeepsAServoFromTheGoalThatItHoldsIsNotTakenForAMove) {
    ModuleState module = limited(820);
    module.backlash.distance = 50;
    module.apply(sampleOf(0.4, kMoveDone | kPower, kServoOn, 821));
    ASSERT_EQ(module.goal(), 820);
    EXPECT_TRUE(plan(to(820), module).has_value()) << "from 821 it would turn at 770, below the limit";
    EXPECT_EQ(plan(to(819), module).error(), Refusal::BeyondTravel);
    EXPECT_EQ(travelProblem(to(819), module)->turn, 769);
}

TEST(Backlash, TheWayRoundOfPointsAndSequencesIsTheSame) {
    ModuleState module = limited(1'200);
    module.backlash.distance = 50;
    EXPECT_TRUE(plan(to(850), asOfSequence(module)).has_value());
    EXPECT_EQ(plan(to(849), asOfSequence(module)).error(), Refusal::BeyondTravel);
    EXPECT_TRUE(plan(to(801), withoutBacklash(module)).has_value()) << "a leg goes straight";
}

}  // namespace
}  // namespace nmc

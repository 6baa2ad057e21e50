// SPDX-License-Identifier: GPL-3.0-or-later
// A home search on a PIC-STEP, DS-S 4.4 and 5.1 Set Homing Mode.
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Stop = HomingRecipe::Stop;
using Input = sim::Input;

class StepperHoming : public testing::Test {
protected:
    StepperHoming() : bench({{ModuleType::Stepper, 1}}) {}

    /// The speed unit is 25 steps/s, and the minimum speed is 100 steps/s.
    [[nodiscard]] bool enable(bool offOnLimit = false) {
        if (!bench.connect())
            return false;
        const stepper::SetParameters parameters{
            stepper::SpeedMode::X1, false, false, offOnLimit, 4, 200, 50, 0};
        const bool done =
            bench.bus.perform(
                {toStep(parameters), toStep(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}) ==
            bus::Outcome::Done;
        bench.settle();
        return done;
    }
    [[nodiscard]] static bus::Order toStep(StepperCommand command) {
        return {ModuleIndex(0), std::move(command)};
    }
    [[nodiscard]] static HomingRecipe recipe() {
        HomingRecipe recipe;
        recipe.onHomeSwitch = true;
        recipe.reverse = false;
        recipe.velocity = 490.0;  // between two of the chip's speeds
        recipe.acceleration = 2'000.0;
        recipe.travelLimit = 4'000.0;
        recipe.timeLimit = 20.0;
        return recipe;
    }
    ProcedureBench bench;
};

TEST_F(StepperHoming, FindsTheHomeSwitchGoesThereAndMakesItZero) {
    for (const Stop stop : {Stop::Abruptly, Stop::Smoothly, Stop::Off}) {
        SCOPED_TRACE(static_cast<int>(stop));
        bench.set(Input::HomeSwitchAt, std::nullopt);
        ASSERT_TRUE(enable());
        const auto start = bench.stepperTruth();
        const auto at = start.shaft + 900;
        bench.set(Input::HomeSwitchAt, static_cast<double>(at));
        double fastest = 0;
        bench.onTurn = [&](Procedure&) {
            fastest = std::max(fastest, std::abs(bench.stepperTruth().stepRate));
        };
        HomingRecipe wanted = recipe();
        wanted.stop = stop;
        const ProcedureReport report = bench.run(intent::Home{wanted});
        EXPECT_EQ(report.stage, ProcedureStage::Done);
        ASSERT_TRUE(report.home);
        EXPECT_NEAR(*report.home, start.position + 900, 1);
        const auto truth = bench.stepperTruth();
        EXPECT_EQ(truth.position, 0);
        EXPECT_NEAR(static_cast<double>(truth.shaft), static_cast<double>(at), 1);
        EXPECT_FALSE(truth.moving);
        EXPECT_FALSE(bench.searches());
        EXPECT_TRUE(truth.ampEnabled);
        EXPECT_DOUBLE_EQ(fastest, 475.0) << "19 x 25 steps/s, never faster than the requested 490";
        bench.bus.expectNoViolations();
    }
}

TEST_F(StepperHoming, ASearchEndsWhereHomeAndLimitsAreBehindIt) {
    ASSERT_TRUE(enable());
    bench.module().home.declare(bench.module().latestTime);
    bench.module().travel.highest = 200;
    // There is no switch. At 490 steps/s it goes 245 steps in half a second, and 60 while it slows down at
    // 2 000 steps/s²: so far a search may go beyond the limit, and then it stops.
    const ProcedureReport report = bench.run(intent::Home{recipe()});
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::SoftLimit);
    EXPECT_NEAR(bench.stepperTruth().position, 200 + 245 + 60 + 60, 60);
    EXPECT_FALSE(bench.stepperTruth().moving);
}

TEST_F(StepperHoming, BacksOffFromTheClosedSwitch) {
    bench.set(Input::HomeSwitchAt, -300.0);
    ASSERT_TRUE(enable());
    const ProcedureReport report = bench.run(intent::Home{recipe()});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::BackingOff) == 1);
    EXPECT_NEAR(static_cast<double>(bench.stepperTruth().shaft), -300, 1);
    EXPECT_EQ(bench.stepperTruth().position, 0);
    bench.bus.expectNoViolations();
}

TEST_F(StepperHoming, FindsALimit) {
    for (const bool offOnLimit : {false, true}) {
        SCOPED_TRACE(offOnLimit);
        bench.set(Input::TravelMin, std::nullopt);
        ASSERT_TRUE(enable(offOnLimit));
        const auto shaft = bench.stepperTruth().shaft;
        bench.set(Input::TravelMin, static_cast<double>(shaft - 500));
        bench.set(Input::TravelMax, static_cast<double>(shaft + 5'000));
        bench.set(Input::Limits, 1);
        HomingRecipe wanted = recipe();
        wanted.onHomeSwitch = false;
        wanted.onLimit2 = true;
        wanted.reverse = true;
        const ProcedureReport report = bench.run(intent::Home{wanted});
        EXPECT_EQ(report.stage, ProcedureStage::Done);
        EXPECT_NEAR(static_cast<double>(bench.stepperTruth().shaft), static_cast<double>(shaft - 500), 1);
        EXPECT_EQ(bench.stepperTruth().position, 0);
        bench.bus.expectNoViolations();
    }
}

TEST_F(StepperHoming, AnotherLimitOnTheWayIsNotHome) {
    ASSERT_TRUE(enable());
    bench.set(Input::TravelMax, 400.0);
    bench.set(Input::TravelMin, -5'000.0);
    bench.set(Input::Limits, 1);
    const ProcedureReport report = bench.run(intent::Home{recipe()});
    EXPECT_EQ(report.failure, ProcedureFailure::NotFound);
    EXPECT_FALSE(report.home);
    EXPECT_FALSE(bench.searches());
    EXPECT_TRUE(bench.stepperTruth().ampEnabled) << "it still holds";
    EXPECT_EQ(bench.bus.sends("AA 01 00"), 0U) << "zero is not set";
    bench.bus.expectNoViolations();
}

TEST_F(StepperHoming, NowhereToBackOffTo) {
    bench.set(Input::HomeSwitch, 1);
    ASSERT_TRUE(enable());
    bench.set(Input::TravelMin, -400.0);
    bench.set(Input::TravelMax, 5'000.0);
    bench.set(Input::Limits, 1);
    const ProcedureReport report = bench.run(intent::Home{recipe()});
    EXPECT_EQ(report.failure, ProcedureFailure::SwitchActive);
    EXPECT_FALSE(bench.stepperTruth().moving);
    bench.bus.expectNoViolations();
}

TEST_F(StepperHoming, M14_WithoutASwitchTheTravelLimitEndsIt) {
    ASSERT_TRUE(enable());
    HomingRecipe wanted = recipe();
    wanted.travelLimit = 1'000;
    const ProcedureReport report = bench.run(intent::Home{wanted});
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
    EXPECT_FALSE(bench.stepperTruth().moving);
    // Slowing down from 475 steps/s at 2 000 steps/s^2 takes 56 steps, and noticing within 100 ms another 48.
    EXPECT_NEAR(bench.stepperTruth().position, 1'060, 60);
    bench.bus.expectNoViolations();
}

TEST_F(StepperHoming, OneReplyThatSaysItIsOffEndsNothing) {
    ASSERT_TRUE(enable());
    bench.set(Input::HomeSwitchAt, static_cast<double>(bench.stepperTruth().shaft + 900));
    bench.begin(intent::Home{recipe()});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.settle();
    bench.sayOff();
    const Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(next));
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_FALSE(report.failure);
    EXPECT_EQ(bench.stepperTruth().position, 0);
    bench.bus.expectNoViolations();
}

class StepEndedIn : public StepperHoming, public testing::WithParamInterface<ProcedureStage> {};

TEST_P(StepEndedIn, ByCancel) {
    bench.set(Input::HomeSwitchAt, -300.0);
    ASSERT_TRUE(enable());
    HomingRecipe wanted = recipe();
    wanted.stop = Stop::Smoothly;
    bench.begin(intent::Home{wanted});
    ASSERT_TRUE(bench.runTo(GetParam()));
    bench.procedure->cancel();
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    bench.bus.runFor(2s);
    EXPECT_FALSE(bench.stepperTruth().moving);
    EXPECT_FALSE(bench.searches());
    EXPECT_TRUE(bench.stepperTruth().ampEnabled);
    EXPECT_EQ(bench.bus.sends("AA 01 00"), 0U) << "zero is not set";
    bench.bus.expectNoViolations();
}

TEST_P(StepEndedIn, ByStopAll) {
    bench.set(Input::HomeSwitchAt, -300.0);
    ASSERT_TRUE(enable());
    HomingRecipe wanted = recipe();
    wanted.stop = Stop::Smoothly;
    bench.begin(intent::Home{wanted});
    ASSERT_TRUE(bench.runTo(GetParam()));
    const std::size_t before = bench.bus.sent.size();
    bench.procedure->cancel();
    ASSERT_TRUE(bench.bus.stopAll());
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 05", before), 0U) << "nothing is started any more";
    EXPECT_FALSE(bench.stepperTruth().moving);
    bench.bus.expectNoViolations();
}

INSTANTIATE_TEST_SUITE_P(Stages, StepEndedIn,
                         testing::Values(ProcedureStage::Preparing, ProcedureStage::BackingOff,
                                         ProcedureStage::Searching, ProcedureStage::Stopping,
                                         ProcedureStage::Reading, ProcedureStage::GoingHome));

TEST_F(StepperHoming, IsRefusedWithoutParametersOrAmplifier) {
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(whyNot(IntentKind::Home, bench.module()), Refusal::ParametersUnknown);
    ASSERT_EQ(bench.bus.perform({toStep(
                  stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0})}),
              bus::Outcome::Done);
    bench.settle();
    EXPECT_EQ(whyNot(IntentKind::Home, bench.module()), Refusal::AmplifierOff);
}

}  // namespace
}  // namespace nmc::test

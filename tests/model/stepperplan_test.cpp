// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/intent/stepperplan.h"

#include <gtest/gtest.h>

#include "base/bytes.h"
#include "bus/commandlane.h"
#include "model/intent/homingplan.h"
#include "model/procedure/procedures.h"
#include "tests/model/intents.h"
#include "tests/model/stepperfixture.h"

namespace nmc {
namespace {

using namespace testing_support;

/// Command byte and data of each step, as they are sent.
std::vector<std::string> bytesOf(const Intent& intent, const ModuleState& module) {
    const auto steps = plan(intent, module);
    if (!steps)
        return {"refused " + std::to_string(static_cast<int>(steps.error()))};
    std::vector<std::string> bytes;
    for (const bus::Order& step : *steps) {
        const PacketBytes packet = toPacket({BusAddress(1), payloadOf(step.command)});
        const std::vector<std::uint8_t> inner(packet.begin() + 2, packet.end() - 1);
        bytes.push_back(toHex(inner));
    }
    return bytes;
}
using Bytes = std::vector<std::string>;

const StepperMotion kTrapezoid = steppermotion::Trapezoid{1'000, false, 40, 4};
const StepperMotion kForward = steppermotion::VelocityProfile{40, 4, false};
const StepperMotion kReverse = steppermotion::VelocityProfile{40, 4, true};
const StepperMotion kPlainMove = steppermotion::UnprofiledMove{-1'000, false, {64'288, 20}};
const StepperMotion kPlainRun = steppermotion::UnprofiledRun{{64'288, 20}, false};

// Data bytes by hand from DS-S 5.1; 1000 = 3E8, 64 288 = FB20, 40 = 28, 20 = 14. Bit 4, 10, is the direction:
// of a run, and of a move without a ramp, where it agrees with the goal.
TEST(StepPlan, LoadsWhatTable4AsksForFromStandstill) {
    const Stepper stepper = Stepper::holding();
    EXPECT_EQ(bytesOf(intent::Move{kTrapezoid}, stepper.module), (Bytes{"74 07 E8 03 00 00 28 04", "05"}));
    EXPECT_EQ(bytesOf(intent::Move{kForward}, stepper.module), (Bytes{"34 06 28 04", "05"}));
    EXPECT_EQ(bytesOf(intent::Move{kReverse}, stepper.module), (Bytes{"34 16 28 04", "05"}));
    EXPECT_EQ(bytesOf(intent::Move{kPlainMove}, stepper.module), (Bytes{"84 19 18 FC FF FF 20 FB 14", "05"}));
    EXPECT_EQ(
        bytesOf(intent::Move{steppermotion::UnprofiledMove{1'000, false, {64'288, 20}}}, stepper.module),
        (Bytes{"84 09 E8 03 00 00 20 FB 14", "05"}));
    EXPECT_EQ(bytesOf(intent::Move{kPlainRun}, stepper.module), (Bytes{"44 08 20 FB 14", "05"}));
    EXPECT_EQ(bytesOf(intent::LoadMove{kTrapezoid}, stepper.module), (Bytes{"74 07 E8 03 00 00 28 04"}));
}

/// As a PIC-SERVO (link.md 1).
TEST(StepPlan, StartsNoMoveToAPositionByItsLoad) {
    const Stepper stepper = Stepper::holding();
    stepper::LoadTrajectory load = Stepper::trapezoid(1'000);
    EXPECT_EQ(bytesOf(intent::Direct{StepperCommand(load)}, stepper.module),
              (Bytes{"74 07 E8 03 00 00 28 04"}));
    load.startNow = true;
    EXPECT_EQ(refusalOf(intent::Direct{StepperCommand(load)}, stepper.module), Refusal::StartApart);
    load.position.reset();
    EXPECT_EQ(bytesOf(intent::Direct{StepperCommand(load)}, stepper.module), (Bytes{"34 86 28 04"}));
    load = {};
    load.position = Counts(-1'000);
    load.timer = stepper::TimerCount{64'288, 20};
    load.startNow = load.reverse = true;
    EXPECT_EQ(refusalOf(intent::Direct{StepperCommand(load)}, stepper.module), Refusal::StartApart);
}

TEST(StepPlan, CountsARelativeGoalFromWhereItStands) {
    Stepper stepper = Stepper::holding();
    stepper.position = 500;
    stepper.says(kStepOn);
    EXPECT_EQ(bytesOf(intent::Move{steppermotion::Trapezoid{-100, true, 40, 4}}, stepper.module),
              (Bytes{"74 07 90 01 00 00 28 04", "05"}))
        << "400 = 190";
    EXPECT_EQ(bytesOf(intent::Move{steppermotion::UnprofiledMove{-100, true, {64'288, 20}}}, stepper.module),
              (Bytes{"84 19 90 01 00 00 20 FB 14", "05"}))
        << "in reverse to a goal above 0";
}

TEST(StepPlan, SwitchesAndStopsWithTheAmplifierAsItShallBe) {
    const Stepper stepper = Stepper::running();
    EXPECT_EQ(bytesOf(intent::Enable{}, Stepper::holding().module), (Bytes{"17 01"}));
    EXPECT_EQ(bytesOf(intent::StopSmoothly{}, stepper.module), (Bytes{"17 09"}));
    EXPECT_EQ(bytesOf(intent::StopAbruptly{}, stepper.module), (Bytes{"17 05"}));
    EXPECT_EQ(bytesOf(intent::MotorOff{}, stepper.module), (Bytes{"17 04"}));
    Stepper off;
    off.says(kStepPower);
    EXPECT_EQ(bytesOf(intent::StopAbruptly{}, off.module), (Bytes{"17 04"})) << "a stop enables nothing";
}

/// docs/link.md 2.4: one reply does not state a fact.
TEST(StepPlan, AStopLeavesTheAmplifierOnThatOnlyOneReplyShowsOff) {
    Stepper stepper = Stepper::running();
    stepper.says(kStepPower);
    ASSERT_TRUE(stepper.module.maybeOff());
    EXPECT_EQ(bytesOf(intent::StopSmoothly{}, stepper.module), (Bytes{"17 09"}));
    EXPECT_EQ(bytesOf(intent::StopAbruptly{}, stepper.module), (Bytes{"17 05"}));
    stepper.says(kStepPower);
    EXPECT_EQ(bytesOf(intent::StopAbruptly{}, stepper.module), (Bytes{"17 04"})) << "now it is";
}

TEST(StepPlan, StopsAbruptlyWhereNoRampIsKnown) {
    Stepper stepper = Stepper::holding();
    stepper::LoadTrajectory load;
    load.timer = stepper::TimerCount{64'288, 20};
    load.startNow = true;
    stepper.was(load);
    stepper.says(kStepOn | kMoving | kAtSpeed);
    EXPECT_EQ(bytesOf(intent::StopSmoothly{}, stepper.module), (Bytes{"17 05"}));
}

// Mode 1x = 11, ignore limits = 4, motor off = 10: 17.
TEST(StepPlan, SendsParametersAndOutputsAsTheyAre) {
    stepper::SetParameters parameters = Stepper::parameters();
    parameters.ignoreLimits = parameters.motorOffOnLimitOrEstop = true;
    parameters.thermalLimit = 80;
    const Stepper stepper = Stepper::holding();
    EXPECT_EQ(bytesOf(stepperintent::SetParameters{parameters}, stepper.module),
              (Bytes{"56 17 04 64 32 50"}));
    EXPECT_EQ(bytesOf(stepperintent::SetOutputs{0x15}, stepper.module), (Bytes{"18 15"}));
}

TEST(StepPlan, MovesNothingBeforeTheParametersWereSet) {
    Stepper stepper;
    stepper.says(kStepOn);
    EXPECT_EQ(refusalOf(intent::Move{kTrapezoid}, stepper.module), Refusal::ParametersUnknown);
    EXPECT_EQ(refusalOf(intent::Enable{}, stepper.module), Refusal::ParametersUnknown);
    EXPECT_EQ(whyNot(IntentKind::Hold, stepper.module), Refusal::ParametersUnknown);
}

TEST(StepPlan, MovesNothingWithoutPowerOrAmplifier) {
    Stepper stepper = Stepper::holding();
    stepper.wasStopped(stepper::StopManner::Abruptly, false);
    stepper.says(kStepPower);
    EXPECT_EQ(refusalOf(intent::Move{kForward}, stepper.module), Refusal::AmplifierOff);
    EXPECT_EQ(refusalOf(intent::Enable{}, stepper.module), std::nullopt);
    stepper.says(0);
    EXPECT_EQ(refusalOf(intent::Move{kForward}, stepper.module), Refusal::NoPower);
    EXPECT_EQ(refusalOf(intent::Enable{}, stepper.module), Refusal::NoPower);
}

TEST(StepPlan, RefusesTheDirectionWhoseLimitIsActive) {
    Stepper stepper = Stepper::holding();
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(refusalOf(intent::Move{kForward}, stepper.module), Refusal::Limit1Active);
    EXPECT_EQ(refusalOf(intent::Move{kTrapezoid}, stepper.module), Refusal::Limit1Active);
    EXPECT_EQ(refusalOf(intent::Move{kReverse}, stepper.module), std::nullopt) << "off the switch";
    stepper.inputs = kLimit2In;
    stepper.says(kStepOn);
    EXPECT_EQ(refusalOf(intent::Move{kReverse}, stepper.module), Refusal::Limit2Active);
    EXPECT_EQ(refusalOf(intent::Move{kPlainMove}, stepper.module), Refusal::Limit2Active);
    stepper::SetParameters ignoring = Stepper::parameters();
    ignoring.ignoreLimits = true;
    stepper.was(ignoring);
    EXPECT_EQ(refusalOf(intent::Move{kReverse}, stepper.module), std::nullopt);
}

TEST(StepPlan, RefusesMotionWhileTheEstopInputActs) {
    Stepper stepper = Stepper::holding();
    stepper.inputs = kEstopIn;
    stepper.says(kStepOn);
    EXPECT_EQ(refusalOf(intent::Move{kReverse}, stepper.module), Refusal::EstopActive);
    EXPECT_EQ(refusalOf(intent::StopAbruptly{}, stepper.module), std::nullopt);
}

TEST(StepPlan, RefusesToEnableAMotorThatIsTooHot) {
    Stepper stepper = Stepper::holding();
    stepper::SetParameters parameters = Stepper::parameters();
    parameters.thermalLimit = 80;
    stepper.was(parameters);
    stepper.analog = 79;
    stepper.says(kStepPower);
    EXPECT_EQ(refusalOf(intent::Enable{}, stepper.module), Refusal::TooHot);
}

// Footnote of Load Trajectory: the goal is at most 0x7FFFFFFF away.
TEST(StepPlan, RefusesAGoalThatIsTooFarAway) {
    Stepper stepper = Stepper::holding();
    stepper.position = -2'000'000'000;
    stepper.says(kStepOn);
    const auto to = [](std::int32_t goal, bool relative) {
        return intent::Move{steppermotion::Trapezoid{goal, relative, 40, 4}};
    };
    EXPECT_EQ(refusalOf(to(200'000'000, false), stepper.module), Refusal::TooFar);
    EXPECT_EQ(refusalOf(to(147'483'647, false), stepper.module), std::nullopt);
    EXPECT_EQ(refusalOf(to(-200'000'000, true), stepper.module), Refusal::TooFar) << "-2 200 000 000";
    stepper.was(Stepper::trapezoid(200'000'000));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), Refusal::TooFar);
    stepper.was(Stepper::trapezoid(147'483'647));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), std::nullopt);
}

struct Transition {
    const char* name;
    StepperMode from;
    StepperMotion goal;
    bool allowed;
};

/// A stepper that moves forward in `mode`, with a goal 900 steps away where the mode has one.
Stepper inMode(StepperMode mode) {
    Stepper stepper = Stepper::holding();
    stepper::LoadTrajectory load = Stepper::trapezoid(900);
    unsigned bits = kTrapezoidalMode;
    switch (mode) {
        case StepperMode::Trapezoidal:
            break;
        case StepperMode::VelocityProfile:
            load.position.reset();
            bits = kVelocityMode;
            break;
        case StepperMode::UnprofiledWithStop:
        case StepperMode::Unprofiled:
            load = {};
            if (mode == StepperMode::UnprofiledWithStop)
                load.position = Counts(900);
            load.timer = stepper::TimerCount{64'288, 20};
            bits = 0;
            break;
        case StepperMode::Stopped:
            return stepper;
        case StepperMode::Unknown:
            stepper.says(kStepOn | kMoving);
            return stepper;
    }
    load.startNow = true;
    stepper.was(load);
    stepper.says(kStepOn | kMoving | bits);
    return stepper;
}

class StepperTransitions : public testing::TestWithParam<Transition> {};

TEST_P(StepperTransitions, AreThoseOfTable4) {
    const Stepper stepper = inMode(GetParam().from);
    EXPECT_EQ(stepper.module.stepper.mode(), GetParam().from);
    EXPECT_EQ(refusalOf(intent::Move{GetParam().goal}, stepper.module),
              GetParam().allowed ? std::nullopt : std::optional(Refusal::NeedsStop));
    EXPECT_EQ(whyNotFromStandstill(GetParam().goal, stepper.module), std::nullopt);
}

// This is stricter than the data sheet, which still applies to commands that a user sends directly: the speed
// of a move is not changed while it runs, because the timer count alone would start a run without an end if
// the move had ended meanwhile.
INSTANTIATE_TEST_SUITE_P(
    Cells, StepperTransitions,
    testing::Values(Transition{"TrapezoidToTrapezoid", StepperMode::Trapezoidal, kTrapezoid, false},
                    Transition{"TrapezoidToProfile", StepperMode::Trapezoidal, kForward, false},
                    Transition{"TrapezoidToMove", StepperMode::Trapezoidal, kPlainMove, false},
                    Transition{"TrapezoidToRun", StepperMode::Trapezoidal, kPlainRun, false},
                    Transition{"ProfileToTrapezoid", StepperMode::VelocityProfile, kTrapezoid, false},
                    Transition{"ProfileToProfile", StepperMode::VelocityProfile, kForward, true},
                    Transition{"ProfileToOtherDirection", StepperMode::VelocityProfile, kReverse, false},
                    Transition{"ProfileToMove", StepperMode::VelocityProfile, kPlainMove, false},
                    Transition{"ProfileToRun", StepperMode::VelocityProfile, kPlainRun, true},
                    Transition{"MoveToTrapezoid", StepperMode::UnprofiledWithStop, kTrapezoid, false},
                    Transition{"MoveToProfile", StepperMode::UnprofiledWithStop, kForward, true},
                    Transition{"MoveToMove", StepperMode::UnprofiledWithStop, kPlainMove, false},
                    Transition{"MoveToRun", StepperMode::UnprofiledWithStop, kPlainRun, false},
                    Transition{"RunToTrapezoid", StepperMode::Unprofiled, kTrapezoid, false},
                    Transition{"RunToProfile", StepperMode::Unprofiled, kForward, true},
                    Transition{"RunToOtherDirection", StepperMode::Unprofiled, kReverse, false},
                    Transition{"RunToMove", StepperMode::Unprofiled, kPlainMove, false},
                    Transition{"RunToRun", StepperMode::Unprofiled, kPlainRun, true},
                    Transition{"UnknownToProfile", StepperMode::Unknown, kForward, false}),
    [](const auto& one) { return std::string(one.param.name); });

/// DS-S 5.1 Load Trajectory: without the start bit it has no effect whatsoever.
TEST(StepPlan, LoadsAMoveInMotionWhereItsGoalIsCertain) {
    const Stepper stepper = Stepper::running();
    EXPECT_EQ(bytesOf(intent::LoadMove{kTrapezoid}, stepper.module), (Bytes{"74 07 E8 03 00 00 28 04"}));
    EXPECT_EQ(refusalOf(intent::LoadMove{steppermotion::Trapezoid{-100, true, 40, 4}}, stepper.module),
              Refusal::NeedsStop)
        << "the starting point is not known";
    EXPECT_EQ(refusalOf(intent::LoadMove{kPlainMove}, stepper.module), Refusal::NeedsStop)
        << "nor on which side of the goal it lies";
}

TEST(StepPlan, DoesNotSetThePositionToZeroInMotion) {
    const Stepper stepper = Stepper::running();
    EXPECT_EQ(refusalOf(intent::ResetPosition{}, stepper.module), Refusal::NeedsStop);
    stepper::SetParameters parameters = Stepper::parameters();
    parameters.runCurrent = 90;
    EXPECT_EQ(refusalOf(stepperintent::SetParameters{parameters}, stepper.module), std::nullopt);
    parameters.minimumProfileSpeed = 9;
    EXPECT_EQ(refusalOf(stepperintent::SetParameters{parameters}, stepper.module), Refusal::NeedsStop)
        << "the chip would ignore it (DS-S 5.1)";
    EXPECT_EQ(refusalOf(intent::SaveAsHome{}, stepper.module), std::nullopt);
}

TEST(StepPlan, StartsWhatWasLoadedOnceAndOnlyWhereItMayGo) {
    Stepper stepper = Stepper::holding();
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), Refusal::NothingLoaded);
    stepper.was(Stepper::trapezoid(1'000));
    EXPECT_EQ(bytesOf(intent::StartLoaded{}, stepper.module), (Bytes{"05"}));
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), Refusal::Limit1Active);
    stepper.inputs = 0;
    stepper.says(kStepOn);
    stepper.was(StartMotion{});
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), Refusal::NothingLoaded);
    stepper.was(Stepper::trapezoid(1'000));
    stepper.was(ResetPosition{});
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, stepper.module), Refusal::NothingLoaded)
        << "its goal counts from the zero of before";
}

TEST(StepPlan, KnowsWhatIsNotForIt) {
    const Stepper stepper = Stepper::holding();
    EXPECT_EQ(refusalOf(intent::ApplyGains{}, stepper.module), Refusal::NotAServo);
    EXPECT_EQ(refusalOf(intent::Move{servomotion::Trapezoid{}}, stepper.module), Refusal::NotAServo);
    ModuleState servo;
    servo.info.identity = {ModuleType::Servo, 4};
    EXPECT_EQ(refusalOf(stepperintent::SetOutputs{1}, servo), Refusal::NotAStepper);
    EXPECT_EQ(whyNot(IntentKind::SetParameters, servo), Refusal::Unresponsive);
}

TEST(StepPlan, AsksNothingOfAModuleThatDoesNotAnswerButToSwitchOff) {
    Stepper stepper = Stepper::running();
    stepper.module.silent = true;
    EXPECT_EQ(refusalOf(intent::Move{kForward}, stepper.module), Refusal::Unresponsive);
    EXPECT_EQ(refusalOf(intent::MotorOff{}, stepper.module), std::nullopt);
}

}  // namespace
}  // namespace nmc

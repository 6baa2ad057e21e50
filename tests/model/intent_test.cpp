// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/intent.h"

#include <gtest/gtest.h>

#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

const intent::GoTo kGoTo{Counts(20'000), CountsPerTick(8 << 16), CountsPerTickSquared(1311)};
const intent::RunAtVelocity kRun{CountsPerTick(1 << 16), CountsPerTickSquared(100), true};

Refusal refusalOf(const Intent& intent, const ModuleState& module) {
    const auto steps = plan(intent, module);
    EXPECT_FALSE(steps.has_value());
    return steps ? Refusal::NotConnected : steps.error();
}

std::vector<std::string> payloads(const Intent& intent, const ModuleState& module) {
    std::vector<std::string> hex;
    const auto steps = plan(intent, module);
    EXPECT_TRUE(steps.has_value());
    if (steps)
        for (const bus::Step& step : *steps) {
            const Payload payload = encode(std::get<ServoCommand>(step.command));
            hex.push_back(toHex(ByteBuffer<1>{payload.commandByte()}) +
                          (payload.data.empty() ? "" : " " + toHex(payload.data)));
        }
    return hex;
}

using Hex = std::vector<std::string>;

TEST(Plan, GoesToAPositionByLoadThenStart) {
    // 20 000 = 0x4E20, 8 counts/tick = 0x00080000, 1311 = 0x51F; control: position, velocity, acceleration,
    // servo.
    EXPECT_EQ(payloads(kGoTo, holdingServo()), (Hex{"D4 17 20 4E 00 00 00 00 08 00 1F 05 00 00", "05"}));
}

TEST(Plan, RunsInReverseByLoadThenStart) {
    // control: velocity, acceleration, servo, velocity profile, reverse = 0x76.
    EXPECT_EQ(payloads(kRun, holdingServo()), (Hex{"94 76 00 00 01 00 64 00 00 00", "05"}));
}

TEST(Plan, EnablesWithOneStopThatHoldsAndSetsTheAmplifier) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1, stopWith(servo::StopManner::MotorOff, false)));
    module.apply(sampleOf(1, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::Enable{}, module), Hex{"17 05"});
}

TEST(Plan, RefusesToEnableWithoutGainsThatHold) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::GainsUnknown);
    module.apply(executedAt(1, servo::SetGain{}));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::GainsUnknown);
}

TEST(Plan, RefusesToEnableWithoutMotorPower) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError, 0));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::NoPower);
}

TEST(Plan, RefusesAMoveWhileAServoIsOff) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(refusalOf(kGoTo, module), Refusal::ServoOff);
    EXPECT_EQ(refusalOf(kRun, module), Refusal::ServoOff);
    // A stop would switch it on (protocol.md 2).
    EXPECT_EQ(refusalOf(intent::StopAbruptly{}, module), Refusal::ServoOff);
    EXPECT_EQ(refusalOf(intent::StopSmoothly{}, module), Refusal::ServoOff);
}

TEST(Plan, RefusesATrapezoidAndAZeroInMotionButTakesAVelocity) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1, trapezoid(20'000, 8 << 16, 1311)));
    module.apply(executedAt(1, StartMotion{}));
    module.apply(sampleOf(1.1, kPower, kServoOn));
    EXPECT_EQ(refusalOf(kGoTo, module), Refusal::Moving);
    EXPECT_EQ(refusalOf(intent::ResetPosition{}, module), Refusal::Moving);
    EXPECT_TRUE(
        plan(kRun, module).has_value());  // DS-V 4.4: velocity mode may be entered in the middle of a move
}

TEST(Plan, RefusesAMoveThatCouldNeverMove) {
    intent::GoTo goTo = kGoTo;
    goTo.acceleration = CountsPerTickSquared(0);
    EXPECT_EQ(refusalOf(goTo, holdingServo()), Refusal::NoAcceleration);
    goTo = kGoTo;
    goTo.velocity = CountsPerTick(0);
    EXPECT_EQ(refusalOf(goTo, holdingServo()), Refusal::NoVelocity);
}

TEST(Plan, StopsAbruptlyWhereASmoothStopCouldNotSlowDown) {
    ModuleState module = holdingServo();
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 05"});
    module.apply(executedAt(1, velocityMode(1 << 16, 100)));
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 09"});
}

TEST(Plan, SwitchesTheMotorOffWhateverIsBelieved) {
    EXPECT_EQ(payloads(intent::MotorOff{}, servoModule()), Hex{"17 02"});
}

TEST(Plan, SendsThirteenGainBytesToEarlierVersions) {
    servo::SetGain gains;
    gains.kp = 1;
    gains.db = std::uint8_t{5};
    ModuleState old = servoModule(3);
    old.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::ApplyGains{gains}, old), Hex{"D6 01 00 00 00 00 00 00 00 00 00 00 00 01"});
    ModuleState present = servoModule(4);
    present.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::ApplyGains{gains}, present),
              Hex{"E6 01 00 00 00 00 00 00 00 00 00 00 00 01 05"});
}

TEST(Plan, AsksNothingOfASilentModuleButToSwitchOff) {
    ModuleState module = holdingServo();
    module.silent = true;
    EXPECT_EQ(refusalOf(kGoTo, module), Refusal::Silent);
    EXPECT_EQ(refusalOf(intent::ClearStickyBits{}, module), Refusal::Silent);
    EXPECT_TRUE(plan(intent::MotorOff{}, module).has_value());
}

TEST(Plan, KnowsNoCommandsForOtherModules) {
    ModuleState module = holdingServo();
    module.info.identity = {ModuleType::Io, 1};
    EXPECT_EQ(refusalOf(kGoTo, module), Refusal::NotAServo);
    EXPECT_EQ(refusalOf(intent::MotorOff{}, module), Refusal::NotAServo);
}

}  // namespace
}  // namespace nmc

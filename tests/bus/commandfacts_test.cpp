// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "module/commandfacts.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;

// Expected values are those of the table in link.md 2.3.

TEST(CommandFacts, RepeatsQuestionsAndIdenticalSettingsTwice) {
    const std::vector<ModuleCommand> commands{
        ServoCommand(Nop{}),
        ServoCommand(ReadStatus{}),
        ServoCommand(DefineStatus{}),
        gains(0).command,
        ServoCommand(servo::IoControl{}),
        ServoCommand(servo::ScIoControl{}),
        StepperCommand(stepper::SetParameters{}),
        StepperCommand(stepper::SetOutputs{}),
        IoCommand(io::SetDirection{}),
        IoCommand(io::SetOutput{}),
        IoCommand(io::SetPwm{100, 0}),
        IoCommand(io::SetPwm{200, 0}),  // bit 7 of its first byte starts a motion in a Load Trajectory
        IoCommand(io::SetSynchOutput{}),
    };
    for (const ModuleCommand& command : commands)
        EXPECT_EQ(factsOf(command).retry, (RetryRule{2, 3, false})) << toHex(payloadOf(command).data);
}

TEST(CommandFacts, NeverRepeatsBlindlyWhatCouldActTwice) {
    const std::vector<ModuleCommand> commands{
        ServoCommand(StartMotion{}),
        ServoCommand(ResetPosition{}),
        ServoCommand(servo::ResetRelativeToHome{}),
        ServoCommand(servo::SetPosition{}),
        ServoCommand(SaveAsHome{}),
        ServoCommand(servo::ClearStickyBits{}),
        ServoCommand(servo::SetHoming{}),
        StepperCommand(stepper::SetHoming{}),
        ServoCommand(SetAddress{BusAddress(1)}),
        IoCommand(io::SetTimerMode{}),
        IoCommand(io::SynchOutput{}),
        IoCommand(io::SynchInput{}),
    };
    for (const ModuleCommand& command : commands)
        EXPECT_EQ(factsOf(command).retry, (RetryRule{0, 3, false})) << payloadOf(command).commandByte();
}

TEST(CommandFacts, RepeatsALoadOnlyWithoutStart) {
    EXPECT_EQ(factsOf(loadMove(0, 5).command).retry.silentRepeats, 2);
    EXPECT_EQ(factsOf(loadVelocity(0, 5, false).command).retry.silentRepeats, 2);
    EXPECT_EQ(factsOf(loadVelocity(0, 5, true).command).retry.silentRepeats, 0);
    EXPECT_EQ(factsOf(loadPwm(0, 5).command).retry.silentRepeats, 0);
}

TEST(CommandFacts, RepeatsAStopAtOnce) {
    EXPECT_EQ(factsOf(enable(0).command).retry, (RetryRule{4, 10, true}));
    EXPECT_EQ(factsOf(StepperCommand(stepper::StopMotor{})).retry, (RetryRule{4, 10, true}));
}

TEST(CommandFacts, OnlyAMotorStartsAMotion) {
    EXPECT_TRUE(mayStartMotion(loadVelocity(0, 5, true).command));
    EXPECT_TRUE(mayStartMotion(start(0).command));
    EXPECT_FALSE(mayStartMotion(loadVelocity(0, 5, false).command));
    EXPECT_FALSE(mayStartMotion(IoCommand(io::SetPwm{200, 200})));
    EXPECT_FALSE(mayStartMotion(IoCommand(io::SynchOutput{})));
}

}  // namespace

}  // namespace nmc::test

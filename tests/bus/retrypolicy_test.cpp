// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/commandlane.h"
#include "bus/retrypolicy.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;

// The oracle is the table of link.md 2.3.

TEST(RetryPolicy, RepeatsQuestionsAndIdenticalSettingsTwice) {
    for (const CommandCode code : {CommandCode::Nop, CommandCode::ReadStatus, CommandCode::DefineStatus,
                                   CommandCode::SetGain, CommandCode::IoControl}) {
        EXPECT_EQ(retryRule(code, false).afterSilence, AfterSilence::Repeat);
        EXPECT_EQ(retryRule(code, false).silentRepeats, 2);
    }
}

TEST(RetryPolicy, NeverRepeatsBlindlyWhatCouldActTwice) {
    for (const CommandCode code :
         {CommandCode::StartMotion, CommandCode::ResetPosition, CommandCode::SaveAsHome,
          CommandCode::ClearStickyBits, CommandCode::SetHoming, CommandCode::SetAddress}) {
        EXPECT_EQ(retryRule(code, false).afterSilence, AfterSilence::GiveUp);
        EXPECT_EQ(retryRule(code, false).silentRepeats, 0);
        EXPECT_EQ(retryRule(code, false).refusedAttempts, 3) << "refused is certainly not carried out";
    }
}

TEST(RetryPolicy, RepeatsALoadOnlyWithoutStart) {
    EXPECT_EQ(retryRule(payloadOf(loadMove(0, 5).command)).silentRepeats, 2);
    EXPECT_EQ(retryRule(payloadOf(loadVelocity(0, 5, false).command)).silentRepeats, 2);
    EXPECT_EQ(retryRule(payloadOf(loadVelocity(0, 5, true).command)).silentRepeats, 0);
    EXPECT_EQ(retryRule(payloadOf(loadPwm(0, 5).command)).silentRepeats, 0);
}

TEST(RetryPolicy, RepeatsAStopAtOnce) {
    EXPECT_EQ(retryRule(CommandCode::StopMotor, false).afterSilence, AfterSilence::RepeatAtOnce);
    EXPECT_GE(retryRule(CommandCode::StopMotor, false).refusedAttempts, 3);
}

}  // namespace

}  // namespace nmc::test

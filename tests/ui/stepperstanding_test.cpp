// SPDX-License-Identifier: GPL-3.0-or-later
// What is reported about the states of a PIC-STEP: each cause by itself, as long as it lasts.
#include <gmock/gmock.h>

#include "tests/model/stepperfixture.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr unsigned kRuns = kStepOn | kMoving | kVelocityMode | kAtSpeed;

class StepperStanding : public testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> keys() const {
        LinkState link;
        link.phase = LinkPhase::Connected;
        link.modules = {stepper.module};
        std::vector<std::string> all;
        for (const Message& message : texts::standing(link, stepper.time))
            all.push_back(message.key.toStdString());
        return all;
    }
    void runsAgain(bool offOnInputs) {
        stepper = Stepper::running();
        stepper::SetParameters parameters = Stepper::parameters();
        parameters.thermalLimit = 80;
        parameters.motorOffOnLimitOrEstop = offOnInputs;
        stepper.was(parameters);
        stepper.says(kRuns);
    }
    Stepper stepper;
};

TEST_F(StepperStanding, HeatLimitAndEstopAreThreeCauses) {
    runsAgain(true);
    EXPECT_THAT(keys(), IsEmpty());
    stepper.analog = 79;
    stepper.says(kStepPower);
    stepper.says(kStepPower);
    EXPECT_THAT(keys(), ElementsAre("overheated.1"));
    runsAgain(true);
    stepper.inputs = kLimit1In;
    stepper.says(kStepPower);
    stepper.says(kStepPower);
    EXPECT_THAT(keys(), ElementsAre("limitOff.1")) << "the limit is not reported once more";
    runsAgain(true);
    stepper.inputs = kEstopIn;
    stepper.says(kStepPower);
    stepper.says(kStepPower);
    EXPECT_THAT(keys(), ElementsAre("estop.1"));
}

TEST_F(StepperStanding, WhatSwitchedItOffStaysToldWhenSomethingElseIsTheCaseLater) {
    runsAgain(true);
    stepper.analog = 79;
    stepper.says(kStepPower);
    stepper.inputs = kEstopIn;
    stepper.says(0);
    EXPECT_THAT(keys(), ElementsAre("overheated.1"));
}

TEST_F(StepperStanding, ALimitStopThatKeepsTheAmplifierOnIsToldUntilTheSwitchOpens) {
    runsAgain(false);
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_THAT(keys(), ElementsAre("limit1.1"));
    EXPECT_TRUE(texts::limitClosed(stepper.module, 1).headline.contains(QStringLiteral("stopped its motor")));
    stepper.inputs = 0;
    stepper.says(kStepOn);
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StepperStanding, AnEstopThatKeepsTheAmplifierOnIsToldUntilItIsReleased) {
    runsAgain(false);
    stepper.inputs = kEstopIn;
    stepper.says(kStepOn);
    EXPECT_THAT(keys(), ElementsAre("estopActive.1"));
    stepper.inputs = 0;
    stepper.says(kStepOn);
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StepperStanding, HomesOwnMotorOffIsNoFault) {
    runsAgain(true);
    stepper::SetHoming homing;
    homing.onLimit1Change = homing.motorOff = true;
    stepper.was(homing);
    stepper.says(kRuns | kStepHoming);
    stepper.inputs = kLimit1In;
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), Activity::AmplifierOff);
    stepper.was(stepper::SetHoming{});
    stepper.says(kStepPower);
    EXPECT_THAT(keys(), IsEmpty());
}

}  // namespace
}  // namespace nmc

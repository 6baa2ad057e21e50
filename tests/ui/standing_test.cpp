// SPDX-License-Identifier: GPL-3.0-or-later
// What is reported about a state, as long as the state lasts.
#include <gmock/gmock.h>

#include "tests/model/servofixture.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using namespace testing_support;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint8_t kLimit1 = 0x20;
constexpr std::uint8_t kOk = kMoveDone | kPower;

class StandingTexts : public testing::Test {
protected:
    StandingTexts() {
        link.phase = LinkPhase::Connected;
        link.modules = {holdingServo()};
    }
    ModuleState& servo() { return link.modules.front(); }
    void says(double seconds, int status, int aux = kServoOn) {
        servo().apply(sampleOf(seconds, static_cast<std::uint8_t>(status), static_cast<std::uint8_t>(aux)));
    }
    void run(int bits = 0) {
        servo().apply(executedAt(1.0, velocityMode(65'536, 100)));
        says(1.1, kPower | bits);
    }
    [[nodiscard]] std::vector<std::string> keys(bool procedureRuns = false) const {
        std::vector<std::string> all;
        for (const Message& message :
             texts::standing(link, atSeconds(10), [procedureRuns](ModuleIndex) { return procedureRuns; }))
            all.push_back(message.key.toStdString());
        return all;
    }

    LinkState link;
};

TEST_F(StandingTexts, NothingIsToldOfAChainThatIsWell) {
    EXPECT_THAT(keys(), IsEmpty());
    run();
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, ATripEndsWithItsAcknowledgement) {
    says(2.0, kOk | kPosError, 0);
    EXPECT_THAT(keys(), IsEmpty()) << "one answer is not enough";
    says(2.05, kOk | kPosError, 0);
    EXPECT_THAT(keys(), ElementsAre("tripped.1"));
    servo().apply(executedAt(2.1, stopWith(servo::StopManner::MotorOff)));
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, MissingPowerIsNoTrip) {
    says(2.0, kMoveDone | kPosError, 0);
    says(2.05, kMoveDone | kPosError, 0);
    EXPECT_THAT(keys(), ElementsAre("power.1"));
}

TEST_F(StandingTexts, ARestartIsToldInPlaceOfAllThatWasTheCase) {
    says(2.0, kOk | kPosError, 0);
    servo().restarted();
    servo().silent = true;
    EXPECT_THAT(keys(), ElementsAre("restarted.1"));
}

TEST_F(StandingTexts, AModuleWithoutAMotorIsNotSaidToHaveOne) {
    servo().info.identity = {ModuleType::Io, 1};
    servo().silent = true;
    link.modules.push_back(servoModule());
    link.modules.back().info.index = ModuleIndex(1);
    const auto headline = [this] { return texts::standing(link, atSeconds(10)).front().headline; };
    EXPECT_TRUE(headline().endsWith(u"The state of its outputs is unknown."_s)) << headline().toStdString();
    servo().restarted();
    EXPECT_TRUE(headline().startsWith(u"Module 1 restarted: its pins are inputs again"_s))
        << headline().toStdString();
}

TEST_F(StandingTexts, SilenceIsToldUnlessItIsThatOfTheWholeLink) {
    link.modules.push_back(servoModule());
    link.modules.back().info.index = ModuleIndex(1);
    servo().silent = true;
    EXPECT_THAT(keys(), ElementsAre("silent.1"));
    link.modules.back().silent = true;
    link.modules.back().latest.emplace();
    EXPECT_THAT(keys(), ElementsAre("silent.1", "silent.2"));
    link.phase = LinkPhase::Lost;
    EXPECT_THAT(keys(), IsEmpty()) << "one cause gives one text";
    link.phase = LinkPhase::Connecting;
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, ALimitThatClosesOnTheWayIsToldUntilItOpens) {
    run();
    says(1.2, kPower | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limit1.1"));
    servo().apply(executedAt(1.3, stopWith(servo::StopManner::Abruptly)));
    says(1.4, kOk | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limit1.1")) << "it stands on the switch";
    says(1.5, kOk);
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, ALimitThatIsClosedAlreadyOrByHandIsNotToldOf) {
    says(0.9, kOk | kLimit1);
    EXPECT_THAT(keys(), IsEmpty()) << "the motor stands";
    run();
    says(1.2, kPower | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limit1.1")) << "open in between, at 1.1 s";
    servo() = holdingServo();
    says(0.9, kOk | kLimit1);
    servo().apply(executedAt(1.0, velocityMode(65'536, 100)));
    says(1.1, kPower | kLimit1);
    EXPECT_THAT(keys(), IsEmpty()) << "it may be on its way off the switch";
}

TEST_F(StandingTexts, ALimitStopThatTripsIsToldUntilItIsArmedAnewOrDisarmed) {
    servo::SetHoming stop;
    stop.onLimit1Change = stop.stopAbruptly = true;
    servo().apply(executedAt(0.5, stop));
    says(0.6, kOk | kHoming);
    run(kHoming);
    says(1.2, kPower | kHoming);
    EXPECT_THAT(keys(), IsEmpty());
    says(1.3, kOk | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limitStop.1")) << "the limit that was watched is not reported itself";
    EXPECT_THAT(keys(true), IsEmpty()) << "a search for home stops in the same way";
    says(1.4, kOk);
    EXPECT_THAT(keys(), ElementsAre("limitStop.1")) << "nothing would stop it the next time";
    servo().apply(executedAt(1.5, servo::SetHoming{}));
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, ALimitStopThatIsArmedAnewForTheOtherLimitIsToldUntilTheMotorHasLeft) {
    servo::SetHoming stop;
    stop.onLimit1Change = stop.onLimit2Change = stop.stopAbruptly = true;
    servo().apply(executedAt(0.5, stop));
    run(kHoming);
    says(1.2, kOk | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limitStop.1"));
    stop.onLimit1Change = false;
    servo().apply(executedAt(1.3, stop));
    says(1.4, kOk | kLimit1 | kHoming);
    EXPECT_THAT(keys(), ElementsAre("limitStop.1")) << "it stands on the switch";
    says(1.5, kOk | kHoming);
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, ALimitOtherThanTheWatchedOneIsToldOf) {
    servo::SetHoming stop;
    stop.onLimit2Change = stop.stopAbruptly = true;
    servo().apply(executedAt(0.5, stop));
    run(kHoming);
    says(1.2, kPower | kHoming);
    says(1.3, kPower | kHoming | kLimit1);
    EXPECT_THAT(keys(), ElementsAre("limit1.1"));
}

TEST_F(StandingTexts, AServoIsSaidToGoOnAndAStepperToBeHeld) {
    EXPECT_TRUE(texts::limitClosed(servo(), 1).headline.contains(u"does not stop it"_s));
    servo().info.identity.type = ModuleType::Stepper;
    servo().info.identity.version = 1;
    const Message step = texts::limitClosed(servo(), 1);
    EXPECT_FALSE(step.headline.contains(u"does not stop it"_s));
    EXPECT_TRUE(step.body.contains(u"the module blocks this direction"_s));
}

/// pos_wrap is bit 1 of the auxiliary byte, and sticks until it is cleared (DS-V 5.2).
TEST_F(StandingTexts, APositionThatWrappedIsTold) {
    constexpr std::uint8_t kWrapped = 0x02;
    servo().apply(sampleOf(3.0, kOk, kServoOn | kWrapped));
    ASSERT_THAT(keys(), ElementsAre("wrapped.1"));
    EXPECT_TRUE(texts::standing(link, atSeconds(3)).front().body.contains(u"find home"_s));
    servo().apply(sampleOf(3.1, kOk, kServoOn));
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, AMotorThatSwingsIsToldWithAWayBack) {
    const auto hold = [this](double from, int amplitude) {
        for (int i = 0; i < 200; ++i) {
            bus::Sample sample = sampleOf(from + i / 100.0, kOk, kServoOn);
            sample.report.position = i % 8 < 4 ? amplitude : -amplitude;
            servo().apply(sample);
        }
    };
    servo::SetGain gains = *servo().gains;
    gains.kp = static_cast<std::uint16_t>(gains.kp + 500);
    servo().apply(executedAt(2.0, gains));
    hold(3.0, 100);
    ASSERT_THAT(keys(), ElementsAre("swings.1"));
    const Message message = texts::standing(link, atSeconds(10)).front();
    EXPECT_TRUE(message.offers(MessageAction::SwitchOff));
    EXPECT_TRUE(message.offers(MessageAction::GainsBefore));
    hold(5.0, 0);
    EXPECT_THAT(keys(), IsEmpty());
    servo().apply(executedAt(7.0, stopWith(servo::StopManner::MotorOff)));
    EXPECT_THAT(keys(), IsEmpty());
}

TEST_F(StandingTexts, AModuleThatWasReplacedIsToldUntilItIsExpected) {
    servo().expected = ModuleIdentity{ModuleType::Servo, 3};
    EXPECT_THAT(keys(), ElementsAre("replaced.1"));
    EXPECT_TRUE(texts::standing(link, atSeconds(10)).front().body.contains(u"check these settings"_s));
    servo().expected = ModuleIdentity{ModuleType::Stepper, 1};
    EXPECT_THAT(keys(), ElementsAre("replaced.1"));
    EXPECT_TRUE(texts::standing(link, atSeconds(10)).front().body.contains(u"they are not used"_s));
    servo().silent = true;
    EXPECT_THAT(keys(), ElementsAre("silent.1"));
    servo().silent = false;
    servo().expected = servo().info.identity;
    EXPECT_THAT(keys(), IsEmpty());
}

}  // namespace
}  // namespace nmc

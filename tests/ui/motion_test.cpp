// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/motionof.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Motion : public WindowTest {
protected:
    Intent sent(qsizetype i = 0) { return intents.at(i).at(1).value<Intent>(); }
    void expectRefused(const QString& control, Refusal refusal) {
        EXPECT_FALSE(button(control)->isEnabled()) << control.toStdString();
        EXPECT_EQ(button(control)->toolTip(), texts::refusal(refusal)) << control.toStdString();
        EXPECT_EQ(button(control)->accessibleDescription(), texts::refusal(refusal));
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Motion, GoSendsPositionVelocityAndAccelerationInFixedPoint) {
    showServo();
    type(u"goalField"_s, u"-12000"_s);
    type(u"velocityField"_s, u"1,5"_s);
    type(u"accelerationField"_s, u"0.25"_s);
    click(u"goButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto go = test::motionOf<servomotion::Trapezoid>(sent());
    EXPECT_EQ(go.position.value(), -12000);
    EXPECT_EQ(go.velocity.value(), 98304U);      // 1.5 x 65536
    EXPECT_EQ(go.acceleration.value(), 16384U);  // 0.25 x 65536
    EXPECT_EQ(intents.at(0).at(0).value<ModuleIndex>(), ModuleIndex(0));
}

TEST_F(Motion, RunsBothWays) {
    showServo();
    click(u"runReverseButton"_s);
    showServo({.millisecond = 20});
    click(u"runForwardButton"_s);
    ASSERT_EQ(intents.size(), 2);
    EXPECT_TRUE(test::motionOf<servomotion::VelocityProfile>(sent(0)).reverse);
    EXPECT_FALSE(test::motionOf<servomotion::VelocityProfile>(sent(1)).reverse);
}

TEST_F(Motion, EnterInTheGoalStartsTheMoveAndElsewhereNothing) {
    showServo();
    QTest::keyClick(field(u"velocityField"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
    QTest::keyClick(field(u"goalField"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 1);
}

TEST_F(Motion, U07_ADoubleClickIsOneCommandUntilTheModuleHasSpoken) {
    showServo();
    QTest::mouseClick(button(u"goButton"_s), Qt::LeftButton);
    QTest::mouseClick(button(u"goButton"_s), Qt::LeftButton);
    QTest::mouseDClick(button(u"goButton"_s), Qt::LeftButton);
    EXPECT_EQ(intents.size(), 1);
    showServo({.millisecond = 10});
    click(u"goButton"_s);
    EXPECT_EQ(intents.size(), 2);
}

TEST_F(Motion, U07_AStatusThatWasOnItsWayEndsNoCommand) {
    showServo();
    click(u"goButton"_s);
    ModuleState module = Servo{.millisecond = 10}.state();
    module.awaited = bus::OperationId(1);
    window->showLink(connectedTo({module}));
    click(u"goButton"_s);
    EXPECT_EQ(intents.size(), 1) << "the command has not been answered yet";
    module.awaited.reset();
    window->showLink(connectedTo({module}));
    click(u"goButton"_s);
    EXPECT_EQ(intents.size(), 2);
}

TEST_F(Motion, StopsNeverWait) {
    showServo();
    click(u"goButton"_s);
    click(u"stopSmoothlyButton"_s);
    click(u"stopAbruptlyButton"_s);
    click(u"motorOffButton"_s);
    EXPECT_EQ(intents.size(), 4);
    EXPECT_TRUE(std::holds_alternative<intent::StopSmoothly>(sent(1)));
    EXPECT_TRUE(std::holds_alternative<intent::StopAbruptly>(sent(2)));
    EXPECT_TRUE(std::holds_alternative<intent::MotorOff>(sent(3)));
}

TEST_F(Motion, U01_OutOfRangeSendsNothing) {
    showServo();
    for (const QString& bad : {u"2147483648"_s, u"-99999999999"_s, u"1.5"_s, u"abc"_s, QString()}) {
        type(u"goalField"_s, bad);
        EXPECT_FALSE(button(u"goButton"_s)->isEnabled()) << bad.toStdString();
        QTest::keyClick(field(u"goalField"_s), Qt::Key_Return);
        click(u"goButton"_s);
    }
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Motion, ZeroAccelerationAndVelocitySayWhatTheyWouldDo) {
    showServo();
    type(u"velocityField"_s, u"0"_s);
    expectRefused(u"goButton"_s, Refusal::NoVelocity);
    type(u"velocityField"_s, u"1"_s);
    type(u"accelerationField"_s, u"0"_s);
    expectRefused(u"goButton"_s, Refusal::NoAcceleration);
    expectRefused(u"runForwardButton"_s, Refusal::NoAcceleration);
}

TEST_F(Motion, OneThatIsFasterThanTheAxisMayGoIsNotCalledZero) {
    machine.axes.resize(1);
    machine.axes[0].travel.fastest = 0.4;
    window->showMachine(machine);
    showServo();
    type(u"velocityField"_s, u"0.5"_s);
    EXPECT_FALSE(button(u"goButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"goButton"_s)->toolTip().contains(u" to 0.4 counts/tick."_s))
        << button(u"goButton"_s)->toolTip().toStdString();
}

TEST_F(Motion, ShowsEveryValueInSecondsAsWell) {
    showServo();
    type(u"velocityField"_s, u"1"_s);
    // 1 count per 0.512 ms is 1953.125 counts/s.
    EXPECT_EQ(text(u"velocityFieldPerSecond"_s), u"= 1\u202f953 counts/s"_s);
    type(u"accelerationField"_s, u"0.002"_s);
    // 0.002 / 0.000512^2 = 7629.4
    EXPECT_EQ(text(u"accelerationFieldPerSecond"_s), u"= 7\u202f629 counts/s²"_s);
}

TEST_F(Motion, ASlowerServoRateStretchesTheTick) {
    ModuleState module = Servo{}.state();
    module.servoRate = 10;
    window->showLink(connectedTo({module}));
    type(u"velocityField"_s, u"1"_s);
    EXPECT_EQ(text(u"velocityFieldPerSecond"_s), u"= 195.3 counts/s"_s);
}

TEST_F(Motion, WhatIsNotPossibleSaysWhy) {
    showServo({.on = false, .gains = false});
    expectRefused(u"enableButton"_s, Refusal::GainsUnknown);
    expectRefused(u"goButton"_s, Refusal::ServoOff);
    expectRefused(u"runForwardButton"_s, Refusal::ServoOff);
    expectRefused(u"holdForwardButton"_s, Refusal::ServoOff);
    expectRefused(u"stopAbruptlyButton"_s, Refusal::ServoOff);
    EXPECT_TRUE(button(u"motorOffButton"_s)->isEnabled());

    showServo({.on = false, .power = false});
    expectRefused(u"enableButton"_s, Refusal::NoPower);

    showServo({.on = true, .moveDone = false});
    expectRefused(u"goButton"_s, Refusal::Moving);
    expectRefused(u"zeroHereButton"_s, Refusal::Moving);
}

TEST_F(Motion, WithoutAConnectionNothingIsPossible) {
    showServo();
    LinkState lost = connectedTo({Servo{}.state()});
    lost.phase = LinkPhase::Lost;
    window->showLink(lost);
    for (const QString& control :
         {u"enableButton"_s, u"goButton"_s, u"runForwardButton"_s, u"holdForwardButton"_s,
          u"applyGainsButton"_s, u"motorOffButton"_s, u"clearStickyButton"_s})
        expectRefused(control, Refusal::NotConnected);
}

TEST_F(Motion, EnableIsOneIntent) {
    showServo({.on = false});
    click(u"enableButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::Enable>(sent()));
}

TEST_F(Motion, ShowingValuesEmitsNothing) {
    QSignalSpy released(&window->requests(), &Requests::holdReleased);
    showServos({{}, {.version = 2}});
    showServos({{}, {.version = 2}});
    EXPECT_EQ(intents.size() + released.size(), 0);
}

TEST_F(Motion, EveryConnectionBeginsWithLowSpeeds) {
    showServo();
    type(u"holdVelocityField"_s, u"100"_s);
    window->showLink({});
    LinkState connecting;
    connecting.phase = LinkPhase::Connecting;
    window->showLink(connecting);
    showServo();
    EXPECT_EQ(field(u"holdVelocityField"_s)->value(), 0.25);
}

/// This has happened: Scan again put 0 in place of the typed goal, and Enter turned the motor back to 0.
TEST_F(Motion, LookingAgainLeavesNoGoalToGoTo) {
    LinkState link = connectedTo({Servo{.position = 140}.state()});
    window->showLink(link);
    type(u"goalField"_s, u"140"_s);
    link.phase = LinkPhase::Connecting;
    link.looking = true;
    window->showLink(link);
    link.phase = LinkPhase::Connected;
    link.looking = false;
    window->showLink(link);
    EXPECT_EQ(field(u"goalField"_s)->text(), QString());
    for (const QString& name : {u"goButton"_s, u"loadButton"_s}) {
        EXPECT_FALSE(button(name)->isEnabled()) << name.toStdString();
        EXPECT_EQ(button(name)->toolTip(), field(u"goalField"_s)->problemText());
    }
    EXPECT_EQ(text(u"forecastLabel"_s), QString());
    QTest::keyClick(field(u"goalField"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
    type(u"goalField"_s, u"150"_s);
    EXPECT_TRUE(button(u"goButton"_s)->isEnabled());
}

TEST_F(Motion, EachModuleKeepsItsOwnNumbers) {
    showServos({{}, {}});
    type(u"goalField"_s, u"111"_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_EQ(field(u"goalField"_s)->value(), 0);
    chain->setCurrentIndex(chain->model()->index(0, 0));
    EXPECT_EQ(field(u"goalField"_s)->value(), 111);
}

TEST_F(Motion, HeadSaysStateInWordsAndPositionInFigures) {
    showServo({.position = -1234567});
    EXPECT_EQ(text(u"stateLabel"_s), u"Holding"_s);
    EXPECT_EQ(text(u"positionLabel"_s), u"\u22121\u202f234\u202f567"_s);
    EXPECT_EQ(text(u"positionUnit"_s), u"counts"_s);
}

TEST_F(Motion, AnOldPositionIsStruckOutWithItsAge) {
    ModuleState module = Servo{.position = 5}.state();
    module.silent = true;
    window->showLink(connectedTo({module}));
    window->showHistory(History(), module.latestTime + fromSeconds(2.3));
    EXPECT_TRUE(find<QLabel>(u"positionLabel"_s)->font().strikeOut());
    EXPECT_TRUE(text(u"positionUnit"_s).contains(u"2.3 s old"_s)) << text(u"positionUnit"_s).toStdString();
    EXPECT_EQ(text(u"stateLabel"_s), u"No answer"_s);
}

TEST_F(Motion, StatusBitsHaveTheirDataSheetNames) {
    showServo({.power = true});
    find<QTabWidget>(u"servoPages"_s)->setCurrentIndex(1);
    EXPECT_EQ(text(u"bit_power_on"_s), u"on"_s);
    EXPECT_EQ(text(u"bit_servo_on"_s), u"on"_s);
    EXPECT_EQ(text(u"bit_home_in_progress"_s), u"off"_s);
    click(u"clearStickyButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::ClearStickyBits>(sent()));
}

TEST_F(Motion, AMoveByItsShortcutIsOfTheModuleThatWasSeen) {
    showServo();
    QTest::keyClick(window.get(), Qt::Key_U, Qt::AltModifier);
    EXPECT_EQ(intents.size(), 1)
        << "at once, because soon another module may be selected, or nothing may be allowed";
    showServo({.millisecond = 20});
    QTest::keyClick(window.get(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(intents.size(), 2);
}

TEST_F(Motion, AStopByItsMnemonicDoesNotWaitForTheButtonToBeSeenPressed) {
    showServo({.moveDone = false});
    QTest::keyClick(window.get(), Qt::Key_S, Qt::AltModifier);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::StopSmoothly>(sent()));
}

}  // namespace
}  // namespace nmc

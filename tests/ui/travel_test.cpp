// SPDX-License-Identifier: GPL-3.0-or-later
// Travel and speed limits, as a user sets and meets them.
#include "tests/model/stepperfixture.h"
#include "tests/support/motionof.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class TravelPanel : public WindowTest {
protected:
    void enter(const QString& name, const QString& number) {
        type(name, number);
        QTest::keyClick(field(name), Qt::Key_Return);
    }
    TravelPanel() {
        window->resize(1500, 1100);
        standAt(0);
    }
    /// Shows a servo that holds there; home, if known, is where the counter is 0.
    void standAt(std::int32_t position, bool homed = true) {
        ModuleState module = Servo{.position = position, .millisecond = m_millisecond += 10}.state();
        if (homed)
            module.home.found(0, module.latestTime);
        window->showLink(connectedTo({module}));
    }
    void setLimits() {
        enter(u"lowestField"_s, u"-500"_s);
        enter(u"highestField"_s, u"1500"_s);
    }
    [[nodiscard]] const TravelSettings& kept() const { return machine.axes.at(0).travel; }
    template <typename T>
    [[nodiscard]] T lastIntent() {
        EXPECT_FALSE(intents.isEmpty());
        return std::get<T>(intents.last().at(1).value<Intent>());
    }
    QString whyNot(const QString& name) {
        auto* control = button(name);
        EXPECT_FALSE(control->isEnabled()) << name.toStdString();
        return control->toolTip();
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
    int m_millisecond = 0;
};

TEST_F(TravelPanel, WhatIsTypedIsKeptWithTheAxisAndSendsNothing) {
    setLimits();
    enter(u"fastestField"_s, u"1.5"_s);
    EXPECT_EQ(kept(), (TravelSettings{-500, 1'500, 1.5}));
    enter(u"highestField"_s, u" "_s);
    enter(u"fastestField"_s, u" "_s);
    EXPECT_EQ(kept(), (TravelSettings{-500, std::nullopt, 0.0})) << "an empty field means no limit";
    EXPECT_TRUE(intents.isEmpty());
}

TEST_F(TravelPanel, ItSaysWhetherTheyAreInForceAndWhyNot) {
    EXPECT_TRUE(text(u"travelState"_s).contains(u"No travel limits are set"_s));
    setLimits();
    EXPECT_EQ(text(u"travelState"_s), u"● In force: from −500 counts to 1\u202f500 counts."_s);
    EXPECT_EQ(text(u"headTravel"_s), QString());
    standAt(0, false);
    EXPECT_TRUE(text(u"travelState"_s).startsWith(u"▲ Not in force: home is unknown"_s));
    EXPECT_TRUE(text(u"headTravel"_s).contains(u"not in force"_s));
    EXPECT_EQ(kept().highest, 1'500);
}

TEST_F(TravelPanel, ARestartOfTheModuleTakesThemOutOfForce) {
    setLimits();
    ModuleState module = Servo{.position = 0, .millisecond = 500}.state();
    module.home.found(0, module.latestTime);
    module.restarted();
    window->showLink(connectedTo({module}));
    EXPECT_TRUE(text(u"travelState"_s).startsWith(u"▲ Not in force"_s));
}

TEST_F(TravelPanel, TheOfferOfANearerGoalMovesNothing) {
    setLimits();
    const auto places = [this] {
        QApplication::processEvents();
        std::vector<QPoint> found;
        for (const QString& name :
             {u"goButton"_s, u"zeroHereButton"_s, u"runForwardButton"_s, u"holdForwardButton"_s})
            found.push_back(button(name)->mapToGlobal(QPoint()));
        return found;
    };
    const auto before = places();
    type(u"goalField"_s, u"1600"_s);
    EXPECT_TRUE(button(u"nearestGoalButton"_s)->isVisible());
    EXPECT_EQ(places(), before);
}

/// This has happened: a limit at home and backlash left "Go home" grey for ever, with a reason that named a
/// limit of 50.
TEST_F(TravelPanel, SettingsThatExcludeEachOtherAreNamedWhereTheyRefuse) {
    standAt(400);
    enter(u"lowestField"_s, u"0"_s);
    EXPECT_TRUE(button(u"goHomeButton"_s)->isEnabled());
    enter(u"backlashField"_s, u"50"_s);
    const QString reason = whyNot(u"goHomeButton"_s);
    EXPECT_EQ(
        reason,
        u"To take up the backlash, the move would reverse at −50 counts, below the lowest position 0 counts. Lower that position, or change the backlash or its direction (Axis page)."_s);
    EXPECT_TRUE(text(u"travelHint"_s).startsWith(u"With this backlash, no move can end at home"_s))
        << "where it is entered, too";
    // Each of the three remedies that it names works.
    enter(u"lowestField"_s, u"-50"_s);
    EXPECT_TRUE(button(u"goHomeButton"_s)->isEnabled());
    EXPECT_EQ(text(u"travelHint"_s), QString());
    enter(u"lowestField"_s, u"0"_s);
    find<QComboBox>(u"backlashSideBox"_s)->setCurrentIndex(1);
    EXPECT_TRUE(button(u"goHomeButton"_s)->isEnabled());
    find<QComboBox>(u"backlashSideBox"_s)->setCurrentIndex(0);
    EXPECT_FALSE(button(u"goHomeButton"_s)->isEnabled());
    enter(u"backlashField"_s, u" "_s);
    EXPECT_TRUE(button(u"goHomeButton"_s)->isEnabled());
}

TEST_F(TravelPanel, ArrivalIsKeptWithTheAxisAndWhatMakesNoSenseIsNot) {
    enter(u"arrivalToleranceField"_s, u"25"_s);
    enter(u"arrivalDurationField"_s, u"0.2"_s);
    EXPECT_EQ(machine.axes.at(0).arrival, (ArrivalSettings{25, 0.2}));
    enter(u"arrivalToleranceField"_s, u"0"_s);
    EXPECT_EQ(machine.axes.at(0).arrival, (ArrivalSettings{25, 0.2}));
    EXPECT_TRUE(text(u"travelHint"_s).startsWith(u"Arrival tolerance must be"_s))
        << text(u"travelHint"_s).toStdString();
    enter(u"arrivalToleranceField"_s, u""_s);
    EXPECT_EQ(machine.axes.at(0).arrival.tolerance, 0.0) << "standstill again";
}

TEST_F(TravelPanel, AFieldWhoseRangeIsASettingSaysWhichOne) {
    enter(u"fastestField"_s, u"1.5"_s);
    type(u"velocityField"_s, u"2"_s);
    EXPECT_TRUE(whyNot(u"goButton"_s).endsWith(u"The highest velocity is set on the Axis page."_s))
        << button(u"goButton"_s)->toolTip().toStdString();
    type(u"holdVelocityField"_s, u"2"_s);
    EXPECT_TRUE(whyNot(u"holdForwardButton"_s).contains(u"set on the Axis page."_s));
}

TEST_F(TravelPanel, HalfANumberIsNoLimit) {
    setLimits();
    type(u"highestField"_s, u"2000"_s);
    EXPECT_EQ(kept().highest, 1'500) << "2, 20 and 200 would have stopped a moving motor";
    find<QWidget>(u"lowestField"_s)->setFocus();
    EXPECT_EQ(kept().highest, 2'000);
}

TEST_F(TravelPanel, LimitsThatCrossStayInTheirFieldsAndTheOldOnesInForce) {
    setLimits();
    enter(u"lowestField"_s, u"1500"_s);
    EXPECT_EQ(kept().lowest, -500);
    EXPECT_TRUE(text(u"travelHint"_s).contains(u"below the highest"_s));
    EXPECT_EQ(field(u"lowestField"_s)->text(), u"1500"_s);
    enter(u"lowestField"_s, u"x"_s);
    EXPECT_EQ(kept().lowest, -500);
}

TEST_F(TravelPanel, AGoalBeyondIsRefusedAndTheNearestOneOffered) {
    setLimits();
    type(u"goalField"_s, u"1600"_s);
    EXPECT_EQ(whyNot(u"goButton"_s),
              u"That is beyond the travel limits: the highest position is 1\u202f500 counts (Axis page)."_s);
    EXPECT_TRUE(text(u"motionHint"_s).contains(u"1\u202f500 counts"_s));
    whyNot(u"loadButton"_s);
    QTest::keyClick(field(u"goalField"_s), Qt::Key_Return);
    EXPECT_TRUE(intents.isEmpty()) << "Enter does not send it either";
    ASSERT_TRUE(button(u"nearestGoalButton"_s)->isVisible());
    EXPECT_EQ(button(u"nearestGoalButton"_s)->text(), u"Use 1\u202f500 counts"_s);
    click(u"nearestGoalButton"_s);
    EXPECT_EQ(field(u"goalField"_s)->value(), 1'500);
    EXPECT_FALSE(button(u"nearestGoalButton"_s)->isVisible());
    EXPECT_TRUE(intents.isEmpty()) << "using it moves nothing";
    click(u"goButton"_s);
    EXPECT_EQ(test::motionOf<servomotion::Trapezoid>(lastIntent<intent::Move>()).position.value(), 1'500);
}

TEST_F(TravelPanel, AtALimitThereIsOnlyTheWayBack) {
    setLimits();
    standAt(1'500);
    EXPECT_EQ(text(u"headTravel"_s), u"● At the highest position"_s);
    const QString reason = u"Highest position reached: 1\u202f500 counts. Move in reverse."_s;
    EXPECT_EQ(whyNot(u"runForwardButton"_s), reason);
    EXPECT_EQ(whyNot(u"holdForwardButton"_s), reason);
    whyNot(u"moveByForwardButton"_s);
    EXPECT_TRUE(button(u"runReverseButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"holdReverseButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"moveByReverseButton"_s)->isEnabled());
    standAt(1'700);
    EXPECT_EQ(text(u"headTravel"_s), u"▲ Above the highest position"_s);
    EXPECT_TRUE(button(u"runReverseButton"_s)->isEnabled());
}

TEST_F(TravelPanel, NoFieldTakesMoreThanTheHighestVelocity) {
    enter(u"fastestField"_s, u"1.5"_s);
    for (const auto& [velocity, act] : {std::pair(u"velocityField"_s, u"goButton"_s),
                                        std::pair(u"runVelocityField"_s, u"runForwardButton"_s),
                                        std::pair(u"holdVelocityField"_s, u"holdForwardButton"_s)}) {
        type(velocity, u"1.6"_s);
        EXPECT_TRUE(whyNot(act).contains(u"to 1.5 counts/tick"_s)) << whyNot(act).toStdString();
        type(velocity, u"1.5"_s);
        EXPECT_TRUE(button(act)->isEnabled());
    }
    click(u"runForwardButton"_s);
    EXPECT_EQ(test::motionOf<servomotion::VelocityProfile>(lastIntent<intent::Move>()).velocity.value(),
              98'304U);
}

TEST_F(TravelPanel, NoFieldTakesMoreThanTheChip) {
    window->showLink(connectedTo({Servo{.version = 10}.state()}));
    for (const auto& [velocity, act] : {std::pair(u"velocityField"_s, u"goButton"_s),
                                        std::pair(u"runVelocityField"_s, u"runForwardButton"_s)}) {
        type(velocity, u"1281"_s);
        EXPECT_TRUE(whyNot(act).contains(u"to 1280 counts/tick"_s)) << whyNot(act).toStdString();
        type(velocity, u"1280"_s);
        EXPECT_TRUE(button(act)->isEnabled());
    }
    enter(u"fastestField"_s, u"1281"_s);
    EXPECT_TRUE(text(u"travelHint"_s).contains(u"to 1280 counts/tick"_s))
        << text(u"travelHint"_s).toStdString();
    EXPECT_EQ(kept().fastest, 0.0);
}

TEST_F(TravelPanel, AVelocityThatAHigherLimitAllowsIsSent) {
    standAt(500);
    enter(u"fastestField"_s, u"1.5"_s);
    type(u"velocityField"_s, u"2"_s);
    whyNot(u"goHomeButton"_s);
    enter(u"fastestField"_s, u"3"_s);
    EXPECT_EQ(field(u"velocityField"_s)->text(), u"2"_s);
    click(u"goHomeButton"_s);
    const Pace pace = lastIntent<intent::GoHome>().pace;
    EXPECT_EQ(std::get<ServoPace>(pace).velocity.value(), 131'072U);
}

TEST_F(TravelPanel, ThePresentPositionBecomesALimit) {
    standAt(1'234);
    click(u"highestHereButton"_s);
    EXPECT_EQ(kept().highest, 1'234);
    standAt(0, false);
    EXPECT_TRUE(whyNot(u"lowestHereButton"_s).contains(u"Home"_s)) << "there is nothing to count from";
}

TEST_F(TravelPanel, AnOldPositionBecomesNoLimit) {
    ModuleState module = Servo{.position = 1'234, .millisecond = m_millisecond += 10}.state();
    module.home.found(0, module.latestTime);
    module.silent = true;
    window->showLink(connectedTo({module}));
    for (const QString& here : {u"lowestHereButton"_s, u"highestHereButton"_s})
        EXPECT_EQ(whyNot(here), texts::refusal(Refusal::PositionUnknown));
}

TEST_F(TravelPanel, ThePositionIsDeclaredRightAfterAQuestion) {
    setLimits();
    standAt(700, false);
    click(u"declarePositionButton"_s);
    auto* question = window->findChild<AskDialog*>(u"declarePositionDialog"_s);
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->findChild<QLabel*>(u"closeText"_s)->text().contains(u"700 counts"_s));
    EXPECT_TRUE(intents.isEmpty());
    QTest::mouseClick(question->findChild<QAbstractButton*>(u"positionIsRightButton"_s), Qt::LeftButton);
    EXPECT_TRUE(lastIntent<intent::DeclarePosition>().right);
    standAt(700);
    click(u"doubtPositionButton"_s);
    EXPECT_FALSE(lastIntent<intent::DeclarePosition>().right);
}

TEST_F(TravelPanel, AStepperHasTheSamePage) {
    testing_support::Stepper stepper = testing_support::Stepper::holding();
    stepper.module.home.found(0, stepper.time);
    window->showLink(connectedTo({stepper.module}));
    type(u"stepperHighestField"_s, u"300"_s);
    type(u"stepperGoalField"_s, u"301"_s);
    EXPECT_TRUE(whyNot(u"stepperGoButton"_s).contains(u"300 steps"_s));
    click(u"stepperNearestGoalButton"_s);
    click(u"stepperGoButton"_s);
    const auto move = test::motionOf<steppermotion::Trapezoid>(lastIntent<intent::Move>());
    EXPECT_EQ(move.position, 300);
    EXPECT_FALSE(move.relative);
}

}  // namespace
}  // namespace nmc

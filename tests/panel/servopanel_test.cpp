// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that the servo's panel can request, in the whole program by object name, with the simulator.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class ServoPage : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal())); }
    void show(const char* page) { panel.find(page); }
    void click(const char* name) {
        ASSERT_TRUE(panel.waitFor([&] { return panel.find<QAbstractButton>(name).isEnabled(); }))
            << name << ": " << panel.find<QAbstractButton>(name).toolTip().toStdString();
        testing_support::clickOn(panel.find<QAbstractButton>(name));
    }
    /// True if the simulated motor arrives there.
    bool arrives(int number, int position) {
        return panel.waitFor(
            [&] { return std::abs(sim.state(number)[u"position"_s].toInt() - position) <= 3; });
    }
    VirtualChain sim{u"servo,servo,servo"_s};
    VirtualPanel panel;
};

TEST_F(ServoPage, LoadsNowAndStartsLaterByADistance) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    click("saveHomeButton");
    panel.find<QComboBox>("goalKindBox").setCurrentIndex(1);
    panel.type("goalField", u"600"_s);
    panel.type("velocityField", u"2"_s);
    panel.type("accelerationField", u"0,02"_s);
    click("loadButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(0).loadWaiting; }));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 3) << "nothing moves before the start";
    click("startButton");
    EXPECT_TRUE(arrives(1, 600));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module(0).moving(); }));
    click("goHomeButton");
    EXPECT_TRUE(arrives(1, 0));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, StopsHereInTheMiddleOfARun) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    panel.type("accelerationField", u"0.02"_s);
    click("runForwardButton");
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    click("stopHereButton");
    EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim); }));
    EXPECT_TRUE(sim.state(1)[u"servo_on"_s].toBool());
    EXPECT_EQ(sim.violations(), "");
}

/// The command has been sent, but no answer has shown a motion yet.
TEST_F(ServoPage, LeavingRightBehindAStartAsksAsWhileItMoves) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    ASSERT_TRUE(panel.answersFor(0.3));
    QTest::mouseClick(&panel.find<QAbstractButton>("runForwardButton"), Qt::LeftButton);
    EXPECT_FALSE(panel.module(0).moving());
    QTest::mouseClick(&panel.find<QAbstractButton>("disconnectButton"), Qt::LeftButton);
    ASSERT_NE(panel.window().findChild<QAbstractButton*>(u"stopAndCloseButton"_s), nullptr);
    EXPECT_TRUE(panel.composition().worker().isOpen());
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim) && !panel.module(0).moving(); }));
}

TEST_F(ServoPage, StepsThereAndBackAsOftenAsAsked) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    panel.type("velocityField", u"4"_s);
    panel.type("accelerationField", u"0.05"_s);
    panel.type("moveByDistanceField", u"250"_s);
    panel.type("moveByRoundsField", u"3"_s);
    click("moveByForwardButton");
    EXPECT_TRUE(arrives(1, 750));
    ASSERT_TRUE(panel.waitFor([&] { return panel.find<QLabel>("moveByProgress").text() == u"Done"_s; }))
        << panel.find<QLabel>("moveByProgress").text().toStdString();
    panel.find<QCheckBox>("moveByBackAndForthBox").setChecked(true);
    panel.type("moveByRoundsField", u"1000"_s);
    click("moveByReverseButton");
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    click("moveByEndButton");
    EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim) && !panel.module(0).moving(); }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, DrivesByPwmUntilItIsSwitchedOff) {
    panel.select(0);
    show("pwmBox");
    panel.type("pwmField", u"60"_s);
    click("pwmReverseButton");
    ASSERT_TRUE(panel.waitFor([&] { return sim.state(1)[u"position"_s].toInt() < -50; }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(0).activity() == Activity::PwmMode; }));
    click("pwmOffButton");
    EXPECT_TRUE(panel.waitFor([&] { return sim.state(1)[u"pwm"_s].toInt() == 0; }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, ALimitPinAndTheAmplifierFollowTheirControls) {
    panel.select(0);
    show("ioBox");
    auto& use = panel.find<QComboBox>("limit1UseBox");
    use.setFocus();
    QTest::keyClick(&use, Qt::Key_End);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module(0).io.has_value(); }));
    EXPECT_FALSE(panel.module(0).io->limit1IsInput);
    EXPECT_TRUE(panel.waitFor([&] { return panel.find<QLabel>("limit1Value").text() == u"high"_s; }));
    click("amplifierBox");
    EXPECT_TRUE(panel.waitFor([&] { return panel.find<QCheckBox>("amplifierBox").isChecked(); }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, MovesInTurns) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    show("axisBox");
    auto& unit = panel.find<QComboBox>("axisUnitBox");
    unit.setCurrentIndex(unit.findText(u"turns"_s));
    panel.type("countsPerUnitField", u"2000"_s);
    panel.find<QAction>("chainDoctorAction").trigger();
    EXPECT_EQ(panel.find<QLabel>("chainFinding").text(), u"Chain OK: 3 modules."_s)
        << "a user who names one axis means the chain that is connected";
    panel.find<QWidget>("chainDialog").close();
    panel.type("goalField", u"0.5"_s);
    panel.type("velocityField", u"4"_s);  // turns/s: 4.096 counts/tick
    panel.type("accelerationField", u"40"_s);
    click("goButton");
    EXPECT_TRUE(arrives(1, 1'000));
    EXPECT_TRUE(panel.waitFor([&] {
        return panel.find<QLabel>("positionLabel").text().startsWith(u"0.50"_s) ||
               panel.find<QLabel>("positionLabel").text().startsWith(u"0.49"_s);
    }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, AGroupStartsItsLoadedMovesTogether) {
    for (const std::uint8_t index : {std::uint8_t{0}, std::uint8_t{1}}) {
        ASSERT_NO_FATAL_FAILURE(panel.makeReady(index));
        panel.type("goalField", u"4000"_s);
        panel.type("velocityField", u"4"_s);
        panel.type("accelerationField", u"0.05"_s);
        click("loadButton");
        ASSERT_TRUE(panel.waitFor([&] { return panel.module(index).loadWaiting; }));
    }
    panel.find<QAction>("groupsAction").trigger();
    for (const char* box : {"group1Box", "group2Box"}) {
        auto& group = panel.find<QComboBox>(box);
        group.setFocus();
        QTest::keyClick(&group, Qt::Key_Down);
        ASSERT_TRUE(panel.waitFor([&] {
            const auto& place = panel.module(box == std::string("group1Box") ? 0 : 1).info.group;
            return place && place->group == 0x81;
        }));
    }
    click("groupStartButton");
    EXPECT_TRUE(arrives(1, 4'000));
    EXPECT_TRUE(arrives(2, 4'000));
    click("groupHomeButton");
    // The motor may still be settling when home is captured.
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(sim.state(2)[u"home"_s].toInt() - 4'000) <= 50; }))
        << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_EQ(sim.state(3)[u"home"_s].toInt(), 0) << "it is in no group";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(ServoPage, TheChainChangesItsRateAndKeepsItsPositions) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    panel.type("goalField", u"300"_s);
    panel.type("velocityField", u"4"_s);
    panel.type("accelerationField", u"0.05"_s);
    click("goButton");
    ASSERT_TRUE(arrives(1, 300));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module(0).moving(); }));
    panel.find<QAction>("rateAction").trigger();
    auto& rate = panel.find<QComboBox>("chainRateBox");
    rate.setCurrentIndex(rate.findData(57'600));
    click("changeRateButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().baud == 57'600; }));
    const TimePoint before = panel.module(0).latestTime;
    EXPECT_TRUE(panel.waitFor([&] { return panel.module(0).latestTime > before + fromSeconds(0.2); }))
        << "it still answers";
    EXPECT_TRUE(panel.module(0).servoOn());
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 300, 3);
    EXPECT_EQ(sim.violations(), "");
}

/// A step ends once its motor was seen at rest. A user who jogs before that wants something else: the step's
/// own stop must not be sent after the start of the jog.
TEST_F(ServoPage, AJogTakesOverFromAStepWhereverThatIs) {
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
    const auto place = [&] { return sim.state(1)[u"position"_s].toDouble(); };
    for (const double left : {1'000.0, 40.0, 3.0}) {
        ASSERT_NO_FATAL_FAILURE(panel.type("moveByDistanceField", u"2000"_s));
        const double goal = place() + 2'000;
        ASSERT_NO_FATAL_FAILURE(click("moveByForwardButton"));
        ASSERT_TRUE(panel.waitFor([&] { return place() > goal - left; })) << left;
        auto& hold = panel.find<QAbstractButton>("holdReverseButton");
        ASSERT_TRUE(panel.waitFor([&] { return hold.isEnabled(); })) << hold.toolTip().toStdString();
        QTest::mousePress(&hold, Qt::LeftButton);
        EXPECT_TRUE(panel.waitFor([&] { return place() < goal - left - 200; })) << left << ": " << place();
        QTest::mouseRelease(&hold, Qt::LeftButton);
        EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim); }));
        ASSERT_TRUE(panel.answersFor(0.5));
    }
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

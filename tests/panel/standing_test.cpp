// SPDX-License-Identifier: GPL-3.0-or-later
// A fault is shown as long as it lasts, and only for the chain that has it.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class Standing : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim)); }
    void click(const QString& name) {
        auto* button = panel.window().findChild<QAbstractButton*>(name);
        ASSERT_NE(button, nullptr) << name.toStdString();
        ASSERT_TRUE(panel.waitFor([&] { return button->isEnabled(); })) << name.toStdString();
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// Runs the motor into a hard stop, until its servo switches itself off.
    void trip() {
        (void)sim.control(u"set 1 travel_max 30000"_s);
        ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"switched its servo off"_s) != nullptr; }))
            << panel.headlines().join(u" | "_s).toStdString();
    }
    bool isOver(const QString& headline) {
        return panel.count(headline) > 0 && panel.standing(headline) == nullptr;
    }
    [[nodiscard]] bool offersToClear() {
        return panel.window().findChild<QPushButton*>(u"bannerAction_clearAndStayOff"_s) != nullptr ||
               panel.window().findChild<QPushButton*>(u"listAction_clearAndStayOff"_s) != nullptr;
    }

    VirtualChain sim{u"servo,servo"_s};
    VirtualChain other{u"servo,servo"_s};
    VirtualPanel panel;
};

TEST_F(Standing, ATripIsOverWhenTheServoIsOnAgain) {
    ASSERT_NO_FATAL_FAILURE(trip());
    EXPECT_TRUE(offersToClear());
    EXPECT_TRUE(panel.window().findChild<QWidget*>(u"banner"_s)->isVisible());
    click(u"enableButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return isOver(u"switched its servo off"_s); }));
    EXPECT_FALSE(offersToClear());
}

TEST_F(Standing, ATripIsOverWhenTheMotorIsSwitchedOff) {
    ASSERT_NO_FATAL_FAILURE(trip());
    click(u"motorOffButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return isOver(u"switched its servo off"_s); }));
}

TEST_F(Standing, MissingPowerIsToldUntilTheServoIsOnAgain) {
    (void)sim.control(u"set 1 power 0"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"has no motor power"_s) != nullptr; }));
    (void)sim.control(u"set 1 power 1"_s);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NE(panel.standing(u"has no motor power"_s), nullptr) << "its servo is still off";
    click(u"enableButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return isOver(u"has no motor power"_s); }));
}

TEST_F(Standing, ARestartedModuleIsOverWithTheRestartOfTheNetwork) {
    (void)sim.control(u"power-cycle 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"restarted"_s) != nullptr; }))
        << panel.headlines().join(u" | "_s).toStdString();
    panel.window().findChild<QAction*>(u"restartNetworkAction"_s)->trigger();
    click(u"restartButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return panel.connected() && isOver(u"restarted"_s); }))
        << panel.headlines().join(u" | "_s).toStdString();
}

TEST_F(Standing, AFaultOfAnotherChainActsOnNobody) {
    ASSERT_NO_FATAL_FAILURE(trip());
    click(u"disconnectButton"_s);
    ASSERT_TRUE(
        panel.waitFor([&] { return panel.composition().store().link().phase == LinkPhase::Disconnected; }));
    EXPECT_TRUE(isOver(u"switched its servo off"_s));
    EXPECT_FALSE(offersToClear());
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(other.terminal()));
    EXPECT_FALSE(offersToClear()) << "it would switch the new module 1 off";
    EXPECT_TRUE(isOver(u"switched its servo off"_s));
}

TEST_F(Standing, ARefusalIsOverWhenTheModuleObeysAgain) {
    panel.ask(
        intent::Move{servomotion::Trapezoid{Counts(100), CountsPerTick(65'536), CountsPerTickSquared(100)}});
    const QString refused = u"Module 1 cannot do this now"_s;
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(refused) != nullptr; })) << "the motor is running";
    click(u"stopAbruptlyButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return isOver(refused); }));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST_F(Standing, ALimitThatClosesOnTheWayIsOverWhenItOpens) {
    (void)sim.control(u"set 1 limit1 1"_s);
    const QString closed = u"Limit switch 1 of module 1 closed while its motor was moving"_s;
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(closed) != nullptr; }))
        << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_TRUE(moves(sim)) << "as the message says";
    EXPECT_TRUE(panel.press(closed, u"STOP ALL"_s));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    (void)sim.control(u"set 1 limit1 0"_s);
    EXPECT_TRUE(panel.waitFor([&] { return isOver(closed); }));
}

TEST_F(Standing, ALimitStopThatTripsIsOverWhenItIsDisarmed) {
    panel.ask(intent::ArmLimitStop{true, true, HomingRecipe::Stop::Abruptly});
    ASSERT_TRUE(panel.waitFor([&] {
        return panel.module().homing.state() == HomeWatch::State::Armed &&
               panel.module().latest->servoStatus().homeInProgress();
    }));
    (void)sim.control(u"set 1 limit1 1"_s);
    const QString tripped = u"The limit stop of module 1 stopped its motor"_s;
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(tripped) != nullptr; }))
        << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_EQ(panel.count(u"closed while its motor"_s), 0) << "one cause gives one message";
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    panel.ask(intent::ArmLimitStop{});
    EXPECT_TRUE(panel.waitFor([&] { return isOver(tripped); }));
}

TEST_F(Standing, AFaultLeavesWithItsConnectionAndIsNotOfferedInTheNext) {
    (void)sim.control(u"set 1 limit1 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(u"Limit switch 1 of module 1"_s) != nullptr; }));
    emit panel.window().connectRequested(other.terminal(), 115'200);
    ASSERT_TRUE(panel.waitFor([&] { return panel.chainsFound() == 2; }));
    EXPECT_TRUE(isOver(u"Limit switch 1 of module 1"_s));
    EXPECT_EQ(panel.window().findChild<QPushButton*>(u"bannerAction_stopAll"_s), nullptr);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// The homing page in the whole program, by object name, with the simulator, which knows where home is.
#include "model/intent/homingplan.h"
#include "tests/support/virtualpanel.h"
#include "widgets/axes/axespage.h"
#include "widgets/common/lazydock.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

class HomingPage : public testing::Test {
protected:
    /// Connects, sends gains, enables the servo, and shows the homing page.
    void begin() {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        // Limit 1 is at -700, limit 2 at 9 000; the shaft is on its index.
        for (const QString& line :
             {u"set 1 travel_min -700"_s, u"set 1 travel_max 9000"_s, u"set 1 limits auto"_s})
            std::ignore = sim.control(line);
        ASSERT_NO_FATAL_FAILURE(panel.enable(4'000));
        panel.window().resize(1'500, 1'100);  // all of the panel is visible
        panel.find("homingBox");
        ASSERT_TRUE(panel.waitFor([&] { return button("homeButton")->isEnabled(); }))
            << button("homeButton")->toolTip().toStdString();
    }
    QAbstractButton* button(const char* name) { return &panel.find<QAbstractButton>(name); }
    QString text(const char* label) { return panel.find<QLabel>(label).text(); }
    void click(const char* name) {
        ASSERT_TRUE(panel.waitFor([&] { return button(name)->isEnabled(); }))
            << name << ": " << button(name)->toolTip().toStdString();
        testing_support::clickOn(*button(name));
    }
    bool waitForResult(const QString& words) {
        const bool came = panel.waitFor([&] { return text("homingResultLabel").contains(words); });
        EXPECT_TRUE(came) << text("homingResultLabel").toStdString();
        return came;
    }
    /// Begins a slow search.
    void search() {
        ASSERT_NO_FATAL_FAILURE(begin());
        panel.type("homingVelocityField", u"0.2"_s);
        click("homeButton");
        ASSERT_TRUE(waitForResult(u"Searching"_s));
    }
    VirtualChain sim{u"servo,servo"_s};
    VirtualChain stepFirst{u"step,servo"_s};
    VirtualPanel panel;
};

TEST_F(HomingPage, FindsTheLimitGoesThereAndMakesItZero) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.type("homingVelocityField", u"1,5"_s);
    click("homeButton");
    EXPECT_TRUE(panel.waitFor([&] { return button("cancelHomingButton")->isEnabled(); }));
    EXPECT_FALSE(button("homeButton")->isEnabled());
    EXPECT_FALSE(button("onLimit2Box")->isEnabled()) << "the search has begun with its settings";
    ASSERT_TRUE(waitForResult(u"Done: home was at"_s));
    EXPECT_TRUE(text("homingResultLabel").contains(u"700 counts"_s) ||
                text("homingResultLabel").contains(u"701 counts"_s))
        << text("homingResultLabel").toStdString();
    const QJsonObject truth = sim.state(1);
    EXPECT_NEAR(truth[u"position"_s].toInt(), 0, 2);
    EXPECT_TRUE(truth[u"limit1"_s].toBool()) << "0 is where the switch closes";
    EXPECT_TRUE(truth[u"servo_on"_s].toBool());
    EXPECT_EQ(panel.count(u"found home"_s), 1);
    EXPECT_EQ(panel.count(u"imit"_s), 0)
        << "the switch was searched for: it is neither a limit that closed nor a limit stop";
    EXPECT_TRUE(panel.waitFor([&] { return button("homeButton")->isEnabled(); }));
    EXPECT_EQ(sim.violations(), "");
}

/// The shaft is where it should be, whatever its counter was set to: home is where limit 1 closes, at -700.
TEST_F(HomingPage, GoHomeAfterAZeroGoesWhereHomeIs) {
    ASSERT_NO_FATAL_FAILURE(begin());
    const auto shaft = [&] { return sim.state(1)[u"shaft"_s].toDouble(); };
    EXPECT_FALSE(button("goHomeButton")->isEnabled()) << "home has not been searched for";
    EXPECT_EQ(text("homeState"), u"Home: unknown"_s);
    panel.type("homingVelocityField", u"1,5"_s);
    click("homeButton");
    ASSERT_TRUE(waitForResult(u"Done: home was at"_s));
    const double home = shaft();
    EXPECT_NEAR(home, -700, 3);
    EXPECT_NEAR(sim.state(1)[u"home"_s].toInt(), -700, 3) << "the register is left as it was";
    ASSERT_TRUE(panel.module().home.place());
    EXPECT_NEAR(panel.module().home.place()->counts, 0, 2);
    click("goHomeButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().motion == MotionMode::Trapezoidal; }));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().moving(); }));
    EXPECT_NEAR(shaft(), home, 3) << "it is already there";
    panel.type("goalField", u"500"_s);
    click("goButton");
    ASSERT_TRUE(panel.waitFor([&] { return std::abs(shaft() - home - 500) <= 3; }));
    click("zeroHereButton");
    ASSERT_TRUE(panel.waitFor([&] {
        const auto& place = panel.module().home.place();
        return place && std::abs(place->counts + 500) <= 5;
    })) << text("homeState").toStdString();
    click("goHomeButton");
    ASSERT_TRUE(panel.waitFor([&] { return std::abs(shaft() - home) <= 3; }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, AnOperatorWhoMayHomeAndNothingElseHomesAllAxes) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.type("homingVelocityField", u"1,5"_s);
    ASSERT_TRUE(panel.waitFor([&] {
        const auto& homing = panel.composition().machine().axis(ModuleIndex(0)).homing;
        return homing && homing->velocity > 0;
    }));
    panel.window().findChild<QAction*>(u"operatorAction"_s)->trigger();
    for (const char* name : {"operatorEnableBox", "operatorJogBox", "operatorPointsBox"})
        panel.window().findChild<QCheckBox*>(QLatin1String(name))->setChecked(false);
    panel.window().findChild<QCheckBox*>(u"operatorHomingBox"_s)->setChecked(true);
    for (const char* name : {"operatorPinField", "operatorPinAgainField"})
        QTest::keyClicks(panel.window().findChild<QLineEdit*>(QLatin1String(name)), u"4711"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("operatorBeginButton"));
    panel.window().axes().show();
    panel.window().axes().raise();
    click("homeAllButton");
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    EXPECT_EQ(button("homeAllButton")->toolTip(), u"A sequence is already running."_s);
    EXPECT_FALSE(button("homeAllButton")->isEnabled());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
    EXPECT_TRUE(panel.waitFor([&] { return button("homeAllButton")->isEnabled(); }))
        << button("homeAllButton")->toolTip().toStdString();
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, ScanAgainEndsTheSearchForHomeAndThenLooks) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.type("homingVelocityField", u"0.2"_s);
    click("homeButton");
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_F5);
    EXPECT_TRUE(panel.waitFor([&] { return panel.chainsFound() == 2; }));
    EXPECT_FALSE(testing_support::moves(sim)) << "no motor is left to a search that nothing supervises";
    EXPECT_EQ(sim.violations(), "");
}

/// The search waits until the motor has stopped. It would stop what was begun meanwhile, too.
TEST_F(HomingPage, ScanAgainIsDroppedForAMoveOfOtherAxes) {
    ASSERT_NO_FATAL_FAILURE(begin());
    const auto tell = [&](const Intent& intent) {
        emit panel.window().requests().intent(ModuleIndex(1), intent);
    };
    const auto second = [&] { return *panel.composition().store().module(ModuleIndex(1)); };
    tell(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}}});
    ASSERT_TRUE(panel.waitFor([&] { return second().gains.has_value(); }));
    tell(intent::Enable{});
    ASSERT_TRUE(panel.waitFor([&] { return second().servoOn(); }));
    panel.type("homingVelocityField", u"0.2"_s);
    click("homeButton");
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    panel.window().findChild<QAction*>(u"scanAction"_s)->trigger();
    emit panel.window().requests().goToPlace({"Away", {{ModuleIndex(1), 5'000, false}}});
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(sim.state(2)[u"position"_s].toInt() - 5'000) < 5; }));
    EXPECT_EQ(panel.chainsFound(), 1);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, TheIndexBehindTheLimit) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.type("homingVelocityField", u"1.5"_s);
    click("thenIndexBox");
    panel.type("homingIndexVelocityField", u"0.3"_s);
    click("makeZeroBox");
    EXPECT_TRUE(text("homingStagesLabel").contains(u"Searching\u00A0for\u00A0the\u00A0index"_s));
    click("homeButton");
    ASSERT_TRUE(waitForResult(u"Done"_s));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 2)
        << "it started on the index, and did not make it zero";
    EXPECT_NEAR(sim.state(1)[u"home"_s].toInt(), 0, 1);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, AHardStopIsHomeAndNoTrip) {
    ASSERT_NO_FATAL_FAILURE(begin());
    panel.ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 150, 1, std::uint8_t{0}}});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->el == 150; }));
    panel.type("homingVelocityField", u"1.5"_s);
    click("onLimit1Box");
    click("onPositionErrorBox");
    click("goToHomeBox");
    click("homeButton");
    ASSERT_TRUE(waitForResult(u"Done: home was at"_s));
    const QJsonObject truth = sim.state(1);
    EXPECT_NEAR(truth[u"home"_s].toInt(), -700, 3);
    EXPECT_FALSE(truth[u"servo_on"_s].toBool());
    EXPECT_EQ(panel.module().activity(), Activity::ServoOff);
    EXPECT_EQ(panel.count(u"switched its servo off"_s), 0);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, M15_AModuleThatFallsSilentIsNotHomedAndToldToStop) {
    ASSERT_NO_FATAL_FAILURE(search());
    ASSERT_TRUE(panel.waitFor([&] { return *panel.module().latest->position < -60; }));
    // It receives and carries out commands, but its answers are lost.
    EXPECT_FALSE(sim.control(u"fault module 1 drop status for=4s"_s).contains(u"error"_s));
    ASSERT_TRUE(waitForResult(u"Failed"_s));
    EXPECT_EQ(panel.count(u"is not homed"_s), 1) << panel.headlines().join(u'\n').toStdString();
    EXPECT_EQ(panel.count(u"found home"_s), 0);
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_GT(sim.state(1)[u"position"_s].toInt(), -690);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, AStepperFindsItsHomeSwitchToo) {
    panel.composition().show({stepFirst.terminal(), 115'200, false});
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && panel.module().latest.has_value(); }));
    std::ignore = stepFirst.control(u"set 1 home_switch_at 600"_s);
    const stepper::SetParameters parameters{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0};
    panel.composition().worker().ask(bus::Operation{
        bus::OperationId(1'000'000),
        {{ModuleIndex(0), StepperCommand(parameters)},
         {ModuleIndex(0), StepperCommand(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})}}});
    ASSERT_TRUE(panel.waitFor([&] { return !whyNot(IntentKind::Home, panel.module()); }));
    HomingRecipe recipe = firstRecipe({ModuleType::Stepper, 1});
    recipe.reverse = false;
    panel.ask(intent::Home{recipe});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"found home"_s) == 1; }))
        << panel.headlines().join(u'\n').toStdString();
    EXPECT_EQ(stepFirst.state(1)[u"position"_s].toInt(), 0);
    EXPECT_NEAR(stepFirst.state(1)[u"home"_s].toInt(), 600, 1);
    EXPECT_EQ(stepFirst.violations(), "");
}

TEST_F(HomingPage, CancelStopsTheMotor) {
    ASSERT_NO_FATAL_FAILURE(search());
    ASSERT_TRUE(panel.waitFor([&] { return *panel.module().latest->position < -60; }));
    click("cancelHomingButton");
    ASSERT_TRUE(waitForResult(u"Cancelled"_s));
    EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim); }));
    EXPECT_TRUE(sim.state(1)[u"servo_on"_s].toBool()) << "it still holds";
    EXPECT_FALSE(panel.module().latest->servoStatus().homeInProgress());
    EXPECT_GT(sim.state(1)[u"position"_s].toInt(), -690);
    EXPECT_EQ(sim.violations(), "");
}

struct Other {
    const char* button;
    bool servoOn;  ///< after the search has ended
};

class OtherWish : public HomingPage, public testing::WithParamInterface<Other> {};

/// Any other request ends the search, and leaves the motor as that request wants it.
TEST_P(OtherWish, EndsTheSearchAndIsNotUndone) {
    const char* const name = GetParam().button;
    ASSERT_NO_FATAL_FAILURE(search());
    ASSERT_TRUE(panel.waitFor([&] { return *panel.module().latest->position < -60; }));
    ASSERT_TRUE(panel.waitFor([&] { return button(name)->isEnabled(); }))
        << button(name)->toolTip().toStdString();
    QTest::mouseClick(button(name), Qt::LeftButton);
    ASSERT_TRUE(waitForResult(u"Cancelled"_s));
    EXPECT_TRUE(panel.waitFor([&] {
        return !panel.module().latest->servoStatus().homeInProgress() && !testing_support::moves(sim);
    }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(sim.state(1)[u"servo_on"_s].toBool(), GetParam().servoOn);
    EXPECT_LT(sim.state(1)[u"position"_s].toInt(), -50)
        << "it had moved, and nothing has made this position zero";
    EXPECT_EQ(sim.violations(), "");
}

INSTANTIATE_TEST_SUITE_P(Buttons, OtherWish,
                         testing::Values(Other{"stopSmoothlyButton", true}, Other{"stopAbruptlyButton", true},
                                         Other{"motorOffButton", false}, Other{"stopAllButton", true},
                                         Other{"applyGainsButton", true}, Other{"holdForwardButton", true},
                                         Other{"clearStickyButton", true}),
                         [](const auto& tested) { return std::string(tested.param.button); });

TEST_F(HomingPage, ClosingThePortEndsIt) {
    ASSERT_NO_FATAL_FAILURE(search());
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, TheLimitStopStopsTheMotorAndSaysSo) {
    ASSERT_NO_FATAL_FAILURE(begin());
    EXPECT_TRUE(text("limitStopState").contains(u"Not armed"_s));
    click("armLimitStopButton");
    ASSERT_TRUE(panel.waitFor([&] {
        return text("limitStopState").contains(u"Armed: stops at limit 1 or limit 2"_s);
    })) << text("limitStopState").toStdString();
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(1'311), true}});
    ASSERT_TRUE(panel.waitFor([&] { return text("limitStopState").contains(u"Tripped"_s); }));
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(panel.module().activity(), Activity::Holding);
    click("disarmLimitStopButton");
    EXPECT_TRUE(panel.waitFor([&] { return text("limitStopState").contains(u"Not armed"_s); }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, MovesByNFromTheWindowsIntent) {
    ASSERT_NO_FATAL_FAILURE(begin());
    auto* procedures = panel.composition().findChild<ProcedureController*>();
    panel.ask(intent::MoveBy{{250, 3, 0.05, false},
                             ServoPace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}});
    ASSERT_TRUE(procedures->anyRunning());
    ASSERT_TRUE(panel.waitFor([&] { return !procedures->anyRunning(); }));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 750, 4);
    panel.ask(intent::MoveBy{{-250, 30, 0.0, false},
                             ServoPace{CountsPerTick(1 << 14), CountsPerTickSquared(1'311)}});
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    panel.ask(intent::Home{});
    EXPECT_EQ(panel.count(u"Module 1 cannot do this now"_s), 1) << "it is not queued either";
    EXPECT_TRUE(panel.waitFor([&] { return !procedures->anyRunning() && !testing_support::moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().moving(); }));
    panel.ask(intent::MoveBy{{-250, 30, 0.0, false},
                             ServoPace{CountsPerTick(1 << 14), CountsPerTickSquared(1'311)}});
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return !testing_support::moves(sim); }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_FALSE(testing_support::moves(sim)) << "nothing starts again";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(HomingPage, N2_AfterAFreezeOfThePanelNoMoveFollows) {
    ASSERT_NO_FATAL_FAILURE(begin());
    auto* procedures = panel.composition().findChild<ProcedureController*>();
    panel.ask(intent::MoveBy{{5'000, 1'000, 0.0, true},
                             ServoPace{CountsPerTick(1 << 15), CountsPerTickSquared(1'311)}});
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    panel.freeze(2'600ms);
    ASSERT_FALSE(testing_support::moves(sim));
    const int there = sim.state(1)[u"position"_s].toInt();
    EXPECT_TRUE(panel.waitFor([&] { return !procedures->anyRunning(); }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), there, 4);
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(sim.violations(), "");
}

/// 0.5 counts/tick is about 977 counts/s, so the move takes about 5 s.
TEST_F(HomingPage, AFreezeOfThePanelThatStopsNothingEndsNoProcedure) {
    ASSERT_NO_FATAL_FAILURE(begin());
    auto* procedures = panel.composition().findChild<ProcedureController*>();
    const int from = sim.state(1)[u"position"_s].toInt();
    panel.ask(intent::MoveBy{{5'000, 1, 0.0, false},
                             ServoPace{CountsPerTick(1 << 15), CountsPerTickSquared(1'311)}});
    ASSERT_TRUE(panel.waitFor([&] { return testing_support::moves(sim); }));
    panel.freeze(1'200ms);
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"The motor was not stopped"_s) == 1; }));
    EXPECT_TRUE(panel.waitFor([&] { return !procedures->anyRunning(); }));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), from + 5'000, 5);
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a PIC-STEP can do, through the window and by object name; the oracle is what the simulator
// knows about the motor, and it must have seen nothing that a chip would not tolerate.
#include "link/command/procedurecontroller.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class SteppersByHand : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        panel.select(1);
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AmplifierOff; }));
    }
    void TearDown() override { EXPECT_EQ(sim.violations(), ""); }

    void click(const char* button) {
        auto& widget = panel.find<QAbstractButton>(button);
        ASSERT_TRUE(waitFor([&] { return widget.isEnabled(); })) << button << ": " << tip(button);
        QTest::mouseClick(&widget, Qt::LeftButton, {}, {widget.height() / 2, widget.height() / 2});
    }
    std::string tip(const char* name) { return panel.find(name).toolTip().toStdString(); }
    QString text(const char* label) {
        return panel.find<QLabel>(label).text().replace(QChar(0x202F), QLatin1Char(' '));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate) {
        return panel.waitFor(predicate);
    }
    [[nodiscard]] const ModuleState& module() { return panel.module(1); }
    [[nodiscard]] QJsonObject truth() { return sim.state(2); }
    [[nodiscard]] double rate() { return truth()[QStringLiteral("step_rate")].toDouble(); }
    [[nodiscard]] int position() { return truth()[QStringLiteral("position")].toInt(); }

    /// Applies parameters with 4x: 100 to 25 000 steps/s.
    void setParameters() {
        auto& mode = panel.find<QComboBox>("stepperSpeedModeField");
        mode.setFocus();
        QTest::keyClick(&mode, Qt::Key_Home);
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(&mode, Qt::Key_Down);
        panel.type("stepperMinimumSpeedField", QStringLiteral("200"));
        panel.type("stepperRunCurrentField", QStringLiteral("120"));
        panel.type("stepperHoldCurrentField", QStringLiteral("60"));
        panel.type("stepperThermalLimitField", QStringLiteral("80"));
        panel.type("stepperAccelerationTimeField", QStringLiteral("8"));
        EXPECT_EQ(text("stepperAccelerationRemark"), QStringLiteral("50 000 steps/s²"))
            << "100 steps/s every 2 ms";
        EXPECT_EQ(text("stepperRunCurrentState"), QStringLiteral("● not sent"));
        click("stepperApplyParametersButton");
        ASSERT_TRUE(waitFor([&] { return module().stepper.parameters.has_value(); }));
    }
    void enable() {
        setParameters();
        click("stepperEnableButton");
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    }
    void choose(const char* mode) { click(mode); }
    /// Waits until the stepper has answered for this much longer, so that whatever was on its way to it has
    /// arrived.
    bool answersFor(double seconds) {
        const TimePoint until = module().latestTime + fromSeconds(seconds);
        return waitFor([&] { return module().latestTime >= until; });
    }
    bool standsAt(int goal) {
        return waitFor([&] { return !module().moving() && *module().latest->position == goal; });
    }

    VirtualChain sim{QStringLiteral("servo,step")};
    /// True while a stop, wait, go is in progress.
    [[nodiscard]] bool changing() {
        return panel.composition().findChild<ProcedureController*>()->anyRunning();
    }
    VirtualPanel panel;
};

TEST_F(SteppersByHand, NothingMovesOrHoldsBeforeTheParametersWereSent) {
    EXPECT_FALSE(panel.find("stepperEnableButton").isEnabled());
    EXPECT_FALSE(panel.find("stepperGoButton").isEnabled());
    EXPECT_EQ(tip("stepperGoButton"), "Apply parameters first.");
    EXPECT_EQ(text("stepperSpeedModeState"), QStringLiteral("? unknown"));
    setParameters();
    EXPECT_EQ(module().stepper.parameters,
              (stepper::SetParameters{stepper::SpeedMode::X4, false, false, false, 2, 120, 60, 80}));
    EXPECT_TRUE(waitFor([&] { return text("stepperRunCurrentState") == QStringLiteral("✓ sent"); }));
    EXPECT_EQ(text("stepperThermalLimitRemark"), QStringLiteral("A/D now 255"));
    EXPECT_FALSE(truth()[QStringLiteral("amp_enabled")].toBool());
    click("stepperEnableButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    EXPECT_TRUE(truth()[QStringLiteral("amp_enabled")].toBool());
    EXPECT_EQ(truth()[QStringLiteral("current_limit")].toInt(), 60);
}

TEST_F(SteppersByHand, MovesToAPositionAndSaysBeforehandHowLongItTakes) {
    enable();
    choose("stepperModeTrapezoidal");
    panel.type("stepperGoalField", QStringLiteral("3000"));
    panel.type("stepperSpeedField", QStringLiteral("2000"));
    EXPECT_EQ(text("stepperSpeedOutcome"), QStringLiteral("Runs at 2 000 steps/s: speed 20 of 250."));
    // Ramp: 0.002 x 100 x 189 = 37.8 steps each; 2 x 18 x 2 ms + (3 000 - 75.6) / 2 000 = 1.534 s.
    EXPECT_EQ(text("stepperForecast"), QStringLiteral("Takes 1.53 s, peak speed 2 000 steps/s."));
    click("stepperGoButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AtSpeed; }));
    EXPECT_DOUBLE_EQ(rate(), 2'000);
    ASSERT_TRUE(standsAt(3'000));
    EXPECT_EQ(position(), 3'000);
    click("stepperRelativeBox");
    panel.type("stepperGoalField", QStringLiteral("-40"));
    EXPECT_TRUE(text("stepperForecast").contains(QStringLiteral("Too short for that speed")))
        << text("stepperForecast").toStdString();
    click("stepperGoButton");
    ASSERT_TRUE(standsAt(2'960));
}

TEST_F(SteppersByHand, RunsBothWaysAndChangesItsSpeedOnTheFly) {
    enable();
    choose("stepperModeProfile");
    panel.type("stepperSpeedField", QStringLiteral("1000"));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 1'000; }));
    panel.type("stepperSpeedField", QStringLiteral("1540"));
    EXPECT_EQ(text("stepperSpeedOutcome"), QStringLiteral("Runs at 1 500 steps/s: speed 15 of 250."));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 1'500; }));
    EXPECT_TRUE(panel.find<QAbstractButton>("stepperRunReverseButton")
                    .text()
                    .startsWith(QLatin1String("Stop, wait")));
    click("stepperStopSmoothlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0 && module().activity() == Activity::Holding; }));
    click("stepperRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() == -1'500; }));
    QTest::keyClick(&panel.find("stepperSpeedField"), Qt::Key_Escape);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
    EXPECT_TRUE(truth()[QStringLiteral("amp_enabled")].toBool());
}

// 65 536 - 2 500 000 / 700 + 8 = 61 972.57: 61 973 gives 2 500 000 / 3 571 = 700.08 steps/s.
TEST_F(SteppersByHand, MovesWithoutARampAtTheTimersSpeed) {
    enable();
    choose("stepperModeTimedMove");
    panel.type("stepperGoalField", QStringLiteral("-500"));
    panel.type("stepperSpeedField", QStringLiteral("700"));
    EXPECT_EQ(text("stepperSpeedOutcome"), QStringLiteral("Runs at 700.084 steps/s: timer count 61 973."));
    click("stepperGoButton");
    ASSERT_TRUE(waitFor([&] { return rate() < 0; }));
    EXPECT_NEAR(rate(), -700.084, 1e-3);
    ASSERT_TRUE(standsAt(-500));
    choose("stepperModeTimedRun");
    panel.type("stepperSpeedField", QStringLiteral("350"));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    EXPECT_NEAR(rate(), 350, 0.1);
    panel.type("stepperSpeedField", QStringLiteral("450"));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 400; }));
    choose("stepperModeProfile");
    panel.type("stepperSpeedField", QStringLiteral("900"));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 900; }));
    click("stepperStopAbruptlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(SteppersByHand, ReversesAndMovesOutOfARunByStopWaitGo) {
    enable();
    choose("stepperModeProfile");
    panel.type("stepperSpeedField", QStringLiteral("2000"));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 2'000; }));
    click("stepperRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() == -2'000; }));
    // The panel learns about it one status later; until then, another change is refused.
    ASSERT_TRUE(waitFor([&] { return !changing(); }));
    choose("stepperModeTrapezoidal");
    panel.type("stepperGoalField", QStringLiteral("100"));
    click("stepperGoButton");
    ASSERT_TRUE(standsAt(100));
    EXPECT_EQ(position(), 100);
    // A stop overtakes the change, of which the rest is not carried out.
    choose("stepperModeProfile");
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 2'000; }));
    click("stepperRunReverseButton");
    QTest::keyClick(&panel.find("stepperSpeedField"), Qt::Key_Escape);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
    ASSERT_TRUE(answersFor(0.5));
    EXPECT_EQ(rate(), 0);
}

TEST_F(SteppersByHand, LoadsNowAndStartsLater) {
    enable();
    choose("stepperModeTrapezoidal");
    panel.type("stepperGoalField", QStringLiteral("400"));
    EXPECT_FALSE(panel.find("stepperStartLoadedButton").isEnabled());
    click("stepperLoadOnlyBox");
    click("stepperGoButton");
    ASSERT_TRUE(waitFor([&] { return module().loadWaiting; }));
    ASSERT_TRUE(answersFor(0.2));
    EXPECT_EQ(position(), 0);
    click("stepperStartLoadedButton");
    ASSERT_TRUE(standsAt(400));
    EXPECT_FALSE(panel.find("stepperStartLoadedButton").isEnabled());
}

TEST_F(SteppersByHand, MovesOnlyWhileAButtonIsHeld) {
    enable();
    panel.type("stepperHoldCapField", QStringLiteral("600"));
    EXPECT_TRUE(panel.find<QLineEdit>("stepperHoldVelocityField").text() == QStringLiteral("200"))
        << "low, and no lower than the minimum profile speed";
    panel.type("stepperHoldVelocityField", QStringLiteral("5000"));
    EXPECT_FALSE(panel.find("stepperHoldForwardButton").isEnabled()) << "above the cap";
    panel.type("stepperHoldVelocityField", QStringLiteral("600"));
    auto& forward = panel.find<QAbstractButton>("stepperHoldForwardButton");
    ASSERT_TRUE(forward.isEnabled()) << tip("stepperHoldForwardButton");
    QTest::mousePress(&forward, Qt::LeftButton);
    // One press alone lasts for 250 ms: the window must have re-armed it.
    ASSERT_TRUE(waitFor([&] { return *module().latest->position > 300; }));
    EXPECT_DOUBLE_EQ(rate(), 600);
    EXPECT_FALSE(panel.find("stepperHoldReverseButton").isEnabled());
    QTest::mouseRelease(&forward, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    EXPECT_EQ(rate(), 0);
    auto& reverse = panel.find<QAbstractButton>("stepperHoldReverseButton");
    ASSERT_TRUE(waitFor([&] { return reverse.isEnabled(); }));
    QTest::mousePress(&reverse, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return rate() == -600; }));
    QTest::mouseRelease(&reverse, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(SteppersByHand, SwitchesOutputsAndShowsInputsUnderTheirNames) {
    const auto outputs = [&] { return truth().value(QStringLiteral("outputs")); };
    EXPECT_TRUE(panel.find<QAbstractButton>("stepperOutput5Box").isChecked())
        << "outputs are high at power-up";
    click("stepperOutput2Box");
    ASSERT_TRUE(waitFor([&] { return module().stepper.outputs == 0x12; }));
    click("stepperOutput5Box");
    ASSERT_TRUE(waitFor([&] { return module().stepper.outputs == 0x02; }));
    EXPECT_EQ(text("stepperOutput2State"), QStringLiteral("high"));
    EXPECT_EQ(outputs().toInt(), 2);
    panel.type("stepperOutput2Name", QStringLiteral("Coolant"));
    panel.type("stepperInput1Name", QStringLiteral("Door"));
    EXPECT_EQ(panel.find<QLineEdit>("stepperOutput2Name").text(), QStringLiteral("Coolant"));

    for (const auto& [input, label] : {std::pair{"in1", "stepperIn1Input"},
                                       {"in2", "stepperIn2Input"},
                                       {"limit1", "stepperLimit1Input"},
                                       {"limit2", "stepperLimit2Input"},
                                       {"home_switch", "stepperHomeInput"},
                                       {"estop", "stepperEstopInput"}}) {
        EXPECT_EQ(text(label), QStringLiteral("low")) << input;
        (void)sim.control(QStringLiteral("set 2 %1 1").arg(QLatin1String(input)));
        EXPECT_TRUE(waitFor([&, l = label] { return text(l) == QStringLiteral("high"); })) << input;
    }
    EXPECT_EQ(text("stepperLimit1InputEffect"), QStringLiteral("blocks forward"));
    (void)sim.control(QStringLiteral("set 2 analog 51"));
    EXPECT_TRUE(waitFor([&] { return text("stepperIoAnalog") == QStringLiteral("1 V (51 of 255)"); }));
}

TEST_F(SteppersByHand, ALimitStopsItAndLeavesTheWayBackOpen) {
    enable();
    choose("stepperModeProfile");
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    (void)sim.control(QStringLiteral("set 2 limit1 1"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::StoppedByLimit; }));
    EXPECT_EQ(text("stepperStateLabel"), QStringLiteral("Stopped by a limit"));
    EXPECT_FALSE(panel.find("stepperRunForwardButton").isEnabled());
    EXPECT_EQ(tip("stepperRunForwardButton"),
              "Limit switch 1 is active: the motor can only move away from it.");
    EXPECT_FALSE(panel.find("stepperHoldForwardButton").isEnabled());
    click("stepperRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() < 0; }));
    click("stepperStopAbruptlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(SteppersByHand, HeatAndPowerSwitchItOffAndItStaysOff) {
    enable();
    (void)sim.control(QStringLiteral("set 2 analog 70"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Overheated; }));
    EXPECT_TRUE(
        panel.headlines().contains(QStringLiteral("Module 2 is too hot and switched its motor off.")));
    EXPECT_FALSE(panel.find("stepperEnableButton").isEnabled());
    (void)sim.control(QStringLiteral("set 2 analog 200"));
    click("stepperEnableButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    (void)sim.control(QStringLiteral("set 2 power 0"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::PowerLost; }));
    EXPECT_TRUE(
        panel.headlines().contains(QStringLiteral("Module 2 has no motor power, so its motor is off.")));
    (void)sim.control(QStringLiteral("set 2 power 1"));
    ASSERT_TRUE(waitFor([&] { return panel.find("stepperEnableButton").isEnabled(); }));
    EXPECT_FALSE(truth()[QStringLiteral("amp_enabled")].toBool());
}

TEST_F(SteppersByHand, TheEstopInputStopsItUnlessItIsIgnored) {
    enable();
    choose("stepperModeProfile");
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    (void)sim.control(QStringLiteral("set 2 estop 1"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::EstopActive; }));
    EXPECT_EQ(rate(), 0);
    EXPECT_FALSE(panel.find("stepperRunForwardButton").isEnabled());
    click("stepperIgnoreEstopField");
    EXPECT_EQ(text("stepperParametersHint"),
              QStringLiteral("If checked, the E-stop input does not stop the motor."));
    EXPECT_EQ(text("stepperIgnoreEstopState"), QStringLiteral("● not sent"));
    click("stepperApplyParametersButton");
    ASSERT_TRUE(waitFor([&] { return module().stepper.parameters->ignoreEstop; }));
    click("stepperRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    click("stepperMotorOffButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AmplifierOff; }));
    EXPECT_EQ(rate(), 0);
}

TEST_F(SteppersByHand, DetailsTellEveryBitAndKeepPositionAndHome) {
    enable();
    choose("stepperModeTrapezoidal");
    panel.type("stepperGoalField", QStringLiteral("250"));
    click("stepperGoButton");
    ASSERT_TRUE(standsAt(250));
    EXPECT_TRUE(waitFor([&] { return text("stepperBit_amplifier_enabled") == QStringLiteral("on"); }));
    EXPECT_EQ(text("stepperBit_power"), QStringLiteral("on"));
    EXPECT_EQ(text("stepperBit_moving"), QStringLiteral("off"));
    EXPECT_EQ(text("stepperRawLabel"), QStringLiteral("status 0c, inputs 00"));
    click("stepperSaveHomeButton");
    EXPECT_TRUE(waitFor([&] { return text("stepperHomeLabel") == QStringLiteral("250 steps"); }));
    click("stepperZeroHereButton");
    ASSERT_TRUE(standsAt(0));
    EXPECT_EQ(position(), 0);
}

TEST_F(SteppersByHand, StepsByADistanceAndGoesHome) {
    enable();
    EXPECT_EQ(tip("stepperGoHomeButton"), "Home is unknown: search for it, or save it.");
    click("stepperSaveHomeButton");
    panel.type("stepperMoveByDistanceField", QStringLiteral("120"));
    panel.type("stepperMoveByRoundsField", QStringLiteral("3"));
    click("stepperMoveByForwardButton");
    ASSERT_TRUE(standsAt(360));
    EXPECT_EQ(position(), 360);
    ASSERT_TRUE(waitFor([&] { return !changing(); }));
    click("stepperGoHomeButton");
    ASSERT_TRUE(standsAt(0));
    panel.type("stepperMoveByRoundsField", QStringLiteral("500"));
    click("stepperMoveByReverseButton");
    ASSERT_TRUE(waitFor([&] { return position() < -100; }));
    click("stepperMoveByEndButton");
    ASSERT_TRUE(waitFor([&] { return !changing() && !module().moving(); }));
    const int stood = position();
    ASSERT_TRUE(answersFor(1.0));
    EXPECT_EQ(position(), stood) << "no more steps";
}

TEST_F(SteppersByHand, ASecondLookAtTheServoChangesNothing) {
    enable();
    panel.select(0);
    EXPECT_TRUE(waitFor([&] { return panel.find("servoPanel").isVisible(); }));
    panel.select(1);
    EXPECT_TRUE(waitFor([&] { return panel.find("stepperPanel").isVisible(); }));
    EXPECT_EQ(panel.find<QLineEdit>("stepperRunCurrentField").text(), QStringLiteral("120"));
    EXPECT_EQ(text("stepperRunCurrentState"), QStringLiteral("✓ sent"));
    EXPECT_EQ(module().activity(), Activity::Holding);
}

}  // namespace
}  // namespace nmc

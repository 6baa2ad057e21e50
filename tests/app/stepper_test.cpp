// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a PIC-STEP can do, through the window and by object name, over a pseudo-terminal that
// nmcsim serves; the oracle is what nmcsim knows of the motor, and it must have seen nothing that a chip
// would not forgive.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "app/composition.h"
#include "app/procedurecontroller.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/turnto.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"

namespace nmc {
namespace {

using testing_support::NmcsimProcess;

class StepperPanel : public testing::Test {
protected:
    void SetUp() override {
        m_composition.show({sim.terminal(), 115'200, false});
        ASSERT_TRUE(waitFor([&] {
            return m_composition.store().link().phase == LinkPhase::Connected &&
                   m_composition.store().link().modules.size() == 2;
        })) << headlines().join(QStringLiteral(" | ")).toStdString();
        auto& list = find<QAbstractItemView>("chainList");
        list.setCurrentIndex(list.model()->index(1, 0));
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AmplifierOff; }));
    }
    void TearDown() override { EXPECT_EQ(sim.violations(), ""); }

    template <typename Widget = QWidget>
    Widget& find(const char* name) {
        auto* widget = m_composition.window().findChild<Widget*>(QLatin1String(name));
        if (widget == nullptr)
            throw std::runtime_error(std::string("there is no ") + name);
        testing_support::turnTo(*widget);
        return *widget;
    }
    void type(const char* field, const QString& text) {
        auto& edit = find<QLineEdit>(field);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        EXPECT_EQ(edit.text(), text) << field;
    }
    void click(const char* button) {
        auto& widget = find<QAbstractButton>(button);
        ASSERT_TRUE(waitFor([&] { return widget.isEnabled(); })) << button << ": " << tip(button);
        QTest::mouseClick(&widget, Qt::LeftButton, {}, {widget.height() / 2, widget.height() / 2});
    }
    std::string tip(const char* name) { return find(name).toolTip().toStdString(); }
    QString text(const char* label) {
        return find<QLabel>(label).text().replace(QChar(0x202F), QLatin1Char(' '));
    }
    template <typename Predicate>
    bool waitFor(Predicate predicate) {
        return QTest::qWaitFor(predicate, 20'000);
    }
    [[nodiscard]] const ModuleState& module() const { return *m_composition.store().module(ModuleIndex(1)); }
    [[nodiscard]] QJsonObject truth() { return sim.state(2); }
    [[nodiscard]] double rate() { return truth()[QStringLiteral("step_rate")].toDouble(); }
    [[nodiscard]] int position() { return truth()[QStringLiteral("position")].toInt(); }
    QStringList headlines() {
        QStringList lines;
        for (const MessageRow* row : m_composition.window().findChild<MessageList*>()->rows())
            lines << row->message().headline;
        return lines;
    }

    /// 4x: 100 to 25 000 steps/s.
    void setParameters() {
        auto& mode = find<QComboBox>("stepSpeedModeField");
        mode.setFocus();
        QTest::keyClick(&mode, Qt::Key_Home);
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(&mode, Qt::Key_Down);
        type("stepMinimumSpeedField", QStringLiteral("200"));
        type("stepRunCurrentField", QStringLiteral("120"));
        type("stepHoldCurrentField", QStringLiteral("60"));
        type("stepThermalLimitField", QStringLiteral("80"));
        type("stepAccelerationTimeField", QStringLiteral("8"));
        EXPECT_EQ(text("stepAccelerationRemark"), QStringLiteral("50 000 steps/s²"))
            << "100 steps/s each 2 ms";
        EXPECT_EQ(text("stepRunCurrentState"), QStringLiteral("● not sent"));
        click("stepApplyParametersButton");
        ASSERT_TRUE(waitFor([&] { return module().stepper.parameters().has_value(); }));
    }
    void enable() {
        setParameters();
        click("stepEnableButton");
        ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    }
    void choose(const char* mode) { click(mode); }
    /// The stepper has answered for so much longer: what was on its way to it has come.
    bool answersFor(double seconds) {
        const TimePoint until = module().latestTime + fromSeconds(seconds);
        return waitFor([&] { return module().latestTime >= until; });
    }
    bool standsAt(int goal) {
        return waitFor([&] { return !module().moving() && *module().latest->position == goal; });
    }

    NmcsimProcess sim{QStringLiteral("servo,step")};
    /// A stop, wait, go is under way.
    [[nodiscard]] bool changing() const {
        return m_composition.findChild<ProcedureController*>()->anyRunning();
    }

private:
    QTemporaryDir m_directory;
    QSettings m_settings{m_directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat};
    Composition m_composition{m_settings};
};

TEST_F(StepperPanel, NothingMovesOrHoldsBeforeTheParametersWereSent) {
    EXPECT_FALSE(find("stepEnableButton").isEnabled());
    EXPECT_FALSE(find("stepGoButton").isEnabled());
    EXPECT_EQ(tip("stepGoButton"), "Apply parameters first.");
    EXPECT_EQ(text("stepSpeedModeState"), QStringLiteral("? unknown"));
    setParameters();
    EXPECT_EQ(module().stepper.parameters(),
              (step::SetParameters{step::SpeedMode::X4, false, false, false, 2, 120, 60, 80}));
    EXPECT_TRUE(waitFor([&] { return text("stepRunCurrentState") == QStringLiteral("✓ sent"); }));
    EXPECT_EQ(text("stepThermalLimitRemark"), QStringLiteral("A/D now 255"));
    EXPECT_FALSE(truth()[QStringLiteral("amp_enabled")].toBool());
    click("stepEnableButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    EXPECT_TRUE(truth()[QStringLiteral("amp_enabled")].toBool());
    EXPECT_EQ(truth()[QStringLiteral("current_limit")].toInt(), 60);
}

TEST_F(StepperPanel, MovesToAPositionAndSaysBeforehandHowLongItTakes) {
    enable();
    choose("stepModeTrapezoidal");
    type("stepGoalField", QStringLiteral("3000"));
    type("stepSpeedField", QStringLiteral("2000"));
    EXPECT_EQ(text("stepSpeedOutcome"), QStringLiteral("Runs at 2 000 steps/s: speed 20 of 250."));
    // Ramp: 0.002 x 100 x 189 = 37.8 steps each; 2 x 18 x 2 ms + (3 000 - 75.6) / 2 000 = 1.534 s.
    EXPECT_EQ(text("stepForecast"), QStringLiteral("Takes 1.53 s, peak speed 2 000 steps/s."));
    click("stepGoButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AtSpeed; }));
    EXPECT_DOUBLE_EQ(rate(), 2'000);
    ASSERT_TRUE(standsAt(3'000));
    EXPECT_EQ(position(), 3'000);
    click("stepRelativeBox");
    type("stepGoalField", QStringLiteral("-40"));
    EXPECT_TRUE(text("stepForecast").contains(QStringLiteral("Too short for that speed")))
        << text("stepForecast").toStdString();
    click("stepGoButton");
    ASSERT_TRUE(standsAt(2'960));
}

TEST_F(StepperPanel, RunsBothWaysAndChangesItsSpeedOnTheFly) {
    enable();
    choose("stepModeProfile");
    type("stepSpeedField", QStringLiteral("1000"));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 1'000; }));
    type("stepSpeedField", QStringLiteral("1540"));
    EXPECT_EQ(text("stepSpeedOutcome"), QStringLiteral("Runs at 1 500 steps/s: speed 15 of 250."));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 1'500; }));
    EXPECT_TRUE(find<QAbstractButton>("stepRunReverseButton").text().startsWith(QLatin1String("Stop, wait")));
    click("stepStopSmoothlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0 && module().activity() == Activity::Holding; }));
    click("stepRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() == -1'500; }));
    QTest::keyClick(&find("stepSpeedField"), Qt::Key_Escape);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
    EXPECT_TRUE(truth()[QStringLiteral("amp_enabled")].toBool());
}

// 65 536 - 2 500 000 / 700 + 8 = 61 972.57: 61 973 gives 2 500 000 / 3 571 = 700.08 steps/s.
TEST_F(StepperPanel, MovesWithoutARampAtTheTimersSpeed) {
    enable();
    choose("stepModeTimedMove");
    type("stepGoalField", QStringLiteral("-500"));
    type("stepSpeedField", QStringLiteral("700"));
    EXPECT_EQ(text("stepSpeedOutcome"), QStringLiteral("Runs at 700.084 steps/s: timer count 61 973."));
    click("stepGoButton");
    ASSERT_TRUE(waitFor([&] { return rate() < 0; }));
    EXPECT_NEAR(rate(), -700.084, 1e-3);
    ASSERT_TRUE(standsAt(-500));
    choose("stepModeTimedRun");
    type("stepSpeedField", QStringLiteral("350"));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    EXPECT_NEAR(rate(), 350, 0.1);
    type("stepSpeedField", QStringLiteral("450"));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 400; }));
    choose("stepModeProfile");
    type("stepSpeedField", QStringLiteral("900"));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 900; }));
    click("stepStopAbruptlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(StepperPanel, ReversesAndMovesOutOfARunByStopWaitGo) {
    enable();
    choose("stepModeProfile");
    type("stepSpeedField", QStringLiteral("2000"));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 2'000; }));
    click("stepRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() == -2'000; }));
    // The panel learns of it a status later; until then another change is refused.
    ASSERT_TRUE(waitFor([&] { return !changing(); }));
    choose("stepModeTrapezoidal");
    type("stepGoalField", QStringLiteral("100"));
    click("stepGoButton");
    ASSERT_TRUE(standsAt(100));
    EXPECT_EQ(position(), 100);
    // A stop overtakes it: what was to come does not.
    choose("stepModeProfile");
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 2'000; }));
    click("stepRunReverseButton");
    QTest::keyClick(&find("stepSpeedField"), Qt::Key_Escape);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
    ASSERT_TRUE(answersFor(0.5));
    EXPECT_EQ(rate(), 0);
}

TEST_F(StepperPanel, LoadsNowAndStartsLater) {
    enable();
    choose("stepModeTrapezoidal");
    type("stepGoalField", QStringLiteral("400"));
    EXPECT_FALSE(find("stepStartLoadedButton").isEnabled());
    click("stepLoadOnlyBox");
    click("stepGoButton");
    ASSERT_TRUE(waitFor([&] { return module().loadWaiting; }));
    ASSERT_TRUE(answersFor(0.2));
    EXPECT_EQ(position(), 0);
    click("stepStartLoadedButton");
    ASSERT_TRUE(standsAt(400));
    EXPECT_FALSE(find("stepStartLoadedButton").isEnabled());
}

TEST_F(StepperPanel, MovesOnlyWhileAButtonIsHeld) {
    enable();
    type("stepHoldCapField", QStringLiteral("600"));
    EXPECT_TRUE(find<QLineEdit>("stepHoldVelocityField").text() == QStringLiteral("200"))
        << "low, and no lower than the minimum profile speed";
    type("stepHoldVelocityField", QStringLiteral("5000"));
    EXPECT_FALSE(find("stepHoldForwardButton").isEnabled()) << "above the cap";
    type("stepHoldVelocityField", QStringLiteral("600"));
    auto& forward = find<QAbstractButton>("stepHoldForwardButton");
    ASSERT_TRUE(forward.isEnabled()) << tip("stepHoldForwardButton");
    QTest::mousePress(&forward, Qt::LeftButton);
    // One press alone lasts 250 ms: the window must have re-armed it.
    ASSERT_TRUE(waitFor([&] { return *module().latest->position > 300; }));
    EXPECT_DOUBLE_EQ(rate(), 600);
    EXPECT_FALSE(find("stepHoldReverseButton").isEnabled());
    QTest::mouseRelease(&forward, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    EXPECT_EQ(rate(), 0);
    auto& reverse = find<QAbstractButton>("stepHoldReverseButton");
    ASSERT_TRUE(waitFor([&] { return reverse.isEnabled(); }));
    QTest::mousePress(&reverse, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return rate() == -600; }));
    QTest::mouseRelease(&reverse, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(StepperPanel, SwitchesOutputsAndShowsInputsUnderTheirNames) {
    const auto outputs = [&] { return truth()[QStringLiteral("outputs")]; };
    EXPECT_TRUE(find<QAbstractButton>("stepOutput5Box").isChecked()) << "high at power-up";
    click("stepOutput2Box");
    ASSERT_TRUE(waitFor([&] { return module().stepper.outputs() == 0x12; }));
    click("stepOutput5Box");
    ASSERT_TRUE(waitFor([&] { return module().stepper.outputs() == 0x02; }));
    EXPECT_EQ(text("stepOutput2State"), QStringLiteral("high"));
    EXPECT_EQ(outputs().toInt(), 2);
    type("stepOutput2Name", QStringLiteral("Coolant"));
    type("stepInput1Name", QStringLiteral("Door"));
    EXPECT_EQ(find<QLineEdit>("stepOutput2Name").text(), QStringLiteral("Coolant"));

    for (const auto& [input, label] : {std::pair{"in1", "stepIn1Input"},
                                       {"in2", "stepIn2Input"},
                                       {"limit1", "stepLimit1Input"},
                                       {"limit2", "stepLimit2Input"},
                                       {"home_switch", "stepHomeInput"},
                                       {"estop", "stepEstopInput"}}) {
        EXPECT_EQ(text(label), QStringLiteral("low")) << input;
        (void)sim.control(QStringLiteral("set 2 %1 1").arg(QLatin1String(input)));
        EXPECT_TRUE(waitFor([&, l = label] { return text(l) == QStringLiteral("high"); })) << input;
    }
    EXPECT_EQ(text("stepLimit1InputEffect"), QStringLiteral("blocks forward"));
    (void)sim.control(QStringLiteral("set 2 analog 51"));
    EXPECT_TRUE(waitFor([&] { return text("stepIoAnalog") == QStringLiteral("1 V (51 of 255)"); }));
}

TEST_F(StepperPanel, ALimitStopsItAndLeavesTheWayBackOpen) {
    enable();
    choose("stepModeProfile");
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    (void)sim.control(QStringLiteral("set 2 limit1 1"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::StoppedByLimit; }));
    EXPECT_EQ(text("stepStateLabel"), QStringLiteral("Stopped by a limit"));
    EXPECT_FALSE(find("stepRunForwardButton").isEnabled());
    EXPECT_EQ(tip("stepRunForwardButton"), "Limit switch 1 is active: the motor can move in reverse only.");
    EXPECT_FALSE(find("stepHoldForwardButton").isEnabled());
    click("stepRunReverseButton");
    ASSERT_TRUE(waitFor([&] { return rate() < 0; }));
    click("stepStopAbruptlyButton");
    ASSERT_TRUE(waitFor([&] { return rate() == 0; }));
}

TEST_F(StepperPanel, HeatAndPowerSwitchItOffAndItStaysOff) {
    enable();
    (void)sim.control(QStringLiteral("set 2 analog 70"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Overheated; }));
    EXPECT_TRUE(headlines().contains(QStringLiteral("Module 2 is too hot and switched its motor off.")));
    EXPECT_FALSE(find("stepEnableButton").isEnabled());
    (void)sim.control(QStringLiteral("set 2 analog 200"));
    click("stepEnableButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::Holding; }));
    (void)sim.control(QStringLiteral("set 2 power 0"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::PowerLost; }));
    EXPECT_TRUE(headlines().contains(QStringLiteral("Module 2 has no motor power, so its motor is off.")));
    (void)sim.control(QStringLiteral("set 2 power 1"));
    ASSERT_TRUE(waitFor([&] { return find("stepEnableButton").isEnabled(); }));
    EXPECT_FALSE(truth()[QStringLiteral("amp_enabled")].toBool());
}

TEST_F(StepperPanel, TheEstopInputStopsItUnlessItIsIgnored) {
    enable();
    choose("stepModeProfile");
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    (void)sim.control(QStringLiteral("set 2 estop 1"));
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::EstopActive; }));
    EXPECT_EQ(rate(), 0);
    EXPECT_FALSE(find("stepRunForwardButton").isEnabled());
    click("stepIgnoreEstopField");
    EXPECT_EQ(text("stepParametersHint"),
              QStringLiteral("If checked, the E-stop input does not stop the motor."));
    EXPECT_EQ(text("stepIgnoreEstopState"), QStringLiteral("● not sent"));
    click("stepApplyParametersButton");
    ASSERT_TRUE(waitFor([&] { return module().stepper.parameters()->ignoreEstop; }));
    click("stepRunForwardButton");
    ASSERT_TRUE(waitFor([&] { return rate() > 0; }));
    click("stepMotorOffButton");
    ASSERT_TRUE(waitFor([&] { return module().activity() == Activity::AmplifierOff; }));
    EXPECT_EQ(rate(), 0);
}

TEST_F(StepperPanel, DetailsTellEveryBitAndKeepPositionAndHome) {
    enable();
    choose("stepModeTrapezoidal");
    type("stepGoalField", QStringLiteral("250"));
    click("stepGoButton");
    ASSERT_TRUE(standsAt(250));
    EXPECT_TRUE(waitFor([&] { return text("stepBit_amplifier_enabled") == QStringLiteral("on"); }));
    EXPECT_EQ(text("stepBit_power"), QStringLiteral("on"));
    EXPECT_EQ(text("stepBit_moving"), QStringLiteral("off"));
    EXPECT_EQ(text("stepRawLabel"), QStringLiteral("status 0c, inputs 00"));
    click("stepSaveHomeButton");
    EXPECT_TRUE(waitFor([&] { return text("stepHomeLabel") == QStringLiteral("250 steps"); }));
    click("stepZeroHereButton");
    ASSERT_TRUE(standsAt(0));
    EXPECT_EQ(position(), 0);
}

TEST_F(StepperPanel, StepsByADistanceAndGoesHome) {
    enable();
    EXPECT_EQ(tip("stepGoHomeButton"), "Home is unknown: search for it, or save it.");
    click("stepSaveHomeButton");
    type("stepStepSizeField", QStringLiteral("120"));
    type("stepStepRoundsField", QStringLiteral("3"));
    click("stepStepForwardButton");
    ASSERT_TRUE(standsAt(360));
    EXPECT_EQ(position(), 360);
    ASSERT_TRUE(waitFor([&] { return !changing(); }));
    click("stepGoHomeButton");
    ASSERT_TRUE(standsAt(0));
    type("stepStepRoundsField", QStringLiteral("500"));
    click("stepStepReverseButton");
    ASSERT_TRUE(waitFor([&] { return position() < -100; }));
    click("stepStepEndButton");
    ASSERT_TRUE(waitFor([&] { return !changing() && !module().moving(); }));
    const int stood = position();
    ASSERT_TRUE(answersFor(1.0));
    EXPECT_EQ(position(), stood) << "no more steps";
}

TEST_F(StepperPanel, ASecondLookAtTheServoChangesNothing) {
    enable();
    auto& list = find<QAbstractItemView>("chainList");
    list.setCurrentIndex(list.model()->index(0, 0));
    EXPECT_TRUE(waitFor([&] { return find("servoPanel").isVisible(); }));
    list.setCurrentIndex(list.model()->index(1, 0));
    EXPECT_TRUE(waitFor([&] { return find("stepPanel").isVisible(); }));
    EXPECT_EQ(find<QLineEdit>("stepRunCurrentField").text(), QStringLiteral("120"));
    EXPECT_EQ(text("stepRunCurrentState"), QStringLiteral("✓ sent"));
    EXPECT_EQ(module().activity(), Activity::Holding);
}

}  // namespace
}  // namespace nmc

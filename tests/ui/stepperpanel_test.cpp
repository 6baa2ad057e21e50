// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/stepperfixture.h"
#include "tests/support/motionof.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing_support::kAmplifier;
using testing_support::kLimit1In;
using testing_support::kStepPower;
using testing_support::Stepper;

class StepperPanelTest : public WindowTest {
protected:
    void show(const Stepper& stepper) { window->showLink(connectedTo({stepper.module})); }
    template <typename T>
    std::optional<T> asked(int number = 0) {
        if (intents.size() <= number)
            return std::nullopt;
        const auto intent = intents.at(number).at(1).value<Intent>();
        const T* wanted = std::get_if<T>(&intent);
        return wanted == nullptr ? std::nullopt : std::optional(*wanted);
    }
    /// Clicks the mark itself: a choice as wide as its row does not react everywhere.
    void choose(const QString& mode) {
        QAbstractButton* choice = button(mode);
        QTest::mouseClick(choice, Qt::LeftButton, {}, {choice->height() / 2, choice->height() / 2});
    }
    void bringUp(int page) { find<QTabWidget>(u"stepperPages"_s)->setCurrentIndex(page); }
    QString plain(const QString& label) { return text(label).replace(QChar(0x202F), u' '); }

    QSignalSpy intents{&window->requests(), &Requests::intent};
    QSignalSpy edits{&window->requests(), &Requests::axisEdited};
    QSignalSpy holds{&window->requests(), &Requests::hold};
    QSignalSpy releases{&window->requests(), &Requests::holdReleased};
};

TEST_F(StepperPanelTest, ShowsAModuleAndAsksForNothing) {
    show(Stepper::holding());
    EXPECT_TRUE(find(u"stepperPanel"_s)->isVisible());
    EXPECT_EQ(window->findChild<QWidget*>(u"servoPanel"_s), nullptr) << "it is not needed yet";
    EXPECT_EQ(text(u"stepperStateLabel"_s), u"Holding"_s);
    EXPECT_EQ(text(u"stepperPositionUnit"_s), u"steps"_s);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_EQ(edits.size(), 0);
}

TEST_F(StepperPanelTest, OffersWhatTheChipForbidsAsStopWaitGo) {
    show(Stepper::running());
    choose(u"stepperModeProfile"_s);
    EXPECT_EQ(button(u"stepperRunForwardButton"_s)->text(), u"R&un forward"_s);
    EXPECT_EQ(button(u"stepperRunReverseButton"_s)->text(), u"Stop, wait: Run &reverse"_s);
    click(u"stepperRunReverseButton"_s);
    const auto change = asked<intent::ChangeMotion>();
    ASSERT_TRUE(change);
    // 200 steps/s at 1x is speed 8; the initial acceleration time is 40, which is 10 ms.
    EXPECT_EQ(change->motion, StepperMotion(steppermotion::VelocityProfile{8, 40, true}));
}

TEST_F(StepperPanelTest, OffersAMoveOutOfARunAsStopWaitGo) {
    show(Stepper::running());
    type(u"stepperGoalField"_s, u"900"_s);
    EXPECT_EQ(button(u"stepperGoButton"_s)->text(), u"Stop, wait: &Go"_s);
    EXPECT_EQ(button(u"stepperGoButton"_s)->shortcut(), QKeySequence(Qt::ALT | Qt::Key_G));
    click(u"stepperLoadOnlyBox"_s);
    EXPECT_EQ(button(u"stepperGoButton"_s)->text(), u"Load"_s) << "a load does not stop anything (DS-S 5.1)";
    EXPECT_TRUE(button(u"stepperGoButton"_s)->isEnabled());
    click(u"stepperLoadOnlyBox"_s);
    click(u"stepperGoButton"_s);
    const auto change = asked<intent::ChangeMotion>();
    ASSERT_TRUE(change);
    EXPECT_EQ(change->motion, StepperMotion(steppermotion::Trapezoid{900, false, 16, 40}));
}

TEST_F(StepperPanelTest, StartsAMoveByEnterAndOnlyOnceForADoubleClick) {
    show(Stepper::holding());
    type(u"stepperGoalField"_s, u"-300"_s);
    QTest::keyClick(field(u"stepperGoalField"_s), Qt::Key_Return);
    click(u"stepperGoButton"_s);
    EXPECT_EQ(intents.size(), 1);
    const auto move = asked<intent::Move>();
    ASSERT_TRUE(move);
    EXPECT_EQ(test::motionOf<steppermotion::Trapezoid>(*move),
              (steppermotion::Trapezoid{-300, false, 16, 40}));
    click(u"stepperStopAbruptlyButton"_s);
    EXPECT_TRUE(asked<intent::StopAbruptly>(1)) << "a stop never waits";
}

/// Scan again leaves no goal that nobody has typed.
TEST_F(StepperPanelTest, LookingAgainLeavesNoGoalToGoTo) {
    LinkState link = connectedTo({Stepper::holding().module});
    window->showLink(link);
    type(u"stepperGoalField"_s, u"-300"_s);
    link.phase = LinkPhase::Connecting;
    link.looking = true;
    window->showLink(link);
    link.phase = LinkPhase::Connected;
    link.looking = false;
    window->showLink(link);
    EXPECT_EQ(field(u"stepperGoalField"_s)->text(), QString());
    EXPECT_FALSE(button(u"stepperGoButton"_s)->isEnabled());
    EXPECT_EQ(button(u"stepperGoButton"_s)->toolTip(), field(u"stepperGoalField"_s)->problemText());
    QTest::keyClick(field(u"stepperGoalField"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(StepperPanelTest, SaysTheRangeAndSendsNothingOutOfIt) {
    show(Stepper::holding());
    type(u"stepperSpeedField"_s, u"6251"_s);
    EXPECT_FALSE(button(u"stepperGoButton"_s)->isEnabled());
    EXPECT_TRUE(plain(u"stepperMotionHint"_s).contains(u"6250"_s))
        << text(u"stepperMotionHint"_s).toStdString();
    QTest::keyClick(field(u"stepperGoalField"_s), Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
    // The timer allows higher speeds than the profile: 625 000 / 86.
    choose(u"stepperModeTimedMove"_s);
    type(u"stepperSpeedField"_s, u"7000"_s);
    EXPECT_TRUE(button(u"stepperGoButton"_s)->isEnabled())
        << button(u"stepperGoButton"_s)->toolTip().toStdString();
    EXPECT_EQ(text(u"stepperRampOutcome"_s), u"No ramp."_s);
}

TEST_F(StepperPanelTest, DoesNotGoHomeAtAnotherSpeedThanTheOneThatIsTyped) {
    Stepper stepper = Stepper::holding();
    stepper.module.home.found(500, stepper.time);
    show(stepper);
    EXPECT_TRUE(button(u"stepperGoHomeButton"_s)->isEnabled())
        << button(u"stepperGoHomeButton"_s)->toolTip().toStdString();
    type(u"stepperSpeedField"_s, u"6251"_s);
    EXPECT_FALSE(button(u"stepperGoHomeButton"_s)->isEnabled());
    EXPECT_EQ(button(u"stepperGoHomeButton"_s)->toolTip(), field(u"stepperSpeedField"_s)->problemText());
}

TEST_F(StepperPanelTest, KeepsSpeedsInTheSettingsPerKindOfMotion) {
    show(Stepper::holding());
    type(u"stepperSpeedField"_s, u"800"_s);
    choose(u"stepperModeProfile"_s);
    EXPECT_EQ(field(u"stepperSpeedField"_s)->text(), u"200"_s);
    type(u"stepperSpeedField"_s, u"300"_s);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).motion.velocity, 800);
    EXPECT_EQ(machine.axis(ModuleIndex(0)).motion.runVelocity, 300);
    choose(u"stepperModeTrapezoidal"_s);
    EXPECT_EQ(field(u"stepperSpeedField"_s)->text(), u"800"_s);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(StepperPanelTest, ReadsInTheUsersUnitAndChangesNothingBySwitchingIt) {
    show(Stepper::holding());
    type(u"stepperGoalField"_s, u"1000"_s);
    const auto before = edits.size();
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 200.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(edits.size(), before);
    EXPECT_EQ(field(u"stepperGoalField"_s)->value(), 5.0) << "1000 steps of 200 a millimetre";
    EXPECT_EQ(text(u"stepperGoalFieldUnit"_s), u"mm"_s);
    EXPECT_EQ(field(u"stepperSpeedField"_s)->value(), 2.0);
    EXPECT_TRUE(field(u"stepperSpeedField"_s)->toolTip().contains(u" mm/s)"_s))
        << field(u"stepperSpeedField"_s)->toolTip().toStdString();
    EXPECT_EQ(text(u"stepperSpeedFieldPerSecond"_s), u"= 400 steps/s"_s);
    EXPECT_EQ(plain(u"stepperSpeedOutcome"_s), u"Runs at 400 steps/s (2 mm/s): speed 16 of 250."_s);
    // 25 steps/s each 10 ms are 2 500 steps/s^2, 12.5 mm/s^2.
    EXPECT_EQ(plain(u"stepperRampOutcome"_s), u"Ramp of 2 500 steps/s² (12.5 mm/s²)."_s);
}

// A reading of 200 of 255, at half a degree per step, from -10 degrees.
TEST_F(StepperPanelTest, ReadsTheTemperatureInTheUsersScale) {
    show(Stepper::holding());
    EXPECT_EQ(text(u"stepperAnalogLabel"_s), u"3.92 V (200 of 255)"_s);
    machine.axes.resize(1);
    machine.axes[0].analog = {0.5, -10.0, "°C"};
    window->showMachine(machine);
    EXPECT_EQ(text(u"stepperAnalogLabel"_s), u"90 °C (200 of 255)"_s);
    EXPECT_EQ(text(u"stepperIoAnalog"_s), u"90 °C (200 of 255)"_s);
}

TEST_F(StepperPanelTest, SaysWhatBlocksADirection) {
    Stepper stepper = Stepper::holding();
    stepper.inputs = kLimit1In;
    stepper.says(kStepPower | kAmplifier);
    show(stepper);
    choose(u"stepperModeTimedRun"_s);
    EXPECT_FALSE(button(u"stepperRunForwardButton"_s)->isEnabled());
    EXPECT_EQ(button(u"stepperRunForwardButton"_s)->toolTip(), texts::refusal(Refusal::Limit1Active));
    EXPECT_TRUE(button(u"stepperRunReverseButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"stepperHoldForwardButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"stepperHoldReverseButton"_s)->isEnabled());
    EXPECT_EQ(text(u"stepperLimit1InputEffect"_s), u"blocks forward"_s);
}

TEST_F(StepperPanelTest, HoldsAtALowSpeedAndEndsWithTheModeAndTheModule) {
    show(Stepper::holding());
    auto* forward = button(u"stepperHoldForwardButton"_s);
    QTest::mousePress(forward, Qt::LeftButton);
    ASSERT_EQ(holds.size(), 1);
    const auto hold = holds.at(0).at(0).value<bus::HoldToMove>();
    EXPECT_EQ(hold.pace, (bus::StepperPace{4, 40})) << "100 steps/s";
    EXPECT_FALSE(hold.reverse);
    choose(u"stepperModeProfile"_s);
    EXPECT_EQ(releases.size(), 1) << "the mode has changed";
    QTest::mouseRelease(forward, Qt::LeftButton);
    QTest::mousePress(forward, Qt::LeftButton);
    Stepper blocked = Stepper::holding();
    blocked.inputs = kLimit1In;
    blocked.says(kStepPower | kAmplifier);
    show(blocked);
    EXPECT_EQ(releases.size(), 2) << "it is no longer allowed";
    QTest::mouseRelease(forward, Qt::LeftButton);
}

TEST_F(StepperPanelTest, NeverHoldsFasterThanWhatStandsThere) {
    show(Stepper::holding());
    type(u"stepperHoldVelocityField"_s, u"149"_s);
    QTest::mousePress(button(u"stepperHoldReverseButton"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), 1);
    EXPECT_EQ(holds.at(0).at(0).value<bus::HoldToMove>().pace->speed, 5) << "125 steps/s, not 150";
    QTest::mouseRelease(button(u"stepperHoldReverseButton"_s), Qt::LeftButton);
}

TEST_F(StepperPanelTest, StagesParametersAndSendsThemAllAtOnce) {
    window->resize(1'456, 952);  // a smaller one shows marks instead of words
    Stepper fresh;
    fresh.says(kStepPower);
    show(fresh);
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"? unknown"_s);
    EXPECT_FALSE(button(u"stepperApplyParametersButton"_s)->isEnabled());
    click(u"stepperFillParametersButton"_s);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"● not sent"_s);
    type(u"stepperRunCurrentField"_s, u"90"_s);
    click(u"stepperApplyParametersButton"_s);
    const auto set = asked<stepperintent::SetParameters>();
    ASSERT_TRUE(set);
    EXPECT_EQ(set->parameters,
              (stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 4, 90, 32, 0}));
    EXPECT_EQ(machine.axis(ModuleIndex(0)).parameters, set->parameters);
    fresh.was(set->parameters);
    fresh.says(kStepPower);
    show(fresh);
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"✓ sent"_s);
    EXPECT_FALSE(button(u"stepperRevertParametersButton"_s)->isEnabled());
    type(u"stepperRunCurrentField"_s, u"91"_s);
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"● not sent"_s);
    click(u"stepperRevertParametersButton"_s);
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), u"90"_s);
}

TEST_F(StepperPanelTest, EditsOfParametersAreUndoneAndRedoneAndSendNothing) {
    window->resize(1'456, 952);
    Stepper fresh;
    fresh.says(kStepPower);
    show(fresh);
    EXPECT_FALSE(button(u"stepperUndoParametersButton"_s)->isEnabled());
    type(u"stepperRunCurrentField"_s, u"77"_s);
    click(u"stepperFillParametersButton"_s);
    click(u"stepperIgnoreEstopField"_s);
    EXPECT_TRUE(button(u"stepperIgnoreEstopField"_s)->isChecked());
    click(u"stepperUndoParametersButton"_s);
    EXPECT_FALSE(button(u"stepperIgnoreEstopField"_s)->isChecked());
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), u"64"_s) << "a starting value";
    click(u"stepperUndoParametersButton"_s);
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), u"77"_s);
    EXPECT_EQ(find<QComboBox>(u"stepperSpeedModeField"_s)->currentIndex(), -1);
    click(u"stepperUndoParametersButton"_s);
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), QString());
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"? unknown"_s);
    click(u"stepperRedoParametersButton"_s);
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), u"77"_s);
    EXPECT_EQ(text(u"stepperRunCurrentState"_s), u"● not sent"_s);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(StepperPanelTest, AnEmptyFieldStaysEmptyInAnotherUnit) {
    Stepper first = Stepper::holding();
    Stepper second;
    second.says(kStepPower);
    second.module.info.index = ModuleIndex(1);
    window->showLink(connectedTo({first.module, second.module}));
    EXPECT_EQ(field(u"stepperMinimumSpeedField"_s)->text(), u"100"_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    machine.axes.resize(2);
    machine.axes[1].unit = {UnitKind::Millimetres, 200.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(field(u"stepperMinimumSpeedField"_s)->text(), QString());
}

TEST_F(StepperPanelTest, KeepsUnfinishedEditsPerModule) {
    Stepper first;
    first.says(kStepPower);
    Stepper second = first;
    second.module.info.index = ModuleIndex(1);
    window->showLink(connectedTo({first.module, second.module}));
    type(u"stepperRunCurrentField"_s, u"77"_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), QString());
    chain->setCurrentIndex(chain->model()->index(0, 0));
    EXPECT_EQ(field(u"stepperRunCurrentField"_s)->text(), u"77"_s);
}

/// DS-S 5.1 Set Parameters: in motion "any changes to the speed mode bits and minimum profile speed will be
/// ignored".
TEST_F(StepperPanelTest, SendsParametersInMotionButForThoseThatTheChipIgnores) {
    show(Stepper::running());
    type(u"stepperRunCurrentField"_s, u"90"_s);
    click(u"stepperApplyParametersButton"_s);
    const auto set = asked<stepperintent::SetParameters>();
    ASSERT_TRUE(set);
    EXPECT_EQ(set->parameters.runCurrent, 90);
}

TEST_F(StepperPanelTest, TheMinimumSpeedWaitsForStandstill) {
    show(Stepper::running());
    type(u"stepperMinimumSpeedField"_s, u"200"_s);
    EXPECT_FALSE(button(u"stepperApplyParametersButton"_s)->isEnabled());
    EXPECT_EQ(button(u"stepperApplyParametersButton"_s)->toolTip(), texts::refusal(Refusal::NeedsStop));
}

TEST_F(StepperPanelTest, TheWheelDoesNothingToAChoiceWithoutFocus) {
    show(Stepper::holding());
    auto* mode = find<QComboBox>(u"stepperSpeedModeField"_s);
    button(u"stepperGoButton"_s)->setFocus();
    const int before = mode->currentIndex();
    QWheelEvent wheel(QPointF(5, 5), mode->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(mode, &wheel);
    EXPECT_EQ(mode->currentIndex(), before);
}

TEST_F(StepperPanelTest, OutputsThatNobodyKnowsAreChosenAllBeforeTheyAreSent) {
    Stepper stepper;
    stepper.module.attached();
    stepper.says(kStepPower);
    show(stepper);
    bringUp(1);
    EXPECT_EQ(find<QCheckBox>(u"stepperOutput1Box"_s)->checkState(), Qt::PartiallyChecked);
    EXPECT_FALSE(button(u"stepperSetOutputsButton"_s)->isEnabled());
    for (int i = 1; i <= 5; ++i)
        button(u"stepperOutput%1Box"_s.arg(i))->click();
    // A click on what is unknown chooses "high"; a second one on the third "low".
    button(u"stepperOutput3Box"_s)->click();
    EXPECT_EQ(text(u"stepperOutput3State"_s), u"● low, not sent"_s);
    EXPECT_EQ(intents.size(), 0);
    click(u"stepperSetOutputsButton"_s);
    ASSERT_TRUE(asked<stepperintent::SetOutputs>());
    EXPECT_EQ(asked<stepperintent::SetOutputs>()->outputs, 0x1B);
}

TEST_F(StepperPanelTest, AnOutputThatIsKnownShowsWhatWasConfirmed) {
    show(Stepper::holding());
    bringUp(1);
    EXPECT_FALSE(button(u"stepperSetOutputsButton"_s)->isVisible());
    button(u"stepperOutput1Box"_s)->click();
    ASSERT_TRUE(asked<stepperintent::SetOutputs>());
    EXPECT_EQ(asked<stepperintent::SetOutputs>()->outputs, 0x11);
    EXPECT_FALSE(button(u"stepperOutput1Box"_s)->isChecked()) << "not before the module has confirmed it";
}

TEST_F(StepperPanelTest, SaysWhyNothingIsPossibleWithoutAConnection) {
    LinkState link = connectedTo({Stepper::holding().module});
    link.phase = LinkPhase::Lost;
    window->showLink(link);
    for (const char* name : {"stepperGoButton", "stepperHoldForwardButton", "stepperApplyParametersButton",
                             "stepperZeroHereButton"}) {
        EXPECT_FALSE(button(QLatin1String(name))->isEnabled()) << name;
        EXPECT_EQ(button(QLatin1String(name))->toolTip(), texts::refusal(Refusal::NotConnected)) << name;
    }
}

TEST_F(StepperPanelTest, EachControlIsReachedByTab) {
    show(Stepper::holding());
    for (int page = 0; page < find<QTabWidget>(u"stepperPages"_s)->count(); ++page) {
        bringUp(page);
        const QSet<const QWidget*> reached = reachedByTab();
        for (const QWidget* control : find(u"stepperPanel"_s)->findChildren<QWidget*>()) {
            const bool operates = qobject_cast<const QAbstractButton*>(control) != nullptr ||
                                  qobject_cast<const QLineEdit*>(control) != nullptr ||
                                  qobject_cast<const QComboBox*>(control) != nullptr;
            if (!operates || !control->isVisible() || control->parentWidget()->inherits("QTabBar"))
                continue;
            // Among exclusive choices, Tab reaches only the selected one.
            const auto* choice = qobject_cast<const QAbstractButton*>(control);
            const bool another = choice != nullptr && choice->autoExclusive() && !choice->isChecked();
            EXPECT_TRUE(reached.contains(control) || !control->isEnabled() || another)
                << control->objectName().toStdString();
            EXPECT_FALSE(control->accessibleName().isEmpty()) << control->objectName().toStdString();
            EXPECT_FALSE(control->toolTip().isEmpty()) << control->objectName().toStdString();
        }
    }
}

}  // namespace
}  // namespace nmc

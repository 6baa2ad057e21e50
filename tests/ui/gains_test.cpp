// SPDX-License-Identifier: GPL-3.0-or-later
#include "windowtest.h"

namespace nmc {
namespace {

class Gains : public WindowTest {
protected:
    void typeAll(const std::array<const char*, 9>& values) {
        for (std::size_t i = 0; i < kNames.size(); ++i)
            type(kNames[i] + u"Field"_s, QLatin1StringView(values[i]));
    }
    servo::SetGain sent(qsizetype i = 0) {
        return std::get<intent::ApplyGains>(intents.at(i).at(1).value<Intent>()).gains;
    }
    const std::array<QString, 9> kNames{u"kp"_s, u"kd"_s, u"ki"_s, u"il"_s, u"ol"_s,
                                        u"cl"_s, u"el"_s, u"sr"_s, u"db"_s};
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Gains, U04_AreStagedAndAppliedAllAtOnce) {
    showServo({.on = false, .gains = false});
    typeAll({"1", "2", "3", "4", "5", "6", "7", "8", "9"});
    EXPECT_EQ(intents.size(), 0);
    click(u"applyGainsButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(sent(), (servo::SetGain{1, 2, 3, 4, 5, 6, 7, 8, std::uint8_t(9)}));
}

TEST_F(Gains, U04_OlderVersionsHaveNoDeadband) {
    showServo({.version = 3, .on = false, .gains = false});
    EXPECT_FALSE(field(u"dbField"_s)->isVisible());
    for (std::size_t i = 0; i < 8; ++i)
        type(kNames[i] + u"Field"_s, u"1"_s);
    click(u"applyGainsButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(sent().db, std::nullopt);
}

TEST_F(Gains, SayWhetherTheyWereSentEditedOrNobodyKnows) {
    showServo({.gains = false});
    EXPECT_TRUE(text(u"kpState"_s).contains(u"unknown"_s));
    EXPECT_TRUE(field(u"kpField"_s)->text().isEmpty());
    type(u"kpField"_s, u"100"_s);
    EXPECT_TRUE(text(u"kpState"_s).contains(u"not sent"_s));
    showServo({.gains = true});
    EXPECT_TRUE(text(u"kpState"_s).contains(u"sent"_s));
    EXPECT_FALSE(text(u"kpState"_s).contains(u"not"_s));
    type(u"kpField"_s, u"101"_s);
    EXPECT_TRUE(text(u"kpState"_s).contains(u"not sent"_s));
}

/// A scroll bar that appears with the first digit would move the buttons away from under the mouse.
TEST_F(Gains, NeedNoScrollBarToSaySo) {
    window->resize(1'456, 952);
    showServo({.version = 10, .gains = false});
    type(u"kpField"_s, u"100"_s);
    const QScrollArea* around = nullptr;
    for (const QWidget* w = field(u"kpField"_s); w != nullptr && around == nullptr; w = w->parentWidget())
        around = qobject_cast<const QScrollArea*>(w);
    ASSERT_NE(around, nullptr);
    EXPECT_TRUE(eventually([&] { return around->horizontalScrollBar()->maximum() == 0; }));
}

/// It sends the present gains with another multiplier: in a trial, those have a lower output limit.
TEST_F(Gains, OfATrialAreNotSentAgainWithTheStepMultiplier) {
    showServo({.version = 10});
    EXPECT_TRUE(button(u"setMultiplierButton"_s)->isEnabled());
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    report.stage = ProcedureStage::Trying;
    window->showProcedure(report);
    EXPECT_FALSE(button(u"setMultiplierButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"setMultiplierButton"_s)->toolTip().startsWith(u"A task is running"_s));
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    EXPECT_TRUE(button(u"setMultiplierButton"_s)->isEnabled());
}

TEST_F(Gains, NeverClaimToBeReadFromTheModule) {
    showServo();
    for (const QLabel* label : window->findChildren<QLabel*>())
        EXPECT_FALSE(label->text().contains(u"read from"_s, Qt::CaseInsensitive))
            << label->text().toStdString();
}

TEST_F(Gains, U01_OutOfRangeIsNotSent) {
    const std::array<const char*, 9> tooMuch{"32768", "32768", "32768", "32768", "256",
                                             "256",   "16384", "256",   "256"};
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        showServo({.millisecond = static_cast<int>(i)});
        typeAll({"1", "1", "1", "1", "1", "1", "1", "1", "1"});
        EXPECT_TRUE(button(u"applyGainsButton"_s)->isEnabled());
        type(kNames[i] + u"Field"_s, QLatin1StringView(tooMuch[i]));
        EXPECT_FALSE(button(u"applyGainsButton"_s)->isEnabled()) << kNames[i].toStdString();
        EXPECT_TRUE(button(u"applyGainsButton"_s)->toolTip().contains(u"must be"_s));
        click(u"applyGainsButton"_s);
    }
    type(u"srField"_s, u"0"_s);
    EXPECT_FALSE(button(u"applyGainsButton"_s)->isEnabled());
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Gains, StartingValuesFillTheFieldsAndSendNothing) {
    window->resize(1'456, 952);  // a smaller one shows marks instead of words
    showServo({.on = false, .gains = false});
    click(u"fillGainsButton"_s);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_TRUE(button(u"applyGainsButton"_s)->isEnabled());
    EXPECT_TRUE(text(u"kpState"_s).contains(u"not sent"_s));
    EXPECT_EQ(field(u"olField"_s)->value(), 64) << "a quarter of 255";
    EXPECT_EQ(field(u"elField"_s)->value(), 500) << "a quarter of 2 000 counts";
}

TEST_F(Gains, StartingValuesFollowTheEncoder) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Turns, 4'000.0, {}};
    window->showMachine(machine);
    showServo({.on = false, .gains = false});
    click(u"fillGainsButton"_s);
    EXPECT_EQ(field(u"elField"_s)->value(), 1'000);
}

TEST_F(Gains, RevertGoesBackToWhatWasSent) {
    showServo();
    type(u"kpField"_s, u"7"_s);
    click(u"revertGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 100);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Gains, EachModuleHasItsOwnDraft) {
    showServos({{.gains = false}, {.gains = false}});
    type(u"kpField"_s, u"42"_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_TRUE(field(u"kpField"_s)->text().isEmpty());
    chain->setCurrentIndex(chain->model()->index(0, 0));
    EXPECT_EQ(field(u"kpField"_s)->value(), 42);
}

/// The same rule holds for both chips: an opened file takes precedence over what was typed and not sent.
TEST_F(Gains, AMachineFileGoesBeforeWhatWasTypedAndUndoBringsThatBack) {
    showServos({{.gains = false}, {.gains = false}});
    type(u"kpField"_s, u"42"_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    const auto select = [chain](int row) { chain->setCurrentIndex(chain->model()->index(row, 0)); };
    select(1);
    type(u"kpField"_s, u"43"_s);
    machine.axes.resize(2);
    for (AxisSettings& axis : machine.axes)
        axis.gains = someGains();
    window->showMachine(machine);
    EXPECT_EQ(field(u"kpField"_s)->value(), someGains().kp);
    click(u"undoGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 43);
    select(0);
    EXPECT_EQ(field(u"kpField"_s)->value(), someGains().kp)
        << "also if another module was shown when the file was opened";
}

TEST_F(Gains, ToolTipsGiveMeaningRangeAndAdvice) {
    showServo();
    EXPECT_TRUE(field(u"kdField"_s)->toolTip().contains(u"hum"_s));
    EXPECT_TRUE(field(u"elField"_s)->toolTip().contains(u"0 to 16383"_s));
    EXPECT_TRUE(field(u"clField"_s)->toolTip().contains(u"Odd"_s));
    EXPECT_TRUE(field(u"srField"_s)->toolTip().contains(u"velocity"_s));
}

TEST_F(Gains, SayWhenTheyActAtOnce) {
    showServo({.on = true});
    EXPECT_TRUE(button(u"applyGainsButton"_s)->text().contains(u"live"_s));
    showServo({.on = false});
    EXPECT_FALSE(button(u"applyGainsButton"_s)->text().contains(u"live"_s));
}

TEST_F(Gains, UndoChangesTheFieldAndNotTheMotor) {
    showServo();
    type(u"kpField"_s, u"150"_s);
    type(u"kdField"_s, u"2000"_s);
    QTest::keyClick(field(u"kdField"_s), Qt::Key_Z, Qt::ControlModifier);
    // A button that is clicked by its shortcut first looks pressed for a moment.
    EXPECT_TRUE(eventually([this] { return field(u"kdField"_s)->value() == 1000; }));
    EXPECT_EQ(field(u"kpField"_s)->value(), 150);
    click(u"undoGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 100);
    EXPECT_FALSE(button(u"undoGainsButton"_s)->isEnabled());
    click(u"redoGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 150);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Gains, UndoTakesBackAFillAsOneEdit) {
    showServo();
    click(u"zeroGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 0);
    EXPECT_EQ(field(u"srField"_s)->value(), 1);  // the lowest value that the chip accepts
    click(u"undoGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 100);
    EXPECT_EQ(field(u"elField"_s)->value(), 4000);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Gains, TheCurrentLimitsSenseIsItsParity) {
    showServo();
    auto* sense = find<QComboBox>(u"clSenseBox"_s);
    EXPECT_EQ(sense->currentText(), u"no current limit"_s);
    type(u"clField"_s, u"101"_s);
    EXPECT_TRUE(sense->currentText().contains(u"above"_s));
    // 101 of 255 steps of 5 V.
    EXPECT_EQ(text(u"clRemark"_s), u"= 1.98 V"_s);
    sense->setFocus();
    QTest::keyClick(sense, Qt::Key_Down);
    EXPECT_TRUE(sense->currentText().contains(u"below"_s));
    EXPECT_EQ(field(u"clField"_s)->value(), 100);
    QTest::keyClick(sense, Qt::Key_Up);
    EXPECT_EQ(field(u"clField"_s)->value(), 101);
    QTest::keyClick(sense, Qt::Key_Up);
    EXPECT_EQ(field(u"clField"_s)->value(), 0);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Gains, AnotherServoRateSaysWhatItDoesToVelocities) {
    showServo();
    type(u"srField"_s, u"2"_s);
    EXPECT_TRUE(find<QLabel>(u"gainsHint"_s)->isVisible());
    EXPECT_TRUE(text(u"gainsHint"_s).contains(u"the meaning of every velocity"_s));
    type(u"srField"_s, u"1"_s);
    EXPECT_FALSE(find<QLabel>(u"gainsHint"_s)->isVisible());
}

TEST_F(Gains, U04_ALargeStepWhileTheServoIsOnIsAskedAbout) {
    showServo();
    type(u"kpField"_s, u"201"_s);  // more than twice 100
    click(u"applyGainsButton"_s);
    EXPECT_EQ(intents.size(), 0);
    auto* dialog = find(u"largeStepDialog"_s);
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->findChild<QLabel*>(u"closeText"_s)->text().contains(u"Kp from 100 to 201"_s));
    QTest::mouseClick(button(u"applyLargeStepButton"_s), Qt::LeftButton);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(sent().kp, 201);
}

TEST_F(Gains, U04_TwiceIsNoLargeStepAndAServoThatIsOffDoesNotCare) {
    showServo();
    type(u"kpField"_s, u"200"_s);
    click(u"applyGainsButton"_s);
    EXPECT_EQ(intents.size(), 1);
    showServo({.on = false, .millisecond = 10});
    type(u"kpField"_s, u"5000"_s);
    click(u"applyGainsButton"_s);
    EXPECT_EQ(intents.size(), 2);
}

/// As when it was found running: another host may have set any gains.
TEST_F(Gains, U04_UnknownOnesWhileTheServoIsOnAreAskedAbout) {
    showServo({.gains = false});
    typeAll({"1", "2", "3", "4", "5", "6", "7", "8", "9"});
    click(u"applyGainsButton"_s);
    EXPECT_EQ(intents.size(), 0);
    auto* dialog = find(u"largeStepDialog"_s);
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->findChild<QLabel*>(u"closeText"_s)->text().contains(u"unknown"_s));
    QTest::mouseClick(button(u"applyLargeStepButton"_s), Qt::LeftButton);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(sent(), (servo::SetGain{1, 2, 3, 4, 5, 6, 7, 8, std::uint8_t(9)}));
}

TEST_F(Gains, U04_CancelSendsNothing) {
    showServo();
    type(u"kdField"_s, u"10"_s);
    click(u"applyGainsButton"_s);
    QTest::mouseClick(button(u"cancelLargeStepButton"_s), Qt::LeftButton);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_EQ(field(u"kdField"_s)->value(), 10);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// Operator mode in the window: who begins it, who leaves it, and what can be used in the meantime.
#include "tests/model/stepperfixture.h"
#include "widgets/mainwindow/bell.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/sequences/sequencesdock.h"
#include "windowtest.h"

namespace nmc {
namespace {

/// Some of its letters are no hexadecimal digits, so a hash in hexadecimal cannot contain it by chance.
const QString kPin = u"lathe-4711"_s;

class OperatorMode : public WindowTest {
protected:
    OperatorMode() {
        // Reacts to a change of the lock as the program does.
        QObject::connect(&window->operatorLock(), &OperatorLock::changed, window.get(), [this] { show(); });
        show();
    }
    void show(LinkState link = connectedTo({Servo{}.state()})) {
        link.rights = window->operatorLock().rights();
        for (ModuleState& module : link.modules)
            module.rights = link.rights;
        window->showLink(link);
    }
    void open() {
        settle();
        window->findChild<QAction*>(u"operatorAction"_s)->trigger();
    }
    /// Deletes questions that were answered.
    static void settle() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }
    void typePin(const QString& field, const QString& pin) {
        auto* edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, pin);
    }
    void begin() {
        open();
        typePin(u"operatorPinField"_s, kPin);
        typePin(u"operatorPinAgainField"_s, kPin);
        click(u"operatorBeginButton"_s);
        ASSERT_TRUE(window->operatorLock().isLocked());
        settle();
    }
    /// Adds moves to what is left by default.
    void beginWithMoves() {
        open();
        auto* moves = button(u"operatorMovesBox"_s);
        QTest::mouseClick(moves, Qt::LeftButton, {}, {moves->height() / 2, moves->height() / 2});
        typePin(u"operatorPinField"_s, kPin);
        typePin(u"operatorPinAgainField"_s, kPin);
        click(u"operatorBeginButton"_s);
        ASSERT_TRUE(window->operatorLock().isLocked());
        settle();
    }
    /// Takes jogging away from what is left by default, and adds homing.
    void beginWithHomingInsteadOfJog() {
        open();
        for (const QString& name : {u"operatorHomingBox"_s, u"operatorJogBox"_s}) {
            auto* box = button(name);
            QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
        }
        typePin(u"operatorPinField"_s, kPin);
        typePin(u"operatorPinAgainField"_s, kPin);
        click(u"operatorBeginButton"_s);
    }
    [[nodiscard]] static ModuleState stepper() {
        ModuleState module;
        module.info.identity = {ModuleType::Stepper, 1};
        module.info.address = BusAddress(1);
        bus::Sample sample;
        sample.report.status = std::uint8_t{0x0C};  // amplifier enabled, power
        sample.report.position = 0;
        sample.report.aux = std::uint8_t{0};
        sample.report.analog = std::uint8_t{200};
        module.apply(sample);
        return module;
    }
    /// All buttons except those that leave the mode or the connection.
    [[nodiscard]] QList<QPointer<QAbstractButton>> buttons() {
        QList<QPointer<QAbstractButton>> all;
        for (QAbstractButton* button : window->findChildren<QAbstractButton*>())
            if (const QString name = button->objectName();
                !name.isEmpty() && !name.startsWith(u"qt_"_s) && name != u"leaveOperatorButton"_s &&
                name != u"disconnectButton"_s && name != u"connectButton"_s)
                all << button;
        return all;
    }
    [[nodiscard]] bool enabled(const char* name) { return button(QString::fromLatin1(name))->isEnabled(); }
};

TEST_F(OperatorMode, LeavesJogAndStopsAndTakesTheRest) {
    ASSERT_TRUE(enabled("runForwardButton"));
    begin();
    EXPECT_TRUE(find(u"operatorRibbon"_s)->isVisible());
    for (const char* left : {"holdForwardButton", "holdReverseButton", "stopSmoothlyButton",
                             "stopAbruptlyButton", "motorOffButton", "stopAllButton", "disconnectButton"})
        EXPECT_TRUE(enabled(left)) << left;
    for (const char* taken : {"runForwardButton", "goButton", "goHomeButton", "zeroHereButton"})
        EXPECT_FALSE(enabled(taken)) << taken;
    EXPECT_TRUE(button(u"runForwardButton"_s)->toolTip().contains(u"operator mode"_s));
    for (const char* action :
         {"newMachineAction", "openMachineAction", "saveMachineAction", "restartNetworkAction"})
        EXPECT_FALSE(window->findChild<QAction*>(QString::fromLatin1(action))->isEnabled()) << action;
    EXPECT_FALSE(field(u"kpField"_s)->isEnabled());
}

/// They would be put into the fields of a locked page, and taken back without a word.
TEST_F(OperatorMode, FillsInNoGains) {
    window->findChild<QAction*>(u"responseDockAction"_s)->trigger();
    ASSERT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    begin();
    for (const char* taken : {"undoGainsButton", "redoGainsButton", "revertGainsButton", "zeroGainsButton",
                              "fillGainsButton", "responseUseGainsButton", "fillSuggestedButton"}) {
        EXPECT_FALSE(enabled(taken)) << taken;
        EXPECT_TRUE(button(QLatin1String(taken))->toolTip().contains(u"operator mode"_s)) << taken;
    }
}

/// Keeping gains on trial is applying them.
TEST_F(OperatorMode, KeepsNoGainsOnTrial) {
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    window->showProcedure(report);
    EXPECT_FALSE(enabled("keepGainsButton")) << "they have not been sent yet";
    report.stage = ProcedureStage::Trying;
    window->showProcedure(report);
    EXPECT_TRUE(enabled("keepGainsButton"));
    begin();
    EXPECT_FALSE(enabled("keepGainsButton"));
    EXPECT_TRUE(button(u"keepGainsButton"_s)->toolTip().contains(u"operator mode"_s));
}

TEST_F(OperatorMode, IsLeftWithThePinOnly) {
    begin();
    click(u"leaveOperatorButton"_s);
    typePin(u"operatorPinField"_s, u"4712"_s);
    click(u"operatorLeaveButton"_s);
    EXPECT_TRUE(window->operatorLock().isLocked());
    EXPECT_TRUE(text(u"operatorProblem"_s).startsWith(u"Wrong PIN."_s));
    typePin(u"operatorPinField"_s, kPin);
    QTest::keyClick(find<QLineEdit>(u"operatorPinField"_s), Qt::Key_Return);
    EXPECT_FALSE(window->operatorLock().isLocked());
    EXPECT_TRUE(enabled("runForwardButton"));
    EXPECT_FALSE(find(u"operatorRibbon"_s)->isVisible());
    EXPECT_TRUE(field(u"kpField"_s)->isEnabled());
}

TEST_F(OperatorMode, APinHasFourCharactersTwiceTheSame) {
    open();
    typePin(u"operatorPinField"_s, u"471"_s);
    typePin(u"operatorPinAgainField"_s, u"471"_s);
    click(u"operatorBeginButton"_s);
    EXPECT_TRUE(text(u"operatorProblem"_s).contains(u"too short"_s));
    typePin(u"operatorPinField"_s, kPin);
    click(u"operatorBeginButton"_s);
    EXPECT_TRUE(text(u"operatorProblem"_s).contains(u"differ"_s));
    EXPECT_FALSE(window->operatorLock().isLocked());
}

TEST_F(OperatorMode, OutlivesTheSessionAndThePinIsNotInTheSettings) {
    begin();
    for (const QString& key : settings.allKeys())
        EXPECT_FALSE(settings.value(key).toString().contains(kPin)) << key.toStdString();
    window = std::make_unique<MainWindow>(settings);
    EXPECT_TRUE(window->operatorLock().isLocked());
}

/// The operator may move, but the settings are not his to change; what he types is for his moves only.
TEST_F(OperatorMode, WhatIsTypedForAMoveStaysInItsField) {
    ASSERT_NO_FATAL_FAILURE(beginWithMoves());
    show();
    type(u"moveByDistanceField"_s, u"3"_s);
    type(u"velocityField"_s, u"0.25"_s);
    show(connectedTo({Servo{.millisecond = 40}.state()}));
    EXPECT_EQ(field(u"moveByDistanceField"_s)->text(), u"3"_s);
    EXPECT_EQ(field(u"velocityField"_s)->text(), u"0.25"_s);
    EXPECT_TRUE(machine.axes.empty() || machine.axes[0] == AxisSettings{}) << "they are not stored";
}

TEST_F(OperatorMode, AStepperStepsAndGoesHomeAtTheSpeedThatIsTyped) {
    ASSERT_NO_FATAL_FAILURE(beginWithMoves());
    testing_support::Stepper chip = testing_support::Stepper::holding();
    chip.module.home.found(500, chip.time);
    show(connectedTo({chip.module}));
    QSignalSpy intents(&window->requests(), &Requests::intent);
    type(u"stepperSpeedField"_s, u"800"_s);
    click(u"stepperMoveByForwardButton"_s);
    chip.says(testing_support::kStepOn);
    show(connectedTo({chip.module}));
    click(u"stepperGoHomeButton"_s);
    ASSERT_EQ(intents.size(), 2);
    // 800 steps/s at 1x, where a unit is 25 steps/s, is speed 32; the initial acceleration time is 40.
    const Pace typed = bus::StepperPace{32, 40};
    EXPECT_EQ(std::get<intent::MoveBy>(intents.at(0).at(1).value<Intent>()).pace, typed);
    EXPECT_EQ(std::get<intent::GoHome>(intents.at(1).at(1).value<Intent>()).pace, typed);
    EXPECT_TRUE(machine.axes.empty() || machine.axes[0] == AxisSettings{}) << "it is not stored";
}

TEST_F(OperatorMode, TheUserChoosesWhatIsLeftForTheMachine) {
    QSignalSpy edited(&window->operatorLock(), &OperatorLock::rightsEdited);
    beginWithHomingInsteadOfJog();
    ASSERT_EQ(edited.size(), 1);
    const auto rights = edited.at(0).at(0).value<OperatorRights>();
    EXPECT_TRUE(rights.homing);
    EXPECT_FALSE(rights.jog);
    EXPECT_FALSE(enabled("holdForwardButton"));
}

/// Otherwise the fields would take what is typed, and Home would search with what is stored.
TEST_F(OperatorMode, SearchesForHomeWithTheStoredRecipe) {
    type(u"homingVelocityField"_s, u"x"_s);
    beginWithHomingInsteadOfJog();
    settle();
    show();
    for (const char* locked :
         {"onLimit2Box", "thenIndexBox", "homingForwardButton", "homingSmoothlyButton", "makeZeroBox"})
        EXPECT_FALSE(enabled(locked)) << locked;
    for (const QString& locked : {u"homingVelocityField"_s, u"homingAccelerationField"_s,
                                  u"homingTravelField"_s, u"homingTimeField"_s}) {
        EXPECT_FALSE(field(locked)->isEnabled()) << locked.toStdString();
        EXPECT_TRUE(field(locked)->toolTip().contains(u"operator mode"_s)) << locked.toStdString();
    }
    EXPECT_TRUE(enabled("homeButton")) << button(u"homeButton"_s)->toolTip().toStdString();
}

TEST_F(OperatorMode, WhatWasChosenOutlivesTheSessionUntilAMachineSaysOtherwise) {
    beginWithHomingInsteadOfJog();
    window = std::make_unique<MainWindow>(settings);
    const OperatorLock& lock = window->operatorLock();
    const OperatorRights chosen{.jog = false, .homing = true};
    EXPECT_EQ(lock.rights(), chosen);
    window->showMachine({});  // as at the start, when none is loaded
    EXPECT_EQ(lock.rights(), chosen);
    machine.operatorRights = OperatorRights{.outputs = true};
    window->showMachine(machine);
    EXPECT_EQ(lock.rights(), machine.operatorRights);
}

TEST_F(OperatorMode, AMachineThatSaysOtherwiseIsFollowedAtOnce) {
    begin();
    EXPECT_FALSE(enabled("runForwardButton"));
    machine.operatorRights = OperatorRights{.moves = true};
    window->showMachine(machine);
    EXPECT_TRUE(enabled("runForwardButton"));
}

TEST_F(OperatorMode, StopsInEveryPhaseAndWhileItsQuestionStands) {
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    begin();
    int expected = 0;
    LinkState link = connectedTo({Servo{.moveDone = false}.state()});
    for (const LinkPhase phase : {LinkPhase::Connected, LinkPhase::Connecting, LinkPhase::Lost}) {
        link.phase = phase;
        show(link);
        click(u"stopAllButton"_s);
        EXPECT_EQ(stops.size(), ++expected);
        click(u"leaveOperatorButton"_s);
        QTest::keyClick(find(u"operatorDialog"_s), Qt::Key_Escape);
        EXPECT_EQ(stops.size(), ++expected) << "Esc works in the question";
        settle();
    }
}

TEST_F(OperatorMode, DoesNotKeepAnybodyFromLeavingThePort) {
    begin();
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 1);
}

TEST_F(OperatorMode, AMessageSaysWhyItsButtonDoesNotAct) {
    begin();
    window->showMessage(texts::restarted({ModuleIndex(0)}, 1));
    auto* readdress = window->findChild<QAbstractButton*>(u"listAction_readdress"_s);
    ASSERT_NE(readdress, nullptr);
    EXPECT_FALSE(readdress->isEnabled());
    EXPECT_TRUE(readdress->toolTip().contains(u"operator mode"_s));
}

TEST_F(OperatorMode, WhatIsExpectedOfTheChainIsNotForTheOperator) {
    begin();
    window->findChild<QAction*>(u"chainDoctorAction"_s)->trigger();
    EXPECT_FALSE(enabled("acceptChainButton"));
    EXPECT_TRUE(button(u"acceptChainButton"_s)->toolTip().contains(u"operator mode"_s));
}

/// Presses each enabled button of the window as a user would: whatever it requests is allowed for the
/// operator, and no setting of the machine changes.
TEST_F(OperatorMode, NoButtonThatIsEnabledDoesMoreThanIsLeft) {
    window->resize(1500, 1100);
    for (const char* dock : {"responseDockAction", "sequencesDockAction", "axesDockAction"})
        window->findChild<QAction*>(QLatin1String(dock))->trigger();
    for (const OperatorRights& rights :
         {OperatorRights{}, OperatorRights{.moves = true, .homing = true}, OperatorRights{.outputs = true}}) {
        machine.operatorRights = rights;
        window->showMachine(machine);
        if (!window->operatorLock().isLocked())
            begin();
        for (const ModuleState& module : {Servo{.held = true}.state(), stepper()}) {
            show(connectedTo({module}));
            ModuleState locked = module;
            locked.rights = window->operatorLock().rights();
            QSignalSpy intents(&window->requests(), &Requests::intent);
            QSignalSpy edits(&window->requests(), &Requests::axisEdited);
            int pressed = 0;
            for (const QPointer<QAbstractButton>& button : buttons()) {
                if (!button)
                    continue;
                testing_support::turnTo(*button);
                QCoreApplication::processEvents();
                if (!button->isEnabled() || button->visibleRegion().isEmpty())
                    continue;
                ++pressed;
                const QString name = button->objectName();
                testing_support::clickOn(*button);
                for (const QList<QVariant>& asked : intents) {
                    const auto intent = asked.at(1).value<Intent>();
                    const auto steps = plan(intent, locked);
                    EXPECT_TRUE(isStop(intent) || steps || steps.error() != Refusal::OperatorMode)
                        << name.toStdString();
                }
                EXPECT_TRUE(edits.isEmpty()) << name.toStdString();
                intents.clear();
                edits.clear();
                for (QDialog* dialog : window->findChildren<QDialog*>())
                    dialog->reject();
                settle();
            }
            EXPECT_GT(pressed, 5);
        }
    }
}

class BellTest : public WindowTest {
protected:
    QSignalSpy rings{&window->bell(), &Bell::rang};
};

TEST_F(BellTest, RingsForAFaultAndNotForNews) {
    window->showMessage(texts::rateChanged({115'200}));
    EXPECT_EQ(rings.size(), 0);
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    EXPECT_EQ(rings.size(), 1);
}

TEST_F(BellTest, RingsWhenAProcedureEndsAndNotWhenItIsShownAgain) {
    showServo();
    ProcedureReport report;
    report.module = ModuleIndex(0);
    report.kind = ProcedureKind::Homing;
    report.stage = ProcedureStage::Searching;
    window->showProcedure(report);
    EXPECT_EQ(rings.size(), 0);
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    window->showProcedure(report);
    EXPECT_EQ(rings.size(), 1);
}

TEST_F(BellTest, IsSilentAtTheEndOfAMoveThatTakesUpBacklash) {
    showServo();
    ProcedureReport report;
    report.module = ModuleIndex(0);
    report.kind = ProcedureKind::Approach;
    report.stage = ProcedureStage::Moving;
    window->showProcedure(report);
    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    EXPECT_EQ(rings.size(), 0) << "as of any other move";
}

TEST_F(BellTest, RingsOnceWhenASequenceEndsWellOrNot) {
    SequenceReport report;
    report.places = {{"Main", 0}};
    window->sequences().showRun(report);
    EXPECT_EQ(rings.size(), 0);
    report.stage = SequenceStage::Done;
    window->sequences().showRun(report);
    window->sequences().showRun(report);
    EXPECT_EQ(rings.size(), 1);
}

TEST_F(BellTest, RingsOnceWhenAFaultEndsASequence) {
    SequenceReport report;
    report.places = {{"Main", 0}};
    window->sequences().showRun(report);
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    report.stage = SequenceStage::Over;
    report.end = SequenceEnd::WentOff;
    report.module = ModuleIndex(0);
    window->sequences().showRun(report);
    EXPECT_EQ(rings.size(), 1);
}

TEST_F(BellTest, IsSilentWhenTheUserEndsASequence) {
    for (const SequenceEnd end : {SequenceEnd::ByUser, SequenceEnd::StopOfAll}) {
        SequenceReport report;
        report.places = {{"Main", 0}};
        window->sequences().showRun(report);
        report.stage = SequenceStage::Over;
        report.end = end;
        window->sequences().showRun(report);
    }
    EXPECT_EQ(rings.size(), 0);
}

TEST_F(BellTest, CanBeOffAndStaysSo) {
    window->findChild<QAction*>(u"soundsAction"_s)->trigger();
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    SequenceReport report;
    report.places = {{"Main", 0}};
    report.stage = SequenceStage::Done;
    window->sequences().showRun(report);
    EXPECT_EQ(rings.size(), 0);
    window = std::make_unique<MainWindow>(settings);
    EXPECT_FALSE(window->findChild<QAction*>(u"soundsAction"_s)->isChecked());
}

}  // namespace
}  // namespace nmc

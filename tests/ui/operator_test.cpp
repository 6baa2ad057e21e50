// SPDX-License-Identifier: GPL-3.0-or-later
// Operator mode in the window: who begins it, who leaves it, and what is in reach meanwhile.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/model/stepfixture.h"
#include "widgets/axes/axesdock.h"
#include "widgets/chain/chainmenu.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/bell.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/sequences/sequencesdock.h"
#include "windowtest.h"

namespace nmc {
namespace {

class OperatorMode : public WindowTest {
protected:
    OperatorMode() {
        // As the program does with what the lock says.
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
    /// A question that was answered is gone.
    static void settle() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }
    void typePin(const QString& field, const QString& pin) {
        auto* edit = find<QLineEdit>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, pin);
    }
    void begin() {
        open();
        typePin(u"operatorPinField"_s, u"4711"_s);
        typePin(u"operatorPinAgainField"_s, u"4711"_s);
        click(u"operatorBeginButton"_s);
        ASSERT_TRUE(window->operatorLock().isLocked());
        settle();
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

TEST_F(OperatorMode, IsLeftWithThePinOnly) {
    begin();
    click(u"leaveOperatorButton"_s);
    typePin(u"operatorPinField"_s, u"4712"_s);
    click(u"operatorLeaveButton"_s);
    EXPECT_TRUE(window->operatorLock().isLocked());
    EXPECT_TRUE(text(u"operatorProblem"_s).startsWith(u"That is not the PIN."_s));
    typePin(u"operatorPinField"_s, u"4711"_s);
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
    typePin(u"operatorPinField"_s, u"4711"_s);
    click(u"operatorBeginButton"_s);
    EXPECT_TRUE(text(u"operatorProblem"_s).contains(u"differ"_s));
    EXPECT_FALSE(window->operatorLock().isLocked());
}

TEST_F(OperatorMode, OutlivesTheSessionAndThePinIsNotInTheSettings) {
    begin();
    for (const QString& key : settings.allKeys())
        EXPECT_FALSE(settings.value(key).toString().contains(u"4711"_s)) << key.toStdString();
    window = std::make_unique<MainWindow>(settings);
    EXPECT_TRUE(window->operatorLock().isLocked());
}

TEST_F(OperatorMode, TheUserChoosesWhatIsLeftForTheMachine) {
    QSignalSpy edited(&window->operatorLock(), &OperatorLock::rightsEdited);
    open();
    auto* homing = button(u"operatorHomingBox"_s);
    auto* jog = button(u"operatorJogBox"_s);
    for (auto* box : {homing, jog})
        QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
    typePin(u"operatorPinField"_s, u"4711"_s);
    typePin(u"operatorPinAgainField"_s, u"4711"_s);
    click(u"operatorBeginButton"_s);
    ASSERT_EQ(edited.size(), 1);
    const auto rights = edited.at(0).at(0).value<OperatorRights>();
    EXPECT_TRUE(rights.homing);
    EXPECT_FALSE(rights.jog);
    EXPECT_FALSE(enabled("holdForwardButton"));
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
        EXPECT_EQ(stops.size(), ++expected) << "Esc, in the question";
        settle();
    }
}

TEST_F(OperatorMode, DoesNotKeepAnybodyFromLeavingThePort) {
    begin();
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 1);
}

/// Whoever has the window before them tries everything in it: each button, each action whatever its menu,
/// each line of the palette, each field and table.
class OperatorTriesAll : public OperatorMode {
protected:
    OperatorTriesAll() {
        window->resize(1'500, 1'100);
        machine.program = {
            {{"A", {{ModuleIndex(0), 100, false}}}},
            {{"Main", {action::MoveTo{"A"}, action::Wait{0.5}}}, {"Other", {action::Wait{1}}}}};
        for (int i = 0; i < 3; ++i) {
            AxisSettings axis;
            axis.homing = HomingRecipe{};
            axis.homing->onLimit1 = true;
            machine.axes.push_back(axis);
        }
        window->showMachine(machine);
        ModuleState member = Servo{}.state();
        member.info.group = bus::GroupPlace{0x81, false};
        testing_support::Stepper stepper = testing_support::Stepper::holding();
        stepper.module.info.index = ModuleIndex(2);
        chain = connectedTo({member, Servo{.index = 1}.state(), stepper.module});
        show(chain);
        window->showMessage(texts::restarted({ModuleIndex(0)}, 3));
        window->showMessage(texts::unsavedWorkLeft(u"mill"_s));
        watch();
    }
    void TearDown() override { window.reset(); }  // which tells, while it goes, what is noted here
    void watch() {
        MainWindow* w = window.get();
        QObject::connect(w, &MainWindow::intentRequested, w, [this](ModuleIndex, const Intent& intent) {
            const bool harmless = isStop(intent) || std::holds_alternative<intent::AskAnew>(intent) ||
                                  std::holds_alternative<intent::CancelProcedure>(intent);
            const bool enables = std::holds_alternative<intent::Enable>(intent) ||
                                 std::holds_alternative<intent::ClearStickyBits>(intent);
            if (!harmless)
                done << (enables ? u"enable"_s : u"intent %1"_s.arg(intent.index()));
        });
        const auto note = [this](const QString& what) { return [this, what] { done << what; }; };
        QObject::connect(w, &MainWindow::restartNetworkRequested, w, note(u"restart"_s));
        QObject::connect(w, &MainWindow::axisEdited, w, note(u"axis"_s));
        QObject::connect(w, &MainWindow::messageAction, w, [this](const Message&, MessageAction action) {
            if (action != MessageAction::Understood && action != MessageAction::ShowRecord)
                done << u"message "_s + nmc::objectName(action);
        });
        QObject::connect(&w->chainMenu(), &ChainMenu::acceptRequested, w, note(u"accept"_s));
        QObject::connect(&w->chainMenu(), &ChainMenu::groupChangeRequested, w, note(u"group"_s));
        QObject::connect(&w->chainMenu(), &ChainMenu::groupCommandRequested, w, note(u"group command"_s));
        QObject::connect(&w->chainMenu(), &ChainMenu::groupNamed, w, note(u"group name"_s));
        QObject::connect(&w->chainMenu(), &ChainMenu::rateRequested, w, note(u"rate"_s));
        QObject::connect(&w->machineMenu(), &MachineMenu::newRequested, w, note(u"new machine"_s));
        QObject::connect(&w->machineMenu(), &MachineMenu::openRequested, w, note(u"open machine"_s));
        QObject::connect(&w->machineMenu(), &MachineMenu::saveRequested, w, note(u"save machine"_s));
        QObject::connect(&w->sequences(), &SequencesDock::programEdited, w, [this](const Program& program) {
            done << u"program"_s;
            machine.program = program;
            window->showMachine(machine);
        });
        QObject::connect(&w->sequences(), &SequencesDock::startRequested, w, note(u"run"_s));
        QObject::connect(&w->sequences(), &SequencesDock::goToRequested, w, note(u"go to point"_s));
        QObject::connect(&w->axes(), &AxesDock::homeOrderEdited, w, note(u"home order"_s));
        QObject::connect(&w->axes(), &AxesDock::homeAllRequested, w, note(u"home all"_s));
        QObject::connect(&w->axes(), &AxesDock::intentRequested, w, [this](ModuleIndex, const Intent& i) {
            done << (std::holds_alternative<intent::Enable>(i) ? u"enable"_s : u"intent %1"_s.arg(i.index()));
        });
    }
    /// Everything that can be closed is opened.
    void openAll() {
        for (const char* action : {"chainDoctorAction", "groupsAction", "rateAction"})
            window->findChild<QAction*>(QLatin1StringView(action))->trigger();
        for (auto* dock : window->findChildren<QDockWidget*>())
            dock->show();
        window->sequences().page();
        show(chain);
        for (const QString& table : {u"pointTable"_s, u"rowTable"_s})
            window->findChild<QTableView*>(table)->selectRow(0);
        QApplication::processEvents();
    }
    static bool ends(const QString& name) { return name == u"quitAction"_s; }
    /// It only opens a menu, whose actions are tried by themselves.
    static bool opensMenu(const QAbstractButton& button) {
        const auto* tool = qobject_cast<const QToolButton*>(&button);
        const auto* push = qobject_cast<const QPushButton*>(&button);
        return (tool != nullptr && tool->popupMode() == QToolButton::InstantPopup) ||
               (push != nullptr && push->menu() != nullptr);
    }
    void tryButtons() {
        for (const QPointer<QAbstractButton> button : window->findChildren<QAbstractButton*>())
            if (button && button->isEnabled() && !ends(button->objectName()) && !opensMenu(*button))
                button->click();
    }
    void tryActions() {
        for (const QPointer<QAction> action : window->findChildren<QAction*>())
            if (action && action->isEnabled() && !ends(action->objectName()))
                action->trigger();
    }
    /// As somebody at the keyboard: chooses a line and strikes Enter.
    void tryPalette() {
        for (int i = 0, lines = 1; i < lines; ++i) {
            window->openPalette();
            auto* list = window->findChild<QTreeWidget*>(u"commandList"_s);
            lines = list->topLevelItemCount();
            QTreeWidgetItem* line = list->topLevelItem(i);
            if (line->text(0) == u"Quit"_s)
                continue;
            list->setCurrentItem(line);
            QTest::keyClick(window->findChild<QLineEdit*>(u"commandWords"_s), Qt::Key_Return);
        }
    }
    void tryFields() {
        for (const QPointer<QLineEdit> field : window->findChildren<QLineEdit*>()) {
            if (!field || !field->isEnabled() || field->isReadOnly() ||
                field->objectName().startsWith(u"operator"_s))
                continue;
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, u"7"_s);
            if (field)
                QTest::keyClick(field, Qt::Key_Return);
        }
        for (const QPointer<QComboBox> box : window->findChildren<QComboBox*>())
            if (box && box->isEnabled()) {
                QTest::keyClick(box, Qt::Key_Down);
                QTest::keyClick(box, Qt::Key_Home);
            }
        for (auto* table : window->findChildren<QTableView*>())
            for (int column = 0; column < table->model()->columnCount(); ++column)
                table->model()->setData(table->model()->index(0, column), 1);
    }
    QStringList tryAll() {
        openAll();
        tryActions();
        openAll();
        tryButtons();
        openAll();
        tryFields();
        openAll();
        tryPalette();
        done.removeDuplicates();
        return done;
    }
    LinkState chain;
    QStringList done;
};

TEST_F(OperatorTriesAll, WhatIsNotLockedActs) {
    const QStringList all = tryAll();
    for (const QString& what :
         {u"accept"_s, u"axis"_s, u"program"_s, u"home order"_s, u"group"_s, u"group name"_s,
          u"new machine"_s, u"message readdress"_s, u"message restoreWork"_s, u"run"_s})
        EXPECT_TRUE(all.contains(what)) << what.toStdString() << " of " << all.join(u", "_s).toStdString();
    EXPECT_GE(all.filter(u"intent"_s).size(), 5) << all.join(u", "_s).toStdString();
}

TEST_F(OperatorTriesAll, OnlyPointsAndSequencesAndEnablingAreLeft) {
    begin();
    show(chain);
    EXPECT_THAT(tryAll(), testing::IsSubsetOf({u"enable"_s, u"run"_s, u"go to point"_s}));
    EXPECT_TRUE(done.contains(u"run"_s)) << "though moves are not";
    EXPECT_TRUE(done.contains(u"go to point"_s));
}

TEST_F(OperatorTriesAll, NothingIsLeftWhereTheMachineLeavesNothing) {
    machine.operatorRights = OperatorRights{false, false, false, false, false, false};
    window->showMachine(machine);
    QSignalSpy holds(window.get(), &MainWindow::holdRequested);
    begin();
    show(chain);
    EXPECT_EQ(tryAll(), QStringList());
    for (auto* hold : window->findChildren<HoldButton*>())
        EXPECT_FALSE(hold->isEnabled()) << hold->objectName().toStdString();
    EXPECT_TRUE(enabled("stopAllButton"));
}

TEST_F(OperatorTriesAll, WhatWasEditedIsNotUndoneAndIsAgainWhenTheModeIsLeft) {
    openAll();
    click(u"addRowButton"_s);
    ASSERT_TRUE(enabled("undoEditButton"));
    done.clear();
    begin();
    show(chain);
    openAll();
    EXPECT_FALSE(enabled("undoEditButton"));
    EXPECT_TRUE(button(u"undoEditButton"_s)->toolTip().contains(u"operator mode"_s));
    QTest::keyClick(find(u"rowTable"_s), Qt::Key_Z, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(done, QStringList());
    window->operatorLock().open();
    typePin(u"operatorPinField"_s, u"4711"_s);
    click(u"operatorLeaveButton"_s);
    show(chain);
    EXPECT_TRUE(enabled("undoEditButton"));
    EXPECT_TRUE(window->findChild<QAbstractButton*>(u"listAction_restoreWork"_s)->isEnabled());
}

TEST_F(OperatorTriesAll, AMessageSaysWhyItsButtonDoesNotAct) {
    begin();
    show(chain);
    auto* readdress = window->findChild<QAbstractButton*>(u"listAction_readdress"_s);
    ASSERT_NE(readdress, nullptr);
    EXPECT_FALSE(readdress->isEnabled());
    EXPECT_TRUE(readdress->toolTip().contains(u"operator mode"_s));
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
    report.stage = SequenceStage::Done;
    window->sequences().showRun(report);
    EXPECT_EQ(rings.size(), 0);
    window = std::make_unique<MainWindow>(settings);
    EXPECT_FALSE(window->findChild<QAction*>(u"soundsAction"_s)->isChecked());
}

}  // namespace
}  // namespace nmc

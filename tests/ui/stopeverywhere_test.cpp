// SPDX-License-Identifier: GPL-3.0-or-later
// STOP ALL and Esc in every state of every window of the program: questions, dialogs, popups.
#include <functional>

#include "widgets/common/printdialog.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/scope/scopefiles.h"
#include "windowtest.h"

namespace nmc {
namespace {

class StopEverywhere : public WindowTest {
public:
    StopEverywhere() {
        showServos({{.moveDone = false}, {}, {}});
        window->machineMenu().showFile({directory.filePath(u"mill.json"_s), {}, true, {}});
    }
    void trigger(const QString& action) { find<QAction>(action)->trigger(); }
    using WindowTest::click;
    using WindowTest::directory;
    using WindowTest::find;
    using WindowTest::type;
    using WindowTest::window;

    [[nodiscard]] QPoint stopPlace() {
        QWidget* stop = find(u"stopAllButton"_s);
        return stop->mapToGlobal(stop->rect().center());
    }
    /// Clicks as the window system does: in the window that has the pointer there.
    void pressStop() {
        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, window->mapFromGlobal(stopPlace()));
    }
    /// Presses outside of a popup, which grabs the pointer wherever it is.
    static void pressOutside(QWidget& popup, const QPoint& global) {
        const QPoint local = popup.mapFromGlobal(global);
        QMouseEvent press(QEvent::MouseButtonPress, local, local, global, Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(popup.windowHandle(), &press);
    }
    /// Presses Esc in the window that has the keyboard.
    static void pressEsc() {
        ASSERT_NE(QGuiApplication::focusWindow(), nullptr);
        QTest::keyClick(QGuiApplication::focusWindow(), Qt::Key_Escape);
    }
    QSignalSpy stops{window.get(), &MainWindow::stopAllRequested};
};

struct Opened {
    const char* name;
    const char* window;  ///< object name of what it opens
    std::function<void(StopEverywhere&)> open;
};
void PrintTo(const Opened& opened, std::ostream* out) {
    *out << opened.name;
}

class StopBeside : public StopEverywhere, public testing::WithParamInterface<Opened> {
protected:
    StopBeside() {
        GetParam().open(*this);
        other = window->findChild<QWidget*>(QLatin1StringView(GetParam().window));
    }
    QWidget* other = nullptr;
};

TEST_P(StopBeside, StopAllTakesTheClickAndEscStillWorksAfterwards) {
    ASSERT_NE(other, nullptr);
    ASSERT_TRUE(other->isVisible());
    pressStop();
    EXPECT_EQ(stops.size(), 1);
    pressEsc();
    EXPECT_EQ(stops.size(), 2);
}

TEST_P(StopBeside, EscStopsFromIt) {
    ASSERT_NE(other, nullptr);
    ASSERT_TRUE(eventually([this] { return QGuiApplication::focusWindow() == other->windowHandle(); }));
    pressEsc();
    EXPECT_EQ(stops.size(), 1);
    pressStop();
    EXPECT_EQ(stops.size(), 2);
}

TEST_P(StopBeside, EscClosesWhatIsAWindowOfItsOwnAsWell) {
    const QPointer<QWidget> opened = other;
    const bool dock = qobject_cast<QDockWidget*>(other) != nullptr;
    ASSERT_TRUE(eventually([&] { return QGuiApplication::focusWindow() == opened->windowHandle(); }));
    pressEsc();
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(opened != nullptr && opened->isVisible(), dock) << "docks belong to the main window";
}

void atRest(StopEverywhere& test) {
    test.window->showLink(connectedTo({Servo{}.state()}));
}

const std::array kWindows{
    Opened{"Disconnecting", "disconnectDialog", [](StopEverywhere& t) { t.click(u"disconnectButton"_s); }},
    Opened{"Closing", "closeDialog", [](StopEverywhere& t) { t.window->close(); }},
    Opened{"Restarting", "restartDialog", [](StopEverywhere& t) { t.trigger(u"restartNetworkAction"_s); }},
    Opened{"UnsavedBeforeClosing", "unsavedDialog",
           [](StopEverywhere& t) {
               atRest(t);
               t.window->close();
           }},
    Opened{"UnsavedBeforeNew", "unsavedDialog", [](StopEverywhere& t) { t.trigger(u"newMachineAction"_s); }},
    Opened{"LargeStep", "largeStepDialog",
           [](StopEverywhere& t) {
               t.type(u"kpField"_s, u"900"_s);
               t.click(u"applyGainsButton"_s);
           }},
    Opened{"Chain", "chainDialog", [](StopEverywhere& t) { t.trigger(u"chainDoctorAction"_s); }},
    Opened{"Copying", "copyDialog", [](StopEverywhere& t) { t.trigger(u"copyAxisAction"_s); }},
    Opened{"Differences", "differencesDialog",
           [](StopEverywhere& t) { t.window->machineMenu().showDifferences(u"mill.json"_s, {}); }},
    Opened{"About", "aboutDialog", [](StopEverywhere& t) { t.trigger(u"aboutAction"_s); }},
    Opened{"Manual", "manualWindow", [](StopEverywhere& t) { t.trigger(u"manualAction"_s); }},
    Opened{"Report", "reportDialog", [](StopEverywhere& t) { t.trigger(u"reportProblemAction"_s); }},
    Opened{"Language", "languageDialog", [](StopEverywhere& t) { t.trigger(u"languageAction_de"_s); }},
    Opened{"Safety", "safetyDialog", [](StopEverywhere& t) { t.trigger(u"safetyAction"_s); }},
    Opened{"SavingAs", "saveMachineDialog", [](StopEverywhere& t) { t.trigger(u"saveMachineAsAction"_s); }},
    Opened{"OpeningARecording", "openRecordingDialog",
           [](StopEverywhere& t) { t.window->scopeFiles().openAction()->trigger(); }},
    Opened{"Signals", "scopeSignalsDialog", [](StopEverywhere& t) { t.trigger(u"scopeSignalsAction"_s); }},
    Opened{"Printing", "printDialog",
           [](StopEverywhere& t) { (new PrintDialog({}, t.window->requests(), t.window.get()))->show(); }},
    Opened{"AFloatingDock", "messagesDock",
           [](StopEverywhere& t) {
               auto* dock = t.find<QDockWidget>(u"messagesDock"_s);
               dock->setFloating(true);
               dock->activateWindow();
           }},
    Opened{"TwoQuestions", "restartDialog",
           [](StopEverywhere& t) {
               t.window->close();
               t.trigger(u"restartNetworkAction"_s);
           }},
    Opened{"AWindowThatQtMadeModal", "modalBox",
           [](StopEverywhere& t) {
               auto* box = new QMessageBox(t.window.get());
               box->setObjectName(u"modalBox"_s);
               box->open();
           }},
};
INSTANTIATE_TEST_SUITE_P(U10, StopBeside, testing::ValuesIn(kWindows),
                         [](const auto& opened) { return std::string(opened.param.name); });

// ---- popups ----

class StopThroughPopup : public StopEverywhere, public testing::WithParamInterface<Opened> {
protected:
    StopThroughPopup() { GetParam().open(*this); }
};

TEST_P(StopThroughPopup, ThePressStopsAndClosesItAndChoosesNothing) {
    QWidget* popup = QApplication::activePopupWidget();
    ASSERT_NE(popup, nullptr);
    ASSERT_FALSE(popup->frameGeometry().contains(stopPlace()));
    pressOutside(*popup, stopPlace());
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, window->mapFromGlobal(stopPlace()));
    QApplication::processEvents();
    EXPECT_EQ(stops.size(), 1) << "one press gives one stop";
    pressStop();
    EXPECT_EQ(stops.size(), 2);
}

TEST_P(StopThroughPopup, AsTheMainWindowSeesThePress) {
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    pressStop();
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_P(StopThroughPopup, EscStops) {
    QWidget* popup = QApplication::activePopupWidget();
    ASSERT_NE(popup, nullptr);
    QTest::keyClick(popup->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

void openContextMenu(StopEverywhere& test, const QString& field) {
    auto* edit = test.find<QWidget>(field);
    const QPoint at(5, 5);
    QContextMenuEvent asked(QContextMenuEvent::Mouse, at, edit->mapToGlobal(at));
    QApplication::sendEvent(edit, &asked);
}

const std::array kPopups{
    Opened{"AMenu", "",
           [](StopEverywhere& t) {
               t.find<QMenu>(u"viewMenu"_s)->popup(t.window->mapToGlobal(QPoint(20, 40)));
           }},
    Opened{"ASubmenu", "",
           [](StopEverywhere& t) {
               t.window->machineMenu().showFile({{}, {}, false, {u"/home/anna/mill.json"_s}});
               auto* file = t.find<QMenu>(u"fileMenu"_s);
               file->popup(t.window->mapToGlobal(QPoint(20, 40)));
               t.find<QMenu>(u"recentMachinesMenu"_s)->popup(t.window->mapToGlobal(QPoint(90, 90)));
           }},
    Opened{"AList", "", [](StopEverywhere& t) { t.find<QComboBox>(u"scopeWindowBox"_s)->showPopup(); }},
    Opened{"AListOfAPanel", "", [](StopEverywhere& t) { t.find<QComboBox>(u"goalKindBox"_s)->showPopup(); }},
    Opened{"AContextMenu", "", [](StopEverywhere& t) { openContextMenu(t, u"kpField"_s); }},
    Opened{"ACompleter", "",
           [](StopEverywhere& t) {
               t.trigger(u"saveMachineAsAction"_s);
               auto* dialog = t.find<QFileDialog>(u"saveMachineDialog"_s);
               QDir(t.directory.path()).mkdir(u"mill-old"_s);
               dialog->setDirectory(t.directory.path());
               auto* list = dialog->findChild<QListView*>(u"listView"_s);
               EXPECT_TRUE(eventually([&] { return list->model()->rowCount(list->rootIndex()) > 0; }));
               auto* edit = dialog->findChild<QLineEdit*>(u"fileNameEdit"_s);
               edit->setFocus();
               edit->clear();
               QTest::keyClicks(edit, u"mill"_s);
               EXPECT_TRUE(eventually([] { return QApplication::activePopupWidget() != nullptr; }));
           }},
};
INSTANTIATE_TEST_SUITE_P(U10, StopThroughPopup, testing::ValuesIn(kPopups),
                         [](const auto& opened) { return std::string(opened.param.name); });

TEST_F(StopEverywhere, WhatLiesOverTheButtonKeepsItsOwnPress) {
    QMenu menu(window.get());
    QAction* action = menu.addAction(u"Something else"_s);
    QSignalSpy chosen(action, &QAction::triggered);
    menu.popup(stopPlace() - QPoint(10, 10));
    QTest::mouseClick(menu.windowHandle(), Qt::LeftButton, {}, menu.actionGeometry(action).center());
    EXPECT_EQ(stops.size(), 0);
    EXPECT_EQ(chosen.size(), 1);
}

TEST_F(StopEverywhere, APressBesideTheButtonOnlyClosesThePopup) {
    find<QComboBox>(u"scopeWindowBox"_s)->showPopup();
    QWidget* popup = QApplication::activePopupWidget();
    const QPoint beside = stopPlace() - QPoint(find(u"stopAllButton"_s)->width() / 2 + 20, 0);
    pressOutside(*popup, beside);
    EXPECT_FALSE(popup->isVisible());
    EXPECT_EQ(stops.size(), 0);
}

TEST_F(StopEverywhere, ASecondFingerStopsWhileTheFirstHolds) {
    auto* touch = QTest::createTouchDevice();
    auto* hold = find<HoldButton>(u"holdForwardButton"_s);
    const QPoint first = window->mapFromGlobal(hold->mapToGlobal(hold->rect().center()));
    showServo();
    QTest::touchEvent(window->windowHandle(), touch).press(0, first);
    EXPECT_TRUE(hold->isHeld());
    QTest::touchEvent(window->windowHandle(), touch)
        .stationary(0)
        .press(1, window->mapFromGlobal(stopPlace()));
    EXPECT_EQ(stops.size(), 1);
    EXPECT_FALSE(hold->isHeld());
    QTest::touchEvent(window->windowHandle(), touch)
        .release(0, first)
        .release(1, window->mapFromGlobal(stopPlace()));
}

// ---- questions that Qt asks by itself ----

TEST_F(StopEverywhere, TheFileDialogsOwnQuestionBlocksOnlyTheFileDialog) {
    const QString there = directory.filePath(u"there.json"_s);
    ASSERT_TRUE(QFile(there).open(QIODevice::WriteOnly));
    trigger(u"saveMachineAsAction"_s);
    auto* dialog = find<QFileDialog>(u"saveMachineDialog"_s);
    dialog->selectFile(there);
    bool asked = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
        auto* box = dialog->findChild<QMessageBox*>();
        if (box == nullptr || !box->isVisible())
            return;
        look.stop();
        asked = true;
        pressStop();
        EXPECT_EQ(stops.size(), 1);
        EXPECT_FALSE(dialog->isEnabled());
        EXPECT_TRUE(box->isEnabled());
        EXPECT_FALSE(dialog->close()) << "it waits for the answer";
        QTest::keyClick(box->windowHandle(), Qt::Key_Escape);
        EXPECT_EQ(stops.size(), 2);
    });
    look.start(5);
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    EXPECT_TRUE(asked);
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_TRUE(dialog->isEnabled());
}

// ---- the subject of a question changes while it is open ----

class Standing : public StopEverywhere {
protected:
    QWidget* question(const QString& name) {
        auto* found = window->findChild<QDialog*>(name);
        return found != nullptr && found->isVisible() ? found : nullptr;
    }
};

TEST_F(Standing, AQuestionIsAskedOnce) {
    click(u"disconnectButton"_s);
    click(u"disconnectButton"_s);
    window->close();
    window->close();
    trigger(u"restartNetworkAction"_s);
    trigger(u"restartNetworkAction"_s);
    for (const QString& name : {u"disconnectDialog"_s, u"closeDialog"_s, u"restartDialog"_s})
        EXPECT_EQ(window->findChildren<QDialog*>(name).size(), 1) << name.toStdString();
}

TEST_F(Standing, SaysWhatIsSoNow) {
    click(u"disconnectButton"_s);
    EXPECT_EQ(text(u"closeText"_s), u"1 motor is moving. It will be stopped before the port closes."_s);
    showServos({{.moveDone = false}, {.moveDone = false}});
    EXPECT_EQ(text(u"closeText"_s), u"2 motors are moving. They will be stopped before the port closes."_s);
    showServos({{}, {}});
    EXPECT_EQ(text(u"closeText"_s),
              u"No motor is moving. All motors are commanded to stop before the port closes."_s);
    click(u"stopAndCloseButton"_s);
    EXPECT_EQ(stops.size(), 1);
}

// A motor that was started a moment ago is not shown moving until its first answer.
TEST_F(Standing, IsAskedWhileAProcedureRunsThatMovesAMotor) {
    atRest(*this);
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    ProcedureReport report{.module = ModuleIndex(0), .kind = ProcedureKind::FollowPath};
    window->showProcedure(report);
    click(u"disconnectButton"_s);
    ASSERT_NE(question(u"disconnectDialog"_s), nullptr);
    EXPECT_EQ(text(u"closeText"_s), u"1 motor is moving. It will be stopped before the port closes."_s);
    click(u"stayButton"_s);
    EXPECT_EQ(disconnects.size(), 0);

    report.stage = ProcedureStage::Done;
    window->showProcedure(report);
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 1);
}

TEST_F(Standing, GainsOnTrialMoveNothing) {
    atRest(*this);
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    window->showProcedure({.module = ModuleIndex(0), .kind = ProcedureKind::TryGains});
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 1);
}

TEST_F(Standing, IsWithdrawnWhenThePortIsGoneOrAnother) {
    QSignalSpy restarts(window.get(), &MainWindow::restartNetworkRequested);
    LinkState other = connectedTo({Servo{}.state()});
    other.port = "/dev/ttyUSB1";
    other.connection = 1;  // each connection has its own number
    for (const LinkState& link : {LinkState{}, other}) {
        showServos({{.moveDone = false}});
        click(u"disconnectButton"_s);
        trigger(u"restartNetworkAction"_s);
        ASSERT_NE(question(u"disconnectDialog"_s), nullptr);
        window->showLink(link);
        EXPECT_EQ(question(u"disconnectDialog"_s), nullptr);
        EXPECT_EQ(question(u"restartDialog"_s), nullptr);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    EXPECT_EQ(restarts.size(), 0);
}

TEST_F(Standing, LargeStepIsWithdrawnWhenItsModuleIsOffOrItsGainsAreOthers) {
    QSignalSpy intents(&window->requests(), &Requests::intent);
    const auto ask = [this] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        showServo();
        type(u"kpField"_s, u"900"_s);
        click(u"applyGainsButton"_s);
        ASSERT_NE(question(u"largeStepDialog"_s), nullptr);
    };
    ask();
    showServo({.on = false});
    EXPECT_EQ(question(u"largeStepDialog"_s), nullptr) << "no motor would jump";
    ask();
    type(u"kpField"_s, u"901"_s);
    click(u"applyLargeStepButton"_s);
    EXPECT_EQ(intents.size(), 0) << "the question was about other gains";
    ask();
    window->showLink({});
    EXPECT_EQ(question(u"largeStepDialog"_s), nullptr);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Standing, MotorsThatStartWhileUnsavedWorkIsAskedAboutAreAskedAboutToo) {
    atRest(*this);
    window->close();
    ASSERT_NE(question(u"unsavedDialog"_s), nullptr);
    showServos({{.moveDone = false}});
    click(u"goOnUnsavedButton"_s);
    EXPECT_TRUE(window->isVisible());
    EXPECT_NE(question(u"closeDialog"_s), nullptr);
}

TEST_F(Standing, UnsavedWorkThatIsSavedMeanwhileIsNotAskedAboutAnyMore) {
    atRest(*this);
    window->close();
    ASSERT_NE(question(u"unsavedDialog"_s), nullptr);
    window->machineMenu().showFile({directory.filePath(u"mill.json"_s), {}, false, {}});
    EXPECT_EQ(question(u"unsavedDialog"_s), nullptr);
    EXPECT_TRUE(window->isVisible());
}

TEST_F(Standing, EndsAHoldWhenItAppears) {
    showServo();
    auto* hold = find<HoldButton>(u"holdForwardButton"_s);
    QTest::mousePress(hold, Qt::LeftButton);
    ASSERT_TRUE(hold->isHeld());
    trigger(u"restartNetworkAction"_s);
    EXPECT_FALSE(hold->isHeld());
    ASSERT_NE(question(u"restartDialog"_s), nullptr);
    EXPECT_FALSE(question(u"restartDialog"_s)->isModal());
    QTest::mouseRelease(hold, Qt::LeftButton);
}

}  // namespace
}  // namespace nmc

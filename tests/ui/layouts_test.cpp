// SPDX-License-Identifier: GPL-3.0-or-later
// The layouts of the window, and the loop of editing, applying, stepping and looking in them.
#include "widgets/mainwindow/layouts.h"
#include "widgets/scope/scopepanel.h"
#include "windowtest.h"

namespace nmc {
namespace {

class LayoutsTest : public WindowTest {
protected:
    LayoutsTest() {
        window->resize(1456, 952);
        Servo servo;
        servo.held = true;
        showServo(servo);
        settle();
    }
    void settle() {
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
    }
    void strike(int key, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(window.get(), static_cast<Qt::Key>(key), modifiers);
        settle();
    }
    QDockWidget* dock(const char* name) { return window->findChild<QDockWidget*>(QLatin1String(name)); }
    [[nodiscard]] int area(const char* name) { return dock(name)->width() * dock(name)->height(); }
    /// Expects that it is completely visible without scrolling. It avoids find(), which scrolls.
    void expectWhole(const QString& name) {
        const auto* widget = window->findChild<QWidget*>(name);
        ASSERT_NE(widget, nullptr) << name.toStdString();
        EXPECT_EQ(widget->visibleRegion().boundingRect(), widget->rect()) << name.toStdString();
    }
    template <typename T>
    T last() {
        EXPECT_FALSE(intents.isEmpty());
        const auto intent = intents.takeLast().at(1).value<Intent>();
        const T* wanted = std::get_if<T>(&intent);
        EXPECT_NE(wanted, nullptr);
        return wanted != nullptr ? *wanted : T{};
    }
    /// Types over the value, and does not send it.
    void typeGain(const QString& name, const QString& value) {
        auto* field = window->findChild<QLineEdit*>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, value);
        settle();
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

/// Two thirds of the whole window, including its bars and the place for a message.
TEST_F(LayoutsTest, TuneGivesTwoThirdsToThePlotsWithGainsAndStepBesideThem) {
    strike(Qt::Key_2, Qt::ControlModifier);
    const int plots = area("scopeDock") + area("responseDock");
    EXPECT_GE(3 * plots, 2 * window->width() * window->height())
        << "share " << 1.0 * plots / (window->width() * window->height());
    for (const char* name : {"kpField",        "kdField",          "kiField",        "ilField",
                             "olField",        "clField",          "elField",        "srField",
                             "dbField",        "applyGainsButton", "tryGainsButton", "responseDistanceField",
                             "responseButton", "responseState",    "enableButton",   "motorOffButton",
                             "stateLabel",     "positionLabel",    "responsePlot",   "responseRunTable",
                             "responseResults"})
        expectWhole(QLatin1String(name));
}

/// It is the error that one tunes by.
TEST_F(LayoutsTest, TuneShowsTheErrorAsHighAsThePosition) {
    strike(Qt::Key_2, Qt::ControlModifier);
    const QWidget* position = find(u"scopePlot1"_s);
    const QWidget* error = find(u"scopePlot2"_s);
    EXPECT_NEAR(error->height(), position->height(), 1);
    const auto* analog = window->findChild<QWidget*>(u"scopePlot3"_s);
    EXPECT_TRUE(analog == nullptr || !analog->isVisible());
    strike(Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(find(u"scopePlot3"_s)->isVisible());
    expectWhole(u"scopePlot3"_s);
}

/// What is chosen in one layout does not change another.
TEST_F(LayoutsTest, EachHasItsOwnSignals) {
    auto* scope = find<ScopePanel>(u"scopePanel"_s);
    strike(Qt::Key_2, Qt::ControlModifier);
    click(u"scopeLaneButton"_s);
    EXPECT_TRUE(scope->setup().lane);
    strike(Qt::Key_1, Qt::ControlModifier);
    EXPECT_FALSE(scope->setup().lane);
    strike(Qt::Key_2, Qt::ControlModifier);
    EXPECT_TRUE(scope->setup().lane);
}

/// No tab hides behind the arrows of its bar, whatever the layout, the module and the size of the window.
TEST_F(LayoutsTest, NoTabBarHasScrollArrows) {
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1456, 952)}) {
        window->resize(size);
        for (const ModuleIdentity& identity :
             {ModuleIdentity{ModuleType::Servo, 4}, ModuleIdentity{ModuleType::Servo, 10},
              ModuleIdentity{ModuleType::Stepper, 1}, ModuleIdentity{ModuleType::Io, 1}}) {
            ModuleState module;
            module.info.identity = identity;
            module.info.address = BusAddress(1);
            window->showLink(connectedTo({module}));
            for (const Qt::Key layout : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
                strike(layout, Qt::ControlModifier);
                for (const QTabBar* bar : window->findChildren<QTabBar*>())
                    for (const QToolButton* arrow : bar->findChildren<QToolButton*>())
                        EXPECT_FALSE(arrow->isVisible())
                            << size.width() << ", layout " << layout - Qt::Key_0 << ", "
                            << bar->parentWidget()->objectName().toStdString() << ", version "
                            << static_cast<int>(identity.version) << ": " << bar->count() << " tabs in "
                            << bar->width();
            }
        }
    }
}

/// Otherwise the outer area scrolls away what the inner one keeps in view.
TEST_F(LayoutsTest, NothingScrollsWithinWhatScrolls) {
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io}) {
        ModuleState module;
        module.info = {ModuleIndex(0), BusAddress(1), {type, 1}, {}};
        window->showLink(connectedTo({module}));
        for (const auto* area : window->findChildren<QScrollArea*>())
            for (const auto* inner : area->findChildren<QScrollArea*>())
                EXPECT_EQ(inner->objectName(), u"messageList"_s) << "a list, like a table, scrolls its rows";
    }
}

/// On X11, the keys of the digits 1 to 8 have the codes 10 to 17, and type these characters without Shift.
TEST_F(LayoutsTest, AreChosenByTheKeysOfDigitsWhereTheseAreShifted) {
    const QString azerty = u"&é\"'(-è_"_s;
    const auto strikeKey = [&](int digit) {
        const QChar typed = azerty[digit - 1];
        QKeyEvent press(QEvent::KeyPress, typed.toUpper().unicode(), Qt::ControlModifier,
                        static_cast<quint32>(9 + digit), 0, 0, typed);
        QApplication::sendEvent(
            QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window.get(), &press);
        settle();
    };
    for (const bool inAField : {false, true}) {
        if (inAField)
            window->findChild<QWidget*>(u"goalField"_s)->setFocus();
        for (const auto& [digit, layout] :
             {std::pair{2, u"tuneLayoutAction"_s}, std::pair{3, u"chainLayoutAction"_s},
              std::pair{1, u"operateLayoutAction"_s}}) {
            strikeKey(digit);
            EXPECT_TRUE(window->findChild<QAction*>(layout)->isChecked()) << digit;
        }
    }
    const bool before = dock("messagesDock")->isVisible();
    strikeKey(6);
    EXPECT_NE(dock("messagesDock")->isVisible(), before) << "Ctrl+6";
}

TEST_F(LayoutsTest, AHigherWindowGivesWhatItGainsToThePlots) {
    const int before = dock("scopeDock")->height();
    window->resize(1456, 1300);
    settle();
    EXPECT_GE(dock("scopeDock")->height(), before + 250);
    for (const char* name : {"goButton", "holdForwardButton", "applyGainsButton", "moveByForwardButton"})
        expectWhole(QLatin1String(name));
    window->resize(1456, 952);
    settle();
    EXPECT_NEAR(dock("scopeDock")->height(), before, 2);
}

TEST_F(LayoutsTest, EachComesBackAsItWasLeft) {
    dock("messagesDock")->close();
    strike(Qt::Key_2, Qt::ControlModifier);
    EXPECT_TRUE(dock("responseDock")->isVisible());
    EXPECT_FALSE(dock("chainDock")->isVisible());
    dock("chainDock")->toggleViewAction()->trigger();
    settle();
    strike(Qt::Key_3, Qt::ControlModifier);
    EXPECT_TRUE(dock("monitorDock")->isVisible());
    EXPECT_FALSE(dock("scopeDock")->isVisible());
    strike(Qt::Key_1, Qt::ControlModifier);
    EXPECT_FALSE(dock("messagesDock")->isVisible());
    EXPECT_FALSE(dock("responseDock")->isVisible());
    EXPECT_TRUE(window->findChild<QAction*>(u"operateLayoutAction"_s)->isChecked());
    strike(Qt::Key_2, Qt::ControlModifier);
    EXPECT_TRUE(dock("chainDock")->isVisible());
    window->findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
    settle();
    EXPECT_FALSE(dock("chainDock")->isVisible()) << "as it was initially";
    EXPECT_TRUE(dock("responseDock")->isVisible());
}

TEST_F(LayoutsTest, TheNextWindowHasTheOneThatWasChosen) {
    strike(Qt::Key_2, Qt::ControlModifier);
    window->close();
    window = std::make_unique<MainWindow>(settings);
    window->resize(1456, 952);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), testing_support::kPatienceMs));
    showServo();
    settle();
    EXPECT_TRUE(window->findChild<QAction*>(u"tuneLayoutAction"_s)->isChecked());
    EXPECT_TRUE(dock("responseDock")->isVisible());
    expectWhole(u"responseButton"_s);
}

TEST_F(LayoutsTest, ThePlotsHaveWhatTheWindowGains) {
    strike(Qt::Key_2, Qt::ControlModifier);
    const int column = window->centralWidget()->width();
    const int plots = dock("scopeDock")->width();
    window->resize(1756, 952);
    settle();
    EXPECT_NEAR(window->centralWidget()->width(), column, 5);
    EXPECT_NEAR(dock("scopeDock")->width(), plots + 300, 5);
}

TEST_F(LayoutsTest, ADockOpenedBesideThePlotsTakesItsWidthFromThem) {
    strike(Qt::Key_2, Qt::ControlModifier);
    const int column = window->centralWidget()->width();
    const int plots = dock("scopeDock")->width();
    dock("messagesDock")->toggleViewAction()->trigger();
    settle();
    ASSERT_TRUE(dock("messagesDock")->isVisible());
    EXPECT_NEAR(window->centralWidget()->width(), column, 5);
    EXPECT_LT(dock("scopeDock")->width(), plots);
    dock("messagesDock")->close();  // as its button does
    settle();
    EXPECT_NEAR(window->centralWidget()->width(), column, 5);
    EXPECT_NEAR(dock("scopeDock")->width(), plots, 5);
    window->findChild<Layouts*>()->open(*dock("messagesDock"));  // as a message does
    settle();
    ASSERT_TRUE(dock("messagesDock")->isVisible());
    EXPECT_NEAR(window->centralWidget()->width(), column, 5);
    dock("messagesDock")->toggleViewAction()->trigger();
    settle();
    EXPECT_NEAR(window->centralWidget()->width(), column, 5);
    EXPECT_NEAR(dock("scopeDock")->width(), plots, 5);
}

TEST_F(LayoutsTest, TuneInASmallWindowAndBackIsNoTrouble) {
    for (const QSize size : {QSize(800, 600), QSize(1456, 952), QSize(780, 480), QSize(1200, 700)}) {
        window->resize(size);
        settle();
        strike(Qt::Key_2, Qt::ControlModifier);
        window->resize(size / 2);
        settle();
        window->findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
        settle();
        find(u"stopAllButton"_s);
        EXPECT_FALSE(find(u"stopAllButton"_s)->visibleRegion().isEmpty());
        strike(Qt::Key_1, Qt::ControlModifier);
    }
}

TEST_F(LayoutsTest, TheFormGoesBackToItsPlace) {
    strike(Qt::Key_2, Qt::ControlModifier);
    strike(Qt::Key_1, Qt::ControlModifier);
    window->findChild<QAction*>(u"responseDockAction"_s)->trigger();
    settle();
    EXPECT_TRUE(dock("responseDock")->isAncestorOf(find(u"responseForm"_s)));
    click(u"responseButton"_s);
    EXPECT_EQ(last<intent::StepResponse>().counts, 100);
}

TEST_F(LayoutsTest, EnterInAFieldAppliesTheGains) {
    typeGain(u"kpField"_s, u"101"_s);
    QTest::keyClick(window->findChild<QWidget*>(u"kpField"_s), Qt::Key_Return);
    EXPECT_EQ(last<intent::ApplyGains>().gains.kp, 101);
    typeGain(u"kpField"_s, u"99999"_s);
    intents.clear();
    QTest::keyClick(window->findChild<QWidget*>(u"kpField"_s), Qt::Key_Return);
    EXPECT_TRUE(intents.isEmpty()) << "it is out of range";
}

TEST_F(LayoutsTest, GainsAreTriedAndKept) {
    EXPECT_FALSE(button(u"tryGainsButton"_s)->isEnabled()) << "the module already has these";
    EXPECT_FALSE(button(u"keepGainsButton"_s)->isEnabled());
    typeGain(u"kpField"_s, u"101"_s);
    intents.clear();
    click(u"tryGainsButton"_s);
    EXPECT_EQ(last<intent::TryGains>().gains.kp, 101);
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    report.stage = ProcedureStage::Trying;
    window->showProcedure(report);
    settle();
    EXPECT_FALSE(button(u"tryGainsButton"_s)->isEnabled());
    // The trial has lowered the output limit of the module, but this is not an edit.
    Servo servo;
    servo.held = true;
    ModuleState module = servo.state();
    module.gains->kp = 101;
    module.gains->ol = 63;
    window->showLink(connectedTo({module}));
    settle();
    EXPECT_EQ(window->findChild<QLineEdit*>(u"olField"_s)->text(), u"255"_s);
    EXPECT_FALSE(button(u"revertGainsButton"_s)->isEnabled());
    click(u"keepGainsButton"_s);
    last<intent::KeepGains>();
}

TEST_F(LayoutsTest, AStepIsMadeFromAnywhereAndSeen) {
    EXPECT_FALSE(dock("responseDock")->isVisible());
    find(u"goalField"_s)->setFocus();
    strike(Qt::Key_F9, Qt::ShiftModifier);
    EXPECT_EQ(last<intent::StepResponse>().counts, 100);
    EXPECT_TRUE(dock("responseDock")->isVisible());
}

TEST_F(LayoutsTest, AStepThatIsRefusedSaysWhy) {
    showServo({.on = false});
    strike(Qt::Key_F9, Qt::ShiftModifier);
    EXPECT_TRUE(intents.isEmpty());
    EXPECT_TRUE(dock("responseDock")->isVisible());
    EXPECT_FALSE(text(u"responseState"_s).isEmpty());
}

/// The machine keeps what is typed, as in the program.
class UnsentGains : public LayoutsTest {
protected:
    UnsentGains() {
        QObject::connect(&window->requests(), &Requests::axisEdited, window.get(),
                         [this](ModuleIndex, const AxisSettings& edited) {
                             machine.axes = {edited};
                             window->showMachine(machine);
                         });
        strike(Qt::Key_2, Qt::ControlModifier);
        typeGain(u"kpField"_s, QString::number(someGains().kp + 1));
        intents.clear();
        strike(Qt::Key_F9, Qt::ShiftModifier);
        EXPECT_TRUE(intents.isEmpty()) << "it asks first";
    }
};

TEST_F(UnsentGains, AreAppliedAndTheStepMadeWithThem) {
    EXPECT_TRUE(text(u"closeText"_s).contains(u"Kp"_s));
    click(u"applyAndStepButton"_s);
    const auto step = last<intent::StepResponse>();
    ASSERT_TRUE(step.gains);
    EXPECT_EQ(step.gains->kp, someGains().kp + 1);
}

TEST_F(UnsentGains, OrTheStepIsMadeWithThoseThatItHas) {
    click(u"stepWithoutButton"_s);
    EXPECT_FALSE(last<intent::StepResponse>().gains);
}

TEST_F(UnsentGains, AndTheQuestionIsWithdrawnWhenTheStepIsAnotherOne) {
    type(u"responseDistanceField"_s, u"50"_s);
    click(u"stepWithoutButton"_s);
    EXPECT_TRUE(intents.isEmpty()) << "it was asked about 100 counts";
}

/// The step is made with them: it ends the trial, which has lowered the output limit.
TEST_F(UnsentGains, WithinATrialAreThoseThatDifferFromTheOnesFromBefore) {
    click(u"cancelStepButton"_s);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ProcedureReport report;
    report.kind = ProcedureKind::TryGains;
    report.stage = ProcedureStage::Trying;
    report.gains = someGains();
    window->showProcedure(report);
    ModuleState module = Servo{.held = true}.state();
    module.gains->kp = someGains().kp + 1;
    module.gains->ol = 63;
    window->showLink(connectedTo({module}));
    settle();
    click(u"responseButton"_s);
    ASSERT_NE(window->findChild<QLabel*>(u"closeText"_s), nullptr) << "it asks";
    EXPECT_TRUE(text(u"closeText"_s).contains(u"Kp"_s));
    EXPECT_FALSE(text(u"closeText"_s).contains(u"OL"_s)) << text(u"closeText"_s).toStdString();
}

TEST_F(UnsentGains, OrNothingIsDone) {
    click(u"cancelStepButton"_s);
    EXPECT_TRUE(intents.isEmpty());
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard as a pendant: two keys move, and whatever takes one of them away stops.
#include <QAbstractItemView>
#include <QAction>
#include <QDialog>
#include <QMenu>
#include <functional>

#include "tests/model/stepfixture.h"
#include "widgets/panels/holdbutton.h"
#include "windowtest.h"

namespace nmc {
namespace {

class PendantMode : public WindowTest {
protected:
    PendantMode() {
        showServo();
        window->setHoldInterval(5);
    }
    /// What has the focus, as a keyboard has it.
    QWidget* focused() {
        QWidget* widget = QApplication::focusWidget();
        return widget != nullptr ? widget : window.get();
    }
    void begin() {
        QTest::keyClick(focused(), Qt::Key_F12);
        ASSERT_TRUE(find(u"pendantRibbon"_s)->isVisible());
    }
    void press(Qt::Key arrow = Qt::Key_Right) {
        QTest::keyPress(focused(), Qt::Key_Shift);
        QTest::keyPress(focused(), arrow, Qt::ShiftModifier);
    }
    void autoRepeat(Qt::Key key) {
        QKeyEvent up(QEvent::KeyRelease, key, Qt::ShiftModifier, {}, true);
        QKeyEvent down(QEvent::KeyPress, key, Qt::ShiftModifier, {}, true);
        QApplication::sendEvent(focused(), &up);
        QApplication::sendEvent(focused(), &down);
    }
    bus::HoldToMove hold(qsizetype at = 0) { return holds.at(at).at(0).value<bus::HoldToMove>(); }
    /// Ended, and no evidence goes on.
    void expectEnded() {
        EXPECT_EQ(releases.size(), 1);
        const qsizetype before = holds.size();
        QTimer reference;
        QSignalSpy chances(&reference, &QTimer::timeout);
        reference.start(5);
        EXPECT_TRUE(QTest::qWaitFor([&chances] { return chances.size() >= 3; }));
        EXPECT_EQ(holds.size(), before);
    }
    QSignalSpy holds{window.get(), &MainWindow::holdRequested};
    QSignalSpy releases{window.get(), &MainWindow::holdReleased};
};

TEST_F(PendantMode, MovesWhileShiftAndAnArrowAreHeld) {
    begin();
    press();
    ASSERT_EQ(holds.size(), 1);
    EXPECT_EQ(hold().module, ModuleIndex(0));
    EXPECT_FALSE(hold().reverse);
    EXPECT_EQ(hold().velocity.value(), 16384U) << "the speed that the jog box shows, 0.25 counts/tick";
    EXPECT_TRUE(QTest::qWaitFor([this] { return holds.size() >= 4; }));
    EXPECT_EQ(hold(3).press, hold().press);
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
    expectEnded();
    const qsizetype before = holds.size();
    press(Qt::Key_Left);
    ASSERT_GT(holds.size(), before);
    EXPECT_TRUE(hold(before).reverse);
    EXPECT_GT(hold(before).press, hold().press);
    QTest::keyRelease(focused(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_TRUE(find(u"pendantRibbon"_s)->isVisible()) << "the mode goes on";
}

TEST_F(PendantMode, NeitherKeyAloneMovesAndNothingDoesOutsideOfTheMode) {
    press();
    EXPECT_EQ(holds.size(), 0);
    QTest::keyRelease(focused(), Qt::Key_Right);
    QTest::keyRelease(focused(), Qt::Key_Shift);
    begin();
    QTest::keyClick(focused(), Qt::Key_Shift);
    QTest::keyPress(focused(), Qt::Key_Right);
    QTest::keyPress(focused(), Qt::Key_Shift);  // an arrow that was held before
    autoRepeat(Qt::Key_Right);
    QTest::keyRelease(focused(), Qt::Key_Right);
    QTest::keyClick(focused(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(focused(), Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_EQ(holds.size(), 0);
}

TEST_F(PendantMode, AutoRepeatIsNeitherAPressNorARelease) {
    begin();
    press();
    autoRepeat(Qt::Key_Right);
    EXPECT_EQ(releases.size(), 0);
    window->endHold();  // as the bus does
    EXPECT_EQ(releases.size(), 1);
    const qsizetype before = holds.size();
    autoRepeat(Qt::Key_Right);
    EXPECT_EQ(holds.size(), before) << "once ended it stays so until the key was up";
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
    press();
    EXPECT_EQ(holds.size(), before + 1);
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
}

TEST_F(PendantMode, WorksFromAFieldThatWouldSelectWithTheseKeys) {
    auto* goal = find<QLineEdit>(u"goalField"_s);
    type(u"goalField"_s, u"1234"_s);
    begin();
    ASSERT_TRUE(goal->hasFocus());
    press(Qt::Key_Left);
    EXPECT_EQ(holds.size(), 1);
    EXPECT_FALSE(goal->hasSelectedText());
    QTest::keyRelease(focused(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(goal->text(), u"1234"_s);
}

TEST_F(PendantMode, ANotPossibleMoveSaysWhyInTheRibbon) {
    showServo({.on = false});
    begin();
    press();
    EXPECT_EQ(holds.size(), 0);
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"The servo is off. Enable it first."_s))
        << text(u"pendantRibbonText"_s).toStdString();
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
}

TEST_F(PendantMode, MovesAStepperToo) {
    testing_support::Stepper stepper = testing_support::Stepper::holding();
    window->showLink(connectedTo({stepper.module}));
    begin();
    press();
    ASSERT_EQ(holds.size(), 1);
    ASSERT_TRUE(hold().pace.has_value());
    EXPECT_FALSE(hold().reverse);
    QTest::keyRelease(focused(), Qt::Key_Shift);
    expectEnded();
}

TEST_F(PendantMode, TheRibbonNamesTheAxisThatIsChosen) {
    showServos({{}, {}});
    begin();
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"Module 1"_s));
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setFocus();
    QTest::keyClick(chain, Qt::Key_Down);
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"Module 2"_s));
    press();
    ASSERT_EQ(holds.size(), 1);
    EXPECT_EQ(hold().module, ModuleIndex(1));
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
}

TEST_F(PendantMode, StandsInTheModuleMenuWithItsKey) {
    QMenu menu;
    window->fillModuleMenu(menu);
    auto* action = window->findChild<QAction*>(u"pendantAction"_s);
    ASSERT_TRUE(menu.actions().contains(action));
    EXPECT_EQ(action->shortcut(), QKeySequence(Qt::Key_F12));
    QTest::keyClick(focused(), Qt::Key_F12);
    QTest::keyClick(focused(), Qt::Key_F12);
    EXPECT_FALSE(find(u"pendantRibbon"_s)->isVisible());
}

TEST_F(PendantMode, NeedsSomethingToMoveAndSomebodyToTell) {
    auto* action = window->findChild<QAction*>(u"pendantAction"_s);
    LinkState link = connectedTo({Servo{}.state()});
    for (const LinkPhase phase : {LinkPhase::Disconnected, LinkPhase::Connecting, LinkPhase::Lost}) {
        link.phase = phase;
        window->showLink(link);
        EXPECT_FALSE(action->isEnabled()) << static_cast<int>(phase);
    }
    link.phase = LinkPhase::Connected;
    link.readOnly = link.modules[0].readOnly = true;
    window->showLink(link);
    EXPECT_FALSE(action->isEnabled());
    EXPECT_TRUE(action->toolTip().contains(u"read-only"_s));
}

struct Ending {
    const char* name;
    bool modeToo;
    std::function<void(MainWindow&)> happen;
};
void PrintTo(const Ending& ending, std::ostream* out) {
    *out << ending.name;
}
class PendantEnds : public PendantMode, public testing::WithParamInterface<Ending> {};

TEST_P(PendantEnds, AtOnceAndForGood) {
    showServos({{}, {}});
    begin();
    press();
    ASSERT_EQ(holds.size(), 1);
    GetParam().happen(*window);
    expectEnded();
    EXPECT_EQ(window->findChild<QAction*>(u"pendantAction"_s)->isChecked(), !GetParam().modeToo);
}

QWidget* focusIn(MainWindow& window) {
    QWidget* widget = QApplication::focusWidget();
    return widget != nullptr ? widget : &window;
}

const std::array kEndings{
    Ending{"TheArrowIsReleased", false,
           [](MainWindow& w) { QTest::keyRelease(focusIn(w), Qt::Key_Right, Qt::ShiftModifier); }},
    Ending{"ShiftIsReleased", false, [](MainWindow& w) { QTest::keyRelease(focusIn(w), Qt::Key_Shift); }},
    Ending{"TheOtherArrow", false,
           [](MainWindow& w) {
               // Shift is down already; QTest would press it again.
               QKeyEvent left(QEvent::KeyPress, Qt::Key_Left, Qt::ShiftModifier);
               QApplication::sendEvent(focusIn(w), &left);
           }},
    Ending{"AnyOtherKey", false, [](MainWindow& w) { QTest::keyPress(focusIn(w), Qt::Key_A); }},
    Ending{"TheMouse", false,
           [](MainWindow& w) {
               QTest::mousePress(w.findChild<QWidget*>(QStringLiteral("messageList")), Qt::LeftButton);
           }},
    Ending{"Esc", true, [](MainWindow& w) { QTest::keyClick(focusIn(w), Qt::Key_Escape); }},
    Ending{"StopAll", false,
           [](MainWindow& w) {
               QTest::mousePress(w.findChild<QWidget*>(QStringLiteral("stopAllButton")), Qt::LeftButton);
           }},
    Ending{"ADialog", true,
           [](MainWindow& w) {
               w.askBeforeRestart();
               ASSERT_TRUE(
                   QTest::qWaitForWindowActive(w.findChild<QDialog*>(QStringLiteral("restartDialog"))));
           }},
    Ending{"AnotherWindow", true,
           [](MainWindow&) {
               QWidget other;
               other.show();
               other.activateWindow();
               ASSERT_TRUE(QTest::qWaitForWindowActive(&other));
           }},
    Ending{"TheWindowHides", true, [](MainWindow& w) { w.hide(); }},
    Ending{"TheLinkIsLost", true,
           [](MainWindow& w) {
               LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
               link.phase = LinkPhase::Lost;
               w.showLink(link);
           }},
    Ending{"Disconnected", true, [](MainWindow& w) { w.showLink({}); }},
    Ending{"TheChainIsLookedForAnew", true,
           [](MainWindow& w) {
               LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
               link.phase = LinkPhase::Connecting;
               w.showLink(link);
           }},
    Ending{"TheServoGoesOff", false,
           [](MainWindow& w) {
               w.showLink(connectedTo({Servo{.on = false}.state(), Servo{.index = 1}.state()}));
           }},
    Ending{"TheModuleIsSilent", false,
           [](MainWindow& w) {
               LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
               link.modules[0].silent = true;
               w.showLink(link);
           }},
    Ending{"AnotherModuleIsChosen", false,
           [](MainWindow& w) {
               auto* chain = w.findChild<QAbstractItemView*>(QStringLiteral("chainList"));
               chain->setCurrentIndex(chain->model()->index(1, 0));
           }},
};
INSTANTIATE_TEST_SUITE_P(When, PendantEnds, testing::ValuesIn(kEndings),
                         [](const testing::TestParamInfo<Ending>& ending) {
                             return std::string(ending.param.name);
                         });

}  // namespace
}  // namespace nmc

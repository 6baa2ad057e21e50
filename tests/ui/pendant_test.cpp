// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard, gamepad and jog wheel as a pendant: a motion takes two hands, and whatever takes one of them away
// stops it.
#include <functional>

#include "tests/model/stepperfixture.h"
#include "tests/support/virtualpad.h"
#include "tests/support/virtualwheel.h"
#include "widgets/panels/holdbutton.h"
#include "windowtest.h"

namespace nmc {
namespace {

class PendantMode : public WindowTest {
protected:
    PendantMode() {
        showServo();
        holdOften();
    }
    /// The buttons of the page that is shown report so often that no test has to wait for long.
    void holdOften() {
        for (HoldButton* button : window->findChildren<HoldButton*>())
            button->setInterval(5);
    }
    /// The widget that receives the keys.
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
    /// Expects that the hold has ended, and that no evidence comes any more.
    void expectEnded() {
        EXPECT_EQ(releases.size(), 1);
        const qsizetype before = holds.size();
        wait();
        EXPECT_EQ(holds.size(), before);
    }
    /// Waits for longer than it takes to send evidence again and to read a gamepad.
    static void wait() {
        QTimer reference;
        QSignalSpy chances(&reference, &QTimer::timeout);
        reference.start(15);
        EXPECT_TRUE(eventually([&chances] { return chances.size() >= 3; }));
    }
    QSignalSpy holds{&window->requests(), &Requests::hold};
    QSignalSpy releases{&window->requests(), &Requests::holdReleased};
};

TEST_F(PendantMode, MovesWhileShiftAndAnArrowAreHeld) {
    begin();
    press();
    ASSERT_EQ(holds.size(), 1);
    EXPECT_EQ(hold().module, ModuleIndex(0));
    EXPECT_FALSE(hold().reverse);
    EXPECT_EQ(hold().velocity.value(), 16384U) << "the speed that the jog box shows, 0.25 counts/tick";
    EXPECT_TRUE(eventually([this] { return holds.size() >= 4; }));
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
    QTest::keyPress(focused(), Qt::Key_Shift);  // the arrow was held before
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
    EXPECT_EQ(holds.size(), before) << "it stays ended until the key was released";
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

TEST_F(PendantMode, WhyAMoveWasNotPossibleIsSaidOfItsModuleOnly) {
    showServos({{.on = false}, {}});
    begin();
    press();
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
    ASSERT_TRUE(text(u"pendantRibbonText"_s).contains(u"The servo is off."_s));
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setFocus();
    QTest::keyClick(chain, Qt::Key_Down);
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"Module 2"_s));
    EXPECT_FALSE(text(u"pendantRibbonText"_s).contains(u"The servo is off."_s))
        << text(u"pendantRibbonText"_s).toStdString();
}

TEST_F(PendantMode, MovesAStepperToo) {
    testing_support::Stepper stepper = testing_support::Stepper::holding();
    window->showLink(connectedTo({stepper.module}));
    holdOften();
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

struct PendantEnding {
    const char* name;
    bool modeToo;
    std::function<void(MainWindow&)> happen;
};
void PrintTo(const PendantEnding& ending, std::ostream* out) {
    *out << ending.name;
}

class WheelMode : public PendantMode {
protected:
    using Wheel = testing_support::VirtualWheel;

    WheelMode() {
        QObject::connect(&window->requests(), &Requests::intent, window.get(),
                         [this](ModuleIndex /*module*/, const Intent& intent) { asked.push_back(intent); });
    }
    /// What was requested: the counts of a move, or nothing for the end of moves.
    [[nodiscard]] std::vector<std::optional<std::int32_t>> moves() const {
        std::vector<std::optional<std::int32_t>> counts;
        for (const Intent& intent : asked)
            if (const auto* by = std::get_if<intent::MoveBy>(&intent))
                counts.emplace_back(by->moves.counts);
            else if (std::holds_alternative<intent::CancelProcedure>(intent))
                counts.emplace_back();
        return counts;
    }
    /// The module answers, and its series of steps is at this stage.
    void showMoves(ProcedureStage stage, bool on = true) {
        ProcedureReport report;
        report.kind = ProcedureKind::MoveBy;
        report.module = ModuleIndex(0);
        report.stage = stage;
        window->showProcedure(report);
        showServo({.on = on, .millisecond = ++m_millisecond});
    }
    std::vector<Intent> asked;
    Wheel wheel;  // unplugged first, which ends a move

private:
    int m_millisecond = 0;
};

/// A step is 100 counts at first.
TEST_F(WheelMode, TheWheelMovesByStepsAndThoseThatComeMeanwhileBecomeOneMove) {
    begin();
    wheel.turn(1);
    wheel.press();
    EXPECT_TRUE(moves().empty());
    wheel.turn(1);
    EXPECT_THAT(moves(), testing::ElementsAre(100));
    wheel.turn(1);  // before the module has answered
    showMoves(ProcedureStage::Moving);
    wheel.turn(3);
    EXPECT_THAT(moves(), testing::ElementsAre(100));
    showMoves(ProcedureStage::Done);
    EXPECT_THAT(moves(), testing::ElementsAre(100, 400));
    showMoves(ProcedureStage::Moving);
    wheel.turn(-2);
    showMoves(ProcedureStage::Done);
    EXPECT_THAT(moves(), testing::ElementsAre(100, 400, -200));
}

TEST_F(WheelMode, ReleasingTheButtonEndsTheStepsThatLastAndThoseThatWait) {
    begin();
    wheel.press();
    wheel.turn(1);
    showMoves(ProcedureStage::Moving);
    wheel.turn(5);
    wheel.release();
    EXPECT_THAT(moves(), testing::ElementsAre(100, std::nullopt));
    showMoves(ProcedureStage::Cancelled);
    EXPECT_THAT(moves(), testing::ElementsAre(100, std::nullopt));
}

TEST_F(WheelMode, StepsThatAreNotPossibleSayWhyInTheRibbon) {
    showServo({.on = false});
    begin();
    wheel.press();
    wheel.turn(1);
    EXPECT_TRUE(moves().empty());
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"Not moved: "_s))
        << text(u"pendantRibbonText"_s).toStdString();
    showServo({.millisecond = 1});
    EXPECT_TRUE(moves().empty()) << "what was refused does not come later";
}

TEST_F(WheelMode, StepsThatWaitedAndAreNotPossibleSayWhyInTheRibbonToo) {
    begin();
    wheel.press();
    wheel.turn(1);
    showMoves(ProcedureStage::Moving);
    wheel.turn(3);
    showMoves(ProcedureStage::Moving, false);
    EXPECT_FALSE(text(u"pendantRibbonText"_s).contains(u"Not moved: "_s)) << "the steps still wait";
    showMoves(ProcedureStage::Failed, false);
    EXPECT_THAT(moves(), testing::ElementsAre(100));
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"Not moved: The servo is off."_s))
        << text(u"pendantRibbonText"_s).toStdString();
}

TEST_F(WheelMode, TheRingMovesAtAShareOfTheJogSpeed) {
    begin();
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"hold a button of the jog wheel"_s));
    wheel.press();
    wheel.push(-7);
    ASSERT_GE(holds.size(), 1);
    EXPECT_TRUE(hold().reverse);
    EXPECT_EQ(hold().velocity.value(), 16384U) << "the speed that the jog box shows";
    wheel.push(-1);
    EXPECT_NEAR(hold(holds.size() - 1).velocity.value(), 16384.0 / 7, 1);
    EXPECT_EQ(hold(holds.size() - 1).press, hold().press) << "one hold, which changes its speed";
    EXPECT_EQ(releases.size(), 0);
    wheel.push(0);
    expectEnded();
}

TEST_F(WheelMode, ItsButtonEndsTheMotionAndTheMouseToo) {
    begin();
    wheel.press();
    wheel.push(3);
    ASSERT_GE(holds.size(), 1);
    wheel.release();
    expectEnded();
    wheel.push(0);
    wheel.press();
    wheel.push(3);
    QTest::mouseClick(window.get(), Qt::LeftButton);
    EXPECT_EQ(releases.size(), 2);
    const qsizetype before = holds.size();
    wheel.push(4);
    wait();
    EXPECT_EQ(holds.size(), before) << "it has not been at its centre";
}

TEST_F(WheelMode, TheMiddleButtonStopsAll) {
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    begin();
    wheel.press(Wheel::kMiddleButton);
    EXPECT_EQ(stops.size(), 1);
}

class GamepadMode : public PendantMode {
protected:
    using Button = testing_support::VirtualPad::Button;
    static constexpr auto kShoulder = Button::RightShoulder;

    void SetUp() override { ASSERT_TRUE(pad.works()); }
    void beginWithPad() {
        begin();
        ASSERT_TRUE(eventually([this] { return saysGamepad(); }));
    }
    /// Holds the shoulder button first, then pushes the stick to the right.
    void hold() {
        pad.press(kShoulder);
        wait();
        pad.push(1);
        ASSERT_TRUE(eventually([this] { return !holds.isEmpty(); }));
    }
    bool saysGamepad() { return text(u"pendantRibbonText"_s).contains(u"shoulder button of the gamepad"_s); }
    bool ended() {
        return eventually([this] { return !releases.isEmpty(); });
    }
    testing_support::VirtualPad pad;
};

TEST_F(GamepadMode, MovesWhileAShoulderButtonAndTheStickAreHeld) {
    beginWithPad();
    hold();
    EXPECT_EQ(PendantMode::hold().module, ModuleIndex(0));
    EXPECT_FALSE(PendantMode::hold().reverse);
    EXPECT_EQ(PendantMode::hold().velocity.value(), 16384U) << "the speed that the jog box shows";
    EXPECT_TRUE(eventually([this] { return holds.size() >= 4; }));
    pad.push(0);
    ASSERT_TRUE(ended());
    expectEnded();
    const qsizetype before = holds.size();
    pad.push(-1);
    ASSERT_TRUE(eventually([&] { return holds.size() > before; }));
    EXPECT_TRUE(PendantMode::hold(before).reverse);
}

TEST_F(GamepadMode, TheCrossAndTheOtherShoulderDoTheSame) {
    beginWithPad();
    pad.press(Button::LeftShoulder);
    wait();
    pad.press(Button::CrossLeft);
    ASSERT_TRUE(eventually([this] { return !holds.isEmpty(); }));
    EXPECT_TRUE(PendantMode::hold().reverse);
    pad.press(Button::CrossRight);  // both directions cancel out
    ASSERT_TRUE(ended());
    expectEnded();
}

TEST_F(GamepadMode, NeitherHandAloneMovesNorOneThatCameFirst) {
    beginWithPad();
    pad.press(kShoulder);
    wait();
    pad.push(0.4);  // less than half of its way
    wait();
    pad.release(kShoulder);
    pad.push(1);
    wait();
    pad.press(kShoulder);  // while the stick is pushed, or stuck
    wait();
    EXPECT_EQ(holds.size(), 0);
}

TEST_F(GamepadMode, WhatIsHeldWhenTheModeBeginsMovesNothing) {
    pad.press(kShoulder);
    pad.push(1);
    beginWithPad();
    wait();
    EXPECT_EQ(holds.size(), 0);
}

TEST_F(GamepadMode, EndsWithTheShoulderButton) {
    beginWithPad();
    hold();
    pad.release(kShoulder);
    ASSERT_TRUE(ended());
    expectEnded();
    pad.press(kShoulder);
    wait();
    EXPECT_EQ(releases.size(), 1) << "the stick has not been back in its middle";
}

TEST_F(GamepadMode, EndsWithTheOtherWay) {
    beginWithPad();
    hold();
    pad.push(-1);
    ASSERT_TRUE(ended());
    expectEnded();
}

TEST_F(GamepadMode, EndsWhenItIsUnpluggedAndIsFoundAgain) {
    beginWithPad();
    hold();
    pad.unplug();
    ASSERT_TRUE(ended());
    expectEnded();
    EXPECT_FALSE(saysGamepad());
    EXPECT_TRUE(window->findChild<QAction*>(u"pendantAction"_s)->isChecked())
        << "the keyboard can still be used";
    testing_support::VirtualPad another;
    EXPECT_TRUE(eventually([this] { return saysGamepad(); }));
}

TEST_F(GamepadMode, OneButtonStopsAllWithTheOtherHandsOrWithout) {
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    beginWithPad();
    pad.press(Button::B);
    ASSERT_TRUE(eventually([&] { return stops.size() == 1; }));
    wait();
    EXPECT_EQ(stops.size(), 1) << "once for each press";
    pad.release(Button::B);
    wait();
    hold();
    pad.press(Button::B);
    ASSERT_TRUE(eventually([&] { return stops.size() == 2; }));
    expectEnded();
    EXPECT_TRUE(text(u"pendantRibbonText"_s).contains(u"B (○) is STOP ALL"_s));
}

TEST_F(GamepadMode, DoesNothingOutsideOfTheMode) {
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    beginWithPad();
    QTest::keyClick(focused(), Qt::Key_F12);
    pad.press(kShoulder);
    pad.push(1);
    pad.press(Button::B);
    wait();
    EXPECT_EQ(holds.size(), 0);
    EXPECT_EQ(stops.size(), 0);
}

TEST_F(GamepadMode, ANotPossibleMoveSaysWhyInTheRibbon) {
    showServo({.on = false});
    beginWithPad();
    pad.press(kShoulder);
    wait();
    pad.push(1);
    EXPECT_TRUE(eventually([this] {
        return text(u"pendantRibbonText"_s).contains(u"The servo is off. Enable it first."_s);
    })) << text(u"pendantRibbonText"_s).toStdString();
    EXPECT_EQ(holds.size(), 0);
}

TEST_F(GamepadMode, AKeyOfTheKeyboardEndsWhatThePadHoldsAndTheOtherWayRound) {
    beginWithPad();
    hold();
    QTest::keyPress(focused(), Qt::Key_Shift);
    expectEnded();
    pad.push(0);
    wait();
    qsizetype before = holds.size();
    QTest::keyPress(focused(), Qt::Key_Right, Qt::ShiftModifier);
    ASSERT_GT(holds.size(), before);
    pad.push(1);
    ASSERT_TRUE(eventually([this] { return releases.size() == 2; }));
    before = holds.size();
    wait();
    EXPECT_EQ(holds.size(), before);
    QTest::keyRelease(focused(), Qt::Key_Right, Qt::ShiftModifier);
}

/// Otherwise, the button of the first hand would stay down with nobody to release it.
TEST_F(GamepadMode, AnArrowWhileThePadHoldsEndsTheMotionAlthoughShiftWasDownBefore) {
    beginWithPad();
    QTest::keyPress(focused(), Qt::Key_Shift);
    ASSERT_NO_FATAL_FAILURE(hold());
    // QTest would press Shift once more, which ends the motion by itself.
    QKeyEvent left(QEvent::KeyPress, Qt::Key_Left, Qt::ShiftModifier);
    QApplication::sendEvent(focused(), &left);
    expectEnded();
}

class PendantEnds : public PendantMode, public testing::WithParamInterface<PendantEnding> {};
class GamepadEnds : public GamepadMode, public testing::WithParamInterface<PendantEnding> {};

TEST_P(GamepadEnds, AtOnceAndForGood) {
    showServos({{}, {}});
    beginWithPad();
    hold();
    GetParam().happen(*window);
    expectEnded();
    EXPECT_EQ(window->findChild<QAction*>(u"pendantAction"_s)->isChecked(), !GetParam().modeToo);
}

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

const std::array kOfTheKeyboard{
    PendantEnding{"TheArrowIsReleased", false,
                  [](MainWindow& w) { QTest::keyRelease(focusIn(w), Qt::Key_Right, Qt::ShiftModifier); }},
    PendantEnding{"ShiftIsReleased", false,
                  [](MainWindow& w) { QTest::keyRelease(focusIn(w), Qt::Key_Shift); }},
    PendantEnding{"TheOtherArrow", false,
                  [](MainWindow& w) {
                      // Shift is down already; QTest would press it again.
                      QKeyEvent left(QEvent::KeyPress, Qt::Key_Left, Qt::ShiftModifier);
                      QApplication::sendEvent(focusIn(w), &left);
                  }},
};
const std::array kPendantEndings{
    PendantEnding{"AnyOtherKey", false, [](MainWindow& w) { QTest::keyPress(focusIn(w), Qt::Key_A); }},
    PendantEnding{"TheMouse", false,
                  [](MainWindow& w) {
                      QTest::mousePress(w.findChild<QWidget*>(QStringLiteral("messageList")), Qt::LeftButton);
                  }},
    PendantEnding{"Esc", true, [](MainWindow& w) { QTest::keyClick(focusIn(w), Qt::Key_Escape); }},
    PendantEnding{"StopAll", false,
                  [](MainWindow& w) {
                      QTest::mousePress(w.findChild<QWidget*>(QStringLiteral("stopAllButton")),
                                        Qt::LeftButton);
                  }},
    PendantEnding{"ADialog", true,
                  [](MainWindow& w) {
                      w.askBeforeRestart();
                      ASSERT_TRUE(
                          QTest::qWaitForWindowActive(w.findChild<QDialog*>(QStringLiteral("restartDialog")),
                                                      testing_support::kPatienceMs));
                  }},
    PendantEnding{"AnotherWindow", true,
                  [](MainWindow&) {
                      QWidget other;
                      other.show();
                      other.activateWindow();
                      ASSERT_TRUE(QTest::qWaitForWindowActive(&other, testing_support::kPatienceMs));
                  }},
    PendantEnding{"TheWindowHides", true, [](MainWindow& w) { w.hide(); }},
    PendantEnding{"TheLinkIsLost", true,
                  [](MainWindow& w) {
                      LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
                      link.phase = LinkPhase::Lost;
                      w.showLink(link);
                  }},
    PendantEnding{"Disconnected", true, [](MainWindow& w) { w.showLink({}); }},
    PendantEnding{"TheChainIsLookedForAnew", true,
                  [](MainWindow& w) {
                      LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
                      link.phase = LinkPhase::Connecting;
                      w.showLink(link);
                  }},
    PendantEnding{"TheServoGoesOff", false,
                  [](MainWindow& w) {
                      w.showLink(connectedTo({Servo{.on = false}.state(), Servo{.index = 1}.state()}));
                  }},
    PendantEnding{"TheModuleIsSilent", false,
                  [](MainWindow& w) {
                      LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
                      link.modules[0].silent = true;
                      w.showLink(link);
                  }},
    PendantEnding{"AnotherModuleIsChosen", false,
                  [](MainWindow& w) {
                      auto* chain = w.findChild<QAbstractItemView*>(QStringLiteral("chainList"));
                      chain->setCurrentIndex(chain->model()->index(1, 0));
                  }},
};
std::string nameOf(const testing::TestParamInfo<PendantEnding>& ending) {
    return ending.param.name;
}
INSTANTIATE_TEST_SUITE_P(OfTheKeyboard, PendantEnds, testing::ValuesIn(kOfTheKeyboard), nameOf);
INSTANTIATE_TEST_SUITE_P(When, PendantEnds, testing::ValuesIn(kPendantEndings), nameOf);
INSTANTIATE_TEST_SUITE_P(When, GamepadEnds, testing::ValuesIn(kPendantEndings), nameOf);

}  // namespace
}  // namespace nmc

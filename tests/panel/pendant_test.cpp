// SPDX-License-Identifier: GPL-3.0-or-later
// Pendant and operator mode in the whole program, checked with the simulated motor.
#include "tests/support/virtualpad.h"
#include "tests/support/virtualpanel.h"
#include "tests/support/virtualwheel.h"
#include "widgets/mainwindow/operatorlock.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class ByHand : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.enable());
        ASSERT_TRUE(panel.answersFor(0.3));
    }
    void TearDown() override { texts::setModuleNames({}); }
    QWidget* focused() {
        QWidget* widget = QApplication::focusWidget();
        return widget != nullptr ? widget : &panel.window();
    }
    [[nodiscard]] bool rests() {
        return panel.waitFor([&] { return !moves(sim) && !panel.module().moving(); });
    }
    /// What is held when the line is lost moves nothing when it is back. The motor itself runs on meanwhile.
    void loseTheLine() {
        sim.unplug();
        ASSERT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
        sim.plugIn();
        panel.composition().show({sim.terminal(), 115'200, false});
        ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
        panel.pressStopAll();
        ASSERT_TRUE(rests());
        const double rest = shaft();
        ASSERT_TRUE(panel.answersFor(0.5));
        EXPECT_NEAR(shaft(), rest, 2);
    }
    void press() {
        QTest::keyPress(focused(), Qt::Key_Shift);
        QTest::keyPress(focused(), Qt::Key_Right, Qt::ShiftModifier);
    }
    [[nodiscard]] double shaft() { return sim.state(1)[u"position"_s].toDouble(); }
    void lock() {
        panel.window().findChild<QAction*>(u"operatorAction"_s)->trigger();
        for (const char* name : {"operatorPinField", "operatorPinAgainField"})
            QTest::keyClicks(panel.window().findChild<QLineEdit*>(QLatin1String(name)), u"4711"_s);
        panel.click("operatorBeginButton");
        panel.window().activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&panel.window()));
    }
    VirtualChain sim{u"servo,servo"_s};
    VirtualPanel panel;
};

TEST_F(ByHand, TheMotorMovesWhileBothKeysAreHeldAndStopsWithTheFirstThatIsReleased) {
    QTest::keyClick(focused(), Qt::Key_F12);
    const double before = shaft();
    press();
    ASSERT_TRUE(panel.waitFor([&] { return shaft() > before + 50; }));
    QTest::keyRelease(focused(), Qt::Key_Shift);
    EXPECT_TRUE(rests());
    const double rest = shaft();
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), rest, 2) << "the arrow is still held";
    QTest::keyRelease(focused(), Qt::Key_Right);
}

TEST_F(ByHand, ALostLineEndsTheMotionForGood) {
    QTest::keyClick(focused(), Qt::Key_F12);
    press();
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    loseTheLine();
}

TEST_F(ByHand, LosingTheFocusStopsItAndEndsTheMode) {
    QTest::keyClick(focused(), Qt::Key_F12);
    press();
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    QWidget other;
    other.show();
    other.activateWindow();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_FALSE(panel.window().findChild<QAction*>(u"pendantAction"_s)->isChecked());
}

class ByGamepad : public ByHand {
protected:
    using Button = testing_support::VirtualPad::Button;
    static constexpr auto kShoulder = Button::LeftShoulder;

    void SetUp() override {
        ByHand::SetUp();
        ASSERT_TRUE(pad.works());
        QTest::keyClick(focused(), Qt::Key_F12);
    }
    void hold() {
        const double before = shaft();
        pad.press(kShoulder);
        ASSERT_TRUE(panel.answersFor(0.1));
        pad.push(1);
        ASSERT_TRUE(panel.waitFor([&] { return shaft() > before + 50; }));
    }
    testing_support::VirtualPad pad;
};

TEST_F(ByGamepad, TheMotorMovesWhileBothAreHeldAndStopsWithTheFirstThatIsReleased) {
    ASSERT_NO_FATAL_FAILURE(hold());
    pad.release(kShoulder);
    EXPECT_TRUE(rests());
    const double rest = shaft();
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), rest, 2) << "the stick is still pushed";
}

TEST_F(ByGamepad, TakingThePadAwayStopsIt) {
    ASSERT_NO_FATAL_FAILURE(hold());
    pad.unplug();
    EXPECT_TRUE(rests());
}

TEST_F(ByGamepad, ALostLineEndsTheMotionForGood) {
    ASSERT_NO_FATAL_FAILURE(hold());
    loseTheLine();
}

TEST_F(ByGamepad, LosingTheFocusStopsIt) {
    ASSERT_NO_FATAL_FAILURE(hold());
    QWidget other;
    other.show();
    other.activateWindow();
    EXPECT_TRUE(rests());
}

TEST_F(ByGamepad, ItsStopButtonStopsWhatItDidNotSetGoing) {
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() == Activity::AtSpeed; }));
    pad.press(Button::B);
    EXPECT_TRUE(rests());
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"stopped"_s) >= 1; }));
}

class ByWheel : public ByHand {
protected:
    void SetUp() override {
        ByHand::SetUp();
        QTest::keyClick(focused(), Qt::Key_F12);
        wheel.press();
    }
    testing_support::VirtualWheel wheel;
    double before = 0;
};

/// A step is 100 counts at first.
TEST_F(ByWheel, StepsAddUpToTheirDistance) {
    before = shaft();
    wheel.turn(3);
    wheel.turn(-1);
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(shaft() - before - 200) < 2; }));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), before + 200, 2);
    wheel.turn(-2);
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(shaft() - before) < 2; })) << "the first steps are over";
}

TEST_F(ByWheel, ReleasingItsButtonStopsTheStepsThatAreLeft) {
    before = shaft();
    wheel.turn(1);
    wheel.turn(100);
    ASSERT_TRUE(panel.waitFor([&] { return shaft() > before + 500; }));
    wheel.release();
    EXPECT_TRUE(rests());
    EXPECT_LT(shaft(), before + 9'000);
    const double rest = shaft();
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), rest, 2);
}

TEST_F(ByWheel, TakingItAwayStopsTheMotor) {
    before = shaft();
    wheel.push(7);
    ASSERT_TRUE(panel.waitFor([&] { return shaft() > before + 50; }));
    wheel.unplug();
    EXPECT_TRUE(rests());
}

TEST_F(ByWheel, ALostLineEndsTheMotionForGood) {
    wheel.push(7);
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    loseTheLine();
}

TEST_F(ByHand, AnOperatorJogsAndStopsAndMovesItNoOtherWay) {
    ASSERT_NO_FATAL_FAILURE(lock());
    const double before = shaft();
    panel.ask(intent::Move{
        servomotion::Trapezoid{Counts(5'000), CountsPerTick(65'536), CountsPerTickSquared(100)}});
    panel.ask(
        intent::Move{servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(100), false}});
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_NEAR(shaft(), before, 2);
    EXPECT_GE(panel.count(u"Module 1 cannot do this now"_s), 1);
    auto* forward = panel.window().findChild<QWidget*>(u"holdForwardButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return forward->isEnabled(); })) << forward->toolTip().toStdString();
    QTest::mousePress(forward, Qt::LeftButton);
    ASSERT_TRUE(panel.waitFor([&] { return shaft() > before + 50; }));
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    QTest::mouseRelease(forward, Qt::LeftButton);
    panel.disconnect();
    EXPECT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
}

TEST_F(ByHand, AMotorThatRunsWhenTheModeBeginsCanBeStopped) {
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() == Activity::AtSpeed; }));
    ASSERT_NO_FATAL_FAILURE(lock());
    panel.click("stopSmoothlyButton");
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

}  // namespace
}  // namespace nmc

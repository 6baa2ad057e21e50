// SPDX-License-Identifier: GPL-3.0-or-later
// Where the focus goes when the control that has it can no longer be used; with real keys, which go to the
// focus.
#include "windowtest.h"

namespace nmc {
namespace {

class Focus : public WindowTest {
protected:
    Focus() { showServo(); }
    void press(Qt::Key key) { QTest::keyPress(window->windowHandle(), key); }
    void release(Qt::Key key) { QTest::keyRelease(window->windowHandle(), key); }
    void strike(Qt::Key key) { QTest::keyClick(window->windowHandle(), key); }
    /// Presses Tab as often as needed.
    void tabTo(const QString& name) {
        const int all = static_cast<int>(window->findChildren<QWidget*>().size());
        for (int i = 0; i < all && focused() != name; ++i)
            strike(Qt::Key_Tab);
        ASSERT_EQ(focused(), name);
    }
    [[nodiscard]] QString focused() const {
        const QWidget* widget = QApplication::focusWidget();
        return widget != nullptr ? widget->objectName() : QString();
    }
    /// Shows the module after Enable, when there is nothing left to enable.
    void showEnabled() {
        ModuleState module = Servo{.millisecond = 40}.state();
        module.amplifierEnabled = true;
        window->showLink(connectedTo({module}));
    }
    void turnTo(const QString& page) {
        auto* tabs = find<QTabWidget>(u"servoPages"_s);
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == page)
                QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(i).center());
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
    QSignalSpy holds{&window->requests(), &Requests::hold};
};

TEST_F(Focus, OfAHoldThatTheModuleEndsGoesToNoOtherDirection) {
    tabTo(u"holdForwardButton"_s);
    press(Qt::Key_Space);
    ASSERT_EQ(holds.size(), 1);
    showServo({.on = false, .millisecond = 20});
    EXPECT_EQ(focused(), QString());
    release(Qt::Key_Space);
    const qsizetype before = holds.size();
    strike(Qt::Key_Space);
    EXPECT_EQ(holds.size(), before);
    EXPECT_EQ(intents.size(), 0);
    showServo({.millisecond = 40});
    EXPECT_EQ(focused(), u"holdForwardButton"_s) << "where the user left it";
    EXPECT_EQ(holds.size(), before) << "and it waits for a press";
    press(Qt::Key_Space);
    ASSERT_EQ(holds.size(), before + 1);
    EXPECT_FALSE(holds.last().at(0).value<bus::HoldToMove>().reverse);
    release(Qt::Key_Space);
}

TEST_F(Focus, OfEnableDoesNotGoToMotorOff) {
    showServo({.on = false, .millisecond = 20});
    tabTo(u"enableButton"_s);
    strike(Qt::Key_Space);
    ASSERT_EQ(intents.size(), 1);
    showEnabled();
    strike(Qt::Key_Space);
    strike(Qt::Key_Space);
    EXPECT_EQ(intents.size(), 1) << "a second Space does not drop a load";
}

TEST_F(Focus, TabGoesOnFromWhereItWas) {
    showServo({.on = false, .millisecond = 20});
    tabTo(u"enableButton"_s);
    strike(Qt::Key_Space);
    showEnabled();
    EXPECT_EQ(focused(), QString());
    const QStringList head{u"stopSmoothlyButton"_s, u"stopAbruptlyButton"_s, u"stopHereButton"_s,
                           u"motorOffButton"_s};
    strike(Qt::Key_Tab);
    EXPECT_TRUE(head.contains(focused())) << focused().toStdString();
}

class FocusAfter : public Focus, public testing::WithParamInterface<const char*> {};

TEST_P(FocusAfter, AClickStaysOnTheButtonAndNotInAField) {
    const QString name = QLatin1String(GetParam());
    type(u"goalField"_s, u"1000"_s);
    QTest::mouseClick(button(name), Qt::LeftButton);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(focused(), QString()) << "while it waits for the module's answer";
    strike(Qt::Key_7);
    showServo({.millisecond = 20});
    EXPECT_EQ(focused(), name);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"1000"_s);
}
INSTANTIATE_TEST_SUITE_P(Buttons, FocusAfter,
                         testing::Values("goButton", "runForwardButton", "runReverseButton",
                                         "moveByForwardButton", "moveByReverseButton"));

TEST_F(Focus, GoesToNothingWhereAnotherWasChosenMeanwhile) {
    type(u"goalField"_s, u"1000"_s);
    QTest::mouseClick(button(u"goButton"_s), Qt::LeftButton);
    QTest::mouseClick(field(u"velocityField"_s), Qt::LeftButton);
    showServo({.millisecond = 20});
    EXPECT_EQ(focused(), u"velocityField"_s);
}

TEST_F(Focus, DoesNotComeToEnableByReconnecting) {
    tabTo(u"goalField"_s);
    window->showLink({});
    showServo({.on = false, .millisecond = 20});
    strike(Qt::Key_Space);
    EXPECT_EQ(intents.size(), 0) << focused().toStdString();
}

TEST_F(Focus, DoesNotComeToADriveByTurningThePage) {
    showServo({.on = false, .millisecond = 20});
    turnTo(u"PWM"_s);
    tabTo(u"pwmForwardButton"_s);
    turnTo(u"Axis"_s);
    turnTo(u"PWM"_s);
    EXPECT_EQ(focused(), u"servoPagesBar"_s);
    strike(Qt::Key_Space);
    EXPECT_EQ(intents.size(), 0);
}

/// By the key bindings of X11, a field takes Ctrl+U to remove its line, and Ctrl+D to remove a character.
/// Those of the tests' platform have no such keys.
class FieldOfX11 : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

protected:
    bool event(QEvent* event) override {
        const bool pressed = event->type() == QEvent::KeyPress;
        if (!pressed && event->type() != QEvent::ShortcutOverride)
            return QLineEdit::event(event);
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key != Qt::Key_U && key != Qt::Key_D)
            return QLineEdit::event(event);
        if (pressed)
            clear();
        event->accept();
        return true;
    }
};

TEST_F(Focus, InAFieldLeavesStopHereToTheModule) {
    auto* line = new FieldOfX11(window.get());
    line->setText(u"1234"_s);
    line->show();
    line->setFocus();
    ASSERT_TRUE(line->hasFocus());
    QTest::keyClick(window->windowHandle(), Qt::Key_U, Qt::ControlModifier);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::StopHere>(intents.last().at(1).value<Intent>()));
    EXPECT_EQ(line->text(), u"1234"_s);
    showServo({.on = false, .millisecond = 20});
    QTest::keyClick(window->windowHandle(), Qt::Key_U, Qt::ControlModifier);
    EXPECT_EQ(intents.size(), 1);
    EXPECT_EQ(line->text(), u"1234"_s) << "nor is it emptied while there is nothing to stop";
    QTest::keyClick(window->windowHandle(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(line->text(), u"1234"_s) << "while no move can be loaded";
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that are held down: they go on typing and moving the focus, but give no command twice.
#include "widgets/panels/holdbutton.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Repeat : public WindowTest {
protected:
    Repeat() { showServo(); }
    /// Presses a key once and repeats it as the system does, while the module keeps answering.
    void keepDown(Qt::Key key, Qt::KeyboardModifiers modifiers = {}, const QString& text = {}) {
        for (int i = 0; i < kTimes; ++i) {
            QTest::simulateEvent(window->windowHandle(), true, key, modifiers, text, i > 0);
            showServo({.position = i, .millisecond = 20 * ++m_answers});
        }
        QTest::simulateEvent(window->windowHandle(), false, key, modifiers, text, false);
    }
    static constexpr int kTimes = 5;
    QSignalSpy intents{&window->requests(), &Requests::intent};

private:
    int m_answers = 0;
};

TEST_F(Repeat, EnterWithADistanceMakesOneMove) {
    auto* kind = find<QComboBox>(u"goalKindBox"_s);
    kind->setFocus();
    QTest::keyClick(window->windowHandle(), Qt::Key_Down);
    ASSERT_EQ(kind->currentText(), u"distance"_s);
    type(u"goalField"_s, u"100"_s);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        intents.clear();
        keepDown(key, {}, u"\r"_s);
        EXPECT_EQ(intents.size(), 1);
    }
}

TEST_F(Repeat, AMnemonicMakesOneMove) {
    type(u"goalField"_s, u"100"_s);
    keepDown(Qt::Key_G, Qt::AltModifier, u"g"_s);
    EXPECT_EQ(eventually([this] { return intents.size() > 0; }), true);
    EXPECT_EQ(intents.size(), 1);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"100"_s);
}

TEST_F(Repeat, AShortcutMakesOneMove) {
    type(u"goalField"_s, u"100"_s);
    keepDown(Qt::Key_D, Qt::ControlModifier, u"\x04"_s);  // Load
    EXPECT_EQ(eventually([this] { return intents.size() > 0; }), true);
    EXPECT_EQ(intents.size(), 1);
}

TEST_F(Repeat, AChoiceIsSentOnce) {
    auto* tabs = find<QTabWidget>(u"servoPages"_s);
    QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(1).center());
    find(u"limit1UseBox"_s)->setFocus();
    keepDown(Qt::Key_Down);
    EXPECT_EQ(intents.size(), 1);
}

TEST_F(Repeat, TypesAndGoesOn) {
    type(u"goalField"_s, u"3"_s);
    keepDown(Qt::Key_1, {}, u"1"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"311111"_s);
    keepDown(Qt::Key_Backspace, {}, u"\b"_s);
    EXPECT_EQ(field(u"goalField"_s)->text(), u"3"_s);
    const QWidget* before = QApplication::focusWidget();
    keepDown(Qt::Key_Tab, {}, u"\t"_s);
    QTest::keyClick(window->windowHandle(), Qt::Key_Tab, Qt::ShiftModifier);
    EXPECT_NE(QApplication::focusWidget(), before) << "it went on by more than one control";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Repeat, DoesNotEndAHeldJog) {
    auto* forward = find<HoldButton>(u"holdForwardButton"_s);
    forward->setFocus();
    QTest::simulateEvent(window->windowHandle(), true, Qt::Key_Space, {}, u" "_s, false);
    for (int i = 0; i < kTimes; ++i)
        QTest::simulateEvent(window->windowHandle(), true, Qt::Key_Space, {}, u" "_s, true);
    EXPECT_TRUE(forward->isHeld());
    QTest::simulateEvent(window->windowHandle(), false, Qt::Key_Space, {}, u" "_s, false);
    EXPECT_FALSE(forward->isHeld());
}

}  // namespace
}  // namespace nmc

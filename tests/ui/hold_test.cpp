// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "widgets/panels/holdbutton.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Hold : public WindowTest {
protected:
    Hold() {
        showServo();
        for (HoldButton* button : window->findChildren<HoldButton*>())
            button->setInterval(5);
        forward = find<HoldButton>(u"holdForwardButton"_s);
    }
    void press() { QTest::mousePress(forward, Qt::LeftButton); }
    void expectEnded() {
        EXPECT_EQ(releases.size(), 1);
        EXPECT_FALSE(forward->isHeld());
        const qsizetype before = holds.size();
        // A timer like the button's own: once it has fired several times, the button's would have fired as
        // well.
        QTimer reference;
        QSignalSpy chances(&reference, &QTimer::timeout);
        reference.start(5);
        EXPECT_TRUE(eventually([&chances] { return chances.size() >= 3; }));
        EXPECT_EQ(holds.size(), before) << "no evidence comes after the end";
    }
    HoldButton* forward = nullptr;
    QSignalSpy holds{&window->requests(), &Requests::hold};
    QSignalSpy releases{&window->requests(), &Requests::holdReleased};
};

TEST_F(Hold, AsksOnPressAndAgainWhileHeld) {
    press();
    ASSERT_EQ(holds.size(), 1);
    const auto hold = holds.at(0).at(0).value<bus::HoldToMove>();
    EXPECT_EQ(hold.velocity.value(), 16384U);  // 0.25 counts/tick
    EXPECT_FALSE(hold.reverse);
    EXPECT_TRUE(eventually([this] { return holds.size() >= 4; }));
    QTest::mouseRelease(forward, Qt::LeftButton);
    expectEnded();
}

TEST_F(Hold, EachPressHasANumberOfItsOwnThatItKeeps) {
    press();
    ASSERT_TRUE(eventually([this] { return holds.size() >= 2; }));
    const auto number = [this](qsizetype at) { return holds.at(at).at(0).value<bus::HoldToMove>().press; };
    EXPECT_EQ(number(1), number(0));
    window->endHold();
    expectEnded();
    QTest::mouseRelease(forward, Qt::LeftButton);
    const qsizetype before = holds.size();
    QTest::mousePress(button(u"holdReverseButton"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), before + 1);
    EXPECT_GT(number(before), number(0)) << "whichever button it is";
    QTest::mouseRelease(button(u"holdReverseButton"_s), Qt::LeftButton);
}

TEST_F(Hold, ReverseIsReverse) {
    QTest::mousePress(button(u"holdReverseButton"_s), Qt::LeftButton);
    ASSERT_EQ(holds.size(), 1);
    EXPECT_TRUE(holds.at(0).at(0).value<bus::HoldToMove>().reverse);
    QTest::mouseRelease(button(u"holdReverseButton"_s), Qt::LeftButton);
}

TEST_F(Hold, SpaceHoldsAndAutoRepeatIsIgnored) {
    forward->setFocus();
    QTest::keyPress(forward, Qt::Key_Space);
    EXPECT_EQ(holds.size(), 1);
    QKeyEvent repeatRelease(QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier, u" "_s, true);
    QKeyEvent repeatPress(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, u" "_s, true);
    QApplication::sendEvent(forward, &repeatRelease);
    QApplication::sendEvent(forward, &repeatPress);
    EXPECT_EQ(releases.size(), 0);
    EXPECT_EQ(holds.size(), 1);
    QTest::keyRelease(forward, Qt::Key_Space);
    expectEnded();
}

struct HoldEnding {
    const char* name;
    std::function<void(MainWindow&, HoldButton&)> happen;
};
void PrintTo(const HoldEnding& ending, std::ostream* out) {
    *out << ending.name;
}

class HoldEnds : public Hold, public testing::WithParamInterface<HoldEnding> {};

TEST_P(HoldEnds, AtOnceAndForGood) {
    press();
    GetParam().happen(*window, *forward);
    expectEnded();
}

void sendTo(QWidget& widget, QEvent::Type type) {
    QEvent event(type);
    QApplication::sendEvent(&widget, &event);
}

const std::array kHoldEndings{
    HoldEnding{"Release", [](MainWindow&, HoldButton& b) { QTest::mouseRelease(&b, Qt::LeftButton); }},
    HoldEnding{"PointerLeaves",
               [](MainWindow&, HoldButton& b) {
                   const QPointF out(-50, -50);
                   QMouseEvent move(QEvent::MouseMove, out, b.mapToGlobal(out), Qt::NoButton, Qt::LeftButton,
                                    Qt::NoModifier);
                   QApplication::sendEvent(&b, &move);
                   const QPointF in(5, 5);
                   QMouseEvent back(QEvent::MouseMove, in, b.mapToGlobal(in), Qt::NoButton, Qt::LeftButton,
                                    Qt::NoModifier);
                   QApplication::sendEvent(&b, &back);
               }},
    HoldEnding{
        "FocusOut",
        [](MainWindow& w, HoldButton&) { w.findChild<QWidget*>(QStringLiteral("goalField"))->setFocus(); }},
    HoldEnding{"WindowDeactivated", [](MainWindow&, HoldButton& b) { sendTo(b, QEvent::WindowDeactivate); }},
    HoldEnding{"WindowHidden", [](MainWindow& w, HoldButton&) { w.hide(); }},
    HoldEnding{"Disabled", [](MainWindow&, HoldButton& b) { b.setEnabled(false); }},
    HoldEnding{"Dialog",
               [](MainWindow& w, HoldButton&) {
                   QDialog dialog(&w);
                   dialog.setModal(true);
                   dialog.show();
               }},
    HoldEnding{"AnotherMouseButton",
               [](MainWindow&, HoldButton& b) { QTest::mousePress(&b, Qt::RightButton); }},
    HoldEnding{"AModifier", [](MainWindow&, HoldButton& b) { QTest::keyPress(&b, Qt::Key_Shift); }},
    HoldEnding{"PortError", [](MainWindow& w, HoldButton&) { w.showLink({}); }},
    HoldEnding{"ServoOff",
               [](MainWindow& w, HoldButton&) { w.showLink(connectedTo({Servo{.on = false}.state()})); }},
    HoldEnding{"Silence",
               [](MainWindow& w, HoldButton&) {
                   ModuleState module = Servo{}.state();
                   module.silent = true;
                   w.showLink(connectedTo({module}));
               }},
    HoldEnding{"StopAll",
               [](MainWindow& w, HoldButton&) {
                   QTest::mousePress(w.findChild<QWidget*>(QStringLiteral("stopAllButton")), Qt::LeftButton);
               }},
    HoldEnding{"Esc", [](MainWindow&, HoldButton& b) { QTest::keyClick(&b, Qt::Key_Escape); }},
    HoldEnding{"AnotherSpeed",
               [](MainWindow& w, HoldButton&) {
                   auto* field = w.findChild<NumberField*>(QStringLiteral("holdVelocityField"));
                   field->selectAll();
                   QTest::keyClicks(field, QStringLiteral("2"));
               }},
};
INSTANTIATE_TEST_SUITE_P(When, HoldEnds, testing::ValuesIn(kHoldEndings),
                         [](const testing::TestParamInfo<HoldEnding>& ending) {
                             return std::string(ending.param.name);
                         });

TEST_F(Hold, AnotherModuleEndsIt) {
    showServos({{}, {}});
    press();
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    expectEnded();
}

TEST_F(Hold, ItsOwnStatusesDoNotEndIt) {
    press();
    showServo({.moveDone = false, .position = 3, .millisecond = 30});
    EXPECT_TRUE(forward->isHeld());
    QTest::mouseRelease(forward, Qt::LeftButton);
}

}  // namespace
}  // namespace nmc

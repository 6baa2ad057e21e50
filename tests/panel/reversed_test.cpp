// SPDX-License-Identifier: GPL-3.0-or-later
// An axis whose forward direction is the chip's reverse: what the user reads and enters has the direction of
// the axis, while the simulator reports what the motor does in the counts of the chip.
#include "tests/support/hand.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class Reversed : public testing::Test {
protected:
    /// The axis has 400 counts per millimetre, and its forward direction counts down.
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        panel.window().resize(1'280, 800);
    }
    void TearDown() override { texts::setModuleNames({}); }
    void turnRound() {
        ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
        ASSERT_NO_FATAL_FAILURE(hand.choose(u"native counts"_s, u"millimetres"_s));
        ASSERT_NO_FATAL_FAILURE(hand.type(u"counts in 1 mm"_s, u"400"_s));
        ASSERT_NO_FATAL_FAILURE(hand.click(u"reversed"_s));
        ASSERT_EQ(panel.composition().machine().axes.at(0).unit.countsPerUnit, -400);
    }
    void makeReady() {
        ASSERT_NO_FATAL_FAILURE(panel.makeReady());
        ASSERT_NO_FATAL_FAILURE(turnRound());
    }
    [[nodiscard]] double counts(int module = 1) { return sim.state(module)[u"position"_s].toDouble(); }
    [[nodiscard]] bool rests() { return !moves(sim); }
    [[nodiscard]] double shown() {
        const auto* label = panel.window().findChild<QLabel*>(u"positionLabel"_s);
        QString text = label->text();
        return QLocale::c().toDouble(text.replace(u'\u2212', u'-'));
    }
    void goTo(const QString& millimetres) {
        ASSERT_NO_FATAL_FAILURE(hand.type(u"Goal position"_s, millimetres));
        ASSERT_NO_FATAL_FAILURE(hand.click(u"Go to the position"_s));
    }
    VirtualChain sim{u"servo,step"_s};
    VirtualPanel panel;
    Hand hand{panel};
};

TEST_F(Reversed, APositionIsThatOfTheUser) {
    ASSERT_NO_FATAL_FAILURE(makeReady());
    ASSERT_NO_FATAL_FAILURE(goTo(u"5"_s));
    ASSERT_TRUE(panel.waitFor([&] { return rests() && std::abs(counts() + 2'000) <= 20; })) << counts();
    EXPECT_TRUE(panel.waitFor([&] { return std::abs(shown() - 5) < 0.05; })) << shown();
    ASSERT_NO_FATAL_FAILURE(hand.choose(u"position"_s, u"distance"_s));
    ASSERT_NO_FATAL_FAILURE(goTo(u"-2"_s));
    EXPECT_TRUE(panel.waitFor([&] { return rests() && std::abs(counts() + 1'200) <= 40; })) << counts();
}

TEST_F(Reversed, ForwardIsForwardOnEveryButton) {
    ASSERT_NO_FATAL_FAILURE(makeReady());
    double from = counts();
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Run forward"_s));
    EXPECT_TRUE(panel.waitFor([&] { return counts() < from - 50; }));
    EXPECT_TRUE(panel.waitFor([&] {
        const QString velocity = panel.window().findChild<QLabel*>(u"velocityLabel"_s)->text();
        return velocity.endsWith(u"mm/s"_s) && velocity.front().isDigit() && velocity.front() != u'0';
    }));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Stop this module"_s));
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    from = counts();
    ASSERT_NO_FATAL_FAILURE(hand.hold(u"Hold to move forward"_s, [&] { return counts() < from - 50; }));
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    from = counts();
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Step in reverse"_s));
    EXPECT_TRUE(panel.waitFor([&] { return rests() && std::abs(counts() - from - 100) <= 10; })) << counts();
    // All axes, and the pendant.
    hand.strike(Qt::Key_F4);
    from = counts();
    ASSERT_NO_FATAL_FAILURE(
        hand.hold(u"Hold to move Module 1 in reverse"_s, [&] { return counts() > from + 50; }));
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    from = counts();
    hand.strike(Qt::Key_F12);
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Shift);
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_TRUE(panel.waitFor([&] { return counts() < from - 50; }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Shift);
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Right);
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    EXPECT_EQ(sim.violations(), "");
}

/// Two millimetres forward are 800 counts down: the lowest position of the chip is the user's highest.
TEST_F(Reversed, TheHighestPositionIsWhereTheUserGoesForwardTo) {
    ASSERT_NO_FATAL_FAILURE(makeReady());
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Zero here"_s));
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Details"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Save as home"_s));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Highest position"_s, u"2"_s));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Lowest position"_s, u"-10"_s));
    const auto travel = [&] { return panel.composition().machine().axes.at(0).travel; };
    EXPECT_EQ(travel().lowest, -800);
    EXPECT_EQ(travel().highest, 4'000);
    ASSERT_TRUE(hand.reads(u"In force: from −10 mm to 2 mm"_s) ||
                hand.reads(u"In force: from -10 mm to 2 mm"_s));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Goal position"_s, u"3"_s));
    EXPECT_TRUE(hand.reads(u"the highest position is 2 mm"_s));
    EXPECT_FALSE(hand.find<QAbstractButton>(u"Go to the position"_s)->isEnabled());
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Run forward"_s));
    EXPECT_TRUE(panel.waitFor([&] { return rests() && std::abs(counts() + 800) <= 20; })) << counts();
    EXPECT_TRUE(hand.reads(u"At the highest position"_s));
    // Only the display is reversed: the motor's travel limits stay where they are.
    ASSERT_NO_FATAL_FAILURE(hand.click(u"reversed"_s));
    EXPECT_EQ(travel().lowest, -800);
    EXPECT_TRUE(hand.reads(u"At the lowest position"_s));
    EXPECT_EQ(hand.find<QLineEdit>(u"Lowest position"_s)->text(), u"-2"_s);
    EXPECT_TRUE(rests());
}

TEST_F(Reversed, ASearchForHomeGoesWhereItSays) {
    std::ignore = sim.control(u"set 1 travel_min -1000"_s);
    std::ignore = sim.control(u"set 1 limits auto"_s);
    ASSERT_NO_FATAL_FAILURE(makeReady());
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Homing"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Reverse: search direction"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Forward: search direction"_s));
    EXPECT_TRUE(panel.composition().machine().axes.at(0).homing->reverse)
        << "for the chip, it goes in reverse";
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Home: search"_s));
    ASSERT_TRUE(hand.reads(u"Done"_s));
    EXPECT_LT(sim.state(1)[u"shaft"_s].toDouble(), -900);
}

TEST_F(Reversed, AStepperGoesForwardToo) {
    panel.select(1);
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Parameters"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Starting values"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Apply parameters"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Enable amplifier"_s));
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand.choose(u"native counts"_s, u"turns"_s));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"steps in 1 turn"_s, u"200"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"reversed"_s));
    double from = counts(2);
    ASSERT_NO_FATAL_FAILURE(hand.hold(u"Hold to move forward"_s, [&] { return counts(2) < from - 20; }));
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    from = counts(2);
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Run"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Run reverse"_s));
    EXPECT_TRUE(panel.waitFor([&] { return counts(2) > from + 20; }));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Stop this module"_s));
    ASSERT_TRUE(panel.waitFor([&] { return rests(); }));
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

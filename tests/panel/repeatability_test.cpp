// SPDX-License-Identifier: GPL-3.0-or-later
// Repeatability and backlash in the whole program: the load of the simulated motor has 37 counts of play, and
// the panel finds them and takes them over.
#include <cmath>

#include "tests/support/changes.h"
#include "tests/support/hand.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::changes;
using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class RepeatabilitySession : public testing::Test {
protected:
    void SetUp() override {
        panel.window().resize(1'500, 1'000);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        for (const QString& line : {u"set 1 load_play 37"_s, u"set 1 home_switch_at 200"_s})
            ASSERT_FALSE(sim.control(line).contains(u"error"_s)) << line.toStdString();
        ASSERT_NO_FATAL_FAILURE(panel.makeReady());
        ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Homing"_s));
        ASSERT_NO_FATAL_FAILURE(hand.click(u"Forward: search direction"_s));
        ASSERT_NO_FATAL_FAILURE(hand.type(u"Times from each side"_s, u"3"_s));
    }
    [[nodiscard]] QString result() {
        return panel.window().findChild<QLabel*>(u"repeatabilityResult"_s)->text();
    }
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
    Hand hand{panel};
};

TEST_F(RepeatabilitySession, FindsTheBacklashAndMakesItThatOfTheAxis) {
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Measure repeatability and backlash"_s));
    ASSERT_TRUE(panel.waitFor([&] { return result().startsWith(u"✓"_s); })) << result().toStdString();
    EXPECT_EQ(panel.module().backlash.distance, 0.0) << "only if the user wants it";
    EXPECT_TRUE(result().contains(u"Forward, 3 times"_s)) << result().toStdString();
    const auto backlash =
        QRegularExpression(u"Backlash: ([0-9.]+) counts ± ([0-9.]+) counts"_s).match(result());
    ASSERT_TRUE(backlash.hasMatch()) << result().toStdString();
    EXPECT_NEAR(backlash.captured(1).toDouble(), 37, 1);
    EXPECT_FALSE(moves(sim));
    EXPECT_FALSE(panel.module().home.place()) << "a measurement is not a search for home";
    EXPECT_EQ(panel.count(u"imit"_s), 0) << panel.headlines().join(u'\n').toStdString();

    const QJsonArray before = changes(sim);
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Use as backlash"_s));
    const double used = panel.composition().machine().axis(ModuleIndex(0)).backlash.distance;
    EXPECT_EQ(used, std::ceil(backlash.captured(1).toDouble() + backlash.captured(2).toDouble()));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before) << "it sends nothing";
    EXPECT_EQ(panel.module().backlash.distance, used);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(RepeatabilitySession, AStopInTheMiddleLeavesWhatWasCaptured) {
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Times from each side"_s, u"20"_s));
    ASSERT_NO_FATAL_FAILURE(hand.click(u"Measure repeatability and backlash"_s));
    ASSERT_TRUE(panel.waitFor([&] { return result().contains(u"4 of 20"_s); })) << result().toStdString();
    hand.strike(Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return result().startsWith(u"○ Cancelled"_s); }))
        << result().toStdString();
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_FALSE(panel.module().latest->servoStatus().homeInProgress());
    EXPECT_TRUE(result().contains(u"Reverse, 3 times"_s)) << result().toStdString();
    EXPECT_TRUE(sim.state(1)[u"servo_on"_s].toBool());
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

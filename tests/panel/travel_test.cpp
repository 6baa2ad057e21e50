// SPDX-License-Identifier: GPL-3.0-or-later
// Travel limits that are set while the motor runs, through the window.
#include "tests/support/hand.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// The motor runs at 8 counts/tick, which is 15 625 counts/s, and slows down by 1311/65536 counts/tick^2,
/// which is 76 300 counts/s^2: this takes 1600 counts, and another 1563 for the 0.1 s that a stop may take.
TEST(TravelLimits, AFrozenPanelDelaysNoStop) {
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
    const auto position = [&] { return sim.state(1)[u"position"_s].toInt(); };
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    panel.ask(intent::SaveAsHome{});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
    Hand hand(panel);
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    const int limit = position() + 80'000;
    const int fromHome = limit - panel.module().home.place()->counts;
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Highest position"_s, QString::number(fromHome)));
    ASSERT_EQ(panel.composition().machine().axes.at(0).travel.highest, fromHome);
    ASSERT_TRUE(panel.waitFor([&] { return position() > limit - 15'000; }));
    ASSERT_LT(position(), limit - 10'000) << "it would be too late to show anything";
    panel.freeze(std::chrono::milliseconds(1'800));
    EXPECT_FALSE(moves(sim));
    EXPECT_LE(position(), limit);
    EXPECT_GT(position(), limit - 3'000);
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"just before its travel limit"_s) == 1; }))
        << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_TRUE(panel.module().servoOn());
}

/// The run is sent as a move to 20 000. At 1 count/tick, which is 1953 counts/s, it slows down within 25
/// counts.
TEST(TravelLimits, ALimitThatIsSetNearerEndsARunTowardsTheOneBefore) {
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
    const auto position = [&] { return sim.state(1)[u"position"_s].toInt(); };
    ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    ASSERT_NO_FATAL_FAILURE(panel.enable());
    panel.ask(intent::SaveAsHome{});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
    Hand hand(panel);
    ASSERT_NO_FATAL_FAILURE(hand.turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Highest position"_s, u"20000"_s));
    ASSERT_EQ(panel.composition().machine().axes.at(0).travel.highest, 20'000);
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(1'311), false}});
    ASSERT_TRUE(panel.waitFor([&] { return position() > 1'000; }));
    ASSERT_NO_FATAL_FAILURE(hand.type(u"Highest position"_s, u"5000"_s));
    ASSERT_EQ(panel.composition().machine().axes.at(0).travel.highest, 5'000);
    ASSERT_LT(position(), 4'000) << "it would be too late to show anything";
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_LT(position(), 5'000);
    EXPECT_TRUE(panel.module().servoOn());
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(u"Module 1 did not finish its moves."_s), 1);
    EXPECT_NE(panel.standing(u"did not finish its moves"_s), nullptr) << "its own stop does not end it";
    EXPECT_EQ(sim.violations(), "");
}

/// The user had it move again before that stop was confirmed, and has let go of it since.
TEST(TravelLimits, AReleaseThatFollowsConfirmsNoStopAtALimit) {
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    auto& store = const_cast<BusStore&>(panel.composition().store());
    emit store.happened(bus::StoppedBeforeLimit{ModuleIndex(0)});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"just before its travel limit"_s) == 1; }));
    emit store.happened(bus::OwedStopConfirmed{ModuleIndex(0), bus::StopCause::HoldReleased});
    ASSERT_TRUE(panel.answersFor(0.1));
    EXPECT_EQ(panel.count(u"It has stopped."_s), 0);
    emit store.happened(bus::OwedStopConfirmed{ModuleIndex(0), bus::StopCause::TravelLimit});
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"It has stopped."_s) == 1; }));
}

}  // namespace
}  // namespace nmc

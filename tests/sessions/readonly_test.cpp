// SPDX-License-Identifier: GPL-3.0-or-later
// H-02: what somebody else has set in motion runs on, whatever happens while it is only looked at. The oath
// (lookoath.h) is held throughout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sessions/operator.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::IsEmpty;

/// Two servos and a stepper, switched on by the program before.
class ReadOnlySession : public testing::Test {
protected:
    ReadOnlySession() : rig(world()) {}

    static World world() {
        World world;
        world.chain = {{ModuleType::Servo, 4}, {ModuleType::Servo, 1}, {ModuleType::Stepper, 1}};
        world.baud = 57'600;
        return world;
    }
    /// Another program moves the first motor for some 5 s, and is gone; who comes now only looks.
    void lookAtAMove() {
        ASSERT_TRUE(setRunning(rig, 0));
        rig.submit({loadMove(0, kGoal), start(0)});
        const auto moves = [&] {
            return rig.bus.count<OperationFinished>() == rig.size() + 1 && !rig.atRest(0);
        };
        ASSERT_TRUE(rig.runUntil(moves, 1s));
        look();
    }
    void look() {
        rig.replaceEngine(rig.world.baud, true);
        ASSERT_TRUE(connectAndWait(rig));
    }
    /// It came to its end by itself, and no sooner than it should.
    void expectTheMoveToEnd() {
        EXPECT_FALSE(rig.atRest(0)) << "it is still on its way";
        // The integral unwinds the overshoot against friction: that takes seconds.
        rig.run(30s);
        EXPECT_NEAR(rig.shaft(0), kGoal, 5);
        EXPECT_THAT(rig.bus.all<StopFinished>(), IsEmpty());
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
    static constexpr std::int32_t kGoal = 20'000;  // counts, at 2 per tick of 0.512 ms

    Rig rig;
};

TEST_F(ReadOnlySession, SeesAMoveToItsEnd) {
    ASSERT_NO_FATAL_FAILURE(lookAtAMove());
    expectTheMoveToEnd();
}

TEST_F(ReadOnlySession, SeesAMoveToItsEndOverALinkThatIsLost) {
    ASSERT_NO_FATAL_FAILURE(lookAtAMove());
    rig.fault("mute rx", kForLong, false);
    ASSERT_TRUE(rig.runUntil([&] { return rig.lost; }, 10s));
    rig.run(500ms);
    rig.clearFaults();
    expectTheMoveToEnd();
}

TEST_F(ReadOnlySession, SeesAMoveToItsEndOverABadLineAndAModuleThatRestarts) {
    ASSERT_NO_FATAL_FAILURE(lookAtAMove());
    rig.fault("flip status p=.2", 1s, false);
    rig.powerCycle(1);
    rig.run(1s);
    expectTheMoveToEnd();
}

/// Elsewhere a position that stays while the motor is said to move is a reason to stop it (faults.md F-12).
TEST_F(ReadOnlySession, SuspectsNoMotionAndStopsNone) {
    ASSERT_TRUE(setRunning(rig, 3));
    look();
    rig.run(500ms);
    rig.fault("stuck", kForLong, false, std::uint8_t{0});
    rig.run(5s);
    rig.clearFaults();
    EXPECT_FALSE(rig.atRest(0));
    rig.expectEnds();
    EXPECT_THAT(rig.complaints, IsEmpty());
}

TEST_F(ReadOnlySession, StopsAllThatMovesWhenItIsAskedTo) {
    ASSERT_TRUE(setRunning(rig, 3));
    look();
    rig.run(300ms);
    rig.stopAll();
    ASSERT_TRUE(rig.runUntil([&] { return !rig.stopping(); }, StopOath::kStopBound));
    EXPECT_EQ(rig.bus.last<StopFinished>()->stopped.size(), 3U);
    for (std::uint8_t place = 0; place < 3; ++place)
        EXPECT_TRUE(rig.atRest(place));
    rig.runToRest();
    rig.expectEnds();
    EXPECT_THAT(rig.complaints, IsEmpty());
}

}  // namespace

}  // namespace nmc::test

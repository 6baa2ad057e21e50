// SPDX-License-Identifier: GPL-3.0-or-later
// A home search that is cancelled, or ended by a stop, in each of its stages.
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Stop = HomingRecipe::Stop;
using Input = sim::Input;

/// After a cancel or a stop in any stage, nothing moves, the chip searches for nothing, and zero has not been
/// set.
class EndedIn : public testing::TestWithParam<ProcedureStage> {
protected:
    [[nodiscard]] bool reach() {
        bench.putSwitch(Input::Limit1, 300, true);
        if (!bench.enable())
            return false;
        HomingRecipe recipe = slowRecipe();
        recipe.onLimit1 = recipe.thenIndex = true;
        recipe.stop = Stop::Smoothly;
        bench.begin(intent::Home{recipe});
        return bench.runTo(GetParam());
    }
    void expectEnded() {
        bench.bus.runFor(3s);
        bench.take();
        EXPECT_EQ(bench.truth().commandVelocity, 0);
        EXPECT_NEAR(bench.truth().velocity, 0, 0.05);
        EXPECT_TRUE(bench.truth().servoOn) << "it still holds";
        EXPECT_EQ(bench.bus.sends("AA 01 00"), 0U) << "zero is not set";
        bench.bus.expectNoViolations();
    }
    ServoBench bench;
};

TEST_P(EndedIn, ByCancel) {
    ASSERT_TRUE(reach());
    bench.procedure->cancel();
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    EXPECT_FALSE(report.failure);
    EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
    expectEnded();
}

TEST_P(EndedIn, ByStopAll) {
    ASSERT_TRUE(reach());
    const std::size_t before = bench.bus.sent.size();
    bench.procedure->cancel();
    const auto stopped = bench.bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->stopped.size(), 1U);
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 05", before), 0U) << "nothing is started any more";
    expectEnded();
}

INSTANTIATE_TEST_SUITE_P(Stages, EndedIn,
                         testing::Values(ProcedureStage::Preparing, ProcedureStage::BackingOff,
                                         ProcedureStage::Searching, ProcedureStage::SearchingIndex,
                                         ProcedureStage::Stopping, ProcedureStage::Reading,
                                         ProcedureStage::GoingHome));

TEST(Homing, AStopByWhoeverCancelsItsCommandsIsLeftAsItIs) {
    ServoBench bench;
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    bench.begin(intent::Home{recipe});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.procedure->onFinished(bus::Outcome::Cancelled);
    const std::size_t before = bench.bus.sent.size();
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 17", before), 0U)
        << "a stop might switch on a servo that was switched off";
    EXPECT_EQ(bench.bus.sends("AA 01 19 00", before), 1U);
}

/// A quarantine takes 100 ms (link.md 2.1), in which the motor would go on searching.
TEST(Homing, TheStopThatEndsASearchDoesNotWaitForAQuarantine) {
    ServoBench bench(servoVersion(), 2);
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    bench.begin(intent::Home{recipe});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.settle();
    const auto timeouts = bench.bus.engine.statistics().timeouts;
    bench.bus.losesReply = [](ByteSpan command) { return command.size() > 1 && command[1] == 2; };
    ASSERT_TRUE(bench.bus.runUntil([&] { return bench.bus.engine.statistics().timeouts > timeouts; }, 1s));
    bench.bus.losesReply = {};
    const std::size_t before = bench.bus.sent.size();
    const TimePoint asked = bench.bus.now;
    const Duration slice = std::exchange(bench.sliceTime, Duration{});
    bench.procedure->cancel();
    ASSERT_TRUE(bench.turn());
    ASSERT_TRUE(bench.bus.runUntil([&] { return bench.bus.sends("AA 01 17", before) > 0; }, 1s));
    EXPECT_LT(bench.bus.now - asked, 15ms);
    bench.sliceTime = slice;
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 17", before), 1U);
    EXPECT_EQ(bench.bus.sends("AA 01 19 00", before), 1U) << "and then it searches no longer";
    EXPECT_FALSE(bench.searches());
    EXPECT_EQ(bench.truth().commandVelocity, 0);
    bench.bus.expectNoViolations();
}

}  // namespace
}  // namespace nmc::test

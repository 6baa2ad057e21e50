// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that are followed to their end. Engine and simulator in virtual time, checked against the simulator's
// command position at every tick.
#include "tests/procedures/pathbench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using servo::PathRate;

struct Rate {
    PathRate rate;
    std::optional<bool> fastPath;
    std::uint8_t version = kScVersion;
};

class PathAtEachRate : public testing::TestWithParam<Rate> {};

TEST_P(PathAtEachRate, IsOnEachPointAtTheEndOfItsSegment) {
    const auto [rate, fastPath, version] = GetParam();
    PathBench bench(servos(1, version));
    ASSERT_TRUE(bench.hold(fastPath));
    const PathTable table = bench.swings(rate, 1'000);
    const ProcedureReport report = bench.runPath(table);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.wasOnEachPoint(table, 0));
    EXPECT_EQ(bench.truth().commandPosition, table.columns[0].points.back());
    ASSERT_TRUE(report.path);
    EXPECT_EQ(report.path->done, 1'000U);
    EXPECT_EQ(report.path->end, bus::PathEnd::Done);
    EXPECT_FALSE(report.path->runsDry);
    EXPECT_GT(report.path->least, 70U) << "the buffer of 96 or 128 points was kept filled";
    EXPECT_EQ(bench.module().goal(), table.columns[0].points.back());
    EXPECT_FALSE(bench.module().moving());
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, PathAtEachRate,
                         testing::Values(Rate{PathRate::Hz30, {}}, Rate{PathRate::Hz60, {}},
                                         Rate{PathRate::Hz60, true}, Rate{PathRate::Hz120, true},
                                         Rate{PathRate::Hz30, {}, kPathVersion},
                                         Rate{PathRate::Hz60, {}, kPathVersion},
                                         Rate{PathRate::Hz120, true, kPathVersion}));

TEST(Path, OfAFewPointsIsFollowed) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    for (const std::size_t points : {1U, 2U, 8U, 126U, 127U, 129U, 136U}) {
        bench.ticks.assign(1, {});
        PathTable table = bench.swings(PathRate::Hz60, points);
        table.columns[0].points.back() = 100;
        EXPECT_EQ(bench.runPath(table).stage, ProcedureStage::Done) << points;
        EXPECT_TRUE(bench.wasOnEachPoint(table, 0)) << points;
    }
    bench.bus.expectNoViolations();
}

TEST(Path, ShowsWhatTheModuleDoes) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    bench.follow(bench.swings(PathRate::Hz60, 600));
    ASSERT_TRUE(bench.runToPoint(200));
    EXPECT_EQ(bench.module().activity(), Activity::OnPath);
    EXPECT_TRUE(bench.module().moving());
    EXPECT_EQ(plan(intent::ResetPosition{}, bench.module()).error(), Refusal::Moving);
    // 600 points at 61.035 Hz take 9.83 s.
    EXPECT_NEAR(toSeconds(bench.procedure->report().path->remaining()), 9.83 * 2 / 3, 0.1);
    const auto gains = bench.bus.submit({{ModuleIndex(0), ServoCommand(*bench.module().gains)}});
    servo::LoadTrajectory run;
    run.velocity = CountsPerTick(65'536);
    run.acceleration = CountsPerTickSquared(655);
    run.profile = servo::ProfileMode::Velocity;
    run.startNow = true;
    const auto other = bench.bus.submit({{ModuleIndex(0), ServoCommand(run)}});
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Done);
    EXPECT_EQ(bench.bus.outcomeOf(gains), bus::Outcome::Done);
    EXPECT_EQ(bench.bus.outcomeOf(other), bus::Outcome::Forbidden) << "the module is on its path";
    EXPECT_EQ(bench.module().activity(), Activity::Holding);
}

class PathOfAGroup : public testing::TestWithParam<std::optional<std::uint8_t>> {};

TEST_P(PathOfAGroup, StartsInTheSameTick) {
    PathBench bench(scs(3));
    ASSERT_TRUE(bench.hold());
    ASSERT_TRUE(bench.group(GetParam()));
    const PathTable table = bench.swings(PathRate::Hz60, 300);
    EXPECT_EQ(bench.runPath(table).stage, ProcedureStage::Done);
    for (std::uint8_t i = 0; i < 3; ++i)
        EXPECT_TRUE(bench.wasOnEachPoint(table, i)) << int{i};
    EXPECT_EQ(bench.ticks[0].size(), bench.ticks[1].size());
    EXPECT_EQ(bench.ticks[0].size(), bench.ticks[2].size());
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(WithAndWithoutLeader, PathOfAGroup,
                         testing::Values(std::nullopt, std::optional<std::uint8_t>(1)));

/// Three axes at 60 Hz for ten minutes at 115 200 Bd, while the panel polls.
TEST(Path, OfThreeAxesRunsForTenMinutesWithoutAnUnderRun) {
    PathBench bench(scs(3));
    ASSERT_TRUE(bench.hold());
    ASSERT_TRUE(bench.group());
    const PathTable table = bench.swings(PathRate::Hz60, 36'621);  // 600 s at 61.035 Hz
    const std::size_t before = bench.bus.events.size();
    const ProcedureReport report = bench.runPath(table, 700.0);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.path);
    EXPECT_GT(report.path->least, 100U);
    std::size_t polls[3] = {};
    bool dry = false;
    for (std::size_t i = before; i < bench.bus.events.size(); ++i) {
        if (const auto* sample = std::get_if<bus::Sample>(&bench.bus.events[i]))
            ++polls[sample->module.value()];
        if (const auto* path = std::get_if<bus::PathProgress>(&bench.bus.events[i]))
            dry = dry || path->runsDry;
    }
    EXPECT_FALSE(dry);
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(bench.wasOnEachPoint(table, i)) << int{i};
        EXPECT_GT(polls[i], 600U * 5U) << "at least five times a second";
    }
    bench.bus.expectNoViolations();
}

TEST(Path, IsRefusedWhereItCannotBeFollowed) {
    using Obstacle = PathObstacle::Kind;
    PathBench bench(scs(2));
    ASSERT_TRUE(bench.hold());
    const auto kindOf = [&](const PathTable& table, const PathLine& line = {115'200, Duration{}}) {
        const auto wanted = planPath(table, bench.modules, line);
        return wanted ? std::nullopt : std::optional(wanted.error().kind);
    };
    const PathTable both = bench.swings(PathRate::Hz60, 300);
    PathTable one = both;
    one.columns.pop_back();
    EXPECT_EQ(kindOf(one), std::nullopt);
    EXPECT_EQ(kindOf(both), Obstacle::NotAGroup);
    PathTable changed = one;
    changed.rate = PathRate::Hz120;
    EXPECT_EQ(kindOf(changed), Obstacle::WrongFastPath);
    changed = one;
    changed.columns[0].points[0] = 100 + 8'192;  // one count more than 13 bits hold
    EXPECT_EQ(kindOf(changed), Obstacle::TooFarToStart);
    EXPECT_EQ(planPath(changed, bench.modules, {}).error().value, 8'192);
    EXPECT_EQ(planPath(changed, bench.modules, {}).error().allowed, 8'191);
    changed = one;
    changed.columns[0].points[10] += 9'000;
    EXPECT_EQ(kindOf(changed), Obstacle::Jump);
    EXPECT_EQ(planPath(changed, bench.modules, {}).error().point, 11U);
    EXPECT_EQ(kindOf({}), Obstacle::NoPoints);
    // Nearly nine frames a second with their replies are more than 1200 Bd would carry, were there such a
    // rate.
    EXPECT_EQ(kindOf(one, {1'200, Duration{}}), Obstacle::BusTooSlow);
    ModuleState& module = bench.module();
    const ModuleState good = module;
    module.attached();
    EXPECT_EQ(kindOf(one), Obstacle::ControlUnknown) << "it may be in step and direction mode";
    module = good;
    module.pathControl->stepAndDirection = true;
    EXPECT_EQ(kindOf(one), Obstacle::StepAndDirection);
    module = good;
    module.servoRate = 2;
    EXPECT_EQ(kindOf(one), Obstacle::ServoRate);
    module = good;
    module.travel.fastest = 0.5;  // counts per tick: 16 in a segment of 32 ticks
    EXPECT_EQ(kindOf(one), Obstacle::TooFast);
    module = good;
    module.info.identity.version = 4;
    EXPECT_EQ(kindOf(one), Obstacle::NoPathBuffer);
    module = good;
    module.rights = OperatorRights{};
    module.rights->moves = false;
    EXPECT_EQ(planPath(one, bench.modules, {}).error().refusal, Refusal::OperatorMode);
    module = good;
}

TEST(Path, IsNotWhatSingleCommandsMake) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    const std::array<servo::PathPoint, 1> point{servo::PathPoint{100, PathRate::Hz60}};
    const auto add = servo::AddPathPoints::of(point, false);
    EXPECT_EQ(bench.bus.perform({{ModuleIndex(0), ServoCommand(*add)}}), bus::Outcome::Forbidden);
    EXPECT_EQ(bench.bus.perform({{ModuleIndex(0), ServoCommand(servo::AddPathPoints())}}),
              bus::Outcome::Forbidden);
    EXPECT_EQ(bench.frames(), 0U);
}

/// The engine checks the start itself: the panel's state may be out of date by then.
TEST(Path, ThatBeginsSomewhereElseIsNotSent) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    auto wanted = bench.planned(bench.swings(PathRate::Hz60, 300));
    ASSERT_TRUE(wanted);
    ASSERT_TRUE(bench.ask(0, intent::Move{servomotion::Trapezoid{Counts(150), CountsPerTick(4 << 16),
                                                                 CountsPerTickSquared(6'554)}}));
    EXPECT_EQ(plan(*wanted, bench.module()).error(), Refusal::PathNotPossible);
    const auto id =
        bench.bus.submit({{ModuleIndex(0), ServoCommand(servo::AddPathPoints())}}, {}, wanted->plan);
    bench.settle();
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Forbidden);
    EXPECT_EQ(bench.bus.last<bus::PathProgress>()->end, bus::PathEnd::NotReady);
    EXPECT_EQ(bench.frames(), 0U);
}

/// The panel does not know what another host has sent to the module.
TEST(Path, IsNotAskedOfAChainThatWasLeftAsItWas) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    const auto wanted = bench.planned(bench.swings(PathRate::Hz60, 300));
    ASSERT_TRUE(wanted);
    bench.bus.newHost({115'200});
    ASSERT_TRUE(bench.bus.connect());
    ASSERT_TRUE(bench.bus.last<bus::ChainFound>()->attached);
    const auto id =
        bench.bus.submit({{ModuleIndex(0), ServoCommand(servo::AddPathPoints())}}, {}, wanted->plan);
    bench.bus.runFor(500ms);
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Forbidden);
    EXPECT_EQ(bench.frames(), 0U);
}

}  // namespace
}  // namespace nmc::test

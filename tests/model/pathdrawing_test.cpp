// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that are drawn from the moves of a sequence, and path files that are written. Expected values are
// calculated by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "model/path/pathdrawing.h"
#include "model/path/pathfile.h"
#include "model/path/pathplan.h"

namespace nmc::test {
namespace {

using DrawingFault = DrawingProblem::Kind;
using servo::PathRate;

/// A servo that holds a position.
[[nodiscard]] ModuleState holding(std::uint8_t index, std::int32_t position,
                                  std::uint8_t version = kScVersion) {
    ModuleState module;
    module.info.index = ModuleIndex(index);
    module.info.identity = {ModuleType::Servo, version};
    bus::Sample sample;
    sample.module = module.info.index;
    sample.time = TimePoint(std::chrono::milliseconds(1'000));
    sample.report.status = 0x09;  // move_done, power_on
    sample.report.position = position;
    sample.report.aux = std::uint8_t{0x04};  // servo_on
    sample.report.positionError = std::int16_t{0};
    module.apply(sample);
    return module;
}

class PathDrawing : public testing::Test {
protected:
    PathDrawing() {
        machine.axes.resize(3);
        // 0.5 counts per tick are 976.5625 counts/s, and 0.005 counts per tick squared are 19 073 counts/s^2.
        for (AxisSettings& axis : machine.axes) {
            axis.motion.velocity = 0.5;
            axis.motion.acceleration = 0.005;
        }
        machine.program.points = {{"There", {{ModuleIndex(0), 1'000, false}}},
                                  {"Back", {{ModuleIndex(0), 0, false}}},
                                  {"Both", {{ModuleIndex(0), 500, false}, {ModuleIndex(1), 70, false}}}};
    }
    /// In counts/s and counts/s^2.
    void setPace(ModuleIndex axis, double velocity, double acceleration) {
        constexpr double kTickSeconds = 0.000512;
        machine.axes[axis.value()].motion.velocity = velocity * kTickSeconds;
        machine.axes[axis.value()].motion.acceleration = acceleration * kTickSeconds * kTickSeconds;
    }
    auto draw(std::vector<Action> rows, PathRate rate = PathRate::Hz60) {
        machine.program.sequences.push_back({"Main", std::move(rows)});
        return drawPath("Main", machine, modules, rate);
    }
    [[nodiscard]] std::optional<DrawingProblem> problem(std::vector<Action> rows) {
        const auto table = draw(std::move(rows));
        return table ? std::nullopt : std::optional(table.error());
    }

    std::vector<ModuleState> modules{holding(0, 0), holding(1, 40)};
    Machine machine;
};

TEST_F(PathDrawing, GoesFromPlaceToPlaceInTheTimesOfTheMoves) {
    // 1000 counts: 1000 / 976.5625 + 976.5625 / 19073.486 = 1.0752 s, 65.6 periods of 16.384 ms.
    const auto table = draw({action::MoveTo{"There"}, action::MoveTo{"Back"}});
    ASSERT_TRUE(table);
    ASSERT_EQ(table->columns.size(), 1U) << "nothing moves the other axis";
    const auto& points = table->columns[0].points;
    ASSERT_EQ(points.size(), 66U + 66U);
    EXPECT_EQ(points[65], 1'000);
    EXPECT_EQ(points.back(), 0);
    // After 30 periods, 0.49152 s: 976.5625 * (t - 0.0256) = 455.0.
    EXPECT_EQ(points[29], 455);
}

TEST_F(PathDrawing, RestsWhereItWaitsAndIsSlowerByItsShare) {
    // At half of the velocity: 1000 / 488.28 + 488.28 / 19073.486 = 2.0736 s, 126.6 periods.
    const auto table = draw({action::MoveTo{.point = "There", .percent = 50}, action::Wait{1.0}});
    ASSERT_TRUE(table);
    const auto& points = table->columns[0].points;
    ASSERT_EQ(points.size(), 127U + 61U) << "a second is 61.04 periods";
    EXPECT_EQ(points[126], 1'000);
    EXPECT_EQ(points[186], 1'000);
}

/// At 1.01 counts per tick, a segment of 32 ticks has 32.32 counts. Its points are 32 or 33 counts apart, and
/// 33 are 1.03 counts per tick.
TEST_F(PathDrawing, AtTheLimitOfTheAxisIsNotTooFast) {
    machine.axes[0].motion.velocity = modules[0].travel.fastest = 1.01;
    const auto table = draw({action::MoveTo{"There"}});
    ASSERT_TRUE(table);
    std::int32_t before = 0;
    std::int32_t longest = 0;
    for (const std::int32_t point : table->columns[0].points)
        longest = std::max(longest, point - std::exchange(before, point));
    EXPECT_EQ(longest, 33);
    EXPECT_TRUE(planPath(*table, modules, {}));
    const std::vector<PathColumn> axes{pathColumn("X", modules[0], {})};
    EXPECT_EQ(readPath(pathText(*table, axes), axes), *table);

    modules[0].travel.fastest = 1.0;  // 32 counts
    const auto plan = planPath(*table, modules, {});
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().kind, PathObstacle::Kind::TooFast);
    EXPECT_EQ(plan.error().value, 33.0 / 32);
}

/// At 0.5 counts per tick, a segment of 32 ticks has 16 counts, and at 0.01 counts per tick squared, all of
/// them begin at half a count: the ramp ends after 50 ticks at 12.5.
TEST_F(PathDrawing, AtTheLimitOfTheAxisHalvesOfACountMakeNoSegmentLonger) {
    machine.axes[0].motion.velocity = modules[0].travel.fastest = 0.5;
    machine.axes[0].motion.acceleration = 0.01;
    const auto table = draw({action::MoveTo{"There"}});
    ASSERT_TRUE(table);
    std::int32_t before = 0;
    for (const std::int32_t point : table->columns[0].points)
        EXPECT_LE(point - std::exchange(before, point), 16);
    EXPECT_TRUE(planPath(*table, modules, {}));
}

TEST_F(PathDrawing, RepeatsAndCalls) {
    machine.program.sequences.push_back({"Swing", {action::MoveTo{"There"}, action::MoveTo{"Back"}}});
    const auto table = draw({action::Call{"Swing"}, action::Repeat{0, 3}, action::WaitForArrival{}});
    ASSERT_TRUE(table);
    EXPECT_EQ(table->columns[0].points.size(), 3U * 132U);
}

TEST_F(PathDrawing, TakesTheAxesAlongThatAMoveLeavesWhereTheyAre) {
    const auto table = draw({action::MoveTo{"Both"}, action::MoveTo{"Back"}});
    ASSERT_TRUE(table);
    ASSERT_EQ(table->columns.size(), 2U);
    EXPECT_EQ(table->columns[0].points.back(), 0);
    EXPECT_EQ(table->columns[1].module, ModuleIndex(1));
    EXPECT_EQ(table->columns[1].points.back(), 70);
    EXPECT_EQ(table->columns[1].points.size(), table->columns[0].points.size());
}

/// 32 ticks of 0.512 ms are 16.384 ms.
constexpr double kPeriod = 0.016384;

TEST_F(PathDrawing, IsATrapezoidThatEndsOnItsGoal) {
    // 0.5 s and 250 counts up to 1000 counts/s, 500 counts at that speed, and as long down: 1.5 s, 91.55
    // periods.
    modules.push_back(holding(2, 50));
    setPace(ModuleIndex(2), 1'000.0, 2'000.0);
    machine.program.points.push_back({"Up", {{ModuleIndex(2), 1'050, false}}});
    const auto table = draw({action::MoveTo{"Up"}});
    ASSERT_TRUE(table);
    ASSERT_EQ(table->columns.size(), 1U);
    EXPECT_EQ(table->columns[0].module, ModuleIndex(2));
    const auto& points = table->columns[0].points;
    ASSERT_EQ(points.size(), 92U);
    EXPECT_EQ(points.back(), 1'050);
    EXPECT_EQ(points[0], 50 + std::lround(1'000 * kPeriod * kPeriod));
    // After 30 periods, 0.49152 s: 2000 / 2 * t^2 = 241.6; after 60, 0.98304 s: 1000 * (t - 0.25) = 733.0.
    EXPECT_EQ(points[29], 50 + 242);
    EXPECT_EQ(points[59], 50 + 733);
    // After 90 periods, 25.44 ms before the end: 1000 - 1000 * t^2 = 999.4.
    EXPECT_EQ(points[89], 50 + 999);
}

TEST_F(PathDrawing, GoesInAStraightLine) {
    // Y has twice as far to go at the same maximum speed, so X moves at half of it.
    modules[1] = holding(1, 0);
    setPace(ModuleIndex(0), 1'000.0, 1e6);
    setPace(ModuleIndex(1), 1'000.0, 1e6);
    machine.program.points = {{"Far", {{ModuleIndex(0), 1'000, false}, {ModuleIndex(1), 2'000, false}}},
                              {"Near", {{ModuleIndex(0), 1'000, false}, {ModuleIndex(1), 1'000, false}}}};
    const auto table =
        draw({action::MoveTo{"Far"}, action::MoveTo{"Far"}, action::MoveTo{"Near"}}, PathRate::Hz120);
    ASSERT_TRUE(table);
    const auto& x = table->columns[0].points;
    const auto& y = table->columns[1].points;
    ASSERT_EQ(x.size(), y.size());
    // 2000 counts take 2.001 s, which are 244.3 periods of 8.192 ms; 0 counts take none, and 1000 take 122.2.
    ASSERT_EQ(x.size(), 245U + 123U);
    EXPECT_EQ(x[244], 1'000);
    EXPECT_EQ(y[244], 2'000);
    EXPECT_EQ(x.back(), 1'000);
    EXPECT_EQ(y.back(), 1'000);
    for (std::size_t i = 0; i < 245; ++i)
        EXPECT_LE(std::abs(2 * x[i] - y[i]), 2) << i;
    for (std::size_t i = 1; i < y.size(); ++i)
        EXPECT_LE(std::abs(y[i] - y[i - 1]), 10) << "1000 counts/s are 8.2 in a period, plus rounding";
}

TEST_F(PathDrawing, OfAShortMoveHasNoPlateau) {
    // 100 counts at 1000 counts/s^2: 0.3162 s up to 316 counts/s and as long down make 38.6 periods.
    setPace(ModuleIndex(0), 5'000.0, 1'000.0);
    machine.program.points.push_back({"Down", {{ModuleIndex(0), -100, false}}});
    const auto table = draw({action::MoveTo{"Down"}});
    ASSERT_TRUE(table);
    const auto& points = table->columns[0].points;
    ASSERT_EQ(points.size(), 39U);
    EXPECT_EQ(points.back(), -100);
    // After 19 periods, 0.3113 s: 500 t^2 = 48.5.
    EXPECT_EQ(points[18], -48);
}

TEST_F(PathDrawing, SaysWhatMakesNoPath) {
    EXPECT_EQ(problem({action::MoveTo{"There"}, action::SetOutput{ModuleIndex(0)}}),
              (DrawingProblem{DrawingFault::NotDrawn, "Main", 1, {}}));
    machine.program.sequences.clear();
    EXPECT_EQ(problem({action::MoveTo{"There"}, action::Repeat{0, 0}}),
              (DrawingProblem{DrawingFault::Endless, "Main", 1, {}}));
    machine.program.sequences.clear();
    EXPECT_EQ(problem({action::Wait{0.001}}), (DrawingProblem{DrawingFault::NoMove, "Main", 0, {}}));
    machine.program.sequences.clear();
    EXPECT_EQ(problem({action::MoveTo{"There"}, action::MoveTo{"Back"}, action::Repeat{0, 1'000'000}})->kind,
              DrawingFault::TooManyPoints);
    machine.program.sequences.clear();
    EXPECT_EQ(problem({action::MoveTo{"There"}, action::Wait{1e12}})->kind, DrawingFault::TooManyPoints);
    machine.program.sequences.clear();
    // The axis is there already: no points, however often the move is repeated.
    EXPECT_EQ(problem({action::MoveTo{"Back"}, action::Repeat{0, 4'000'000'000U}})->kind,
              DrawingFault::TooManyPoints);
    machine.program.sequences.clear();
    modules[0] = holding(0, 0, 4);
    EXPECT_EQ(problem({action::MoveTo{"There"}}),
              (DrawingProblem{DrawingFault::NoPathAxis, {}, 0, ModuleIndex(0)}));
}

/// Each sequence by itself is short, but together they are a million rows without a point.
TEST_F(PathDrawing, ATreeOfCallsIsTooMuchToo) {
    for (int i = 0; i < 20; ++i) {
        const Action next = i == 19 ? Action(action::Wait{0}) : Action(action::Call{std::to_string(i + 1)});
        machine.program.sequences.push_back({std::to_string(i), {next, next}});
    }
    EXPECT_EQ(problem({action::MoveTo{"There"}, action::Call{"0"}})->kind, DrawingFault::TooManyPoints);
}

/// A third of a millimetre is not a finite decimal number, but the exact count has to be read back.
TEST(PathText, ReadsBackToTheCount) {
    const std::vector<PathColumn> axes{
        {"X", ModuleIndex(0), AxisScale::servo({UnitKind::Millimetres, 3.0, {}}, 1)}, {"Y", ModuleIndex(1)}};
    const PathTable table{PathRate::Hz120,
                          {{ModuleIndex(1), {0, -1, 2'000}}, {ModuleIndex(0), {-1, 0, 1'000}}}};
    const std::string text = pathText(table, axes);
    EXPECT_TRUE(text.starts_with("# rate 120\nY, X\n0, -0.333333")) << text;
    EXPECT_EQ(readPath(text, axes), table);
}

TEST(PathName, IsOneThatAColumnCanHave) {
    EXPECT_EQ(pathName(ModuleIndex(2), "Z axis"), "Z axis");
    EXPECT_EQ(pathName(ModuleIndex(2), ""), "Module 3");
    EXPECT_EQ(pathName(ModuleIndex(2), " Z axis "), "Z axis") << "blanks around a cell do not belong to it";
    EXPECT_EQ(pathName(ModuleIndex(2), " "), "Module 3");
    EXPECT_EQ(pathName(ModuleIndex(2), "up, down"), "Module 3");
    EXPECT_EQ(pathName(ModuleIndex(2), "#3"), "Module 3");
}

/// Otherwise a path would be read back into the other one of two axes with the same name.
TEST(PathName, IsTheModulesWhereTwoAxesHaveTheSame) {
    std::vector<PathColumn> axes{{"X", ModuleIndex(0)}, {"Z", ModuleIndex(1)}, {"X", ModuleIndex(2)}};
    nameApart(axes);
    EXPECT_EQ(axes[0].name, "Module 1");
    EXPECT_EQ(axes[1].name, "Z");
    EXPECT_EQ(axes[2].name, "Module 3");
    const PathTable table{PathRate::Hz60, {{ModuleIndex(0), {0, 1}}, {ModuleIndex(2), {0, -1}}}};
    EXPECT_EQ(readPath(pathText(table, axes), axes), table);
}

}  // namespace
}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that are drawn from the moves of a sequence, and path files that are written. Expected values are
// calculated by hand.
#include <gtest/gtest.h>

#include "model/path/pathdrawing.h"
#include "model/path/pathfile.h"

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
        machine.axes.resize(2);
        // 0.5 counts per tick are 976.5625 counts/s, and 0.005 counts per tick squared are 19 073 counts/s^2.
        for (AxisSettings& axis : machine.axes) {
            axis.motion.velocity = 0.5;
            axis.motion.acceleration = 0.005;
        }
        machine.program.points = {{"There", {{ModuleIndex(0), 1'000, false}}},
                                  {"Back", {{ModuleIndex(0), 0, false}}},
                                  {"Both", {{ModuleIndex(0), 500, false}, {ModuleIndex(1), 70, false}}}};
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

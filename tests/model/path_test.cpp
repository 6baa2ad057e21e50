// SPDX-License-Identifier: GPL-3.0-or-later
// Path files, and the arithmetic of docs/paths.md. Expected values are calculated by hand.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "model/path/pathfile.h"
#include "model/path/pathshare.h"

namespace nmc::test {
namespace {

using PathFault = PathProblem::Kind;
using servo::PathRate;

constexpr ModuleIdentity kSc{ModuleType::Servo, kScVersion};

[[nodiscard]] std::vector<PathColumn> axes() {
    // X is in millimetres of 200 counts, Y in counts.
    return {{"X", ModuleIndex(0), AxisScale::servo({UnitKind::Millimetres, 200.0, {}}, 1)},
            {"Y", ModuleIndex(1)}};
}

[[nodiscard]] std::vector<PathProblem> problems(const std::string& text,
                                                const std::vector<PathColumn>& known = axes()) {
    const auto table = readPath(text, known);
    return table ? std::vector<PathProblem>{} : table.error();
}

TEST(PathFile, IsColumnsOfPositionsInTheUnitOfEachAxis) {
    const auto table = readPath(
        "# drawn by hand\r\n"
        "# rate 30\r\n"
        "Y, X\r\n"
        "0, 0\r\n"
        "-120, +1.25\r\n"
        "# half way\r\n"
        "7, -0.004\r\n"
        "\r\n",
        axes());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rate, PathRate::Hz30);
    ASSERT_EQ(table->columns.size(), 2U);
    EXPECT_EQ(table->columns[0], (PathTable::Column{ModuleIndex(1), {0, -120, 7}}));
    EXPECT_EQ(table->columns[1], (PathTable::Column{ModuleIndex(0), {0, 250, -1}})) << "-0.8 counts are -1";
}

TEST(PathFile, IsAt60HzWhereItDoesNotSay) {
    const auto table = readPath("\xEF\xBB\xBFY\n1\n2", axes());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rate, PathRate::Hz60);
    EXPECT_EQ(table->columns[0].points, (std::vector<std::int32_t>{1, 2}));
}

TEST(PathFile, TellsEveryProblemWithItsLine) {
    EXPECT_EQ(
        problems("X,Y\n0,0\n0\n0,0,0\n1e,0\n,0\n0,nan\n"),
        (std::vector<PathProblem>{{.kind = PathFault::CellCount, .line = 3, .value = 1, .allowed = 2},
                                  {.kind = PathFault::CellCount, .line = 4, .value = 3, .allowed = 2},
                                  {.kind = PathFault::NotANumber, .line = 5, .column = "X", .text = "1e"},
                                  {.kind = PathFault::Gap, .line = 6, .column = "X"},
                                  {.kind = PathFault::NotANumber, .line = 7, .column = "Y", .text = "nan"}}));
    EXPECT_EQ(problems("X,Y\n0,0\n\n\n0,0\n"),
              (std::vector<PathProblem>{{.kind = PathFault::Gap, .line = 3}}));
    EXPECT_EQ(problems("# rate 50\nX,Z,X\n0,0,0\n0,0,0\n"),
              (std::vector<PathProblem>{{.kind = PathFault::Rate, .line = 1, .text = "50"},
                                        {.kind = PathFault::UnknownColumn, .line = 2, .text = "Z"},
                                        {.kind = PathFault::ColumnTwice, .line = 2, .column = "X"}}));
    EXPECT_EQ(
        problems("Y\n1;5\n2,5\n"),
        (std::vector<PathProblem>{{.kind = PathFault::NotANumber, .line = 2, .column = "Y", .text = "1;5"},
                                  {.kind = PathFault::CellCount, .line = 3, .value = 2, .allowed = 1}}));
    EXPECT_EQ(
        problems("Y\n+1\n+-2\n"),
        (std::vector<PathProblem>{{.kind = PathFault::NotANumber, .line = 3, .column = "Y", .text = "+-2"}}));
    EXPECT_EQ(problems("").front().kind, PathFault::NoColumns);
    EXPECT_EQ(problems("# rate 60\n").front().kind, PathFault::NoColumns);
    EXPECT_EQ(problems("Y\n5\n").front(),
              (PathProblem{.kind = PathFault::TooFewPoints, .line = 2, .value = 1}));
    EXPECT_EQ(problems("Y\n0\n3000000000\n").front().kind, PathFault::OutOfRange);
}

/// The magnitude in a word has 14, 13 or 12 bits.
TEST(PathFile, RefusesWhatAPointCannotCarry) {
    for (const auto& [rate, most] :
         {std::pair{"30", 16'383}, std::pair{"60", 8'191}, std::pair{"120", 4'095}}) {
        const std::string head = std::string("# rate ") + rate + "\nY\n-1\n";
        EXPECT_TRUE(problems(head + std::to_string(most - 1) + "\n").empty()) << rate;
        const auto found = problems(head + std::to_string(most) + "\n");
        ASSERT_EQ(found.size(), 1U) << rate;
        EXPECT_EQ(found[0], (PathProblem{.kind = PathFault::Jump,
                                         .line = 4,
                                         .column = "Y",
                                         .value = static_cast<double>(most + 1),
                                         .allowed = static_cast<double>(most)}));
    }
}

TEST(PathFile, KeepsTheAxisWithinItsSpeedAndTravel) {
    std::vector<PathColumn> known = axes();
    known[1].travel = TravelRange{-100, 500};
    known[1].fastest = 10.0;  // counts per tick: 320 in a segment of 32 ticks
    EXPECT_TRUE(problems("Y\n-100\n220\n500\n", known).empty());
    EXPECT_EQ(
        problems("Y\n-101\n0\n321\n501\n", known),
        (std::vector<PathProblem>{
            {.kind = PathFault::BeyondTravel, .line = 2, .column = "Y", .value = -101, .allowed = -100},
            {.kind = PathFault::TooFast, .line = 4, .column = "Y", .value = 321.0 / 32, .allowed = 10.0},
            {.kind = PathFault::BeyondTravel, .line = 5, .column = "Y", .value = 501, .allowed = 500}}));
}

TEST(PathFile, StopsLookingAfterTwentyProblems) {
    std::string text = "Y\n";
    for (int i = 0; i < 100; ++i)
        text += "x\n";
    const auto found = problems(text);
    EXPECT_EQ(found.size(), 20U);
    EXPECT_EQ(found.back().line, 21U);
}

TEST(PathFile, HasAnEnd) {
    std::string text = "Y\n";
    for (std::size_t i = 0; i < kMaxPathPoints; ++i)
        text += "5\n";
    EXPECT_TRUE(problems(text).empty());
    const auto found = problems(text + "5\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, PathFault::TooManyPoints);
    EXPECT_EQ(found[0].line, kMaxPathPoints + 2);
}

/// A frame of seven points takes 18 bytes to the module, 12 back and a tick; at 61.035 Hz, 8.7193 are sent a
/// second. A poll takes 5 bytes to the module, 19 back and a tick; each module is polled 5.5556 times a
/// second.
TEST(PathShare, IsTheArithmeticOfTheWire) {
    const std::array three{kSc, kSc, kSc};
    const PathLine fast{115'200, Duration{}};
    // A byte takes 86.806 us: 3.1162 ms a frame, 2.5953 ms a poll.
    EXPECT_NEAR(pathShare(fast, PathRate::Hz60, three, 0), 3 * 8.7193 * 3.1162e-3, 0.002);
    EXPECT_NEAR(pathShare(fast, PathRate::Hz60, {}, 3), 3 * 5.5556 * 2.5953e-3, 0.002);
    EXPECT_LE(pathShare(fast, PathRate::Hz60, three, 3), kPathAvailable);
    EXPECT_LE(pathShare(fast, PathRate::Hz120, three, 12), kPathAvailable);
    // At 19 200 Bd a frame takes 16.137 ms and a poll 13.012 ms: 42 % and 22 % of the time at 60 Hz; at 120
    // Hz, the frames alone take 84 %.
    const PathLine slow{19'200, Duration{}};
    EXPECT_NEAR(pathShare(slow, PathRate::Hz60, three, 3), 0.639, 0.005);
    EXPECT_LE(pathShare(slow, PathRate::Hz60, three, 3), kPathAvailable);
    EXPECT_NEAR(pathShare(slow, PathRate::Hz120, three, 0), 0.844, 0.005);
    EXPECT_GT(pathShare(slow, PathRate::Hz120, three, 3), kPathAvailable);
    // With an adapter that holds every answer back for 16 ms, a frame takes 19.1 ms, half of the time at 60
    // Hz.
    const PathLine lazy{115'200, std::chrono::milliseconds(16)};
    EXPECT_NEAR(pathShare(lazy, PathRate::Hz60, three, 0), 0.500, 0.005);
    EXPECT_GT(pathShare(lazy, PathRate::Hz120, three, 3), kPathAvailable);
}

}  // namespace
}  // namespace nmc::test

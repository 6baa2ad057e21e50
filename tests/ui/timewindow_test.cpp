// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/timewindow.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

TEST(TimeWindow, RollsADivisionAtATime) {
    TimeWindow time;  // 10 s: divisions of 1 s
    EXPECT_EQ(time.division(), 1);
    time.follow(20.2);
    EXPECT_EQ(time.right(), 21);
    EXPECT_EQ(time.left(), 11);
    time.follow(20.9);
    EXPECT_EQ(time.right(), 21);
    time.follow(21.1);
    EXPECT_EQ(time.right(), 22);
}

TEST(TimeWindow, BeginsAtZero) {
    TimeWindow time;
    time.follow(0.5);
    EXPECT_EQ(time.left(), 0);
    EXPECT_EQ(time.right(), 10);
}

TEST(TimeWindow, ZoomKeepsWhatIsUnderThePointer) {
    TimeWindow time;
    time.show(0, 10);
    time.zoom(0.5, 2);
    EXPECT_DOUBLE_EQ(time.left(), 1);
    EXPECT_DOUBLE_EQ(time.right(), 6);
    time.zoom(2, 2);
    EXPECT_DOUBLE_EQ(time.left(), 0);
    EXPECT_DOUBLE_EQ(time.right(), 10);
}

TEST(TimeWindow, ZoomWhileRollingKeepsThePresent) {
    TimeWindow time;
    time.follow(100);
    time.zoom(0.5, 93);
    EXPECT_TRUE(time.rolls());
    EXPECT_EQ(time.right(), 100);
    EXPECT_EQ(time.left(), 95);
}

TEST(TimeWindow, PanningStandsStill) {
    TimeWindow time;
    time.follow(100);
    time.pan(-3);
    EXPECT_FALSE(time.rolls());
    time.follow(200);
    EXPECT_EQ(time.right(), 97);
}

TEST(TimeWindow, IsNeverOfNoLengthNorEndless) {
    TimeWindow time;
    time.show(5, 5);
    EXPECT_NEAR(time.width(), TimeWindow::kShortest, 1e-9);
    for (int i = 0; i < 500; ++i)
        time.zoom(0.5, 5);
    EXPECT_NEAR(time.width(), TimeWindow::kShortest, 1e-9);
    for (int i = 0; i < 500; ++i)
        time.zoom(2, 5);
    EXPECT_NEAR(time.width(), TimeWindow::kLongest, 1e-3);
}

TEST(TimeWindow, DivisionsAreOneTwoOrFiveTimesAPowerOfTen) {
    for (const auto& [rough, nice] : {std::pair{0.9, 1.0},
                                      {1.0, 1.0},
                                      {1.1, 2.0},
                                      {2.4, 5.0},
                                      {7.0, 10.0},
                                      {0.03, 0.05},
                                      {3'000.0, 5'000.0}})
        EXPECT_NEAR(TimeWindow::nice(rough), nice, nice * 1e-9);
}

}  // namespace
}  // namespace nmc

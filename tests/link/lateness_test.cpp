// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/terminal/lateness.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Lateness, NinetyNineOfAHundredAreWithinThePercentile) {
    Lateness lateness;
    EXPECT_EQ(lateness.percentile99(), Duration::zero());
    for (int i = 0; i < 98; ++i)
        lateness.add(microseconds(45));
    lateness.add(microseconds(123));
    lateness.add(seconds(2));
    EXPECT_EQ(lateness.percentile99(), microseconds(130)) << "rounded up to the next 10 us";
    EXPECT_EQ(lateness.largest(), seconds(2));
}

TEST(Lateness, BeyondTenMillisecondsItIsTheLargest) {
    Lateness lateness;
    lateness.add(milliseconds(700));
    EXPECT_EQ(lateness.percentile99(), milliseconds(700));
}

TEST(StallWatch, CountsPausesOfMoreThanTwentyMilliseconds) {
    StallWatch watch;
    TimePoint now{};
    for (const Duration pause :
         {milliseconds(5), milliseconds(20), milliseconds(21), milliseconds(300), milliseconds(5)}) {
        now += pause;
        watch.runs(now);
    }
    EXPECT_EQ(watch.count(), 2U);
    EXPECT_EQ(watch.longest(), milliseconds(300));
}

TEST(StallWatch, TheTimeBeforeItBeganIsNone) {
    StallWatch watch;
    watch.runs(TimePoint{} + seconds(100));
    EXPECT_EQ(watch.count(), 0U);
}

TEST(LagReport, IsSaidAtOnceThenEveryFiveSecondsAndWhenItIsOver) {
    LagReport report;
    const TimePoint start{};
    EXPECT_FALSE(report.sentence(milliseconds(10), start));
    EXPECT_EQ(report.sentence(milliseconds(420), start),
              "0.42 s behind real time; use fewer modules or a lower --speed.");
    EXPECT_FALSE(report.sentence(milliseconds(900), start + milliseconds(4'999)));
    EXPECT_TRUE(report.sentence(milliseconds(900), start + seconds(5)));
    EXPECT_FALSE(report.sentence(milliseconds(5), start + seconds(6))) << "it is still behind";
    EXPECT_EQ(report.sentence(Duration::zero(), start + seconds(6)), "caught up with real time.");
    EXPECT_FALSE(report.sentence(Duration::zero(), start + seconds(7)));
    EXPECT_FALSE(report.sentence(milliseconds(900), start + seconds(8))) << "reported every 5 s at most";
    EXPECT_TRUE(report.sentence(milliseconds(900), start + seconds(10)));
}

}  // namespace
}  // namespace nmc

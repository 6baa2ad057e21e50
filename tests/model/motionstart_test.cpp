// SPDX-License-Identifier: GPL-3.0-or-later
// The times at which motions begin, from known positions.
#include "model/scope/motionstart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace nmc {
namespace {

constexpr TimePoint kZero{std::chrono::seconds(50)};

/// A shaft with a thousand samples a second.
class Shaft {
public:
    /// Moves the shaft at `velocity` in counts/s.
    void go(double seconds, double velocity) {
        for (int i = 0; i < std::lround(seconds * 1'000); ++i) {
            m_at += velocity / 1'000;
            ScopeSample sample;
            sample.time = kZero + fromSeconds(m_milliseconds++ / 1e3);
            sample.position = static_cast<std::int32_t>(std::lround(m_at));
            sample.gapBefore = std::exchange(m_wasSet, false);
            history.append(sample);
        }
    }
    /// The counter is set, as by Reset Position, which the next sample marks as a gap.
    void setCounter(double counts) {
        m_at = counts;
        m_wasSet = true;
    }
    /// The last start of a motion that follow() has found, in seconds since the first sample; -1 if there is
    /// none.
    [[nodiscard]] double last() {
        EXPECT_TRUE(motion.follow(history));
        return motion.last() ? toSeconds(*motion.last() - kZero) : -1;
    }

    ModuleHistory history;
    MotionStart motion;

private:
    double m_at = 0;
    bool m_wasSet = false;
    int m_milliseconds = 0;
};

TEST(MotionStart, IsWhereTheShaftLeavesItsPlace) {
    Shaft shaft;
    shaft.go(1.0, 0);
    EXPECT_EQ(shaft.last(), -1) << "it is at rest";
    shaft.go(0.5, 10'000);
    EXPECT_NEAR(shaft.last(), 1.0, 0.0015);
    shaft.go(1.0, 0);
    EXPECT_NEAR(shaft.last(), 1.0, 0.0015);
    shaft.go(0.5, -10'000);
    EXPECT_NEAR(shaft.last(), 2.5, 0.0015) << "the second motion";
    EXPECT_NEAR(toSeconds(*shaft.motion.first() - kZero), 1.0, 0.0015);
}

TEST(MotionStart, AServoThatHoldsDoesNotMove) {
    Shaft shaft;
    for (int i = 0; i < 100; ++i) {
        shaft.go(0.004, 1'000);  // 4 counts forward and back
        shaft.go(0.004, -1'000);
    }
    EXPECT_EQ(shaft.last(), -1);
}

/// The shaft is almost at rest for 40 ms at the reversal: still one motion.
TEST(MotionStart, AShortPauseIsNoEnd) {
    Shaft shaft;
    shaft.go(0.5, 0);
    shaft.go(0.2, 5'000);
    shaft.go(0.04, 0);
    shaft.go(0.2, -5'000);
    EXPECT_NEAR(shaft.last(), 0.5, 0.002);
}

TEST(MotionStart, AMotionOverTheWrapOfThePositionIsOne) {
    Shaft shaft;
    ScopeSample sample;
    for (unsigned i = 0; i < 500; ++i) {
        sample.time = kZero + std::chrono::milliseconds(i);
        sample.position = static_cast<std::int32_t>(0x7FFF'FFFFU + (i < 300 ? 0U : 2U * (i - 300U)));
        shaft.history.append(sample);
    }
    EXPECT_NEAR(shaft.last(), 0.302, 0.001) << "five counts at the fourth sample";
}

TEST(MotionStart, SettingTheCounterIsNoMotion) {
    Shaft shaft;
    shaft.setCounter(50'000);
    shaft.go(1.0, 0);
    shaft.setCounter(0);
    shaft.go(1.0, 0);
    EXPECT_EQ(shaft.last(), -1);
    shaft.go(0.5, 10'000);
    EXPECT_NEAR(shaft.last(), 2.0, 0.0015);
    shaft.setCounter(0);
    shaft.go(0.5, 10'000);
    EXPECT_NEAR(shaft.last(), 2.0, 0.0015) << "it moves on";
}

/// The history is evaluated in pieces; how it is divided makes no difference.
TEST(MotionStart, TakesALongHistoryInPieces) {
    Shaft shaft;
    shaft.go(100.0, 0);
    shaft.go(1.0, 1'000);
    EXPECT_FALSE(shaft.motion.follow(shaft.history)) << "50 000 samples at a time";
    EXPECT_FALSE(shaft.motion.follow(shaft.history));
    EXPECT_NEAR(shaft.last(), 100.0, 0.006);
}

}  // namespace
}  // namespace nmc

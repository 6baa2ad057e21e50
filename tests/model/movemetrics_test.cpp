// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a profiled move, from points whose figures follow from a formula.
#include "model/response/movemetrics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nmc {
namespace {

constexpr double kBetweenPoints = 0.001;  ///< s
constexpr double kRecord = 2.0;

/// 4 counts per tick at 0.02 counts per tick squared: 200 ticks of 512 us to its velocity, over 400 counts
/// each way; so 2000 counts take 200 + 300 + 200 ticks, 0.3584 s.
[[nodiscard]] ResponseTaken move(std::int32_t counts = 2'000) {
    ResponseTaken taken;
    taken.goal = counts;
    taken.record = kRecord;
    taken.method = ResponseMethod::Move;
    taken.pace = {CountsPerTick(4U << 16U), CountsPerTickSquared(1'311)};
    taken.gains.sr = 1;
    return taken;
}
constexpr double kMoveTime = 0.3584;
constexpr double kServoTickTime = 512e-6;  // at SR 1
/// The first tick is within one of the command, and the profile is that of velocities at the ends of ticks.
constexpr double kEnd = kMoveTime - kServoTickTime;

template <typename Error>
[[nodiscard]] std::vector<ResponsePoint> points(const Error& error, double off = 0.0) {
    std::vector<ResponsePoint> points;
    for (int i = -10; i < kRecord / kBetweenPoints; ++i) {
        const double s = i * kBetweenPoints;
        points.push_back({s, 2'000 - off - error(s), error(s)});
    }
    return points;
}

[[nodiscard]] MoveMetrics measured(const std::vector<ResponsePoint>& points, const SettleWindow& window,
                                   const ResponseTaken& taken = move()) {
    return measureMove(points, taken, window, 0.0);
}

TEST(MoveMetrics, MoveTimeIsThatOfTheProfile) {
    const auto none = [](double) { return 0.0; };
    EXPECT_NEAR(measured(points(none), {}).moveTime, kMoveTime, 1e-4);
    // Too short for its velocity: 2 sqrt(200 / 0.02) ticks.
    EXPECT_NEAR(measured(points(none), {}, move(200)).moveTime, 200 * 512e-6, 1e-4);
}

TEST(MoveMetrics, ItHasSettledWhereTheDwellBegins) {
    // It comes in at 0.5 s, leaves from 0.52 s to 0.6 s, and then stays.
    const auto error = [](double s) { return s < 0.4995 || (s > 0.5195 && s < 0.5995) ? 20.0 : 3.0; };
    const MoveMetrics shortDwell = measured(points(error), {5, 0.01});
    ASSERT_TRUE(shortDwell.settling);
    // The error falls to 3 between 0.499 s and 0.5 s, and is 5.5 after (20 - 5.5) / (20 - 3) of that.
    EXPECT_NEAR(shortDwell.settling->value, 0.49985 - kEnd, 1e-4);
    EXPECT_NEAR(shortDwell.settling->doubt, kBetweenPoints / 2 + kServoTickTime, 1e-9);
    const MoveMetrics longDwell = measured(points(error), {5, 0.05});
    ASSERT_TRUE(longDwell.settling);
    EXPECT_NEAR(longDwell.settling->value, 0.59985 - kEnd, 1e-4);
    EXPECT_EQ(measured(points(error), {2, 0.01}).settling.error(), Unmeasured::NeverSettled);
}

TEST(MoveMetrics, AMotorThatIsWithinTheWindowAtTheEndOfTheProfileHasSettledAtOnce) {
    const auto settling = measured(points([](double) { return 2.0; }), {2, 0.1}).settling;
    ASSERT_TRUE(settling);
    EXPECT_EQ(settling->value, 0.0);
}

TEST(MoveMetrics, ARecordThatEndsBeforeTheDwellDoesNotTell) {
    const auto error = [](double s) { return s < kRecord - 0.05 ? 20.0 : 0.0; };
    EXPECT_TRUE(measured(points(error), {5, 0.04}).settling);
    EXPECT_EQ(measured(points(error), {5, 0.1}).settling.error(), Unmeasured::NeverSettled);
}

TEST(MoveMetrics, NothingIsSaidOfTimesWithoutSamples) {
    auto missing = points([](double s) { return s < 0.5 ? 20.0 : 0.0; });
    std::erase_if(missing,
                  [](const ResponsePoint& point) { return point.seconds > 0.51 && point.seconds < 0.55; });
    EXPECT_EQ(measured(missing, {5, 0.1}).settling.error(), Unmeasured::SamplesMissing);
    EXPECT_TRUE(measured(missing, {5, 0.005}).settling);
    EXPECT_EQ(measured({}, {}).settling.error(), Unmeasured::TooFewSamples);
}

TEST(MoveMetrics, ErrorsAreThoseOfTheirTimes) {
    // A sine of whole periods during the move has an RMS value of its amplitude over the root of two.
    const auto sine = [](double s) {
        return s < kMoveTime ? 30 * std::sin(2 * 3.14159265358979 * 10 * s / kMoveTime) : 40.0;
    };
    const MoveMetrics metrics = measured(points(sine), {});
    ASSERT_TRUE(metrics.rms && metrics.peak);
    EXPECT_NEAR(metrics.rms->value, 30 / std::sqrt(2.0), 0.2);
    EXPECT_NEAR(metrics.peak->value, 40, 1e-9);
}

TEST(MoveMetrics, TheErrorAtConstantVelocityIsThatOfItsSecondHalf) {
    // At constant velocity from 0.1024 s to 0.256 s, so its second half begins at 0.1792 s.
    const auto error = [](double s) { return s > 0.179 && s < 0.2565 ? -12.0 : 100.0; };
    const MoveMetrics metrics = measured(points(error), {});
    ASSERT_TRUE(metrics.slew);
    EXPECT_NEAR(metrics.slew->value, -12, 2);
    EXPECT_EQ(measured(points(error), {}, move(200)).slew.error(), Unmeasured::NoConstantVelocity);
}

TEST(MoveMetrics, AtALowerServoRateErrorsAreLessCertain) {
    ResponseTaken slow = move();
    slow.gains.sr = 4;
    const auto none = [](double) { return 0.0; };
    EXPECT_EQ(measured(points(none), {}).rms->doubt, 0.5);
    // 4 counts a tick, of which any of the last three quarters may not have been commanded yet.
    EXPECT_NEAR(measured(points(none), {}, slow).rms->doubt, 0.5 + 1.5, 1e-9);
}

/// At SR 4, a servo tick is 2.048 ms, and the move takes 700 of them.
TEST(MoveMetrics, AtALowerServoRateItsEndIsLessCertain) {
    ResponseTaken slow = move();
    slow.gains.sr = 4;
    const auto error = [](double s) { return s < 1.4995 ? 20.0 : 3.0; };
    const MoveMetrics metrics = measured(points(error), {5, 0.1}, slow);
    ASSERT_TRUE(metrics.settling);
    EXPECT_NEAR(metrics.settling->value, 1.49985 - (700 - 1) * 0.002'048, 2e-4);
    EXPECT_NEAR(metrics.settling->doubt, kBetweenPoints / 2 + 0.002'048, 1e-9);
}

}  // namespace
}  // namespace nmc

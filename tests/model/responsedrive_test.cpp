// SPDX-License-Identifier: GPL-3.0-or-later
// The output of the control filter in a run, calculated by hand (DS-V 4.3).
#include "model/response/responsedrive.h"

#include <gtest/gtest.h>

#include "tests/support/servotick.h"

namespace nmc {
namespace {

using testing_support::kTick;

[[nodiscard]] ResponseRecord runOf(const servo::SetGain& gains, std::vector<ResponsePoint> points) {
    ResponseRecord run;
    run.taken = {{}, 1'000, 1'100, 1.0, ResponseMethod::Profile, gains};
    run.points = std::move(points);
    return run;
}

TEST(ResponseDrive, IsWhatTheFilterMakesOfErrorAndItsChange) {
    // At the step e = 100, all of it new: (100 x 100 + 300 x 100) / 256 = 156.25. A tick later e = 90: (100 x
    // 90 - 300 x 10) / 256 = 23.4; another two ticks later e = 50: (5000 - 300 x 20) / 256 = -3.9.
    const servo::SetGain gains{100, 300, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};
    const auto drive = driveOf(runOf(gains, {{-kTick, 1'000}, {kTick, 1'010}, {3 * kTick, 1'050}}));
    ASSERT_EQ(drive.size(), 3U);
    EXPECT_EQ(drive[0].seconds, 0.0);
    EXPECT_EQ(drive[0].error, 100);
    EXPECT_NEAR(drive[0].pwm, 156.25, 1e-9);
    EXPECT_NEAR(drive[1].pwm, 23.4375, 1e-9);
    EXPECT_NEAR(drive[2].pwm, -3.90625, 1e-9);
}

TEST(ResponseDrive, KeepsToTheOutputLimitAndAddsTheDeadband) {
    const servo::SetGain gains{1'000, 0, 0, 0, 60, 0, 4'000, 1, std::uint8_t{12}};
    const auto drive = driveOf(runOf(gains, {{kTick, 1'000}, {2 * kTick, 1'100}, {3 * kTick, 1'101}}));
    EXPECT_EQ(drive[1].pwm, 72) << "390 would be needed; the limit of 60 and the deadband of 12";
    EXPECT_EQ(drive[2].pwm, 0);
    EXPECT_NEAR(drive[3].pwm, -1'000 / 256.0 - 12, 1e-9);
}

TEST(ResponseDrive, GathersTheIntegralUpToItsLimit) {
    // 10 counts off for 256 ticks are 2560 / 256 = 10, and with Ki 64 x 10 / 256 = 2.5; IL = 20 is reached at
    // 512 ticks.
    const servo::SetGain gains{0, 0, 64, 20, 255, 0, 4'000, 1, std::uint8_t{0}};
    ResponseRecord run = runOf(gains, {{256 * kTick, 1'090}, {512 * kTick, 1'090}, {1'024 * kTick, 1'090}});
    run.taken.goal = 1'100;
    run.taken.from = 1'090;
    run.points.insert(run.points.begin(), {-kTick, 1'090});
    const auto drive = driveOf(run);
    ASSERT_EQ(drive.size(), 4U);
    EXPECT_NEAR(drive[1].pwm, 2.5, 0.26) << "one step of the integral is a quarter";
    EXPECT_NEAR(drive[2].pwm, 5.0, 0.26);
    EXPECT_NEAR(drive[3].pwm, 5.0, 1e-9) << "20 x 64 / 256";
}

}  // namespace
}  // namespace nmc

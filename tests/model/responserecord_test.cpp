// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/response/responserecord.h"

#include <gtest/gtest.h>

#include <vector>

#include "scopesamples.h"
#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

[[nodiscard]] servo::SetGain gainsOf(std::uint16_t kp, std::uint16_t kd, std::uint16_t ki, std::uint8_t ol) {
    servo::SetGain gains;
    gains.kp = kp;
    gains.kd = kd;
    gains.ki = ki;
    gains.il = 100;
    gains.ol = ol;
    return gains;
}

TEST(PwmDemand, IsWhatTheFilterAsksForWhenTheCommandJumps) {
    // 10 x 100 + 50 x 100 = 6000, / 256 = 23.4.
    const PwmDemand demand = pwmDemand(gainsOf(10, 50, 0, 255), 0, 100);
    EXPECT_EQ(demand.wanted, 23);
    EXPECT_FALSE(demand.limited());
    EXPECT_EQ(demand.output(), 23);
    EXPECT_EQ(pwmDemand(gainsOf(10, 50, 0, 255), 0, -100).wanted, 23);
}

TEST(PwmDemand, CountsOnlyTheChangeOfTheErrorForTheDamping) {
    // With an error of 4 before: 10 x 104 + 50 x 100 = 6040, / 256 = 23.6; with -20: 10 x 80 + 50 x 100, /
    // 256 = 22.7.
    EXPECT_EQ(pwmDemand(gainsOf(10, 50, 0, 255), 4, 104).wanted, 23);
    EXPECT_EQ(pwmDemand(gainsOf(10, 50, 0, 255), -20, 80).wanted, 22);
}

TEST(PwmDemand, IsTheOutputLimitExactlyWhenItWantsMore) {
    // 200 x 100 + 2000 x 100 = 220 000, / 256 = 859.4.
    const PwmDemand demand = pwmDemand(gainsOf(200, 2'000, 0, 127), 0, 100);
    EXPECT_EQ(demand.wanted, 859);
    EXPECT_TRUE(demand.limited());
    EXPECT_EQ(demand.output(), 127);
}

TEST(PwmDemand, ReckonsWithAnIntegralThatPullsTheOtherWay) {
    // 6000 - 20 x 100 = 4000, / 256 = 15.6; the demand is never below 0.
    EXPECT_EQ(pwmDemand(gainsOf(10, 50, 20, 255), 0, 100).wanted, 15);
    EXPECT_EQ(pwmDemand(gainsOf(10, 50, 200, 255), 0, 100).wanted, 0);
}

[[nodiscard]] ResponseTaken taken(std::int32_t from, std::int32_t goal) {
    return {atSeconds(1), from, goal, 0.1, ResponseMethod::Profile, gainsOf(10, 50, 0, 255)};
}

TEST(ResponseRecord, KeepsTheRecordFromShortlyBeforeTheStepOn) {
    std::vector<ScopeSample> samples;
    for (int ms = 0; ms < 3'000; ++ms)
        samples.push_back(sampleAt(ms / 1'000.0, ms > 1'000 ? 600 : 500));
    const ResponseRecord run = takeRun(ModuleIndex(3), samples, taken(500, 600), 2);
    EXPECT_EQ(run.module, ModuleIndex(3));
    ASSERT_EQ(run.points.size(), 121U) << "20 ms before the step, 100 ms after it";
    EXPECT_NEAR(run.points.front().seconds, -0.02, 1e-9);
    EXPECT_NEAR(run.points.back().seconds, 0.1, 1e-9);
    EXPECT_NEAR(run.metrics.rise->value, 0.000'8, 1e-9) << "a straight line within one interval";
    EXPECT_EQ(run.metrics.steadyError->value, 0.0);
    EXPECT_FALSE(run.pwm) << "the error before the step was not known";
}

TEST(ResponseRecord, TakesTheErrorRightBeforeTheStepForThePwmDemand) {
    std::vector<ScopeSample> samples = {sampleAt(0.998, 493), sampleAt(0.999, 520), sampleAt(1.001, 520)};
    samples[0].error = 7;
    samples[1].error = -20;
    samples[2].error = 60;
    const ResponseRecord run = takeRun(ModuleIndex(0), samples, taken(500, 580), 2);
    ASSERT_TRUE(run.pwm);
    EXPECT_EQ(run.pwm->wanted, 17) << "10 x 60 + 50 x 80 = 4600, / 256";
}

TEST(ResponseRecord, CrossesTheEndOfThe32Bits) {
    constexpr std::int32_t kHigh = 0x7FFF'FFFF;
    std::vector<ScopeSample> samples = {sampleAt(0.999, kHigh - 60), sampleAt(1.001, kHigh - 10),
                                        sampleAt(1.002, -kHigh - 1 + 4)};
    for (int i = 3; i < 30; ++i)
        samples.push_back(sampleAt(1 + i / 1'000.0, kHigh - 10));
    const ResponseRecord run = takeRun(ModuleIndex(0), samples, taken(kHigh - 60, kHigh - 10), 2);
    // 15 counts beyond the goal: -2^31 + 4 is 5 above 2^31 - 1.
    EXPECT_NEAR(run.metrics.overshoot->value, 30, 1) << "of 50 counts";
}

TEST(ResponseRecord, CanBeJudgedByAnotherBand) {
    std::vector<ScopeSample> samples;
    for (int ms = 0; ms < 100; ++ms)
        samples.push_back(sampleAt(1 + ms / 1'000.0, ms < 10 ? 0 : ms < 30 ? 90 : 100));
    ResponseRecord run = takeRun(ModuleIndex(0), samples, taken(0, 100), 20);
    EXPECT_EQ(run.band(), 20);
    EXPECT_NEAR(run.metrics.settling->value, 0.01, 0.001);
    judge(run, 5);
    EXPECT_NEAR(run.metrics.settling->value, 0.03, 0.001);
    judge(run, 0.1);
    EXPECT_EQ(run.band(), 1) << "the encoder resolves no less than a count";
}

}  // namespace
}  // namespace nmc

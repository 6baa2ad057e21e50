// SPDX-License-Identifier: GPL-3.0-or-later
// The first homing of a motor that nobody has tuned: with starting gains and the preset recipe.
#include "model/intent/homingplan.h"
#include "model/settings/startinggains.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using Input = sim::Input;

/// A motor with its reverse limit at -1 000 and the gains of an axis whose unit is counts.
class FirstHoming : public testing::Test {
protected:
    [[nodiscard]] static ProcedureReport home(ServoBench& bench, const servo::SetGain& gains,
                                              std::int32_t tolerance) {
        const bool reverseLimitIs2 = isSc(bench.module().info.identity);  // docs/family.md
        bench.putSwitch(reverseLimitIs2 ? Input::Limit2 : Input::Limit1, -1'000, true);
        bench.settle();
        EXPECT_TRUE(bench.perform(intent::ApplyGains{gains}));
        EXPECT_TRUE(bench.perform(intent::Enable{}));
        return bench.run(intent::Home{firstRecipe(bench.module().info.identity), tolerance});
    }
};

TEST_F(FirstHoming, WithStartingValuesMakesItsZero) {
    for (const int version : {1, 2, 3, 4, int{kPathVersion}, int{kScVersion}}) {
        SCOPED_TRACE(version);
        ServoBench bench(static_cast<std::uint8_t>(version));
        ASSERT_TRUE(bench.connect());
        const ProcedureReport report = home(bench, startingGains({}), 0);
        EXPECT_EQ(report.stage, ProcedureStage::Done);
        EXPECT_EQ(report.offHome, 0);
        const auto truth = bench.truth();
        EXPECT_NEAR(truth.shaftCounts - truth.position, -1'000, 2);
        EXPECT_TRUE(truth.servoOn);
        bench.bus.expectNoViolations();
    }
}

/// The default motor has a friction of 0.004 N·m and an inertia of 1.7e-5 kg·m².
TEST_F(FirstHoming, DoesNotDependOnThatMotor) {
    for (const double friction : {0.001, 0.004, 0.01, 0.02})
        for (const double inertia : {0.8e-5, 1.7e-5, 6e-5, 2e-4}) {
            SCOPED_TRACE(friction);
            SCOPED_TRACE(inertia);
            ServoBench bench;
            ASSERT_TRUE(bench.connect());
            bench.set(Input::Friction, friction);
            bench.set(Input::Inertia, inertia);
            EXPECT_EQ(home(bench, startingGains({}), homeTolerance({})).stage, ProcedureStage::Done);
        }
}

/// Friction holds against 0.004 N·m / 0.038 N·m/A * 1.1 ohm = 0.116 V, which is 1.23 of 255 at 24 V: without
/// Ki, an error of less than 2 * 256 / 100 = 5.1 counts does not move the motor.
TEST_F(FirstHoming, WithoutKiTheToleranceDecides) {
    servo::SetGain gains = startingGains({});
    gains.ki = gains.il = 0;
    ServoBench strict;
    ASSERT_TRUE(strict.connect());
    const ProcedureReport refused = home(strict, gains, 1);
    EXPECT_EQ(refused.stage, ProcedureStage::Failed);
    EXPECT_EQ(refused.failure, ProcedureFailure::NotAtHome);
    EXPECT_GT(std::abs(refused.offHome), 1);
    EXPECT_LE(std::abs(refused.offHome), 6);
    EXPECT_EQ(strict.truth().position, *refused.home + refused.offHome);

    ServoBench lenient;
    ASSERT_TRUE(lenient.connect());
    // A turn has 10 000 counts: a thousandth of it is 10.
    const ProcedureReport done = home(lenient, gains, homeTolerance({UnitKind::Turns, 10'000.0, {}}));
    EXPECT_EQ(done.stage, ProcedureStage::Done);
    EXPECT_EQ(done.offHome, refused.offHome) << "it is the same motor";
    EXPECT_NEAR(lenient.truth().position, 0, 1) << "zero is set where it rests";
}

TEST_F(FirstHoming, AReversedEncoderIsOverSoon) {
    ServoBench bench;
    ASSERT_TRUE(bench.connect());
    bench.settle();
    bench.fault(sim::FaultKind::Reverse);
    ASSERT_TRUE(bench.perform(intent::ApplyGains{startingGains({})}));
    ASSERT_TRUE(bench.perform(intent::Enable{}));
    const auto recipe = firstRecipe(bench.module().info.identity);
    EXPECT_EQ(bench.run(intent::Home{recipe}).failure, ProcedureFailure::WentOff);
    EXPECT_FALSE(bench.truth().servoOn);
    // A quarter of 24 V gives at most 158 rad/s; from there, 0.004 N·m brakes 1.7e-5 kg·m² within 53 rad,
    // which is 17 000 counts, after the 500 counts of EL.
    EXPECT_LT(std::abs(bench.truth().shaftCounts), 17'500);
}

}  // namespace
}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Homing used as a safety stop (DS-V 5.2), because the limit inputs of a PIC-SERVO do not stop the motor by
// themselves.
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Stop = HomingRecipe::Stop;
using Watch = HomeWatch::State;

class LimitStop : public testing::Test {
protected:
    [[nodiscard]] bool runInto(const intent::ArmLimitStop& arm) {
        bench.putSwitch(sim::Input::Limit2, 900, false);
        if (!bench.enable() || !bench.perform(arm))
            return false;
        EXPECT_EQ(bench.module().homing.state(), Watch::Armed);
        if (!bench.perform(intent::Move{
                servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(6'554), false}}))
            return false;
        bench.bus.runFor(2s);
        bench.take();
        return true;
    }
    ServoBench bench;
};

TEST_F(LimitStop, StopsTheMotorAtTheLimitAndShowsIt) {
    ASSERT_TRUE(runInto({false, true, Stop::Abruptly}));
    EXPECT_EQ(bench.module().homing.state(), Watch::Tripped);
    EXPECT_TRUE(bench.module().homing.onLimit2());
    EXPECT_FALSE(bench.module().homing.onLimit1());
    EXPECT_NEAR(bench.truth().position, 900, 40);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
    EXPECT_FALSE(bench.module().moving());
    EXPECT_EQ(bench.module().activity(), Activity::Holding);
    bench.bus.expectNoViolations();
}

TEST_F(LimitStop, MayAlsoSwitchTheMotorOffWhichIsNoTrip) {
    ASSERT_TRUE(runInto({true, true, Stop::Off}));
    EXPECT_EQ(bench.module().homing.state(), Watch::Tripped);
    EXPECT_FALSE(bench.truth().servoOn);
    EXPECT_EQ(bench.module().activity(), Activity::ServoOff);
    bench.bus.expectNoViolations();
}

TEST_F(LimitStop, IsNotThereWhenItWasTakenAway) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.perform(intent::ArmLimitStop{true, false, Stop::Smoothly}));
    EXPECT_EQ(bench.module().homing.state(), Watch::Armed);
    ASSERT_TRUE(bench.perform(intent::ArmLimitStop{}));
    EXPECT_EQ(bench.module().homing.state(), Watch::Idle);
    EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
}

TEST_F(LimitStop, AHomeSearchReplacesIt) {
    bench.putSwitch(sim::Input::Limit1, -600, true);
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.perform(intent::ArmLimitStop{false, true, Stop::Abruptly}));
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    EXPECT_EQ(bench.run(intent::Home{recipe}).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.module().homing.state(), Watch::Idle);
}

TEST_F(LimitStop, IsRefusedWhereItCannotWork) {
    ASSERT_TRUE(bench.enable());
    bench.set(sim::Input::Limit1, 1);
    bench.settle();
    EXPECT_EQ(plan(intent::ArmLimitStop{true, false, Stop::Abruptly}, bench.module()).error(),
              Refusal::LimitActive);
    EXPECT_TRUE(plan(intent::ArmLimitStop{false, true, Stop::Abruptly}, bench.module()).has_value());
    ServoBench old(2);
    ASSERT_TRUE(old.enable());
    EXPECT_EQ(plan(intent::ArmLimitStop{true, false, Stop::Abruptly}, old.module()).error(),
              Refusal::VersionLacksIt);
}

}  // namespace
}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2 Set Homing Mode: the simulator's behaviour beyond the statements of the data sheet, which
// tests/conformance covers.
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;

class HomingSearch : public testing::Test {
protected:
    HomingSearch() {
        wire.address(1);
        wire.enableAmplifier();
        wire.gains(goodGains(500));
        wire.servoOn();
        wire.command(1, 0x0B);
    }
    HostWire wire;
};

TEST_F(HomingSearch, AMotorThatIsOffAndStandsStillIsWatchedToo) {
    wire.command(1, 0x17, {0x03});
    wire.wait(milliseconds(500));
    wire.command(1, 0x19, {0x01});
    wire.wait(milliseconds(100));
    wire.command(1, 0x18, {0x09});  // limit 1 an output, high
    wire.waitTicks(2);
    EXPECT_FALSE(wire.report().homeInProgress());
}

TEST_F(HomingSearch, NothingFlaggedCancelsTheSearch) {
    wire.command(1, 0x19, {0x01});
    EXPECT_TRUE(wire.report().homeInProgress());
    wire.command(1, 0x19, {0x00});
    EXPECT_FALSE(wire.report().homeInProgress());
    wire.set(Input::Limit1, 1);
    wire.waitTicks(5);
    EXPECT_EQ(wire.report().home, 0);
}

TEST_F(HomingSearch, FindsTheIndexOnceInATurn) {
    wire.velocity(kOne / 2, kOne);
    wire.waitTicks(50);
    ASSERT_GT(wire.report().position, 5) << "off the index it starts on";
    wire.command(1, 0x19, {0x18});
    wire.wait(milliseconds(1500));
    EXPECT_TRUE(wire.report().homeInProgress());
    wire.wait(milliseconds(1500));
    const Report r = wire.report();
    EXPECT_FALSE(r.homeInProgress());
    EXPECT_EQ(r.home, 2000);
    EXPECT_NEAR(r.position, 2000, 4);
}

TEST_F(HomingSearch, TheIndexStaysWithTheShaftWhenThePositionIsReset) {
    wire.trapezoid(700, 2 * kOne, kOne);
    wire.wait(milliseconds(400));
    wire.command(1, 0x00);
    const double shift = wire.truth().servo.shaftCounts - wire.truth().servo.position;
    wire.velocity(kOne / 2, kOne);
    wire.command(1, 0x19, {0x18});
    wire.wait(milliseconds(2000));
    EXPECT_NEAR(wire.report().home + shift, 2000, 1);
}

TEST_F(HomingSearch, TheAuxiliaryBitIsTheComplementOfTheIndex) {
    EXPECT_EQ(wire.report().auxiliary & 1U, 0U) << "the shaft is at its index";
    wire.trapezoid(100, 2 * kOne, kOne);
    wire.wait(milliseconds(300));
    EXPECT_EQ(wire.report().auxiliary & 1U, 1U);
    wire.command(1, 0x17, {0x03});
    wire.wait(milliseconds(100));
    wire.set(Input::Index, 1);
    EXPECT_EQ(wire.report().auxiliary & 1U, 0U);
    wire.servoOn();
    wire.velocity(kOne, kOne);
    wire.waitTicks(30);
    EXPECT_EQ(wire.report().auxiliary & 1U, 1U) << "the motion decides again";
}

TEST_F(HomingSearch, CurrentLimitingCanBeHomeToo) {
    wire.set(Input::TravelMax, 400);
    wire.gains(gainData(200, 2000, 20, 200, 255, 101, 0x3FFF, 1, 0));
    wire.velocity(kOne, kOne / 100);
    wire.command(1, 0x19, {0x90});
    wire.wait(milliseconds(600));
    const Report r = wire.report();
    EXPECT_FALSE(r.homeInProgress());
    EXPECT_NEAR(r.home, 400, 1);
    EXPECT_TRUE(r.overcurrent());
    EXPECT_EQ(wire.truth().servo.commandVelocity, 0);
}

TEST_F(HomingSearch, LimitsFollowTheTravelWhenTheyAreAutomatic) {
    wire.set(Input::TravelMin, -100);
    wire.set(Input::TravelMax, 300);
    wire.set(Input::Limits, 1);
    EXPECT_EQ(wire.report().status & 0x60U, 0U);
    wire.velocity(kOne, kOne);
    wire.command(1, 0x19, {0x12});
    wire.wait(milliseconds(500));
    Report r = wire.report();
    EXPECT_EQ(r.home, 300);
    wire.velocity(-std::int64_t{kOne}, kOne);
    wire.command(1, 0x19, {0x11});
    wire.wait(milliseconds(500));
    r = wire.report();
    EXPECT_EQ(r.home, -100);
    EXPECT_EQ(r.status & 0x60U, 0x20U);
    wire.set(Input::Limits, 0);
    EXPECT_EQ(wire.report().status & 0x60U, 0U);
}

}  // namespace
}  // namespace nmc::sim::test

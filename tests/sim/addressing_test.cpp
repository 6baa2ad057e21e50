// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 4.1 Addressing, Group Commands, Network Initialization: the simulator's behaviour beyond the
// statements, which tests/conformance covers.
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;

TEST(Addressing, AModuleIsDeafForItsDeadTimeAndThenAnswersAtAddress0WithItsStatusByteOnly) {
    Chain chain(parseChain("servo").value());
    chain.hostSends(packet(0, 0x0E), TimePoint{});
    chain.advanceTo(TimePoint{} + milliseconds(7));
    EXPECT_TRUE(chain.takeHostBytes().empty());
    HostWire wire;
    EXPECT_EQ(wire.command(0, 0x0E), kIdle);
}

TEST(Addressing, ThirtyTwoModulesGetTheirAddresses) {
    std::string spec = "servo";
    for (int i = 1; i < 32; ++i)
        spec += ",servo";
    HostWire wire(spec);
    wire.address(32);
    for (unsigned i = 1; i <= 32; ++i)
        EXPECT_EQ(wire.command(i, 0x0E), kIdle) << i;
    EXPECT_TRUE(wire.command(33, 0x0E).empty());
}

TEST(Addressing, AHardResetToTheGroupResetsEverybodySilentlyAndTheFarthestIsFirstAgain) {
    HostWire wire("servo@1,servo");
    wire.address(2);
    EXPECT_TRUE(wire.command(0xFF, 0x0F).empty());
    EXPECT_TRUE(wire.command(0, 0x0E).empty()) << "dead time";
    wire.wait(milliseconds(10));
    EXPECT_TRUE(wire.command(1, 0x0E).empty());
    EXPECT_EQ(wire.command(0, 0x13, {0x20}), (Bytes{0x19, 0, 1, 0x1A}));
    wire.address(2);
    EXPECT_EQ(wire.command(2, 0x0E), kIdle);
}

TEST(Addressing, AHardResetToFFMissesAServoOfAnotherGroup) {
    HostWire wire("servo,servo");
    wire.address(2);
    wire.command(2, 0x21, {2, 0x85});
    wire.command(0xFF, 0x0F);
    wire.wait(milliseconds(10));
    EXPECT_EQ(wire.command(2, 0x0E), kIdle);
    EXPECT_TRUE(wire.command(1, 0x0E).empty());
}

TEST(Addressing, ABrokenAddressLineHidesTheModulesTowardsTheHost) {
    HostWire wire("servo,servo");
    wire.chain.breakAddressLine(ModuleIndex(0), wire.now);
    wire.address(1);
    EXPECT_TRUE(wire.command(0, 0x21, {2, 0xFF}).empty());
    wire.chain.mendAddressLine(ModuleIndex(0), wire.now);
    EXPECT_EQ(wire.command(0, 0x21, {2, 0xFF}), kIdle);
    wire.chain.breakAddressLine(ModuleIndex(0), wire.now);
    EXPECT_EQ(wire.command(2, 0x0E), kIdle) << "it is awake already";
}

TEST(Addressing, AModuleThatWatchesItsPinGoesDeafWhenAddrInRises) {
    ChainOptions options;
    options.deafWhenAddressInputRises = true;
    HostWire wire("servo,servo", options);
    wire.address(2);
    wire.chain.breakAddressLine(ModuleIndex(0), wire.now);
    EXPECT_TRUE(wire.command(2, 0x0E).empty());
    wire.chain.mendAddressLine(ModuleIndex(0), wire.now);
    EXPECT_EQ(wire.command(2, 0x0E), kIdle);
}

TEST(Addressing, APowerCycleForgetsTheAddressAndThePositionButTheShaftStays) {
    HostWire wire;
    wire.address(1);
    wire.enableAmplifier();
    wire.pwm(100);
    wire.wait(milliseconds(100));
    ASSERT_GT(wire.report().position, 100);
    wire.chain.powerCycle(ModuleIndex(0), wire.now);
    wire.wait(milliseconds(500));
    EXPECT_TRUE(wire.command(1, 0x0E).empty());
    wire.address(1);
    EXPECT_GT(wire.truth().servo.shaftCounts, 100);
    EXPECT_LT(wire.truth().servo.position, wire.truth().servo.shaftCounts - 100);
    EXPECT_FALSE(wire.truth().servo.ampEnabled);
}

}  // namespace
}  // namespace nmc::sim::test

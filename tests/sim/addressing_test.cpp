// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 4.1 Addressing, Group Commands, Network Initialization.
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

TEST(Addressing, OnlyTheFarthestModuleListensUntilItsAddressIsSet) {
    HostWire wire("servo@1,servo@2,servo@3");
    EXPECT_EQ(wire.command(0, 0x13, {0x20}), (Bytes{0x19, 0, 1, 0x1A}));
    EXPECT_EQ(wire.command(0, 0x21, {7, 0xFF}), kIdle);
    EXPECT_EQ(wire.command(0, 0x13, {0x20}), (Bytes{0x19, 0, 2, 0x1B}));
    EXPECT_EQ(wire.command(0, 0x21, {8, 0xFF}), kIdle);
    EXPECT_EQ(wire.command(0, 0x21, {9, 0xFF}), kIdle);
    EXPECT_TRUE(wire.command(0, 0x0E).empty()) << "no module without an address is left";
    EXPECT_EQ(wire.command(7, 0x13, {0x20}), (Bytes{0x19, 0, 1, 0x1A}));
    EXPECT_EQ(wire.command(8, 0x13, {0x20}), (Bytes{0x19, 0, 2, 0x1B}));
    EXPECT_EQ(wire.command(9, 0x13, {0x20}), (Bytes{0x19, 0, 3, 0x1C}));
    EXPECT_TRUE(wire.violations().empty());
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

TEST(Addressing, AGroupCommandIsExecutedByEveryMemberAndNobodyAnswersWithoutALeader) {
    HostWire wire("servo,servo");
    wire.address(2);
    EXPECT_TRUE(wire.command(0xFF, 0x12, {0x20}).empty());
    EXPECT_EQ(wire.command(1, 0x0E).size(), 4U);
    EXPECT_EQ(wire.command(2, 0x0E).size(), 4U);
}

TEST(Addressing, TheLeaderAnswersAGroupCommandWithItsOwnItems) {
    HostWire wire("servo@2,servo@3,servo");
    wire.address(3);
    wire.command(1, 0x21, {1, 0x81});  // member
    wire.command(2, 0x21, {2, 0x01});  // leader: bit 7 is set by the module
    wire.command(2, 0x12, {0x20});
    EXPECT_EQ(wire.command(0x81, 0x0E), (Bytes{0x19, 0, 3, 0x1C}));
    EXPECT_TRUE(wire.command(0xFF, 0x0E).empty()) << "3 is still in group FF, without a leader";
    EXPECT_TRUE(wire.truth(2).leader);
    EXPECT_EQ(wire.truth(2).group, 0x81);
    EXPECT_FALSE(wire.truth(1).leader);
    wire.command(2, 0x21, {2, 0x81});
    EXPECT_TRUE(wire.command(0x81, 0x0E).empty()) << "no longer leader";
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

TEST(Addressing, TheInitialisationOfTheDataSheetWorksAndIsNoViolation) {
    HostWire wire("servo,servo");
    wire.exchange(Bytes(16, 0));
    wire.wait(milliseconds(1));
    wire.address(2);
    EXPECT_EQ(wire.command(1, 0x13, {0x20}).size(), 4U);
    EXPECT_EQ(wire.command(2, 0x13, {0x20}).size(), 4U);
    EXPECT_TRUE(wire.command(0xFF, 0x1A, {10}).empty());
    wire.chain.setHostBaud(115'200);
    EXPECT_EQ(wire.command(1, 0x0E), kIdle);
    EXPECT_EQ(wire.command(2, 0x0E), kIdle);
    EXPECT_TRUE(wire.violations().empty());
}

}  // namespace
}  // namespace nmc::sim::test

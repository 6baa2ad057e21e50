// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 4.1: addresses, groups and the start of a network; 5.2: Set Address, Set Baud Rate.
#include <gmock/gmock.h>

#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

class PicServoNetwork : public PicServo {
protected:
    Bytes setAddress(unsigned at, unsigned address, unsigned group) {
        return rig->command(at, 0x21, {static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(group)});
    }
    Bytes nop(unsigned at) { return rig->command(at, 0x0E); }
    bool listens(int module) { return rig->state(module)["listening"]; }
    /// Sets the rate of every module of the chain, and then that of the host.
    void setBaud(unsigned divisor, unsigned baud) {
        EXPECT_EQ(rig->command(0xFF, 0x1A, {static_cast<std::uint8_t>(divisor)}), Bytes{});
        rig->setBaud(baud);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoNetwork, kPlaces, nameOf);

TEST_P(PicServoNetwork, SetAddress1_TheFirstByteIsTheIndividualAddress) {
    EXPECT_EQ(setAddress(1, 42, 0xFF), kIdle);
    EXPECT_EQ(nop(42), kIdle);
    EXPECT_EQ(nop(1), Bytes{});
    expectNoViolation();
}

TEST_P(PicServoNetwork, SetAddress2_TheSecondByteIsTheGroupAddress) {
    setAddress(1, 1, 0x95);
    rig->command(0x95, 0x12, {0x20});
    EXPECT_EQ(nop(1).size(), 4U) << "it has received the command as a member";
    rig->command(0xFF, 0x12, {0x00});
    EXPECT_EQ(nop(1).size(), 4U) << "it is no longer a member of FF";
}

TEST_P(PicServoNetwork, SetAddress3_BothHaveInitialValues) {
    make("servo");
    EXPECT_EQ(nop(0), kIdle);
    rig->command(0xFF, 0x12, {0x20});
    EXPECT_EQ(nop(0).size(), 4U);
}

TEST_P(PicServoNetwork, SetAddress4_ABit7OfTheGroupThatIsClearMakesALeaderAndIsSetByTheModule) {
    setAddress(1, 1, 0x15);
    EXPECT_EQ(truth("group"), 0x95);
    EXPECT_EQ(truth("leader"), true);
    EXPECT_EQ(nop(0x95), kIdle);
    EXPECT_EQ(nop(0x15), Bytes{});
}

TEST_P(PicServoNetwork, SetAddress5_ABit7OfTheGroupThatIsSetMakesAMember) {
    setAddress(1, 1, 0x15);
    setAddress(1, 1, 0x95);
    EXPECT_EQ(truth("group"), 0x95);
    EXPECT_EQ(truth("leader"), false);
    EXPECT_EQ(nop(0x95), Bytes{});
}

TEST_P(PicServoNetwork, SetAddress6_TheFirstOneEnablesTheNextModuleOfTheChain) {
    make("servo,servo");
    nop(0);
    rig->command(0, 0x12, {0x20});
    EXPECT_FALSE(listens(2));
    setAddress(0, 1, 0xFF);
    EXPECT_TRUE(listens(2));
    setAddress(1, 5, 0xFF);
    EXPECT_TRUE(listens(2)) << "later ones do not change this";
    EXPECT_EQ(nop(0), kIdle) << "the second module";
}

TEST_P(PicServoNetwork, Addressing1_AtPowerUpOnlyTheModuleFarthestFromTheHostListensAtAddress00) {
    make("servo,servo,servo");
    EXPECT_EQ(nop(0), kIdle) << "one reply, no collision";
    for (int module = 1; module <= 3; ++module) {
        EXPECT_EQ(rig->state(module)["address"], 0);
        EXPECT_EQ(listens(module), module == 1);
    }
    expectNoViolation();
}

TEST_P(PicServoNetwork, Addressing2_ModuleByModuleGetsItsAddressTowardsTheHost) {
    make("servo@1,servo@2,servo@3");
    for (unsigned i = 1; i <= 3; ++i) {
        EXPECT_EQ(setAddress(0, i, 0xFF), kIdle);
        EXPECT_EQ(byteAt(rig->command(i, 0x13, {0x20}), 2), i) << "the version tells them apart";
    }
    expectNoViolation();
}

TEST_P(PicServoNetwork, Addressing3_TheHostFindsOutHowManyModulesThereAre) {
    make("servo,servo,servo");
    unsigned found = 0;
    while (found < 10 && !setAddress(0, found + 1, 0xFF).empty())
        ++found;
    EXPECT_EQ(found, 3U);
}

TEST_P(PicServoNetwork, Addressing4_AnIndividualAddressMayHaveAnyValue) {
    unsigned at = 1;
    for (const unsigned next : {0x00U, 0x7FU, 0x80U, 0xAAU, 0xFEU, 0xFFU}) {
        setAddress(at, next, 0x81);
        EXPECT_EQ(nop(next), kIdle) << next;
        at = next;
    }
}

TEST_P(PicServoNetwork, Addressing5_AGroupAddressIsAlwaysFrom128To255) {
    for (const unsigned group : {0x00U, 0x01U, 0x7FU, 0x80U, 0xFEU}) {
        setAddress(1, 1, group);
        EXPECT_EQ(truth("group"), group | 0x80U);
    }
}

TEST_P(PicServoNetwork, Addressing6_AGroupCommandIsExecutedByEveryMemberAndByNobodyElse) {
    start("servo,servo,servo", 3);
    setAddress(1, 1, 0x81);
    setAddress(2, 2, 0x81);
    setAddress(3, 3, 0x82);
    EXPECT_EQ(rig->command(0x81, 0x12, {0x20}), Bytes{}) << "members do not answer";
    EXPECT_EQ(nop(1).size(), 4U);
    EXPECT_EQ(nop(2).size(), 4U);
    EXPECT_EQ(nop(3).size(), 2U);
    expectNoViolation();
}

TEST_P(PicServoNetwork, Addressing7_TheLeaderAnswersAGroupCommandAsOneToItself) {
    start("servo@1,servo@2", 2);
    setAddress(1, 1, 0x81);
    setAddress(2, 2, 0x01);
    rig->command(2, 0x12, {0x20});
    EXPECT_EQ(nop(0x81), nop(2));
    EXPECT_EQ(nop(0x81), (Bytes{0x19, 0, 2, 0x1B}));
    EXPECT_EQ(statistics("executed", 1)["nop"], 2) << "the member has executed both";
    expectNoViolation();
}

TEST_P(PicServoNetwork, Addressing8_AGroupHasOneLeaderAtMost) {
    start("servo,servo", 2);
    setAddress(1, 1, 0x01);
    setAddress(2, 2, 0x01);
    nop(0x81);
    EXPECT_THAT(rig->violations(), testing::Contains("reply_collision"));
}

TEST_P(PicServoNetwork, Addressing9_GroupsMayBeReassignedAtAnyTime) {
    for (const unsigned group : {0x90U, 0x11U, 0x92U}) {
        setAddress(1, 1, group);
        EXPECT_EQ(nop(0x90 | (group & 0x0F)).size(), group < 0x80 ? 2U : 0U);
        rig->command(group | 0x80U, 0x0C);
    }
    EXPECT_EQ(statistics("executed")["save_as_home"], 3);
    expectNoViolation();
}

TEST_P(PicServoNetwork, Addressing10_TheIndividualAddressesMustBeUnique) {
    make("servo,servo");
    setAddress(0, 1, 0xFF);
    setAddress(0, 1, 0xFF);
    expectNoViolation();
    nop(1);
    EXPECT_THAT(rig->violations(), testing::Contains("reply_collision"));
}

TEST_P(PicServoNetwork, Addressing11_TheSheetsProcedureBringsUpANetwork) {
    make("servo,servo@2,servo@3");
    rig->send(Bytes(16, 0x00));
    rig->wait(milliseconds(20));
    const std::vector<unsigned> versions{4, 2, 3};
    for (unsigned i = 1; i <= 3; ++i) {
        EXPECT_EQ(setAddress(0, i, 0xFF), kIdle);
        EXPECT_EQ(byteAt(rig->command(i, 0x13, {0x20}), 1), 0U);
        EXPECT_EQ(byteAt(rig->command(i, 0x13, {0x20}), 2), versions[i - 1]);
    }
    EXPECT_EQ(setAddress(0, 4, 0xFF), Bytes{}) << "there are no more modules";
    setBaud(10, 115'200);
    for (unsigned i = 1; i <= 3; ++i) {
        EXPECT_EQ(nop(i), kIdle);
        EXPECT_EQ(setAddress(i, i, i == 1 ? 0x01 : 0x81), kIdle);
    }
    EXPECT_EQ(nop(0x81), kIdle);
    expectNoViolation();
}

TEST_P(PicServoNetwork, SetBaudRate1_TheDivisorsOfTheSheetGiveItsRates) {
    const auto rate = [this](unsigned divisor, unsigned baud) {
        start("servo", 1);
        setBaud(divisor, baud);
        return truth("baud").get<double>();
    };
    EXPECT_NEAR(rate(129, 9'600), 9'600, 0.02 * 9'600);
    EXPECT_EQ(nop(1), kIdle);
    EXPECT_NEAR(rate(63, 19'200), 19'200, 0.02 * 19'200);
    EXPECT_EQ(nop(1), kIdle);
    EXPECT_NEAR(rate(10, 115'200), 115'200, 0.02 * 115'200);
    EXPECT_EQ(nop(1), kIdle);
    // 3.3 % off, which a receiver tolerates (simulator.md).
    EXPECT_NEAR(rate(20, 57'600), 57'600, 0.04 * 57'600);
    EXPECT_EQ(nop(1), kIdle);
}

TEST_P(PicServoNetwork, SetBaudRate2_OtherDivisorsGiveTheClockOver16OverTheDivisorPlus1) {
    setBaud(31, 38'400);
    EXPECT_EQ(truth("baud"), 39'063) << "20 MHz / 16 / 32";
    EXPECT_EQ(nop(1), kIdle);
    setBaud(21, 57'600);
    EXPECT_EQ(truth("baud"), 56'818) << "20 MHz / 16 / 22";
    EXPECT_EQ(nop(1), kIdle);
    setBaud(64, 19'200);
    EXPECT_EQ(truth("baud"), 19'231) << "20 MHz / 16 / 65";
    EXPECT_EQ(nop(1), kIdle);
}

TEST_P(PicServoNetwork, SetBaudRate3_AllModulesChangeAtTheSameTime) {
    start("servo,servo,servo", 3);
    setBaud(10, 115'200);
    for (unsigned i = 1; i <= 3; ++i)
        EXPECT_EQ(nop(i), kIdle);
    expectNoViolation();
}

TEST_P(PicServoNetwork, SetBaudRate4_IsForAGroupOnly) {
    rig->command(1, 0x1A, {10});
    expectViolation("set_baud_single");
}

TEST_P(PicServoNetwork, SetBaudRate5_AReplyIsAtTheNewRate) {
    setAddress(1, 1, 0x7F);
    rig->send(packet(0xFF, 0x1A, {10}));
    // The command's five bytes at 19 200 Bd, at most a tick, and two bytes at 113 636: at the old rate these
    // alone would take 1 ms.
    const Bytes answer = rig->wait(microseconds(2'605) + kTick + microseconds(177));
    EXPECT_EQ(answer.size(), 2U);
    EXPECT_NE(answer, kIdle) << "a host that has not followed cannot read it";
    rig->setBaud(115'200);
    EXPECT_EQ(nop(0xFF), kIdle);
}

TEST_P(PicServoNetwork, SetBaudRate6_WithoutALeaderThereIsNoReply) {
    EXPECT_EQ(rig->command(0xFF, 0x1A, {64}), Bytes{});
    EXPECT_EQ(nop(1), kIdle);
    expectNoViolation();
}

TEST_P(PicServoNetwork, SetBaudRate7_FasterThan115200AtLowerServoRatesOnly) {
    gains({.sr = 2});
    rig->command(0xFF, 0x1A, {5});
    expectNoViolation();
    start("servo", 1);
    rig->command(0xFF, 0x1A, {5});
    expectViolation("out_of_range");
}

}  // namespace
}  // namespace nmc::conformance

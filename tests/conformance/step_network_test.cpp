// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1: Set Address, Set Baud Rate, Hard Reset.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

const Bytes kDisabled{0x08, 0x08};
const Bytes kEnabled{0x0C, 0x0C};

class PicStepNetwork : public PicStep {
protected:
    unsigned outputs(int module = 1) { return rig->state(module)["outputs"].get<unsigned>(); }
    /// Sets the rate of all modules, which do not answer; then sends No Operation at the host's new rate.
    void expectRate(std::uint8_t divisor, unsigned hostBaud) {
        EXPECT_TRUE(rig->command(0xFF, 0x1A, {divisor}).empty());
        rig->setBaud(hostBaud);
        EXPECT_EQ(command(0x0E), kEnabled) << hostBaud;
        expectNoViolations();
    }
};

INSTANTIATE_TEST_SUITE_P(, PicStepNetwork, kPlaces, nameOf);

TEST_P(PicStepNetwork, SetAddress1_IsCommand1WithTwoBytes) {
    expectForm("set_address", 0x21, {1, 0xFF});
}

TEST_P(PicStepNetwork, SetAddress2_TheFirstByteIsTheIndividualAddressFrom0ToFF) {
    unsigned last = 1;
    for (const unsigned next : {0x7FU, 0x80U, 0xFEU, 0x00U, 0x20U}) {
        ASSERT_EQ(rig->command(last, 0x21, {static_cast<std::uint8_t>(next), 0xFF}), kEnabled);
        EXPECT_EQ(rig->command(next, 0x0E), kEnabled);
        EXPECT_TRUE(rig->command(last, 0x0E).empty()) << last;
        last = next;
    }
}

TEST_P(PicStepNetwork, SetAddress3_TheInitialIndividualAddressIs0) {
    powerUp();
    EXPECT_EQ(rig->command(0, 0x0E), kDisabled);
}

TEST_P(PicStepNetwork, SetAddress4_TheInitialGroupAddressIsFF) {
    powerUp();
    EXPECT_TRUE(rig->command(0xFF, 0x18, {0x03}).empty()) << "not the leader";
    EXPECT_EQ(outputs(), 0x03U);
    rig->command(0xFE, 0x18, {0x04});
    EXPECT_EQ(outputs(), 0x03U);
}

TEST_P(PicStepNetwork, SetAddress5_GroupAddressesAreAlwaysFrom80ToFF) {
    for (const unsigned group : {0x80U, 0x85U, 0xFFU, 0x05U}) {
        command(0x21, {1, static_cast<std::uint8_t>(group)});
        rig->command(group | 0x80U, 0x18, {static_cast<std::uint8_t>(group & 0x0FU)});
        EXPECT_EQ(outputs(), group & 0x0FU);
        EXPECT_EQ(truth<unsigned>("group"), group | 0x80U);
    }
}

TEST_P(PicStepNetwork, SetAddress6_WithBit7ClearTheModuleLeadsTheGroupWithBit7Set) {
    command(0x21, {1, 0x05});
    EXPECT_EQ(rig->command(0x85, 0x0E), kEnabled);
    EXPECT_TRUE(rig->command(0x05, 0x0E).empty());
}

TEST_P(PicStepNetwork, SetAddress7_WithBit7SetTheModuleIsAMemberWhichStaysSilent) {
    command(0x21, {1, 0x05});
    command(0x21, {1, 0x85});
    EXPECT_TRUE(rig->command(0x85, 0x18, {0x03}).empty());
    EXPECT_EQ(outputs(), 0x03U);
}

TEST_P(PicStepNetwork, SetAddress8_TheFirstAfterPowerUpOrResetEnablesTheNextModule) {
    powerUp("step,step");
    for (const bool afterReset : {false, true}) {
        if (afterReset)
            rig->command(0xFF, 0x0F);
        rig->waitTicks(20);
        EXPECT_FALSE(rig->state(2)["listening"].get<bool>());
        ASSERT_EQ(rig->command(0, 0x21, {1, 0xFF}), kDisabled);
        EXPECT_TRUE(rig->state(2)["listening"].get<bool>());
        ASSERT_EQ(rig->command(0, 0x21, {2, 0xFF}), kDisabled);
    }
    expectNoViolations();
}

// ---- Set Baud Rate ----

TEST_P(PicStepNetwork, SetBaudRate1_IsCommandAWithOneByte) {
    expectForm("set_baud", 0x1A, {63}, 0xFF);
}
TEST_P(PicStepNetwork, SetBaudRate2_Divisor129Is9600) {
    expectRate(129, 9'600);
}
TEST_P(PicStepNetwork, SetBaudRate3_Divisor63Is19200) {
    expectRate(10, 115'200);
    expectRate(63, 19'200);
}

// 1 250 000 / 21 = 59 524 is 3.3 % off: the sheet's code for 57 600 is one that real lines garble.
TEST_P(PicStepNetwork, SetBaudRate4_Divisor20IsNear57600) {
    rig->command(0xFF, 0x1A, {20});
    EXPECT_EQ(truth<int>("baud"), 59'524);
    expectNoViolations();
}

TEST_P(PicStepNetwork, SetBaudRate5_Divisor10Is115200) {
    expectRate(10, 115'200);
}

// SPBRG with BRGH = 1: 20 MHz / (16 (BRD + 1)).
TEST_P(PicStepNetwork, SetBaudRate6_TheDivisorIsProgrammedAsItIs) {
    expectRate(64, 19'200);
    EXPECT_EQ(truth<int>("baud"), 19'231);
    expectRate(21, 57'600);
    EXPECT_EQ(truth<int>("baud"), 56'818);
}

TEST_P(PicStepNetwork, SetBaudRate7_IsOnlyForAGroupOfAllControllers) {
    expectRate(10, 115'200);
    command(0x1A, {10});
    expectViolations({"set_baud_single"});
}

TEST_P(PicStepNetwork, SetBaudRate8_AllModulesOfTheGroupChangeAtOnce) {
    fresh("step,step,step");
    rig->command(0xFF, 0x1A, {10});
    rig->setBaud(115'200);
    EXPECT_EQ(rig->command(1, 0x0E), kEnabled);
    EXPECT_EQ(rig->command(2, 0x0E), kDisabled);
    EXPECT_EQ(rig->command(3, 0x0E), kDisabled);
    expectNoViolations();
}

TEST_P(PicStepNetwork, SetBaudRate9_AStatusPacketComesAtTheNewRate) {
    command(0x21, {1, 0x7F});  // the leader of FF
    rig->send(packet(0xFF, 0x1A, {10}));
    rig->setBaud(115'200);
    EXPECT_EQ(rig->wait(milliseconds(20)), kEnabled);
}

TEST_P(PicStepNetwork, SetBaudRate10_WithoutALeaderThereIsNoStatusPacket) {
    EXPECT_TRUE(rig->command(0xFF, 0x1A, {63}).empty());
    EXPECT_EQ(command(0x0E), kEnabled);
}

TEST_P(PicStepNetwork, SetBaudRate11_115200IsTheFastest) {
    rig->command(0xFF, 0x1A, {9});
    expectViolations({"out_of_range"});
}

// ---- Hard Reset ----

TEST_P(PicStepNetwork, HardReset1_IsCommandFWithoutDataAndStatus) {
    EXPECT_TRUE(command(0x0F).empty());
    EXPECT_EQ(rig->control("stats")["modules"][0]["executed"]["hard_reset"], 1);
    rig->waitTicks(20);
    rig->address(1);
    expectNoViolations();
    EXPECT_TRUE(command(0x1F, {0}).empty());
    expectViolations({"wrong_length"});
}

TEST_P(PicStepNetwork, HardReset2_ReturnsTheModuleToItsPowerUpState) {
    powerUp();
    auto before = rig->state();
    rig->address(1);
    parameters(k1x, 1, 200, 80);
    stop(0x01);
    command(0x18, {0x03});
    command(0x19, {0x08});
    run();
    command(0x12, {0x3F});
    rig->wait(seconds(1));
    command(0x0F);
    rig->waitTicks(20);
    const auto after = rig->state();
    for (const char* outside : {"time", "tick", "shaft"})
        before[outside] = after[outside];
    EXPECT_EQ(after, before);
    EXPECT_EQ(rig->command(0, 0x0E), kDisabled);
}

TEST_P(PicStepNetwork, HardReset3_ToTheGroupResetsAllModules) {
    fresh("step,step");
    EXPECT_TRUE(rig->command(0xFF, 0x0F).empty());
    rig->waitTicks(20);
    for (const int module : {1, 2})
        EXPECT_EQ(rig->state(module)["address"], 0);
    EXPECT_TRUE(rig->command(2, 0x0E).empty());
    expectNoViolations();
}

TEST_P(PicStepNetwork, HardReset4_ToFFIsObeyedWhateverTheGroup) {
    command(0x21, {1, 0x85});
    rig->command(0xFF, 0x18, {0x03});
    EXPECT_EQ(outputs(), 0x10U) << "no other command to FF is obeyed";
    EXPECT_TRUE(rig->command(0xFF, 0x0F).empty());
    rig->waitTicks(20);
    EXPECT_EQ(truth<int>("address"), 0);
    EXPECT_EQ(rig->command(0, 0x0E), kDisabled);
}

}  // namespace
}  // namespace nmc::conformance

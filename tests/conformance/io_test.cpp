// SPDX-License-Identifier: GPL-3.0-or-later
// The PIC-I/O: its whole command table, its items and its pins.
#include "tests/conformance/picio.h"

namespace nmc::conformance {
namespace {

using Pwm = std::vector<unsigned>;

constexpr unsigned kAllPins = 0x0FFF;

// ---- Commands ----

TEST_P(PicIo, SetDirection1_Byte1HasIo1To8AndByte2Io9To12OneIsAnInput) {
    output(kAllPins);
    command(0x20, {0xFE, 0x07});
    // IO1 and IO12 are outputs now; what was set while they were inputs was ignored.
    EXPECT_EQ(pins(), 0U);
    output(kAllPins);
    EXPECT_EQ(pins(), 0x0801U);
}

TEST_P(PicIo, SetDirection2_AtPowerUpAllPinsAreInputs) {
    for (unsigned pin = 1; pin <= 12; ++pin) {
        set("in " + std::to_string(pin) + " 1");
        EXPECT_EQ(pins(), (1U << pin) - 1U);
    }
}

TEST_P(PicIo, SetAddress1_GivesAddressAndGroupAndWakesTheNextModule) {
    start("io,io", 0);
    EXPECT_EQ(command(0x21, {5, 0x03}, 0).size(), 2U);
    EXPECT_EQ(truth("address"), 5);
    EXPECT_EQ(truth("group"), 0x83);
    EXPECT_EQ(truth("leader"), true);
    EXPECT_EQ(command(0x21, {6, 0xFF}, 0).size(), 2U);
    EXPECT_EQ(command(0x0E, {}, 0x83).size(), 2U);
}

TEST_P(PicIo, SetPwm1_SetsBothOutputsAtOnce) {
    EXPECT_EQ(pwm(), (Pwm{0, 0}));
    command(0x24, {200, 30});
    EXPECT_EQ(pwm(), (Pwm{200, 30}));
}

TEST_P(PicIo, SynchOutput1_PutsOutWhatWasStored) {
    direction(0);
    output(0x0001);
    synchOutput(0x0F0F, 7, 8);
    command(0x05);
    EXPECT_EQ(pins(), 0x0F0FU);
    EXPECT_EQ(pwm(), (Pwm{7, 8}));
}

TEST_P(PicIo, SynchOutput2_IsForAWholeGroupAtOnce) {
    start("io,io", 0);
    for (const unsigned at : {1U, 2U}) {
        command(0x21, {static_cast<std::uint8_t>(at), 0x90}, 0);
        direction(0, at);
        synchOutput(0x0100 + at, 10 * at, 0, at);
    }
    EXPECT_TRUE(rig->command(0x90, 0x05).empty()) << "no leader";
    EXPECT_EQ(pins(1), 0x0101U);
    EXPECT_EQ(pins(2), 0x0102U);
    EXPECT_EQ(pwm(2), (Pwm{20, 0}));
}

TEST_P(PicIo, SetOutput1_Byte1HasIo1To8AndByte2Io9To12) {
    direction(0);
    command(0x26, {0x21, 0x0A});
    EXPECT_EQ(pins(), 0x0A21U);
    command(0x26, {0x00, 0x00});
    EXPECT_EQ(pins(), 0U);
}

TEST_P(PicIo, SetOutput2_BitsOfInputsAreIgnored) {
    direction(0x0FF0);
    set("in 5 1");
    output(kAllPins);
    EXPECT_EQ(pins(), 0x001FU);
    direction(0);
    EXPECT_EQ(pins(), 0x000FU) << "the other outputs have never been set";
    direction(0x000F);
    output(0);
    direction(0);
    EXPECT_EQ(pins(), 0x000FU) << "these are not reset while they are inputs either";
}

TEST_P(PicIo, SetOutput3_OutputPinsAreReadBackAsInputs) {
    direction(0x0FFE);
    set("in 1 1");
    EXPECT_EQ(pins(), 0U) << "an outside level does not drive an output";
    output(0x0001);
    set("in 1 0");
    EXPECT_EQ(pins(), 1U);
}

TEST_P(PicIo, SetSynchOutput1_OnlyStores) {
    direction(0);
    command(0x24, {1, 2});
    output(0x0003);
    synchOutput(0x0800, 9, 9);
    EXPECT_EQ(pins(), 0x0003U);
    EXPECT_EQ(pwm(), (Pwm{1, 2}));
}

TEST_P(PicIo, SetTimerMode1_ATimerCounts5MHz) {
    timer(0x01);
    const std::uint32_t first = count();
    rig->wait(kTick * 15'625);  // 8 s
    const std::uint32_t second = count();
    // Each query takes another 20 ms; the counts differ by whole ticks of 2560 clocks.
    EXPECT_NEAR(second - first, 8.02 * 5e6, 2 * 2560);
    EXPECT_EQ((second - first) % 2560, 0U);
}

TEST_P(PicIo, SetTimerMode2_ThePrescalerMakesItTwoFourOrEightTimesSlower) {
    for (const unsigned bits : {0U, 1U, 2U, 3U}) {
        timer(0x01 | bits << 4U);
        rig->wait(kTick * 15'625);
        EXPECT_NEAR(count(), 8e6 * 5 / (1U << bits), 250'000.0 / (1U << bits)) << bits;
    }
}

TEST_P(PicIo, SetTimerMode3_ACounterCountsTheRisingEdgesOfIo10) {
    timer(0x03);
    pulse(10, 5);
    pulse(9, 3);
    EXPECT_EQ(count(), 5U);
    set("in 10 1");
    set("in 10 1");
    EXPECT_EQ(count(), 6U) << "a level that stays is no edge";
    rig->wait(std::chrono::seconds(1));
    EXPECT_EQ(count(), 6U);
}

TEST_P(PicIo, SetTimerMode4_WithBit0ClearNothingCounts) {
    timer(0x02);
    pulse(10, 5);
    EXPECT_EQ(count(), 0U);
    timer(0x00);
    rig->wait(std::chrono::seconds(1));
    EXPECT_EQ(count(), 0U);
}

TEST_P(PicIo, SetTimerMode5_SettingTheModeClearsTheCount) {
    timer(0x03);
    pulse(10, 5);
    timer(0x03);
    EXPECT_EQ(count(), 0U);
    pulse(10, 2);
    EXPECT_EQ(count(), 2U);
}

TEST_P(PicIo, SetTimerMode6_ThePrescalerDividesEdgesToo) {
    timer(0x23);
    pulse(10, 11);
    EXPECT_EQ(count(), 2U);
    pulse(10, 1);
    EXPECT_EQ(count(), 3U);
}

TEST_P(PicIo, SetBaudRate1_ChangesTheRateOfAllModules) {
    rig->command(0xFF, 0x1A, {10});
    rig->setBaud(115'200);
    rig->wait(std::chrono::milliseconds(5));
    EXPECT_EQ(command(0x0E), (Bytes{0, 0}));
}

TEST_P(PicIo, SynchInput1_LatchesPinsAndCount) {
    timer(0x03);
    set("in 3 1");
    pulse(10, 4);
    command(0x0C);
    set("in 3 0");
    set("in 12 1");
    pulse(10, 1);
    const Bytes answer = read(0xC0);
    ASSERT_EQ(answer.size(), 8U);
    EXPECT_EQ(wordAt(answer, 1), 0x0004U);
    EXPECT_EQ(longAt(answer, 3), 4);
    EXPECT_EQ(pins(), 0x0800U);
}

TEST_P(PicIo, SynchInput2_IsForAWholeGroupAtOnce) {
    start("io,io", 0);
    for (const unsigned at : {1U, 2U})
        command(0x21, {static_cast<std::uint8_t>(at), 0x90}, 0);
    set("in 1 1", 1);
    set("in 2 1", 2);
    rig->command(0x90, 0x0C);
    set("in 1 0", 1);
    set("in 2 0", 2);
    EXPECT_EQ(wordAt(read(0x40, 1), 1), 1U);
    EXPECT_EQ(wordAt(read(0x40, 2), 1), 2U);
}

TEST_P(PicIo, NoOperation1_OnlyAnswersWithTheDefinedItems) {
    EXPECT_EQ(command(0x0E), (Bytes{0, 0}));
    command(0x12, {0x20});
    EXPECT_EQ(command(0x0E), (Bytes{0, 2, 1, 3}));
}

TEST_P(PicIo, HardReset1_TheGroupMustMatch) {
    command(0x21, {1, 0x85});
    rig->command(0xFF, 0x0F);
    rig->wait(std::chrono::milliseconds(20));
    EXPECT_EQ(truth("address"), 1);
    rig->command(0x85, 0x0F);
    rig->wait(std::chrono::milliseconds(20));
    EXPECT_EQ(truth("address"), 0);
}

TEST_P(PicIo, HardReset2_ReturnsToThePowerUpState) {
    direction(0);
    output(kAllPins);
    command(0x24, {9, 9});
    timer(0x01);
    synchOutput(0x0FFF, 9, 9);
    command(0x0C);
    command(0x12, {0xFF});
    EXPECT_TRUE(command(0x0F).empty()) << "no answer";
    rig->wait(std::chrono::milliseconds(20));
    rig->address(1);
    EXPECT_EQ(read(0xFF), (Bytes{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 3}));
    command(0x05);
    EXPECT_EQ(pwm(), (Pwm{0, 0}));
    direction(0);
    EXPECT_EQ(pins(), 0U);
}

TEST_P(PicIo, UnusedCommands1_9BAndDDoNothing) {
    const nlohmann::json before = truth("pins");
    for (const unsigned code : {0x19U, 0x0BU, 0x0DU})
        command(code, code == 0x19U ? Bytes{0xFF} : Bytes{});
    EXPECT_EQ(truth("pins"), before);
    EXPECT_EQ(rig->violations(), (std::vector<std::string>(3, "unknown_command")));
}

// ---- Status ----

TEST_P(PicIo, DefineStatus1_Item0HasThePinsIo9To12InTheLowNibbleOfTheSecondByte) {
    set("in 2 1");
    set("in 9 1");
    EXPECT_EQ(command(0x12, {0x01}), (Bytes{0, 0x02, 0x01, 0x03}));
}

TEST_P(PicIo, DefineStatus2_Items1To3AreTheAdValues) {
    set("analog 1 10");
    set("analog 2 20");
    set("analog 3 255");
    EXPECT_EQ(command(0x12, {0x02}), (Bytes{0, 10, 10}));
    EXPECT_EQ(command(0x12, {0x04}), (Bytes{0, 20, 20}));
    EXPECT_EQ(command(0x12, {0x08}), (Bytes{0, 255, 255}));
    EXPECT_EQ(command(0x12, {0x0E}), (Bytes{0, 10, 20, 255, 29}));
}

TEST_P(PicIo, DefineStatus3_Item4IsTheCounterInFourBytes) {
    timer(0x03);
    pulse(10, 3);
    EXPECT_EQ(command(0x12, {0x10}), (Bytes{0, 3, 0, 0, 0, 3}));
}

TEST_P(PicIo, DefineStatus4_Item5IsType2AndVersion1) {
    EXPECT_EQ(command(0x12, {0x20}), (Bytes{0, 2, 1, 3}));
}

TEST_P(PicIo, DefineStatus5_Items6And7AreTheLatchedPinsAndCounter) {
    EXPECT_EQ(command(0x12, {0x40}).size(), 4U);
    EXPECT_EQ(command(0x12, {0x80}).size(), 6U);
}

TEST_P(PicIo, DefineStatus6_AllItemsMakeNineteenBytes) {
    EXPECT_EQ(command(0x12, {0xFF}).size(), 19U);
    EXPECT_EQ(command(0x0E).size(), 19U) << "permanent";
}

TEST_P(PicIo, ReadStatus1_ChoosesTheItemsOfOneReply) {
    command(0x12, {0x02});
    EXPECT_EQ(read(0x1F).size(), 11U);
    EXPECT_EQ(command(0x0E).size(), 3U);
}

TEST_P(PicIo, IoStatusByte1_OnlyTheChecksumErrorIsDefined) {
    direction(0);
    output(kAllPins);
    timer(0x01);
    EXPECT_EQ(byteAt(command(0x0E), 0), 0U);
    Bytes wrong = packet(1, 0x26, {0x00, 0x00});
    wrong.back() ^= 0x40U;
    EXPECT_EQ(byteAt(rig->exchange(wrong), 0), 2U);
    EXPECT_EQ(pins(), kAllPins) << "not executed";
}

}  // namespace
}  // namespace nmc::conformance

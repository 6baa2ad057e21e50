// SPDX-License-Identifier: GPL-3.0-or-later
// Rates that hosts set at a terminal, before and after what they write. Time is stepped, and each case is
// repeated often, so that the simulator notices all, some or nothing of it in between.
#include <gtest/gtest.h>

#include "tests/conformance/terminalhost.h"

namespace nmc {
namespace {

using namespace terminal;

TEST(Terminal, AHostThatNeverSetsARateIsUnderstood) {
    Host host;
    EXPECT_EQ(host.rate(), speed_t{B19200});
    EXPECT_TRUE(host.answers(kSetAddress));
    EXPECT_EQ(host.garbled(), 0U);
}

TEST(Terminal, AHostThatChooses38400IsTakenAtItsWord) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    host.setRate(B38400);
    EXPECT_TRUE(host.answer(kNop).empty()) << "the module is at 19 200 Bd";
    host.setRate(B19200);
    ASSERT_TRUE(host.answers(kNop));
    host.write({0xAA, 0xFF, 0x1A, 32, 0x39});
    host.setRate(B38400);
    host.pass(0.02);
    EXPECT_TRUE(host.answers(kNop));
    EXPECT_EQ(host.sim.state(1)["baud"], 37'879) << "1 250 000 / 33";
}

TEST(Terminal, ANewRateIsNoticedWithoutABytesHelp) {
    Host host;
    ASSERT_TRUE(host.answers(kSetAddress));
    // Nothing but Set Baud at 115 200 Bd, and back at once.
    host.write(kAllTo115200);
    host.setRate(B115200);
    host.pass(0.2);
    EXPECT_EQ(host.sim.state(1)["baud"], 113'636);
    host.write(kAllTo19200);
    host.setRate(B19200);
    host.pass(0.05);
    EXPECT_TRUE(host.answers(kNop));
    EXPECT_EQ(host.garbled(), 0U);
}

TEST(Terminal, ABadLineGarblesWhatACleanOneHearsRightly) {
    const Bytes allTo57600{0xAA, 0xFF, 0x1A, 0x14, 0x2D};
    for (const char* margin : {"3.9", "1.5"}) {
        Host host({"--line-margin", margin});
        ASSERT_TRUE(host.answers(kSetAddress));
        host.write(allTo57600);
        host.setRate(B57600);
        host.pass(0.02);
        const bool isClean = margin == std::string("3.9");
        EXPECT_EQ(host.answer(kNop) == kIdle, isClean) << "3.2 % off";
        EXPECT_EQ(host.garbled(), isClean ? 0U : kNop.size());
    }
}

constexpr unsigned kOften = 200;

/// The way in which a host makes its settings: from those it finds, or from scratch.
class NewRate : public testing::TestWithParam<bool> {
protected:
    NewRate() {
        host.buildsSettingsAnew = GetParam();
        EXPECT_EQ(host.answer(kSetAddress), kIdle);
    }
    Host host;
};

INSTANTIATE_TEST_SUITE_P(, NewRate, testing::Bool(),
                         [](const auto& of) { return of.param ? "SettingsMadeAnew" : "SettingsChanged"; });

TEST_P(NewRate, WhatWasWrittenBeforeItLeavesAtTheOldOne) {
    for (unsigned i = 1; i <= kOften; ++i) {
        host.writeAndSetRate(kNopToAll, B115200, {});
        host.pass(0.02);
        ASSERT_EQ(host.nops(), i);
        host.setRate(B19200);
    }
    EXPECT_EQ(host.garbled(), 0U);
}

TEST_P(NewRate, WhatIsWrittenBehindItLeavesAtIt) {
    host.write(kAllTo115200);
    host.pass(0.02);
    for (unsigned i = 1; i <= kOften; ++i) {
        host.writeAndSetRate({}, B115200, kNopToAll);
        host.pass(0.02);
        ASSERT_EQ(host.nops(), i);
        host.setRate(B19200);
    }
    EXPECT_EQ(host.garbled(), 0U);
}

TEST_P(NewRate, MayBeSetRightBehindSetBaud) {
    // A module obeys at its tick's end, up to 0.512 ms later: six bytes at 115 200 Bd. Nulls bridge that.
    Bytes nullsAndNop(30, 0);
    nullsAndNop.insert(nullsAndNop.end(), kNopToAll.begin(), kNopToAll.end());
    for (unsigned i = 1; i <= kOften; i += 2) {
        host.writeAndSetRate(kAllTo115200, B115200, nullsAndNop);
        host.pass(0.02);
        ASSERT_EQ(host.nops(), i);
        host.writeAndSetRate(kAllTo19200, B19200, nullsAndNop);
        host.pass(0.02);
        ASSERT_EQ(host.nops(), i + 1);
    }
}

TEST_P(NewRate, IsNotTakenForTheNextOneBehindItsFirstCommand) {
    for (unsigned i = 1; i <= kOften; ++i) {
        host.writeAndSetRate(kAllTo115200, B115200, {});
        host.pass(0.02);
        host.writeAndSetRate(kNopToAll, B57600, {});
        host.pass(0.02);
        ASSERT_EQ(host.nops(), i);
        host.setRate(B115200);
        host.writeAndSetRate(kAllTo19200, B19200, {});
        host.pass(0.02);
    }
    EXPECT_EQ(host.garbled(), 0U);
}

TEST_P(NewRate, MayBeSetRightBehindHardReset) {
    for (unsigned i = 0; i < kOften; ++i) {
        host.writeAndSetRate(kAllTo115200, B115200, {});
        host.pass(0.02);
        host.writeAndSetRate(kResetAll, B19200, {});
        host.pass(0.02);
        ASSERT_EQ(host.answer(kSetAddress), kIdle);
    }
    EXPECT_EQ(host.garbled(), 0U);
}

TEST(Terminal, AWrongRateGarblesWhatIsWrittenRightBehindIt) {
    Host host;
    ASSERT_EQ(host.answer(kSetAddress), kIdle);
    for (unsigned i = 1; i <= kOften; ++i) {
        host.writeAndSetRate({}, B115200, kNopToAll);
        host.pass(0.02);
        host.setRate(B19200);
    }
    EXPECT_EQ(host.garbled(), kOften * kNopToAll.size());
    EXPECT_EQ(host.nops(), 0U);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/strayframes.h"
#include "sim/random.h"
#include "tests/bus/scriptedbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr Duration kByte = 87us;  // at 115 200 Bd
/// Position 300, and the sum.
constexpr const char* kFrame = "19 2C 01 00 00 46 ";

class Strays : public testing::Test {
protected:
    void hear(const std::string& hex) { strays.hear(fromHex(hex), now, kByte); }
    [[nodiscard]] bool foreign() { return strays.takeForeign(now += 500ms); }
    StrayFrames strays;
    TimePoint now{100s};
};

TEST_F(Strays, ThreeWithinTenSecondsAreSomebodyElseOnce) {
    for (int i = 0; i < 2; ++i) {
        hear(kFrame);
        EXPECT_FALSE(foreign());
    }
    hear(kFrame);
    EXPECT_TRUE(foreign());
    for (int i = 0; i < 30; ++i) {
        hear(kFrame);
        EXPECT_FALSE(foreign()) << "already reported";
    }
    now += 11s;
    EXPECT_FALSE(foreign());
    for (int i = 0; i < 3; ++i) {
        hear(kFrame);
        now += 1s;
    }
    EXPECT_TRUE(foreign()) << "the other host is back";
}

TEST_F(Strays, OverALongerTimeAreNot) {
    for (int i = 0; i < 10; ++i) {
        hear(kFrame);
        now += 5s;
        EXPECT_FALSE(foreign());
    }
}

TEST_F(Strays, ByteByByteAreFramesToo) {
    for (int i = 0; i < 3; ++i) {
        for (const std::uint8_t byte : fromHex(kFrame)) {
            now += kByte;
            strays.hear({&byte, 1}, now, kByte);
        }
        EXPECT_EQ(foreign(), i == 2);
    }
}

TEST_F(Strays, AreNoLateAnswers) {
    for (int i = 0; i < 20; ++i) {
        strays.onMissed(now);
        now += 80ms;
        hear(kFrame);
        EXPECT_FALSE(foreign());
    }
    // A missing answer accounts for only one frame, and only for a short time.
    strays.onMissed(now);
    now += 2s;
    bool told = false;
    for (int i = 0; i < 3; ++i) {
        hear(kFrame);
        told = foreign() || told;
    }
    EXPECT_TRUE(told);
}

TEST_F(Strays, AreNeitherEchoesNorHeldLinesNorTooShort) {
    const auto command = fromHex("AA 01 13 20 34 ");
    strays.onSent(PacketBytes(command));
    for (const char* heard :
         {"01 13 20 34 ", "AA 01 13 20 34 ", "00 00 00 00 00 00 ", "FF FF FF FF ", "19 19 ", "01 0E 0F ",
          "19 2C 01 00 00 47 ", "01 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 "})
        for (int i = 0; i < 5; ++i) {
            hear(heard);
            EXPECT_FALSE(foreign()) << heard;
        }
}

/// The calculation in strayframes.h: a quarter of an hour of noise in runs of every length.
TEST_F(Strays, AreNotMadeOfNoise) {
    sim::Random random(45);
    unsigned frames = 0;
    for (int i = 0; i < 9'000; ++i) {
        std::vector<std::uint8_t> noise(1 + random.below(20));
        for (std::uint8_t& byte : noise)
            byte = static_cast<std::uint8_t>(random.below(256));
        const ByteSpan all(noise);
        frames += all.size() >= 4 && sum8(all.first(all.size() - 1)) == all.back() ? 1U : 0U;
        strays.hear(noise, now, kByte);
        now += 100ms;
        ASSERT_FALSE(strays.takeForeign(now));
    }
    EXPECT_GT(frames, 20U) << "their sums are right now and then";
}

}  // namespace

}  // namespace nmc::test

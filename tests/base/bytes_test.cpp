// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/bytes.h"

#include <gtest/gtest.h>

#include "base/strong.h"
#include "base/time.h"

namespace nmc {
namespace {

TEST(Bytes, LeastSignificantByteGoesFirst) {
    ByteBuffer<8> buffer;
    buffer.appendLittleEndian(std::int32_t{-1024});  // 0xFFFFFC00, DS-V's example order
    EXPECT_EQ(toHex(buffer), "00 FC FF FF");
    EXPECT_EQ(readLittleEndian<std::int32_t>(buffer), -1024);
    EXPECT_EQ(readLittleEndian<std::uint16_t>(buffer), 0xFC00);
}

TEST(Bytes, SumIsTheLowEightBits) {
    const ByteBuffer<3> bytes{0xFF, 0x02, 0x80};  // 0x181
    EXPECT_EQ(sum8(bytes), 0x81);
    EXPECT_EQ(sum8(ByteSpan{}), 0);
}

TEST(Bytes, HexHasTwoDigitsAndOneSpace) {
    EXPECT_EQ(toHex(ByteBuffer<3>{0xAA, 0x01, 0x0E}), "AA 01 0E");
    EXPECT_EQ(toHex(ByteSpan{}), "");
}

TEST(Bytes, BuffersCompareByContentNotByWhatWasThereBefore) {
    ByteBuffer<4> a{1, 2, 3};
    a.clear();
    a.push_back(9);
    EXPECT_EQ(a, (ByteBuffer<4>{9}));
    EXPECT_FALSE(a == (ByteBuffer<4>{9, 2}));
}

TEST(Bytes, AFullBufferTakesNoMore) {
    ByteBuffer<4> buffer{1, 2};
    buffer.appendWhatFits(ByteBuffer<4>{3, 4, 5, 6});
    EXPECT_EQ(toHex(buffer), "01 02 03 04");
    buffer.appendWhatFits(ByteBuffer<4>{7});
    EXPECT_EQ(toHex(buffer), "01 02 03 04");
}

TEST(Strong, TypesOfDifferentMeaningDoNotConvert) {
    static_assert(!std::is_convertible_v<ModuleIndex, BusAddress>);
    static_assert(!std::is_convertible_v<int, Counts>);
    static_assert(!std::is_constructible_v<CountsPerTick, Counts>);
    EXPECT_LT(ModuleIndex(1), ModuleIndex(2));
}

TEST(Time, TheEarliestPassesOverTimesThatAreNotThere) {
    const TimePoint one{std::chrono::seconds(1)};
    const TimePoint two{std::chrono::seconds(2)};
    EXPECT_EQ(earliest({std::nullopt, two, one, std::nullopt}), one);
    EXPECT_EQ(earliest({two}), two);
    EXPECT_EQ(earliest({std::nullopt}), std::nullopt);
}

TEST(Time, ServoTickIsTheDataSheetsRate) {
    EXPECT_NEAR(1.0 / toSeconds(kServoTick), 1953.12, 0.01);  // DS-V 3.1
    EXPECT_EQ(fromSeconds(0.000512), kServoTick);
    EXPECT_EQ(fromSeconds(-0.000512), -kServoTick);
}

}  // namespace
}  // namespace nmc

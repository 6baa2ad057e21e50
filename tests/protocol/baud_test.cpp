// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/baud.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

TEST(Baud, DivisorsGiveTheRatesOfTheProtocolPage) {
    EXPECT_NEAR(realRate(129), 9'615, 0.5);
    EXPECT_NEAR(realRate(63), 19'531, 0.5);
    EXPECT_NEAR(realRate(64), 19'231, 0.5);
    EXPECT_NEAR(realRate(20), 59'524, 0.5);
    EXPECT_NEAR(realRate(21), 56'818, 0.5);
    EXPECT_NEAR(realRate(10), 113'636, 0.5);
}

TEST(Baud, OurDivisorIsNeverFurtherOffThanTheDataSheets) {
    for (const BaudRow& row : kBaudRows) {
        const auto error = [&row](std::uint8_t brd) { return std::abs(realRate(brd) / row.nominal - 1.0); };
        EXPECT_LE(error(row.brd), error(row.dataSheetBrd)) << row.nominal;
        EXPECT_LT(error(row.brd), 0.02) << row.nominal;  // what a UART at the other end tolerates
    }
}

TEST(Baud, RatesTheChipsCannotMakeAreNotFound) {
    EXPECT_EQ(findBaud(57'600)->brd, 21);
    EXPECT_FALSE(findBaud(38'400).has_value());
    EXPECT_FALSE(findBaud(0).has_value());
}

TEST(Baud, AByteIsTenBits) {
    EXPECT_EQ(byteTimeAtBaud(19'200), Duration(520'833));
}

}  // namespace
}  // namespace nmc

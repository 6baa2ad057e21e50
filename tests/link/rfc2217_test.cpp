// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are those of RFC 854 (IAC 255, SB 250, SE 240, WILL 251, WONT 252, DO 253, DONT 254), RFC 856
// (binary: 0), RFC 858 (suppress go ahead: 3) and RFC 2217 (option 44, its commands, and answers that are 100
// more).
#include "link/ports/rfc2217.h"

#include <gtest/gtest.h>

#include <random>

namespace nmc {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Rfc2217, AsksForBinaryTransmissionAndControlOfAnUnadornedPort) {
    Rfc2217 client;
    EXPECT_EQ(
        client.takeOutput(),
        (Bytes{
            255, 251, 44,                                             // WILL COM-PORT-OPTION
            255, 251, 0,  255, 253, 0,   255, 251, 3,   255, 253, 3,  // WILL and DO, binary and no go-ahead
            255, 250, 44, 2,   8,   255, 240, 255, 250, 44,  3,   1,
            255, 240,  // 8 bits, no parity
            255, 250, 44, 4,   1,   255, 240, 255, 250, 44,  5,   1,
            255, 240}));  // 1 stop bit, no flow control
    EXPECT_FALSE(client.agreed());
    EXPECT_TRUE(client.take(Bytes{255, 253, 44}).empty());
    EXPECT_EQ(client.agreed(), true);
    EXPECT_TRUE(client.takeOutput().empty());
}

TEST(Rfc2217, LearnsThatTheServerDeclines) {
    Rfc2217 client;
    EXPECT_TRUE(client.take(Bytes{255, 254, 44}).empty());
    EXPECT_EQ(client.agreed(), false);
}

TEST(Rfc2217, DoublesTheByte255InBothDirections) {
    EXPECT_EQ(Rfc2217::encoded(Bytes{0xAA, 0xFF, 0x17, 0xFF}), (Bytes{0xAA, 0xFF, 0xFF, 0x17, 0xFF, 0xFF}));
    Rfc2217 client;
    Bytes data;
    for (const std::uint8_t byte : Bytes{1, 255, 255, 2, 255, 241, 3})  // 241: no operation
        for (const std::uint8_t heard : client.take({&byte, 1}))
            data.push_back(heard);
    EXPECT_EQ(data, (Bytes{1, 255, 2, 3}));
}

TEST(Rfc2217, SetsTheRateAndHearsWhichOneItIs) {
    Rfc2217 client;
    (void)client.takeOutput();
    client.setBaud(115'200);  // 0x0001C200
    EXPECT_EQ(client.takeOutput(), (Bytes{255, 250, 44, 1, 0x00, 0x01, 0xC2, 0x00, 255, 240}));
    EXPECT_FALSE(client.baud());
    EXPECT_EQ(client.take(Bytes{7, 255, 250, 44, 101, 0x00, 0x01, 0xC2, 0x00, 255, 240, 8}), (Bytes{7, 8}));
    EXPECT_EQ(client.baud(), 115'200U);
    client.setBaud(0xFF);  // its last byte is doubled on the way
    EXPECT_EQ(client.takeOutput(), (Bytes{255, 250, 44, 1, 0, 0, 0, 255, 255, 255, 240}));
    EXPECT_FALSE(client.baud()) << "the answer to the last one is awaited";
    (void)client.take(Bytes{255, 250, 44, 101, 0, 0, 0, 255, 255, 255, 240});
    EXPECT_EQ(client.baud(), 0xFFU);
}

TEST(Rfc2217, DropsWhatTheServerHasNotPassedOn) {
    Rfc2217 client;
    (void)client.takeOutput();
    client.purgeInput();
    EXPECT_EQ(client.takeOutput(), (Bytes{255, 250, 44, 12, 1, 255, 240}));
}

TEST(Rfc2217, DeclinesWhatItDoesNotKnowOnce) {
    Rfc2217 client;
    (void)client.takeOutput();
    for (int i = 0; i < 2; ++i) {
        (void)client.take(Bytes{255, 253, 24, 255, 251, 1});  // DO terminal type, WILL echo
        EXPECT_EQ(client.takeOutput(), i == 0 ? (Bytes{255, 252, 24, 255, 254, 1}) : Bytes{});
    }
    (void)client.take(Bytes{255, 253, 0, 255, 251, 0, 255, 251, 3});  // as asked for
    EXPECT_TRUE(client.takeOutput().empty());
}

TEST(Rfc2217, SurvivesAnyBytes) {
    std::mt19937 random(1);
    Rfc2217 client;
    (void)client.takeOutput();
    for (int i = 0; i < 2'000; ++i) {
        Bytes noise(random() % 400);
        for (std::uint8_t& byte : noise)
            byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 240 + random() % 16 : random());
        EXPECT_LE(client.take(noise).size(), noise.size());
        EXPECT_LE(client.takeOutput().size(), 3U * 512U) << "two verbs and 256 options, each answered once";
    }
    // Whatever came before, the end of a subnegotiation leads back to the line.
    (void)client.take(Bytes{0, 0, 255, 240});
    EXPECT_EQ(client.take(Bytes{5}), Bytes{5});
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes and their times (DS-V 3.1, 4.1; protocol.md 1).
#include "sim/line.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

TEST(Line, TheReplyBeginsAtTheEndOfTheTickWithin512Microseconds) {
    Duration least = kTick;
    Duration most{};
    HostWire wire;
    wire.address(1);
    for (int i = 0; i < 500; ++i) {
        const TimePoint last = wire.now + nanoseconds(4 * 10'000'000'000 / 19'200);
        const auto reply = wire.exchange(packet(1, 0x0E));
        ASSERT_EQ(reply.size(), 2U);
        const Duration delay = reply[0].due - nanoseconds(512'000) - last;  // 19 531 Bd: 512 us a byte
        least = std::min(least, delay);
        most = std::max(most, delay);
        wire.wait(microseconds(777 + 37 * i));  // not in step with the ticks
    }
    EXPECT_GE(least, Duration::zero());
    EXPECT_LT(least, microseconds(60));
    EXPECT_LE(most, kTick + nanoseconds(1));
    EXPECT_GT(most, microseconds(450));
}

TEST(Line, AReplyIsPacedAtTheModulesOwnRate) {
    HostWire wire;
    wire.address(1);
    auto reply = wire.exchange(packet(1, 0x13, {0x1F}));
    ASSERT_EQ(reply.size(), 14U);
    for (std::size_t i = 1; i < reply.size(); ++i)
        EXPECT_EQ(reply[i].due - reply[i - 1].due, nanoseconds(512'000)) << "10 bits at 19 531.25 Bd";
    wire.command(0xFF, 0x1A, {10});
    wire.chain.setHostBaud(115'200);
    reply = wire.exchange(packet(1, 0x13, {0x1F}));
    ASSERT_EQ(reply.size(), 14U);
    for (std::size_t i = 1; i < reply.size(); ++i)
        EXPECT_EQ(reply[i].due - reply[i - 1].due, nanoseconds(88'000)) << "10 bits at 113 636 Bd";
}

TEST(Line, AnUnpacedReplyTakesNoTimeOnTheWire) {
    ChainOptions options;
    options.unpaced = true;
    HostWire wire("servo", options);
    const auto reply = wire.exchange(packet(0, 0x13, {0x1F}));
    ASSERT_EQ(reply.size(), 14U);
    EXPECT_EQ(reply.front().due, reply.back().due);
}

TEST(Line, NothingIsOnTheLineWhileNobodyTalks) {
    HostWire wire;
    EXPECT_EQ(wire.chain.nextEvent(), std::nullopt);
    wire.chain.hostSends(packet(0, 0x0E), wire.now);
    EXPECT_EQ(wire.chain.nextEvent(), wire.now + nanoseconds(10'000'000'000 / 19'200));
}

TEST(Line, AByteOfTheHostCutsAReplyShortAndTheNewCommandIsAnswered) {
    HostWire wire;
    wire.address(1);
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    const TimePoint cut = wire.now;
    const auto reply = wire.exchange(packet(1, 0x0E));
    // The bytes that were complete when the first byte arrived are there, then only the second answer.
    const TimePoint firstByteIn = cut + nanoseconds(10'000'000'000 / 19'200);
    std::size_t before = 0;
    while (before < reply.size() && reply[before].due <= firstByteIn)
        ++before;
    EXPECT_LE(before, 2U);
    ASSERT_EQ(reply.size() - before, 2U);
    EXPECT_EQ(reply.back().value, 0x19);
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
}

TEST(Line, AReplyIsCutByAByteThatIsNotForTheModule) {
    HostWire wire("servo,servo");
    wire.address(2);
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    const auto rest = wire.exchange({0x00});
    EXPECT_LE(rest.size(), 2U);
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
    EXPECT_TRUE(wire.violations().empty()) << "a null is not a command";
}

TEST(Line, AMemberOfAGroupIsSilentAboutAWrongSumAndALeaderIsNot) {
    HostWire wire("servo,servo");
    wire.address(2);
    Bytes wrong = packet(0xFF, 0x0E);
    wrong.back() ^= 0x01;
    EXPECT_TRUE(wire.exchange(wrong).empty());
    wire.command(1, 0x21, {1, 0x7F});
    EXPECT_EQ(values(wire.exchange(wrong)), (Bytes{0x1B, 0x1B}));
}

TEST(Line, ALostByteMakesTheNextPacketTheTailAndSixteenNullsRecover) {
    HostWire wire;
    wire.address(1);
    Bytes torn = packet(1, 0x17, {0x01});
    torn.erase(torn.begin() + 3);  // the sum is taken for the control byte
    EXPECT_TRUE(wire.exchange(torn).empty());
    // The next header is taken for the sum; the rest of that packet cuts the error reply short.
    EXPECT_TRUE(wire.exchange(packet(1, 0x0E)).empty());
    EXPECT_EQ(wire.chain.statistics().modules[0].checksumErrors, 1U);
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
    EXPECT_FALSE(wire.truth().servo.ampEnabled);
    EXPECT_EQ(wire.command(1, 0x0E), kIdle);

    // The longest packet, cut after its command byte: 15 data bytes and the sum are missing.
    EXPECT_TRUE(wire.exchange({0xAA, 0x01, 0xFE}).empty());
    EXPECT_TRUE(wire.exchange(packet(1, 0x0E)).empty());
    wire.exchange(Bytes(16, 0));
    wire.wait(milliseconds(10));
    EXPECT_EQ(wire.command(1, 0x0E), kIdle);
}

TEST(Line, BytesAreGarbledFromFourPercentAndAllOfThemFromFive) {
    // protocol.md 1: real rate 1 250 000 / (brd + 1). All sample values of the data sheets are inside.
    EXPECT_EQ(garbleProbability(realRate(63), 19'200), 0.0);   // +1.7 %
    EXPECT_EQ(garbleProbability(realRate(64), 19'200), 0.0);   // +0.2 %
    EXPECT_EQ(garbleProbability(realRate(129), 9'600), 0.0);   // +0.2 %
    EXPECT_EQ(garbleProbability(realRate(20), 57'600), 0.0);   // +3.3 %
    EXPECT_EQ(garbleProbability(realRate(21), 57'600), 0.0);   // -1.4 %
    EXPECT_EQ(garbleProbability(realRate(10), 115'200), 0.0);  // -1.4 %
    // At 16 samples per bit, the margin at 9.5 bits is 8 samples, two of them uncertain: 6/152 = 3.947 % to
    // 8/152 = 5.263 %. 9 200 Bd is 4.32 % below brd 129's 9615: (0.0432 * 152 - 6) / 2 = 0.2832. 9 100 Bd
    // is 5.36 % below.
    EXPECT_NEAR(garbleProbability(realRate(129), 9'200), 0.2832, 1e-4);
    EXPECT_EQ(garbleProbability(realRate(129), 9'100), 1.0);
    EXPECT_EQ(garbleProbability(realRate(63), 115'200), 1.0);
    EXPECT_EQ(garbleProbability(realRate(10), 19'200), 1.0);
}

TEST(Line, AnScIsAt230400BdWithDivisor5) {
    HostWire wire("servo@10");
    wire.command(0xFF, 0x1A, {5});
    wire.chain.setHostBaud(230'400);
    // 2 500 000 / 11 = 227 273, 1.4 % off: ten bits are 44 us. 1 250 000 / 6 would be 208 333.
    const auto reply = wire.exchange(packet(0, 0x13, {0x20}));
    ASSERT_EQ(values(reply), (Bytes{0x19, 0, 10, 0x23}));
    EXPECT_EQ(reply[1].due - reply[0].due, nanoseconds(44'000));
    EXPECT_TRUE(wire.violations().empty());
}

TEST(Line, AHostAtAnotherRateIsNotUnderstood) {
    HostWire wire;
    wire.address(1);
    wire.chain.setHostBaud(57'600);
    EXPECT_TRUE(wire.command(1, 0x0E).empty());
    EXPECT_EQ(wire.chain.statistics().modules[0].executions(CommandCode::Nop), 0U);
    EXPECT_EQ(wire.chain.statistics().modules[0].bytesGarbled, 4U);
    wire.chain.setHostBaud(19'200);
    wire.exchange(Bytes(16, 0));
    wire.wait(milliseconds(10));
    EXPECT_EQ(wire.command(1, 0x0E), kIdle);
}

TEST(Line, At57600WithTheDataSheetsCodeNoPollIsLost) {
    HostWire wire;
    wire.address(1);
    wire.exchange({0xAA, 0xFF, 0x1A, 0x14, 0x2D});
    wire.chain.setHostBaud(57'600);
    for (int i = 0; i < 3'030; ++i)
        ASSERT_EQ(wire.command(1, 0x0E), kIdle) << "poll " << i;
    EXPECT_EQ(wire.chain.statistics().modules[0].bytesGarbled, 0U);
}

TEST(Line, ABadLineHasALesserMargin) {
    ChainOptions options;
    options.lineMargin = 0.03;
    HostWire wire("servo", options);
    wire.command(0xFF, 0x1A, {20});
    wire.chain.setHostBaud(57'600);
    constexpr int kBytes = 16'000;
    wire.exchange(Bytes(kBytes, 0));
    // 57 600 is 3.232 % below 59 524: (0.03232 - 0.03) * 152 / 2 = 0.1763 of the bytes; a standard deviation
    // is sqrt(16 000 * 0.1763 * 0.8237) = 48.
    EXPECT_NEAR(static_cast<double>(wire.chain.statistics().modules[0].bytesGarbled), 0.1763 * kBytes,
                4 * 48.0);
}

TEST(Line, AReplyAtAnotherRateIsGarbledAtTheHost) {
    HostWire wire;
    wire.address(1);
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.chain.setHostBaud(115'200);  // what has been sent leaves at the old rate
    const Bytes reply = values(wire.exchange({}));
    ASSERT_EQ(reply.size(), 14U);
    EXPECT_NE(reply[0], 0x19);
    EXPECT_EQ(wire.chain.statistics().modules[0].bytesGarbled, 14U);
}

TEST(Line, SetBaudTakesEffectBeforeTheLeadersReply) {
    HostWire wire;
    wire.address(1);
    wire.command(1, 0x21, {1, 0x7F});
    wire.chain.hostSends(packet(0xFF, 0x1A, {10}), wire.now);
    wire.wait(nanoseconds(5 * 10'000'000'000 / 19'200));
    wire.chain.setHostBaud(115'200);
    const auto reply = wire.exchange({});
    ASSERT_EQ(values(reply), kIdle);
    EXPECT_EQ(reply[1].due - reply[0].due, nanoseconds(88'000));
}

TEST(Line, TwoAnswersAtOnceCollide) {
    HostWire wire("servo@1,servo@2");
    wire.command(0, 0x21, {5, 0xFF});
    wire.command(0, 0x21, {5, 0xFF});
    const Bytes heard = wire.command(5, 0x13, {0x20});
    EXPECT_NE(heard, (Bytes{0x19, 0, 1, 0x1A}));
    EXPECT_NE(heard, (Bytes{0x19, 0, 2, 0x1B}));
    EXPECT_GE(heard.size(), 4U);
    EXPECT_LE(heard.size(), 5U);
}

TEST(Line, TheSameSeedGivesTheSameHistoryAndAnotherSeedAnother) {
    const auto history = [](std::uint64_t seed) {
        ChainOptions options;
        options.seed = seed;
        options.lineMargin = 0.03;
        HostWire wire("servo,servo", options);
        std::vector<std::pair<Duration, int>> all;
        wire.address(2);
        wire.command(0xFF, 0x1A, {20});
        wire.chain.setHostBaud(57'600);
        for (unsigned i = 0; i < 50; ++i) {
            for (const HostByte& byte : wire.exchange(packet(1 + i % 2, 0x13, {0x1F})))
                all.emplace_back(byte.due.time_since_epoch(), byte.value);
            wire.exchange(Bytes(16, 0));
            wire.wait(milliseconds(2));
        }
        return all;
    };
    EXPECT_EQ(history(1), history(1));
    EXPECT_NE(history(1), history(2));
}

TEST(Line, HowOftenTheChainIsAskedChangesNothing) {
    const auto position = [](Duration step) {
        HostWire wire;
        wire.address(1);
        wire.gains(goodGains());
        wire.servoOn();
        wire.velocity(3 * 65536, 6554);
        const TimePoint end = wire.now + milliseconds(1500);
        while (wire.now < end)
            wire.wait(std::min(step, end - wire.now));
        return wire.truth().servo.shaftCounts;
    };
    EXPECT_EQ(position(milliseconds(1500)), position(microseconds(100)));
}

TEST(Line, MemoryStaysBoundedWhateverIsSentAndNeverTaken) {
    HostWire wire;
    wire.chain.hostSends(Bytes(200'000, 0xAA), wire.now);
    EXPECT_EQ(wire.chain.statistics().bytesLost, 200'000U - HostLine::kCapacity);
    for (int i = 0; i < 12'000; ++i) {
        wire.chain.hostSends(packet(0, 0x13, {0x1F}), wire.now);
        wire.now += milliseconds(20);
        wire.chain.advanceTo(wire.now);
    }
    EXPECT_EQ(wire.chain.takeHostBytes().size(), kMaxWaitingHostBytes);
}

RC_GTEST_PROP(Line, WhateverBytesArriveTheChainLivesAndRecovers, ()) {
    HostWire wire("servo,servo@1,servo@3");
    const auto chunks = *rc::gen::container<std::vector<Bytes>>(rc::gen::container<Bytes>(
        rc::gen::weightedOneOf<std::uint8_t>({{3, rc::gen::arbitrary<std::uint8_t>()},
                                              {1, rc::gen::just<std::uint8_t>(0xAA)},
                                              {1, rc::gen::inRange<std::uint8_t>(0, 4)}})));
    for (const Bytes& chunk : chunks) {
        wire.exchange(chunk);
        // Complete packets with random commands, too, which pass the checksum.
        if (!chunk.empty())
            wire.command(chunk[0] % 4U, chunk.back() & 0x0FU, {});
        wire.wait(milliseconds(20));
    }
    for (unsigned i = 0; i < 3; ++i)
        wire.chain.powerCycle(ModuleIndex(static_cast<std::uint8_t>(i)), wire.now);
    wire.wait(milliseconds(10));
    wire.exchange(Bytes(16, 0));
    wire.wait(milliseconds(10));
    for (unsigned i = 1; i <= 3; ++i)
        RC_ASSERT(wire.command(0, 0x21, {static_cast<std::uint8_t>(i), 0xFF}).size() == 2U);
}

}  // namespace
}  // namespace nmc::sim::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Records for the packet monitor: every byte that was sent, and the replies.
#include <gtest/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

TEST(Records, AreNotKeptUnlessAskedFor) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    EXPECT_TRUE(bus.engine.takeRecords().empty());
}

/// From connecting to a stop, the bytes of the records are those on the line, in the same order.
TEST(Records, HoldEveryByteThatWasSent) {
    VirtualBus bus(servos(2));
    bus.engine.setRecording(true);
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 500), start(0)}), Outcome::Done);
    bus.runFor(300ms);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
    bus.runFor(100ms);
    const auto records = bus.engine.takeRecords();
    ASSERT_GT(records.size(), 50U);
    // An exchange that is still in progress has no record yet.
    ASSERT_LE(records.size(), bus.sent.size());
    ASSERT_GE(records.size() + 2, bus.sent.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        ASSERT_EQ(toHex(records[i].command), bus.sent[i].hex()) << i;
        EXPECT_EQ(records[i].number, i + 1);
        EXPECT_EQ(records[i].sent, bus.sent[i].time) << i;
        EXPECT_GE(records[i].ended, records[i].sent);
        if (records[i].end == ReplyResult::Accepted && i > 200) {
            EXPECT_EQ(records[i].reply.size(), records[i].layout.length());
        }
    }
    EXPECT_EQ(records.front().baud, 19'200U);
    EXPECT_EQ(records.back().baud, 19'200U);
    EXPECT_TRUE(bus.engine.takeRecords().empty()) << "they have been taken";
}

TEST(Records, SayWhatEachExchangeWasFor) {
    VirtualBus bus(servos(1));
    bus.engine.setRecording(true);
    ASSERT_TRUE(bus.connect());
    for (const ExchangeRecord& record : bus.engine.takeRecords())
        EXPECT_EQ(record.purpose, Purpose::Connect) << toHex(record.command);
    bus.runFor(200ms);
    for (const ExchangeRecord& record : bus.engine.takeRecords()) {
        EXPECT_EQ(record.purpose, Purpose::Poll);
        EXPECT_EQ(record.module, ModuleIndex(0));
        EXPECT_EQ(record.end, ReplyResult::Accepted);
    }
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    unsigned operations = 0;
    for (const ExchangeRecord& record : bus.engine.takeRecords())
        operations += record.purpose == Purpose::Operation ? 1U : 0U;
    EXPECT_EQ(operations, 2U);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
    unsigned stops = 0;
    for (const ExchangeRecord& record : bus.engine.takeRecords())
        stops += record.purpose == Purpose::Stop ? 1U : 0U;
    EXPECT_GE(stops, 2U);
}

TEST(Records, SayWhyAnAnswerWasNotBelieved) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.runFor(300ms);
    bus.engine.setRecording(true);
    int kind = 0;
    bus.answer = [&](ByteSpan packet) {
        auto whole = bus.likeAServo(packet);
        if (toHex(packet) != "AA 01 13 3F 53" || kind == 0)
            return whole;
        switch (std::exchange(kind, 0)) {
            case 1:
                return std::vector<std::uint8_t>{};
            case 2:
                whole.pop_back();
                return whole;
            case 3:
                whole.back() = static_cast<std::uint8_t>(whole.back() + 1);
                return whole;
            case 4:
                whole.push_back(0x55);
                return whole;
            case 5:
                return std::vector<std::uint8_t>(whole.size(), 0);
            default:
                whole[0] = static_cast<std::uint8_t>(whole[0] | 0x02);
                whole.pop_back();
                return withSum(whole);
        }
    };
    const ReplyResult kEnds[] = {ReplyResult::Unresponsive, ReplyResult::Partial,  ReplyResult::BadChecksum,
                                 ReplyResult::Rejected,     ReplyResult::Rejected, ReplyResult::Refused};
    for (int k = 1; k <= 6; ++k) {
        SCOPED_TRACE(k);
        (void)bus.engine.takeRecords();
        kind = k;
        bus.runFor(1s);
        std::optional<ExchangeRecord> odd;
        bool nulls = false;
        for (const ExchangeRecord& record : bus.engine.takeRecords()) {
            if (record.end != ReplyResult::Accepted && record.end != ReplyResult::NotAsked)
                odd = record;
            nulls =
                nulls || (record.purpose == Purpose::Flush && toHex(record.command) == ScriptedBus::kNulls);
        }
        ASSERT_TRUE(odd);
        EXPECT_EQ(odd->end, kEnds[k - 1]);
        EXPECT_EQ(nulls, k != 6) << "a refusal is no doubt about the line";
        if (k == 4) {
            EXPECT_EQ(odd->rejection, Rejection::Surplus);
            EXPECT_EQ(odd->reply.size(), 17U);
        }
        if (k == 5) {
            EXPECT_EQ(odd->rejection, Rejection::Uniform);
        }
        if (k == 2) {
            EXPECT_EQ(odd->reply.size(), 15U);
        }
    }
}

TEST(Records, TellOfWhatAStopPreEmpted) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.runFor(300ms);
    bus.engine.setRecording(true);
    const std::size_t sent = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > sent; }));
    bus.engine.stopAll(bus.now);
    bus.runFor(500ms);
    unsigned abandoned = 0;
    for (const ExchangeRecord& record : bus.engine.takeRecords())
        abandoned += record.end == ReplyResult::Abandoned ? 1U : 0U;
    EXPECT_GE(abandoned, 1U);
}

TEST(Records, BeginAnewAtOne) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    bus.engine.setRecording(true);
    bus.runFor(100ms);
    bus.engine.setRecording(false);
    EXPECT_TRUE(bus.engine.takeRecords().empty());
    bus.runFor(100ms);
    bus.engine.setRecording(true);
    bus.runFor(100ms);
    const auto records = bus.engine.takeRecords();
    ASSERT_FALSE(records.empty());
    EXPECT_EQ(records[0].number, 1U);
}

}  // namespace

}  // namespace nmc::test

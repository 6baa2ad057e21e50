// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/line.h"
#include "protocol/commands.h"
#include "tests/bus/scriptedbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr StatusItems kPoll{0x0B};

[[nodiscard]] Request nop(StatusItems items = kPoll) {
    return {BusAddress(1), Nop{}.encode(), {ModuleType::Servo, items}};
}

TEST(LineTiming, IsTheSumOfItsParts) {
    // 4 bytes out, 8 back at 19 200 Bd: 12 x 520.833 us, 0.512 ms, 4 ms adapter, 10 ms margin.
    LineTiming timing{byteTimeAtBaud(19'200), 0ms, 10ms};
    EXPECT_EQ(timing.timeout(4, 8), Duration(12 * 520'833) + 512us + 4ms + 10ms);
    timing.latency = 16ms;
    EXPECT_EQ(timing.timeout(4, 8), Duration(12 * 520'833) + 512us + 16ms + 10ms);
    EXPECT_EQ(timing.wireTime(4, 8), Duration(12 * 520'833) + 256us);
}

TEST(LineTiming, QuarantineIsFiveTimeoutsAndAtLeastATenthOfASecond) {
    EXPECT_EQ(LineTiming::quarantine(10ms), Duration(100ms));
    EXPECT_EQ(LineTiming::quarantine(30ms), Duration(150ms));
}

TEST(Line, GivesUpAtTheTimeout) {
    Line line(4ms, 10ms);
    const TimePoint sent(1s);
    line.begin(nop(), sent);
    const TimePoint deadline = sent + Duration(12 * 520'833) + 512us + 14ms;
    ASSERT_EQ(line.deadline(), deadline);
    EXPECT_FALSE(line.onDeadline(deadline - 1ns));
    const auto end = line.onDeadline(deadline);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Silent);
    EXPECT_TRUE(line.idle());
}

TEST(Line, ReckonsFromWhatIsStillLeaving) {
    Line line(4ms, 10ms);
    const TimePoint now(1s);
    line.run({Line::Nulls{}}, now);
    line.begin(nop(), now);
    EXPECT_EQ(line.deadline(), now + Duration(28 * 520'833) + 512us + 14ms);
    const auto end = line.onBytes(fromHex("19 00 00 00 00 00 00 19 "), now + 20ms);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->latched, now + Duration(20 * 520'833) + 256us);
}

TEST(Line, TakesAReplyInPieces) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    EXPECT_FALSE(line.onBytes(fromHex("19 64 00 "), TimePoint(1s + 8ms)));
    const auto end = line.onBytes(fromHex("00 00 05 00 82 "), TimePoint(1s + 9ms));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Accepted);
    EXPECT_EQ(end->report.position, 100);
    EXPECT_EQ(end->report.analog, 5);
    EXPECT_EQ(line.statistics().answered, 1U);
    EXPECT_EQ(line.statistics().roundTripMax, Duration(9ms));
    EXPECT_EQ(line.statistics().wireTime, Duration(12 * 520'833) + 256us);
}

TEST(Line, RejectsAPartialReplyAtTheTimeout) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    EXPECT_FALSE(line.onBytes(fromHex("19 64 00 "), TimePoint(1s + 8ms)));
    const auto end = line.onDeadline(*line.deadline());
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Partial);
    EXPECT_EQ(line.statistics().timeouts, 1U);
}

TEST(Line, RejectsAWrongSum) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    const auto end = line.onBytes(fromHex("19 64 00 00 00 05 00 83 "), TimePoint(1s + 8ms));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::BadChecksum);
    EXPECT_EQ(line.statistics().badChecksum, 1U);
    EXPECT_EQ(line.statistics().answered, 0U);
}

TEST(Line, CountsSurplusBytesAndKeepsThemFromTheNextReply) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    ASSERT_TRUE(line.onBytes(fromHex("19 00 00 00 00 00 00 19 AA "), TimePoint(1s + 8ms)));
    EXPECT_FALSE(line.onBytes(fromHex("BB CC "), TimePoint(1s + 9ms)));
    EXPECT_EQ(line.statistics().surplusBytes, 3U);
    line.begin(nop(), TimePoint(1s + 10ms));
    const auto end = line.onBytes(fromHex("19 00 00 00 00 00 00 19 "), TimePoint(1s + 18ms));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Accepted);
}

TEST(Line, DoesNotCountRepliesThatItDoesNotRead) {
    Line line(4ms, 10ms);
    const PacketBytes packet = toPacket({BusAddress(1), Nop{}.encode()});
    line.run({Line::Packet{packet, 8}, Line::Pause{10ms}}, TimePoint(1s));
    EXPECT_FALSE(line.onBytes(fromHex("19 00 00 00 00 00 00 19 AA "), TimePoint(1s + 8ms)));
    EXPECT_EQ(line.statistics().surplusBytes, 1U);
    EXPECT_EQ(line.scriptLatches().at(0), TimePoint(1s) + Duration(4 * 520'833) + 256us);
}

TEST(Line, RunsAScriptInOrder) {
    Line line(4ms, 10ms);
    const TimePoint now(1s);
    line.run({Line::Pause{100ms}, DiscardInput{}, Line::Nulls{}, Line::Pause{1ms}, SetHostBaud{115'200}},
             now);
    EXPECT_TRUE(line.takeOutput().empty());
    EXPECT_EQ(line.deadline(), now + 100ms);
    EXPECT_FALSE(line.onDeadline(now + 100ms));
    EXPECT_EQ(line.takeOutput().size(), 2U);
    // Sixteen bytes leave first.
    EXPECT_EQ(line.deadline(), now + 100ms + Duration(16 * 520'833) + 1ms);
    EXPECT_FALSE(line.onDeadline(*line.deadline()));
    const auto output = line.takeOutput();
    ASSERT_EQ(output.size(), 1U);
    EXPECT_EQ(std::get<SetHostBaud>(output[0]).baud, 115'200U);
    EXPECT_TRUE(line.idle());
    EXPECT_EQ(line.timing().byteTime, Duration(86'805));
}

TEST(Line, LeavesTheGapOnlyWhereItIsNeeded) {
    Line line(4ms, 10ms);
    line.run({Line::Gap{}}, TimePoint(1s));
    EXPECT_TRUE(line.idle()) << "nothing was sent for a second";
    line.begin(nop(), TimePoint(1s));
    line.abandon();
    line.run({Line::Gap{}}, TimePoint(1s));
    EXPECT_EQ(line.deadline(), TimePoint(1s) + Duration(4 * 520'833) + 512us);
}

}  // namespace

}  // namespace nmc::test

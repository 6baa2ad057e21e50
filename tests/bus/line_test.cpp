// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/line.h"
#include "protocol/commands.h"
#include "tests/bus/replies.h"
#include "tests/bus/scriptedbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr StatusItems kPoll{0x0B};

[[nodiscard]] Request nop(StatusItems items = kPoll) {
    return {BusAddress(1), encode(Nop{}), {{ModuleType::Servo, 4}, items}};
}

/// The end of the exchange in progress if nothing more arrives.
[[nodiscard]] std::optional<ReplyEnd> endOf(Line& line) {
    if (const auto deadline = line.deadline())
        line.onDeadline(*deadline);
    return line.takeEnd();
}

TEST(LineTiming, IsTheSumOfItsParts) {
    // 4 bytes out and 8 back at 19 200 Bd: 12 x 520.833 us, 0.512 ms, 4 ms for the adapter, and a margin of
    // 10 ms.
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
    line.onDeadline(deadline - 1ns);
    EXPECT_FALSE(line.takeEnd());
    line.onDeadline(deadline);
    const auto end = line.takeEnd();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Unresponsive);
    EXPECT_TRUE(line.idle());
}

TEST(Line, LetsNothingLeaveThatIsNotPermitted) {
    const auto packetOf = [](const auto& command) { return toPacket({BusAddress(1), encode(command)}); };
    const auto leaves = [](Line::Permit permit, const PacketBytes& packet) {
        Line line(4ms, 10ms);
        line.permit(permit);
        line.run({Line::Nulls{}, Line::Packet{packet}}, TimePoint(1s));
        const std::vector<Output> output = line.takeOutput();
        EXPECT_EQ(std::get<Send>(output.at(0)).bytes, std::vector<std::uint8_t>(kNullCount, 0));
        return output.size() == 2;
    };
    const PacketBytes stop = packetOf(servo::StopMotor{true, servo::StopManner::Abruptly, {}});
    for (const auto permit :
         {Line::Permit::Everything, Line::Permit::Questions, Line::Permit::QuestionsAndStops}) {
        const bool all = permit == Line::Permit::Everything;
        EXPECT_TRUE(leaves(permit, packetOf(Nop{})));
        EXPECT_TRUE(leaves(permit, packetOf(ReadStatus{kAllItems})));
        EXPECT_EQ(leaves(permit, stop), permit != Line::Permit::Questions);
        EXPECT_EQ(leaves(permit, packetOf(DefineStatus{kPoll})), all);
        EXPECT_EQ(leaves(permit, packetOf(SetAddress{BusAddress(1)})), all);
        EXPECT_EQ(leaves(permit, packetOf(StartMotion{})), all);
        EXPECT_EQ(leaves(permit, packetOf(servo::LoadTrajectory{})), all);
        EXPECT_EQ(leaves(permit, packetOf(servo::SetGain{})), all);
        EXPECT_EQ(leaves(permit, packetOf(SetBaud{5})), all);
        EXPECT_EQ(leaves(permit, packetOf(HardReset{})), all);
    }
}

/// AA 01 26 0A 00 31 is Set Output to a PIC-I/O and would be a broken Set Gain to a PIC-SERVO.
TEST(Line, LetsNoOtherOutputsLeaveThanThoseOfTheStop) {
    const auto setOutput = [](std::uint16_t outputs) {
        return toPacket({BusAddress(1), encode(io::SetOutput{outputs})});
    };
    for (const auto permit : {Line::Permit::Questions, Line::Permit::QuestionsAndStops}) {
        Line line(4ms, 10ms);
        line.permit(permit, {setOutput(0x000A)});
        line.run({Line::Packet{setOutput(0x000A)}, Line::Packet{setOutput(0x000B)}}, TimePoint(1s));
        std::vector<std::string> left;
        for (const Output& output : line.takeOutput())
            left.push_back(toHex(std::get<Send>(output).bytes));
        const bool stops = permit == Line::Permit::QuestionsAndStops;
        EXPECT_EQ(left, stops ? std::vector<std::string>{"AA 01 26 0A 00 31"} : std::vector<std::string>{});
    }
}

TEST(Line, EndsAnExchangeThatIsNotPermittedInSilence) {
    Line line(4ms, 10ms);
    line.permit(Line::Permit::Questions);
    line.begin({BusAddress(1), encode(DefineStatus{kPoll}), {{ModuleType::Servo, 4}, kPoll}}, TimePoint(1s));
    EXPECT_TRUE(line.takeOutput().empty());
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Unresponsive);
}

/// Eight bytes at 19 200 Bd, from a chip that sends 2 % faster.
constexpr Duration kShortestAnswer = Duration(8 * 520'833) * 98 / 100;

TEST(Line, ReckonsFromWhatIsStillLeaving) {
    Line line(4ms, 10ms);
    const TimePoint now(1s);
    line.run({Line::Nulls{}}, now);
    line.begin(nop(), now);
    EXPECT_EQ(line.deadline(), now + Duration(28 * 520'833) + 512us + 14ms);
    line.onBytes(fromHex("19 00 00 00 00 00 00 19 "), now + 20ms);
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->latched, now + Duration(20 * 520'833) + 256us);
    // The eight bytes of the answer took at least 4.08 ms, so it was latched no later than this.
    EXPECT_EQ(end->latchedBy, now + 20ms - kShortestAnswer);
}

TEST(Line, TellsHowMuchLaterAReplyCameThanIsExplained) {
    // 4 bytes out, a tick, 8 bytes back, and half a tick for this computer.
    const Duration prompt = Duration(4 * 520'833) + kShortestAnswer + 768us;
    for (const Duration latency : {Duration(0ms), Duration(4ms), Duration(16ms)}) {
        // 4 ms is the least time to wait with any adapter, and not a latency that is known.
        const Duration known = latency == Duration(4ms) ? Duration{} : latency;
        for (const Duration late : {Duration(-1ms), Duration(0ms), Duration(3ms)}) {
            Line line(latency, 10ms);
            line.begin(nop(), TimePoint(1s));
            line.onBytes(fromHex("19 00 00 00 00 00 00 19 "), TimePoint(1s) + prompt + known + late);
            const auto end = endOf(line);
            ASSERT_TRUE(end);
            // A reply that arrives before this time was latched earlier, but not before half a tick. A known
            // adapter latency explains a later reply, but does not make a reply early.
            const Duration early = known > Duration{} ? Duration{} : Duration(-512us);
            EXPECT_EQ(end->late, std::max(late, early));
        }
    }
}

TEST(Line, TakesAReplyInPieces) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex("19 64 00 "), TimePoint(1s + 8ms));
    EXPECT_FALSE(line.takeEnd());
    line.onBytes(fromHex("00 00 05 00 82 "), TimePoint(1s + 9ms));
    EXPECT_FALSE(line.takeEnd()) << "surplus bytes may still come";
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Accepted);
    EXPECT_EQ(end->report.position, 100);
    EXPECT_EQ(end->report.analog, 5);
    EXPECT_EQ(end->arrived - end->sent, Duration(9ms));
    EXPECT_EQ(end->wireTime, Duration(12 * 520'833) + 256us);
}

TEST(Line, RejectsAPartialReplyAtTheTimeout) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex("19 64 00 "), TimePoint(1s + 8ms));
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Partial);
    EXPECT_EQ(end->bytes, (ReplyBytes{0x19, 0x64, 0x00}));
}

TEST(Line, RejectsAWrongSum) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex("19 64 00 00 00 05 00 83 "), TimePoint(1s + 8ms));
    const auto end = line.takeEnd();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::BadChecksum);
}

TEST(Line, RejectsAReplyWithSurplusBytesInTheSameRead) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex("19 00 00 00 00 00 00 19 AA "), TimePoint(1s + 8ms));
    const auto end = line.takeEnd();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Rejected);
    EXPECT_EQ(end->rejection, Rejection::Surplus);
    EXPECT_EQ(line.statistics().surplusBytes, 1U);
}

TEST(Line, RejectsAReplyWithSurplusBytesWithinTwoCharacterTimes) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex(kReply), TimePoint(1s + 8ms));
    ASSERT_EQ(line.deadline(), TimePoint(1s + 8ms) + Duration(2 * 520'833));
    EXPECT_FALSE(line.ready());
    line.onBytes(fromHex("BB "), TimePoint(1s + 9ms));
    const auto end = line.takeEnd();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Rejected);
    EXPECT_EQ(end->rejection, Rejection::Surplus);
    EXPECT_EQ(end->bytes.size(), 9U);
}

/// An echo, noise, or the rest of an earlier reply; the command has left after 2.08 ms.
TEST(Line, TakesNothingForTheReplyThatComesBeforeTheCommandHasLeft) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex(kReply), TimePoint(1s + 2ms));
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Unresponsive);
    EXPECT_EQ(line.statistics().staleBytes, 8U);
}

TEST(Line, TakesTheReplyThatFollowsEarlyBytes) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex("AA "), TimePoint(1s + 2ms));
    line.onBytes(fromHex(kReply), TimePoint(1s + 8ms));
    const auto end = endOf(line);
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Accepted);
    EXPECT_EQ(end->bytes.size(), 8U);
}

TEST(Line, BelievesAReplyThatNothingFollows) {
    Line line(4ms, 10ms);
    line.begin(nop(), TimePoint(1s));
    line.onBytes(fromHex(kReply), TimePoint(1s + 8ms));
    line.onDeadline(*line.deadline());
    const auto end = line.takeEnd();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->result, ReplyResult::Accepted);
    line.onBytes(fromHex("BB "), TimePoint(1s + 12ms));
    EXPECT_EQ(line.statistics().staleBytes, 1U);
    EXPECT_TRUE(line.idle());
}

/// The next command is sent at once; no module can answer it before its last byte has left.
TEST(Line, RejectsAPipelinedReplyForBytesThatComeBeforeTheNextCommandHasLeft) {
    Line line(4ms, 10ms);
    Request request = nop();
    request.framing = Framing::Pipelined;
    line.begin(request, TimePoint(1s));
    line.onBytes(fromHex(kReply), TimePoint(1s + 8ms));
    ASSERT_TRUE(line.ready());
    line.begin(request, TimePoint(1s + 8ms));
    line.onBytes(fromHex("BB "), TimePoint(1s + 9ms));  // the command has left after 10.08 ms
    const auto first = line.takeEnd();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->result, ReplyResult::Rejected);
    EXPECT_EQ(first->rejection, Rejection::Surplus);
    line.onBytes(fromHex(kReply), TimePoint(1s + 16ms));
    const auto second = endOf(line);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->result, ReplyResult::Accepted) << "it is judged by itself";
}

TEST(Line, BelievesAPipelinedReplyOnceTheNextOneBegins) {
    Line line(4ms, 10ms);
    Request request = nop();
    request.framing = Framing::Pipelined;
    line.begin(request, TimePoint(1s));
    line.onBytes(fromHex(kReply), TimePoint(1s + 8ms));
    line.begin(request, TimePoint(1s + 8ms));
    line.onBytes(fromHex("19 "), TimePoint(1s + 11ms));
    const auto first = line.takeEnd();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->result, ReplyResult::Accepted);
    EXPECT_EQ(line.statistics().surplusBytes, 0U);
}

TEST(Line, TakesAReplyOfUnknownLengthAsLongAsBytesCome) {
    for (const std::string reply : {"19 19 ", "19 64 00 00 00 7D ", "19 00 00 00 00 00 00 19 "}) {
        Line line(4ms, 10ms);
        line.begin({BusAddress(1), encode(Nop{}), {}, Framing::Open}, TimePoint(1s));
        TimePoint now(1s + 6ms);
        for (std::size_t i = 0; i < reply.size(); i += 3, now += 520us)
            line.onBytes(fromHex(reply.substr(i, 3)), now);
        EXPECT_FALSE(line.takeEnd());
        const auto end = endOf(line);
        ASSERT_TRUE(end);
        EXPECT_EQ(end->result, ReplyResult::Accepted) << reply;
        EXPECT_EQ(end->bytes.size(), reply.size() / 3);
    }
}

TEST(Line, RejectsAReplyOfUnknownLengthWithAWrongSum) {
    Line line(4ms, 10ms);
    line.begin({BusAddress(1), encode(Nop{}), {}, Framing::Open}, TimePoint(1s));
    line.onBytes(fromHex("19 64 00 00 00 7E "), TimePoint(1s + 8ms));
    EXPECT_EQ(endOf(line)->result, ReplyResult::BadChecksum);
}

TEST(Line, DoesNotCountRepliesThatItDoesNotRead) {
    Line line(4ms, 10ms);
    const PacketBytes packet = toPacket({BusAddress(1), encode(Nop{})});
    line.run({Line::Packet{packet, 8}, Line::Pause{10ms}}, TimePoint(1s));
    line.onBytes(fromHex("19 00 00 00 00 00 00 19 AA "), TimePoint(1s + 8ms));
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
    line.onDeadline(now + 100ms);
    EXPECT_EQ(line.takeOutput().size(), 2U);
    // Sixteen bytes have to leave first.
    EXPECT_EQ(line.deadline(), now + 100ms + Duration(16 * 520'833) + 1ms);
    line.onDeadline(*line.deadline());
    const auto output = line.takeOutput();
    ASSERT_EQ(output.size(), 1U);
    EXPECT_EQ(std::get<SetHostBaud>(output[0]).baud, 115'200U);
    EXPECT_TRUE(line.idle());
    EXPECT_EQ(line.timing().byteTime, Duration(86'805));
}

/// DS-V 4.1: 0.51 ms after a packet that is not answered, ensured on the line itself, where an adapter cannot
/// shorten them.
TEST(Line, KeepsPacketsApartThatNobodyAnswersEvenIfTheyAreWrittenTogether) {
    for (const std::uint32_t rate : {9'600U, 19'200U, 57'600U, 115'200U}) {
        Line line(4ms, 10ms);
        line.run({SetHostBaud{rate}, Line::Packet{toPacket({BusAddress(0x81), encode(SaveAsHome{})})},
                  Line::Spacer{}, Line::Packet{toPacket({BusAddress(0x82), encode(SaveAsHome{})})}},
                 TimePoint(1s));
        auto output = line.takeOutput();
        ASSERT_EQ(output.size(), 3U) << rate;
        EXPECT_EQ(*line.deadline(),
                  TimePoint(1s) +
                      byteTimeAtBaud(rate) * (4 + static_cast<int>(std::get<Send>(output[2]).bytes.size())))
            << "no bytes wait in a buffer, where they would delay a stop";
        const auto& nulls = std::get<Send>(output[2]).bytes;
        EXPECT_THAT(nulls, testing::Each(0));
        EXPECT_GE(static_cast<double>(nulls.size()) * 10.0 / rate, 0.51e-3) << rate;
        EXPECT_LT(static_cast<double>(nulls.size()) * 10.0 / rate, 0.51e-3 + 10.0 / rate * 1.05) << rate;
    }
}

TEST(Line, LeavesTheGapOnlyWhereItIsNeeded) {
    Line line(4ms, 10ms);
    line.run({Line::Gap{}}, TimePoint(1s));
    EXPECT_TRUE(line.idle()) << "nothing was sent for a second";
    line.begin(nop(), TimePoint(1s));
    line.abandon(TimePoint(1s));
    line.run({Line::Gap{}}, TimePoint(1s));
    EXPECT_EQ(line.deadline(), TimePoint(1s) + Duration(4 * 520'833) + 512us);
}

}  // namespace

}  // namespace nmc::test

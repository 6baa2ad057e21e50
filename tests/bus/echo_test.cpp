// SPDX-License-Identifier: GPL-3.0-or-later
// An adapter that echoes what is sent, at the level of single bytes. At 19 200 Bd a byte takes 520.833 us: a
// command of four bytes has left after 2.083 ms.
#include <gtest/gtest.h>

#include "bus/line.h"
#include "protocol/commands.h"
#include "tests/bus/replies.h"
#include "tests/bus/scriptedbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr const char* kCommand = "AA 01 0E 0F ";

/// Its echo was missing or wrong, or the adapter has begun to echo.
[[nodiscard]] bool rejectedForEcho(const ReplyEnd& end) {
    return end.result == ReplyResult::Rejected && end.rejection == Rejection::Echo;
}

class EchoingLine : public testing::Test {
protected:
    void ask(Framing framing = Framing::Settled) {
        now += 100ms;
        line.begin({BusAddress(1), encode(Nop{}), {{ModuleType::Servo, 4}, StatusItems{0x0B}}, framing}, now);
    }
    /// Passes bytes to the line, `after` the command began to leave.
    bool hear(const std::string& hex, Duration after) { return line.onBytes(fromHex(hex), now + after); }
    [[nodiscard]] ReplyEnd end() {
        while (const auto deadline = line.deadline())
            line.onDeadline(*deadline);
        const auto end = line.takeEnd();
        EXPECT_TRUE(end);
        EXPECT_FALSE(line.takeEnd());
        return end.value_or(ReplyEnd{});
    }
    /// Lets the line recognise the echo, which the first exchange shows.
    void recognise() {
        ask();
        hear(kCommand, 2083us);
        EXPECT_TRUE(rejectedForEcho(end()));
        ask();
        ASSERT_TRUE(line.echoes());
        hear(kCommand, 2083us);
        hear(kReply, 7ms);
        EXPECT_EQ(end().result, ReplyResult::Accepted);
        line.statistics() = {};
    }
    Line line{4ms, 10ms};
    TimePoint now{1s};
};

TEST_F(EchoingLine, IsRecognisedByOneExactEchoWhichIsNoAnswer) {
    ask();
    hear(kCommand, 2083us);
    hear(kReply, 7ms);
    const ReplyEnd first = end();
    EXPECT_TRUE(rejectedForEcho(first));
    EXPECT_EQ(toHex(first.bytes).rfind("AA 01 0E 0F", 0), 0U) << "the packet monitor shows it";
    ask();
    EXPECT_TRUE(line.echoes());
}

TEST_F(EchoingLine, IsRecognisedWhereTheLastBytesComeBehindTheReplysLength) {
    now += 100ms;  // five bytes out, four back
    line.begin(
        {BusAddress(1), encode(ReadStatus{kIdentityItems}), {{ModuleType::Servo, 4}, kIdentityItems}, {}},
        now);
    for (const char* byte : {"AA ", "01 ", "13 ", "20 "})
        hear(byte, 20ms);
    EXPECT_TRUE(rejectedForEcho(end()));
    hear("34 ", 21ms);
    ask();
    EXPECT_TRUE(line.echoes());
}

/// The module does not answer: neither AA 01 0E 0F is its answer, nor the bytes after the AA, although their
/// sum is right.
TEST_F(EchoingLine, GivesSilenceWhereNobodyAnswers) {
    recognise();
    ask();
    EXPECT_FALSE(hear(kCommand, 2083us)) << "no module was heard";
    const ReplyEnd silent = end();
    EXPECT_EQ(silent.result, ReplyResult::Unresponsive);
    EXPECT_TRUE(silent.bytes.empty());
}

TEST_F(EchoingLine, TakesEchoAndAnswerInOnePiece) {
    recognise();
    ask();
    EXPECT_TRUE(hear(std::string(kCommand) + kReply, 20ms));
    EXPECT_EQ(end().result, ReplyResult::Accepted);
}

TEST_F(EchoingLine, TakesAnOpenAnswerBehindTheEcho) {
    recognise();
    ask(Framing::Open);
    hear(kCommand, 2083us);
    hear(kReply, 7ms);
    const ReplyEnd open = end();
    EXPECT_EQ(open.result, ReplyResult::Accepted);
    EXPECT_EQ(open.bytes.size(), 8U);
}

/// The echo of the next command arrives at a time when surplus bytes would spoil the reply.
TEST_F(EchoingLine, SpoilsNoPipelinedReplyByTheEchoOfTheNextCommand) {
    recognise();
    ask(Framing::Pipelined);
    hear(kCommand, 2083us);
    hear(kReply, 7ms);
    ASSERT_TRUE(line.ready());
    now += 7ms - 100ms;
    ask(Framing::Pipelined);
    for (const char* byte : {"AA ", "01 ", "0E ", "0F "})
        hear(byte, 1ms);
    hear(kReply, 7ms);
    const auto first = line.takeEnd();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->result, ReplyResult::Accepted);
    EXPECT_EQ(end().result, ReplyResult::Accepted);
    EXPECT_EQ(line.statistics().surplusBytes, 0U);
}

TEST_F(EchoingLine, RejectsAnAnswerBehindADamagedEcho) {
    for (const char* damaged :
         {"AA 01 0F 0F ", "AA 01 0E ", "01 0E 0F ", "AA 01 0E 0E ", "AA 01 77 0E 0F "}) {
        SCOPED_TRACE(damaged);
        Line fresh(4ms, 10ms);
        std::swap(line, fresh);
        recognise();
        ask();
        hear(damaged, 2083us);
        hear(kReply, 7ms);
        EXPECT_TRUE(rejectedForEcho(end()));
        ask();
        EXPECT_TRUE(line.echoes());
        hear(kCommand, 2083us);
        hear(kReply, 7ms);
        EXPECT_EQ(end().result, ReplyResult::Accepted) << "the next one is right";
    }
}

/// Nulls and blind stops are echoed, too; with an adapter that holds bytes back, their echo arrives only
/// after the next command.
TEST_F(EchoingLine, PassesByWhatComesBackLate) {
    recognise();
    now += 100ms;
    line.run({Line::Nulls{}, Line::Pause{1ms}, DiscardInput{}}, now);
    while (line.busy())
        line.onDeadline(*line.deadline());
    ask();
    hear("00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 AA 01 17 05 1D ", 1ms);
    hear(kCommand, 16ms);
    hear(kReply, 17ms);
    EXPECT_EQ(end().result, ReplyResult::Accepted);
}

TEST_F(EchoingLine, CountsTheEchoOfAScriptAsExpected) {
    recognise();
    now += 100ms;
    line.run({Line::Nulls{}, Line::Lag{}}, now);
    EXPECT_FALSE(hear("00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 ", 8334us));
    EXPECT_EQ(line.statistics().surplusBytes, 0U);
    EXPECT_TRUE(hear("19 ", 9ms)) << "another host";
    EXPECT_EQ(line.statistics().surplusBytes, 1U);
}

TEST_F(EchoingLine, CountsTheRestOfAnAbandonedExchangeAsExpected) {
    recognise();
    ask();
    hear("AA 01 ", 1042us);
    line.abandon(now + 1042us);
    hear("0E 0F ", 2083us);
    hear(kReply, 7ms);
    EXPECT_EQ(line.statistics().surplusBytes, 0U);
    // A stop that follows at once.
    ask();
    hear(kCommand, 2083us);
    hear(kReply, 7ms);
    EXPECT_EQ(end().result, ReplyResult::Accepted);
}

/// The echo has been switched off at the adapter.
TEST_F(EchoingLine, EndsWithAWholeAnswerWithoutEchoWhichDoesNotCount) {
    recognise();
    ask();
    hear(kReply, 7ms);
    EXPECT_TRUE(rejectedForEcho(end()));
    EXPECT_FALSE(line.echoes());
    ask();
    hear(kReply, 7ms);
    EXPECT_EQ(end().result, ReplyResult::Accepted);
}

/// Noise or half an answer does not mean that the echo is off.
TEST_F(EchoingLine, DoesNotEndByNoiseOrSilence) {
    recognise();
    for (const char* heard : {"19 00 00 ", "19 00 00 00 00 00 00 18 ", ""}) {
        ask();
        hear(heard, 7ms);
        EXPECT_NE(end().result, ReplyResult::Accepted);
        EXPECT_TRUE(line.echoes());
    }
}

/// A motor may be at a position whose reply contains the bytes of a command.
TEST_F(EchoingLine, IsNotTakenForOneByAnAnswerThatHoldsTheCommand) {
    for (int i = 0; i < 3; ++i) {
        ask();
        hear("19 AA 01 0E 0F 00 00 E1 ", 7ms);
        EXPECT_EQ(end().result, ReplyResult::Accepted);
        EXPECT_FALSE(line.echoes());
    }
}

/// Noise may come before the echo: a first byte that is not that of the command.
TEST_F(EchoingLine, IsNotRecognisedBehindSomethingElse) {
    ask();
    hear("55 ", 1ms);
    hear(kCommand, 2083us);
    EXPECT_NE(end().result, ReplyResult::Accepted);
    ask();
    EXPECT_FALSE(line.echoes());
}

}  // namespace

}  // namespace nmc::test

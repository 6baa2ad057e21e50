// SPDX-License-Identifier: GPL-3.0-or-later
// F-01 to F-09: bytes lost, doubled and wrong, in commands and in replies.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Moves two servos to and fro for this time while frames are damaged. It does not matter what they do, but
/// that what is reported about them is true.
void moveAbout(FaultyBus& bus, Duration time) {
    const TimePoint end = bus.now + time;
    for (std::int32_t way = 1'000; bus.now < end; way = -way)
        for (std::uint8_t module : {std::uint8_t{0}, std::uint8_t{1}}) {
            bus.submit({loadMove(module, Truth::placeOf(module) + way), start(module)});
            bus.runFor(400ms);
        }
}

/// Number of bytes in the answer to the last command.
[[nodiscard]] std::size_t expectedReply(const FaultyBus& bus) {
    StatusItems items;
    for (const auto& sent : bus.sent)
        if (codeOf(sent.bytes) == CommandCode::DefineStatus)
            items = StatusItems(sent.bytes[3]);
    if (codeOf(bus.sent.back().bytes) == CommandCode::ReadStatus)
        items = StatusItems(bus.sent.back().bytes[3]);
    return replyLength({ModuleType::Servo, 4}, items);
}

class DamagedFrames : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
    }
    FaultyBus bus{servos(2), kFast};
};

// ---- F-01 ----

/// Whichever packet loses a byte, the stop that follows immediately is carried out.
TEST(F01_ByteLostInACommand, LeavesEveryLaterStopCarriedOut) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(2), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_EQ(bus.perform({loadVelocity(0, 2 * kOnePerTick, true)}), Outcome::Done);
        bus.runFor(200ms);
        bus.fault("bus drop cmd n=1");
        ASSERT_TRUE(bus.runUntil([&] { return bus.struck() == 1; }, 1s));
        bus.runFor(static_cast<Duration::rep>(seed) * 500us);
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_TRUE(FaultyBus::stopped(*stop, 0));
        EXPECT_TRUE(bus.stands(0));
    }
}

TEST(F01_ByteLostInACommand, OfTheStopItselfIsMadeGood) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(2), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_EQ(bus.perform({loadVelocity(0, 2 * kOnePerTick, true)}), Outcome::Done);
        bus.runFor(200ms);
        bus.fault("bus drop cmd on=stop_motor n=1");
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_TRUE(FaultyBus::stopped(*stop, 0));
        EXPECT_TRUE(bus.stands(0));
    }
}

/// Once the time-out has shown that a byte may be missing, nulls are sent before a stop.
TEST(F01_ByteLostInACommand, IsFlushedBeforeAStop) {
    FaultyBus bus(servos(1), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    bus.runFor(100ms);
    bus.fault("bus drop cmd n=1");
    const auto timeouts = bus.engine.statistics().timeouts;
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > timeouts; }, 1s));
    const std::size_t from = bus.sent.size();
    bus.engine.stopAll(bus.now);
    bus.runFor(5ms);
    ASSERT_GT(bus.sent.size(), from);
    EXPECT_EQ(bus.sent[from].bytes, std::vector<std::uint8_t>(16, 0));
}

using F01_ByteLostInACommandOfTwo = DamagedFrames;
TEST_F(F01_ByteLostInACommandOfTwo, MakesNoSampleWrong) {
    Truth truth(bus);
    bus.fault("bus drop cmd p=.03");
    moveAbout(bus, 20s);
    truth.expectAllTrue();
    bus.expectOnlyExecutedWhatWasSent();
}

// ---- F-02, F-04, F-07: replies ----

using F02_ByteLostInAReply = DamagedFrames;
TEST_F(F02_ByteLostInAReply, IsNeverMadeUpFromTheNextReply) {
    Truth truth(bus);
    bus.fault("bus drop status p=.03");
    moveAbout(bus, 20s);
    EXPECT_GT(bus.struck(), 50U);
    EXPECT_GE(bus.engine.statistics().resyncs, bus.struck() / 2);
    truth.expectAllTrue();
}

using F04_ByteDoubledInAReply = DamagedFrames;
TEST_F(F04_ByteDoubledInAReply, MakesNoSampleWrong) {
    Truth truth(bus);
    bus.fault("bus dup status p=.03");
    moveAbout(bus, 20s);
    ASSERT_GT(bus.struck(), 50U);
    EXPECT_GT(bus.engine.statistics().surplusBytes, 0U);
    EXPECT_GE(bus.engine.statistics().badChecksum, bus.struck() / 2);
    truth.expectAllTrue();
}

/// There is one byte too many after a frame whose checksum is right.
TEST_F(F04_ByteDoubledInAReply, RejectsTheWholeFrame) {
    bus.runFor(200ms);
    std::size_t at = 0;
    std::size_t command = 0;
    bus.onHostByte = [&](std::uint8_t&) {
        at = command == bus.sent.size() ? at + 1 : 0;
        command = bus.sent.size();
        return at + 1 == expectedReply(bus) ? 2U : 1U;
    };
    const std::size_t samples = bus.count<Sample>();
    bus.runFor(300ms);
    EXPECT_LE(bus.count<Sample>(), samples + 1) << "only the one that was under way";
    EXPECT_GT(bus.engine.statistics().rejections[static_cast<std::size_t>(Rejection::Surplus)], 0U);
}

using F07_ByteWrongInAReply = DamagedFrames;
TEST_F(F07_ByteWrongInAReply, IsNeverBelieved) {
    Truth truth(bus);
    bus.fault("bus flip status p=.03");
    moveAbout(bus, 20s);
    ASSERT_GT(bus.struck(), 50U);
    EXPECT_GE(bus.engine.statistics().badChecksum, bus.struck() * 9 / 10);
    truth.expectAllTrue();
}

// ---- F-03, F-05: commands ----

using F03_ByteDoubledInACommand = DamagedFrames;
TEST_F(F03_ByteDoubledInACommand, CarriesOutNothingThatWasNotSent) {
    Truth truth(bus);
    bus.fault("bus dup cmd p=.03");
    moveAbout(bus, 20s);
    EXPECT_GT(bus.struck(), 50U);
    bus.expectOnlyExecutedWhatWasSent();
    truth.expectAllTrue();
    bus.clearFaults();
    bus.runFor(2s);
    EXPECT_EQ(bus.perform({loadMove(0, 0)}), Outcome::Done) << "it works again afterwards";
}

using F05_ByteWrongInACommand = DamagedFrames;
TEST_F(F05_ByteWrongInACommand, IsNotCarriedOutAndSentAgain) {
    Truth truth(bus);
    bus.fault("bus flip cmd p=.03");
    moveAbout(bus, 20s);
    EXPECT_GT(bus.struck(), 50U);
    EXPECT_GT(bus.engine.statistics().refused, bus.struck() / 10) << "many flips keep the packet's length";
    EXPECT_GT(bus.engine.statistics().retries, 0U);
    bus.expectOnlyExecutedWhatWasSent();
    truth.expectAllTrue();
}

TEST_F(F05_ByteWrongInACommand, OfAnOperationIsMadeGood) {
    bus.fault("bus flip cmd bit=24 on=save_as_home n=1");
    EXPECT_EQ(bus.perform({toServo(0, SaveAsHome{})}), Outcome::Done);
    EXPECT_EQ(bus.executed(0, CommandCode::SaveAsHome), 1U);
    EXPECT_EQ(bus.count<CommandRefused>(), 1U);
}

// ---- F-06 ----

/// A load may be changed into another one on its way. The motor then either stays within its corridor, or is
/// stopped within three polls of leaving it.
TEST(F06_CommandChangedWithTheRightSum, EndsInAStopOnceTheMotorLeavesItsCorridor) {
    constexpr std::int32_t kGoal = 4'000;
    constexpr std::int32_t kFarOut = 1'000;  // beyond any overshoot of these gains
    unsigned left = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(1), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault("bus collide cmd on=load_trajectory n=1");
        bus.submit({loadMove(0, kGoal), start(0)});
        const auto isOutside = [&] {
            const auto position = bus.servo(0).position;
            return position < -kFarOut || position > kGoal + kFarOut;
        };
        if (!bus.runUntil([&] { return isOutside() || bus.motionSuspects(0) > 0; }, 4s))
            continue;
        ++left;
        const std::size_t polls = bus.samplesOf(0);
        const auto told = [&] { return bus.motionSuspects(0) > 0; };
        EXPECT_TRUE(bus.runUntil(told, 1s));
        EXPECT_LE(bus.samplesOf(0), polls + 3);
        bus.runFor(500ms);
        EXPECT_TRUE(bus.stands(0));
    }
    EXPECT_GT(left, 5U) << "the fault must be able to do harm";
}

// ---- F-08, F-09 ----

TEST(F08_CommandRefusedByTheModule, IsSentAgainAndCounted) {
    FaultyBus bus(servos(2));
    ASSERT_TRUE(bus.connectAndEnable());
    const auto before = bus.engine.statistics();
    bus.fault("module 1 cksum on=save_as_home n=1");
    EXPECT_EQ(bus.perform({toServo(0, SaveAsHome{})}), Outcome::Done);
    EXPECT_EQ(bus.executed(0, CommandCode::SaveAsHome), 1U);
    EXPECT_EQ(bus.engine.statistics().refused, before.refused + 1);
    EXPECT_EQ(bus.engine.statistics().retries, before.retries + 1);
    EXPECT_EQ(bus.engine.statistics().timeouts, before.timeouts);
    ASSERT_EQ(bus.count<CommandRefused>(), 1U);
    EXPECT_EQ(bus.last<CommandRefused>()->module, ModuleIndex(0));
}

/// The status in such a reply shows only one thing: the module is alive.
TEST(F08_CommandRefusedByTheModule, IsNoSample) {
    FaultyBus bus(servos(1));
    ASSERT_TRUE(bus.connectAndEnable());
    bus.runFor(500ms);
    bus.fault("module 1 cksum");
    bus.runFor(200ms);  // an exchange that is already under way is answered
    const std::size_t samples = bus.samplesOf(0);
    bus.runFor(2s);
    EXPECT_EQ(bus.samplesOf(0), samples);
}

TEST(F09_StatusBitOneWrong, NeverStartsTwice) {
    FaultyBus bus(servos(1));
    ASSERT_TRUE(bus.connectAndEnable());
    bus.fault("bus flip status bit=1 on=start_motion n=1");
    ASSERT_TRUE(bus.perform({loadMove(0, 3'000), start(0)}));
    bus.runFor(3s);
    EXPECT_EQ(bus.executed(0, CommandCode::StartMotion), 1U);
    EXPECT_LE(std::abs(bus.servo(0).position - 3'000), 3);
    bus.expectNoViolations();
}

/// A move was started, but its answer looks like a refusal and has a matching checksum.
TEST(F09_StatusBitOneWrong, NeverStartsTwiceWhenTheSumFits) {
    FaultyBus bus(servos(1));
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadMove(0, 3'000)}), Outcome::Done);
    // Bit 1 of the first answer to a Start Motion is changed, and the checksum with it.
    std::size_t at = 0;
    bool struck = false;
    bus.onHostByte = [&](std::uint8_t& byte) {
        if (struck || codeOf(bus.sent.back().bytes) != CommandCode::StartMotion)
            return 1U;
        if (at == 0)
            byte = static_cast<std::uint8_t>(byte | 0x02U);
        if (at + 1 == expectedReply(bus))
            byte = static_cast<std::uint8_t>(byte + 0x02U);
        struck = ++at == expectedReply(bus);
        return 1U;
    };
    ASSERT_TRUE(bus.perform({start(0)}));
    EXPECT_TRUE(struck);
    bus.runFor(3s);
    EXPECT_EQ(bus.executed(0, CommandCode::StartMotion), 1U);
    bus.expectNoViolations();
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// F-17, F-21, F-22, F-45, F-47: unintended bytes on the line.
#include <gtest/gtest.h>

#include "sim/random.h"
#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Three servos at different positions.
class OnTheLine : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
    }
    void moveAbout(Duration time) {
        const TimePoint end = bus.now + time;
        for (std::int32_t way = 1'000; bus.now < end; way = -way) {
            bus.submit({loadMove(1, Truth::placeOf(1) + way), start(1)});
            bus.runFor(1s);
        }
    }
    FaultyBus bus{servos(3), kFast};
};

// ---- F-17 ----

using F17_NoiseBetweenPackets = OnTheLine;

TEST_F(F17_NoiseBetweenPackets, MakesNoSampleWrong) {
    Truth truth(bus);
    bus.fault("bus noise status t=5ms..15ms");
    moveAbout(30s);
    EXPECT_GT(bus.struck(), 2'000U);
    EXPECT_GT(bus.engine.statistics().surplusBytes, 0U);
    truth.expectAllTrue();
}

TEST_F(F17_NoiseBetweenPackets, TowardsTheModulesCarriesOutNothing) {
    Truth truth(bus);
    bus.fault("bus noise cmd t=5ms..15ms");
    moveAbout(30s);
    bus.expectOnlyExecutedWhatWasSent();
    truth.expectAllTrue();
}

TEST_F(F17_NoiseBetweenPackets, OfSixtyFourKilobytesIsOutlived) {
    sim::Random random(17);
    std::vector<std::uint8_t> noise(64 * 1024);
    for (std::uint8_t& byte : noise)
        byte = static_cast<std::uint8_t>(random.below(256));
    const std::size_t from = bus.sent.size();
    for (std::size_t i = 0; i < noise.size(); i += 64) {
        bus.engine.onBytes(ByteSpan(noise).subspan(i, 64), bus.now);
        bus.runFor(5ms);
    }
    bus.expectOnlyQuestions(from);
    ASSERT_TRUE(bus.health() != LinkHealth::Lost || bus.connect());
    bus.runFor(2s);
    Truth truth(bus);
    bus.runFor(1s);
    EXPECT_GT(truth.samples(), 300U);
    truth.expectAllTrue();
}

// ---- F-21, F-22 ----

using F21_OverrunInAModule = OnTheLine;

TEST_F(F21_OverrunInAModule, IsNotCarriedOutAndSentAgain) {
    Truth truth(bus);
    bus.fault("module 2 overrun p=.03");
    moveAbout(20s);
    EXPECT_GT(bus.struck(), 20U);
    EXPECT_GT(bus.engine.statistics().errors(), 0U);
    bus.expectOnlyExecutedWhatWasSent();
    truth.expectAllTrue();
}

TEST_F(F21_OverrunInAModule, OfAnOperationIsMadeGood) {
    bus.fault("module 1 overrun on=load_trajectory n=1");
    EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_LE(std::abs(bus.servo(0).position - 500), 3);
    EXPECT_EQ(bus.executed(0, CommandCode::LoadTrajectory), 1U);
}

using F22_OverrunInTheHost = OnTheLine;

/// What a kernel delivers after an overrun: a flood with holes in it. No queue of the engine grows.
TEST_F(F22_OverrunInTheHost, OfAMegabyteFillsNoQueue) {
    const std::vector<std::uint8_t> flood(16 * 1024, 0xA5);
    for (int i = 0; i < 64; ++i) {
        const std::size_t events = bus.events.size();
        const std::size_t sent = bus.sent.size();
        bus.engine.onBytes(flood, bus.now);
        bus.runFor(10ms);
        EXPECT_LT(bus.events.size() - events, 50U);
        EXPECT_LT(bus.sent.size() - sent, 50U);
    }
    ASSERT_TRUE(bus.health() != LinkHealth::Lost || bus.connect());
    bus.runFor(2s);
    Truth truth(bus);
    bus.runFor(1s);
    EXPECT_GT(truth.samples(), 300U);
    truth.expectAllTrue();
}

TEST_F(F22_OverrunInTheHost, ThatLosesEveryTenthByteMakesNoSampleWrong) {
    Truth truth(bus);
    unsigned n = 0;
    bus.losesByte = [&](std::uint8_t) { return ++n % 10 == 0; };
    bus.runFor(3s);
    EXPECT_EQ(truth.wrong(), 0U) << truth.first();
}

// ---- F-45 ----

using F45_ForeignHost = OnTheLine;

TEST_F(F45_ForeignHost, MakesNoSampleWrongAndIsNoticed) {
    Truth truth(bus);
    bus.fault("bus foreign on=nop t=50ms..150ms");
    bus.runFor(20s);
    EXPECT_GT(bus.struck(), 100U);
    EXPECT_GT(bus.engine.statistics().surplusBytes, 0U);
    EXPECT_GT(bus.count<HealthChanged>(), 0U) << "another host is sending";
    truth.expectAllTrue();
}

TEST_F(F45_ForeignHost, ThatAsksForOtherItemsMakesNoSampleWrong) {
    Truth truth(bus);
    bus.fault("bus foreign on=read_status t=50ms..150ms");
    bus.runFor(20s);
    truth.expectAllTrue();
}

TEST_F(F45_ForeignHost, ThatDefinesOtherItemsMakesNoSampleWrong) {
    Truth truth(bus);
    bus.fault("bus foreign on=define_status t=200ms..500ms");
    bus.runFor(20s);
    truth.expectAllTrue();
}

// ---- F-47 ----

/// Of the Load Trajectory commands that are cut short and filled up with nulls, about one in three hundred
/// still has a right checksum.
TEST(F47_CommandCutShortAndFilledWithZeros, MovesNothingWithoutAStart) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(1), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.runFor(200ms);
        const std::int32_t before = bus.servo(0).position;
        bus.fault("bus truncate cmd p=.3 on=load_trajectory");
        for (std::int32_t i = 0; i < 100; ++i) {
            bus.submit({loadMove(0, 1'000 + 77 * i)});
            bus.runFor(200ms);
            ASSERT_EQ(bus.servo(0).commandVelocity, 0.0);
        }
        EXPECT_LE(std::abs(bus.servo(0).position - before), 2);
        EXPECT_EQ(bus.executed(0, CommandCode::StartMotion), 0U);
    }
}

TEST(F47_CommandCutShortAndFilledWithZeros, IsNotStartedOnADoubt) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(1), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault("bus truncate cmd on=load_trajectory");
        const auto outcome = bus.perform({loadMove(0, 1'000), start(0)});
        EXPECT_NE(outcome, Outcome::Done);
        EXPECT_EQ(bus.sentTo(0, CommandCode::StartMotion), 0U);
        EXPECT_EQ(bus.servo(0).commandVelocity, 0.0);
    }
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// F-10 to F-14, F-18 to F-20: there is no answer, or a late one, or always the same one.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Number of stops since the given entry: a stop may be sent to one module or to all.
[[nodiscard]] std::size_t stops(const FaultyBus& bus, std::size_t from) {
    std::size_t n = 0;
    for (std::size_t i = from; i < bus.sent.size(); ++i)
        n += codeOf(bus.sent[i].bytes) == CommandCode::StopMotor ? 1U : 0U;
    return n;
}

[[nodiscard]] bool turns(FaultyBus& bus, std::uint8_t module) {
    if (!bus.connectAndEnable() ||
        bus.perform({loadVelocity(module, 2 * kOnePerTick, true)}) != Outcome::Done)
        return false;
    bus.runFor(500ms);
    return bus.servo(module).commandVelocity > 1.9;
}

[[nodiscard]] bool becomesLost(FaultyBus& bus) {
    return bus.runUntil([&] { return bus.count<LinkLost>() > 0 || bus.health() == LinkHealth::Lost; }, 10s);
}

// ---- F-10: one module ----

TEST(F10_ModuleSilent, CostsTheOthersLessThanATenth) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    std::size_t before = bus.samplesOf(0) + bus.samplesOf(2);
    bus.runFor(5s);
    const std::size_t inHealth = bus.samplesOf(0) + bus.samplesOf(2) - before;
    bus.fault("module 2 silent");
    bus.runFor(5s);
    const auto silences = bus.all<ModuleUnresponsive>();
    ASSERT_EQ(silences.size(), 1U);
    EXPECT_EQ(silences[0].module, ModuleIndex(1));
    EXPECT_TRUE(silences[0].silent);
    before = bus.samplesOf(0) + bus.samplesOf(2);
    bus.runFor(5s);
    EXPECT_GT(bus.samplesOf(0) + bus.samplesOf(2) - before, inHealth * 9 / 10);
    EXPECT_NE(bus.health(), LinkHealth::Lost) << "two of three answer";
}

TEST(F10_ModuleSilent, IsAskedOnceASecondAtMost) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(bus.connect());
    bus.fault("module 2 silent");
    bus.runFor(10s);
    const std::size_t from = bus.sent.size();
    bus.runFor(10s);
    EXPECT_LE(bus.sends("AA 02", from), 11U);
    EXPECT_GE(bus.sends("AA 02", from), 1U);
    bus.expectOnlyQuestions(from);
}

TEST(F10_ModuleSilent, IsOfferedAStopAndNamedByIt) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(turns(bus, 1));
    bus.fault("module 2 silent");
    bus.runFor(3s);
    EXPECT_EQ(bus.engine.stopReach(), 2U);
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->unreached, std::vector{ModuleIndex(1)});
    EXPECT_TRUE(bus.stands(1)) << "it hears although it does not answer";
}

// ---- F-11, F-19, F-20: all of them ----

TEST(F11_BusSilent, IsToldOnceAndAskedRarely) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    bus.fault("bus silent");
    ASSERT_TRUE(becomesLost(bus));
    const std::size_t samples = bus.count<Sample>();
    bus.runFor(10s);
    const std::size_t from = bus.sent.size();
    bus.runFor(20s);
    EXPECT_LE(bus.packets(from), 21U);
    EXPECT_EQ(bus.count<Sample>(), samples);
    EXPECT_EQ(bus.count<LinkLost>(), 1U);
    // When they answer again, nothing moves.
    bus.clearFaults();
    bus.runFor(5s);
    bus.expectOnlyQuestions(from);
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    EXPECT_GT(bus.count<Sample>(), samples + 100);
}

TEST(F11_BusSilent, GoesOnStoppingAsLongAsThePortIsOpen) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(turns(bus, 0));
    bus.fault("bus silent");
    ASSERT_TRUE(becomesLost(bus));
    const std::size_t from = bus.sent.size();
    bus.runFor(6s);
    EXPECT_GE(stops(bus, from), 11U) << "every half second";
    const std::size_t later = bus.sent.size();
    bus.runFor(60s);
    EXPECT_GE(stops(bus, later), 115U) << "the motor is still owed its stop";
    const std::size_t asked = bus.sent.size();
    bus.engine.stopAll(bus.now);
    bus.runFor(20ms);
    EXPECT_GT(stops(bus, asked), 0U) << "a stop that is requested is sent at once";
}

/// There are only time-outs, without a single answer: the motors of F-19 must not run on.
TEST(F19_ReceiveLineCut, StopsTheMotorsAllTheSame) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(turns(bus, 1));
    bus.fault("bus mute rx");
    ASSERT_TRUE(becomesLost(bus));
    bus.runFor(1s);
    EXPECT_TRUE(bus.stands(1));
}

TEST(F19_ReceiveLineCut, LetsAStopThroughThatReportsNobody) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(turns(bus, 0));
    bus.fault("bus mute rx");
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_TRUE(stop->stopped.empty());
    EXPECT_EQ(stop->unreached.size(), 2U);
    EXPECT_TRUE(bus.stands(0));
}

/// Nothing helps here except the hardware stop, and nothing may claim otherwise.
TEST(F20_TransmitLineCut, NeverClaimsAStop) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(turns(bus, 0));
    bus.fault("bus mute tx");
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_FALSE(FaultyBus::stopped(*stop, 0));
    EXPECT_EQ(stop->unreached.size(), 2U);
    EXPECT_FALSE(bus.stands(0));
    ASSERT_TRUE(becomesLost(bus));
    const std::size_t samples = bus.count<Sample>();
    bus.runFor(5s);
    EXPECT_EQ(bus.count<Sample>(), samples);
}

// ---- F-12 ----

class F12_SameFrameForEver : public testing::TestWithParam<std::tuple<std::uint8_t, bool>> {};

TEST_P(F12_SameFrameForEver, WhileMovingStopsTheModule) {
    const auto [version, inFocus] = GetParam();
    FaultyBus bus(servos(2, version), kFast);
    ASSERT_TRUE(turns(bus, 0));
    if (inFocus) {
        bus.engine.focus(ModuleIndex(0), bus.now);
        bus.runFor(100ms);
    }
    const std::size_t samples = bus.samplesOf(0);
    bus.fault("module 1 stuck");
    ASSERT_TRUE(bus.runUntil([&] { return bus.motionSuspects(0) > 0; }, 2s));
    // The first frame of each layout is the one that is repeated; then there are more than five alike. In
    // focus, every second reply has no velocity and does not count.
    EXPECT_LE(bus.samplesOf(0), samples + (inFocus ? 16 : 9));
    EXPECT_EQ(bus.last<MotionSuspect>()->reason, MotionSuspect::Reason::Frozen);
    bus.runFor(500ms);
    EXPECT_TRUE(bus.stands(0));
    EXPECT_EQ(bus.motionSuspects(1), 0U);
}
INSTANTIATE_TEST_SUITE_P(EachChip, F12_SameFrameForEver,
                         testing::Combine(testing::Values(std::uint8_t{4}, kPathVersion, kScVersion),
                                          testing::Bool()));

TEST(F12_SameFrame, IsNoConcernAtStandstill) {
    FaultyBus bus(servos(1), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    bus.runFor(200ms);
    bus.fault("module 1 stuck");
    bus.runFor(3s);
    EXPECT_EQ(bus.motionSuspects(0), 0U);
}

// ---- F-13, F-14 ----

/// Moves two servos at different positions, where a reply that is taken for another's is noticed at once.
void askWhileRepliesAreLate(Truth& truth, FaultyBus& bus, Duration time) {
    const TimePoint end = bus.now + time;
    for (std::int32_t way = 1'500; bus.now < end; way = -way) {
        bus.submit({loadMove(0, way), start(0)});
        bus.submit({loadMove(1, Truth::placeOf(1) - way), start(1)});
        bus.runFor(1s);
        truth.look();
    }
}

TEST(F13_LateReply, IsNeverTakenForTheAnswerToTheNextCommand) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_TRUE(Truth::spreadOut(bus));
    Truth truth(bus);
    // 1.05 to 5 times the time-out of a poll, which is 16 ms with this adapter's latency and margin.
    bus.fault("bus delay status p=.01 t=17ms..80ms");
    askWhileRepliesAreLate(truth, bus, 60s);
    EXPECT_GT(bus.struck(), 100U);
    EXPECT_GT(bus.engine.statistics().staleBytes, 500U) << "late bytes are counted as such";
    truth.expectAllTrue();
}

/// The poll and two queries of a stop are answered 37 to 40 ms late: as long as the time-outs of the first
/// two and the nulls before the third take.
TEST(F13_LateReply, IsNotShownAsTheAnswerToAStop) {
    for (int start = 0; start < 12; ++start)
        for (int late = 370; late <= 400; ++late) {
            FaultyBus bus(servos(1), kFast);
            ASSERT_TRUE(bus.connectAndEnable());
            Truth truth(bus);
            for (int i = 0; i < 20; ++i) {
                bus.engine.hold(forward(0, 2 * kOnePerTick), bus.now);
                bus.runFor(20ms);
            }
            bus.engine.release(bus.now);
            bus.runFor(20ms + start * 200us);
            bus.fault("bus delay status t=" + std::to_string(late * 100) + "us n=3");
            bus.runFor(500ms);
            truth.look();
            EXPECT_EQ(truth.wrong(), 0U) << start << ", " << late << ": " << truth.first();
            EXPECT_EQ(bus.struck(), 3U);
        }
}

/// As on a busy computer: replies to a search are late, one in four by up to twice the time-out, so that one
/// in six comes too late.
TEST(F13_LateReply, HidesNoChain) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(1 + seed % 3), kPowerUpBaud, seed);
        ASSERT_TRUE(bus.connect());
        bus.newHost();
        bus.fault("bus delay status p=.25 t=10ms..36ms");
        ASSERT_TRUE(bus.connect());
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 1 + seed % 3);
        EXPECT_TRUE(bus.last<ChainFound>()->attached);
    }
}

TEST(F14_ReplyLaterThanTheQuarantine, IsHardlyEverBelievedAndPermitsNothing) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_TRUE(Truth::spreadOut(bus));
    Truth truth(bus);
    bus.fault("bus delay status p=.01 t=100ms..200ms");
    askWhileRepliesAreLate(truth, bus, 60s);
    EXPECT_GT(bus.struck(), 50U);
    EXPECT_LE(truth.wrong() * 1'000, truth.samples() * 3) << truth.first();
    EXPECT_EQ(truth.wrongPermissions(), 0U) << truth.first();
}

// ---- F-18 ----

TEST(F18_LineHeldLow, MakesNoSample) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    bus.fault("bus break status for=2s");
    bus.runFor(20ms);  // for what was under way
    const std::size_t samples = bus.count<Sample>();
    bus.runFor(1900ms);
    EXPECT_EQ(bus.count<Sample>(), samples);
    EXPECT_GT(bus.engine.statistics().rejections[static_cast<std::size_t>(Rejection::Uniform)], 0U)
        << "the checksum of zeros is zero";
}

TEST(F18_LineHeldLow, IsNamedWhenConnecting) {
    FaultyBus bus(servos(2));
    bus.fault("bus break status");
    EXPECT_FALSE(bus.connect());
    ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::HeldLow);
}

}  // namespace

}  // namespace nmc::test

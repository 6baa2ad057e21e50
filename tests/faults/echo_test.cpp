// SPDX-License-Identifier: GPL-3.0-or-later
// F-46: whole sessions over an adapter that returns what is sent to it.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

[[nodiscard]] EngineConfig atRate(std::uint32_t baud, Duration latency = {}) {
    EngineConfig config;
    config.baud = baud;
    config.adapterLatency = std::max<Duration>(config.adapterLatency, latency);
    return config;
}

struct Adapter {
    std::uint32_t baud;
    Duration latency;

    friend void PrintTo(const Adapter& adapter, std::ostream* stream) {
        *stream << adapter.baud << "BdAnd" << adapter.latency / 1ms << "ms";
    }
};

class F46_EchoingAdapter : public testing::TestWithParam<Adapter> {
protected:
    F46_EchoingAdapter() {
        bus.adapterDelay = GetParam().latency;
        bus.fault("bus echo");
    }
    FaultyBus bus{servos(3), atRate(GetParam().baud, GetParam().latency)};
};

INSTANTIATE_TEST_SUITE_P(AllRates, F46_EchoingAdapter,
                         testing::Values(Adapter{9'600, 0ms}, Adapter{19'200, 0ms}, Adapter{57'600, 0ms},
                                         Adapter{115'200, 0ms}, Adapter{19'200, 16ms},
                                         Adapter{115'200, 16ms}),
                         testing::PrintToStringParamName());

TEST_P(F46_EchoingAdapter, WorksAndIsToldOfOnce) {
    ASSERT_TRUE(bus.connectAndEnable());
    EXPECT_FALSE(bus.last<ChainFound>()->attached);
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    ASSERT_TRUE(Truth::spreadOut(bus));
    Truth truth(bus);
    EXPECT_EQ(bus.perform({loadMove(1, Truth::placeOf(1) + 2'000), start(1)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    EXPECT_EQ(bus.engine.statistics().surplusBytes, 0U);
    EXPECT_EQ(bus.count<EchoNoticed>(), 1U);
    EXPECT_EQ(bus.count<HealthChanged>(), 0U);
    truth.expectAllTrue();
    bus.expectOnlyExecutedWhatWasSent();
    bus.expectNoViolations();
}

TEST_P(F46_EchoingAdapter, AttachesToAChainAndLeavesItsMotion) {
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(1s);
    bus.newHost(atRate(GetParam().baud, GetParam().latency));
    bus.events.clear();
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(bus.last<ChainFound>()->attached);
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
    bus.runFor(1s);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    EXPECT_EQ(bus.count<EchoNoticed>(), 1U);
}

TEST_P(F46_EchoingAdapter, ChangesTheRate) {
    ASSERT_TRUE(bus.connectAndEnable());
    const std::uint32_t other = GetParam().baud == kFast ? 19'200 : kFast;
    bus.engine.changeRate(other, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<RateChanged>() == 1; }, 10s));
    bus.runFor(1s);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    bus.expectNoViolations();
}

/// At every byte of an exchange and of the command after it.
TEST_P(F46_EchoingAdapter, StopsAtAnyByte) {
    ASSERT_TRUE(bus.connectAndEnable());
    for (int byte = 0; byte < 50; ++byte) {
        ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
        bus.runFor(100ms);
        const auto crossed = [&] { return bus.chain.statistics().bytesIn + bus.chain.statistics().bytesOut; };
        const auto from = crossed();
        ASSERT_TRUE(bus.runUntil([&] { return crossed() >= from + static_cast<unsigned>(byte); }, 1s));
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        ASSERT_EQ(stop->stopped.size(), 3U);
        ASSERT_TRUE(bus.stands(0)) << byte;
    }
}

TEST_P(F46_EchoingAdapter, TellsSilenceFromItsEcho) {
    ASSERT_TRUE(bus.connectAndEnable());
    bus.fault("module 2 silent");
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleUnresponsive>() == 1; }, 10s));
    EXPECT_EQ(bus.last<ModuleUnresponsive>()->module, ModuleIndex(1));
    EXPECT_EQ(bus.count<LinkLost>(), 0U);
    bus.fault("bus silent");
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<LinkLost>() == 1; }, 10s)) << "no module answers";
}

TEST_P(F46_EchoingAdapter, IsTheReasonWhenNobodyAnswersBehindIt) {
    bus.fault("bus silent");
    EXPECT_FALSE(bus.connect());
    ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Echo);
    EXPECT_EQ(bus.count<EchoNoticed>(), 0U) << "knowing that it is ignored would not help";
}

TEST_P(F46_EchoingAdapter, CostsNoPollShare) {
    FaultyBus plain(servos(3), atRate(GetParam().baud, GetParam().latency));
    plain.adapterDelay = GetParam().latency;
    for (FaultyBus* each : {&bus, &plain}) {
        ASSERT_TRUE(each->connect());
        each->runFor(5s);
    }
    const auto polls = static_cast<double>(plain.engine.statistics().answered);
    EXPECT_NEAR(static_cast<double>(bus.engine.statistics().answered), polls, 0.01 * polls);
}

// ---- What else may go wrong on such a line ----

class F46_EchoAndMore : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Faults, F46_EchoAndMore,
                         testing::Values("bus noise status t=50ms..150ms", "bus drop status p=.02",
                                         "bus dup status p=.02", "bus truncate status p=.02",
                                         "bus delay p=.02 t=17ms..81ms", "bus silent p=.02",
                                         "bus cksum p=.02", "bus drop cmd p=.02", "bus flip cmd p=.02",
                                         "bus foreign on=nop t=100ms..200ms"));

TEST_P(F46_EchoAndMore, MakesNoSampleWrong) {
    FaultyBus bus(servos(3), kFast);
    bus.fault("bus echo");
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_TRUE(Truth::spreadOut(bus));
    Truth truth(bus);
    bus.fault(GetParam());
    const TimePoint end = bus.now + 20s;
    for (std::int32_t way = 1'000; bus.now < end && bus.health() != LinkHealth::Lost; way = -way) {
        bus.submit({loadMove(1, Truth::placeOf(1) + way), start(1)});
        bus.runFor(1s);
    }
    truth.expectAllTrue();
    EXPECT_GT(truth.samples(), 1'000U);
}

/// Now and then a byte that comes back is lost, wrong or doubled, whether the adapter or a module sent it.
TEST(F46_DamagedEcho, MakesNoSampleWrongAndIsOutlived) {
    for (const int damage : {0, 1, 2}) {
        SCOPED_TRACE(damage);
        FaultyBus bus(servos(3), kFast);
        bus.fault("bus echo");
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
        Truth truth(bus);
        unsigned n = 0;
        bus.onHostByte = [&](std::uint8_t& byte) {
            if (++n % 1'009 != 0)
                return 1U;
            if (damage == 1)
                byte ^= 0x10U;
            return damage == 1 ? 1U : damage == 0 ? 0U : 2U;
        };
        bus.runFor(20s);
        EXPECT_NE(bus.health(), LinkHealth::Lost);
        EXPECT_GT(truth.samples(), 1'000U);
        truth.expectAllTrue();
    }
}

// ---- A switch on the adapter ----

class F46_EchoThatChanges : public testing::TestWithParam<std::uint32_t> {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
    }
    FaultyBus bus{servos(3), GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Rates, F46_EchoThatChanges, testing::Values(19'200U, 115'200U));

TEST_P(F46_EchoThatChanges, IsNeverTakenForAnAnswerAndOutlived) {
    Truth truth(bus);
    for (int i = 0; i < 5; ++i) {
        bus.fault("bus echo for=3s");
        for (const Duration time : {Duration(1s), Duration(2s), Duration(1s)}) {
            const auto answered = bus.engine.statistics().answered;
            bus.runFor(time);
            EXPECT_GT(bus.engine.statistics().answered, answered + 50) << "the modules still answer";
        }
        EXPECT_EQ(bus.perform({loadMove(1, Truth::placeOf(1) + 500 * (i % 2)), start(1)}), Outcome::Done);
        bus.runFor(7s + std::chrono::milliseconds(7 * i));
    }
    EXPECT_EQ(bus.count<EchoNoticed>(), 1U);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
    EXPECT_NE(bus.health(), LinkHealth::Lost);
    truth.expectAllTrue();
    bus.expectOnlyExecutedWhatWasSent();
}

TEST_P(F46_EchoThatChanges, DelaysNoStop) {
    for (const char* line : {"bus echo for=1s", "bus echo for=1500ms"}) {
        ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
        bus.fault(line);
        bus.runFor(1s);  // the echo has just ended, or continues
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_EQ(stop->stopped.size(), 3U);
        EXPECT_TRUE(bus.stands(0));
        bus.runFor(2s);
    }
}

}  // namespace

}  // namespace nmc::test

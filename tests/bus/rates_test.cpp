// SPDX-License-Identifier: GPL-3.0-or-later
// The capacity of the line, in virtual time: polls of the modules that are being watched and of the others,
// and the time to assign the addresses of a long chain.
#include <gtest/gtest.h>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Samples per second of each module over ten seconds.
[[nodiscard]] std::vector<double> rates(VirtualBus& bus) {
    std::vector<double> all;
    for (std::uint8_t i = 0; i < bus.chain.moduleCount(); ++i)
        all.push_back(-static_cast<double>(bus.samplesOf(i)));
    bus.runFor(10s);
    for (std::uint8_t i = 0; i < bus.chain.moduleCount(); ++i)
        all[i] = (all[i] + static_cast<double>(bus.samplesOf(i))) / 10;
    return all;
}

/// Calculated by hand: polls alternate between 4 + 10 and 5 + 16 bytes, 10 bits each, plus half a tick of
/// 0.512 ms each.
[[nodiscard]] double pollsPerSecond(double baud) {
    return 2 / (35 * 10 / baud + 0.000'512);
}

TEST(PollRates, GiveTheOthersFiveASecondAndTheRestToTheOneThatIsLookedAt) {
    struct Case {
        std::uint32_t baud;
        std::uint8_t modules;
    };
    for (const auto& [baud, modules] :
         {Case{115'200, 8}, {115'200, 32}, {57'600, 8}, {19'200, 4}, {19'200, 2}}) {
        SCOPED_TRACE(testing::Message() << int{modules} << " modules at " << baud);
        VirtualBus bus(servos(modules), EngineConfig{baud});
        ASSERT_TRUE(bus.connect());
        bus.engine.watch({ModuleIndex(1)});
        bus.runFor(1s);
        const auto all = rates(bus);
        double others = 0;
        for (std::size_t i = 0; i < modules; ++i)
            if (i != 1) {
                EXPECT_GE(all[i], 5.0) << i;
                EXPECT_LE(all[i], 6.5) << i;
                others += all[i];
            }
        std::printf("%u Bd, %u modules: %.1f/s looked at, %.1f/s each of the others\n", baud,
                    unsigned{modules}, all[1], others / (modules - 1));
        EXPECT_GE(all[1] + others, 0.9 * pollsPerSecond(baud)) << "the wire is used";
        EXPECT_GE(all[1], others / (modules - 1));
    }
}

TEST(PollRates, ShareTheWireEvenlyWhenNobodyLooks) {
    VirtualBus bus(servos(4), EngineConfig{115'200});
    ASSERT_TRUE(bus.connect());
    bus.engine.watch({ModuleIndex(2)});
    bus.runFor(1s);
    bus.engine.watch({});
    bus.runFor(1s);
    for (const double rate : rates(bus))
        EXPECT_NEAR(rate, pollsPerSecond(115'200) / 4, 0.1 * pollsPerSecond(115'200) / 4);
}

TEST(PollRates, RememberWhoIsLookedAtThroughAnotherConnection) {
    VirtualBus bus(servos(4), EngineConfig{115'200});
    bus.engine.watch({ModuleIndex(3)});
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    const auto all = rates(bus);
    EXPECT_GT(all[3], 20 * all[0]);
}

/// Calculated by hand: 5 + 6 and 4 + 10 bytes alternate, each with half a tick of waiting on average. Since
/// exchanges begin with a tick, the actual waiting time may be shorter or longer.
[[nodiscard]] double focusedPerSecond(double baud) {
    return 2 / (25 * 10 / baud + 0.000'512);
}

TEST(FocusRates, GiveOneModuleWhatTheWireCarriesAndKeepTheOthersInSight) {
    struct Case {
        std::uint32_t baud;
        std::uint8_t modules;
    };
    for (const auto& [baud, modules] :
         {Case{115'200, 1}, {115'200, 8}, {115'200, 32}, {57'600, 8}, {19'200, 4}, {19'200, 16}}) {
        SCOPED_TRACE(testing::Message() << int{modules} << " modules at " << baud);
        VirtualBus bus(servos(modules), EngineConfig{baud});
        ASSERT_TRUE(bus.connect());
        bus.runFor(1s);
        std::vector<std::size_t> before;
        for (std::uint8_t i = 0; i < modules; ++i)
            before.push_back(bus.samplesOf(i));
        bus.engine.focus(ModuleIndex(0), bus.now);
        bus.runFor(4s);
        const double rate = static_cast<double>(bus.samplesOf(0) - before[0]) / 4;
        double others = 0;
        for (std::uint8_t i = 1; i < modules; ++i) {
            EXPECT_GE(bus.samplesOf(i) - before[i], 4U) << int{i};
            others += static_cast<double>(bus.samplesOf(i) - before[i]) / 4;
        }
        std::printf("%u Bd, %u modules: %.0f/s in focus, of %.0f/s that the wire carries\n", baud,
                    unsigned{modules}, rate, focusedPerSecond(baud));
        EXPECT_GE(rate + 2 * others, 0.95 * focusedPerSecond(baud)) << "their polls are up to twice as long";
        EXPECT_EQ(bus.engine.statistics().errors(), 0U);
        bus.expectNoViolations();
    }
}

class Focus : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1)}), Outcome::Done);
        bus.engine.focus(ModuleIndex(0), bus.now);
        ASSERT_TRUE(focused());
    }
    /// True if the module is in focus: only then is the position requested alone.
    [[nodiscard]] bool focused() {
        const std::size_t from = bus.sent.size();
        bus.runFor(100ms);
        return bus.sends("AA 01 13 01", from) > 10;
    }
    VirtualBus bus{servos(2), EngineConfig{115'200}};
};

TEST_F(Focus, EndsByItselfAfterFiveSeconds) {
    bus.runFor(4'900ms);
    EXPECT_FALSE(focused());
}

TEST_F(Focus, EndsWhenItIsNotWantedAnyMore) {
    bus.engine.focus(std::nullopt, bus.now);
    EXPECT_FALSE(focused());
}

TEST_F(Focus, EndsWithAStopOfAll) {
    ASSERT_TRUE(bus.stopAll());
    EXPECT_FALSE(focused());
}

TEST_F(Focus, EndsWithAStopOfAnyOneModule) {
    ASSERT_EQ(bus.perform({motorOff(1)}), Outcome::Done);
    EXPECT_FALSE(focused());
}

TEST_F(Focus, GoesOnThroughAMoveAndAStopHere) {
    ASSERT_EQ(bus.perform({loadMove(0, 50), start(0)}), Outcome::Done);
    EXPECT_TRUE(focused());
    ASSERT_EQ(bus.perform({toServo(1, servo::StopMotor{true, servo::StopManner::Here, Counts(3)})}),
              Outcome::Done);
    EXPECT_TRUE(focused());
}

TEST_F(Focus, EndsWithTheConnection) {
    ASSERT_TRUE(bus.connect());
    EXPECT_FALSE(focused());
}

TEST_F(Focus, EndsWhenTheModuleIsSilent) {
    bus.losesReply = [](ByteSpan command) { return command.size() > 1 && command[1] == 1; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleUnresponsive>() == 1; }, 2s));
    bus.losesReply = {};
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleUnresponsive>() == 2; }, 5s));
    EXPECT_FALSE(focused());
}

/// The time from the first Set Address to the end.
TEST(EnumerationTime, OfThirtyTwoModulesIsThatOfTheWire) {
    for (const bool restart : {false, true}) {
        SCOPED_TRACE(restart);
        VirtualBus bus(servos(32));
        bus.engine.setRecording(true);
        ASSERT_TRUE(restart ? bus.restart() : bus.connect());
        const TimePoint end = bus.now;
        std::optional<TimePoint> began;
        double wire = 0;
        for (const ExchangeRecord& record : bus.engine.takeRecords()) {
            if (!began && record.command.size() == 6 && record.command[2] == 0x21)
                began = record.sent;
            if (!began || record.sent >= end)
                continue;
            const bool nulls = record.command[0] == 0;
            wire += static_cast<double>(record.command.size() + record.reply.size()) * 10 / 19'200;
            wire += nulls ? 0 : 0.000'256;
        }
        ASSERT_TRUE(began);
        const double took = toSeconds(end - *began);
        // link.md 2.1 for Read Status with type and version, five bytes out and four back: 9 bytes, 0.51 ms,
        // 4 ms for the adapter, and a margin of 10 ms.
        const double timeout = 9 * 10 / 19'200.0 + 0.000'51 + 0.004 + 0.010;
        std::printf("%.3f s, of which %.3f s on the wire; a time-out is %.3f s\n", took, wire, timeout);
        EXPECT_LE(took, 1.2 * wire + timeout);
    }
}

}  // namespace

}  // namespace nmc::test

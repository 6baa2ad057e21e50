// SPDX-License-Identifier: GPL-3.0-or-later
// Changing the rate of a running chain: all modules follow, or all go back.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/bus/groups.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

class RateBus : public GroupBus {
public:
    using GroupBus::GroupBus;

    [[nodiscard]] bool change(std::uint32_t baud) {
        const auto ends = [&] { return count<RateChanged>() + count<RateChangeFailed>(); };
        const std::size_t before = ends();
        engine.changeRate(baud, now);
        EXPECT_TRUE(runUntil([&] { return ends() > before; }, 20s));
        return std::holds_alternative<RateChanged>(lastEnd());
    }
    [[nodiscard]] bool ended() const { return count<RateChanged>() + count<RateChangeFailed>() > 0; }
    [[nodiscard]] RateChangeFailed failure() { return std::get<RateChangeFailed>(lastEnd()); }

    /// Makes the module ignore Set Baud from now on.
    void makeDeaf(std::uint8_t module) {
        sim::FaultSpec ignore;
        ignore.kind = sim::FaultKind::Ignore;
        ignore.modules = {module};
        ignore.command = CommandCode::SetBaud;
        EXPECT_TRUE(chain.inject(ignore, now));
    }
    /// The nominal rate of each module (protocol.md 1).
    [[nodiscard]] std::vector<std::uint32_t> rates() {
        std::vector<std::uint32_t> all;
        for (std::uint8_t i = 0; i < chain.moduleCount(); ++i)
            switch (std::lround(chain.snapshot(ModuleIndex(i), now).baud)) {
                case 9'615:
                    all.push_back(9'600);
                    break;
                case 19'531:
                case 19'231:
                    all.push_back(19'200);
                    break;
                case 56'818:
                    all.push_back(57'600);
                    break;
                case 113'636:
                    all.push_back(115'200);
                    break;
                default:
                    all.push_back(0);
            }
        return all;
    }
    void expectRunsAt(std::uint32_t baud) {
        EXPECT_EQ(hostBaud, baud);
        for (const std::uint32_t rate : rates())
            EXPECT_EQ(rate, baud);
        const auto before = samplesOf(0);
        const std::size_t silences = count<ModuleUnresponsive>();
        runFor(1s);
        EXPECT_GT(samplesOf(0), before + 3);
        EXPECT_EQ(count<ModuleUnresponsive>(), silences);
    }

private:
    [[nodiscard]] Event lastEnd() const {
        for (auto it = events.rbegin(); it != events.rend(); ++it)
            if (std::holds_alternative<RateChanged>(*it) || std::holds_alternative<RateChangeFailed>(*it))
                return *it;
        return RateChangeFailed{};
    }
};

/// Connects to three servos that hold their positions, at 19 200 Bd.
void makeReady(RateBus& bus) {
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i), loadMove(i, 100 * (i + 1)), start(i)}), Outcome::Done);
    bus.runFor(3s);
}

TEST(ChainRate, ChangesForAllAndPositionsGainsAndLoadsStay) {
    RateBus bus(servos(3));
    makeReady(bus);
    ASSERT_EQ(bus.perform({loadMove(1, 1'000)}), Outcome::Done);
    for (const std::uint32_t baud : {115'200U, 57'600U, 9'600U, 19'200U}) {
        SCOPED_TRACE(baud);
        ASSERT_TRUE(bus.change(baud));
        EXPECT_EQ(bus.last<RateChanged>()->baud, baud);
        bus.expectRunsAt(baud);
    }
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(bus.servo(i).servoOn);
        EXPECT_NEAR(bus.servo(i).position, 100 * (i + 1), 2);
        EXPECT_EQ(bus.servo(i).gains.kp, 200);
    }
    EXPECT_EQ(bus.perform({start(1)}), Outcome::Done) << "the load is still waiting";
    bus.runFor(3s);
    EXPECT_NEAR(bus.servo(1).position, 1'000, 2);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    bus.expectNoViolations();
}

TEST(ChainRate, ReachesModulesInOtherGroups) {
    RateBus bus(servos(3));
    makeReady(bus);
    ASSERT_EQ(bus.put(0, 0x81).outcome, Outcome::Done);
    ASSERT_EQ(bus.put(2, 0x90).outcome, Outcome::Done);
    ASSERT_TRUE(bus.change(115'200));
    bus.expectRunsAt(115'200);
    EXPECT_EQ(bus.sends("AA 81 1A 0A A5"), 1U);
    EXPECT_EQ(bus.sends("AA 90 1A 0A B4"), 1U);
    EXPECT_EQ(bus.sends("AA FF 1A 0A 23"), 1U);
    bus.expectNoViolations();
}

TEST(ChainRate, IsTriedAgainWhenNobodyHeardIt) {
    RateBus bus(servos(3));
    makeReady(bus);
    bool lose = true;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() == 5 && command[2] == 0x1A && std::exchange(lose, false))
            command.clear();
    };
    EXPECT_TRUE(bus.change(115'200));
    bus.expectRunsAt(115'200);
    bus.expectNoViolations();
}

TEST(ChainRate, GoesBackWhenAModuleIsDeafToIt) {
    for (const std::uint8_t deaf : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
        SCOPED_TRACE(int{deaf});
        RateBus bus(servos(3), {}, withFaults());
        makeReady(bus);
        ASSERT_TRUE(bus.change(115'200));
        bus.makeDeaf(deaf);
        ASSERT_FALSE(bus.change(57'600));
        const RateChangeFailed failed = bus.failure();
        EXPECT_EQ(failed.reason, RateChangeFailed::Reason::NotHeard);
        EXPECT_EQ(failed.wanted, 57'600U);
        EXPECT_EQ(failed.baud, 115'200U);
        EXPECT_EQ(failed.modules, std::vector{ModuleIndex(deaf)});
        EXPECT_TRUE(failed.lost.empty());
        bus.chain.clearFaults(bus.now);
        bus.expectRunsAt(115'200);
        for (std::uint8_t i = 0; i < 3; ++i) {
            EXPECT_TRUE(bus.servo(i).servoOn);
            EXPECT_NEAR(bus.servo(i).position, 100 * (i + 1), 2);
        }
        ASSERT_TRUE(bus.change(57'600)) << "it follows now";
        bus.expectRunsAt(57'600);
    }
}

TEST(ChainRate, SaysWhoIsLeftBehind) {
    RateBus bus(servos(3));
    makeReady(bus);
    // One module follows, but receives nothing at the new rate, not even the command to go back.
    bool away = false;
    bus.onTime = [&] { away = away || bus.chain.snapshot(ModuleIndex(2), bus.now).baud == realRate(10); };
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (away && command.size() >= 4 && command[0] == 0xAA && bus.hostBaud == 115'200)
            command.clear();
    };
    ASSERT_FALSE(bus.change(115'200));
    const RateChangeFailed failed = bus.failure();
    EXPECT_EQ(failed.modules.size(), 3U);
    EXPECT_EQ(failed.lost.size(), 3U);
    EXPECT_EQ(failed.baud, 19'200U);
    EXPECT_EQ(bus.hostBaud, 19'200U);
}

TEST(ChainRate, IsNotChangedWhenThatWouldLeaveSomebody) {
    RateBus bus(servos(3));
    makeReady(bus);
    const auto refused = [&](std::uint32_t baud) {
        const std::size_t from = bus.sent.size();
        EXPECT_FALSE(bus.change(baud));
        for (std::size_t i = from; i < bus.sent.size(); ++i)
            EXPECT_FALSE(bus.sent[i].bytes.size() == 5 && bus.sent[i].bytes[2] == 0x1A);
        return bus.failure();
    };
    EXPECT_EQ(refused(360'000).reason, RateChangeFailed::Reason::NoSuchRate);
    ASSERT_EQ(bus.perform({loadVelocity(1, 6'554, true)}), Outcome::Done);
    EXPECT_EQ(refused(115'200).reason, RateChangeFailed::Reason::NotNow);
    EXPECT_EQ(bus.failure().modules, std::vector{ModuleIndex(1)});
    ASSERT_TRUE(bus.stopAll());
    ASSERT_EQ(bus.put(2, 0x81, true).outcome, Outcome::Done);
    EXPECT_EQ(refused(115'200).reason, RateChangeFailed::Reason::Leader) << "faults.md F-26";
    EXPECT_EQ(bus.failure().modules, std::vector{ModuleIndex(2)});
    ASSERT_EQ(bus.put(2, 0x81).outcome, Outcome::Done);
    EXPECT_TRUE(bus.change(115'200));
    ASSERT_EQ(bus.perform({motorOff(0), motorOff(1), motorOff(2)}), Outcome::Done);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    EXPECT_EQ(refused(19'200).reason, RateChangeFailed::Reason::GroupsUnknown) << "another host's chain";
    bus.expectNoViolations();
}

TEST(ChainRate, DoesNotHoldUpAStop) {
    for (int ms = 0; ms < 260; ms += 4) {
        SCOPED_TRACE(ms);
        RateBus bus(servos(3));
        makeReady(bus);
        bus.engine.changeRate(115'200, bus.now);
        bus.runFor(std::chrono::milliseconds(ms));
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_EQ(stop->stopped.size(), 3U);
        EXPECT_LT(stop->took, 600ms);
        ASSERT_TRUE(bus.runUntil([&] { return bus.ended(); }, 5s));
        EXPECT_EQ(bus.count<RateChanged>() + bus.count<RateChangeFailed>(), 1U);
        const std::uint32_t baud = bus.count<RateChanged>() > 0 ? 115'200 : 19'200;
        bus.expectRunsAt(baud);
        EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::Done);
    }
}

/// It is not known which modules are at which rate, so the stop is sent at both before this is resolved.
/// First the present exchange ends (9 ms at most); then sixteen nulls, 1 ms, a stop and the adapter's 4 ms
/// take 18 ms at 19 200 Bd, and 4 ms at 115 200 Bd.
TEST(ChainRate, SendsAStopAtBothRatesAtOnce) {
    for (const bool deaf : {false, true})
        for (int ms = 0; ms < 260; ms += 4) {
            SCOPED_TRACE(ms);
            RateBus bus(servos(3), {}, withFaults());
            makeReady(bus);
            if (deaf)
                bus.makeDeaf(1);
            bus.engine.changeRate(115'200, bus.now);
            bus.runFor(std::chrono::milliseconds(ms));
            if (bus.ended())
                break;
            const auto stops = [&bus](std::size_t module) {
                return bus.chain.statistics().modules[module].executions(CommandCode::StopMotor);
            };
            const std::array before{stops(0), stops(1), stops(2)};
            bus.engine.stopAll(bus.now);
            bus.runFor(40ms);
            for (std::size_t i = 0; i < before.size(); ++i)
                EXPECT_GT(stops(i), before[i]) << i;
        }
}

/// The present exchange ends first.
TEST(ChainRate, DoesNotHoldUpAStopOfOne) {
    for (const bool deaf : {false, true})
        for (int ms = 0; ms < 260; ms += 8) {
            SCOPED_TRACE(ms);
            RateBus bus(servos(3), {}, withFaults());
            makeReady(bus);
            if (deaf)
                bus.makeDeaf(1);
            bus.engine.changeRate(115'200, bus.now);
            bus.runFor(std::chrono::milliseconds(ms));
            if (bus.ended())
                break;
            const auto stops = [&bus] {
                return bus.chain.statistics().modules[0].executions(CommandCode::StopMotor);
            };
            const auto before = stops();
            const OperationId id =
                bus.submit({toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}})});
            EXPECT_EQ(bus.outcomeOf(id), Outcome::Done);
            bus.runFor(100ms);
            EXPECT_GT(stops(), before);
            ASSERT_TRUE(bus.runUntil([&] { return bus.ended(); }, 5s));
            EXPECT_EQ(bus.failure().reason, RateChangeFailed::Reason::Interrupted);
            EXPECT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 1; }, 5s));
            bus.expectRunsAt(19'200);
        }
}

TEST(ChainRate, OutlivesStopsInARow) {
    for (int us = 0; us < 60'000; us += 3'100) {
        SCOPED_TRACE(us);
        RateBus bus(servos(3));
        makeReady(bus);
        bus.engine.changeRate(115'200, bus.now);
        bus.runFor(std::chrono::milliseconds(9));
        bus.engine.stopAll(bus.now);
        bus.runFor(std::chrono::microseconds(us));
        const auto stop = bus.stopAll();
        ASSERT_TRUE(stop);
        EXPECT_EQ(stop->stopped.size(), 3U);
        ASSERT_TRUE(bus.runUntil([&] { return bus.ended(); }, 5s));
        bus.expectRunsAt(bus.count<RateChanged>() > 0 ? 115'200 : 19'200);
    }
}

TEST(ChainRate, EndsItsChangeWhenTheChainIsLookedForMeanwhile) {
    for (const bool restart : {false, true}) {
        RateBus bus(servos(3));
        makeReady(bus);
        bus.engine.changeRate(115'200, bus.now);
        bus.runFor(15ms);
        ASSERT_FALSE(bus.ended());
        ASSERT_TRUE(restart ? bus.restart() : bus.connect());
        ASSERT_TRUE(bus.ended());
        EXPECT_EQ(bus.failure().reason, RateChangeFailed::Reason::Interrupted);
        EXPECT_EQ(bus.failure().wanted, 115'200U);
    }
}

TEST(ChainRate, IsTheSameForAllAgainWhenTheWayBackIsNotHeard) {
    RateBus bus(servos(3), {}, withFaults());
    makeReady(bus);
    bus.engine.changeRate(115'200, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.rates()[1] == 115'200; }, 1s));
    sim::FaultSpec ignore;
    ignore.kind = sim::FaultKind::Ignore;
    ignore.modules = {1};
    ignore.command = CommandCode::SetBaud;
    ignore.count = 1;
    ASSERT_TRUE(bus.chain.inject(ignore, bus.now));
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->unreached, std::vector{ModuleIndex(1)}) << "it is at a rate where it is not expected";
    EXPECT_TRUE(bus.servo(1).servoOn);
    ASSERT_TRUE(bus.runUntil([&] { return bus.ended(); }, 5s));
    EXPECT_EQ(bus.failure().reason, RateChangeFailed::Reason::Interrupted);
    EXPECT_TRUE(bus.failure().lost.empty());
    ASSERT_TRUE(bus.runUntil(
        [&] {
            const auto silence = bus.last<ModuleUnresponsive>();
            return !silence || !silence->silent;
        },
        6s))
        << "it answers again";
    bus.expectRunsAt(19'200);
}

}  // namespace

}  // namespace nmc::test

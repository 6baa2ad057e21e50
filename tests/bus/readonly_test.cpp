// SPDX-License-Identifier: GPL-3.0-or-later
// H-02: a read-only connection monitors and changes nothing, as shown by the simulator's own count of the
// commands that its modules have carried out.
#include <gtest/gtest.h>

#include <set>

#include "tests/bus/leftbehind.h"
#include "tests/support/hexbytes.h"
#include "tests/support/modules.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing_support::kFirst;

[[nodiscard]] EngineConfig readOnly() {
    EngineConfig config;
    config.readOnly = true;
    return config;
}

/// A chain that another program left behind with its first motor in motion, and a read-only connection to it.
class OnLooker : public LeftBehind {
public:
    explicit OnLooker(std::size_t modules = 3, std::uint32_t baud = 19'200,
                      const EngineConfig& config = readOnly())
        : LeftBehind(modules, baud, config), m_before(bus.chain.statistics()) {}

    /// Defines the items of replies, as another host would.
    void define(std::uint8_t address, std::uint8_t items) {
        const auto sum = static_cast<std::uint8_t>(address + 0x12 + items);
        bus.runFor(20ms);  // the last command of the previous program has been received
        bus.chain.hostSends(std::vector<std::uint8_t>{0xAA, address, 0x12, items, sum}, bus.now);
        bus.runFor(20ms);
        m_before = bus.chain.statistics();
    }
    /// Number of these commands that all modules have carried out since.
    [[nodiscard]] std::uint64_t executed(CommandCode code) const {
        std::uint64_t n = 0;
        const auto now = bus.chain.statistics();
        for (std::size_t i = 0; i < now.modules.size(); ++i)
            n += now.modules[i].executions(code) - m_before.modules[i].executions(code);
        return n;
    }
    void expectOnlyLookedAt(std::set<CommandCode> also = {}) const {
        also.insert({CommandCode::Nop, CommandCode::ReadStatus});
        const auto fits = [&](unsigned code) { return also.contains(static_cast<CommandCode>(code)); };
        for (unsigned code = 0; code < 16; ++code) {
            EXPECT_TRUE(fits(code) || executed(static_cast<CommandCode>(code)) == 0) << "command " << code;
        }
        for (const VirtualBus::Sent& sent : bus.sent) {
            EXPECT_TRUE(sent.bytes.front() == 0 || fits(sent.bytes.at(2) & 0x0FU)) << sent.hex();
        }
    }
    void expectUndisturbed() {
        EXPECT_NEAR(commandVelocity(), 1.0, 0.01);
        EXPECT_EQ(bus.count<StopFinished>(), 0U);
        EXPECT_EQ(bus.count<MotionSuspect>(), 0U);
        expectOnlyLookedAt();
    }

private:
    sim::ChainStatistics m_before;
};

[[nodiscard]] std::set<int> layoutsOf(const VirtualBus& bus, std::uint8_t module) {
    std::set<int> layouts;
    for (const Sample& sample : bus.all<Sample>())
        if (sample.module.value() == module)
            layouts.insert(sample.report.items.mask());
    return layouts;
}

class ReadOnlyAt : public testing::TestWithParam<std::uint32_t> {};

TEST_P(ReadOnlyAt, LooksAndLeavesEverythingToOthers) {
    OnLooker looker(3, GetParam());
    VirtualBus& bus = looker.bus;
    bus.onTime = [&] { ASSERT_NEAR(looker.commandVelocity(), 1.0, 0.01); };
    ASSERT_TRUE(bus.connect());
    const auto found = *bus.last<ChainFound>();
    EXPECT_TRUE(found.readOnly);
    EXPECT_TRUE(found.attached);
    EXPECT_EQ(found.baud, GetParam());
    EXPECT_EQ(found.modules.size(), 3U);
    bus.runFor(2s);
    // Every reply matched its query, so no query was held back.
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    EXPECT_EQ(bus.engine.statistics().resyncs, 0U);
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_GT(bus.samplesOf(i), 10U);
        EXPECT_TRUE(layoutsOf(bus, i).contains(kStandingItems.mask()));
        EXPECT_TRUE(layoutsOf(bus, i).contains(kAllItems.mask()));
    }
    bus.onTime = {};
    looker.expectUndisturbed();
    bus.expectNoViolations();
}

TEST_P(ReadOnlyAt, StopsWhenItIsAskedTo) {
    OnLooker looker(3, GetParam());
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.runFor(200ms);
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped.has_value());
    EXPECT_EQ(stopped->stopped.size(), 3U);
    EXPECT_DOUBLE_EQ(looker.commandVelocity(), 0);
    EXPECT_TRUE(bus.servo(0).servoOn) << "it still holds";
    looker.expectOnlyLookedAt({CommandCode::StopMotor});
    const std::uint64_t stops = looker.executed(CommandCode::StopMotor);
    EXPECT_GT(stops, 0U);
    bus.runFor(5s);
    EXPECT_EQ(looker.executed(CommandCode::StopMotor), stops) << "it is sent only once";
    bus.expectNoViolations();
}

INSTANTIATE_TEST_SUITE_P(Rates, ReadOnlyAt, testing::Values(9'600U, 19'200U, 57'600U, 115'200U));

/// No Operation and Stop Motor are answered with the items that another host defined.
TEST(ReadOnly, NeedNotKnowWhatRepliesWereDefinedToHave) {
    for (const StatusItems items :
         {StatusItems{}, StatusItems(StatusItems::Position), kStandingItems, kAllItems}) {
        SCOPED_TRACE(int{items.mask()});
        OnLooker looker;
        VirtualBus& bus = looker.bus;
        for (std::uint8_t address = 1; address <= 3; ++address)
            looker.define(address, items.mask());
        ASSERT_TRUE(bus.connect());
        bus.runFor(1s);
        EXPECT_EQ(bus.engine.statistics().errors(), 0U);
        looker.expectUndisturbed();
        const auto stopped = bus.stopAll();
        ASSERT_TRUE(stopped.has_value());
        EXPECT_EQ(stopped->stopped.size(), 3U);
        EXPECT_LT(stopped->took, 500ms);
        EXPECT_DOUBLE_EQ(looker.commandVelocity(), 0);
        EXPECT_EQ(bus.engine.statistics().errors(), 0U);
        looker.expectOnlyLookedAt({CommandCode::StopMotor});
        bus.expectNoViolations();
    }
}

TEST(ReadOnly, LooksAtOneModuleAsFastAsTheWireCarries) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    bus.events.clear();
    bus.engine.focus(kFirst, bus.now);
    bus.runFor(500ms);
    EXPECT_EQ(layoutsOf(bus, 0), (std::set<int>{StatusItems::Position, kStandingItems.mask()}));
    EXPECT_GT(bus.samplesOf(0), 10 * bus.samplesOf(1));
    looker.expectUndisturbed();
}

// ---- incomplete chains ----

TEST(ReadOnly, GivesNoAddressToAChainThatHasNone) {
    VirtualBus bus(servos(2), readOnly());
    EXPECT_FALSE(bus.connect());
    ASSERT_TRUE(bus.last<ConnectFailed>().has_value());
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Unaddressed);
    EXPECT_FALSE(bus.restart()) << "not even if a restart is requested";
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Unaddressed);
    for (std::uint8_t i = 0; i < 2; ++i) {
        EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).address, 0);
        EXPECT_EQ(bus.chain.statistics().modules[i].executions(CommandCode::SetAddress), 0U);
        EXPECT_EQ(bus.chain.statistics().modules[i].executions(CommandCode::HardReset), 0U);
    }
}

TEST(ReadOnly, TellsOfAModuleWithoutAnAddressAndLeavesItSo) {
    for (const bool known : {false, true}) {
        SCOPED_TRACE(known);
        EngineConfig config = readOnly();
        for (std::uint8_t i = 0; known && i < 3; ++i)
            config.known.push_back({ModuleIndex(i),
                                    BusAddress(static_cast<std::uint8_t>(i + 1)),
                                    {ModuleType::Servo, 4},
                                    GroupPlace{}});
        OnLooker looker(3, 19'200, config);
        VirtualBus& bus = looker.bus;
        bus.chain.powerCycle(ModuleIndex(2), bus.now);
        bus.runFor(100ms);
        ASSERT_TRUE(bus.connect());
        EXPECT_TRUE(bus.last<ChainFound>()->unaddressed);
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), known ? 3U : 2U);
        EXPECT_EQ(bus.count<ModuleRestarted>(), known ? 1U : 0U);
        bus.engine.readdress(ModuleIndex(2), bus.now);
        bus.runFor(5s);
        EXPECT_EQ(bus.count<ReaddressFailed>(), 1U);
        EXPECT_EQ(bus.chain.snapshot(ModuleIndex(2), bus.now).address, 0);
        looker.expectUndisturbed();
    }
}

// ---- events that stop motors on other connections ----

TEST(ReadOnly, LeavesMotorsAloneWhenAModuleRestarts) {
    for (const std::uint32_t baud : {19'200U, 115'200U}) {
        SCOPED_TRACE(baud);
        OnLooker looker(3, baud);
        VirtualBus& bus = looker.bus;
        ASSERT_TRUE(bus.connect());
        bus.chain.powerCycle(ModuleIndex(2), bus.now);
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() > 0; }, 10s));
        EXPECT_EQ(bus.last<ModuleRestarted>()->quiet, baud != 19'200U);
        bus.runFor(5s);
        looker.expectUndisturbed();
    }
}

TEST(ReadOnly, LeavesMotorsAloneWhenNobodyAnswersAndGoesOnLooking) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.losesReply = [](ByteSpan) { return true; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<LinkLost>() > 0; }, 10s));
    bus.runFor(10s);
    looker.expectUndisturbed();
    bus.losesReply = {};
    const std::size_t samples = bus.samplesOf(0);
    EXPECT_TRUE(bus.runUntil([&] { return bus.samplesOf(0) > samples + 10; }, 10s));
    looker.expectUndisturbed();
}

TEST(ReadOnly, LeavesMotorsAloneWhenTheLinkIsGivenUp) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.onHostByte = [n = 0](std::uint8_t& byte) mutable {
        byte = static_cast<std::uint8_t>(byte ^ (++n % 3 == 0 ? 0x10U : 0U));
        return 1U;
    };
    const auto givenUp = [&] {
        const auto health = bus.last<HealthChanged>();
        return health && health->health == LinkHealth::Lost && !health->module;
    };
    ASSERT_TRUE(bus.runUntil(givenUp, 60s));
    bus.runFor(10s);
    looker.expectUndisturbed();
}

/// On other connections, a position that does not change while motion is reported is a reason for a stop
/// (faults.md F-12).
TEST(ReadOnly, SuspectsNoMotionOfAModuleThatRepeatsAReply) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    // The previous program sends another command: 4 counts per tick, in velocity mode (DS-V 5.2).
    bus.chain.hostSends(testing_support::fromHex("AA 01 94 B6 00 00 04 00 1F 05 00 00 73"), bus.now);
    bus.runFor(500ms);
    ASSERT_NEAR(looker.commandVelocity(), 4.0, 0.01);
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    sim::FaultSpec stuck;
    stuck.kind = sim::FaultKind::Stuck;
    stuck.modules = {0};
    ASSERT_TRUE(bus.chain.inject(stuck, bus.now));
    bus.runFor(5s);
    EXPECT_NEAR(*bus.lastSample(0)->report.velocity, 4, 1) << "from the reply that is repeated";
    EXPECT_NEAR(looker.commandVelocity(), 4.0, 0.01);
    EXPECT_EQ(bus.count<MotionSuspect>(), 0U);
    EXPECT_EQ(bus.count<StopFinished>(), 0U);
}

TEST(ReadOnly, DefinesNothingAfterADoubt) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    for (int i = 0; i < 5; ++i) {
        bus.engine.distrust(bus.now);
        bus.runFor(400ms);
    }
    EXPECT_GE(bus.engine.statistics().resyncs, 5U);
    looker.expectUndisturbed();
}

TEST(ReadOnly, StopsNobodyUnasked) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.onTime = [&] {
        EXPECT_TRUE(bus.engine.stopBurst().empty());
        EXPECT_FALSE(bus.engine.answersForMotion());
    };
    EXPECT_FALSE(bus.engine.stopUnasked(bus.now));
    EXPECT_FALSE(bus.engine.stopping());
    EXPECT_TRUE(bus.engine.anythingMoves());
    bus.runFor(1s);
    looker.expectUndisturbed();
}

// ---- requests to a read-only connection ----

TEST(ReadOnly, RefusesEverythingThatWouldChangeAModule) {
    for (const bool connected : {false, true}) {
        SCOPED_TRACE(connected);
        OnLooker looker;
        VirtualBus& bus = looker.bus;
        ASSERT_EQ(connected && bus.connect(), connected);
        EXPECT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Forbidden);
        EXPECT_EQ(bus.perform({toServo(0, Nop{})}), Outcome::Forbidden);
        bus.engine.submit(GroupOperation{OperationId(7), GroupChange{kFirst, {0x81, false}}}, bus.now);
        bus.engine.changeRate(57'600, bus.now);
        bus.engine.readdress(kFirst, bus.now);
        for (int i = 0; i < 5; ++i) {
            bus.engine.hold(forward(0, 3 * 65'536), bus.now);
            bus.runFor(100ms);
        }
        bus.engine.release(bus.now);
        bus.runFor(1s);
        ASSERT_EQ(bus.count<GroupFinished>(), 1U);
        EXPECT_EQ(bus.last<GroupFinished>()->outcome, Outcome::Forbidden);
        ASSERT_EQ(bus.count<RateChangeFailed>(), 1U);
        EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NotNow);
        ASSERT_EQ(bus.count<ReaddressFailed>(), 1U);
        EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::NotNow);
        looker.expectUndisturbed();
    }
}

TEST(ReadOnly, LooksAgainWhenItIsToldToRestartTheNetworkAndStaysReadOnly) {
    OnLooker looker(3, 57'600);
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    ASSERT_TRUE(bus.restart());
    EXPECT_TRUE(bus.last<ChainFound>()->attached);
    EXPECT_TRUE(bus.last<ChainFound>()->readOnly);
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(bus.last<ChainFound>()->readOnly);
    bus.runFor(1s);
    EXPECT_EQ(bus.perform({enable(1)}), Outcome::Forbidden);
    looker.expectUndisturbed();
}

// ---- a stop that was requested ----

TEST(ReadOnly, StopsWhenItIsAskedToDuringTheLook) {
    for (const Duration after : {Duration(1ms), Duration(90ms), Duration(400ms)}) {
        SCOPED_TRACE(after.count());
        OnLooker looker(3, 115'200);
        VirtualBus& bus = looker.bus;
        bus.engine.connect(bus.now);
        bus.runFor(after);
        bus.engine.stopAll(bus.now);
        EXPECT_TRUE(bus.engine.stopping());
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 20s));
        EXPECT_FALSE(bus.engine.stopping());
        EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 3U);
        EXPECT_DOUBLE_EQ(looker.commandVelocity(), 0);
        looker.expectOnlyLookedAt({CommandCode::StopMotor});
    }
}

/// Outputs marked "off at stop" are set by Set Output and Set PWM, which are not queries. The rest of the
/// module stays as the other host has set it.
TEST(ReadOnly, TakesOutputsLowWhenItIsAskedToStop) {
    VirtualBus bus({{ModuleType::Servo, 4}, {ModuleType::Io, 1}});
    ASSERT_TRUE(bus.connect());
    const auto toIo = [](const IoCommand& command) { return Order{ModuleIndex(1), command}; };
    ASSERT_EQ(bus.perform(
                  {toIo(io::SetDirection{0x0FF0}), toIo(io::SetOutput{0x000F}), toIo(io::SetPwm{100, 200})}),
              Outcome::Done);
    bus.newHost(readOnly());
    bus.events.clear();
    bus.engine.setStopOutputs({{}, {0x0005, 0x03}});
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    const auto truth = [&] { return *bus.chain.snapshot(ModuleIndex(1), bus.now).io; };
    EXPECT_EQ(truth().outputs, 0x000F) << "no stop was requested";
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped.has_value());
    EXPECT_EQ(stopped->stopped.size(), 2U);
    EXPECT_EQ(truth().outputs, 0x000A);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{0, 0}));
    EXPECT_EQ(truth().directions, 0x0FF0);
    const std::size_t sent = bus.sent.size();
    bus.runFor(20s);
    EXPECT_EQ(bus.engine.statistics().timeouts, 0U);
    EXPECT_EQ(bus.sends("AA 02 24", sent) + bus.sends("AA 02 26", sent), 0U) << "it is sent only once";
    bus.expectNoViolations();
}

/// A requested stop is owed until each module has confirmed it, and no longer.
TEST(ReadOnly, OwesAStopThatWasNotConfirmed) {
    OnLooker looker;
    VirtualBus& bus = looker.bus;
    ASSERT_TRUE(bus.connect());
    bus.onCommand = [](std::vector<std::uint8_t>& command) { command.clear(); };
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped.has_value());
    EXPECT_EQ(stopped->unreached.size(), 3U);
    bus.runFor(3s);
    EXPECT_NEAR(looker.commandVelocity(), 1.0, 0.01);
    bus.onCommand = {};
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 3; }, 5s));
    EXPECT_DOUBLE_EQ(looker.commandVelocity(), 0);
    looker.expectOnlyLookedAt({CommandCode::StopMotor});
    const std::uint64_t stops = looker.executed(CommandCode::StopMotor);
    // The link is lost once more, but this time no stop was requested.
    bus.losesReply = [](ByteSpan) { return true; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<LinkLost>() > 0; }, 10s));
    bus.runFor(5s);
    EXPECT_EQ(looker.executed(CommandCode::StopMotor), stops);
}

}  // namespace

}  // namespace nmc::test

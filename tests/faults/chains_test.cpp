// SPDX-License-Identifier: GPL-3.0-or-later
// F-23, F-24, F-26, F-41, F-42: chains that are not as expected when they are searched for.
#include <gtest/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/faults/faultybus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

// ---- F-23 ----

/// Leaves the chain as a program at another rate would.
[[nodiscard]] bool leaveAt(FaultyBus& bus, std::uint32_t baud) {
    EngineConfig config;
    config.baud = baud;
    bus.newHost(config);
    const bool found = bus.restart();
    bus.newHost();
    bus.events.clear();
    return found;
}

TEST(F23_WrongRateAtConnect, IsFoundByQuestionsAlone) {
    for (const std::uint32_t baud : {9'600U, 57'600U, 115'200U}) {
        SCOPED_TRACE(baud);
        FaultyBus bus(servos(3));
        ASSERT_TRUE(leaveAt(bus, baud));
        const std::size_t from = bus.sent.size();
        EXPECT_TRUE(bus.connect());
        bus.expectOnlyQuestions(from);
        const auto found = bus.last<ChainFound>();
        ASSERT_TRUE(found);
        EXPECT_TRUE(found->attached);
        EXPECT_EQ(found->modules.size(), 3U);
        EXPECT_EQ(found->baud, baud);
    }
}

TEST(F23_WrongRateAtConnect, LeavesAMotionAlone) {
    FaultyBus bus(servos(2));
    EngineConfig config;
    config.baud = kFast;
    bus.newHost(config);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(500ms);
    bus.newHost();
    const std::size_t from = bus.sent.size();
    EXPECT_TRUE(bus.connect());
    bus.expectOnlyQuestions(from);
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
    EXPECT_EQ(bus.sentTo(0, CommandCode::StopMotor, from), 0U);
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_TRUE(FaultyBus::stopped(*stop, 0)) << "it can be stopped";
    EXPECT_TRUE(bus.stands(0));
}

TEST(F23_WrongRateAtConnect, OfAnEmptyLineSendsNoReset) {
    FaultyBus bus(servos(1));
    bus.fault("bus silent");
    bus.fault("bus mute rx");
    EXPECT_FALSE(bus.connect());
    EXPECT_EQ(bus.sentTo(0, CommandCode::HardReset), 0U);
    ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::NobodyAnswers);
}

// ---- F-24 ----

TEST(F24_RateChangeOfSomeOnly, NamesThoseThatStayedBehind) {
    FaultyBus bus(servos(3), kFast);
    bus.fault("module 2 ignore=set_baud");
    EXPECT_FALSE(bus.restart());
    ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::RateChange);
    EXPECT_EQ(bus.last<ConnectFailed>()->modules, std::vector{ModuleIndex(1)});
    for (std::uint8_t i = 0; i < 3; ++i)
        EXPECT_EQ(bus.sentTo(i, CommandCode::StartMotion) + bus.sentTo(i, CommandCode::LoadTrajectory), 0U);
    bus.clearFaults();
    ASSERT_TRUE(bus.restart()) << "a restart reaches both rates";
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    EXPECT_EQ(bus.last<ChainFound>()->baud, kFast);
}

TEST(F24_RateChangeOfSomeOnly, AfterADamagedSetBaudIsMadeGoodOrTold) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(3), kFast, seed);
        bus.fault("bus flip cmd on=set_baud n=1");
        const bool found = bus.restart();
        EXPECT_EQ(bus.struck(), 1U);
        if (found) {
            EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
            bus.runFor(1s);
            EXPECT_GT(bus.samplesOf(2), 30U);
            continue;
        }
        ASSERT_TRUE(bus.last<ConnectFailed>());
        EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::RateChange);
        EXPECT_TRUE(bus.restart());
    }
}

// ---- F-26 ----

TEST(F26_RateChangeWithALeader, IsNeverSent) {
    FaultyBus bus(servos(2));
    ASSERT_TRUE(bus.connectAndEnable());
    const std::size_t from = bus.sent.size();
    for (const ServoCommand& command :
         {ServoCommand(SetBaud{10}), ServoCommand(SetAddress{BusAddress(1), BusAddress(0x7F), true})})
        EXPECT_EQ(bus.perform({toServo(0, command)}), Outcome::Forbidden);
    bus.expectOnlyQuestions(from);
}

TEST(F26_RateChangeWithALeader, IsNotSentToAChainThatHasOne) {
    FaultyBus bus(servos(2), kFast);
    // Group FF of another program, with a leader: bit 7 of the group byte is clear.
    for (const char* packet : {"AA 00 21 01 7F A1 ", "AA 00 21 02 FF 22 "}) {
        bus.chain.hostSends(fromHex(packet), bus.now);
        bus.runFor(20ms);
    }
    ASSERT_TRUE(bus.chain.snapshot(ModuleIndex(0), bus.now).leader);
    static_cast<void>(bus.connect());
    bus.runFor(1s);
    EXPECT_EQ(bus.chain.statistics().modules[0].executions(CommandCode::SetBaud), 0U)
        << "only a reset would make the leader a member again";
}

// ---- F-41, F-42 ----

TEST(F41_UnknownModuleType, IsOnlyLookedAt) {
    for (const std::uint8_t type : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{7}, std::uint8_t{200}}) {
        SCOPED_TRACE(int{type});
        ScriptedBus bus(1);
        bus.type = type;
        ASSERT_TRUE(bus.connect());
        EXPECT_EQ(bus.all<ChainFound>()[0].modules[0].identity.type, static_cast<ModuleType>(type));
        const std::size_t from = bus.sent.size();
        std::uint32_t id = 0;
        for (const Order& order :
             {loadMove(0, 100), start(0), gains(0), toServo(0, ResetPosition{}), toServo(0, SaveAsHome{}),
              toServo(0, servo::SetHoming{}), toServo(0, servo::IoControl{})}) {
            bus.engine.submit({OperationId(++id), {order}}, bus.now);
            bus.runFor(50ms);
            EXPECT_EQ(bus.all<OperationFinished>().back().outcome, Outcome::Forbidden);
        }
        bus.engine.hold(forward(0), bus.now);
        bus.runFor(1s);
        for (std::size_t i = from; i < bus.sent.size(); ++i) {
            const auto code = codeOf(fromHex(bus.sent[i].hex + " "));
            EXPECT_FALSE(code && changesSomething(*code)) << bus.sent[i].hex;
        }
        EXPECT_GT(bus.count<Sample>(), 3U) << "type, version and status stay live";
    }
}

/// Whatever the version is: items that are not known for it are never requested, and it is sent only what it
/// is known to accept. I/O Control has another meaning from version 10 on.
TEST(F42_UnknownFirmwareVersion, IsToldNothingThatItIsNotKnownFor) {
    for (unsigned version = 0; version <= 255; ++version) {
        SCOPED_TRACE(version);
        ScriptedBus bus(1);
        bus.version = static_cast<std::uint8_t>(version);
        ASSERT_TRUE(bus.connect());
        bus.engine.submit({OperationId(1), {toServo(0, servo::IoControl{})}}, bus.now);
        bus.runFor(200ms);
        const auto finished = bus.all<OperationFinished>();
        ASSERT_EQ(finished.size(), 1U);
        EXPECT_EQ(finished[0].outcome, version >= 1 && version <= 5 ? Outcome::Done : Outcome::Forbidden);
        for (const auto& sent : bus.sent) {
            const auto bytes = fromHex(sent.hex + " ");
            const auto code = codeOf(bytes);
            if (code == CommandCode::ReadStatus || code == CommandCode::DefineStatus) {
                const unsigned known = version == 5 || version == 10 ? 0x40U : 0U;  // the position error
                EXPECT_EQ(bytes[3] & 0xC0U & ~known, 0U) << sent.hex;
            }
        }
        EXPECT_GT(bus.count<Sample>(), 3U);
    }
}

}  // namespace

}  // namespace nmc::test

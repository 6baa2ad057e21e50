// SPDX-License-Identifier: GPL-3.0-or-later
// Connecting to a chain that another program left behind: it is found and left as it is.
#include <gtest/gtest.h>

#include <set>

#include "tests/bus/leftbehind.h"
#include "tests/support/modules.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing_support::kStep;

[[nodiscard]] std::uint8_t commandOf(const VirtualBus::Sent& sent) {
    return sent.bytes.size() > 2 && sent.bytes[0] == 0xAA ? sent.bytes[2] : std::uint8_t{0x0E};
}

class AttachAt : public testing::TestWithParam<std::uint32_t> {};

TEST_P(AttachAt, FindsChainsOfEveryLengthAndLeavesMotionAndAddresses) {
    for (const std::size_t modules : {1U, 2U, 3U, 17U, 32U}) {
        SCOPED_TRACE(modules);
        LeftBehind left(modules, GetParam());
        VirtualBus& bus = left.bus;
        bus.onTime = [&] { ASSERT_NEAR(left.commandVelocity(), 1.0, 0.01); };
        ASSERT_TRUE(bus.connect());
        const auto found = *bus.last<ChainFound>();
        EXPECT_TRUE(found.attached);
        EXPECT_FALSE(found.unaddressed);
        EXPECT_EQ(found.baud, GetParam());
        ASSERT_EQ(found.modules.size(), modules);
        for (std::uint8_t i = 0; i < modules; ++i) {
            EXPECT_EQ(found.modules[i].address, BusAddress(static_cast<std::uint8_t>(i + 1)));
            EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).address, i + 1);
            EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).group, 0xFF);
        }
        EXPECT_EQ(bus.servo(0).gains.kp, 200);
        bus.runFor(1s);
        EXPECT_EQ(bus.engine.statistics().rejected, 0U);
        bus.onTime = {};
        bus.expectNoViolations();
    }
}

TEST_P(AttachAt, AsksWithNoOperationUntilTheLastAddress) {
    LeftBehind left(3, GetParam());
    ASSERT_TRUE(left.bus.connect());
    const auto& sent = left.bus.sent;
    std::size_t at = 0;
    std::set<int> asked;
    for (; at < sent.size() && commandOf(sent[at]) == 0x0E; ++at)
        if (sent[at].bytes[0] == 0xAA)
            asked.insert(sent[at].bytes[1]);
        else
            EXPECT_EQ(sent[at].bytes, std::vector<std::uint8_t>(16, 0));
    for (int address = 0; address <= 32; ++address)
        EXPECT_TRUE(asked.count(address)) << address;
    // After that, only queries and the length of replies are sent.
    for (; at < sent.size(); ++at) {
        const std::uint8_t command = commandOf(sent[at]);
        EXPECT_TRUE(command == 0x13 || command == 0x12 || command == 0x0E) << sent[at].hex();
    }
}

TEST_P(AttachAt, CanStopWhatIsRunning) {
    LeftBehind left(3, GetParam());
    VirtualBus& bus = left.bus;
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(bus.engine.anythingMoves());
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
    EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 3U);
    EXPECT_DOUBLE_EQ(left.commandVelocity(), 0);
    EXPECT_TRUE(bus.servo(0).servoOn) << "it still holds";
}

INSTANTIATE_TEST_SUITE_P(Rates, AttachAt, testing::Values(9'600U, 19'200U, 57'600U, 115'200U));

/// Velocities are in counts per servo tick, which is 10 times as long at SR 10: 20 counts per tick are
/// 3 900 counts/s.
TEST(Attach, BelievesAServoThatRunsAtALowServoRate) {
    for (const bool sameHost : {true, false}) {
        SCOPED_TRACE(sameHost);
        VirtualBus bus(servos(2), EngineConfig{19'200});
        ASSERT_TRUE(bus.connect());
        const servo::SetGain slow{
            20, 40, 0, 0, 255, 0, 16'000, 10, std::uint8_t{0}};  // soft enough for such a tick
        servo::LoadTrajectory run;
        run.velocity = CountsPerTick(20 * kOnePerTick);
        run.acceleration = CountsPerTickSquared(6'554);  // 0.1 counts per tick squared
        run.profile = servo::ProfileMode::Velocity;
        run.startNow = true;
        ASSERT_EQ(bus.perform({toServo(0, slow), enable(0), toServo(0, run)}), Outcome::Done);
        bus.runFor(3s);
        if (!sameHost)
            bus.newHost();
        bus.events.clear();
        ASSERT_TRUE(bus.connect());
        bus.runFor(3s);
        EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
        EXPECT_EQ(bus.engine.statistics().rejected, 0U);
        EXPECT_NEAR(bus.servo(0).commandVelocity, 20.0, 0.1);
        bus.engine.stopAll(bus.now);
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
        EXPECT_TRUE(bus.servo(0).servoOn) << "it still holds";
    }
}

TEST(Attach, ForbidsATrapezoidalMoveUntilAStopWasAnswered) {
    LeftBehind left(2, 115'200);
    VirtualBus& bus = left.bus;
    ASSERT_TRUE(bus.connect());
    bus.runFor(300ms);
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Forbidden);
    EXPECT_NEAR(left.commandVelocity(), 1.0, 0.01);
    ASSERT_EQ(bus.perform({enable(0)}), Outcome::Done) << "an abrupt stop";
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Done);
    bus.expectNoViolations();
}

/// Whether the line was disturbed or this computer was busy: the operator need not connect again.
TEST(Attach, SearchesAgainWhenAModuleFallsSilentForAMoment) {
    constexpr std::uint8_t kReadStatus = 0x13;
    for (const int lost : {3, 6}) {  // a query is sent three times in each search
        LeftBehind left(1, 19'200);
        VirtualBus& bus = left.bus;
        int silences = 0;
        bus.losesReply = [&](ByteSpan command) { return command[2] == kReadStatus && silences++ < lost; };
        ASSERT_TRUE(bus.connect()) << lost;
        EXPECT_EQ(bus.count<ConnectFailed>(), 0U);
        EXPECT_NEAR(left.commandVelocity(), 1.0, 0.01);
    }
    LeftBehind left(1, 19'200);
    left.bus.losesReply = [&](ByteSpan command) { return command[2] == kReadStatus; };
    EXPECT_FALSE(left.bus.connect());
    EXPECT_EQ(left.bus.last<ConnectFailed>()->reason, ConnectFailure::Garbled);
    EXPECT_EQ(left.bus.count<ConnectFailed>(), 1U);
}

/// At velocity 0 in velocity mode, a servo reports move_done; the new host cannot distinguish this from a
/// move that has ended.
TEST(Attach, ForbidsATrapezoidalMoveOfAServoThatHolds) {
    VirtualBus bus(servos(1), EngineConfig{115'200});
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Forbidden);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 3);
}

TEST(Attach, AllowsATrapezoidalMoveOfAServoThatIsSeenOff) {
    VirtualBus bus(servos(1), EngineConfig{115'200});
    ASSERT_TRUE(bus.connect());
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.perform({loadMove(0, 1'000)}), Outcome::Done);
}

TEST(Attach, StopsTheMotorsWhenAskedToDuringTheLook) {
    for (const std::uint32_t baud : {9'600U, 115'200U})
        for (const Duration after : {Duration(1ms), Duration(90ms), Duration(400ms)}) {
            SCOPED_TRACE(testing::Message() << baud << " Bd after " << after.count() << " ns");
            LeftBehind left(3, baud);
            VirtualBus& bus = left.bus;
            bus.engine.connect(bus.now);
            bus.runFor(after);
            bus.engine.stopAll(bus.now);
            ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 20s));
            EXPECT_DOUBLE_EQ(left.commandVelocity(), 0);
            EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 3U);
            bus.runFor(1s);
            EXPECT_EQ(bus.count<StopFinished>(), 1U);
            EXPECT_EQ(bus.count<ChainFound>(), 1U);
        }
}

/// A stop as requested on the page of a module, while the panel searches for a chain that it knows.
TEST(Attach, StopsOneMotorAtOnceWhileItsChainIsLookedForAgain) {
    using Manner = servo::StopManner;
    for (const Manner manner : {Manner::Abruptly, Manner::Smoothly, Manner::Here, Manner::MotorOff})
        for (const Duration after : {Duration(1ms), Duration(60ms)}) {
            LeftBehind left(3, 9'600);
            VirtualBus& bus = left.bus;
            ASSERT_TRUE(bus.connect());
            bus.engine.connect(bus.now);
            bus.runFor(after);
            ASSERT_EQ(bus.count<ChainFound>(), 1U) << "the search is in progress";
            const bool off = manner == Manner::MotorOff;
            const OperationId id = bus.submit({toServo(0, servo::StopMotor{!off, manner, Counts(-5'000)})});
            EXPECT_EQ(bus.outcomeOf(id), Outcome::Done);
            // An unanswered query takes some 20 ms at this rate, and the stop after it another 30.
            bus.runFor(150ms);
            EXPECT_EQ(bus.count<ChainFound>(), 1U) << "the search is still in progress";
            EXPECT_EQ(bus.servo(0).servoOn, !off);
            EXPECT_TRUE(off || left.commandVelocity() < 1.0) << "it slows down, or is at rest";
            ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() > 0; }, 20s));
            EXPECT_EQ(bus.servo(0).servoOn, !off) << "as requested, even after the search";
            EXPECT_NE(bus.servo(0).position, -5'000) << "the requested position was out of date by then";
        }
}

TEST(Attach, SendsAStopAgainThatWasNotConfirmedWhenTheLastConnectionEnded) {
    LeftBehind left(3, 19'200);
    VirtualBus& bus = left.bus;
    ASSERT_TRUE(bus.connect());
    bus.onCommand = [](std::vector<std::uint8_t>& command) { command.clear(); };  // the cable is cut
    bus.engine.stopAll(bus.now);
    bus.runFor(20ms);
    EngineConfig next;
    next.unconfirmed = bus.engine.unconfirmedStops();
    EXPECT_EQ(next.unconfirmed.size(), 3U);
    bus.newHost(next);
    EXPECT_FALSE(bus.connect()) << "nobody answers";
    next.unconfirmed = bus.engine.unconfirmedStops();
    EXPECT_EQ(next.unconfirmed.size(), 3U) << "they are passed on";
    bus.onCommand = nullptr;
    bus.newHost(next);
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.last<ChainFound>()->commandedToStop.size(), 3U);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 3; }, 5s));
    EXPECT_DOUBLE_EQ(left.commandVelocity(), 0);
    EXPECT_TRUE(bus.servo(0).servoOn) << "it holds";
    EXPECT_FALSE(bus.servo(1).servoOn) << "it was off";
    EXPECT_TRUE(bus.engine.unconfirmedStops().empty());
}

TEST(Attach, StopsOnlyTheModuleWhoseStopWasNotConfirmed) {
    const ModuleInfo running{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}};
    ModuleInfo other = running;
    other.address = BusAddress(9);
    for (const ModuleInfo& owed : {running, other})
        for (const bool readOnly : {false, true}) {
            EngineConfig next;
            next.unconfirmed = {{owed, StopManner::Off}};
            next.readOnly = readOnly;
            LeftBehind left(2, 19'200, next);
            ASSERT_TRUE(left.bus.connect());
            left.bus.runFor(500ms);
            const bool stops = owed.address == running.address && !readOnly;
            EXPECT_EQ(left.bus.servo(0).servoOn, !stops) << owed.address.value() << readOnly;
            EXPECT_EQ(left.bus.engine.unconfirmedStops().size(), readOnly ? 1U : 0U);
        }
}

TEST(Attach, EndsAStopDuringALookThatFindsNobody) {
    VirtualBus bus(servos(1));
    bus.losesReply = [](ByteSpan) { return true; };
    bus.engine.connect(bus.now);
    bus.runFor(50ms);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ConnectFailed>() > 0; }, 60s));
    bus.runFor(1s);
    ASSERT_EQ(bus.count<StopFinished>(), 1U);
    EXPECT_TRUE(bus.last<StopFinished>()->stopped.empty());
}

/// The result of a stop that the operator requested is always shown, even if another one was already in
/// progress.
TEST(Attach, SaysOfAStopWhetherTheOperatorAskedForIt) {
    for (const bool asked : {false, true}) {
        VirtualBus bus{std::vector<ModuleIdentity>{}};
        bus.engine.connect(bus.now);
        bus.runFor(50ms);
        EXPECT_TRUE(bus.engine.stopUnasked(bus.now));
        if (asked)
            bus.engine.stopAll(bus.now);
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 20s));
        EXPECT_TRUE(bus.last<StopFinished>()->reachedNobody());
        EXPECT_EQ(bus.last<StopFinished>()->unasked, !asked);
    }
}

TEST(Attach, TellsOfAModuleWithoutAnAddressBesideTheChain) {
    for (const std::uint32_t baud : {19'200U, 115'200U}) {
        SCOPED_TRACE(baud);
        LeftBehind left(3, baud);
        VirtualBus& bus = left.bus;
        bus.chain.powerCycle(ModuleIndex(2), bus.now);
        bus.runFor(100ms);
        ASSERT_TRUE(bus.connect());
        const auto found = *bus.last<ChainFound>();
        EXPECT_TRUE(found.attached);
        EXPECT_TRUE(found.unaddressed);
        EXPECT_EQ(found.modules.size(), 2U);
        EXPECT_EQ(bus.chain.snapshot(ModuleIndex(2), bus.now).address, 0)
            << "it is given no address without a request";
        EXPECT_NEAR(left.commandVelocity(), 1.0, 0.01);
        ASSERT_TRUE(bus.restart());
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
        EXPECT_FALSE(bus.last<ChainFound>()->attached);
    }
}

/// Whichever answer is lost, no module is left out, and none is given the address of another.
TEST(Attach, IsNotMisledByOneLostAnswer) {
    for (const bool restarted : {false, true})
        for (int lost = 0; lost < 80; ++lost) {
            SCOPED_TRACE(lost);
            LeftBehind left(3, 115'200);
            VirtualBus& bus = left.bus;
            if (restarted)
                bus.chain.powerCycle(ModuleIndex(1), bus.now);
            bus.runFor(100ms);
            bus.losesReply = [n = 0, lost](ByteSpan) mutable { return n++ == lost; };
            ASSERT_TRUE(bus.connect());
            const auto found = *bus.last<ChainFound>();
            EXPECT_TRUE(found.attached);
            EXPECT_EQ(found.modules.size(), restarted ? 2U : 3U);
            for (const auto& sent : bus.sent)
                EXPECT_NE(commandOf(sent), 0x21) << sent.hex();
        }
}

/// The first one or two answers from one address are lost: from any address in chains of one, two and four
/// modules, and from address 0 if a module has restarted.
TEST(Attach, IsNotMisledByTwoLostAnswersOfOneModule) {
    for (const std::size_t modules : {1U, 2U, 4U})
        for (std::uint8_t address = 0; address <= modules; ++address)
            for (const int lost : {1, 2}) {
                SCOPED_TRACE(std::to_string(modules) + " modules, address " + std::to_string(address) + ", " +
                             std::to_string(lost) + " answers");
                LeftBehind left(modules, 57'600);
                VirtualBus& bus = left.bus;
                if (address == 0)
                    bus.chain.powerCycle(ModuleIndex(0), bus.now);
                bus.runFor(100ms);
                const auto expected = modules - (address == 0 ? 1U : 0U);
                if (expected == 0)
                    continue;  // a fresh chain, below
                bus.losesReply = [n = 0, lost, address](ByteSpan command) mutable {
                    return command.size() > 2 && command[0] == 0xAA && command[1] == address && n++ < lost;
                };
                ASSERT_TRUE(bus.connect());
                const auto found = *bus.last<ChainFound>();
                EXPECT_TRUE(found.attached);
                EXPECT_EQ(found.modules.size(), expected);
                EXPECT_EQ(found.unaddressed, address == 0);
            }
}

/// USB hubs, Bluetooth and device servers pass a reply on in pieces: the length of the pauses is learned,
/// reported and waited for.
TEST(Attach, LearnsHowLongAnAdapterPausesWithinAReply) {
    for (const std::uint32_t baud : {19'200U, 115'200U})
        for (const bool fresh : {false, true}) {
            SCOPED_TRACE(std::to_string(baud) + (fresh ? ", fresh" : ""));
            LeftBehind left(3, baud, EngineConfig{baud});
            VirtualBus& bus = left.bus;
            for (std::uint8_t i = 0; fresh && i < 3; ++i)
                bus.chain.powerCycle(ModuleIndex(i), bus.now);
            bus.runFor(100ms);
            bus.tear = 20ms;
            ASSERT_TRUE(bus.connect());
            const auto found = *bus.last<ChainFound>();
            EXPECT_EQ(found.modules.size(), 3U);
            EXPECT_EQ(found.attached, !fresh);
            EXPECT_GE(found.replyGap, 20ms);
            EXPECT_LT(found.replyGap, 30ms);
            bus.runFor(2s);
            EXPECT_EQ(bus.engine.statistics().errors(), 0U);
            for (std::uint8_t i = 0; i < 3; ++i)
                EXPECT_GT(bus.samplesOf(i), 10U);
        }
}

TEST(Attach, DoesNotTakeNoiseForAPauseOfTheAdapter) {
    LeftBehind left(2, 19'200);
    left.bus.onHostByte = [n = 0](std::uint8_t& byte) mutable {
        byte = static_cast<std::uint8_t>(byte ^ (++n % 11 == 0 ? 0x10U : 0U));
        return 1U;
    };
    if (left.bus.connect()) {
        EXPECT_EQ(left.bus.last<ChainFound>()->replyGap, Duration{});
    }
    EXPECT_LE(left.bus.count<ChainFound>() + left.bus.count<ConnectFailed>(), 1U);
}

/// The same program searches again: a module that answers at its address has not restarted, and is unchanged.
TEST(Attach, KeepsWhatItToldAModuleThatItFindsAgain) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1)}), Outcome::Done);
    bus.runFor(500ms);
    ASSERT_TRUE(bus.connect());
    const auto found = *bus.last<ChainFound>();
    EXPECT_TRUE(found.attached);
    for (const ModuleInfo& info : found.modules)
        EXPECT_EQ(info.group, GroupPlace{}) << "no other host has set one";
    bus.runFor(500ms);
    EXPECT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::Done) << "without a stop before it";
    // A module that has lost power in the meantime does not answer there, and counts as unknown when it has
    // an address again.
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.last<ChainFound>()->absent, std::vector{ModuleIndex(1)});
    bus.runFor(3s);
    EXPECT_EQ(bus.perform({loadMove(1, 500)}), Outcome::Forbidden);
    bus.expectNoViolations();
}

TEST(Attach, FindsAddressesThatNoHostCountsUpTo) {
    LeftBehind left(3, 57'600);
    VirtualBus& bus = left.bus;
    const auto give = [&](std::uint8_t from, std::uint8_t to) {
        std::vector<std::uint8_t> packet{0xAA, from, 0x21, to, 0xFF};
        packet.push_back(static_cast<std::uint8_t>(from + 0x21 + to + 0xFF));
        bus.chain.hostSends(packet, bus.now);
        bus.runFor(20ms);
    };
    give(1, 7);
    give(2, 19);
    give(3, 32);
    ASSERT_TRUE(bus.connect());
    const auto found = *bus.last<ChainFound>();
    ASSERT_EQ(found.modules.size(), 3U);
    EXPECT_EQ(found.modules[0].address, BusAddress(7));
    EXPECT_EQ(found.modules[1].address, BusAddress(19));
    EXPECT_EQ(found.modules[2].address, BusAddress(32));
    EXPECT_EQ(found.baud, 57'600U);
    EXPECT_NEAR(left.commandVelocity(), 1.0, 0.01);
}

TEST(Attach, SwitchesMotorsOffWithARestart) {
    LeftBehind left(2, 9'600);
    ASSERT_TRUE(left.bus.restart());
    EXPECT_FALSE(left.bus.last<ChainFound>()->attached);
    EXPECT_FALSE(left.bus.servo(0).servoOn);
    EXPECT_EQ(left.bus.servo(0).gains.kp, 0);
    EXPECT_EQ(left.bus.perform({gains(0), enable(0), loadMove(0, 100), start(0)}), Outcome::Done);
}

/// The status byte of a PIC-STEP at rest without motor power is 00, and so is the sum of a reply that
/// contains nothing else (DS-S 5.2).
TEST(Attach, FindsAStepperWithoutMotorPower) {
    for (const std::size_t modules : {1U, 3U}) {
        VirtualBus bus(std::vector<ModuleIdentity>(modules, kStep));
        for (std::uint8_t i = 0; i < modules; ++i)
            bus.chain.set(ModuleIndex(i), sim::Input::Power, 0.0, bus.now);
        ASSERT_TRUE(bus.connect()) << "a fresh chain, failure "
                                   << static_cast<int>(bus.last<ConnectFailed>()->reason);
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), modules);
        EXPECT_EQ(bus.last<ChainFound>()->modules[0].identity, kStep);
        bus.runFor(2s);
        EXPECT_EQ(bus.engine.statistics().rejected, 0U);
        bus.newHost();
        ASSERT_TRUE(bus.connect()) << "a chain that was left behind";
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), modules);
    }
}

}  // namespace

}  // namespace nmc::test

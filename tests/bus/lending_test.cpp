// SPDX-License-Identifier: GPL-3.0-or-later
// The line lent to a program: the panel only decodes, and STOP ALL cuts in. Packets and replies are those of
// DS-V 4.1 and 5.2; the oracle is what the simulated chain has carried out.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/bus/steps.h"
#include "tests/support/hexbytes.h"
#include "tests/support/modules.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing_support::kFirst;
using testing_support::kIo;
using testing_support::kSecond;
using testing_support::kServo;
using testing_support::kStep;

using Bytes = std::vector<std::uint8_t>;

/// A packet: header, address, command with its number of data bytes, data, sum of all but the header.
Bytes packet(std::uint8_t address, std::uint8_t command, const Bytes& data = {}) {
    Bytes bytes{0xAA, address, command};
    bytes.insert(bytes.end(), data.begin(), data.end());
    bytes.push_back(static_cast<std::uint8_t>(std::accumulate(bytes.begin() + 1, bytes.end(), 0U)));
    return bytes;
}

constexpr std::uint8_t kAll = 0xFF;

/// A panel that is connected, and has lent its line.
class Lent : public testing::Test {
protected:
    explicit Lent(const std::vector<ModuleIdentity>& modules = servos(2)) : bus(modules) {
        EXPECT_TRUE(bus.connect());
        bus.runFor(200ms);
        bus.engine.setRecording(true);
        EXPECT_TRUE(bus.engine.lend());
        bus.runFor(50ms);
        (void)bus.engine.takeRecords();
        bus.events.clear();
        bus.sent.clear();
    }
    /// The program sends these bytes, and waits.
    void send(const Bytes& bytes, Duration wait = 20ms) {
        m_asked += bytes;
        bus.engine.onProgram(bytes, bus.now);
        bus.runFor(wait);
    }
    Bytes sent() const {
        Bytes all;
        for (const VirtualBus::Sent& one : bus.sent)
            all.insert(all.end(), one.bytes.begin(), one.bytes.end());
        return all;
    }
    /// Resets all modules, and gives them the addresses from 1 on.
    void enumerate(std::uint8_t modules) {
        send(Bytes(20, 0));
        send(packet(kAll, 0x0F), 100ms);
        for (std::uint8_t address = 1; address <= modules + 1; ++address)
            send(packet(0, 0x21, {address, kAll}));
    }
    std::vector<ModuleIdentity> seen() const {
        std::vector<ModuleIdentity> identities;
        const auto last = bus.last<ModulesSeen>().value();
        for (const ModuleInfo& info : last.modules)
            identities.push_back(info.identity);
        return identities;
    }
    template <typename Command>
    std::size_t executed() const {
        std::size_t count = 0;
        for (const auto& command : bus.all<CommandExecuted>())
            count += is<Command>(command.command) ? 1U : 0U;
        return count;
    }

    struct All : Bytes {
        void operator+=(const Bytes& more) { insert(end(), more.begin(), more.end()); }
    } m_asked;
    VirtualBus bus;
};

TEST_F(Lent, NothingIsSentButWhatTheProgramSends) {
    bus.runFor(2s);
    EXPECT_TRUE(bus.sent.empty());
    // Whatever the bytes are, they pass unchanged.
    Bytes any(256);
    std::iota(any.begin(), any.end(), std::uint8_t{0});
    send(any);
    send(packet(1, 0x0E));
    EXPECT_EQ(sent(), m_asked);
}

/// Nulls in the middle of the program's packet would make the module discard it.
TEST(Lending, BeginsAfterTheRecoveryOfTheLine) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bus.runFor(200ms);
    const auto before = bus.engine.statistics().timeouts;
    bus.losesReply = [](ByteSpan) { return true; };
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before; }, 1s));
    bus.losesReply = {};
    bus.runFor(5ms);
    ASSERT_TRUE(bus.engine.lend());
    EXPECT_FALSE(bus.engine.hearsForProgram());
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.hearsForProgram(); }, 1s));
    bus.sent.clear();
    bus.engine.onProgram(packet(1, 0x0E), bus.now);
    bus.runFor(200ms);
    EXPECT_EQ(bus.sent.size(), 1U);
    EXPECT_TRUE(bus.lastSample(0));
}

TEST_F(Lent, RepliesOfAKnownChainAreDecodedAsThePanelHasDefinedThem) {
    send(packet(1, 0x0E));
    send(packet(2, 0x13, {0x21}));
    ASSERT_EQ(bus.count<Sample>(), 2U);
    // Define Status of the panel: position, A/D value, velocity, auxiliary byte.
    EXPECT_EQ(bus.lastSample(0)->report.items.mask(), 0x0F);
    EXPECT_EQ(bus.lastSample(0)->report.position, bus.servo(0).position);
    // Read Status: position and type.
    EXPECT_EQ(bus.lastSample(1)->report.items.mask(), 0x21);
    EXPECT_EQ(bus.lastSample(1)->report.identity, kServo);
    const auto records = bus.engine.takeRecords();
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].purpose, Purpose::Lent);
    EXPECT_EQ(records[0].command, packet(1, 0x0E));
    EXPECT_EQ(records[0].reply.size(), 10U) << "status, 4 + 1 + 2 + 1, sum";
    EXPECT_EQ(records[1].end, ReplyResult::Accepted);
}

TEST_F(Lent, DefineStatusIsFollowed) {
    send(packet(1, 0x12, {0x01}));
    send(packet(1, 0x0E));
    EXPECT_EQ(bus.lastSample(0)->report.items.mask(), 0x01);
    EXPECT_EQ(bus.count<Sample>(), 2U);
}

TEST_F(Lent, AMotionOfTheProgramIsSeen) {
    send(packet(1, 0x12, {0x05}));
    // Kp 200, Kd 2000, Ki 20, IL 200, OL 255, CL 0, EL 4000, SR 1, DB 0.
    send(packet(1, 0xE6, {200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xA0, 0x0F, 1, 0}));
    send(packet(1, 0x17, {0x05}));  // on, stop abruptly
    // Velocity mode, at once: 1 count per tick, 0.1 counts per tick squared.
    send(packet(1, 0x94, {0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0}));
    EXPECT_EQ(executed<servo::SetGain>(), 1U);
    EXPECT_EQ(executed<servo::LoadTrajectory>(), 1U);
    bus.runFor(500ms);
    send(packet(1, 0x0E));
    const auto sample = bus.lastSample(0);
    EXPECT_NEAR(*sample->report.velocity, 1, 1);
    // 500 ms are 976 ticks.
    EXPECT_NEAR(*sample->report.position, 976, 60);
    EXPECT_TRUE(bus.engine.anythingMoves());
    EXPECT_EQ(bus.count<MotionSuspect>() + bus.count<ForeignMotion>(), 0U) << "it is the program's affair";
}

TEST_F(Lent, ACommandWithAWrongSumWasNotCarriedOut) {
    Bytes wrong = packet(1, 0x17, {0x05});
    wrong.back() ^= 0x40U;
    send(wrong);
    EXPECT_EQ(bus.count<CommandExecuted>(), 0U);
    const auto records = bus.engine.takeRecords();
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].command, wrong);
    EXPECT_EQ(records[0].end, ReplyResult::Refused);
}

TEST_F(Lent, OfACommandThatIsNotAnsweredNothingIsClaimed) {
    bus.losesReply = [](ByteSpan) { return true; };
    send(packet(1, 0x00), 100ms);  // Reset Position
    EXPECT_EQ(bus.count<CommandExecuted>(), 0U);
    ASSERT_EQ(bus.count<CommandUnanswered>(), 1U);
    EXPECT_TRUE(is<ResetPosition>(bus.last<CommandUnanswered>()->command));
    bus.losesReply = nullptr;
    send(packet(1, 0x0E));
    EXPECT_EQ(bus.count<Sample>(), 1U) << "and the next reply is decoded again";
}

TEST_F(Lent, NorOfACommandToAGroupWithoutALeader) {
    send(packet(kAll, 0x05));
    EXPECT_EQ(bus.count<CommandUnanswered>(), 2U);
    EXPECT_EQ(bus.engine.takeRecords().at(0).end, ReplyResult::NotAsked);
}

TEST_F(Lent, TheLeaderOfAGroupAnswersForIt) {
    send(packet(1, 0x21, {1, 0x05}));  // group 85, leader
    send(packet(2, 0x21, {2, 0x85}));
    bus.events.clear();
    send(packet(0x85, 0x0C));  // Save as Home
    EXPECT_EQ(executed<SaveAsHome>(), 1U);
    ASSERT_EQ(bus.count<CommandUnanswered>(), 1U);
    EXPECT_EQ(bus.last<CommandUnanswered>()->module, kSecond);
}

TEST_F(Lent, PacketsInPiecesAndBetweenNullsAreFollowed) {
    const Bytes nop = packet(1, 0x0E);
    send({nop.begin(), nop.begin() + 2}, 100ms);
    send({nop.begin() + 2, nop.end()});
    send({0, 0, 0xAA, 2, 0x0E, 0x10});
    EXPECT_EQ(bus.samplesOf(0), 1U);
    EXPECT_EQ(bus.samplesOf(1), 1U);
    EXPECT_EQ(sent(), m_asked);
}

TEST_F(Lent, APacketDuringAReplyBeginsAnew) {
    send(packet(1, 0x13, {0x3F}), 4ms);  // 5 bytes take 2.6 ms
    send(packet(2, 0x0E), 50ms);
    EXPECT_EQ(bus.samplesOf(0), 0U);
    send(packet(2, 0x0E));
    EXPECT_GE(bus.samplesOf(1), 1U);
    EXPECT_EQ(bus.lastSample(1)->report.position, bus.servo(1).position);
}

/// Up to version 4, a PIC-SERVO obeys FF only while that is its group (DS-V 4.1; DS-S 5.1, Hard Reset), so it
/// goes on, and must still be stopped.
TEST_F(Lent, AServoInAnotherGroupDoesNotObeyAResetOfAll) {
    send(packet(2, 0x21, {2, 0x81}));
    send(packet(kAll, 0x0F), 100ms);
    const auto left = bus.last<ModulesSeen>().value();
    ASSERT_EQ(left.modules.size(), 1U);
    EXPECT_EQ(left.modules[0].address, BusAddress(2));
    const std::size_t from = bus.samplesOf(0);
    send(packet(2, 0x0E));
    EXPECT_EQ(bus.samplesOf(0), from + 1);
    EXPECT_EQ(bus.stopAll()->stopped, std::vector<ModuleIndex>{kFirst});
}

class LentFamily : public Lent {
protected:
    LentFamily() : Lent({kServo, kStep, kIo}) {}
};

TEST_F(LentFamily, AfterAHardResetModulesAreWhatTheyReport) {
    send(packet(kAll, 0x0F), 100ms);
    EXPECT_TRUE(seen().empty());
    enumerate(3);
    EXPECT_EQ(seen(), std::vector<ModuleIdentity>(3, kUnheardModule));
    // What other items of an unknown chip mean is not known.
    send(packet(2, 0x13, {0x01}));
    EXPECT_EQ(bus.lastSample(1)->report.items.mask(), 0x00);
    send(packet(2, 0x13, {0x3F}));  // of all items, type and version
    EXPECT_EQ(seen(), (std::vector<ModuleIdentity>{kUnheardModule, kStep, kUnheardModule}));
    send(packet(1, 0x13, {0x20}));
    send(packet(3, 0x12, {0x20}));
    EXPECT_EQ(seen(), (std::vector<ModuleIdentity>{kServo, kStep, kIo}));
    send(packet(2, 0x13, {0x01}));
    EXPECT_EQ(bus.lastSample(1)->report.position, 0);
    send(packet(3, 0x0E));
    EXPECT_EQ(bus.lastSample(2)->report.items.mask(), 0x20) << "as defined";
    EXPECT_EQ(sent(), m_asked);
}

TEST_F(LentFamily, AStopFirstAsksWhatAModuleIs) {
    send(packet(kAll, 0x0F), 100ms);
    enumerate(3);
    // A PIC-STEP of which the panel only knows the address runs: amplifier on, 1x, speed 20.
    send(packet(2, 0x56, {0x03, 1, 200, 80, 0}));
    send(packet(2, 0x17, {0x01}));
    send(packet(2, 0x34, {0x86, 20, 2}));
    EXPECT_EQ(bus.count<CommandExecuted>(), 0U) << "whatever that was";
    const auto stopped = bus.stopAll();
    EXPECT_EQ(stopped->stopped, (std::vector<ModuleIndex>{kFirst, kSecond, ModuleIndex(2)}));
    EXPECT_EQ(bus.chain.snapshot(kSecond, bus.now).stepper->stepRate, 0.0);
    EXPECT_EQ(seen(), (std::vector<ModuleIdentity>{kServo, kStep, kIo}));
}

/// The first module was given its address, but never said what it is: the panel does not keep it.
TEST_F(Lent, AStopThatItsEndFindsUnderWayIsForTheModulesThatAreLeft) {
    send(packet(kAll, 0x0F), 100ms);
    enumerate(2);
    send(packet(2, 0x13, {0x20}));
    ASSERT_EQ(seen(), (std::vector<ModuleIdentity>{kUnheardModule, kServo}));
    bus.losesReply = [](ByteSpan) { return true; };
    bus.engine.stopAll(bus.now);
    bus.runFor(100ms);
    ASSERT_TRUE(bus.engine.stopping());
    bus.engine.takeBack(bus.now);
    EXPECT_TRUE(bus.engine.stopping());
    bus.losesReply = {};
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 5s));
}

TEST_F(Lent, AChangedAddressIsFollowed) {
    send(packet(2, 0x21, {7, kAll}));
    EXPECT_EQ(bus.last<AddressChanged>()->address, BusAddress(7));
    send(packet(7, 0x0E));
    EXPECT_EQ(bus.samplesOf(1), 2U) << "of the reply to Set Address, and of this one";
}

TEST_F(Lent, TheRateIsFollowed) {
    send(packet(kAll, 0x1A, {20}), 5ms);  // 57 600 Bd
    bus.engine.onProgramRate(57'600);
    bus.runFor(5ms);
    EXPECT_EQ(bus.hostBaud, 57'600U);
    send(packet(1, 0x0E));
    EXPECT_EQ(bus.count<Sample>(), 1U);
    EXPECT_EQ(bus.last<ModulesSeen>()->baud, 57'600U);
    EXPECT_TRUE(bus.stopAll()->unreached.empty());
}

TEST_F(Lent, RequestsOfThePanelAreRefused) {
    EXPECT_EQ(bus.perform({gains(0)}), Outcome::Forbidden);
    bus.engine.hold(forward(0), bus.now);
    bus.engine.changeRate(57'600, bus.now);
    bus.engine.readdress(kFirst, bus.now);
    bus.runFor(100ms);
    EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NotNow);
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::NotNow);
    EXPECT_TRUE(bus.sent.empty());
    EXPECT_FALSE(bus.engine.lend()) << "it is lent already";
}

/// A stop of all motors holds the program off; one of a single motor does not.
TEST_F(Lent, AStopOfASingleMotorIsRefusedAndIsNotOwed) {
    EXPECT_EQ(bus.perform({motorOff(0)}), Outcome::Forbidden);
    EXPECT_TRUE(bus.engine.unconfirmedStops().empty());
    bus.runFor(100ms);
    EXPECT_TRUE(bus.sent.empty());
}

/// The program runs the first motor.
class LentInMotion : public Lent {
protected:
    void SetUp() override {
        send(packet(1, 0xE6, {200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xA0, 0x0F, 1, 0}));
        send(packet(1, 0x17, {0x05}));
        send(packet(1, 0x94, {0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0}), 500ms);
        ASSERT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
        bus.sent.clear();
    }
};

TEST_F(LentInMotion, AStopWaitsForTheEndOfAPacket) {
    const Bytes nop = packet(2, 0x0E);
    send({nop.begin(), nop.begin() + 2}, 0ms);
    bus.engine.stopAll(bus.now);
    EXPECT_TRUE(bus.engine.stopping());
    bus.runFor(10ms);
    EXPECT_EQ(bus.sent.size(), 1U);
    // What the program sends behind the packet does not pass any more.
    send({nop[2], nop[3], 0xAA, 1, 0x05}, 0ms);
    EXPECT_EQ(bus.sent.at(1).bytes, (Bytes{nop[2], nop[3]}));
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 3s));
    EXPECT_EQ(bus.last<StopFinished>()->stopped, (std::vector<ModuleIndex>{kFirst, kSecond}));
    EXPECT_EQ(bus.servo(0).commandVelocity, 0.0);
    EXPECT_TRUE(bus.servo(0).servoOn) << "it holds";
    EXPECT_FALSE(bus.servo(1).servoOn) << "one that is off stays off";
    bus.expectNoViolations();
}

TEST_F(LentInMotion, AStopWaitsNoLongerThanTwentyMilliseconds) {
    send({0xAA, 2, 0xD4, 0x17}, 0ms);  // Load Trajectory, which goes no further
    bus.engine.stopAll(bus.now);
    bus.runFor(19ms);
    EXPECT_EQ(bus.sent.size(), 1U);
    bus.runFor(2ms);
    ASSERT_GE(bus.sent.size(), 2U);
    EXPECT_EQ(bus.sent[1].bytes, Bytes(kNullCount, 0)) << "for what the modules have of that packet";
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 3s));
    EXPECT_EQ(bus.last<StopFinished>()->stopped.size(), 2U);
    EXPECT_EQ(bus.servo(0).commandVelocity, 0.0);
}

TEST_F(LentInMotion, TheProgramIsHeldOffUntilItIsLetThrough) {
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(1s);
    bus.sent.clear();
    send(packet(1, 0x94, {0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0}), 500ms);
    EXPECT_TRUE(bus.sent.empty());
    EXPECT_EQ(bus.servo(0).commandVelocity, 0.0);
    bus.engine.letThrough(bus.now);
    EXPECT_TRUE(bus.engine.passes());
    send(packet(1, 0x94, {0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0}), 500ms);
    EXPECT_EQ(bus.sent.size(), 1U);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
}

TEST_F(LentInMotion, ThePanelsGuardsAreReadyToStopIt) {
    EXPECT_FALSE(bus.engine.stopBurst().empty());
}

TEST_F(LentInMotion, TakenBackTheModulesAreLookedAtAnewAndGoOn) {
    bus.engine.takeBack(bus.now);
    ASSERT_TRUE(bus.connect());
    const auto found = bus.last<ChainFound>();
    EXPECT_TRUE(found->attached);
    EXPECT_TRUE(found->absent.empty());
    EXPECT_EQ(found->modules.size(), 2U);
    bus.runFor(500ms);
    EXPECT_NEAR(bus.servo(0).commandVelocity, 1.0, 0.01);
    EXPECT_TRUE(bus.engine.answersForMotion()) << "the panel answers for it again";
    EXPECT_EQ(bus.perform({enable(0)}), Outcome::Done);
}

TEST(Lend, IsRefusedWhileAMotorMovesAndOnAReadOnlyConnection) {
    VirtualBus moving(servos(1));
    ASSERT_TRUE(moving.connect());
    EXPECT_EQ(moving.perform({gains(0), enable(0), loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    EXPECT_FALSE(moving.engine.lend());
    VirtualBus unconnected(servos(1));
    EXPECT_FALSE(unconnected.engine.lend());
    EngineConfig config;
    config.readOnly = true;
    moving.newHost(config);
    ASSERT_TRUE(moving.connect());
    EXPECT_FALSE(moving.engine.lend());
}

}  // namespace

}  // namespace nmc::test

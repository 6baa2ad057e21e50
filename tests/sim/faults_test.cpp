// SPDX-License-Identifier: GPL-3.0-or-later
// Faults on the line and in modules, one kind after the other, as a host sees them.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include <nlohmann/json.hpp>

#include "protocol/baud.h"
#include "sim/control.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class Faults : public testing::Test {
protected:
    Faults() { wire.address(3); }
    nlohmann::json say(const std::string& line) {
        return nlohmann::json::parse(handleControlLine(wire.chain, line, wire.now));
    }
    void fault(const std::string& text) {
        const auto answer = say("fault " + text);
        ASSERT_TRUE(answer.contains("ok")) << answer;
    }
    Bytes nop(unsigned address) { return wire.command(address, 0x0E); }
    unsigned executed(unsigned module, CommandCode code) {
        return static_cast<unsigned>(wire.chain.statistics().modules[module - 1].executions(code));
    }
    /// Brings the modules back in step after damaged commands, as every host does, and without faults.
    void flush() {
        say("fault clear");
        wire.exchange(Bytes(20, 0));
        wire.wait(milliseconds(2));
    }
    HostWire wire{"servo,servo,step", withFaults()};
};

TEST(FaultsDisabled, AreRefused) {
    HostWire wire;
    const auto answer = nlohmann::json::parse(handleControlLine(wire.chain, "fault bus drop", wire.now));
    EXPECT_EQ(answer["error"], "faults are not enabled; start with --enable-faults");
    EXPECT_EQ(wire.command(0, 0x0E), kIdle);
}

TEST_F(Faults, AreListedCountedAndCleared) {
    fault("bus drop status n=2");
    fault("module 3 cksum p=0");
    nop(1);
    EXPECT_EQ(say("faults")["faults"], nlohmann::json::parse(R"([
        {"fault":1,"text":"bus drop status n=2","struck":1,"active":true},
        {"fault":2,"text":"module 3 cksum p=0","struck":0,"active":true}])"));
    nop(1);
    EXPECT_EQ(say("faults")["faults"][0]["active"], false) << "it strikes twice and no more";
    EXPECT_EQ(nop(1), kIdle);
    say("fault clear");
    EXPECT_THAT(say("faults")["faults"], IsEmpty());
}

TEST_F(Faults, BeginAndEndAtTheirTimes) {
    const double now = toSeconds(wire.now.time_since_epoch());
    fault("bus silent at=" + std::to_string(now + 1.0) + " for=1s");
    EXPECT_EQ(nop(1), kIdle);
    wire.wait(milliseconds(1100));
    EXPECT_THAT(nop(1), IsEmpty());
    wire.wait(milliseconds(1000));
    EXPECT_EQ(nop(1), kIdle);
    EXPECT_TRUE(say("fault bus silent at=0.5")["error"].get<std::string>().starts_with("at is past"));
}

TEST_F(Faults, ThereIsAnEndToTheirNumber) {
    for (int i = 0; i < 100; ++i)
        fault("bus drop p=0");
    EXPECT_TRUE(say("fault bus drop p=0").contains("error"));
}

// ---- Damaged frames ----

TEST_F(Faults, DropLosesOneByteOfAReply) {
    fault("bus drop status n=1");
    EXPECT_THAT(wire.command(1, 0x13, {0x3F}), SizeIs(15));
    EXPECT_THAT(wire.command(1, 0x13, {0x3F}), SizeIs(16));
}

TEST_F(Faults, DropLosesOneByteOfACommandSoThatTheNextBecomesItsTail) {
    fault("bus drop cmd n=1");
    EXPECT_THAT(nop(1), IsEmpty());
    EXPECT_EQ(executed(1, CommandCode::Nop), 0U);
    flush();
    EXPECT_EQ(nop(1), kIdle);
}

TEST_F(Faults, DropAtOneModuleLeavesTheOthersAlone) {
    fault("module 2 drop cmd on=save_as_home n=1");
    EXPECT_EQ(nop(2), kIdle) << "it is for another command";
    wire.command(0xFF, 0x0C);
    flush();
    EXPECT_EQ(executed(1, CommandCode::SaveAsHome), 1U);
    EXPECT_EQ(executed(2, CommandCode::SaveAsHome), 0U);
    EXPECT_EQ(executed(3, CommandCode::SaveAsHome), 1U);
}

TEST_F(Faults, DupDoublesOneByte) {
    fault("module 1 dup status n=1");
    EXPECT_THAT(wire.command(2, 0x13, {0x3F}), SizeIs(16)) << "another module's reply";
    const Bytes reply = wire.command(1, 0x13, {0x3F});
    ASSERT_THAT(reply, SizeIs(17));
    const Bytes right = wire.command(1, 0x13, {0x3F});
    bool fits = false;
    for (std::size_t i = 0; i < right.size(); ++i) {
        Bytes doubled = right;
        doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), right[i]);
        fits = fits || doubled == reply;
    }
    EXPECT_TRUE(fits);
}

TEST_F(Faults, FlipTurnsTheGivenBitOfTheFrame) {
    fault("bus flip status bit=1 n=1");
    EXPECT_EQ(nop(1), (Bytes{0x1B, 0x19})) << "bit 1 of the status byte";
    fault("bus flip status bit=8 n=1");
    EXPECT_EQ(nop(1), (Bytes{0x19, 0x18})) << "bit 0 of the second byte";
    fault("bus flip status bit=16 n=1");
    EXPECT_EQ(nop(1), kIdle) << "there is no third byte";
}

TEST_F(Faults, FlipOfACommandIsRefusedByTheModule) {
    // AA 01 0C 0D: bit 24 is the sum's bit 0.
    fault("bus flip cmd bit=24 n=1");
    EXPECT_EQ(wire.command(1, 0x0C), (Bytes{0x1B, 0x1B})) << "communication error";
    EXPECT_EQ(executed(1, CommandCode::SaveAsHome), 0U);
    EXPECT_EQ(wire.chain.statistics().modules[0].checksumErrors, 1U);
}

RC_GTEST_PROP(FaultsProperty, CollideChangesTwoBitsAndKeepsTheSum, ()) {
    HostWire wire("servo", withFaults(*rc::gen::inRange<std::uint64_t>(1, 1'000'000)));
    wire.address(1);
    const auto items = *rc::gen::arbitrary<std::uint8_t>();
    const Bytes right = wire.command(1, 0x12, {items});
    static_cast<void>(handleControlLine(wire.chain, "fault bus collide status n=1", wire.now));
    const Bytes struck = wire.command(1, 0x0E);
    RC_ASSERT(struck.size() == right.size());
    int changed = 0;
    unsigned sum = 0;
    for (std::size_t i = 0; i < struck.size(); ++i) {
        changed += std::popcount(static_cast<unsigned>(struck[i] ^ right[i]));
        sum += i + 1 < struck.size() ? struck[i] : 0U;
    }
    RC_ASSERT(changed == 2);
    RC_ASSERT((sum & 0xFFU) == struck.back());
}

TEST_F(Faults, CollidedCommandsAreExecutedAsWhatTheyHaveBecome) {
    // Two bits of the data wrong and the sum right: the module has no way to know.
    fault("module 1 collide cmd on=set_gain");
    int changed = 0;
    for (int i = 0; i < 20; ++i) {
        wire.gains(goodGains());
        const Gains g = wire.truth().servo.gains;
        changed += g.kp != 200 || g.kd != 2000 || g.ki != 20 || g.il != 200 || g.ol != 255 || g.cl != 0 ||
                   g.el != 0x3FFF || g.sr != 1 || g.db != 0;
    }
    EXPECT_EQ(wire.chain.statistics().modules[0].checksumErrors, 0U);
    EXPECT_GT(changed, 10) << "the other collisions hit the address or the command";
}

TEST_F(Faults, TruncateLosesTheRest) {
    fault("bus truncate status n=1");
    const Bytes right = wire.command(2, 0x12, {0x1F});
    EXPECT_THAT(right, SizeIs(testing::AllOf(testing::Ge(1U), testing::Lt(14U))));
    fault("bus truncate cmd n=1");
    EXPECT_THAT(nop(2), IsEmpty());
}

TEST_F(Faults, GarbageIsRandomBytesOfTheSameNumber) {
    fault("bus garbage status n=1");
    const Bytes reply = wire.command(1, 0x13, {0x3F});
    EXPECT_THAT(reply, SizeIs(16));
    EXPECT_NE(reply, wire.command(1, 0x13, {0x3F}));
}

TEST_F(Faults, OverrunLosesAByteAndTheModuleSaysSo) {
    fault("module 1 overrun n=1");
    EXPECT_THAT(nop(1), IsEmpty()) << "it waits for the byte that it lost";
    // One more byte completes the packet; whatever it is, the packet was damaged.
    EXPECT_EQ(values(wire.exchange({0x00})), (Bytes{0x1B, 0x1B}));
}

TEST_F(Faults, AHostThatSendsByteByByteIsStruckToo) {
    fault("bus drop cmd n=1");
    for (const std::uint8_t byte : packet(1, 0x0E))
        wire.exchange({byte});
    EXPECT_EQ(executed(1, CommandCode::Nop), 0U);
    EXPECT_EQ(say("faults")["faults"][0]["struck"], 1);
}

/// 15 of the 18 bytes of a Set Gain are left, which would not fit behind another packet in a buffer of 19.
TEST_F(Faults, AFaultInjectedInAPacketWaitsForTheNextOne) {
    const Bytes gains = packet(1, 0xE6, goodGains());
    for (const bool followedBefore : {false, true}) {
        SCOPED_TRACE(followedBefore);
        if (followedBefore) {
            fault("bus drop cmd p=0");
            wire.exchange(gains);
            say("fault clear");
        }
        wire.exchange(Bytes(gains.begin(), gains.begin() + 3));
        fault("bus drop cmd n=1");
        EXPECT_EQ(values(wire.exchange(Bytes(gains.begin() + 3, gains.end()))), kIdle);
        EXPECT_EQ(say("faults")["faults"][0]["struck"], 0);
        EXPECT_THAT(nop(1), IsEmpty());
        EXPECT_EQ(say("faults")["faults"][0]["struck"], 1);
        flush();
    }
}

TEST_F(Faults, NullsBetweenPacketsAreNoFrames) {
    fault("bus drop cmd");
    wire.exchange(Bytes(16, 0));
    EXPECT_EQ(say("faults")["faults"][0]["struck"], 0);
}

TEST_F(Faults, ProbabilityIsThatOfAFrame) {
    fault("bus drop status p=0.1");
    int struck = 0;
    for (int i = 0; i < 2000; ++i)
        struck += nop(1).size() != 2;
    EXPECT_NEAR(struck, 200, 60) << "4.5 standard deviations of 13.4";
}

// ---- Late, missing and repeated replies ----

TEST_F(Faults, DelayOnTheBusHoldsTheReplyUpWhateverTheHostSends) {
    fault("bus delay t=50ms..50ms n=1");
    const Duration sent = milliseconds(10);
    wire.chain.hostSends(packet(1, 0x0E), wire.now);
    wire.now += sent;
    wire.chain.advanceTo(wire.now);
    EXPECT_THAT(wire.chain.takeHostBytes(), IsEmpty());
    // The answer to the next command waits for the late one.
    const auto both = wire.exchange(packet(2, 0x0E));
    ASSERT_THAT(both, SizeIs(4));
    EXPECT_GE(both[0].due - TimePoint{}, wire.now - TimePoint{} - milliseconds(60));
    EXPECT_EQ(values(both), (Bytes{0x19, 0x19, 0x19, 0x19}));
    EXPECT_EQ(both[1].due, both[2].due);
}

TEST_F(Faults, DelayInAModuleIsCutShortByTheNextCommand) {
    fault("module 1 delay t=50ms..50ms n=1");
    wire.chain.hostSends(packet(1, 0x0E), wire.now);
    wire.wait(milliseconds(10));
    EXPECT_EQ(nop(2), kIdle);
    EXPECT_EQ(wire.chain.statistics().modules[0].repliesDropped, 1U);
}

TEST_F(Faults, SilentExecutesWithoutAnswering) {
    fault("module 1 silent on=set_gain");
    EXPECT_THAT(wire.command(1, 0xE6, goodGains()), IsEmpty());
    EXPECT_EQ(wire.truth().servo.gains.kp, 200);
    EXPECT_EQ(nop(1), kIdle);
}

TEST_F(Faults, CksumRefusesAGoodPacket) {
    fault("module 3 cksum n=1 on=set_outputs");
    EXPECT_EQ(wire.command(3, 0x18, {0x01}), (Bytes{0x0A, 0x0A})) << "power and communication error";
    EXPECT_EQ(wire.truth(3).stepper->outputs, 0x10);
    wire.command(3, 0x18, {0x01});
    EXPECT_EQ(wire.truth(3).stepper->outputs, 0x01);
}

TEST_F(Faults, IgnoreIsAsIfTheCommandHadNeverCome) {
    fault("module 2 ignore=set_baud");
    wire.exchange(packet(0xFF, 0x1A, {10}));
    EXPECT_EQ(wire.truth(1).baud, realRate(10));
    EXPECT_EQ(wire.truth(2).baud, realRate(63));
    EXPECT_EQ(wire.truth(3).baud, realRate(10));
    EXPECT_EQ(executed(2, CommandCode::SetBaud), 0U);
}

TEST_F(Faults, StuckRepeatsTheReplyOfThatLength) {
    wire.enableAmplifier();
    fault("module 1 stuck");
    wire.pwm(100);
    const Bytes first = wire.command(1, 0x13, {0x05});
    wire.wait(milliseconds(200));
    EXPECT_EQ(wire.command(1, 0x13, {0x05}), first);
    say("fault clear");
    EXPECT_NE(wire.command(1, 0x13, {0x05}), first);
}

// ---- The line ----

TEST_F(Faults, NoiseReachesTheHostBetweenReplies) {
    fault("bus noise t=10ms..10ms n=5");
    wire.chain.advanceTo(wire.now + milliseconds(100));
    wire.now += milliseconds(100);
    const auto bytes = wire.chain.takeHostBytes();
    ASSERT_THAT(bytes, SizeIs(5));
    EXPECT_EQ(bytes[1].due - bytes[0].due, milliseconds(10));
}

TEST_F(Faults, NoiseOnTheCommandLineCutsReplies) {
    wire.command(1, 0x12, {0x3F});
    fault("bus noise cmd t=4ms..4ms n=20");
    EXPECT_LT(nop(1).size(), 16U) << "16 bytes take 8.2 ms";
}

TEST_F(Faults, BreakMakesEveryByteZero) {
    fault("bus break status for=100ms");
    EXPECT_THAT(values(wire.chain.takeHostBytes()), ElementsAre(0));
    EXPECT_EQ(nop(1), (Bytes{0, 0}));
    wire.wait(milliseconds(100));
    EXPECT_EQ(nop(1), kIdle);
}

TEST_F(Faults, BreakOfTheCommandLineIsHeardAsZeros) {
    fault("bus break cmd for=100ms");
    EXPECT_THAT(nop(1), IsEmpty());
    wire.wait(milliseconds(100));
    EXPECT_EQ(nop(1), kIdle);
}

TEST_F(Faults, MuteRxLetsModulesObeyUnheard) {
    fault("bus mute rx");
    EXPECT_THAT(wire.command(1, 0x0C), IsEmpty());
    EXPECT_EQ(executed(1, CommandCode::SaveAsHome), 1U);
}

TEST_F(Faults, MuteTxKeepsCommandsFromAModule) {
    fault("module 2 mute tx");
    wire.command(0xFF, 0x0C);
    EXPECT_EQ(executed(1, CommandCode::SaveAsHome), 1U);
    EXPECT_EQ(executed(2, CommandCode::SaveAsHome), 0U);
    EXPECT_THAT(nop(2), IsEmpty());
}

TEST_F(Faults, EchoGivesTheHostItsOwnBytesFirst) {
    fault("bus echo");
    Bytes expected = packet(1, 0x0E);
    expected.insert(expected.end(), kIdle.begin(), kIdle.end());
    EXPECT_EQ(nop(1), expected);
}

TEST_F(Faults, ForeignCommandsAreAnsweredAndNotBlamedOnTheHost) {
    fault("bus foreign t=20ms..20ms n=10 on=read_status");
    wire.chain.advanceTo(wire.now + milliseconds(500));
    EXPECT_GE(wire.chain.takeHostBytes().size(), 20U);
    EXPECT_EQ(wire.chain.statistics().bytesIn, 3 * 6U) << "the three Set Address of this host";
    EXPECT_THAT(wire.violations(), IsEmpty());
    unsigned total = 0;
    for (unsigned module = 1; module <= 3; ++module)
        total += executed(module, CommandCode::ReadStatus);
    EXPECT_EQ(total, 10U);
}

TEST_F(Faults, AnotherHostsBytesAreCarriedOutAndAnsweredLikeThisHosts) {
    const Bytes save = packet(2, 0x0C);
    ASSERT_TRUE(wire.chain.foreignSends(save, wire.now));
    wire.chain.advanceTo(wire.now + milliseconds(20));
    EXPECT_EQ(wire.chain.takeHostBytes().size(), 2U) << "the answer, and not the command";
    EXPECT_EQ(executed(2, CommandCode::SaveAsHome), 1U);
    EXPECT_EQ(wire.chain.statistics().bytesIn, 3 * 6U) << "the three Set Address of this host";
    EXPECT_THAT(wire.violations(), IsEmpty());
}

TEST_F(Faults, MutesAndEchoesCountTheirBytes) {
    const auto struckOnce = [this](const std::string& kind) {
        say("fault clear");
        fault(kind);
        nop(1);  // four bytes, and two in answer
        nop(3);
        return say("faults")["faults"][0]["struck"].get<int>();
    };
    EXPECT_EQ(struckOnce("bus mute rx"), 4);
    EXPECT_EQ(struckOnce("module 1 mute rx"), 2);
    EXPECT_EQ(struckOnce("module 2 mute rx"), 0);
    EXPECT_EQ(struckOnce("bus mute tx"), 8);
    EXPECT_EQ(struckOnce("module 2,3 mute tx"), 8) << "each byte once";
    EXPECT_EQ(struckOnce("bus echo"), 8);
    EXPECT_EQ(struckOnce("bus echo at=1000"), 0) << "it has not begun";
}

/// A half-duplex adapter hears each byte as it leaves: at 19 200 Bd four bytes have come back by 2.083 ms,
/// each at the end of its stop bit.
TEST_F(Faults, EchoedBytesComeBackWhenTheyHaveLeft) {
    fault("bus echo");
    wire.chain.hostSends(packet(1, 0x0E), wire.now);
    wire.chain.advanceTo(wire.now + milliseconds(100));
    const auto bytes = wire.chain.takeHostBytes();
    ASSERT_GE(bytes.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(bytes[i].due, wire.now + static_cast<Duration::rep>(i + 1) * byteTimeAtBaud(19'200));
}

// ---- The module ----

TEST_F(Faults, PowerCycleLosesTheAddress) {
    fault("module 1 powercycle");
    EXPECT_EQ(wire.truth(1).address, 0);
    EXPECT_EQ(wire.truth(2).address, 2);
    EXPECT_THAT(nop(1), IsEmpty());
    EXPECT_EQ(say("faults")["faults"][0]["active"], false);
}

TEST_F(Faults, StallHoldsTheShaftUntilItIsOver) {
    wire.enableAmplifier();
    fault("module 1 stall");
    wire.pwm(50);
    wire.wait(milliseconds(490));
    EXPECT_EQ(wire.truth().servo.position, 0);
    // The stalled motor: 24 V * 50/255 through 1.1 ohm.
    EXPECT_NEAR(wire.truth().servo.amperes, 24.0 * 50 / 255 / 1.1, 1e-6);
    say("fault clear");
    wire.wait(milliseconds(200));
    EXPECT_GT(wire.truth().servo.position, 100);
}

TEST_F(Faults, StallAndReverseEndByThemselves) {
    wire.enableAmplifier();
    fault("module 1 stall for=100ms");
    fault("module 2 reverse for=100ms");
    wire.wait(milliseconds(101));
    EXPECT_FALSE(say("faults")["faults"][0]["active"]);
    wire.pwm(60);
    wire.enableAmplifier(2);
    wire.pwm(60, 2);
    wire.wait(milliseconds(100));
    EXPECT_GT(wire.truth(1).servo.position, 50);
    EXPECT_GT(wire.truth(2).servo.position, 50);
}

TEST_F(Faults, StallTripsThePositionErrorLimit) {
    wire.enableAmplifier();
    wire.gains(goodGains(400));
    wire.servoOn();
    wire.command(1, 0x0B);
    fault("module 1 stall");
    wire.velocity(kOne, kOne);
    wire.waitTicks(420);
    EXPECT_TRUE(wire.report().positionError());
    EXPECT_FALSE(wire.report().servoOn());
}

TEST_F(Faults, ReverseCountsTheWrongWay) {
    wire.enableAmplifier();
    fault("module 1 reverse");
    wire.pwm(60);
    wire.wait(milliseconds(290));
    const ServoSnapshot during = wire.truth().servo;
    EXPECT_LT(during.position, -100);
    EXPECT_NEAR(during.position, -during.shaftCounts, 1.0);
    say("fault clear");
    wire.wait(milliseconds(100));
    EXPECT_GT(wire.truth().servo.position, during.position) << "the right way again, from there on";
}

TEST_F(Faults, SameAddressMakesTwoModulesAnswerAtOnce) {
    fault("module 2,1 sameaddr");
    EXPECT_EQ(wire.truth(1).address, 2);
    EXPECT_EQ(wire.truth(2).address, 2);
    nop(2);
    EXPECT_EQ(executed(1, CommandCode::Nop), 1U);
    EXPECT_EQ(executed(2, CommandCode::Nop), 1U);
}

TEST_F(Faults, DefineStatusIsAnotherHostsWork) {
    fault("module 1 definestat");
    EXPECT_GT(nop(1).size(), 2U);
    EXPECT_EQ(nop(2), kIdle);
}

// ---- All of them ----

/// The bytes that the host receives in a session with many faults at once.
Bytes session(std::uint64_t seed, bool more) {
    HostWire wire("servo,servo,step", withFaults(seed));
    wire.address(3);
    for (const char* text :
         {"fault bus drop p=0.05", "fault bus flip p=0.05", "fault module 2 collide p=0.1",
          "fault bus dup p=0.05", "fault bus truncate p=0.02", "fault bus garbage p=0.02",
          "fault module 3 overrun p=0.1", "fault bus delay p=0.05 t=1ms..60ms", "fault bus noise",
          "fault module 1 silent p=0.1", "fault bus cksum p=0.05", "fault bus foreign"})
        static_cast<void>(handleControlLine(wire.chain, text, wire.now));
    if (more)
        static_cast<void>(handleControlLine(wire.chain, "fault bus silent p=0", wire.now));
    Bytes heard;
    for (unsigned i = 0; i < 200; ++i) {
        wire.chain.hostSends(packet(1 + i % 3, 0x13, {static_cast<std::uint8_t>(i)}), wire.now);
        wire.now += milliseconds(15);
        wire.chain.advanceTo(wire.now);
        for (const std::uint8_t byte : values(wire.chain.takeHostBytes()))
            heard.push_back(byte);
    }
    return heard;
}

TEST(FaultsTogether, TheSameSeedGivesTheSameFaults) {
    EXPECT_EQ(session(7, false), session(7, false));
    EXPECT_NE(session(7, false), session(8, false));
    EXPECT_EQ(session(7, true), session(7, false)) << "a fault that never strikes changes no other";
}

}  // namespace
}  // namespace nmc::sim::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

[[nodiscard]] auto losesModule(std::uint8_t address) {
    return [address](ByteSpan command) {
        return command.size() > 1 && command[0] == 0xAA && command[1] == address;
    };
}

TEST(Polls, TakeTurnsAndUseTheWire) {
    VirtualBus bus(servos(4));
    ASSERT_TRUE(bus.connect());
    bus.runFor(2s);
    for (std::uint8_t i = 1; i < 4; ++i)
        EXPECT_NEAR(static_cast<double>(bus.samplesOf(i)), static_cast<double>(bus.samplesOf(0)), 1);
    const auto sample = bus.lastSample(2);
    EXPECT_TRUE(sample->report.position);
    EXPECT_TRUE(sample->report.aux);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
    bus.expectNoViolations();
}

TEST(Polls, TakeTurnsInTwoLayoutsOfDifferentLength) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    const std::size_t from = bus.sent.size();
    bus.runFor(2s);
    const double full = static_cast<double>(bus.sends("AA 01 13 3F 53", from));
    const double shortOnes = static_cast<double>(bus.sends("AA 01 0E 0F", from));
    EXPECT_NEAR(shortOnes, full, 1);
    EXPECT_GT(full, 10);
}

TEST(Polls, AreStampedWithTheTimeAtWhichTheModuleLatchedThem) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 4 * 65'536, true)}), Outcome::Done);
    bus.runFor(2s);
    // 4 counts a tick: a line through the samples has that slope, and no sample is off by more than half a
    // tick.
    const auto samples = bus.all<Sample>();
    const Sample& last = samples.back();
    for (auto it = samples.end() - 100; it != samples.end(); ++it) {
        const double ticks = toSeconds(last.time - it->time) / toSeconds(kServoTick);
        EXPECT_NEAR(*last.report.position - *it->report.position, 4 * ticks, 4 * 1.0 + 3);
    }
}

/// 32 modules at 19 200 Bd: a module that is not being watched is polled every 0.6 s, and runs and stops in
/// between.
class PollsOfEachChip : public testing::TestWithParam<std::uint8_t> {};

TEST_P(PollsOfEachChip, BelieveAMotionThatLiesBetweenTwoOfThem) {
    VirtualBus bus(servos(32, GetParam()));
    ASSERT_TRUE(bus.connect());
    bus.engine.watch({ModuleIndex(31)});
    for (std::uint8_t i = 0; i < 4; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
    for (int round = 0; round < 5; ++round) {
        for (std::uint8_t i = 0; i < 4; ++i)
            ASSERT_EQ(bus.perform({loadVelocity(i, 8 * 65'536, true)}), Outcome::Done);
        bus.runFor(550ms + round * 50ms);
        const auto stopped = bus.stopAll();
        ASSERT_TRUE(stopped);
        EXPECT_EQ(stopped->stopped.size(), 32U);
    }
    EXPECT_EQ(bus.engine.statistics().rejected, 0U);
    bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, PollsOfEachChip, testing::Values(std::uint8_t{4}, kPathVersion, kScVersion));

/// Beside errors that are reported, calculated ones would look like a swing: they are off by up to half a
/// tick of the motion.
TEST(Polls, InFocusAlwaysAskALaterChipForItsPositionError) {
    VirtualBus bus({{ModuleType::Servo, kPathVersion}, {ModuleType::Servo, kScVersion}});
    ASSERT_TRUE(bus.connect());
    for (const ModuleIndex module : {ModuleIndex(0), ModuleIndex(1)}) {
        bus.engine.focus(module, bus.now);
        bus.runFor(50ms);
        bus.events.clear();
        bus.runFor(500ms);
        for (const Sample& sample : bus.all<Sample>())
            if (sample.module == module) {
                EXPECT_TRUE(sample.report.positionError);
            }
    }
}

TEST(Polls, SurviveALostReply) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    int n = 0;
    bus.losesReply = [&](ByteSpan command) { return command.size() == 4 && n++ == 5; };
    bus.runFor(1s);
    EXPECT_EQ(bus.engine.statistics().timeouts, 1U);
    EXPECT_EQ(bus.engine.statistics().resyncs, 1U);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
    bus.expectNoViolations();
}

TEST(Polls, WaitOutALateReply) {
    ScriptedBus bus(2);
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    const auto before = bus.engine.statistics();
    bus.replyDelay = 60ms;  // three time-outs late: falls into the quarantine
    const std::size_t sent = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > sent; }));
    bus.replyDelay = 2ms;
    const TimePoint from = bus.now;
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before.timeouts; }));
    const std::size_t late = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > late; }));
    EXPECT_EQ(bus.sent.back().hex, ScriptedBus::kNulls);
    EXPECT_GE(bus.now - from, 100ms);
    bus.runFor(200ms);
    EXPECT_EQ(bus.engine.statistics().badChecksum, 0U);
    EXPECT_EQ(bus.engine.statistics().timeouts, before.timeouts + 1);
    EXPECT_GE(bus.engine.statistics().surplusBytes, 8U);
}

TEST(Silence, OfOneModuleIsToldAndCostsTheOthersLittle) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    bus.runFor(5s);
    const std::size_t others = bus.samplesOf(0) + bus.samplesOf(2);
    const std::size_t all = others + bus.samplesOf(1);
    bus.losesReply = losesModule(2);
    bus.runFor(2s);
    ASSERT_EQ(bus.count<ModuleUnresponsive>(), 1U);
    EXPECT_EQ(bus.last<ModuleUnresponsive>()->module, ModuleIndex(1));
    EXPECT_TRUE(bus.last<ModuleUnresponsive>()->silent);
    EXPECT_EQ(bus.engine.stopReach(), 2U);
    const std::size_t before = bus.samplesOf(0) + bus.samplesOf(2);
    bus.runFor(5s);
    const auto now = static_cast<double>(bus.samplesOf(0) + bus.samplesOf(2) - before);
    EXPECT_GT(now, 0.9 * static_cast<double>(all)) << "of the whole bus's rate";
    EXPECT_EQ(bus.count<LinkLost>(), 0U);

    bus.losesReply = {};
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleUnresponsive>() == 2; }, 5s));
    EXPECT_FALSE(bus.last<ModuleUnresponsive>()->silent);
    const std::size_t samples = bus.samplesOf(1);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(1), samples + 30);
    EXPECT_EQ(bus.engine.stopReach(), 3U);
}

TEST(Silence, OfManyCostsTheOthersLittle) {
    EngineConfig config;
    config.adapterLatency = 16ms;
    VirtualBus bus(servos(32), config);
    ASSERT_TRUE(bus.connect());
    const std::size_t connected = bus.count<Sample>();
    bus.runFor(5s);
    const std::size_t all = bus.count<Sample>() - connected;
    bus.losesReply = [](ByteSpan command) {
        return command.size() > 1 && command[0] == 0xAA && command[1] > 2;
    };
    bus.runFor(30s);
    ASSERT_EQ(bus.count<ModuleUnresponsive>(), 30U);
    const std::size_t before = bus.count<Sample>();
    bus.runFor(5s);
    EXPECT_GT(static_cast<double>(bus.count<Sample>() - before), 0.9 * static_cast<double>(all));
    bus.losesReply = {};
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleUnresponsive>() == 60; }, 6s));
}

TEST(Silence, OfAllIsALostLinkThatComesBackByItself) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    const std::size_t lost = bus.sent.size();
    bus.losesReply = [](ByteSpan) { return true; };
    bus.runFor(6s);
    EXPECT_EQ(bus.count<LinkLost>(), 1U);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 3U);
    EXPECT_EQ(bus.engine.stopReach(), 0U);
    EXPECT_GE(bus.sends("AA 01 17 05 1D", lost), 10U) << "commands may still arrive";
    EXPECT_EQ(bus.sends("AA 02 17", lost), 0U) << "its servo was off";
    const std::size_t from = bus.sent.size();
    bus.runFor(10s);
    const std::size_t questions =
        bus.sends("AA 01 13", from) + bus.sends("AA 02 13", from) + bus.sends("AA 03 13", from);
    EXPECT_NEAR(static_cast<double>(questions), 10, 1) << "once a second";
    EXPECT_NEAR(static_cast<double>(bus.sends("AA 01 17 05 1D", from)), 20, 1) << "a stop is owed to it";
    bus.losesReply = {};
    const std::size_t then = bus.sent.size();
    bus.runFor(3s);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 6U);
    EXPECT_EQ(bus.count<LinkLost>(), 1U);
    EXPECT_EQ(bus.count<OwedStopConfirmed>(), 1U);
    // Only that stop and queries are sent: nothing that moves, enables or sets gains.
    for (std::size_t i = then; i < bus.sent.size(); ++i)
        if (bus.sent[i].bytes[0] == 0xAA) {
            const int code = bus.sent[i].bytes[2] & 0x0F;
            EXPECT_TRUE(code == 0x2 || code == 0x3 || code == 0xE || bus.sent[i].hex() == "AA 01 17 05 1D")
                << bus.sent[i].hex();
        }
    bus.losesReply = [](ByteSpan) { return true; };
    bus.runFor(5s);
    EXPECT_EQ(bus.count<LinkLost>(), 2U);
}

TEST(Silence, OfAStopThatFindsNobodyEndsSoonAndSaysSo) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.runFor(200ms);
    bus.losesReply = [](ByteSpan) { return true; };
    bus.runFor(5s);
    const std::size_t from = bus.sent.size();
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->unreached.size(), 2U);
    EXPECT_EQ(bus.sends("00 00", from) > 0, true);
    EXPECT_GE(bus.sends("AA 01 17 05 1D", from), 3U) << "the command may still arrive";
    EXPECT_EQ(bus.sends("AA 02 17", from), 0U) << "its servo was off";
}

TEST(Link, SurvivesTheReplyOfAnotherLength) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    // Another host redefines the status; three replies are rejected, the module counts as silent, and then
    // the layout is defined again.
    bus.chain.hostSends(fromHex("AA 01 12 1F 32 "), bus.now);
    bus.runFor(4s);
    const std::size_t samples = bus.samplesOf(0);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(0), samples + 30);
}

TEST(Link, AcceptsTheLatencyOfAnAdapter) {
    EngineConfig config;
    config.adapterLatency = 16ms;
    VirtualBus bus(servos(2), config);
    bus.adapterDelay = 16ms;
    ASSERT_TRUE(bus.connect());
    bus.runFor(2s);
    EXPECT_EQ(bus.engine.statistics().errors(), 0U);
}

/// With arbitrary bytes at any time, the engine continues, sends nothing that moves a motor, and works again
/// afterwards.
RC_GTEST_PROP(Link, OutlivesGarbage, ()) {
    VirtualBus bus(servos(2));
    RC_ASSERT(bus.connect());
    for (int i = 0; i < 60; ++i) {
        const auto bytes = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
        bus.engine.onBytes(bytes, bus.now);
        bus.runFor(*rc::gen::inRange(0, 40) * 1ms);
    }
    for (const auto& sent : bus.sent)
        if (sent.bytes[0] == 0xAA && sent.bytes[1] != 0 && sent.bytes[1] != 0xFF) {
            const int code = sent.bytes[2] & 0x0F;
            RC_ASSERT(code == 0x2 || code == 0x3 || code == 0xE);
        }
    bus.runFor(5s);
    const std::size_t samples = bus.samplesOf(0);
    bus.runFor(1s);
    RC_ASSERT(bus.samplesOf(0) > samples + 30);
}

TEST(Link, OutlivesAFloodInEveryPhase) {
    const std::vector<std::uint8_t> flood(64 * 1024, 0x5A);
    VirtualBus bus(servos(2));
    bus.engine.onBytes(flood, bus.now);
    bus.engine.connect(bus.now);
    for (int i = 0; i < 50; ++i) {
        bus.engine.onBytes(flood, bus.now);
        bus.runFor(37ms);
    }
    ASSERT_TRUE(bus.connect());
    for (int i = 0; i < 50; ++i) {
        if (i % 10 == 5)
            bus.engine.stopAll(bus.now);
        bus.engine.onBytes(flood, bus.now);
        bus.runFor(37ms);
    }
    bus.runFor(5s);
    EXPECT_EQ(bus.engine.stopReach(), 2U);
    EXPECT_GT(bus.engine.statistics().surplusBytes, flood.size());
}

/// Operations, holds, stops and losses in any order: each operation and each stop ends once, nothing happens
/// that a real chip would not tolerate except as a result of lost bytes, and a final stop is effective.
RC_GTEST_PROP(Engine, KeepsItsPromisesInAnyOrder, ()) {
    VirtualBus bus(servos(2));
    RC_ASSERT(bus.connect());
    RC_ASSERT(bus.perform({gains(0), enable(0), gains(1), enable(1)}) == Outcome::Done);
    int loss = 0;
    std::uint32_t noise = 1;
    bus.losesByte = [&](std::uint8_t) {
        noise = noise * 1'664'525U + 1'013'904'223U;
        return loss > 0 && (noise >> 16U) % 100U < static_cast<std::uint32_t>(loss);
    };
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        std::erase_if(command, [&](std::uint8_t byte) { return bus.losesByte(byte); });
    };
    std::vector<OperationId> submitted;
    for (int i = 0; i < 40; ++i) {
        const auto module = static_cast<std::uint8_t>(*rc::gen::inRange(0, 2));
        switch (*rc::gen::inRange(0, 8)) {
            case 0:
                submitted.push_back(
                    bus.submit({loadMove(module, *rc::gen::inRange(-500, 500)), start(module)}));
                break;
            case 1:
                submitted.push_back(bus.submit({loadVelocity(module, 32'768, true)}));
                break;
            case 2:
                submitted.push_back(
                    bus.submit({toServo(module, servo::StopMotor{true, servo::StopManner::Smoothly, {}})}));
                break;
            case 3:
                bus.engine.hold(forward(module, 20'000), bus.now);
                break;
            case 4:
                bus.engine.release(bus.now);
                break;
            case 5:
                bus.engine.stopAll(bus.now);
                break;
            case 6:
                loss = *rc::gen::inRange(0, 4);
                break;
            default:
                submitted.push_back(bus.submit({toServo(module, ResetPosition{})}));
        }
        bus.runFor(*rc::gen::inRange(0, 300) * 1ms);
    }
    loss = 0;
    bus.runFor(3s);
    const auto stopped = bus.stopAll();
    RC_ASSERT(stopped.has_value());
    for (const ModuleIndex module : {ModuleIndex(0), ModuleIndex(1)}) {
        const auto servo = bus.servo(module.value());
        RC_ASSERT(servo.commandVelocity == 0);
        // A load that is cut short and filled up with nulls can be a Set Gain with a valid sum (link.md 1):
        // such a servo may swing for ever, and the stop reports it.
        if (servo.gains.kp == 200)
            RC_ASSERT(std::count(stopped->stopped.begin(), stopped->stopped.end(), module) == 1);
    }
    std::map<std::uint32_t, int> ends;
    for (const auto& finished : bus.all<OperationFinished>())
        ++ends[finished.id.value()];
    for (const OperationId id : submitted)
        RC_ASSERT(ends[id.value()] == 1);
    // A lost byte can result in another command, for instance one of a wrong length, if nulls or zeros
    // complete its sum (link.md 1). Nothing that the gate forbids ever happens.
    using enum sim::ViolationKind;
    for (const sim::Violation& v : bus.chain.violations().entries())
        if (v.kind == TrapezoidInMotion || v.kind == ResetInMotion || v.kind == ReplyCollision)
            RC_FAIL(std::string(sim::toText(v.kind)) + ": " + toHex(v.bytes));
}

}  // namespace

}  // namespace nmc::test

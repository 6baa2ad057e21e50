// SPDX-License-Identifier: GPL-3.0-or-later
// Gains that are tried, and taken back whatever happens: engine and simulator in virtual time. Expected
// values are compared with the simulator's own state.
#include <gtest/gtest.h>

#include "tests/bus/groups.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {
namespace {

using namespace bus;
using namespace std::chrono_literals;

const servo::SetGain kGood = std::get<servo::SetGain>(std::get<ServoCommand>(gains(0).command));
/// Less stiff, but holds as well.
constexpr servo::SetGain kOther{150, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
/// No damping: a push makes it swing more and more.
constexpr servo::SetGain kBad{3'000, 0, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};

class Trials : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1)}), Outcome::Done);
        bus.runFor(300ms);
    }
    void beginTrial(const servo::SetGain& tried, Duration lasts = 10s) {
        id = bus.submit({.id = {},
                         .orders = {toServo(0, tried)},
                         .trial = GainTrial{kGood, bus.servo(0).position, 2'000, lasts}});
        ASSERT_TRUE(bus.runUntil([&] { return has(tried); }, 1s));
    }
    void push() {
        bus.chain.set(ModuleIndex(0), sim::Input::Load, 0.05, bus.now);
        bus.runFor(4ms);
        bus.chain.set(ModuleIndex(0), sim::Input::Load, 0.0, bus.now);
    }
    /// True if the chip has these gains.
    [[nodiscard]] bool has(const servo::SetGain& wanted) {
        const auto& g = bus.servo(0).gains;
        return g.kp == wanted.kp && g.kd == wanted.kd;
    }
    [[nodiscard]] bool comesBack(Duration within) {
        return bus.runUntil([&] { return has(kGood); }, within);
    }
    [[nodiscard]] std::optional<OperationFinished> finished() {
        bus.runFor(50ms);
        std::optional<OperationFinished> end;
        for (const auto& one : bus.all<OperationFinished>())
            if (one.id == id) {
                EXPECT_FALSE(end) << "exactly one";
                end = one;
            }
        return end;
    }
    void fault(sim::FaultKind kind, Duration lasts) {
        sim::FaultSpec spec;
        spec.kind = kind;
        spec.modules = {0};
        ASSERT_TRUE(bus.chain.inject(spec, bus.now).has_value());
        bus.runFor(lasts);
        bus.chain.clearFaults(bus.now);
    }
    GroupBus bus{servos(2), EngineConfig{115'200}, withFaults()};
    OperationId id{0};
};

TEST_F(Trials, EndWhenTheTimeIsOverWithNobodyAsking) {
    beginTrial(kOther, 2s);
    const TimePoint began = bus.now;
    ASSERT_TRUE(comesBack(3s));
    EXPECT_NEAR(toSeconds(bus.now - began), 2.0, 0.02);
    const auto end = finished();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->outcome, Outcome::Done);
    EXPECT_EQ(end->trial, TrialEnd::TimeOver);
    bus.expectNoViolations();
}

/// A module that has restarted makes the panel stop everything, and send nothing more to the others.
TEST_F(Trials, EndWhenTheLinkIsGivenUp) {
    beginTrial(kOther);
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    EXPECT_TRUE(comesBack(5s));
    const auto end = finished();
    ASSERT_TRUE(end);
    EXPECT_EQ(end->outcome, Outcome::Cancelled);
}

/// As long as it has the gains that were tried, it must not move.
TEST_F(Trials, AreOverBeforeTheirModuleMoves) {
    beginTrial(kOther);
    unsigned refused = 0;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        const bool gain = command.size() > 2 && command[1] == 1 && (command[2] & 0x0FU) == 0x06;
        if (gain && refused < 3) {
            ++refused;
            command.back() ^= 0x40U;  // the module flags a communication error
        }
    };
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Forbidden);
    EXPECT_EQ(refused, 3U) << "all attempts (link.md 2.3)";
    EXPECT_TRUE(has(kOther));
    EXPECT_NEAR(bus.servo(0).position, 0, 3);
    EXPECT_TRUE(comesBack(1s));
    EXPECT_EQ(bus.perform({loadMove(0, 1'000), start(0)}), Outcome::Done);
}

TEST_F(Trials, EndBeforeTheGroupStarts) {
    for (const std::uint8_t member : {std::uint8_t{0}, std::uint8_t{1}}) {
        ASSERT_EQ(bus.put(member, kGroup).outcome, Outcome::Done);
        ASSERT_EQ(bus.perform({loadMove(member, 1'000)}), Outcome::Done);
    }
    beginTrial(kOther);
    unsigned starts = 0;
    bus.onCommand = [&](const std::vector<std::uint8_t>& command) {
        if (command.size() < 3 || command[1] != kGroup || command[2] != 0x05)  // Start Motion
            return;
        ++starts;
        EXPECT_TRUE(has(kGood));
    };
    EXPECT_EQ(bus.start(kGroup).outcome, Outcome::Done);
    EXPECT_EQ(starts, 1U);
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 3);
    bus.expectNoViolations();
}

/// For as long as that takes, nobody would watch them.
TEST_F(Trials, PermitNoChangeOfRateOrAddress) {
    beginTrial(kOther);
    const std::size_t from = bus.sent.size();
    bus.engine.changeRate(57'600, bus.now);
    bus.engine.readdress(ModuleIndex(1), bus.now);
    bus.engine.resetModule(ModuleIndex(1), bus.now);
    bus.runFor(500ms);
    ASSERT_TRUE(bus.last<RateChangeFailed>());
    EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NotNow);
    EXPECT_EQ(bus.count<ReaddressFailed>(), 2U);
    EXPECT_EQ(bus.sends("AA FF 1A", from), 0U);
    EXPECT_TRUE(has(kOther));
    bus.expectNoViolations();
}

TEST_F(Trials, StayWhenTheyAreKept) {
    beginTrial(kOther, 1s);
    bus.runFor(500ms);
    bus.engine.keepTrial(ModuleIndex(0), bus.now);
    bus.runFor(3s);
    EXPECT_TRUE(has(kOther));
    ASSERT_TRUE(finished());
    EXPECT_EQ(finished()->trial, TrialEnd::Kept);
    bus.engine.keepTrial(ModuleIndex(0), bus.now);
    EXPECT_TRUE(finished()) << "no second end";
}

TEST_F(Trials, AreTakenBackWithinMillisecondsOfTheFirstSwings) {
    beginTrial(kBad);
    push();
    const TimePoint pushed = bus.now;
    ASSERT_TRUE(comesBack(1s));
    EXPECT_LT(bus.now - pushed, 30ms);
    const auto end = finished();
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->trial == TrialEnd::Swings || end->trial == TrialEnd::Saturates);
    bus.runFor(500ms);
    const std::int32_t calm = bus.servo(0).position;
    bus.runFor(500ms);
    EXPECT_NEAR(bus.servo(0).position, calm, 2);
    EXPECT_TRUE(bus.servo(0).servoOn);
}

TEST_F(Trials, TooLateToKeepIsTooLate) {
    beginTrial(kBad);
    push();
    ASSERT_TRUE(comesBack(1s));
    bus.engine.keepTrial(ModuleIndex(0), bus.now);
    bus.runFor(500ms);
    EXPECT_TRUE(has(kGood));
    EXPECT_NE(finished()->trial, TrialEnd::Kept);
}

TEST_F(Trials, AStopOfAllTakesThemBackAndSeesASwingingServoAtRest) {
    // The stop comes while the servo swings with bad gains, and has to cope with that.
    beginTrial(kOther);
    ASSERT_EQ(bus.perform({toServo(0, kOther)}), Outcome::Done) << "this ends the trial";
    beginTrial(kBad);
    push();
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() == 1; }, 5s));
    const auto stopped = bus.last<StopFinished>();
    EXPECT_EQ(stopped->stopped.size(), 2U);
    EXPECT_TRUE(has(kGood)) << "before the end of the stop is reported";
    EXPECT_LT(stopped->took, 1s);
}

TEST_F(Trials, StopsGoBeforeThem) {
    beginTrial(kOther);
    bus.runFor(100ms);
    const std::size_t from = bus.sent.size();
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(comesBack(1s));
    std::optional<std::size_t> stop, gain;
    for (std::size_t i = from; i < bus.sent.size(); ++i) {
        const std::string hex = bus.sent[i].hex();
        if (hex.find("17 05") != std::string::npos && !stop)
            stop = i;
        if (hex.starts_with("AA 01 E6") && !gain)  // Set Gain
            gain = i;
    }
    ASSERT_TRUE(stop && gain);
    EXPECT_LT(*stop, *gain);
}

TEST_F(Trials, AreNotSentAgainAfterTheStopThatEndsThem) {
    const std::size_t from = bus.sent.size();
    const auto before = bus.engine.statistics().timeouts;
    bool lost = false;
    bus.losesReply = [&](ByteSpan command) { return command.size() > 10 && !std::exchange(lost, true); };
    id = bus.submit({.id = {}, .orders = {toServo(0, kOther)}, .trial = GainTrial{kGood, 0, 2'000, 10s}});
    ASSERT_TRUE(bus.runUntil([&] { return bus.engine.statistics().timeouts > before; }, 1s));
    bus.submit({motorOff(0)});
    bus.runFor(1s);
    EXPECT_TRUE(lost);
    EXPECT_EQ(bus.sends("AA 01 E6 96 00", from), 1U) << "Kp is 150";
    EXPECT_TRUE(has(kGood));
    EXPECT_FALSE(bus.servo(0).servoOn);
}

TEST_F(Trials, AreNotSentAgainWhenTheyAreRefusedAfterTheStopThatEndsThem) {
    const std::size_t from = bus.sent.size();
    bool refused = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 10 && !std::exchange(refused, true))
            command.back() ^= 0x40U;  // the module flags a communication error
    };
    id = bus.submit({.id = {}, .orders = {toServo(0, kOther)}, .trial = GainTrial{kGood, 0, 2'000, 10s}});
    ASSERT_TRUE(bus.runUntil([&] { return refused; }, 1s));
    bus.submit({motorOff(0)});
    bus.runFor(1s);
    EXPECT_EQ(bus.sends("AA 01 E6 96 00", from), 1U) << "Kp is 150";
    EXPECT_TRUE(has(kGood));
    EXPECT_FALSE(bus.servo(0).servoOn);
}

TEST_F(Trials, GoOnAfterALostAnswer) {
    const std::size_t from = bus.sent.size();
    bool lost = false;
    bus.losesReply = [&](ByteSpan command) { return command.size() > 10 && !std::exchange(lost, true); };
    id = bus.submit({.id = {}, .orders = {toServo(0, kOther)}, .trial = GainTrial{kGood, 0, 2'000, 10s}});
    bus.runFor(1s);
    EXPECT_TRUE(lost);
    EXPECT_EQ(bus.sends("AA 01 E6 96 00", from), 2U) << "Kp is 150";
    EXPECT_TRUE(has(kOther));
    EXPECT_FALSE(finished());
}

TEST_F(Trials, WhateverElseIsAskedOfTheModuleEndsThemFirst) {
    beginTrial(kOther);
    ASSERT_EQ(bus.perform({loadMove(0, 500), start(0)}), Outcome::Done);
    EXPECT_TRUE(has(kGood));
    EXPECT_EQ(finished()->outcome, Outcome::Cancelled);
    bus.runFor(2s);
    beginTrial(kOther);
    bus.engine.hold(forward(0), bus.now);
    bus.runFor(200ms);
    EXPECT_TRUE(has(kGood));
    EXPECT_NE(bus.servo(0).commandVelocity, 0) << "it moves";
}

TEST_F(Trials, ThoseOfAnotherModuleGoOn) {
    beginTrial(kOther);
    ASSERT_EQ(bus.perform({loadMove(1, 500), start(1)}), Outcome::Done);
    bus.runFor(500ms);
    EXPECT_TRUE(has(kOther));
}

TEST_F(Trials, OtherGainsTakeTheirPlace) {
    beginTrial(kBad);
    ASSERT_EQ(bus.perform({toServo(0, kOther)}), Outcome::Done);
    EXPECT_EQ(finished()->outcome, Outcome::Cancelled);
    bus.runFor(15s);
    EXPECT_TRUE(has(kOther)) << "these are not taken back";
}

TEST_F(Trials, ASecondOneIsRefusedWhileOneRuns) {
    beginTrial(kOther);
    const OperationId second =
        bus.submit({.id = {}, .orders = {toServo(0, kBad)}, .trial = GainTrial{kGood, 0, 2'000, 1s}});
    EXPECT_EQ(bus.outcomeOf(second), Outcome::Forbidden);
    EXPECT_TRUE(has(kOther));
}

TEST_F(Trials, AreTakenBackWhenTheServoGoesOff) {
    beginTrial(kOther);
    bus.chain.set(ModuleIndex(0), sim::Input::Power, 0.0, bus.now);
    ASSERT_TRUE(comesBack(1s));
    EXPECT_EQ(finished()->trial, TrialEnd::WentOff);
}

TEST_F(Trials, ALostAnswerIsAskedForAgainUntilTheGainsAreBack) {
    beginTrial(kOther, 1s);
    int lost = 0;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 10 && lost < 6) {  // Set Gain
            ++lost;
            command.clear();
        }
    };
    ASSERT_TRUE(comesBack(10s));
    EXPECT_EQ(lost, 6);
}

TEST_F(Trials, AModuleThatWasOutOfReachGoesBackOnceItAnswers) {
    beginTrial(kOther, 2s);
    ASSERT_NO_FATAL_FAILURE(fault(sim::FaultKind::MuteRx, 5s));
    EXPECT_TRUE(comesBack(5s));
}

TEST_F(Trials, AnotherLookAtTheChainForgetsNothing) {
    beginTrial(kOther);
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(comesBack(1s));
    EXPECT_EQ(finished()->outcome, Outcome::Cancelled);
}

TEST_F(Trials, ARestartOfTheNetworkLeavesNothingToTakeBack) {
    beginTrial(kOther);
    ASSERT_TRUE(bus.restart());
    const std::size_t from = bus.sent.size();
    bus.runFor(12s);
    EXPECT_EQ(bus.sends("AA 01 E6", from), 0U);
    ASSERT_TRUE(finished());
    EXPECT_EQ(finished()->outcome, Outcome::Cancelled);
}

TEST_F(Trials, WhoeverStopsForADyingPanelTakesThemBackFirst) {
    const auto before = bus.engine.stopBurst();
    beginTrial(kOther);
    const auto during = bus.engine.stopBurst();
    EXPECT_EQ(during.size(), before.size() + 18 + 6)
        << "a Set Gain of version 4, and as many nulls as last a tick: 0.512 ms / 87 us";
    const std::string hex = toHex(during);
    EXPECT_LT(hex.find("AA 01 E6"), hex.find("AA 01 17 05"));
    bus.chain.hostSends(during, bus.now);
    bus.chain.advanceTo(bus.now + 20ms);
    EXPECT_TRUE(has(kGood));
}

}  // namespace
}  // namespace nmc::test

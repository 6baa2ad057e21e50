// SPDX-License-Identifier: GPL-3.0-or-later
// F-45: another host on the line. Modules answer on a line of their own, so the other host itself is never
// heard, but the effects of its commands are.
#include <gtest/gtest.h>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Two servos that hold and a stepper whose amplifier is on.
class OtherHost : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connectAndEnable());
        bus.runFor(500ms);
    }
    void sends(std::uint8_t module, const Payload& payload) {
        const BusAddress address(static_cast<std::uint8_t>(module + 1));
        ASSERT_TRUE(bus.chain.foreignSends(toPacket({address, payload}), bus.now));
        bus.runFor(20ms);
    }
    void sends(const Order& order) {
        const auto& chip = order.command;
        sends(order.module.value(),
              std::visit([](const auto& c) { return std::visit([](const auto& x) { return encode(x); }, c); },
                         chip));
    }
    [[nodiscard]] std::size_t motions(std::uint8_t module) const {
        std::size_t n = 0;
        for (const auto& motion : bus.all<ForeignMotion>())
            n += motion.module == ModuleIndex(module) ? 1U : 0U;
        return n;
    }
    FaultyBus bus{{{ModuleType::Servo, 4}, {ModuleType::Servo, 4}, {ModuleType::Stepper, 1}}, kFast};
};

// ---- what it moves ----

using F45_ForeignMotion = OtherHost;

TEST_F(F45_ForeignMotion, IsToldAndNotStopped) {
    sends(loadMove(1, 4'000));
    EXPECT_EQ(motions(1), 0U) << "nothing moves yet";
    sends(start(1));
    ASSERT_TRUE(bus.runUntil([&] { return motions(1) == 1; }, 500ms));
    EXPECT_EQ(motions(0) + motions(2), 0U);
    bus.runFor(3s);
    EXPECT_EQ(motions(1), 1U) << "it is reported once";
    EXPECT_LE(std::abs(bus.servo(1).position - 4'000), 3) << "it was left alone";
    EXPECT_EQ(bus.count<OwedStopConfirmed>(), 0U);
    // The next motion is another one.
    sends(loadMove(1, 0));
    sends(start(1));
    bus.runFor(500ms);
    EXPECT_EQ(motions(1), 2U);
}

TEST_F(F45_ForeignMotion, InVelocityModeAtSpeedIsToldToo) {
    sends(loadVelocity(1, 8 * 65'536, true));
    ASSERT_TRUE(bus.runUntil([&] { return motions(1) == 1; }, 3s));
}

TEST_F(F45_ForeignMotion, OfAServoThatWasOffIsTold) {
    ASSERT_EQ(bus.perform({motorOff(1)}), Outcome::Done);
    bus.runFor(500ms);
    sends(enable(1));
    sends(loadMove(1, 4'000));
    sends(start(1));
    bus.runFor(500ms);
    EXPECT_EQ(motions(1), 1U);
}

TEST_F(F45_ForeignMotion, OfAStepperIsTold) {
    sends(2, encode(stepper::SetParameters{}));
    stepper::LoadTrajectory load;
    load.speed = 20;
    load.accelerationTime = 20;
    load.startNow = true;
    sends(2, encode(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly}));
    sends(2, encode(load));
    bus.runFor(1s);
    EXPECT_EQ(motions(2), 1U);
}

TEST_F(F45_ForeignMotion, EndsByAStopOfAll) {
    while (bus.servo(1).commandVelocity == 0)  // a poll may have come between
        sends(loadVelocity(1, 2 * 65'536, true));
    // It may have reached its speed while the line was in doubt: 16 384 counts then take 4.2 s.
    ASSERT_TRUE(bus.runUntil([&] { return motions(1) == 1; }, 6s));
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 3U);
    EXPECT_TRUE(bus.stands(1));
}

/// Motions by hand, by a load or by our own commands are not foreign, nor is anything after ours have ended.
TEST_F(F45_ForeignMotion, IsNoneOfOurs) {
    EXPECT_EQ(bus.perform({loadMove(0, 3'000), start(0)}), Outcome::Done);
    bus.runFor(3s);
    EXPECT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(2s);
    ASSERT_TRUE(bus.stopAll());
    for (int i = 0; i < 10; ++i) {
        bus.engine.hold(forward(1), bus.now);
        bus.runFor(100ms);
    }
    bus.runFor(2s);
    bus.chain.set(ModuleIndex(0), sim::Input::Load, 0.02, bus.now);
    bus.runFor(1s);
    ASSERT_EQ(bus.perform({motorOff(0)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_NE(bus.servo(0).position, 3'000) << "the load turns it";
    EXPECT_EQ(bus.count<ForeignMotion>(), 0U);
    EXPECT_EQ(bus.count<ForeignTraffic>(), 0U);
}

TEST_F(F45_ForeignMotion, IsNotWhatAnAttachedChainWasDoing) {
    ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(500ms);
    EngineConfig config;
    config.baud = kFast;
    bus.newHost(config);
    bus.events.clear();
    ASSERT_TRUE(bus.connect());
    bus.runFor(2s);
    EXPECT_EQ(bus.count<ForeignMotion>(), 0U);
    // But a motor that holds, and is then set in motion, is reported.
    sends(loadMove(1, 4'000));
    sends(start(1));
    bus.runFor(500ms);
    EXPECT_EQ(motions(1), 1U);
}

// ---- what it queries ----

using F45_ForeignTraffic = OtherHost;

TEST_F(F45_ForeignTraffic, IsToldOnceAndEndsWhatWasUnderWayHere) {
    ASSERT_EQ(bus.perform({loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(300ms);
    bus.fault("bus foreign on=nop t=10ms..40ms for=8s");
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ForeignTraffic>() == 1; }, 5s));
    EXPECT_EQ(bus.last<ForeignTraffic>()->commandedToStop, std::vector{ModuleIndex(0)});
    ASSERT_TRUE(bus.runUntil([&] { return bus.stands(0); }, 2s));
    bus.runFor(7s);
    EXPECT_EQ(bus.count<ForeignTraffic>(), 1U);
}

TEST_F(F45_ForeignTraffic, EndsAHoldUntilTheButtonIsPressedAnew) {
    bus.fault("bus foreign on=nop t=10ms..40ms");
    const HoldToMove held = forward(0);
    const auto holdOn = [&](auto condition) {
        for (int i = 0; i < 60 && !condition(); ++i) {
            bus.engine.hold(held, bus.now);
            bus.runFor(100ms);
        }
        return condition();
    };
    ASSERT_TRUE(holdOn([&] { return bus.count<ForeignTraffic>() == 1; }));
    bus.clearFaults();
    (void)holdOn([] { return false; });
    EXPECT_TRUE(bus.stands(0));
}

TEST_F(F45_ForeignTraffic, CancelsAnOperation) {
    // So many steps that it cannot have ended: each waits for its answer on a disturbed line.
    bus.fault("bus foreign on=nop t=10ms..30ms");
    std::vector<Order> steps;
    for (int i = 0; i < 2'000; ++i)
        steps.push_back(gains(0));
    const OperationId id = bus.submit(std::move(steps));
    ASSERT_TRUE(bus.runUntil([&] { return bus.outcomeOf(id).has_value(); }, 20s));
    EXPECT_EQ(bus.outcomeOf(id), Outcome::Cancelled);
    EXPECT_GE(bus.count<ForeignTraffic>(), 1U);
}

TEST_F(F45_ForeignTraffic, LeavesMotorsAloneThatWereNotSetInMotionHere) {
    sends(loadVelocity(1, 65'536, true));
    bus.fault("bus foreign on=nop t=10ms..40ms for=4s");
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ForeignTraffic>() == 1; }, 5s));
    EXPECT_TRUE(bus.last<ForeignTraffic>()->commandedToStop.empty());
    EXPECT_FALSE(bus.stands(1));
}

// ---- what is not another host ----

class F45_NoForeignHost : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(
    Faults, F45_NoForeignHost,
    testing::Values("bus drop cmd p=.02", "bus drop status p=.02", "bus dup cmd p=.02",
                    "bus dup status p=.02", "bus flip cmd p=.02", "bus flip status p=.02",
                    "bus truncate cmd p=.02", "bus truncate status p=.02", "bus delay p=.05 t=17ms..81ms",
                    "bus silent p=.05", "module 2 silent", "bus cksum p=.05", "bus overrun p=.02",
                    "bus noise status t=2ms..10ms", "bus noise status t=80us..2ms", "bus echo",
                    "bus break status for=1s", "module 2 powercycle", "module 1,2 sameaddr",
                    "module 2 definestat", "module 1 garbage p=.2"));

TEST_P(F45_NoForeignHost, IsBlamedForIt) {
    for (const std::uint32_t baud : {19'200U, kFast}) {
        FaultyBus bus(servos(3), baud);
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
        bus.fault(GetParam());
        for (std::int32_t way = 1'000, i = 0; i < 20; way = -way, ++i) {
            bus.submit({loadMove(1, Truth::placeOf(1) + way), start(1)});
            bus.runFor(1s);
        }
        EXPECT_EQ(bus.count<ForeignTraffic>(), 0U);
        EXPECT_EQ(bus.count<ForeignMotion>(), 0U);
    }
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of an SC that the first data sheet does not have, through the engine and on the simulator: moves
// by a distance, limits that the chip itself observes, and a saved configuration. Distances by hand.
#include <gtest/gtest.h>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {
namespace {

using namespace bus;
using namespace std::chrono_literals;

class ScOnTheBus : public testing::Test {
protected:
    static constexpr std::uint8_t kSc = 1;

    ScOnTheBus() : bus({{ModuleType::Servo, 4}, {ModuleType::Servo, 10}}) {
        EXPECT_TRUE(bus.connect());
        EXPECT_EQ(bus.perform({gains(kSc)}), Outcome::Done);
    }
    [[nodiscard]] static Order moveBy(std::int32_t counts) {
        Order order = loadMove(kSc, counts);
        std::get<servo::LoadTrajectory>(std::get<ServoCommand>(order.command)).relative = true;
        return order;
    }
    [[nodiscard]] Outcome minds(servo::LimitStop how) {
        return bus.perform({toServo(kSc, servo::ScIoControl{.limitStop = how})}).value();
    }
    [[nodiscard]] sim::ModuleSnapshot truth() { return bus.chain.snapshot(ModuleIndex(kSc), bus.now); }
    void closeLimit1(bool closed) {
        bus.chain.set(ModuleIndex(kSc), sim::Input::Limit1, closed ? 1.0 : 0.0, bus.now);
    }

    VirtualBus bus;
};

TEST_F(ScOnTheBus, MovesByADistanceAddUpToTheCount) {
    ASSERT_EQ(bus.perform({enable(kSc)}), Outcome::Done);
    for (int move = 0; move < 3; ++move) {
        ASSERT_EQ(bus.perform({moveBy(1'000), start(kSc)}), Outcome::Done);
        bus.runFor(2s);
    }
    ASSERT_EQ(bus.perform({moveBy(-500), start(kSc)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_EQ(truth().servo.commandPosition, 2'500.0);
    EXPECT_EQ(bus.count<MotionSuspect>(), 0U) << "the goal was not taken for a position";
    bus.expectNoViolations();
}

TEST_F(ScOnTheBus, WhatALimitHasEndedIsAtRestAndMayMoveBack) {
    ASSERT_EQ(minds(servo::LimitStop::Abruptly), Outcome::Done);
    ASSERT_EQ(bus.perform({enable(kSc)}), Outcome::Done);
    ASSERT_EQ(bus.perform({loadVelocity(kSc, 65'536, true)}), Outcome::Done);
    bus.runFor(300ms);
    closeLimit1(true);
    bus.runFor(300ms);
    const std::int32_t rest = truth().servo.position;
    EXPECT_GT(rest, 100);
    EXPECT_EQ(bus.perform({loadMove(kSc, 0), start(kSc)}), Outcome::Done) << "no stop is needed first";
    bus.runFor(2s);
    EXPECT_NEAR(truth().servo.position, 0, 3);
    bus.expectNoViolations();
}

TEST_F(ScOnTheBus, ItsAmplifierIsNotChangedWhileTheServoIsOn) {
    ASSERT_EQ(bus.perform({enable(kSc)}), Outcome::Done);
    EXPECT_EQ(bus.perform({toServo(kSc, servo::ScIoControl{.antiphase = true})}), Outcome::Forbidden);
    EXPECT_FALSE(truth().servo.later->antiphase);
    ASSERT_EQ(bus.perform({motorOff(kSc)}), Outcome::Done);
    bus.runFor(500ms);
    EXPECT_EQ(bus.perform({toServo(kSc, servo::ScIoControl{.antiphase = true})}), Outcome::Done);
    EXPECT_TRUE(truth().servo.later->antiphase);
}

/// To a value, and to the position minus home, which neither command changes (family.md, PIC-SERVO CMC and
/// SC).
TEST_F(ScOnTheBus, SetsItsCounterWithoutADoubt) {
    ASSERT_EQ(bus.perform({enable(kSc)}), Outcome::Done);
    const auto setsTo = [&](const Order& order, std::int32_t counts) {
        EXPECT_EQ(bus.perform({order}), Outcome::Done);
        bus.runFor(1s);
        EXPECT_NEAR(bus.lastSample(kSc).value().report.position.value(), counts, 3);
    };
    setsTo(toServo(kSc, servo::SetPosition{Counts(100'000)}), 100'000);
    setsTo(toServo(kSc, SaveAsHome{}), 100'000);
    setsTo(toServo(kSc, servo::SetPosition{Counts(-50'000)}), -50'000);
    setsTo(toServo(kSc, servo::ResetRelativeToHome{}), -150'000);
    EXPECT_EQ(bus.engine.statistics().rejected, 0U);
    for (const Sample& sample : bus.all<Sample>())
        EXPECT_FALSE(sample.jumped);
    bus.expectNoViolations();
}

/// Above 4.5 V, POWER_ON is 0 and the servo stays on (family.md, PIC-SERVO CMC and SC).
TEST_F(ScOnTheBus, AnswersWhileItsSupplyIsTooHigh) {
    ASSERT_EQ(bus.perform({enable(kSc)}), Outcome::Done);
    bus.chain.set(ModuleIndex(kSc), sim::Input::VoltSense, 4.8, bus.now);
    bus.runFor(3s);
    ASSERT_TRUE(truth().servo.servoOn);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
    EXPECT_EQ(bus.engine.statistics().rejected, 0U);
    const StatusReport shown = bus.lastSample(kSc).value().report;
    EXPECT_FALSE(shown.servoStatus().powerOn());
    EXPECT_TRUE(servo::AuxByte{shown.aux.value()}.servoOn());
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_TRUE(stopped->unreached.empty());
}

TEST_F(ScOnTheBus, AConfigurationIsSavedAndTheOthersKeepWhatTheyHave) {
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadMove(0, 1'000), start(0)}), Outcome::Done);
    bus.runFor(2s);
    bus.engine.resetModule(ModuleIndex(kSc), bus.now,
                           servo::HardReset{.save = true, .restoreAddresses = true, .limitProtection = true});
    const auto over = [&] { return bus.count<Readdressed>() + bus.count<ReaddressFailed>() > 0; };
    ASSERT_TRUE(bus.runUntil(over, 5s));
    EXPECT_EQ(bus.count<Readdressed>(), 1U);
    EXPECT_EQ(truth().servo.later->saved, 0b0010'0011) << "save, addresses, limit protection";
    bus.runFor(1s);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 3);
    EXPECT_TRUE(bus.servo(0).servoOn);
    bus.expectNoViolations();
}

TEST_F(ScOnTheBus, AConfigurationIsNotForAChipThatKnowsNone) {
    bus.engine.resetModule(ModuleIndex(0), bus.now, servo::HardReset{.save = true});
    bus.runFor(1s);
    ASSERT_EQ(bus.count<ReaddressFailed>(), 1U);
    EXPECT_EQ(bus.count<ModuleRestarted>(), 0U) << "not even reset";
}

}  // namespace
}  // namespace nmc::test

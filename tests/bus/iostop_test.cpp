// SPDX-License-Identifier: GPL-3.0-or-later
// STOP ALL and a PIC-I/O beside two servos, on the simulator: its outputs stay as they are, except those that
// the machine marks to go low.
#include <gtest/gtest.h>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {
namespace {

using namespace bus;
using namespace std::chrono_literals;

class StopsAnIoModule : public testing::Test {
protected:
    static constexpr std::uint8_t kIo = 1;

    StopsAnIoModule() : bus({{ModuleType::Servo, 4}, {ModuleType::Io, 1}, {ModuleType::Servo, 10}}) {
        EXPECT_TRUE(bus.connect());
    }
    [[nodiscard]] static Order told(const IoCommand& command) { return {ModuleIndex(kIo), command}; }
    /// Switches on IO1 to IO4 and both PWM outputs.
    void switchOn() {
        ASSERT_EQ(bus.perform({told(io::SetDirection{0x0FF0}), told(io::SetOutput{0x000F}),
                               told(io::SetPwm{100, 200})}),
                  Outcome::Done);
    }
    [[nodiscard]] sim::IoSnapshot truth() { return *bus.chain.snapshot(ModuleIndex(kIo), bus.now).io; }

    VirtualBus bus;
};

TEST_F(StopsAnIoModule, ItIsFoundAndPolledLikeTheOthers) {
    bus.runFor(1s);
    EXPECT_EQ(bus.chain.violations().count(), 0U);
    const auto reported = [&](std::uint8_t module, auto item) {
        const auto samples = bus.all<Sample>();
        return std::any_of(samples.begin(), samples.end(), [&](const Sample& sample) {
            return sample.module == ModuleIndex(module) && (sample.report.*item).has_value();
        });
    };
    EXPECT_TRUE(reported(kIo, &StatusReport::pins));
    EXPECT_TRUE(reported(kIo, &StatusReport::counter));
    EXPECT_TRUE(reported(2, &StatusReport::positionError)) << "an SC reports its error";
    EXPECT_FALSE(reported(0, &StatusReport::positionError));
}

TEST_F(StopsAnIoModule, WithoutAWordOfTheMachineNothingOfItChanges) {
    switchOn();
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->stopped.size(), 3U);
    EXPECT_EQ(truth().outputs, 0x000F);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{100, 200}));
}

TEST_F(StopsAnIoModule, WhatIsMarkedGoesLowAndTheRestStays) {
    bus.engine.setStopOutputs({{}, {0x0005, 0x02}, {}});
    switchOn();
    const auto stopped = bus.stopAll();
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->stopped.size(), 3U);
    EXPECT_EQ(truth().outputs, 0x000A);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{100, 0}));
}

/// It is marked while a No Operation is on its way, which the module refuses because its sum was damaged.
TEST_F(StopsAnIoModule, WhatIsMarkedWhileACommandIsRefusedGoesLow) {
    switchOn();
    bool marked = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() != 4 || command[1] != kIo + 1 || std::exchange(marked, true))
            return;
        command.back() = static_cast<std::uint8_t>(command.back() + 1);
        bus.engine.setStopOutputs({{}, {0x0005, 0x02}, {}});
    };
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<CommandRefused>() == 1; }, 2s));
    ASSERT_TRUE(bus.stopAll());
    EXPECT_EQ(truth().outputs, 0x000A);
    EXPECT_EQ(truth().pwm, (std::array<std::uint8_t, 2>{100, 0}));
}

/// The bytes for a process that is about to die contain all of it.
TEST_F(StopsAnIoModule, TheBurstHasThePinsAndThePwm) {
    bus.engine.setStopOutputs({{}, {0x0005, 0x02}, {}});
    EXPECT_TRUE(bus.engine.stopBurst().empty());
    switchOn();
    const std::vector<std::uint8_t> burst = bus.engine.stopBurst();
    const std::string hex = toHex(burst);
    EXPECT_NE(hex.find("AA 02 26 0A 00 32"), std::string::npos) << hex;
    EXPECT_NE(hex.find("AA 02 24 64 00 8A"), std::string::npos) << hex;
}

/// The process that keeps the burst ready is informed of each change, including that of the second command.
TEST_F(StopsAnIoModule, TheBurstIsNewWhenOnlyThePwmChanges) {
    bus.engine.setStopOutputs({{}, {0x0005, 0x02}, {}});
    ASSERT_EQ(bus.perform({told(io::SetDirection{0x0FF0}), told(io::SetOutput{0x000F})}), Outcome::Done);
    const auto before = bus.engine.stopBurst();
    ASSERT_FALSE(before.empty());
    ASSERT_EQ(bus.perform({told(io::SetPwm{100, 200})}), Outcome::Done);
    const auto burst = bus.engine.stopBurst();
    ASSERT_NE(burst, before);
    EXPECT_NE(toHex(burst).find("AA 02 24 64 00 8A"), std::string::npos) << toHex(burst);
}

}  // namespace
}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// The stop that a dying process writes: it is known before it is needed, and changes only when it has to.
#include <gtest/gtest.h>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Nulls, stop abruptly with the amplifier on (DS-V 5.2), and more than a tick of nulls at 19 200 Bd.
const std::string kStopsTheFirst = "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 AA 01 17 05 1D 00";

TEST(StopBurst, IsMadeAnewOnlyForMotorsThatHaveToBeStopped) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    bus.runFor(1s);
    const auto idle = bus.engine.stopBurst();
    for (int i = 0; i < 100; ++i) {
        bus.runFor(10ms);
        EXPECT_EQ(bus.engine.stopBurst(), idle) << "polls change nothing";
    }
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    EXPECT_EQ(toHex(bus.engine.stopBurst()), kStopsTheFirst);
    for (int i = 0; i < 100; ++i) {
        bus.runFor(10ms);
        EXPECT_EQ(toHex(bus.engine.stopBurst()), kStopsTheFirst) << "polls change nothing";
    }
    ASSERT_EQ(bus.perform({motorOff(0)}), Outcome::Done);
    bus.runFor(500ms);
    EXPECT_TRUE(bus.engine.stopBurst().empty());
}

TEST(StopBurst, IsKnownBeforeTheCommandThatNeedsItLeaves) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0)}), Outcome::Done);
    std::vector<std::uint8_t> atLeaving;
    bus.onCommand = [&](const std::vector<std::uint8_t>& command) {
        if (command.size() > 2 && command[0] == 0xAA && command[2] == 0x17)
            atLeaving = bus.engine.stopBurst();
    };
    const auto before = bus.engine.stopBurst();
    ASSERT_EQ(bus.perform({enable(0)}), Outcome::Done);
    EXPECT_NE(atLeaving, before);
    EXPECT_EQ(toHex(atLeaving), kStopsTheFirst);
}

/// The motor has been switched off, but that is not known: a stop that keeps the servo on would switch it on
/// again.
TEST(StopBurst, SwitchesOffWhatWasToBeSwitchedOff) {
    VirtualBus bus(servos(1));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    bus.losesReply = [](ByteSpan) { return true; };
    EXPECT_EQ(bus.perform({motorOff(0)}), Outcome::NoAnswer);
    EXPECT_FALSE(bus.servo(0).servoOn);
    const std::string burst = toHex(bus.engine.stopBurst());
    EXPECT_NE(burst.find("AA 01 17 02 1A"), std::string::npos) << burst;
    EXPECT_EQ(burst.find("AA 01 17 05"), std::string::npos) << burst;
}

TEST(StopBurst, IsForTheRateOfTheChainWhileTheLineIsElsewhere) {
    EngineConfig config;
    config.baud = 115'200;
    VirtualBus bus(servos(2), config);
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0)}), Outcome::Done);
    // At this rate, a servo tick is 5.9 bytes long.
    const std::string stop = kStopsTheFirst + " 00 00 00 00 00";
    EXPECT_EQ(toHex(bus.engine.stopBurst()), stop);
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.hostBaud == 19'200; }, 10s))
        << "it searches for the module that restarted";
    EXPECT_EQ(bus.engine.stopBurstBaud(), 115'200U);
    EXPECT_EQ(toHex(bus.engine.stopBurst()), stop);
}

}  // namespace

}  // namespace nmc::test

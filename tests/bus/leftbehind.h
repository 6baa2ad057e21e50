// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

/// The first program assigns addresses, runs the first motor in velocity mode at one count per tick, and
/// disappears. Another one takes its place, with `next` as its configuration.
class LeftBehind {
public:
    LeftBehind(std::size_t modules, std::uint32_t baud, const bus::EngineConfig& next = {})
        : bus(servos(modules), bus::EngineConfig{baud}, withFaults()) {
        EXPECT_TRUE(bus.connect());
        EXPECT_FALSE(bus.last<bus::ChainFound>()->attached);
        EXPECT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, kOnePerTick, true)}), bus::Outcome::Done);
        bus.runFor(std::chrono::milliseconds(500));
        bus.newHost(next);
        bus.events.clear();
        bus.sent.clear();
    }
    [[nodiscard]] double commandVelocity() { return bus.servo(0).commandVelocity; }

    VirtualBus bus;
};

}  // namespace nmc::test

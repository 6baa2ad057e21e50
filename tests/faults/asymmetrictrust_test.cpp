// SPDX-License-Identifier: GPL-3.0-or-later
// link.md 2.4: a stop needs two consistent samples; tests/bus/trust_test.cpp has what else one or two of them
// permit.
#include <gtest/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr std::uint8_t kStands = 0x19;  // move_done, power_on, pos_error
constexpr std::uint8_t kMoves = 0x08;   // power_on

/// Stops a servo that is on. Each query of its status, by the stop or a poll, is answered with what `says`
/// returns next.
[[nodiscard]] std::optional<StopFinished> stopOf(const std::function<std::uint8_t(unsigned question)>& says) {
    ScriptedBus bus(1);
    if (!bus.connect())
        return std::nullopt;
    bus.aux = kServoOn;
    bus.runFor(500ms);
    unsigned asked = 0;
    bus.answer = [&](ByteSpan packet) {
        const auto frame = parsePacket(packet);
        if (frame && frame->payload.code != CommandCode::StopMotor)
            bus.status = says(asked++);
        return bus.likeAServo(packet);
    };
    bus.engine.stopAll(bus.now);
    if (!bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 10s))
        return std::nullopt;
    return bus.all<StopFinished>().back();
}

TEST(AsymmetricTrust, OneLookDoesNotMakeAStop) {
    const auto stop = stopOf([](unsigned question) { return question % 2 == 0 ? kStands : kMoves; });
    ASSERT_TRUE(stop);
    EXPECT_TRUE(stop->stopped.empty()) << "it is never seen at rest twice in a row";
    EXPECT_EQ(stop->unconfirmed.size(), 1U) << "it answers, so it was reached";
}

TEST(AsymmetricTrust, TwoLooksMakeAStop) {
    const auto stop = stopOf([](unsigned question) { return question < 5 ? kMoves : kStands; });
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 1U);
    EXPECT_TRUE(stop->unreached.empty());
}

}  // namespace

}  // namespace nmc::test

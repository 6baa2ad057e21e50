// SPDX-License-Identifier: GPL-3.0-or-later
// link.md 2.4: one plausible sample is enough to stop or to warn, two consistent ones are needed to permit.
#include <gtest/gtest.h>

#include "bus/trust.h"
#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr std::uint8_t kStands = 0x19;  // move_done, power_on, pos_error
constexpr std::uint8_t kMoves = 0x08;   // power_on
constexpr StatusItems kShort{StatusItems::Position};
constexpr StatusItems kLong{StatusItems::Position | StatusItems::Identity};

[[nodiscard]] StatusReport report(StatusItems items, std::uint8_t status) {
    StatusReport report;
    report.items = items;
    report.status = status;
    return report;
}

/// A PIC-SERVO that has been moving for as long as it is known.
[[nodiscard]] Trust trustInAMotion() {
    Trust trust({ModuleType::Servo, 4});
    EXPECT_FALSE(trust.confirm(report(kShort, kMoves))) << "it is the first report";
    EXPECT_EQ(trust.confirm(report(kLong, kMoves))->status, kMoves);
    return trust;
}

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

TEST(AsymmetricTrust, TwoRepliesOfOneLengthDoNotPermit) {
    Trust trust = trustInAMotion();
    EXPECT_EQ(trust.confirm(report(kShort, kStands))->status, 0x18) << "move_done is withheld";
    EXPECT_EQ(trust.confirm(report(kShort, kStands))->status, 0x18) << "it may be the same reply again";
    EXPECT_EQ(trust.confirm(report(kLong, kStands))->status, kStands);
}

TEST(AsymmetricTrust, OneReplyWithdraws) {
    Trust trust = trustInAMotion();
    EXPECT_EQ(trust.confirm(report(kShort, kStands))->status, 0x18);
    EXPECT_EQ(trust.confirm(report(kLong, kStands))->status, kStands);
    EXPECT_EQ(trust.confirm(report(kShort, kMoves))->status, kMoves);
    EXPECT_EQ(trust.confirm(report(kLong, kStands))->status, 0x18) << "it has to be shown again";
}

}  // namespace

}  // namespace nmc::test

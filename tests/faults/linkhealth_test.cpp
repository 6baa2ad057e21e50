// SPDX-License-Identifier: GPL-3.0-or-later
// link.md 2.5: each wrong answer puts 10 into the bucket, each right one takes 1 out of it; from 100 on, the
// link is lost.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Two servos that are on; every fourth answer of the second one has a wrong checksum.
class LinkHealthOfOneModule : public testing::Test {
protected:
    void SetUp() override {
        bus.aux = kServoOn;
        ASSERT_TRUE(bus.connect());
        bus.runFor(200ms);
        bus.answer = [this](ByteSpan packet) {
            auto bytes = bus.likeAServo(packet);
            if (packet[1] == 2 && !bytes.empty() && ++answers % 4 == 0) {
                ++bytes.back();
                ++wrong;
            }
            return bytes;
        };
    }
    /// The levels of the second module, in order.
    [[nodiscard]] std::vector<LinkHealth> levels() const {
        std::vector<LinkHealth> all;
        for (const HealthChanged& event : bus.all<HealthChanged>())
            if (event.module == ModuleIndex(1))
                all.push_back(event.health);
        return all;
    }
    [[nodiscard]] bool reaches(LinkHealth level) {
        return bus.runUntil([&] { return !levels().empty() && levels().back() == level; });
    }

    ScriptedBus bus{2};
    unsigned answers = 0;
    unsigned wrong = 0;
};

// Each round of four answers puts 10 in and takes 3 out: 10, 17, 24, 31; and 94, 101 at the 13th and 14th.
TEST_F(LinkHealthOfOneModule, IsDoubtfulFromThirtyAndLostFromAHundred) {
    ASSERT_TRUE(reaches(LinkHealth::Marginal));
    EXPECT_EQ(wrong, 4U);
    ASSERT_TRUE(reaches(LinkHealth::Lost));
    EXPECT_EQ(wrong, 14U);
}

TEST_F(LinkHealthOfOneModule, StopsItOnceLostAndThenOnlyAsksWhetherItIsWellAgain) {
    const std::string whoIsThere = "AA 02 13 20 35";

    ASSERT_TRUE(reaches(LinkHealth::Lost));
    const std::size_t from = bus.sent.size();
    bus.runFor(5s);
    EXPECT_GE(bus.sends("AA 02 17 05 1E", from), 1U);
    std::size_t toIt = 0;
    std::size_t toTheOther = 0;
    for (std::size_t i = from; i < bus.sent.size(); ++i) {
        toIt += bus.sent[i].hex.starts_with("AA 02") && bus.sent[i].hex != whoIsThere ? 1U : 0U;
        toTheOther += bus.sent[i].hex.starts_with("AA 01") ? 1U : 0U;
    }
    // It is looked at twice, and only then reported as stopped.
    EXPECT_EQ(bus.count<OwedStopConfirmed>(), 1U);
    EXPECT_LE(toIt, bus.sends("AA 02 17 05 1E", from) + 4) << "only its stop and the looks at it are sent";
    const std::size_t later = bus.sent.size();
    bus.runFor(5s);
    for (std::size_t i = later; i < bus.sent.size(); ++i)
        EXPECT_TRUE(!bus.sent[i].hex.starts_with("AA 02") || bus.sent[i].hex == whoIsThere)
            << bus.sent[i].hex;
    EXPECT_GT(toTheOther, 100U);
}

// Its answers to a stop of all take out more than the 1 by which it was above the hundred.
TEST_F(LinkHealthOfOneModule, StaysLost) {
    ASSERT_TRUE(reaches(LinkHealth::Lost));
    bus.runFor(1s);
    bus.engine.stopAll(bus.now);
    bus.runFor(5s);
    ASSERT_EQ(bus.count<StopFinished>(), 1U);
    EXPECT_EQ(levels(), (std::vector{LinkHealth::Marginal, LinkHealth::Lost}));
}

// The 55th answer is that to a poll; the 56th is the 14th wrong one.
TEST_F(LinkHealthOfOneModule, IsLostByTheAnswerToItsMotorOffWhichIsStillOwed) {
    ASSERT_TRUE(bus.runUntil([&] { return answers == 55; }));
    const std::size_t from = bus.sent.size();
    bus.engine.submit({OperationId(1), {motorOff(1)}}, bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<OwedStopConfirmed>() == 1; }));
    EXPECT_EQ(levels(), (std::vector{LinkHealth::Marginal, LinkHealth::Lost}));
    EXPECT_EQ(bus.all<OperationFinished>().at(0).outcome, Outcome::Cancelled);
    EXPECT_EQ(bus.all<OwedStopConfirmed>().at(0).cause, StopCause::LinkGivenUp);
    EXPECT_GE(bus.sends("AA 02 17 02 1B", from), 1U);
    EXPECT_EQ(bus.sends("AA 02 17 05 1E", from), 0U) << "it would be switched on again";
}

/// It was given up because of errors, so it has not restarted, and is owed its stop.
TEST(LinkHealthBesideARestartedModule, IsNotTakenForThatOne) {
    ScriptedBus bus(4);
    bus.aux = kServoOn;
    ASSERT_TRUE(bus.connect());
    bus.runFor(200ms);
    bool restarted = false;
    unsigned answers = 0;
    bus.answer = [&](ByteSpan packet) {
        if (restarted && packet[1] == 4)
            return std::vector<std::uint8_t>{};
        if (restarted && packet[1] == 0)  // Read Status of the module that has restarted
            return bus.reply(StatusItems(packet[3]));
        auto bytes = bus.likeAServo(packet);
        if (packet[1] == 2 && !bytes.empty() && ++answers % 4 == 0)
            ++bytes.back();
        return bytes;
    };
    ASSERT_TRUE(bus.runUntil([&] {
        const auto all = bus.all<HealthChanged>();
        return std::ranges::any_of(all, [](const HealthChanged& event) {
            return event.module == ModuleIndex(1) && event.health == LinkHealth::Lost;
        });
    }));
    bus.runFor(200ms);
    restarted = true;
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }));
    EXPECT_EQ(bus.all<ModuleRestarted>().at(0).module, ModuleIndex(3));
}

/// What is sent to its address reaches nobody, and may be noise to it.
TEST(LinkHealthBesideARestartedModule, DoesNotBringThatOneBack) {
    ScriptedBus bus(3);
    bus.aux = kServoOn;
    ASSERT_TRUE(bus.connect());
    bus.runFor(200ms);
    bool garbles = false;
    unsigned answers = 0;
    bus.answer = [&](ByteSpan packet) {
        if (packet[1] == 3)
            return std::vector<std::uint8_t>{};
        if (packet[1] == 0)  // Read Status of the module that has restarted
            return bus.reply(StatusItems(packet[3]));
        auto bytes = bus.likeAServo(packet);
        if (garbles && packet[1] == 2 && !bytes.empty() && ++answers % 4 == 0)
            ++bytes.back();
        return bytes;
    };
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }));
    const auto reaches = [&](LinkHealth level) {
        return bus.runUntil([&] {
            const auto all = bus.all<HealthChanged>();
            return std::ranges::any_of(all, [&](const HealthChanged& event) {
                return event.module == ModuleIndex(1) && event.health == level;
            });
        });
    };
    garbles = true;
    ASSERT_TRUE(reaches(LinkHealth::Lost));
    garbles = false;
    ASSERT_TRUE(reaches(LinkHealth::Good));
    const std::size_t from = bus.sent.size();
    bus.runFor(5s);
    for (std::size_t i = from; i < bus.sent.size(); ++i)
        EXPECT_FALSE(bus.sent[i].hex.starts_with("AA 03")) << bus.sent[i].hex;
}

}  // namespace

}  // namespace nmc::test

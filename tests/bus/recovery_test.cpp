// SPDX-License-Identifier: GPL-3.0-or-later
// The reaction to doubtful answers: nulls, a challenge of two queries, and finally giving up the link.
#include <gtest/gtest.h>

#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

/// How an answer can be wrong.
struct Doubt {
    const char* name;
    Bytes (*damage)(Bytes whole);

    friend void PrintTo(const Doubt& doubt, std::ostream* stream) { *stream << doubt.name; }
};

constexpr std::array kDoubts{
    Doubt{"Unresponsive", [](Bytes) { return Bytes{}; }},
    Doubt{"Partial",
          [](Bytes whole) {
              whole.pop_back();
              return whole;
          }},
    Doubt{"BadChecksum",
          [](Bytes whole) {
              whole.back() = static_cast<std::uint8_t>(whole.back() + 1);
              return whole;
          }},
    Doubt{"Surplus",
          [](Bytes whole) {
              whole.push_back(0x55);
              return whole;
          }},
    Doubt{"AllZero", [](Bytes whole) { return Bytes(whole.size(), 0); }},
    Doubt{"Contradicting",  // position 01 01 01 01, with a correct sum
          [](Bytes whole) {
              whole.pop_back();
              for (std::size_t i = 1; i <= 4; ++i)
                  whole[i] = 1;
              return withSum(whole);
          }},
};

class AfterADoubtfulAnswer : public testing::TestWithParam<Doubt> {};

/// The answer to a full poll of the first module is wrong; the next queries request its identity, and then
/// everything.
TEST_P(AfterADoubtfulAnswer, AsksTwoQuestionsOfDifferentLength) {
    ScriptedBus bus(2);
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    int spoilt = 0;
    bus.answer = [&](ByteSpan packet) {
        Bytes whole = bus.likeAServo(packet);
        if (toHex(packet) == "AA 01 13 3F 53" && spoilt++ == 0)
            return GetParam().damage(whole);
        return whole;
    };
    ASSERT_TRUE(bus.runUntil([&] { return spoilt > 0; }));
    std::size_t at = bus.sent.size();
    const std::size_t samples = bus.count<Sample>();
    const TimePoint began = bus.now;
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 01 13 3F 53", at) > 0; }, 2s));
    bus.runFor(20ms);
    // A poll of the other module may have left before the surplus bytes came.
    if (bus.sent[at].hex.rfind("AA 02", 0) == 0)
        ++at;
    ASSERT_GE(bus.sent.size(), at + 3);
    EXPECT_EQ(bus.sent[at].hex, ScriptedBus::kNulls);
    EXPECT_GE(bus.sent[at].time - began, 100ms) << "the quarantine";
    EXPECT_EQ(bus.sent[at + 1].hex, "AA 01 13 20 34") << "four bytes";
    EXPECT_GE(bus.sent[at + 1].time - bus.sent[at].time, 16 * byteTimeAtBaud(19'200) + 1ms);
    EXPECT_EQ(bus.sent[at + 2].hex, "AA 01 13 3F 53") << "sixteen";
    bus.runFor(1s);
    EXPECT_GT(bus.count<Sample>(), samples + 20);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
    EXPECT_EQ(bus.engine.statistics().resyncs, 1U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, AfterADoubtfulAnswer, testing::ValuesIn(kDoubts),
                         [](const auto& doubt) { return std::string(doubt.param.name); });

TEST(Recovery, BelievesAMoveThatTheChallengeConfirms) {
    ScriptedBus bus(2);
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    bool moved = false;
    bus.answer = [&](ByteSpan packet) {
        Bytes whole = bus.likeAServo(packet);
        if (!moved || packet[1] != 1 || whole.size() < 10)
            return whole;
        whole.pop_back();
        whole[2] = 0x40;  // 16 384
        return withSum(whole);
    };
    moved = true;
    bus.runFor(2s);
    EXPECT_EQ(bus.count<ModuleUnresponsive>(), 0U);
    std::optional<std::int32_t> last;
    for (const Sample& sample : bus.all<Sample>())
        if (sample.module == ModuleIndex(0))
            last = sample.report.position;
    EXPECT_EQ(last, 0x4000);
    EXPECT_EQ(bus.engine.statistics().rejected, 1U);
}

/// Every fifth answer, of module 2 or of both, is wrong: for five answers, the bucket gains 10 and loses 4.
class BadLine {
public:
    BadLine() : bus(2) {
        EXPECT_TRUE(bus.connect());
        bus.aux = 0x04;
        bus.status = 0x08;
        bus.runFor(500ms);
        bus.answer = [this](ByteSpan packet) {
            Bytes whole = bus.likeAServo(packet);
            const bool spoils = isBad && (everywhere || packet[1] == 2) && ++m_asked % 5 == 0;
            if (spoils)
                whole.back() = static_cast<std::uint8_t>(whole.back() + 1);
            return whole;
        };
    }
    [[nodiscard]] std::vector<LinkHealth> healths(bool ofModule) const {
        std::vector<LinkHealth> all;
        for (const auto& event : bus.all<HealthChanged>())
            if (event.module.has_value() == ofModule)
                all.push_back(event.health);
        return all;
    }

    ScriptedBus bus;
    bool isBad = false;
    bool everywhere = false;  ///< otherwise only at module 2

private:
    unsigned m_asked = 0;
};

TEST(Recovery, TellsOfADoubtfulLinkOnceAndOfItsEndOnce) {
    BadLine line;
    line.isBad = true;
    ASSERT_TRUE(line.bus.runUntil([&] { return line.bus.count<HealthChanged>() > 0; }, 60s));
    EXPECT_EQ(line.bus.all<HealthChanged>().front().health, LinkHealth::Marginal);
    EXPECT_GE(line.bus.all<HealthChanged>().front().wrong, 3U);
    line.isBad = false;
    line.bus.runFor(10s);
    for (const bool ofModule : {false, true}) {
        const auto healths = line.healths(ofModule);
        if (!healths.empty()) {
            EXPECT_EQ(healths, (std::vector{LinkHealth::Marginal, LinkHealth::Good})) << ofModule;
        }
    }
    EXPECT_FALSE(line.healths(true).empty());
}

TEST(Recovery, StopsEverythingAndOnlyAsksWhoIsThereOnceTheLinkIsLost) {
    BadLine line;
    line.isBad = line.everywhere = true;
    const auto lost = [&] {
        const auto healths = line.bus.all<HealthChanged>();
        return !healths.empty() && healths.back().health == LinkHealth::Lost && !healths.back().module;
    };
    ASSERT_TRUE(line.bus.runUntil(lost, 120s));
    const std::size_t at = line.bus.sent.size();
    ASSERT_TRUE(line.bus.runUntil([&] { return line.bus.count<StopFinished>() > 0; }, 10s));
    EXPECT_GE(line.bus.sends("AA 01 17 05 1D", at), 1U) << "abruptly, with the amplifier on";
    EXPECT_GE(line.bus.sends("AA 02 17 05 1E", at), 1U);
    // The stops are owed until the motors are seen at rest.
    EXPECT_EQ(line.bus.count<OwedStopConfirmed>(), 0U);
    line.isBad = false;
    line.bus.status = 0x09;  // move_done
    ASSERT_TRUE(line.bus.runUntil([&] { return line.bus.count<OwedStopConfirmed>() == 2; }, 2s));
    line.isBad = true;
    const std::size_t after = line.bus.sent.size();
    const std::size_t events = line.bus.events.size();
    line.bus.runFor(60s);
    for (std::size_t i = after; i < line.bus.sent.size(); ++i) {
        const std::string& hex = line.bus.sent[i].hex;
        EXPECT_TRUE(hex.starts_with("00") || hex.starts_with("AA 01 13 20") || hex.starts_with("AA 02 13 20"))
            << hex << ": only queries for the identity";
    }
    EXPECT_LT(line.bus.sent.size() - after, 60U * 10 * 2)
        << "ten times a second, with nulls after a doubtful answer";
    EXPECT_EQ(line.bus.events.size(), events);
    EXPECT_EQ(line.bus.count<StopFinished>(), 1U);
    // Commands are not accepted any more, but a stop is.
    line.bus.engine.submit({OperationId(7), {gains(0)}}, line.bus.now);
    line.bus.runFor(1s);
    ASSERT_EQ(line.bus.count<OperationFinished>(), 1U);
    EXPECT_EQ(line.bus.all<OperationFinished>()[0].outcome, Outcome::Cancelled);
    EXPECT_EQ(line.bus.sends("AA 01 D6", after), 0U);
    line.bus.engine.stopAll(line.bus.now);
    EXPECT_TRUE(line.bus.runUntil([&] { return line.bus.count<StopFinished>() == 2; }, 10s));
    EXPECT_GT(line.bus.sent.size(), after);
}

TEST(Recovery, GivesUpOneModuleAndGoesOnWithTheOthers) {
    BadLine line;
    line.isBad = true;
    ASSERT_TRUE(line.bus.runUntil([&] { return line.bus.count<ModuleUnresponsive>() > 0; }, 120s));
    EXPECT_EQ(line.healths(true).back(), LinkHealth::Lost);
    EXPECT_EQ(line.bus.all<ModuleUnresponsive>()[0].module, ModuleIndex(1));
    line.bus.runFor(200ms);
    EXPECT_GE(line.bus.sends("AA 02 17 05 1E"), 1U) << "its servo was on, so it is stopped";
    const std::size_t from = line.bus.sent.size();
    line.bus.runFor(10s);
    EXPECT_GT(line.bus.sends("AA 01 0E 0F", from), 300U);
    EXPECT_EQ(line.bus.sends("AA 02 0E 10", from), 0U);
    EXPECT_EQ(line.bus.sends("AA 02 13 3F 54", from), 0U)
        << "it is not polled as long as its answers are wrong";
}

TEST(Recovery, ComesBackWithAnotherConnection) {
    VirtualBus bus(servos(2));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
    unsigned bytes = 0;
    bus.onHostByte = [&](std::uint8_t& byte) {
        if (++bytes % 40 == 0)
            byte = static_cast<std::uint8_t>(byte + 1);
        return 1U;
    };
    const auto lost = [&] {
        const auto health = bus.last<HealthChanged>();
        return health && health->health == LinkHealth::Lost;
    };
    ASSERT_TRUE(bus.runUntil(lost, 60s));
    bus.runFor(5s);
    EXPECT_DOUBLE_EQ(bus.servo(0).commandVelocity, 0);
    EXPECT_TRUE(bus.servo(0).servoOn) << "it still holds";
    bus.onHostByte = {};
    ASSERT_TRUE(bus.connect());
    EXPECT_TRUE(bus.last<ChainFound>()->attached);
    const std::size_t samples = bus.count<Sample>();
    const std::size_t healths = bus.count<HealthChanged>();
    bus.runFor(5s);
    EXPECT_GT(bus.count<Sample>(), samples + 100);
    EXPECT_EQ(bus.count<HealthChanged>(), healths) << "the health starts from good again";
    EXPECT_EQ(bus.servo(0).gains.kp, 200) << "nothing was reset";
}

// ---- modules and lines that were given up ----

/// A line that was too bad is good again: the chain is found again automatically, and is at rest.
TEST(WellAgain, TakesTheChainUpOnceTheLineIsWell) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.perform({gains(0), enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.onHostByte = [n = 0](std::uint8_t& byte) mutable {
        byte = static_cast<std::uint8_t>(byte ^ (++n % 3 == 0 ? 0x10U : 0U));
        return 1U;
    };
    const auto givenUp = [&] {
        const auto health = bus.last<HealthChanged>();
        return health && health->health == LinkHealth::Lost && !health->module;
    };
    ASSERT_TRUE(bus.runUntil(givenUp, 60s));
    bus.runFor(10s);
    EXPECT_EQ(bus.count<ChainFound>(), 1U) << "not while the line is bad";
    const std::size_t sent = bus.sent.size();
    bus.onHostByte = {};
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ChainFound>() == 2; }, 6s));
    EXPECT_TRUE(bus.last<ChainFound>()->attached);
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    const std::size_t samples = bus.samplesOf(2);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(2), samples + 5);
    EXPECT_DOUBLE_EQ(bus.servo(0).commandVelocity, 0) << "a stopped motor stays stopped";
    EXPECT_EQ(bus.sends("AA 01 94", sent) + bus.sends("AA 01 05", sent), 0U);
    bus.expectNoViolations();
}

/// One module behind a bad plug was given up: it is queried again, while the others continue.
TEST(WellAgain, AsksOneModuleAgainThatWasGivenUp) {
    VirtualBus bus(servos(3));
    ASSERT_TRUE(bus.connect());
    bool bad = true;
    bool toOne = false;
    bus.losesReply = [&](ByteSpan command) {
        toOne = command.size() > 1 && command[1] == 2;
        return false;
    };
    bus.onHostByte = [&, n = 0](std::uint8_t& byte) mutable {
        byte = static_cast<std::uint8_t>(byte ^ (bad && toOne && ++n % 3 == 0 ? 0x10U : 0U));
        return 1U;
    };
    const auto givenUp = [&] {
        const auto changes = bus.all<HealthChanged>();
        return std::any_of(changes.begin(), changes.end(), [](const HealthChanged& change) {
            return change.health == LinkHealth::Lost && change.module == ModuleIndex(1);
        });
    };
    ASSERT_TRUE(bus.runUntil(givenUp, 60s));
    ASSERT_TRUE(bus.last<ModuleUnresponsive>()->silent);
    bad = false;
    ASSERT_TRUE(bus.runUntil([&] { return !bus.last<ModuleUnresponsive>()->silent; }, 6s));
    EXPECT_EQ(bus.last<HealthChanged>()->health, LinkHealth::Good);
    const std::size_t samples = bus.samplesOf(1);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(1), samples + 4);
    EXPECT_EQ(bus.count<ChainFound>(), 1U);
}

}  // namespace

}  // namespace nmc::test

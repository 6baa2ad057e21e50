// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <tuple>

#include "tests/bus/scriptedbus.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

TEST(Discovery, FindsThirtyTwoModulesInOrder) {
    VirtualBus bus(servos(32));
    ASSERT_TRUE(bus.connect());
    const auto found = *bus.last<ChainFound>();
    ASSERT_EQ(found.modules.size(), 32U);
    for (std::uint8_t i = 0; i < 32; ++i) {
        EXPECT_EQ(found.modules[i].index, ModuleIndex(i));
        EXPECT_EQ(found.modules[i].address, BusAddress(static_cast<std::uint8_t>(i + 1)));
        EXPECT_EQ(found.modules[i].identity, (ModuleIdentity{ModuleType::Servo, 4}));
        EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).address, i + 1);
    }
    EXPECT_EQ(found.baud, 19'200U);
    bus.expectNoViolations();
}

/// Resets every group at every rate (faults.md F-48), with FF and 19 200 Bd last, so that all are then reset
/// at once.
TEST(Discovery, RestartsWithAResetAtEveryRate) {
    ScriptedBus bus(1);
    std::vector<std::uint32_t> rates;
    bus.engine.restart(bus.now);
    constexpr std::size_t kPerRate = 1 + 128;
    for (int i = 0; i < 3000 && bus.sent.size() < 4 * kPerRate + 1; ++i) {
        for (const Output& output : bus.engine.takeOutput())
            if (const auto* rate = std::get_if<SetHostBaud>(&output))
                rates.push_back(rate->baud);
            else if (const auto* send = std::get_if<Send>(&output);
                     send != nullptr && !ScriptedBus::isSpacer(send->bytes))
                bus.sent.push_back({bus.now, toHex(send->bytes)});
        bus.now = *bus.engine.nextDeadline();
        bus.engine.onDeadline(bus.now);
    }
    EXPECT_EQ(rates, (std::vector<std::uint32_t>{115'200, 57'600, 9'600, 19'200}));
    ASSERT_EQ(bus.sent.size(), 4 * kPerRate + 1);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto* sent = &bus.sent[i * kPerRate];
        EXPECT_EQ(sent[0].hex, ScriptedBus::kNulls);
        EXPECT_EQ(sent[1].hex, "AA 80 0F 8F");
        EXPECT_EQ(sent[128].hex, "AA FF 0F 0E");
        // Sixteen bytes and one millisecond; 0.51 ms between packets that are not answered.
        EXPECT_GE(sent[1].time - sent[0].time, 16 * byteTimeAtBaud(rates[i]) + 1ms);
        EXPECT_GE(sent[128].time - sent[127].time, 4 * byteTimeAtBaud(rates[i]) + 510us);
    }
    EXPECT_EQ(bus.sent.back().hex, ScriptedBus::kNulls);
    EXPECT_GE(bus.sent.back().time - (&bus.sent.back() - 1)->time,
              4 * byteTimeAtBaud(19'200) + EngineConfig{}.resetWait);
}

TEST(Discovery, AsksInTheOrderOfTheDataSheet) {
    ScriptedBus bus(2);
    ASSERT_TRUE(bus.connect());
    std::vector<std::string> packets;
    for (const auto& sent : bus.sent) {
        const bool reset = sent.hex.substr(6, 2) == "0F";
        if (sent.hex != ScriptedBus::kNulls && !reset)
            packets.push_back(sent.hex);
    }
    ASSERT_GE(packets.size(), 7U);
    EXPECT_EQ(packets[0], "AA 00 21 01 FF 21");
    EXPECT_EQ(packets[1], "AA 00 21 02 FF 22");
    EXPECT_EQ(packets[2], "AA 00 21 03 FF 23");
    EXPECT_EQ(packets[3], "AA 03 13 20 36") << "no answer: was it lost?";
    EXPECT_EQ(packets[4], "AA 03 13 20 36") << "was this one lost, too?";
    EXPECT_EQ(packets[5], "AA 02 0E 10") << "is the line dead?";
    EXPECT_EQ(packets[6], "AA 00 21 04 FF 24") << "a number that was sent is never sent again";
    ASSERT_EQ(packets.back(), "AA 01 13 3F 53") << "the first poll";
    const std::vector<std::string> tail(packets.end() - 7, packets.end());
    EXPECT_EQ(tail[0], "AA 01 13 20 34");
    EXPECT_EQ(tail[1], "AA 02 13 20 35");
    EXPECT_EQ(tail[2], "AA 01 12 0F 22");
    EXPECT_EQ(tail[3], "AA 02 12 0F 23");
    EXPECT_EQ(tail[4], "AA 01 13 3F 53") << "three different answers: no two modules share an address";
    EXPECT_EQ(tail[5], "AA 02 13 3F 54");
}

TEST(Discovery, RestartsAChainLeftAtAnotherRate) {
    for (const std::uint32_t baud : {9'600U, 57'600U, 115'200U}) {
        SCOPED_TRACE(baud);
        // One engine leaves the chain at this rate; a second one, at 19 200, does not know the rate.
        EngineConfig config;
        config.baud = baud;
        VirtualBus bus(servos(3), config);
        ASSERT_TRUE(bus.connect());
        bus.newHost();
        ASSERT_TRUE(bus.restart());
        EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
        EXPECT_EQ(bus.last<ChainFound>()->baud, 19'200U);
    }
}

/// What is lost while address `n` is assigned: the command, or this many answers, first to the command and
/// then to the queries at the new address.
struct Loss {
    bool command = false;
    int answers = 0;
    friend void PrintTo(const Loss& l, std::ostream* stream) {
        *stream << (l.command ? "Command" : "Answer") << l.answers;
    }
};

class AddressLost : public testing::TestWithParam<Loss> {};

/// If a module took a number without being heard, and the next one got the same number, two motors would obey
/// one command.
TEST_P(AddressLost, LeavesNoTwoModulesAtOneAddress) {
    constexpr std::uint8_t kModules = 8;
    for (std::uint8_t n = 1; n <= kModules; ++n) {
        SCOPED_TRACE(int{n});
        VirtualBus bus(servos(kModules));
        int struck = 0;
        const auto concerns = [n](ByteSpan command) {
            const bool gives = command.size() > 3 && command[1] == 0 && command[2] == 0x21 && command[3] == n;
            const bool asks = command.size() > 3 && command[1] == n && command[2] == 0x13;
            return gives || asks;
        };
        if (GetParam().command)
            bus.onCommand = [&](std::vector<std::uint8_t>& command) {
                if (concerns(command) && struck++ == 0)
                    command.pop_back();
            };
        else
            bus.losesReply = [&](ByteSpan command) {
                return concerns(command) && struck++ < GetParam().answers;
            };
        ASSERT_TRUE(bus.connect());
        const auto found = *bus.last<ChainFound>();
        ASSERT_EQ(found.modules.size(), kModules);
        std::vector<int> given;
        for (const auto& sent : bus.sent)
            if (sent.hex().rfind("AA 00 21", 0) == 0)
                given.push_back(sent.bytes[3]);
        EXPECT_TRUE(std::adjacent_find(given.begin(), given.end(), std::greater_equal<>()) == given.end())
            << "each number once, in ascending order";
        int before = 0;
        for (std::uint8_t i = 0; i < kModules; ++i) {
            const int address = bus.chain.snapshot(ModuleIndex(i), bus.now).address;
            EXPECT_GT(address, before) << "module " << int{i};
            EXPECT_EQ(found.modules[i].address.value(), address);
            before = address;
        }
        bus.onCommand = {};
        bus.losesReply = {};
        bus.runFor(std::chrono::seconds(1));
        for (std::uint8_t i = 0; i < kModules; ++i)
            EXPECT_GT(bus.samplesOf(i), 2U);
    }
}

INSTANTIATE_TEST_SUITE_P(Discovery, AddressLost,
                         testing::Values(Loss{true, 0}, Loss{false, 1}, Loss{false, 2}, Loss{false, 3}),
                         testing::PrintToStringParamName());

/// Wherever the answers are lost, a chain that has just been switched on is found complete.
TEST(Discovery, IsNotMisledByTwoLostAnswers) {
    constexpr std::size_t kModules = 4;
    EngineConfig config;
    config.baud = 115'200;
    for (int first = 0; first < 90; ++first)
        for (const int apart : {1, 2, 3, 9}) {
            SCOPED_TRACE(std::to_string(first) + " and " + std::to_string(first + apart));
            VirtualBus bus(servos(kModules), config);
            bus.losesReply = [n = -1, first, apart](ByteSpan command) mutable {
                n += command[0] == 0xAA ? 1 : 0;
                return n == first || n == first + apart;
            };
            ASSERT_TRUE(bus.connect());
            EXPECT_EQ(bus.last<ChainFound>()->modules.size(), kModules);
            EXPECT_EQ(bus.last<ChainFound>()->baud, 115'200U);
        }
}

/// An adapter or a computer in between stops working for a while: the commands sent meanwhile are lost, or
/// their answers are.
using Frozen = std::tuple<bool, Duration, std::size_t>;

class LineFrozen : public testing::TestWithParam<Frozen> {};

TEST_P(LineFrozen, DoesNotMakeAShorterChain) {
    const auto [commandsLost, lasting, modules] = GetParam();
    for (Duration from{}; from < 2s; from += 11ms) {
        SCOPED_TRACE(toSeconds(from));
        VirtualBus bus(servos(modules));
        const TimePoint begin = bus.now + from;
        const auto frozen = [&bus, begin, end = begin + lasting] {
            return bus.now >= begin && bus.now < end;
        };
        if (commandsLost)
            bus.onCommand = [&](std::vector<std::uint8_t>& command) {
                if (frozen())
                    command.clear();
            };
        else
            bus.losesReply = [&](ByteSpan) { return frozen(); };
        const bool connected = bus.connect();
        EXPECT_TRUE(connected) << static_cast<int>(bus.last<ConnectFailed>()->reason);
        if (connected) {
            EXPECT_EQ(bus.last<ChainFound>()->modules.size(), modules);
        }
    }
}

std::string nameOf(const testing::TestParamInfo<Frozen>& info) {
    const auto& [commandsLost, lasting, modules] = info.param;
    return (commandsLost ? "CommandsFor" : "AnswersFor") + std::to_string(lasting / 1ms) + "MsOf" +
           std::to_string(modules);
}

INSTANTIATE_TEST_SUITE_P(Discovery, LineFrozen,
                         testing::Combine(testing::Bool(), testing::Values(100ms, 313ms, 500ms),
                                          testing::Values(1, 4)),
                         nameOf);

/// The chain answers, and then it does not: the part that is known by then is not used as a chain.
TEST(Discovery, SaysThatTheLineIsDisturbed) {
    VirtualBus bus(servos(4));
    bool given = false;
    bus.losesReply = [&](ByteSpan command) {
        given = given || toHex(command).starts_with("AA 00 21 03");
        return given;
    };
    EXPECT_FALSE(bus.connect());
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Disturbed);
}

/// The communication-error bit means "certainly not carried out", but a flipped bit looks the same.
TEST(Discovery, GivesAnotherNumberWhenOneIsRefused) {
    ScriptedBus bus(2);
    bus.answer = [&](ByteSpan packet) {
        auto reply = bus.likeAServo(packet);
        if (toHex(packet) == "AA 00 21 01 FF 21")
            reply = withSum({static_cast<std::uint8_t>(reply[0] | 0x02U)});
        return reply;
    };
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.sends("AA 00 21 01 FF 21"), 1U);
    EXPECT_EQ(bus.all<ChainFound>().at(0).modules.size(), 2U);
}

/// Two modules that wake at the same time take the same number, and answer at the same time.
TEST(Discovery, NamesTheAddressAtWhichTwoAnswerAtOnce) {
    ScriptedBus bus(2);
    bus.answer = [&](ByteSpan packet) {
        auto reply = bus.likeAServo(packet);
        if (packet.size() > 1 && (toHex(packet) == "AA 00 21 02 FF 22" || packet[1] == 2)) {
            const auto once = reply;
            reply.insert(reply.end(), once.begin(), once.end());
        }
        return reply;
    };
    EXPECT_FALSE(bus.connect());
    const auto failed = bus.all<ConnectFailed>().at(0);
    EXPECT_EQ(failed.reason, ConnectFailure::Collision);
    EXPECT_EQ(failed.modules, std::vector{ModuleIndex(1)});
}

TEST(Discovery, SaysThatNobodyAnswers) {
    ScriptedBus bus(0);
    EXPECT_FALSE(bus.connect());
    const auto failed = bus.all<ConnectFailed>();
    ASSERT_EQ(failed.size(), 1U);
    EXPECT_EQ(failed[0].reason, ConnectFailure::NobodyAnswers);
    EXPECT_EQ(failed[0].baud, 19'200U);
    EXPECT_FALSE(bus.engine.nextDeadline()) << "nothing happens without a request";
}

class ReadLate : public testing::TestWithParam<std::tuple<bool, std::uint32_t>> {};

TEST_P(ReadLate, IsWaitedForBeforeNobodyIsSaidToAnswer) {
    const auto [fresh, rate] = GetParam();
    EngineConfig config;
    config.baud = rate;
    VirtualBus bus(servos(2), config);
    if (!fresh) {
        ASSERT_TRUE(bus.connect());
        bus.newHost();
    }
    bus.readLater = 40ms;
    ASSERT_TRUE(bus.connect()) << static_cast<int>(bus.last<ConnectFailed>()->reason);
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 2U);
    EXPECT_EQ(bus.last<ChainFound>()->attached, !fresh);
}

INSTANTIATE_TEST_SUITE_P(Discovery, ReadLate,
                         testing::Combine(testing::Bool(), testing::Values(19'200U, 115'200U)),
                         [](const auto& test) {
                             return std::string(std::get<bool>(test.param) ? "Fresh" : "Known") + "At" +
                                    std::to_string(std::get<std::uint32_t>(test.param));
                         });

/// The chain is a process on a busy machine: it reads at once for a while, and then for a while not at all.
class ReadInFits : public testing::TestWithParam<std::tuple<bool, int>> {
protected:
    const bool fresh = std::get<bool>(GetParam());
    const Duration longest = std::chrono::milliseconds(std::get<int>(GetParam()));
};

TEST_P(ReadInFits, IsFoundWhole) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const auto upTo = [&](Duration most) {
            return Duration(static_cast<Duration::rep>(random() % 1'000) * most.count() / 1'000);
        };
        VirtualBus bus(servos(2));
        if (!fresh) {
            ASSERT_TRUE(bus.connect());
            bus.newHost();
        }
        TimePoint begin = bus.now;
        TimePoint end = begin;
        bus.onCommand = [&](const std::vector<std::uint8_t>&) {
            while (end <= bus.now) {
                begin = end + upTo(100ms);
                end = begin + upTo(longest);
            }
            bus.readLater = bus.now >= begin ? end - bus.now : Duration{};
        };
        const bool found = bus.connect();
        EXPECT_TRUE(found || longest > 50ms) << seed;
        if (found) {
            EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 2U) << seed;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Discovery, ReadInFits, testing::Combine(testing::Bool(), testing::Values(50, 100)),
                         [](const auto& test) {
                             return std::string(std::get<bool>(test.param) ? "Fresh" : "Known") +
                                    std::to_string(std::get<int>(test.param)) + "ms";
                         });

TEST(Discovery, StaysAtTheOnlyRateOfALine) {
    EngineConfig config;
    config.fixedRate = true;
    config.knownBaud = 57'600;
    VirtualBus bus({}, config);
    bus.onTime = [&bus] { ASSERT_EQ(bus.hostBaud, 19'200U); };
    EXPECT_FALSE(bus.connect());
    EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::NobodyAnswers);
    EXPECT_TRUE(bus.last<ConnectFailed>()->fixedRate);
    const std::size_t from = bus.sent.size();
    bus.engine.restart(bus.now);
    bus.runFor(10s);
    EXPECT_EQ(bus.sends("AA FF 0F 0E", from), 1U) << "Hard Reset of all (DS-V 5.2)";
}

TEST(Discovery, SaysThatAnswersAreGarbled) {
    ScriptedBus bus(1);
    bus.answer = [](ByteSpan packet) {
        return packet[1] == 0xFF ? std::vector<std::uint8_t>{} : std::vector<std::uint8_t>{0x55, 0xAA};
    };
    bus.replyDelay = 300us;
    EXPECT_FALSE(bus.connect());
    EXPECT_EQ(bus.all<ConnectFailed>().at(0).reason, ConnectFailure::Garbled);
}

TEST(Discovery, NamesTheModuleThatDoesNotFollowToTheNewRate) {
    EngineConfig config;
    config.baud = 115'200;
    ScriptedBus bus(3, config);
    bool changed = false;
    bus.answer = [&](ByteSpan packet) {
        changed = changed || toHex(packet) == "AA FF 1A 0A 23";
        return changed && packet[1] == 2 ? std::vector<std::uint8_t>{} : bus.likeAServo(packet);
    };
    EXPECT_FALSE(bus.connect());
    const auto failed = bus.all<ConnectFailed>();
    ASSERT_EQ(failed.size(), 1U);
    EXPECT_EQ(failed[0].reason, ConnectFailure::RateChange);
    EXPECT_EQ(failed[0].modules, std::vector{ModuleIndex(1)});
    EXPECT_EQ(failed[0].baud, 115'200U);
    EXPECT_EQ(bus.sends("AA 02 0E 10"), 3U) << "queried three times";
}

TEST(Discovery, RefusesARateThatTheChipsCannotMakeBeforeItResetsAnything) {
    EngineConfig config;
    config.baud = 360'000;  // between 1 250 000 / 4 and 1 250 000 / 3
    ScriptedBus bus(3, config);
    EXPECT_FALSE(bus.connect());
    EXPECT_TRUE(bus.sent.empty());
    EXPECT_EQ(bus.all<ConnectFailed>().at(0).reason, ConnectFailure::RateChange);
}

TEST(Discovery, SendsTheBetterDivisor) {
    EngineConfig config;
    config.baud = 57'600;
    VirtualBus bus(servos(1), config);
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.sends("AA FF 1A 15 2E"), 1U);
}

TEST(Discovery, TellsHowFarItIs) {
    EngineConfig config;
    config.baud = 115'200;
    VirtualBus bus(servos(2), config);
    ASSERT_TRUE(bus.connect());
    std::vector<std::pair<ConnectStage, int>> stages;
    for (const auto& progress : bus.all<ConnectProgress>())
        stages.emplace_back(progress.stage, progress.modules);
    using enum ConnectStage;
    const std::vector<std::pair<ConnectStage, int>> expected{
        {Looking, 0},     {Addressing, 0},   {Addressing, 1}, {Addressing, 2},
        {Identifying, 2}, {ChangingRate, 2}, {Preparing, 2}};
    EXPECT_EQ(stages, expected);
}

TEST(Discovery, StartsCleanWheneverItIsAskedFor) {
    VirtualBus bus(servos(3));
    for (int i = 0; i < 60; ++i) {
        bus.engine.connect(bus.now);
        bus.runFor(i * 23ms);
    }
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    EXPECT_EQ(bus.engine.statistics().timeouts, 0U);
}

TEST(Discovery, LetsWhatIsLeavingLeaveBeforeItChangesTheRate) {
    ScriptedBus bus(1);
    ASSERT_TRUE(bus.connect());
    bus.runFor(100ms);
    const std::size_t sent = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sent.size() > sent; }));
    bus.engine.connect(bus.now);
    EXPECT_TRUE(bus.engine.takeOutput().empty());
    EXPECT_GE(*bus.engine.nextDeadline() - bus.now, 4 * byteTimeAtBaud(19'200));
}

/// Most of the time is needed to query three times for an existing chain, which must not be given other
/// addresses; a tenth of a second, to wait longer for the two numbers after the last module.
TEST(Discovery, TakesLittleMoreThanASecondForAShortChain) {
    VirtualBus bus(servos(3));
    const TimePoint began = bus.now;
    ASSERT_TRUE(bus.connect());
    EXPECT_LT(bus.now - began, 1300ms);
}

TEST(Discovery, RunsAtEveryRate) {
    for (const std::uint32_t baud : {9'600U, 19'200U, 57'600U, 115'200U}) {
        SCOPED_TRACE(baud);
        EngineConfig config;
        config.baud = baud;
        VirtualBus bus(servos(3), config);
        ASSERT_TRUE(bus.connect());
        EXPECT_EQ(bus.last<ChainFound>()->baud, baud);
        const TimePoint began = bus.now;
        const auto before = bus.engine.statistics();
        bus.runFor(2s);
        const auto& after = bus.engine.statistics();
        EXPECT_NEAR(static_cast<double>(after.answered - before.answered),
                    static_cast<double>(after.exchanges - before.exchanges), 1);
        const double used = toSeconds(after.wireTime - before.wireTime) / toSeconds(bus.now - began);
        std::printf("%u Bd: %.1f polls/s, %.1f %% of the wire\n", baud,
                    static_cast<double>(after.answered - before.answered) / 2, used * 100);
        EXPECT_GT(used, 0.9);
        bus.expectNoViolations();
    }
}

}  // namespace

}  // namespace nmc::test

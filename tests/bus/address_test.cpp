// SPDX-License-Identifier: GPL-3.0-or-later
// Any address for a module that answers (DS-V 5.2, DS-S 5.1 Set Address), chains whose addresses are not
// consecutive, and any divisor that the chips support (Set Baud Rate).
#include <gtest/gtest.h>

#include "tests/bus/groups.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// Three servos, on, at 1 000, 2 000 and 3 000 counts.
class Addresses : public testing::Test {
protected:
    using Reason = ReaddressFailed::Reason;

    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        for (std::uint8_t i = 0; i < 3; ++i)
            ASSERT_EQ(bus.perform({gains(i), enable(i), loadMove(i, 1'000 * (i + 1)), start(i)}),
                      Outcome::Done);
        bus.runFor(3s);
    }
    /// Changes the address and runs until this has ended; returns the reason if it failed.
    std::optional<Reason> move(std::uint8_t module, std::uint8_t address) {
        const std::size_t before = bus.count<AddressChanged>() + bus.count<ReaddressFailed>();
        const std::size_t failed = bus.count<ReaddressFailed>();
        bus.engine.moveTo(ModuleIndex(module), BusAddress(address), bus.now);
        EXPECT_TRUE(bus.runUntil(
            [&] { return bus.count<AddressChanged>() + bus.count<ReaddressFailed>() > before; }, 5s));
        return bus.count<ReaddressFailed>() > failed ? std::optional(bus.last<ReaddressFailed>()->reason)
                                                     : std::nullopt;
    }
    [[nodiscard]] int addressOf(std::uint8_t module) {
        return bus.chain.snapshot(ModuleIndex(module), bus.now).address;
    }
    /// Each module answers at its address and is in its old position.
    void expectAllLive() {
        bus.runFor(1s);
        for (std::uint8_t i = 0; i < 3; ++i) {
            EXPECT_GE(bus.lastSample(i)->time, bus.now - 300ms) << int{i};
            EXPECT_NEAR(bus.lastSample(i)->report.position.value_or(0), 1'000 * (i + 1), 3) << int{i};
        }
    }

    GroupBus bus{servos(3)};
};

// AA, old address, 21, new address, group, sum.
TEST_F(Addresses, AreAnyFrom1To127AndTheModuleKeepsWhatItHas) {
    EXPECT_EQ(move(1, 127), std::nullopt);
    EXPECT_EQ(bus.sends("AA 02 21 7F FF A1"), 1U);
    EXPECT_EQ(bus.last<AddressChanged>()->address, BusAddress(127));
    EXPECT_EQ(addressOf(1), 127);
    EXPECT_TRUE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.servo(1).gains.kp, 200);
    expectAllLive();
    ASSERT_EQ(bus.perform({loadMove(1, 0), start(1)}), Outcome::Done);
    bus.runFor(100ms);
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 3U);
    EXPECT_EQ(bus.servo(1).commandVelocity, 0.0);
    EXPECT_EQ(move(1, 2), std::nullopt) << "it gets its old address back";
    bus.expectNoViolations();
}

TEST_F(Addresses, AreInTheStopThatLiesReady) {
    const auto before = bus.engine.stopBurst();
    EXPECT_EQ(move(1, 100), std::nullopt);
    const auto burst = bus.engine.stopBurst();
    ASSERT_NE(burst, before) << "a guardian would stop no motor at the old address";
    EXPECT_NE(toHex(burst).find("AA 64 17"), std::string::npos);
    EXPECT_EQ(toHex(burst).find("AA 02 17"), std::string::npos);
}

TEST_F(Addresses, ChangeWithoutTheGroup) {
    ASSERT_EQ(bus.put(1, 0x81, true).outcome, Outcome::Done);
    EXPECT_EQ(move(1, 50), std::nullopt);
    EXPECT_EQ(bus.sends("AA 02 21 32 01 56"), 1U) << "bit 7 of the group cleared: it leads";
    const auto truth = bus.chain.snapshot(ModuleIndex(1), bus.now);
    EXPECT_EQ(truth.group, 0x81);
    EXPECT_TRUE(truth.leader);
}

TEST_F(Addresses, ThatCannotBeAreRefusedBeforeAnythingIsSent) {
    const std::size_t from = bus.sent.size();
    EXPECT_EQ(move(1, 3), Reason::Taken);
    EXPECT_EQ(move(1, 2), Reason::Taken) << "it has this address already";
    EXPECT_EQ(move(1, 0), Reason::Taken) << "reserved for modules without an address";
    EXPECT_EQ(move(1, 0x80), Reason::Taken) << "a group's address";
    ASSERT_EQ(bus.perform({loadVelocity(2, 65'536, true)}), Outcome::Done);
    bus.runFor(200ms);
    EXPECT_EQ(move(1, 20), Reason::NotNow) << "a motor moves";
    EXPECT_EQ(bus.sends("AA 02 21", from), 0U);
    EXPECT_EQ(addressOf(1), 2);
}

TEST_F(Addresses, OfAModuleThatIsNotKnownHereAreTaken) {
    ASSERT_EQ(move(2, 90), std::nullopt);
    bus.newHost();  // it does not know address 90
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.last<ChainFound>()->modules.size(), 2U);
    EXPECT_EQ(move(0, 50), Reason::GroupUnknown) << "another host may have given it one";
    ASSERT_EQ(bus.put(0, 0xFF).outcome, Outcome::Done);
    EXPECT_EQ(move(0, 90), Reason::Taken);
    EXPECT_EQ(addressOf(0), 1);
    EXPECT_EQ(move(0, 91), std::nullopt);
}

TEST_F(Addresses, OfAModuleThatIsNotKnownHereAreTakenAlthoughAnswersAreLost) {
    ASSERT_EQ(move(2, 90), std::nullopt);
    bus.newHost();
    ASSERT_TRUE(bus.connect());
    ASSERT_EQ(bus.last<ChainFound>()->modules.size(), 2U);
    ASSERT_EQ(bus.put(0, 0xFF).outcome, Outcome::Done);
    unsigned lost = 0;
    bus.losesReply = [&](ByteSpan command) {
        return command.size() > 1 && command[1] == 90 && lost < 2 && ++lost > 0;
    };
    EXPECT_EQ(move(0, 90), Reason::Taken);
    EXPECT_EQ(lost, 2U);
    EXPECT_EQ(addressOf(0), 1);
}

TEST_F(Addresses, AreFoundOutWhenTheAnswerIsLost) {
    bus.losesReply = [](ByteSpan command) { return command.size() > 2 && command[2] == 0x21; };
    EXPECT_EQ(move(1, 60), std::nullopt);
    bus.losesReply = nullptr;
    EXPECT_EQ(bus.sends("AA 02 21"), 1U) << "it is queried at the new address first";
    EXPECT_EQ(addressOf(1), 60);
    expectAllLive();
}

TEST_F(Addresses, AreGivenAgainWhenTheCommandIsLost) {
    bool lost = false;
    bus.onCommand = [&](std::vector<std::uint8_t>& command) {
        if (command.size() > 2 && command[2] == 0x21 && !std::exchange(lost, true))
            command.clear();
    };
    EXPECT_EQ(move(1, 60), std::nullopt);
    EXPECT_TRUE(lost);
    EXPECT_EQ(addressOf(1), 60);
    expectAllLive();
}

TEST_F(Addresses, AreKnownAfterAStopThatCameInBetween) {
    for (const bool heard : {true, false})
        for (const Duration after : {0us, 500us, 2'000us, 5'000us, 20'000us, 40'000us, 60'000us, 100'000us}) {
            SCOPED_TRACE(toSeconds(after));
            const int before = addressOf(1);
            const std::uint8_t wanted = before == 70 ? 71 : 70;
            bus.onCommand = [&](std::vector<std::uint8_t>& command) {
                if (!heard && command.size() > 2 && command[2] == 0x21)
                    command.clear();
            };
            bus.events.clear();
            bus.engine.moveTo(ModuleIndex(1), BusAddress(wanted), bus.now);
            bus.runFor(after);
            const auto stop = bus.stopAll();
            bus.onCommand = nullptr;
            ASSERT_TRUE(stop);
            EXPECT_TRUE(bus.runUntil(
                [&] { return bus.count<AddressChanged>() + bus.count<ReaddressFailed>() == 1; }, 5s));
            EXPECT_EQ(addressOf(1), bus.count<AddressChanged>() == 1 ? int{wanted} : before);
            bus.runFor(5s);
            expectAllLive();
        }
}

TEST_F(Addresses, ChangeWithoutAnythingElseInBetween) {
    for (const Duration after : {0us, 1'000us, 5'000us}) {
        SCOPED_TRACE(toSeconds(after));
        bus.events.clear();
        const auto wanted = static_cast<std::uint8_t>(addressOf(1) == 70 ? 71 : 70);
        bus.engine.moveTo(ModuleIndex(1), BusAddress(wanted), bus.now);
        bus.runFor(after);
        ASSERT_EQ(bus.count<AddressChanged>(), 0U);
        bus.engine.changeRate(57'600, bus.now);
        bus.engine.moveTo(ModuleIndex(2), BusAddress(90), bus.now);
        EXPECT_FALSE(bus.engine.lend());
        bus.runFor(100us);
        ASSERT_TRUE(bus.last<RateChangeFailed>());
        EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NotNow);
        EXPECT_TRUE(bus.runUntil([&] { return bus.count<AddressChanged>() == 1; }, 5s));
        EXPECT_EQ(bus.count<ReaddressFailed>(), 1U);
        EXPECT_EQ(addressOf(1), wanted);
        EXPECT_NEAR(bus.chain.snapshot(ModuleIndex(1), bus.now).baud, 19'200, 400);  // to within 2 %
        expectAllLive();
    }
}

TEST_F(Addresses, LeadAnotherProgramToTheSamePlaces) {
    ASSERT_EQ(move(0, 99), std::nullopt);
    ASSERT_EQ(move(1, 7), std::nullopt);
    EngineConfig config;
    for (std::uint8_t i = 0; i < 3; ++i)
        config.known.push_back({ModuleIndex(i),
                                BusAddress(static_cast<std::uint8_t>(addressOf(i))),
                                {ModuleType::Servo, 4},
                                std::nullopt});
    bus.newHost(config);
    ASSERT_TRUE(bus.connect());
    const ChainFound found = *bus.last<ChainFound>();
    ASSERT_EQ(found.modules.size(), 3U);
    EXPECT_TRUE(found.attached);
    EXPECT_TRUE(found.absent.empty());
    EXPECT_EQ(found.modules[0].address, BusAddress(99));
    expectAllLive();
    ASSERT_TRUE(bus.connect()) << "a scan finds the same";
    EXPECT_EQ(bus.last<ChainFound>()->modules[0].address, BusAddress(99));
    expectAllLive();
}

TEST_F(Addresses, ComeBackToAModuleThatRestarted) {
    ASSERT_EQ(move(1, 80), std::nullopt);
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }, 10s));
    EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(1));
    bus.engine.readdress(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<Readdressed>() == 1; }, 5s));
    EXPECT_EQ(addressOf(1), 80);
    bus.runFor(1s);
    EXPECT_GE(bus.lastSample(1)->time, bus.now - 300ms);
}

TEST_F(Addresses, StartFrom1AgainWhenTheNetworkIsRestarted) {
    ASSERT_EQ(move(0, 99), std::nullopt);
    ASSERT_TRUE(bus.restart());
    for (std::uint8_t i = 0; i < 3; ++i)
        EXPECT_EQ(addressOf(i), i + 1);
}

// ---- any divisor ----

class Divisors : public Addresses {
protected:
    [[nodiscard]] bool change(std::uint32_t baud) {
        const std::size_t before = bus.count<RateChanged>() + bus.count<RateChangeFailed>();
        const std::size_t done = bus.count<RateChanged>();
        bus.engine.changeRate(baud, bus.now);
        EXPECT_TRUE(bus.runUntil(
            [&] { return bus.count<RateChanged>() + bus.count<RateChangeFailed>() > before; }, 10s));
        return bus.count<RateChanged>() > done;
    }
};

// AA FF 1A brd sum; 1 250 000 / (19 + 1) = 62 500 (DS-V 5.2 Set Baud Rate).
TEST_F(Divisors, OutsideTheTableTakeTheChainToTheirRateAndBack) {
    ASSERT_TRUE(change(62'500));
    EXPECT_EQ(bus.sends("AA FF 1A 13 2C"), 1U);
    EXPECT_EQ(bus.hostBaud, 62'500U);
    expectAllLive();
    ASSERT_TRUE(change(31'250));  // 1 250 000 / (39 + 1)
    EXPECT_EQ(bus.sends("AA FF 1A 27 40"), 1U);
    expectAllLive();
    ASSERT_TRUE(change(19'200));
    expectAllLive();
    bus.expectNoViolations();
}

TEST_F(Divisors, ThatGiveNoSuchRateAreRefused) {
    // The rate after 1 250 000 / 4 = 312 500 is 1 250 000 / 3 = 416 667.
    EXPECT_FALSE(change(360'000));
    EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NoSuchRate);
    EXPECT_FALSE(change(4'000)) << "slower than divisor 255";
    EXPECT_FALSE(change(0));
    EXPECT_EQ(bus.sends("AA FF 1A"), 0U);
    expectAllLive();
}

TEST_F(Divisors, AreTakenBackWhenAModuleDoesNotFollow) {
    unsigned deaf = 0;
    bus.losesReply = [&](ByteSpan command) {
        return bus.hostBaud == 250'000 && command.size() > 1 && command[1] == 2 && ++deaf > 0;
    };
    EXPECT_FALSE(change(250'000));
    EXPECT_EQ(bus.last<RateChangeFailed>()->reason, RateChangeFailed::Reason::NotHeard);
    EXPECT_TRUE(bus.last<RateChangeFailed>()->lost.empty());
    EXPECT_GT(deaf, 0U);
    EXPECT_EQ(bus.hostBaud, 19'200U);
    bus.losesReply = nullptr;
    expectAllLive();
}

TEST_F(Divisors, AreLookedAtByAProgramThatKnowsThem) {
    ASSERT_TRUE(change(250'000));
    EngineConfig config;
    config.knownBaud = 250'000;
    bus.newHost(config);
    ASSERT_TRUE(bus.connect());
    EXPECT_EQ(bus.last<ChainFound>()->baud, 250'000U);
    EXPECT_TRUE(bus.last<ChainFound>()->attached);
    expectAllLive();
    ASSERT_TRUE(bus.connect()) << "a scan stays at this rate";
    EXPECT_EQ(bus.last<ChainFound>()->baud, 250'000U);
    bus.newHost(config);
    ASSERT_TRUE(bus.restart()) << "a reset reaches the chain at this rate";
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    EXPECT_EQ(bus.last<ChainFound>()->baud, 19'200U);
}

}  // namespace

}  // namespace nmc::test

// SPDX-License-Identifier: GPL-3.0-or-later
// F-15, F-16, F-37, F-38, F-43, F-44, F-48: modules that restart, or share an address, or were left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/bus/scriptedbus.h"
#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"
#include "tests/support/modules.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::Contains;

/// To a module without an address.
constexpr const char* kQueryOfRestarted = "AA 00 13 20 33";

[[nodiscard]] bool restarted(const FaultyBus& bus, std::uint8_t module) {
    for (const auto& event : bus.all<ModuleRestarted>())
        if (event.module == ModuleIndex(module))
            return true;
    return false;
}

// ---- F-15, F-16 ----

class F15_ModulePowerCycled : public testing::TestWithParam<bool> {
protected:
    static sim::ChainOptions options() {
        sim::ChainOptions options = withFaults();
        options.deafWhenAddressInputRises = GetParam();
        return options;
    }
};

TEST_P(F15_ModulePowerCycled, IsToldAndLeftAlone) {
    VirtualBus bus(servos(3), {}, options());
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < 3; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(500ms);
    const std::size_t from = bus.sent.size();
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    const auto told = [&] { return bus.count<ModuleRestarted>() > 0; };
    ASSERT_TRUE(bus.runUntil(told, 10s));
    EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(1));
    bus.runFor(5s);
    EXPECT_EQ(bus.count<ModuleRestarted>(), 1U);
    for (std::size_t i = from; i < bus.sent.size(); ++i) {
        const auto code = codeOf(bus.sent[i].bytes);
        EXPECT_FALSE(code && changesSomething(*code)) << bus.sent[i].hex();
    }
    EXPECT_EQ(bus.chain.snapshot(ModuleIndex(1), bus.now).address, 0);
    EXPECT_FALSE(bus.servo(1).servoOn);
    const auto operation = bus.perform({gains(1)});
    EXPECT_NE(operation, Outcome::Done) << "it cannot be reached by its address";
}

TEST_P(F15_ModulePowerCycled, LeavesTheOthersThatAnswerLive) {
    VirtualBus bus(servos(3), {}, options());
    ASSERT_TRUE(bus.connect());
    bus.runFor(500ms);
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    bus.runFor(5s);
    const std::size_t samples = bus.samplesOf(0);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(0), samples + 10) << "module 1 is farther from the host";
}

INSTANTIATE_TEST_SUITE_P(AddressInputs, F15_ModulePowerCycled, testing::Bool());

TEST(F15_ModulePowerCycledAlone, IsWellAgainAfterARestart) {
    FaultyBus bus(servos(3));
    ASSERT_TRUE(bus.connectAndEnable());
    bus.fault("module 2 powercycle");
    bus.runFor(3s);
    ASSERT_TRUE(bus.restart());
    EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    bus.runFor(1s);
    EXPECT_EQ(bus.chain.snapshot(ModuleIndex(1), bus.now).address, 2);
}

/// Module 1 may run, so the stop that is owed to it must go on.
TEST(F15_ModulePowerCycledBesideASilentOne, IsNotMistakenForThatOne) {
    for (const ModuleIdentity first : {testing_support::kServo, testing_support::kStep}) {
        FaultyBus bus({first, testing_support::kServo, testing_support::kServo});
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault("module 1 silent");
        bus.runFor(3s);
        ASSERT_TRUE(bus.stopAll());
        bus.fault("module 3 powercycle");
        ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() > 0; }, 10s));
        EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(2));
        const std::size_t from = bus.sent.size();
        bus.runFor(2s);
        EXPECT_EQ(bus.count<ModuleRestarted>(), 1U);
        if (first == testing_support::kServo) {
            EXPECT_GT(bus.sends("AA 01 17", from), 0U) << "its stop is owed";
        }
        ASSERT_TRUE(bus.connect()) << "a scan finds the same";
        EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(2));
    }
}

/// The module next to the silent one may be cut off by it, or have restarted itself.
TEST(F15_ModulePowerCycledBesideASilentOne, IsNotNamedWhereEitherMayBeIt) {
    FaultyBus bus(servos(3));
    ASSERT_TRUE(bus.connectAndEnable());
    bus.fault("module 1 silent");
    bus.runFor(3s);
    ASSERT_TRUE(bus.stopAll());
    std::size_t from = bus.sent.size();
    bus.fault("module 2 powercycle");
    bus.runFor(10s);
    EXPECT_GT(bus.sends(kQueryOfRestarted, from), 0U);
    EXPECT_EQ(bus.count<ModuleRestarted>(), 0U);
    EXPECT_GT(bus.sends("AA 01 17", from), 0U);
    ASSERT_TRUE(bus.connect());
    from = bus.sent.size();
    bus.runFor(20s);
    EXPECT_GT(bus.sends(kQueryOfRestarted, from), 0U);
    EXPECT_EQ(bus.count<ModuleRestarted>(), 0U) << "a scan forgets nothing";
    EXPECT_GT(bus.sends("AA 01 17", from), 0U) << "its stop is owed";
}

/// The answer about another module, from before the chain was searched for again, says nothing of this one.
TEST(F15_ModuleSilentAfterAnotherRestarted, IsNotCalledRestartedWhenAStopCutsTheQueryOff) {
    FaultyBus bus(servos(2));
    ASSERT_TRUE(bus.connectAndEnable());
    std::size_t from = bus.sent.size();
    bus.fault("module 2 powercycle");
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends(kQueryOfRestarted, from) > 0; }, 10s));
    from = bus.sent.size();
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends("AA 01 13 20 34", from) > 0; }, 1s))
        << "the other module is asked whether it still answers";
    ASSERT_EQ(bus.count<ModuleRestarted>(), 0U);
    ASSERT_TRUE(bus.connect());
    bus.engine.readdress(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<Readdressed>() == 1; }, 5s));
    bus.runFor(500ms);
    const std::size_t restarts = bus.count<ModuleRestarted>();
    from = bus.sent.size();
    bus.fault("module 1 silent");
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends(kQueryOfRestarted, from) > 0; }, 10s));
    ASSERT_TRUE(bus.stopAll());
    bus.runFor(5s);
    EXPECT_EQ(bus.count<ModuleRestarted>(), restarts);
}

TEST(F16_PowerCycledAtTheHigherRate, IsRecognisedAndTheBusGoesQuiet) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(500ms);
    const std::size_t from = bus.sent.size();
    bus.fault("module 2 powercycle");
    ASSERT_TRUE(bus.runUntil([&] { return restarted(bus, 1); }, 10s));
    bus.expectOnlyQuestions(from);
    // At the wrong rate it hears noise, which could become a command: nothing is sent to it any more.
    const std::size_t later = bus.sent.size();
    bus.runFor(2s);
    std::size_t toIt = 0;
    for (std::size_t i = later; i < bus.sent.size(); ++i)
        toIt += codeOf(bus.sent[i].bytes) && bus.sent[i].bytes[1] != 1 ? 1U : 0U;
    EXPECT_LT(toIt, 10U);
    EXPECT_FALSE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.executed(1, CommandCode::SetGain), 1U) << "the gains are not sent again";
}

/// This has happened: the motor's late answer to the last query by its address was taken for that of a module
/// that had lost it, and no stop reached the motor any more.
TEST(F16_LateAnswers, AreNoSignOfARestart) {
    for (int late = 10; late <= 150; ++late) {
        FaultyBus bus(servos(1), kFast);
        ASSERT_TRUE(bus.connectAndEnable());
        bus.fault("bus delay p=.5 t=" + std::to_string(late) + "ms for=1s");
        bus.runFor(2s);
        EXPECT_EQ(bus.count<ModuleRestarted>(), 0U) << late << " ms late";
    }
}

TEST(F16_PowerCycledAtTheHigherRate, IsLeftInPeace) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    bus.fault("module 2 powercycle");
    ASSERT_TRUE(bus.runUntil([&] { return restarted(bus, 1); }, 10s));
    bus.runFor(3s);  // the stop of the others takes at most 2 s
    const std::size_t from = bus.sent.size();
    bus.runFor(5s);
    EXPECT_EQ(bus.packets(from), 0U);
}

/// At their own rate, although the query to the restarted module was sent at 19 200 Bd.
TEST(F16_PowerCycledAtTheHigherRate, StopsTheOthers) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_EQ(bus.perform({loadVelocity(0, kOnePerTick, true)}), Outcome::Done);
    bus.runFor(500ms);
    bus.fault("module 2 powercycle");
    ASSERT_TRUE(bus.runUntil([&] { return restarted(bus, 1); }, 10s));
    const std::size_t from = bus.sent.size();
    bus.runFor(3s);
    EXPECT_LT(bus.packets(from), 10U) << "only the stop and the looks at the motor";
    EXPECT_TRUE(bus.stands(0));
    ASSERT_EQ(bus.count<StopFinished>(), 1U);
    EXPECT_TRUE(FaultyBus::stopped(*bus.last<StopFinished>(), 0));
}

/// It had been looked for in vain when its plug was loose.
TEST(F16_PowerCycledAtTheHigherRate, IsRecognisedAfterASilence) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    const std::size_t from = bus.sent.size();
    bus.fault("module 2 silent");
    const auto silent = [&] {
        const auto told = bus.last<ModuleUnresponsive>();
        return told && told->silent;
    };
    ASSERT_TRUE(bus.runUntil(silent, 10s));
    bus.runFor(2s);
    ASSERT_GT(bus.sends(kQueryOfRestarted, from), 0U);
    bus.clearFaults();
    ASSERT_TRUE(bus.runUntil([&] { return !silent(); }, 10s));
    bus.runFor(500ms);
    ASSERT_EQ(bus.count<ModuleRestarted>(), 0U);
    bus.fault("module 2 powercycle");
    EXPECT_TRUE(bus.runUntil([&] { return restarted(bus, 1); }, 10s));
}

TEST(F16_PowerCycledAtTheHigherRate, IsRecognisedAlthoughAStopCutsTheQueryOff) {
    FaultyBus bus(servos(2), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    const std::size_t from = bus.sent.size();
    bus.fault("module 2 powercycle");
    ASSERT_TRUE(bus.runUntil([&] { return bus.sends(kQueryOfRestarted, from) > 0; }, 10s));
    ASSERT_TRUE(bus.stopAll());
    EXPECT_TRUE(bus.runUntil([&] { return restarted(bus, 1); }, 10s));
}

// ---- F-37: two at one address ----

/// Their different positions give them away; their status bytes are the same.
TEST(F37_TwoModulesAtOneAddress, AreFoundWhenConnecting) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(4), EngineConfig{}, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
        bus.fault("module 2,3 sameaddr");
        const std::size_t from = bus.sent.size();
        EXPECT_FALSE(bus.connect());
        ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
        EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Collision);
        bus.expectOnlyQuestions(from);
    }
}

TEST(F37_TwoModulesAtOneAddress, MakeNoSampleWhenItHappensLater) {
    FaultyBus bus(servos(3), kFast);
    ASSERT_TRUE(bus.connectAndEnable());
    ASSERT_TRUE(Truth::spreadOut(bus));
    Truth truth(bus);
    bus.fault("module 2,3 sameaddr");
    bus.runFor(10s);
    truth.expectAllTrue();
}

// ---- F-38 ----

TEST(F38_AnswerToSetAddressLost, AtEveryPlaceOfALongChainGivesUniqueAddresses) {
    constexpr std::uint8_t kLongChain = 32;
    for (std::uint8_t place = 1; place <= kLongChain; ++place) {
        SCOPED_TRACE(int{place});
        FaultyBus bus(servos(kLongChain));
        bus.fault("module " + std::to_string(place) + (place % 2 == 0 ? " silent" : " drop status") +
                  " on=set_address n=1");
        ASSERT_TRUE(bus.restart());
        EXPECT_EQ(bus.struck(), 1U);
        ASSERT_EQ(bus.last<ChainFound>()->modules.size(), std::size_t{kLongChain});
        for (std::uint8_t i = 0; i < kLongChain; ++i)
            EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).address, i + 1);
    }
}

// ---- F-43 ----

TEST(F43_StatusItemsChangedByOthers, AreDefinedAnew) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        FaultyBus bus(servos(2), kFast, seed);
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
        Truth truth(bus);
        bus.fault("module 1 definestat");
        bus.runFor(5s);
        const std::size_t samples = bus.samplesOf(0);
        bus.runFor(1s);
        EXPECT_GT(bus.samplesOf(0), samples + 100);
        truth.expectAllTrue();
    }
}

// ---- F-44, F-48: groups ----

/// What another program may have left: addresses and groups that were given by hand.
void leaveGroups(FaultyBus& bus, const std::vector<std::uint8_t>& groupBytes) {
    for (std::uint8_t i = 0; i < groupBytes.size(); ++i) {
        const auto address = static_cast<std::uint8_t>(i + 1);
        const std::vector<std::uint8_t> body{0, 0x21, address, groupBytes[i]};
        std::vector<std::uint8_t> packet{kHeader};
        packet.insert(packet.end(), body.begin(), body.end());
        packet.push_back(sum8(body));
        bus.chain.hostSends(packet, bus.now);
        bus.runFor(20ms);
    }
}

TEST(F44_TwoLeadersOfAGroup, CannotBeMadeHere) {
    FaultyBus bus(servos(2));
    ASSERT_TRUE(bus.connectAndEnable());
    for (const std::uint8_t module : {std::uint8_t{0}, std::uint8_t{1}})
        EXPECT_EQ(bus.perform({toServo(module, SetAddress{BusAddress(static_cast<std::uint8_t>(module + 1)),
                                                          BusAddress(0x81), true})}),
                  Outcome::Forbidden);
}

TEST(F44_TwoLeadersOfAGroup, LeftByAnotherHostNeverAnswerAtOnce) {
    FaultyBus bus(servos(2));
    leaveGroups(bus, {0x7F, 0x7F});  // bit 7 cleared: leaders of group FF
    ASSERT_TRUE(bus.chain.snapshot(ModuleIndex(0), bus.now).leader);
    ASSERT_TRUE(bus.chain.snapshot(ModuleIndex(1), bus.now).leader);
    ASSERT_TRUE(bus.connect());
    // Both modules accept the same stop, which might be sent to both at once.
    ASSERT_EQ(bus.perform({gains(0), enable(0), gains(1), enable(1)}), Outcome::Done);
    bus.runFor(500ms);
    const auto stop = bus.stopAll();
    ASSERT_TRUE(stop);
    EXPECT_EQ(stop->stopped.size(), 2U);
    for (const sim::Violation& v : bus.chain.violations().entries())
        EXPECT_NE(v.kind, sim::ViolationKind::ReplyCollision) << toHex(v.bytes);
}

TEST(F48_ModuleThatTheResetDidNotReach, IsNeverMistakenForAnother) {
    for (const std::uint8_t farther : {std::uint8_t{0x91}, std::uint8_t{0xFF}}) {
        SCOPED_TRACE(int{farther});
        FaultyBus bus(servos(2));
        const std::uint8_t nearer = farther == 0xFF ? 0x91 : 0xFF;
        leaveGroups(bus, {farther, nearer});
        if (bus.restart()) {
            std::set<int> addresses;
            for (std::uint8_t i = 0; i < 2; ++i)
                addresses.insert(bus.chain.snapshot(ModuleIndex(i), bus.now).address);
            EXPECT_EQ(addresses, (std::set<int>{1, 2}));
            EXPECT_EQ(bus.last<ChainFound>()->modules.size(), 2U);
        } else {
            ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
            EXPECT_EQ(bus.last<ConnectFailed>()->reason, ConnectFailure::Collision);
        }
    }
}

}  // namespace

}  // namespace nmc::test

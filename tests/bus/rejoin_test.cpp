// SPDX-License-Identifier: GPL-3.0-or-later
// A chain in which one module has restarted: the modules are identified, and that one gets its address back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/rejoin.h"
#include "tests/bus/steps.h"
#include "tests/support/modules.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing_support::kServo;
using testing_support::kStep;

[[nodiscard]] ModuleInfo module(std::uint8_t index, std::uint8_t address, ModuleIdentity identity = kServo) {
    return {ModuleIndex(index), BusAddress(address), identity, std::nullopt};
}

TEST(Rejoin, KeepsThePlacesOfThoseBehindOneThatIsMissing) {
    const auto rejoined = rejoin({module(0, 1), module(1, 2), module(2, 3, kStep)},
                                 {module(0, 1), module(1, 3, kStep)}, kServo);
    ASSERT_TRUE(rejoined);
    ASSERT_EQ(rejoined->modules.size(), 3U);
    EXPECT_EQ(rejoined->modules[2], module(2, 3, kStep));
    EXPECT_THAT(rejoined->absent, ElementsAre(ModuleIndex(1)));
    EXPECT_EQ(rejoined->restarted, ModuleIndex(1));
}

TEST(Rejoin, DoesNotCallAModuleRestartedThatIsOfAnotherType) {
    const auto rejoined = rejoin({module(0, 1), module(1, 2)}, {module(0, 1)}, kStep);
    ASSERT_TRUE(rejoined);
    EXPECT_THAT(rejoined->absent, ElementsAre(ModuleIndex(1)));
    EXPECT_FALSE(rejoined->restarted) << "it may be a new one";
    EXPECT_FALSE(rejoin({module(0, 1), module(1, 2)}, {module(0, 1)}, std::nullopt)->restarted);
}

TEST(Rejoin, TakesAnotherChainAsItIs) {
    EXPECT_FALSE(rejoin({module(0, 1), module(1, 2)}, {module(0, 1, kStep)}, std::nullopt)) << "another type";
    EXPECT_FALSE(rejoin({module(0, 1)}, {module(0, 1), module(1, 2)}, std::nullopt)) << "one module more";
    EXPECT_FALSE(rejoin({}, {module(0, 1)}, std::nullopt)) << "nothing was known";
    EXPECT_FALSE(rejoin({module(0, 1)}, {}, kServo)) << "no module was found";
}

struct Case {
    std::uint32_t baud;
    bool deaf;  ///< a module stops listening when its ADDR_IN rises
    friend void PrintTo(const Case& c, std::ostream* stream) { *stream << c.baud << (c.deaf ? "Deaf" : ""); }
};

/// Three servos X, Y and Z with gains; X and Z are at 1 000 and 3 000 counts. Y has just lost its supply.
class YRestarted : public testing::TestWithParam<Case> {
public:
    static EngineConfig config() {
        EngineConfig c;
        c.baud = GetParam().baud;
        return c;
    }
    static sim::ChainOptions options() {
        sim::ChainOptions o;
        o.deafWhenAddressInputRises = GetParam().deaf;
        return o;
    }
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(moveAll());
        bus.chain.powerCycle(ModuleIndex(1), bus.now);
        bus.runFor(20ms);
    }
    void moveAll() {
        ASSERT_TRUE(bus.connect());
        for (std::uint8_t i = 0; i < 3; ++i)
            ASSERT_EQ(bus.perform({gains(i), enable(i), loadMove(i, 1'000 * (i + 1)), start(i)}),
                      Outcome::Done);
        bus.runFor(3s);
    }
    [[nodiscard]] bool scanAgain() { return bus.connect(); }
    [[nodiscard]] bool readdress() {
        bus.engine.readdress(ModuleIndex(1), bus.now);
        const auto over = [&] { return bus.count<Readdressed>() + bus.count<ReaddressFailed>() > 0; };
        return bus.runUntil(over, 5s) && bus.count<Readdressed>() == 1;
    }

    VirtualBus bus{servos(3), config(), options()};
};

TEST_P(YRestarted, DrivesZByZsControls) {
    ASSERT_TRUE(scanAgain());
    const auto found = *bus.last<ChainFound>();
    ASSERT_EQ(found.modules.size(), 3U);
    EXPECT_EQ(found.modules[2].address, BusAddress(3));
    EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(1)) << "the restarted module is reported";
    bus.runFor(2s);
    if (GetParam().deaf)
        return;  // Z cannot be heard before Y has its address
    EXPECT_THAT(found.absent, ElementsAre(ModuleIndex(1)));
    ASSERT_EQ(bus.perform({enable(2), loadMove(2, 3'500), start(2)}), Outcome::Done);
    bus.runFor(3s);
    EXPECT_NEAR(bus.servo(2).position, 3'500, 3) << "Z";
    EXPECT_NEAR(bus.servo(0).position, 1'000, 3) << "X";
    EXPECT_NE(bus.perform({gains(1), enable(1)}), Outcome::Done) << "Y has no address";
}

TEST_P(YRestarted, GivesYItsAddressAndLeavesTheOthersAlone) {
    ASSERT_TRUE(scanAgain());
    bus.runFor(1s);
    const std::size_t from = bus.sent.size();
    ASSERT_TRUE(readdress());
    EXPECT_EQ(bus.last<Readdressed>()->module.address, BusAddress(2));
    EXPECT_EQ(bus.last<Readdressed>()->module.group, GroupPlace{}) << "as after a restart";
    EXPECT_EQ(bus.sends("AA 00 21 02 FF 22", from), 1U) << "it is sent only once";
    EXPECT_EQ(bus.sends("AA FF 0F", from), 0U) << "no module is reset";
    bus.runFor(6s);
    for (std::uint8_t i = 0; i < 3; ++i) {
        EXPECT_EQ(bus.chain.snapshot(ModuleIndex(i), bus.now).address, i + 1);
        EXPECT_GE(bus.lastSample(i)->time, bus.now - 1s) << "module " << int{i} << " is live";
    }
    EXPECT_EQ(bus.servo(0).gains.kp, 200);
    EXPECT_EQ(bus.servo(2).gains.kp, 200);
    EXPECT_NEAR(bus.servo(0).position, 1'000, 3);
    EXPECT_NEAR(bus.servo(2).position, 3'000, 3);
    EXPECT_EQ(bus.servo(1).gains.kp, 0) << "N1: its lost gains are not sent again without a request";
    EXPECT_FALSE(bus.servo(1).servoOn);
    ASSERT_EQ(bus.perform({gains(1), enable(1), loadMove(1, 500), start(1)}), Outcome::Done);
    bus.runFor(3s);
    EXPECT_NEAR(bus.servo(1).position, 500, 3);
}

TEST_P(YRestarted, IsToldFromTheChainThatWasKnownWhenTheProgramIsNew) {
    EngineConfig known = config();
    known.known = bus.last<ChainFound>()->modules;
    bus.newHost(known);
    ASSERT_TRUE(scanAgain());
    ASSERT_EQ(bus.last<ChainFound>()->modules.size(), 3U);
    EXPECT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(1));
    EXPECT_TRUE(readdress());
}

TEST_P(YRestarted, GivesNoAddressWhileAMotorMoves) {
    ASSERT_TRUE(scanAgain());
    ASSERT_EQ(bus.perform({enable(0), loadVelocity(0, 65'536, true)}), Outcome::Done);
    bus.runFor(200ms);
    const std::size_t from = bus.sent.size();
    EXPECT_FALSE(readdress());
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::NotNow);
    EXPECT_EQ(bus.sends("AA 00 21", from), 0U);
}

/// At a quarter of a count per tick, three of four replies have a velocity of 0.
TEST_P(YRestarted, GivesNoAddressWhileAMotorCreeps) {
    ASSERT_TRUE(scanAgain());
    ASSERT_EQ(bus.perform({enable(0), loadVelocity(0, 16'384, true)}), Outcome::Done);
    const std::size_t from = bus.sent.size();
    for (unsigned look = 1; look <= 10; ++look) {
        bus.runFor(200ms + look * 1ms);
        bus.engine.readdress(ModuleIndex(1), bus.now);
        bus.runFor(1ms);
        EXPECT_EQ(bus.count<ReaddressFailed>(), look);
    }
    EXPECT_EQ(bus.sends("AA 00 21", from), 0U);
}

/// A busy computer sometimes reads an answer too late.
TEST_P(YRestarted, IsAskedAgainWhereAnAnswerIsLost) {
    ASSERT_TRUE(scanAgain());
    bus.runFor(1s);
    int lost = 0;
    bus.losesReply = [&lost](ByteSpan command) {
        const bool looks = command.size() > 2 && command[1] == 2 && (command[2] & 0x0FU) == 0x03;
        return looks && lost++ < 2;
    };
    EXPECT_TRUE(readdress());
    EXPECT_GE(lost, 3) << "two lost answers, and a third query";
    EXPECT_EQ(bus.last<Readdressed>()->module.address, BusAddress(2));
}

TEST_P(YRestarted, SaysWhenItDoesNotAnswer) {
    ASSERT_TRUE(scanAgain());
    bus.runFor(1s);
    bus.losesReply = [](ByteSpan command) {
        return command.size() > 1 && command[1] <= 2 && command[1] != 1;
    };
    EXPECT_FALSE(readdress());
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::NoAnswer);
    EXPECT_EQ(bus.hostBaud, GetParam().baud) << "the port is back where the others listen";
    const std::size_t samples = bus.samplesOf(0);
    bus.runFor(1s);
    EXPECT_GT(bus.samplesOf(0), samples);
}

INSTANTIATE_TEST_SUITE_P(Rates, YRestarted,
                         testing::Values(Case{19'200, false}, Case{19'200, true}, Case{57'600, false},
                                         Case{115'200, false}, Case{115'200, true}),
                         testing::PrintToStringParamName());

/// The same chain, with Y being reset on purpose (DS-V 5.2 Hard Reset).
class YIsReset : public YRestarted {
public:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(moveAll()); }
    [[nodiscard]] bool reset() {
        bus.engine.resetModule(ModuleIndex(1), bus.now);
        const auto over = [&] { return bus.count<Readdressed>() + bus.count<ReaddressFailed>() > 0; };
        return bus.runUntil(over, 5s) && bus.count<Readdressed>() == 1;
    }
};

TEST_P(YIsReset, AndTheOthersKeepWhatTheyHave) {
    ASSERT_TRUE(reset());
    EXPECT_EQ(bus.count<ModuleRestarted>(), 1U);
    bus.runFor(1s);
    EXPECT_FALSE(bus.servo(1).servoOn);
    EXPECT_EQ(bus.servo(1).position, 0);
    for (const std::uint8_t i : {std::uint8_t{0}, std::uint8_t{2}}) {
        EXPECT_TRUE(bus.servo(i).servoOn);
        EXPECT_NEAR(bus.servo(i).position, 1'000 * (i + 1), 3);
    }
    EXPECT_EQ(bus.perform({gains(1), enable(1), loadMove(1, 500), start(1)}), Outcome::Done);
    bus.runFor(2s);
    EXPECT_NEAR(bus.servo(1).position, 500, 3);
    bus.expectNoViolations();
}

TEST_P(YIsReset, NotWhileAnythingMoves) {
    ASSERT_EQ(bus.perform({loadVelocity(2, 65'536, true)}), Outcome::Done);
    bus.runFor(200ms);
    EXPECT_FALSE(reset());
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::NotNow);
    EXPECT_NEAR(bus.servo(1).position, 2'000, 3);
}

/// Y would take the address that Z loses: each axis would drive the other's motor.
TEST_P(YIsReset, NotWhileAnotherModuleHasNoAddress) {
    bus.chain.powerCycle(ModuleIndex(1), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }, 10s));
    ASSERT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(1));
    const std::size_t from = bus.sent.size();
    bus.engine.resetModule(ModuleIndex(2), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ReaddressFailed>() == 1; }, 5s));
    const bool asked = GetParam().baud == 19'200 && !GetParam().deaf;  // otherwise Z does not answer
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason,
              asked ? ReaddressFailed::Reason::Unaddressed : ReaddressFailed::Reason::NotNow);
    bus.runFor(1s);
    EXPECT_EQ(bus.sends("AA 03 0F", from), 0U);
    EXPECT_EQ(bus.sends("AA 00 21", from), 0U);
    EXPECT_EQ(bus.chain.snapshot(ModuleIndex(1), bus.now).address, 0);
    EXPECT_EQ(bus.chain.snapshot(ModuleIndex(2), bus.now).address, 3);
}

TEST_P(YIsReset, AndAStopComesFirst) {
    bus.engine.resetModule(ModuleIndex(1), bus.now);
    bus.runFor(5ms);
    bus.engine.stopAll(bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<StopFinished>() > 0; }, 10s));
    EXPECT_EQ(bus.count<Readdressed>() + bus.count<ReaddressFailed>(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Chains, YIsReset,
                         testing::Values(Case{19'200, false}, Case{19'200, true}, Case{115'200, false},
                                         Case{115'200, true}));

/// The farthest and the nearest module have no address, and both listen: each would take it.
TEST(AddressOfOne, IsNotGivenWhileTwoWouldTakeIt) {
    VirtualBus bus({kServo, kServo, kStep});
    ASSERT_TRUE(bus.connect());
    bus.chain.powerCycle(ModuleIndex(0), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ModuleRestarted>() == 1; }, 10s));
    ASSERT_EQ(bus.last<ModuleRestarted>()->module, ModuleIndex(0));
    bus.chain.powerCycle(ModuleIndex(2), bus.now);
    const std::size_t from = bus.sent.size();
    bus.engine.readdress(ModuleIndex(0), bus.now);
    ASSERT_TRUE(bus.runUntil([&] { return bus.count<ReaddressFailed>() == 1; }, 5s));
    EXPECT_EQ(bus.last<ReaddressFailed>()->reason, ReaddressFailed::Reason::Unaddressed);
    EXPECT_EQ(bus.sends("AA 00 21", from), 0U);
}

}  // namespace

}  // namespace nmc::test

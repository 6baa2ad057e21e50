// SPDX-License-Identifier: GPL-3.0-or-later
// Operations on the whole chain, from the GUI thread to the simulator and back: groups, and another rate.
#include <gtest/gtest.h>

#include "tests/link/connection/virtualconnection.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace Qt::StringLiterals;

class Chainwide : public testing::Test {
protected:
    void SetUp() override {
        connection.open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    }
    void TearDown() override { EXPECT_EQ(sim.violations(), ""); }

    [[nodiscard]] bus::Outcome carryOut(std::variant<bus::GroupChange, bus::GroupCommand> what) {
        connection.forgetNews();
        connection.worker().ask(bus::GroupOperation{bus::OperationId(++lastId), what});
        if (!connection.waitFor<bus::GroupFinished>())
            return bus::Outcome::Cancelled;
        return connection.news<bus::GroupFinished>()->outcome;
    }

    VirtualChain sim{u"servo,servo"_s};
    VirtualConnection connection{sim};
    std::uint32_t lastId = 1'000;
};

TEST_F(Chainwide, GroupsStartTogetherAndTheStoreKnowsThem) {
    EXPECT_EQ(connection.module(0).info.group, bus::GroupPlace{})
        << "after a reset, it is in the group of all";
    for (const std::uint8_t module : {std::uint8_t{0}, std::uint8_t{1}}) {
        ASSERT_EQ(connection.carryOut(gainsAndEnable(module)), bus::Outcome::Done);
        ASSERT_EQ(carryOut(bus::GroupChange{ModuleIndex(module), {0x81, module == 1}}), bus::Outcome::Done);
        ASSERT_EQ(connection.carryOut({move(module, 2'000).front()}), bus::Outcome::Done);
    }
    EXPECT_EQ(connection.module(1).info.group, (bus::GroupPlace{0x81, true}));
    EXPECT_EQ(sim.state(2)[u"group"_s].toInt(), 0x81);
    EXPECT_TRUE(sim.state(2)[u"leader"_s].toBool());
    EXPECT_TRUE(connection.module(0).loadWaiting);
    ASSERT_EQ(carryOut(bus::GroupCommand{0x81, bus::GroupCommand::Action::StartMotion}), bus::Outcome::Done);
    EXPECT_FALSE(connection.module(0).loadWaiting);
    for (const int number : {1, 2})
        EXPECT_TRUE(connection.waitUntil(
            [&] { return std::abs(sim.state(number)[u"position"_s].toInt() - 2'000) <= 5; }));
}

TEST_F(Chainwide, AGroupStopsAtOnceAndSoDoesTheStore) {
    for (const std::uint8_t module : {std::uint8_t{0}, std::uint8_t{1}}) {
        ASSERT_EQ(connection.carryOut(gainsAndEnable(module)), bus::Outcome::Done);
        ASSERT_EQ(carryOut(bus::GroupChange{ModuleIndex(module), {0xA0, module == 0}}), bus::Outcome::Done);
        ASSERT_EQ(connection.carryOut({move(module, 2'000'000).front()}), bus::Outcome::Done);
    }
    ASSERT_EQ(carryOut(bus::GroupCommand{0xA0, bus::GroupCommand::Action::StartMotion}), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return sim.state(2)[u"position"_s].toInt() > 100; }));
    ASSERT_EQ(carryOut(bus::GroupCommand{0xA0, bus::GroupCommand::Action::StopAbruptly}), bus::Outcome::Done);
    EXPECT_TRUE(connection.waitUntil([&] { return connection.count<bus::OwedStopConfirmed>() == 2; }));
    const int place = sim.state(2)[u"position"_s].toInt();
    EXPECT_TRUE(connection.waitUntil([&] { return !connection.module(1).moving(); }));
    EXPECT_NEAR(sim.state(2)[u"position"_s].toInt(), place, 5);
    EXPECT_TRUE(sim.state(2)[u"servo_on"_s].toBool());
}

TEST_F(Chainwide, AModuleTakesAnotherAddressAndTheStoreKnowsIt) {
    connection.worker().ask(Readdress{ModuleIndex(1), BusAddress(77)});
    ASSERT_TRUE(connection.waitFor<bus::AddressChanged>());
    EXPECT_EQ(connection.module(1).info.address, BusAddress(77));
    EXPECT_EQ(sim.state(2)[u"address"_s].toInt(), 77);
    EXPECT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    connection.worker().ask(Readdress{ModuleIndex(1), BusAddress(1)});
    ASSERT_TRUE(connection.waitFor<bus::ReaddressFailed>());
    EXPECT_EQ(connection.news<bus::ReaddressFailed>()->reason, bus::ReaddressFailed::Reason::Taken);
}

TEST_F(Chainwide, RateChangesWhileTheMotorsHold) {
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    for (const std::uint32_t baud : {115'200U, 57'600U}) {
        connection.forgetNews();
        connection.worker().ask(ChangeRate{baud});
        ASSERT_TRUE(connection.waitFor<bus::RateChanged>());
        EXPECT_EQ(connection.store().link().baud, baud);
        EXPECT_NEAR(sim.state(1)[u"baud"_s].toInt(), static_cast<int>(baud), 0.02 * baud);
        EXPECT_TRUE(sim.state(1)[u"servo_on"_s].toBool());
        const auto before = connection.worker().statistics().answered;
        EXPECT_TRUE(
            connection.waitUntil([&] { return connection.worker().statistics().answered > before + 50; }));
    }
    EXPECT_EQ(connection.count<bus::ModuleUnresponsive>(), 0);
}

TEST_F(Chainwide, AModuleThatRestartsGoesSilentWhileTheOthersGoOn) {
    sim.tell("power-cycle 2");  // the module nearest the host: no other one depends on its ADDR_OUT
    ASSERT_TRUE(connection.waitFor<bus::ModuleUnresponsive>());
    EXPECT_EQ(connection.news<bus::ModuleUnresponsive>()->module, ModuleIndex(1));
    EXPECT_EQ(connection.module(1).activity(), Activity::Unresponsive);
    EXPECT_NE(connection.module(0).activity(), Activity::Unresponsive);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/connection/busworker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/link/connection/virtualconnection.h"
#include "tests/support/leaverunning.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

class OnAChain : public testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(sim.violations(), ""); }

    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualConnection connection{sim};
};
using BusWorkerTest = OnAChain;
using BusStoreTest = OnAChain;

TEST_F(BusWorkerTest, RunsAChainInThisProcess) {
    connection.open(115'200);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    EXPECT_EQ(connection.news<bus::ChainFound>()->baud, 115'200U);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 2'000)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return !connection.module(0).moving(); }));
    EXPECT_TRUE(
        connection.waitUntil([&] { return std::abs(*connection.module(0).latest->position - 2'000) <= 5; }));
    const ModuleHistory* history = connection.store().history().module(ModuleIndex(0));
    ASSERT_NE(history, nullptr);
    EXPECT_GT(history->count(), 20U);
    EXPECT_EQ(history->last()->command(), 2'000);
}

TEST_F(BusWorkerTest, DoesNotNeedTheGuiThreadToPollOrToStop) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    // From here on, no event loop runs in this thread.
    const std::uint64_t before = connection.worker().statistics().answered;
    connection.freeze(1s);
    EXPECT_GE(connection.worker().statistics().answered, before + 20);
    (void)connection.worker().takeEvents();
    connection.worker().stopAll();
    connection.freeze(1s);
    const std::vector<WorkerEvent> told = connection.worker().takeEvents();
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const WorkerEvent& event) {
        const auto* busEvent = std::get_if<bus::Event>(&event);
        return busEvent != nullptr && std::holds_alternative<bus::StopFinished>(*busEvent);
    }));
}

TEST_F(BusWorkerTest, StopsTheMotorsBeforeItCloses) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 2'000'000)), bus::Outcome::Done);
    connection.forgetNews();
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_NE(connection.news<bus::StopFinished>(), nullptr);
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 2U);
    EXPECT_FALSE(connection.worker().isOpen());
    EXPECT_FALSE(sim.driven(0));
}

/// Another program has left a motor running, and the window is closed before the chain is found: the motor is
/// stopped as soon as it is found, and only then is the port closed.
TEST(BusWorker, StopsAMotorThatItHasOnlySeenBeforeItCloses) {
    VirtualChain sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(leaveRunning(sim, 1, 1));
    VirtualConnection connection(sim);
    connection.open();
    // The first module has answered, in the middle of the search for others.
    ASSERT_TRUE(connection.waitUntil([&] { return connection.store().link().found > 0; }));
    EXPECT_TRUE(sim.driven(0));
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_NE(connection.news<bus::StopFinished>(), nullptr);
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_FALSE(sim.driven(0));
}

TEST_F(BusWorkerTest, CanBeOpenedAgainAndDestroyedWhileOpen) {
    for (int i = 0; i < 3; ++i) {
        connection.forgetNews();
        connection.open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        connection.worker().close();
        ASSERT_TRUE(connection.waitFor<PortClosed>());
    }
    connection.open();
}

TEST_F(BusWorkerTest, HasTheSimulatorAnswerControlLines) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    connection.worker().ask(ControlLine{"set 2 power 0"});
    ASSERT_TRUE(connection.waitFor<SimulatorAnswered>());
    EXPECT_EQ(connection.news<SimulatorAnswered>()->line, "set 2 power 0");
    EXPECT_EQ(connection.news<SimulatorAnswered>()->json, R"({"ok":true})");
    EXPECT_TRUE(connection.waitUntil([&] { return connection.module(1).activity() == Activity::NoPower; }))
        << "the status shows what was set at the bench";
    connection.forgetNews();
    connection.worker().ask(ControlLine{"set 9 power 0"});
    ASSERT_TRUE(connection.waitFor<SimulatorAnswered>());
    EXPECT_NE(connection.news<SimulatorAnswered>()->json.find("error"), std::string::npos);
}

TEST_F(BusWorkerTest, GivesOneModuleTheBusForAsLongAsItIsWanted) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    connection.worker().setRecording(true);
    // True if a Read Status of exactly these items was sent.
    const auto asked = [&](std::uint8_t items) {
        const auto records = connection.worker().takeRecords();
        return std::any_of(records.begin(), records.end(), [items](const bus::ExchangeRecord& record) {
            return record.command.size() == 5 && record.command[2] == 0x13 && record.command[3] == items;
        });
    };
    connection.worker().focus(ModuleIndex(0));
    EXPECT_TRUE(connection.waitUntil([&] { return asked(StatusItems::Position); }));
    connection.worker().focus(std::nullopt);
    connection.freeze(3s);  // it would end automatically after 5 s
    EXPECT_TRUE(asked(StatusItems::All)) << "all items are requested again";
}

TEST_F(BusWorkerTest, RestartFindsTheChainAnew) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_TRUE(connection.module(0).gains.has_value());
    connection.forgetNews();
    connection.worker().restart();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    EXPECT_FALSE(connection.module(0).gains.has_value()) << "a restarted module has lost them";
}

TEST_F(BusWorkerTest, RecordsNothingUnlessAsked) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    EXPECT_TRUE(connection.worker().takeRecords().empty());
}

TEST_F(BusWorkerTest, RecordsEveryExchangeWhileAsked) {
    connection.worker().setRecording(true);
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    std::vector<bus::ExchangeRecord> records = connection.worker().takeRecords();
    ASSERT_FALSE(records.empty());
    EXPECT_EQ(records.front().number, 1U) << "the first packet of the connection is recorded";
    EXPECT_EQ(records.front().purpose, bus::Purpose::Connect);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    records = connection.worker().takeRecords();
    const auto gains = [](const bus::ExchangeRecord& r) {
        return r.command.size() > 2 && r.command[2] == 0xE6;
    };
    EXPECT_EQ(std::count_if(records.begin(), records.end(), gains), 1);
    // After switching it off, an exchange that is in progress may still be recorded, but no later one.
    connection.worker().setRecording(false);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    (void)connection.worker().takeRecords();
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    EXPECT_TRUE(connection.worker().takeRecords().empty());
}

/// A module that answers at its address has not restarted: it still has the gains that it was sent, and the
/// position at which it holds is known.
TEST_F(BusStoreTest, KeepsWhatModulesWereToldThatAreFoundAgain) {
    connection.open(115'200);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 500)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return connection.module(0).activity() == Activity::Holding; }));
    const auto gains = connection.module(0).gains;
    connection.forgetNews();
    connection.worker().connectAgain();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    EXPECT_TRUE(connection.news<bus::ChainFound>()->attached);
    EXPECT_EQ(connection.module(0).gains, gains);
    EXPECT_EQ(connection.module(0).servoRate, gains->sr);
    EXPECT_EQ(connection.module(0).goal(), 500);
    EXPECT_FALSE(connection.module(1).gains) << "it was never sent any";
    const ModuleHistory* history = connection.store().history().module(ModuleIndex(0));
    const auto before = history->count();
    ASSERT_TRUE(connection.waitUntil([&] { return history->count() > before + 3; }));
    EXPECT_EQ(history->last()->command(), 500);
}

/// Nobody finds out whether the module has carried out what a stop of all motors overtook.
TEST_F(BusStoreTest, AStopOvertakesAStopHereAndTheScopeDoesNotClaimToKnowTheError) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    const ModuleHistory* history = connection.store().history().module(ModuleIndex(0));
    ASSERT_TRUE(connection.waitUntil([&] { return history->count() > 0 && history->last()->errorKnown(); }));
    sim.tell("fault module 1 silent on=stop_motor n=1");
    connection.forgetNews();
    connection.submit(
        {{ModuleIndex(0), ServoCommand(servo::StopMotor{true, servo::StopManner::Here, Counts(100)})}});
    connection.freeze(15ms);
    connection.worker().stopAll();
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    ASSERT_TRUE(connection.waitUntil([&] { return std::abs(history->last()->position - 100) <= 5; }));
    ASSERT_TRUE(connection.waitUntil([&] { return !connection.module(0).moving(); }));
    EXPECT_TRUE(!history->last()->errorKnown() || std::abs(history->last()->error) <= 5)
        << history->last()->error;
}

TEST_F(BusStoreTest, FiguresAreRatesSinceTheLastPull) {
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    (void)connection.store().pullFigures(TimePoint(std::chrono::seconds(10)));
    const std::uint64_t before = connection.worker().statistics().answered;
    ASSERT_TRUE(
        connection.waitUntil([&] { return connection.worker().statistics().answered >= before + 30; }));
    const std::uint64_t least = connection.worker().statistics().answered - before;
    const LinkFigures figures = connection.store().pullFigures(TimePoint(std::chrono::seconds(12)));
    EXPECT_GE(figures.exchangesPerSecond, static_cast<double>(least) / 2.0 - 1.0);
    EXPECT_GT(figures.meanRoundTripMs, 0.0);
    EXPECT_EQ(figures.errors, 0U);
    EXPECT_GE(figures.counters.answered, before + 30);
}

}  // namespace
}  // namespace nmc

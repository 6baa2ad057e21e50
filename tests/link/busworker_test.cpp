// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/connection/busworker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "link/connection/simulatortransport.h"
#include "tests/link/connection.h"
#include "tests/link/otherhost.h"

namespace nmc {
namespace {

using namespace testing_support;

BusWorker::TransportFactory simulator(int modules) {
    return [modules] {
        return std::make_unique<SimulatorTransport>(
            std::vector<ModuleIdentity>(static_cast<std::size_t>(modules), {ModuleType::Servo, 4}));
    };
}

TEST(BusWorker, RunsAChainInThisProcess) {
    Connection connection;
    connection.open(simulator(2), 115'200);
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

TEST(BusWorker, DoesNotNeedTheGuiThreadToPollOrToStop) {
    Connection connection;
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    // No event loop turns in this thread from here on.
    const std::uint64_t before = connection.worker().statistics().answered;
    while (connection.worker().statistics().answered < before + 20)
        std::this_thread::yield();
    connection.worker().stopAll();
    bool stopped = false;
    while (!stopped)
        for (const WorkerEvent& event : connection.worker().takeEvents())
            if (const auto* busEvent = std::get_if<bus::Event>(&event))
                stopped = stopped || std::holds_alternative<bus::StopFinished>(*busEvent);
}

TEST(BusWorker, StopsTheMotorsBeforeItCloses) {
    Connection connection;
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 2'000'000)), bus::Outcome::Done);
    connection.forgetNews();
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_NE(connection.news<bus::StopFinished>(), nullptr);
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_FALSE(connection.worker().isOpen());
}

/// A motor that another program left running, and a window that is closed before the chain is found: as soon
/// as it is, it is told to stop, and only then the port is let go.
TEST(BusWorker, StopsAMotorThatItHasOnlySeenBeforeItCloses) {
    NmcsimProcess sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(leaveRunning(sim, 1, 1));
    const auto runs = [&sim] {
        return std::abs(sim.state(1)[QStringLiteral("command_velocity")].toDouble()) > 0.01;
    };
    ASSERT_TRUE(runs());
    Connection connection;
    connection.openSerial(sim.terminal());
    // Its first answer, in the middle of the search for the others.
    ASSERT_TRUE(connection.waitUntil([&] { return connection.store().link().found > 0; }));
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_NE(connection.news<bus::StopFinished>(), nullptr);
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_FALSE(runs());
}

TEST(BusWorker, CanBeOpenedAgainAndDestroyedWhileOpen) {
    Connection connection;
    for (int i = 0; i < 3; ++i) {
        connection.forgetNews();
        connection.open(simulator(1));
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        connection.worker().close();
        ASSERT_TRUE(connection.waitFor<PortClosed>());
    }
    connection.open(simulator(1));
}

TEST(BusWorker, HasTheSimulatorAnswerControlLines) {
    Connection connection;
    connection.open(simulator(2));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    connection.worker().control("set 2 power 0");
    ASSERT_TRUE(connection.waitFor<SimulatorAnswered>());
    EXPECT_EQ(connection.news<SimulatorAnswered>()->line, "set 2 power 0");
    EXPECT_EQ(connection.news<SimulatorAnswered>()->json, R"({"ok":true})");
    EXPECT_TRUE(connection.waitUntil([&] { return connection.module(1).activity() == Activity::NoPower; }))
        << "the wire says what the bench did";
    connection.forgetNews();
    connection.worker().control("set 9 power 0");
    ASSERT_TRUE(connection.waitFor<SimulatorAnswered>());
    EXPECT_NE(connection.news<SimulatorAnswered>()->json.find("error"), std::string::npos);
}

TEST(BusWorker, ARealPortNeitherHearsNorAnswersControlLines) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Connection connection;
    connection.openSerial(sim.terminal());
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    connection.worker().control("set 2 power 0");
    // The line was in the queue before the gains, so it has had its turn.
    ASSERT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    EXPECT_EQ(connection.count<SimulatorAnswered>(), 0);
    EXPECT_TRUE(sim.state(2)[QStringLiteral("power")].toBool());
    EXPECT_EQ(sim.violations(), "");
}

TEST(BusWorker, GivesOneModuleTheBusForAsLongAsItIsWanted) {
    Connection connection;
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    connection.worker().setRecording(true);
    // Read Status of these items only.
    const auto asked = [&](std::uint8_t items) {
        const auto records = connection.worker().takeRecords();
        return std::any_of(records.begin(), records.end(), [items](const bus::ExchangeRecord& record) {
            return record.command.size() == 5 && record.command[2] == 0x13 && record.command[3] == items;
        });
    };
    connection.worker().focus(ModuleIndex(0));
    EXPECT_TRUE(connection.waitUntil([&] { return asked(StatusItems::Position); }));
    connection.worker().focus(std::nullopt);
    // Sooner than it would end by itself.
    EXPECT_TRUE(connection.waitUntil([&] { return asked(StatusItems::All); }, 3'000)) << "in full again";
}

TEST(BusWorker, RestartFindsTheChainAnew) {
    Connection connection;
    connection.open(simulator(2));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_TRUE(connection.module(0).gains.has_value());
    connection.forgetNews();
    connection.worker().restart();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    EXPECT_FALSE(connection.module(0).gains.has_value()) << "a restarted module has lost them";
}

TEST(BusWorker, RecordsNothingUnlessAsked) {
    Connection connection;
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    EXPECT_TRUE(connection.worker().takeRecords().empty());
}

TEST(BusWorker, RecordsEveryExchangeWhileAsked) {
    Connection connection;
    connection.worker().setRecording(true);
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    std::vector<bus::ExchangeRecord> records = connection.worker().takeRecords();
    ASSERT_FALSE(records.empty());
    EXPECT_EQ(records.front().number, 1U) << "the first packet of the connection is there";
    EXPECT_EQ(records.front().purpose, bus::Purpose::Connect);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    records = connection.worker().takeRecords();
    const auto gains = [](const bus::ExchangeRecord& r) {
        return r.command.size() > 2 && r.command[2] == 0xE6;
    };
    EXPECT_EQ(std::count_if(records.begin(), records.end(), gains), 1);
    // Off: what is under way may still come, and nothing after it.
    connection.worker().setRecording(false);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    (void)connection.worker().takeRecords();
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    EXPECT_TRUE(connection.worker().takeRecords().empty());
}

/// One that answers at its address has not restarted: it has the gains that it was sent, and where it holds
/// is known.
TEST(BusStore, KeepsWhatModulesWereToldThatAreFoundAgain) {
    Connection connection;
    connection.open(simulator(2), 115'200);
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

TEST(BusStore, FiguresAreRatesSinceTheLastPull) {
    Connection connection;
    connection.open(simulator(1));
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    (void)connection.store().pullFigures(TimePoint(std::chrono::seconds(10)));
    const std::uint64_t before = connection.worker().statistics().answered;
    while (connection.worker().statistics().answered < before + 30)
        std::this_thread::yield();
    const std::uint64_t least = connection.worker().statistics().answered - before;
    const LinkFigures figures = connection.store().pullFigures(TimePoint(std::chrono::seconds(12)));
    EXPECT_GE(figures.exchangesPerSecond, static_cast<double>(least) / 2.0 - 1.0);
    EXPECT_GT(figures.meanRoundTripMs, 0.0);
    EXPECT_EQ(figures.errors, 0U);
    EXPECT_GE(figures.counters.answered, before + 30);
}

}  // namespace
}  // namespace nmc

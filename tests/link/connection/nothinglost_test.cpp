// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is lost between two threads, whatever one does while the other stands still.
#include <gtest/gtest.h>

#include <map>

#include "tests/link/connection/virtualconnection.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr std::uint32_t kFlood = 3'000;  // three times what the queue holds

class NothingLost : public testing::Test {
protected:
    void open() {
        bus::EngineConfig config;
        config.holdTimeout = std::chrono::hours(1);
        connection.open(config);
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    }

    /// The number of times that each operation has ended.
    std::map<std::uint32_t, int> endings() {
        std::map<std::uint32_t, int> ends;
        connection.forEach<bus::OperationFinished>(
            [&ends](const bus::OperationFinished& finished) { ++ends[finished.id.value()]; });
        return ends;
    }
    /// The bus thread stands still in the meantime: time passes for it only while this thread waits.
    void flood() {
        for (std::uint32_t i = 0; i < kFlood; ++i)
            connection.submit({bus::Order{ModuleIndex(0), ServoCommand(Nop{})}});
    }
    void expectEachEndedOnce() {
        EXPECT_TRUE(connection.waitUntil([this] { return endings().size() == kFlood; }))
            << endings().size() << " of " << kFlood;
        for (const auto& [id, times] : endings())
            EXPECT_EQ(times, 1) << "operation " << id;
    }

    VirtualChain sim{QStringLiteral("servo")};
    VirtualConnection connection{sim};
};

TEST_F(NothingLost, WhatIsOneTooManyIsRefusedAndEveryOperationEndsOnce) {
    open();
    flood();
    expectEachEndedOnce();
}

TEST_F(NothingLost, OperationsEndWhenThePortIsGone) {
    open();
    flood();
    sim.unplug();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    expectEachEndedOnce();
}

TEST_F(NothingLost, OperationsEndWhenNothingIsConnected) {
    flood();
    expectEachEndedOnce();
}

TEST_F(NothingLost, AReleaseIsHeardBehindAnyNumberOfRequests) {
    open();
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    bus::HoldToMove hold;
    hold.velocity = CountsPerTick(4 << 16);
    hold.acceleration = CountsPerTickSquared(1'311);
    connection.worker().hold(hold);
    ASSERT_TRUE(
        connection.waitUntil([this] { return connection.module(0).activity() == Activity::AtSpeed; }));
    connection.worker().release();
    flood();
    EXPECT_TRUE(connection.waitUntil([this] { return connection.module(0).activity() == Activity::Holding; }))
        << "nothing else ends this motion within an hour";
}

TEST_F(NothingLost, ARateThatCannotBeAskedForIsRefused) {
    connection.worker().ask(ChangeRate{115'200});
    ASSERT_TRUE(connection.waitFor<bus::RateChangeFailed>());
    EXPECT_EQ(connection.news<bus::RateChangeFailed>()->reason, bus::RateChangeFailed::Reason::NotNow);
    EXPECT_EQ(connection.news<bus::RateChangeFailed>()->wanted, 115'200U);
}

/// F-27: one cause gives one message, and the port stays open for another attempt as long as it exists.
TEST_F(NothingLost, NobodyAnsweringIsSaidAndSoIsThePortThatGoesThenOnce) {
    sim.tell("fault bus silent");
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ConnectFailed>());
    EXPECT_EQ(connection.news<bus::ConnectFailed>()->reason, bus::ConnectFailure::NobodyAnswers);
    EXPECT_TRUE(connection.worker().isOpen());
    sim.unplug();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_TRUE(connection.news<PortClosed>()->error.has_value());
    EXPECT_EQ(connection.news<PortClosed>()->error->problem, PortProblem::Gone);
    EXPECT_FALSE(connection.worker().isOpen());
    EXPECT_EQ(connection.count<PortClosed>(), 1);
    EXPECT_EQ(connection.count<bus::LinkLost>(), 0);
    EXPECT_EQ(connection.count<bus::ModuleUnresponsive>(), 0);
}

/// Counters start again with the chain; the next figures must not contain a rate of 1.8e19.
TEST_F(NothingLost, FiguresBehindANewSearchAreNoUnderflow) {
    open();
    using std::chrono::seconds;
    connection.worker().ask(ControlLine{"fault bus drop status n=3"});
    const auto errors = [this] { return connection.worker().statistics().errors(); };
    ASSERT_TRUE(connection.waitUntil([&errors] { return errors() >= 3; }));
    (void)connection.store().pullFigures(TimePoint(seconds(10)));
    const std::uint64_t answered = connection.worker().statistics().answered;
    connection.forgetNews();
    connection.worker().connectAgain();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    const auto counters = [this] { return connection.worker().statistics(); };
    ASSERT_TRUE(connection.waitUntil([&] { return counters().answered > answered; }));
    const LinkFigures figures = connection.store().pullFigures(TimePoint(seconds(11)));
    EXPECT_LE(figures.errorsPerSecond, static_cast<double>(figures.errors));
    EXPECT_GE(figures.exchangesPerSecond, static_cast<double>(answered));
    EXPECT_GE(figures.meanRoundTripMs, 0.0);
}

}  // namespace
}  // namespace nmc

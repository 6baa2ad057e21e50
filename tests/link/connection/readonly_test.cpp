// SPDX-License-Identifier: GPL-3.0-or-later
// H-02: a read-only connection. What another program has set in motion runs on through everything that stops
// motors elsewhere; the simulator is the witness.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <atomic>

#include "tests/link/changes.h"
#include "tests/link/connection/virtualconnection.h"
#include "tests/support/leaverunning.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

class H02_ReadOnly : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(leaveRunning(sim, 2, 8));
        before = changes(sim);
    }
    void open() {
        bus::EngineConfig config;
        config.readOnly = true;
        connection.open(config);
    }
    void look() {
        open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        EXPECT_TRUE(connection.news<bus::ChainFound>()->readOnly);
        ASSERT_TRUE(connection.waitUntil([&] { return connection.store().movingMotors() > 0; }));
    }
    [[nodiscard]] double velocity() { return sim.state(2)[QStringLiteral("command_velocity")].toDouble(); }
    void expectUndisturbed() {
        EXPECT_NEAR(velocity(), 8.0, 0.01);
        EXPECT_EQ(changes(sim), before);
        EXPECT_EQ(sim.violations(), "");
    }

    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualConnection connection{sim};
    QJsonArray before;
};

TEST_F(H02_ReadOnly, LeavesMotorsAloneWhenItIsClosed) {
    ASSERT_NO_FATAL_FAILURE(look());
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    EXPECT_FALSE(connection.news<PortClosed>()->error.has_value());
    EXPECT_EQ(connection.count<bus::StopFinished>(), 0);
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, LeavesMotorsAloneWhenItIsClosedInASearch) {
    open();
    ASSERT_TRUE(connection.waitUntil([&] { return connection.store().link().found > 0; }));
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    EXPECT_EQ(connection.count<bus::StopFinished>(), 0);
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, LeavesMotorsAloneWhenThePanelFreezes) {
    ASSERT_NO_FATAL_FAILURE(look());
    connection.freeze(Heartbeat::kStopAfter + 500ms);
    ASSERT_TRUE(connection.waitFor<PanelFroze>());
    EXPECT_FALSE(connection.news<PanelFroze>()->stopped);
    EXPECT_EQ(connection.count<bus::StopFinished>(), 0);
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, LeavesMotorsAloneWhenTheMachineSlept) {
    std::atomic<Duration::rep> asleep{0};
    connection.worker().setSleepClock([&asleep] { return Duration(asleep.load()); });
    ASSERT_NO_FATAL_FAILURE(look());
    asleep = Duration(2h).count();
    ASSERT_TRUE(connection.waitFor<ComputerSlept>());
    EXPECT_FALSE(connection.news<ComputerSlept>()->stopped);
    // What was asked for after it is the last word of this connection.
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    EXPECT_EQ(connection.count<bus::StopFinished>(), 0);
    expectUndisturbed();
}

/// A stop that was asked for goes before the close that comes right behind it.
TEST_F(H02_ReadOnly, StopsWhenItIsAskedToAndThenCloses) {
    ASSERT_NO_FATAL_FAILURE(look());
    connection.worker().stopAll();
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_EQ(connection.count<bus::StopFinished>(), 1);
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 2U);
    EXPECT_NEAR(velocity(), 0.0, 0.01);
    EXPECT_TRUE(sim.state(2)[QStringLiteral("servo_on")].toBool()) << "it holds";
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

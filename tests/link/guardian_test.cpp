// SPDX-License-Identifier: GPL-3.0-or-later
// The bus thread on its own: the GUI thread hangs, or the machine was suspended.
#include <gtest/gtest.h>

#include <QTimer>
#include <ctime>
#include <thread>

#include "link/clock.h"
#include "tests/link/connection.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

bool moves(NmcsimProcess& sim) {
    return std::abs(sim.state(1)[QStringLiteral("command_velocity")].toDouble()) > 0.01;
}

void startMoving(Connection& connection, NmcsimProcess& sim) {
    connection.openSerial(sim.terminal());
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 100'000'000)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return connection.module(0).activity() == Activity::AtSpeed; }));
    connection.forgetNews();
}

TEST(H01_FrozenPanel, HasItsMotorsStoppedAndIsToldWhenItIsBack) {
    NmcsimProcess sim(QStringLiteral("servo"));
    Connection connection;
    ASSERT_NO_FATAL_FAILURE(startMoving(connection, sim));
    // A slot that does not return before the motor has been stopped: no event of this thread is handled.
    bool stopped = false;
    QTimer::singleShot(0, [&] {
        const TimePoint limit = TimePoint(std::chrono::steady_clock::now().time_since_epoch()) + 20s;
        while (!stopped && TimePoint(std::chrono::steady_clock::now().time_since_epoch()) < limit)
            stopped = !moves(sim);
    });
    ASSERT_TRUE(connection.waitUntil([&] { return stopped; }));
    ASSERT_TRUE(connection.waitFor<PanelFroze>());
    EXPECT_TRUE(connection.news<PanelFroze>()->stopped);
    EXPECT_GE(connection.news<PanelFroze>()->length, Heartbeat::kStopAfter);
    EXPECT_EQ(connection.count<PanelFroze>(), 1);
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_TRUE(connection.news<bus::StopFinished>()->unreached.empty());
}

/// Whatever is set, corrected or moved to summer time: nothing here takes time from the wall clock.
TEST(H06_WallClock, IsNotWhereTimeComesFrom) {
    const auto monotonic = [] {
        timespec time{};
        ::clock_gettime(CLOCK_MONOTONIC, &time);
        return TimePoint(std::chrono::seconds(time.tv_sec) + Duration(time.tv_nsec));
    };
    const TimePoint before = monotonic();
    const TimePoint now = monotonicNow();
    EXPECT_LE(before, now);
    EXPECT_LE(now, monotonic());
}

TEST(H05_Suspend, HasTheMotorsStoppedAndIsToldOnce) {
    NmcsimProcess sim(QStringLiteral("servo"));
    std::atomic<Duration::rep> asleep{0};
    Connection connection;
    connection.worker().setSleepClock([&asleep] { return Duration(asleep.load()); });
    ASSERT_NO_FATAL_FAILURE(startMoving(connection, sim));
    asleep = Duration(2h).count();
    ASSERT_TRUE(connection.waitFor<ComputerSlept>());
    EXPECT_EQ(connection.news<ComputerSlept>()->length, 2h);
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_TRUE(connection.waitUntil([&] { return !moves(sim); }));
    EXPECT_EQ(connection.count<ComputerSlept>(), 1);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// The bus thread without the others: the GUI thread stands still, or the machine was suspended.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <atomic>

#include "link/connection/processguard.h"
#include "link/guardian/descriptor.h"
#include "tests/link/connection/virtualconnection.h"
#include "tests/support/leaverunning.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace std::chrono_literals;

class Standstill : public testing::Test {
protected:
    void startMoving() {
        connection.open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
        ASSERT_EQ(connection.carryOut(move(0, 100'000'000)), bus::Outcome::Done);
        ASSERT_TRUE(
            connection.waitUntil([&] { return connection.module(0).activity() == Activity::AtSpeed; }));
        connection.forgetNews();
    }

    VirtualChain sim{QStringLiteral("servo")};
    VirtualConnection connection{sim};
};
using H01_FrozenPanel = Standstill;
using H05_Suspend = Standstill;

TEST_F(H01_FrozenPanel, HasItsMotorsStoppedAfterTwoSecondsAndIsToldWhenItIsBack) {
    ASSERT_NO_FATAL_FAILURE(startMoving());
    connection.freeze(1'800ms);
    EXPECT_TRUE(sim.driven(0));
    connection.freeze(400ms);
    EXPECT_FALSE(sim.driven(0));
    ASSERT_TRUE(connection.waitFor<PanelFroze>());
    EXPECT_TRUE(connection.news<PanelFroze>()->stopped);
    EXPECT_GE(connection.news<PanelFroze>()->length, Heartbeat::kStopAfter);
    EXPECT_EQ(connection.count<PanelFroze>(), 1);
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_TRUE(connection.news<bus::StopFinished>()->unreached.empty());
}

TEST_F(H01_FrozenPanel, ThatIsSlowToShowAChainStopsNoneOfItsMotors) {
    ASSERT_NO_FATAL_FAILURE(leaveRunning(sim, 1, 4));
    connection.open();
    connection.freeze(10s);
    ASSERT_TRUE(connection.waitUntil(
        [&] { return connection.count<bus::ChainFound>() == 1 && connection.module(0).moving(); }));
    EXPECT_TRUE(connection.news<bus::ChainFound>()->attached);
    EXPECT_TRUE(sim.driven(0));
    EXPECT_EQ(connection.count<PanelFroze>(), 0);
}

TEST_F(H05_Suspend, HasTheMotorsStoppedAndIsToldOnce) {
    std::atomic<Duration::rep> asleep{0};
    connection.worker().setSleepClock([&asleep] { return Duration(asleep.load()); });
    ASSERT_NO_FATAL_FAILURE(startMoving());
    asleep = Duration(2h).count();
    ASSERT_TRUE(connection.waitFor<ComputerSlept>());
    EXPECT_EQ(connection.news<ComputerSlept>()->length, 2h);
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_TRUE(connection.waitUntil([&] { return !sim.driven(0); }));
    EXPECT_EQ(connection.count<ComputerSlept>(), 1);
}

/// A guard whose program does not exist, on a port with a descriptor.
class NoGuardian : public ProcessGuard {
public:
    NoGuardian() : ProcessGuard({"/no/such/nmcguard", "/no/such/report"}) {}
    void begin(int /*fd*/) override { ProcessGuard::begin(m_port.get()); }

private:
    Descriptor m_port{::open("/dev/null", O_RDWR | O_CLOEXEC)};
};

TEST(GuardedPanel, SaysOnceThatItHasNoGuardianAndGoesOn) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    NoGuardian guard;
    VirtualConnection connection(sim);
    connection.worker().addGuard(guard);
    connection.open();
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.count<GuardianMissing>(), 1);
    EXPECT_EQ(connection.news<GuardianMissing>()->problem, GuardianProblem::Missing);
    EXPECT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    EXPECT_EQ(connection.count<GuardianMissing>(), 0) << "reported once";
}

}  // namespace
}  // namespace nmc

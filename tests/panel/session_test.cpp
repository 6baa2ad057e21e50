// SPDX-License-Identifier: GPL-3.0-or-later
// The program is requested to end, or hangs: what happens to the motors.
#include <unistd.h>

#include <csignal>

#include "app/unixsignals.h"
#include "link/connection/bussession.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace std::chrono_literals;

class Signals : public testing::TestWithParam<int> {};

TEST_P(Signals, StopTheMotorsAndEndTheProgram) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    const UnixSignals system(&panel.composition().worker());
    QObject::connect(&system, &UnixSignals::terminationAsked, &panel.composition(),
                     &Composition::stopAndQuit);
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    std::raise(GetParam());
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_FALSE(panel.composition().worker().isOpen());
    EXPECT_FALSE(sim.driven(0));
    EXPECT_TRUE(sim.state(1)[QStringLiteral("servo_on")].toBool());
    EXPECT_TRUE(panel.markers().isEmpty());
}

INSTANTIATE_TEST_SUITE_P(H04, Signals, testing::Values(SIGTERM, SIGINT, SIGHUP));

TEST(H04_Signal, StopsTheMotorsWhileTheGuiThreadIsBlocked) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    const UnixSignals system(&panel.composition().worker());
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    std::raise(SIGTERM);
    panel.freeze(500ms);  // much less than the 2 s after which they would be stopped anyway
    EXPECT_FALSE(sim.driven(0));
    EXPECT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }))
        << "the port was closed, too";
}

/// During a search, the stop is confirmed only once its modules are known.
TEST(H04_Signal, LeavesTheTimeThatClosingMayTake) {
    const UnixSignals system(nullptr);
    QSignalSpy asked(&system, &UnixSignals::terminationAsked);
    std::raise(SIGTERM);
    EXPECT_GT(std::chrono::seconds(::alarm(0)), BusSession::kLongestClose);
    EXPECT_TRUE(asked.wait());
}

TEST(H01_FrozenPanel, HasItsMotorsStoppedAndSaysSo) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    panel.freeze(1'900ms);
    EXPECT_TRUE(sim.driven(0)) << "2 s have not passed yet";
    panel.freeze(600ms);
    EXPECT_FALSE(sim.driven(0));
    EXPECT_TRUE(panel.waitFor([&] {
        return panel.count(QStringLiteral("motors were commanded to stop after 2 s")) == 1;
    })) << panel.headlines().join(QLatin1Char('\n')).toStdString();
}

TEST(H04_EndOfSession, StopsTheMotorsAndEndsTheProgramWithoutAQuestion) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    // Only the platform can create a session manager, and the program does not use it.
    alignas(QObject) std::byte manager[sizeof(QObject)]{};
    emit qApp->commitDataRequest(reinterpret_cast<QSessionManager&>(manager));
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_FALSE(panel.composition().worker().isOpen());
    EXPECT_FALSE(sim.driven(0));
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that crashes stops the motors with its last breath: a process of its own, the real worker and
// serial port, and nmcsim as the witness.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QProcess>

#include "link/connection/crashburst.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using testing_support::kAtRest;
using testing_support::NmcsimProcess;

constexpr int kLimitMs = 10'000;

double velocity(NmcsimProcess& sim) {
    return std::abs(sim.state(2)[QStringLiteral("command_velocity")].toDouble());
}

/// Lets a process crash while motor 2 moves; how it ended.
void crash(NmcsimProcess& sim, const QString& thread, const QString& how) {
    QProcess process;
    process.start(QStringLiteral(CRASHER_PATH), {sim.terminal(), thread, how});
    while (!process.canReadLine())
        ASSERT_TRUE(process.waitForReadyRead(kLimitMs));
    ASSERT_EQ(process.readLine().trimmed(), "moving");
    ASSERT_NEAR(velocity(sim), 8.0, 0.1) << "the simulator has to agree that it moves";
    process.write("now\n");
    ASSERT_TRUE(process.waitForFinished(kLimitMs));
    EXPECT_EQ(process.exitStatus(), QProcess::CrashExit) << "the crash must not be hidden";
}

bool stops(NmcsimProcess& sim) {
    QElapsedTimer clock;
    clock.start();
    while (velocity(sim) > kAtRest)
        if (clock.elapsed() > kLimitMs)
            return false;
    return true;
}

using Way = std::pair<std::string, std::string>;  // thread, manner

class Crash : public testing::TestWithParam<Way> {};

TEST_P(Crash, StopsTheMotor) {
    NmcsimProcess sim(QStringLiteral("servo,servo,step"));
    ASSERT_NO_FATAL_FAILURE(
        crash(sim, QString::fromStdString(GetParam().first), QString::fromStdString(GetParam().second)));
    EXPECT_TRUE(stops(sim));
    EXPECT_TRUE(sim.state(2)[QStringLiteral("servo_on")].toBool()) << "it holds";
    EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool()) << "what was off stays off";
    EXPECT_EQ(sim.violations(), "");
}

// Either thread and either signal; an overflow is a SIGSEGV of which the handler must not run on the same
// stack.
INSTANTIATE_TEST_SUITE_P(H03, Crash,
                         testing::Values(Way("gui", "abort"), Way("gui", "overflow"), Way("bus", "segv")),
                         [](const auto& way) { return way.param.first + "_" + way.param.second; });

/// What the crash path cannot reach, and the proof that the tests above would notice a motor that runs on.
TEST(H02_Killed, LeavesTheMotorRunning) {
    NmcsimProcess sim(QStringLiteral("servo,servo,step"));
    ASSERT_NO_FATAL_FAILURE(crash(sim, QStringLiteral("gui"), QStringLiteral("kill")));
    EXPECT_NEAR(velocity(sim), 8.0, 0.1);
}

TEST(H03_CrashBurst, RefusesABurstThatDoesNotFitWhole) {
    const std::vector<std::uint8_t> fits(StopBurst::kCapacity, 0);
    const std::vector<std::uint8_t> doesNot(StopBurst::kCapacity + 1, 0);
    EXPECT_TRUE(crashburst::arm(1, fits, 19'200));
    EXPECT_FALSE(crashburst::arm(1, doesNot, 19'200));
    EXPECT_TRUE(crashburst::arm(-1, fits, 19'200)) << "the simulator in this process has no descriptor";
    crashburst::disarm();
    EXPECT_FALSE(crashburst::underWay());
}

}  // namespace
}  // namespace nmc

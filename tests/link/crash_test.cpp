// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that crashes stops the motors before it dies: a separate process with the real worker and serial
// port, and nmcsim as the witness.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QProcess>
#include <array>
#include <deque>

#include "link/connection/crashburst.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/patience.h"

namespace nmc {
namespace {

using testing_support::kAtRest;
using testing_support::kPatienceMs;
using testing_support::NmcsimProcess;

/// A process with its own port that ends while motor 2 moves.
class Crasher {
public:
    Crasher(const QString& thread, const QString& how) {
        m_process.start(QStringLiteral(CRASHER_PATH), {m_sim.terminal(), thread, how});
    }
    void crash() {
        while (!m_process.canReadLine())
            ASSERT_TRUE(m_process.waitForReadyRead(kPatienceMs));
        ASSERT_EQ(m_process.readLine().trimmed(), "moving");
        ASSERT_NEAR(velocity(), 8.0, 0.1) << "the simulator must see it move, too";
        m_process.write("now\n");
        ASSERT_TRUE(m_process.waitForFinished(kPatienceMs));
        EXPECT_EQ(m_process.exitStatus(), QProcess::CrashExit) << "the crash must not be hidden";
    }
    [[nodiscard]] double velocity() {
        return std::abs(m_sim.state(2)[QStringLiteral("command_velocity")].toDouble());
    }
    [[nodiscard]] bool stops() {
        QElapsedTimer clock;
        clock.start();
        while (velocity() > kAtRest)
            if (clock.elapsed() > kPatienceMs)
                return false;
        return true;
    }
    [[nodiscard]] NmcsimProcess& sim() { return m_sim; }

private:
    NmcsimProcess m_sim{QStringLiteral("servo,servo,step")};
    QProcess m_process;
};

/// Both threads and both signals, in parallel, because the test mostly waits. A stack overflow is a SIGSEGV
/// whose handler must not run on the same stack.
TEST(H03_Crash, StopsTheMotor) {
    struct Way {
        const char* thread;
        const char* how;
    };
    const std::array ways{Way{"gui", "abort"}, Way{"gui", "overflow"}, Way{"bus", "segv"}};
    std::deque<Crasher> crashers;
    for (const auto& [thread, how] : ways)
        crashers.emplace_back(QLatin1String(thread), QLatin1String(how));
    for (std::size_t i = 0; i < ways.size(); ++i) {
        SCOPED_TRACE(std::string(ways.at(i).thread) + ' ' + ways.at(i).how);
        Crasher& crasher = crashers[i];
        ASSERT_NO_FATAL_FAILURE(crasher.crash());
        EXPECT_TRUE(crasher.stops());
        EXPECT_TRUE(crasher.sim().state(2)[QStringLiteral("servo_on")].toBool()) << "it holds";
        EXPECT_FALSE(crasher.sim().state(1)[QStringLiteral("servo_on")].toBool()) << "what was off stays off";
        EXPECT_EQ(crasher.sim().violations(), "");
    }
}

/// The crash path cannot act on SIGKILL. This also shows that H03_Crash would notice a motor that runs on.
TEST(H02_Killed, LeavesTheMotorRunning) {
    Crasher crasher(QStringLiteral("gui"), QStringLiteral("kill"));
    ASSERT_NO_FATAL_FAILURE(crasher.crash());
    EXPECT_NEAR(crasher.velocity(), 8.0, 0.1);
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

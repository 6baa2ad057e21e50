// SPDX-License-Identifier: GPL-3.0-or-later
// The panel's own worker and serial port with their guardian, in a process of their own that comes to a bad
// end while a motor moves, in every kind of motion; nmcsim is the witness.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "link/connection/processguard.h"
#include "link/guardian/guardreport.h"
#include "tests/link/changes.h"
#include "tests/link/connection.h"
#include "tests/link/otherhost.h"

namespace nmc {
namespace {

using testing_support::kAtRest;
using testing_support::kPatienceMs;
using testing_support::NmcsimProcess;

/// crasher with a guardian, on nmcsim: motor 2 moves, and in a group motor 1 as well.
class Panel {
public:
    Panel(NmcsimProcess& sim, const QString& motion, int baud, const QStringList& end) : m_sim(sim) {
        const QString report = QString::fromStdString(guardReportFile(m_folder.path().toStdString()));
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(QStringLiteral(CRASHER_PATH), QStringList{sim.terminal()} + end +
                                                          QStringList{QString::number(baud), motion,
                                                                      QStringLiteral(NMCGUARD_PATH), report});
        EXPECT_EQ(word(), "moving");
        m_guard = guardOf(m_process.processId());
        EXPECT_NEAR(velocity(2), 8.0, 0.1) << "the simulator has to agree that it moves";
    }
    ~Panel() {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        m_process.waitForFinished(kPatienceMs);
    }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    /// What it says next.
    QByteArray word() {
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(kPatienceMs))
                return {};
        return m_process.readLine().trimmed();
    }
    void send(int signal) const { ::kill(static_cast<pid_t>(m_process.processId()), signal); }
    void goOn() { m_process.write("now\n"); }
    [[nodiscard]] bool ends() { return m_process.waitForFinished(kPatienceMs); }
    [[nodiscard]] QProcess::ExitStatus exitStatus() const { return m_process.exitStatus(); }
    [[nodiscard]] pid_t guard() const { return m_guard; }
    [[nodiscard]] bool guardIsGone() const { return m_guard > 0 && ::kill(m_guard, 0) != 0; }
    [[nodiscard]] double velocity(int module) {
        return std::abs(m_sim.state(module)[QStringLiteral("command_velocity")].toDouble());
    }
    [[nodiscard]] bool motorsStop() {
        return QTest::qWaitFor([this] { return velocity(1) < kAtRest && velocity(2) < kAtRest; },
                               kPatienceMs);
    }
    [[nodiscard]] std::vector<GuardReport> reports() const {
        return takeGuardReports(m_folder.path().toStdString());
    }
    /// Reports, when there are some.
    [[nodiscard]] bool isReported() const {
        return QTest::qWaitFor([this] { return !reports().empty(); }, kPatienceMs);
    }

private:
    /// The only child, of whichever thread.
    [[nodiscard]] static pid_t guardOf(qint64 panel) {
        const QDir tasks(QStringLiteral("/proc/%1/task").arg(panel));
        for (const QString& task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            QFile file(tasks.filePath(task + QStringLiteral("/children")));
            if (file.open(QIODevice::ReadOnly))
                if (const int child = file.readAll().trimmed().toInt(); child > 0)
                    return child;
        }
        return -1;
    }

    NmcsimProcess& m_sim;
    QTemporaryDir m_folder;
    QProcess m_process;
    pid_t m_guard = -1;
};

/// Motion, rate.
class Guarded : public testing::TestWithParam<std::tuple<const char*, int>> {
protected:
    [[nodiscard]] static QString motion() { return QLatin1String(std::get<0>(GetParam())); }
    [[nodiscard]] static int baud() { return std::get<1>(GetParam()); }
    void crashes(const char* how) {
        Panel panel(sim, motion(), baud(), {QStringLiteral("bus"), QLatin1String(how)});
        panel.goOn();
        ASSERT_TRUE(panel.ends());
        EXPECT_EQ(panel.exitStatus(), QProcess::CrashExit);
        EXPECT_TRUE(panel.motorsStop());
        EXPECT_TRUE(panel.isReported());
    }

    NmcsimProcess sim{QStringLiteral("servo,servo")};
};

TEST_P(Guarded, IsStoppedWhenItIsKilled) {
    Panel panel(sim, motion(), baud(), {QStringLiteral("gui"), QStringLiteral("kill")});
    panel.send(SIGKILL);
    ASSERT_TRUE(panel.ends());
    EXPECT_TRUE(panel.motorsStop());
    EXPECT_TRUE(sim.state(2)[QStringLiteral("servo_on")].toBool()) << "it holds";
    EXPECT_TRUE(panel.isReported());
}

TEST_P(Guarded, IsStoppedWhenItCrashes) {
    ASSERT_NO_FATAL_FAILURE(crashes("segv"));
}

TEST_P(Guarded, IsStoppedWhenItAborts) {
    ASSERT_NO_FATAL_FAILURE(crashes("abort"));
}

TEST_P(Guarded, IsStoppedWhileItIsHaltedAndHearsOfItAfterwards) {
    Panel panel(sim, motion(), baud(), {QStringLiteral("close"), QStringLiteral("kill")});
    panel.send(SIGSTOP);
    EXPECT_TRUE(panel.motorsStop());
    panel.send(SIGCONT);
    EXPECT_EQ(panel.word(), "stopped");
    EXPECT_TRUE(panel.reports().empty()) << "told here";
    panel.goOn();
    ASSERT_TRUE(panel.ends());
    EXPECT_EQ(panel.exitStatus(), QProcess::NormalExit);
    EXPECT_TRUE(panel.reports().empty()) << "an end in order";
}

INSTANTIATE_TEST_SUITE_P(H02, Guarded,
                         testing::Combine(testing::Values("trapezoid", "velocity", "hold", "group"),
                                          testing::Values(19'200, 115'200)),
                         [](const auto& way) {
                             return std::string(std::get<0>(way.param)) + '_' +
                                    std::to_string(std::get<1>(way.param));
                         });

/// One that only looks at what another program has left in motion.
class ReadOnlyPanel : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(sim, 2, 8));
        before = testing_support::changes(sim);
    }
    void expectUndisturbed(Panel& panel) {
        ASSERT_TRUE(QTest::qWaitFor([&panel] { return panel.guardIsGone(); }, kPatienceMs));
        EXPECT_NEAR(panel.velocity(2), 8.0, 0.01);
        EXPECT_EQ(testing_support::changes(sim), before);
        EXPECT_TRUE(panel.reports().empty());
    }

    NmcsimProcess sim{QStringLiteral("servo,servo")};
    QJsonArray before;
};

class ReadOnlyPanelThatDies : public ReadOnlyPanel, public testing::WithParamInterface<const char*> {};

TEST_P(ReadOnlyPanelThatDies, LeavesMotorsAlone) {
    Panel panel(sim, QStringLiteral("look"), 19'200, {QStringLiteral("bus"), QLatin1String(GetParam())});
    panel.goOn();
    ASSERT_TRUE(panel.ends());
    EXPECT_EQ(panel.exitStatus(), QProcess::CrashExit);
    expectUndisturbed(panel);
}

INSTANTIATE_TEST_SUITE_P(H02, ReadOnlyPanelThatDies, testing::Values("kill", "segv", "abort"),
                         [](const auto& how) { return std::string(how.param); });

TEST_F(ReadOnlyPanel, LeavesMotorsAloneWhileItIsHalted) {
    Panel panel(sim, QStringLiteral("look"), 19'200, {QStringLiteral("close"), QStringLiteral("kill")});
    panel.send(SIGSTOP);
    ASSERT_TRUE(testing_support::passes(sim, 1.0)) << "far longer than a guardian bears elsewhere";
    EXPECT_NEAR(panel.velocity(2), 8.0, 0.01);
    panel.send(SIGCONT);
    panel.goOn();
    ASSERT_TRUE(panel.ends());
    EXPECT_EQ(panel.exitStatus(), QProcess::NormalExit);
    expectUndisturbed(panel);
}

TEST(GuardedPanel, GoesOnWithoutItsGuardianAndSaysSo) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Panel panel(sim, QStringLiteral("velocity"), 115'200, {QStringLiteral("close"), QStringLiteral("kill")});
    const pid_t guard = panel.guard();
    ASSERT_GT(guard, 0);
    ::kill(guard, SIGKILL);
    EXPECT_EQ(panel.word(), "unguarded");
    EXPECT_NEAR(panel.velocity(2), 8.0, 0.1) << "it goes on";
    panel.goOn();
    ASSERT_TRUE(panel.ends());
    EXPECT_EQ(panel.exitStatus(), QProcess::NormalExit);
    EXPECT_TRUE(panel.motorsStop());
    EXPECT_TRUE(panel.reports().empty());
}

TEST(GuardedPanel, SaysOnceThatItHasNoneAndGoesOn) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    ProcessGuard guard({"/no/such/nmcguard", "/no/such/report"});
    testing_support::Connection connection;
    connection.worker().addGuard(guard);
    connection.openSerial(sim.terminal());
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.count<GuardianMissing>(), 1);
    EXPECT_EQ(connection.news<GuardianMissing>()->problem, GuardianProblem::Missing);
    EXPECT_EQ(connection.carryOut(testing_support::gainsAndEnable(1)), bus::Outcome::Done);
    EXPECT_EQ(connection.count<GuardianMissing>(), 0) << "once";
}

TEST(GuardedPanel, WithTheNextOneOnTheSamePortAfterItWasKilled) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Panel first(sim, QStringLiteral("velocity"), 19'200, {QStringLiteral("gui"), QStringLiteral("kill")});
    first.send(SIGKILL);
    ASSERT_TRUE(first.ends());
    ASSERT_TRUE(first.isReported()) << "and the port is free again soon after";
    ASSERT_TRUE(first.motorsStop());
    // As long as the guardian has the port nobody else gets it; this one would fail if it kept it.
    ASSERT_TRUE(QTest::qWaitFor([&first] { return first.guardIsGone(); }, kPatienceMs));
    Panel second(sim, QStringLiteral("velocity"), 19'200, {QStringLiteral("close"), QStringLiteral("kill")});
    second.goOn();
    ASSERT_TRUE(second.ends());
    EXPECT_EQ(second.exitStatus(), QProcess::NormalExit);
    EXPECT_TRUE(second.motorsStop());
}

}  // namespace
}  // namespace nmc

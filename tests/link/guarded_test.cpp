// SPDX-License-Identifier: GPL-3.0-or-later
// The panel's worker and serial port with their guardian, in a separate process that is halted, killed or
// crashes while a motor moves, in every kind of motion; nmcsim is the witness.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <array>
#include <cmath>
#include <csignal>
#include <deque>
#include <optional>

#include "link/guardian/guardreport.h"
#include "tests/link/connection.h"
#include "tests/support/changes.h"
#include "tests/support/eventually.h"
#include "tests/support/leaverunning.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using testing_support::kAtRest;
using testing_support::kPatienceMs;
using testing_support::NmcsimProcess;

/// The crasher with a guardian, on nmcsim: motor 2 moves, and in a group motor 1 as well.
class Panel {
public:
    Panel(NmcsimProcess& sim, const QString& motion, int baud, const QStringList& end) : m_sim(sim) {
        const QString report = QString::fromStdString(guardReportFile(m_folder.path().toStdString()));
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(QStringLiteral(CRASHER_PATH), QStringList{sim.terminal()} + end +
                                                          QStringList{QString::number(baud), motion,
                                                                      QStringLiteral(NMCGUARD_PATH), report});
    }
    ~Panel() {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        m_process.waitForFinished(kPatienceMs);
    }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    /// Waits until its motor moves.
    void begin() {
        EXPECT_EQ(word(), "moving");
        m_guard = guardOf(m_process.processId());
        EXPECT_TRUE(moves()) << "the simulator must see it move, too";
    }
    /// Waits until motor 2 has its velocity. If this computer gives the panel no time, its guardian stops the
    /// motor, and the panel starts it again.
    [[nodiscard]] bool moves() {
        return testing_support::eventually([this] { return std::abs(velocity(2) - 8.0) < 0.1; });
    }
    /// Waits until it says this, whatever it says before.
    [[nodiscard]] bool says(const char* wanted) {
        QByteArray said;
        do {
            said = word();
        } while (!said.isEmpty() && said != wanted);
        return said == wanted;
    }
    /// The next word that it says.
    QByteArray word() {
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(kPatienceMs))
                return {};
        return m_process.readLine().trimmed();
    }
    void send(int signal) const {
        const auto pid = static_cast<pid_t>(m_process.processId());
        ASSERT_GT(pid, 0) << "0 would be the group of processes that these tests are in";
        ::kill(pid, signal);
    }
    void goOn() { m_process.write("now\n"); }
    [[nodiscard]] bool ends() {
        return m_process.state() == QProcess::NotRunning || m_process.waitForFinished(kPatienceMs);
    }
    [[nodiscard]] QProcess::ExitStatus exitStatus() const { return m_process.exitStatus(); }
    [[nodiscard]] pid_t guard() const { return m_guard; }
    /// Waits until its guardian has gone, too, because until then no other program gets the port. A zombie
    /// has no program any more.
    [[nodiscard]] bool letsGo() const {
        const QString program = QStringLiteral("/proc/%1/exe").arg(m_guard);
        return m_guard > 0 &&
               testing_support::eventually([&] { return QFile::symLinkTarget(program).isEmpty(); });
    }
    [[nodiscard]] double velocity(int module) {
        return std::abs(m_sim.state(module)[QStringLiteral("command_velocity")].toDouble());
    }
    [[nodiscard]] bool motorsStop() {
        return testing_support::eventually([this] { return velocity(1) < kAtRest && velocity(2) < kAtRest; });
    }
    [[nodiscard]] std::vector<GuardReport> reports() const {
        return takeGuardReports(m_folder.path().toStdString());
    }
    /// Waits until there is a report.
    [[nodiscard]] bool isReported() const {
        return testing_support::eventually([this] { return !reports().empty(); });
    }

private:
    /// The only child process, whichever thread started it.
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

/// A motion, and the rate of its chain.
struct Course {
    const char* motion;
    int baud;
};

/// All in parallel, each at its own port, because the test mostly waits.
TEST(H02_GuardedMotions, AreStoppedWhileThePanelIsHaltedAndWhenItIsKilled) {
    struct Session {
        explicit Session(const Course& course)
            : panel(sim, QLatin1String(course.motion), course.baud,
                    {QStringLiteral("gui"), QStringLiteral("kill")}) {}
        NmcsimProcess sim{QStringLiteral("servo,servo")};
        Panel panel;
    };
    const std::array courses{Course{"trapezoid", 19'200}, Course{"velocity", 115'200}, Course{"hold", 19'200},
                             Course{"group", 115'200}};
    std::deque<Session> sessions;
    for (const Course& course : courses)
        sessions.emplace_back(course);
    const auto each = [&](const auto& check) {
        for (std::size_t i = 0; i < courses.size(); ++i) {
            SCOPED_TRACE(courses.at(i).motion);
            ASSERT_NO_FATAL_FAILURE(check(sessions[i].panel, sessions[i].sim));
        }
    };
    each([](Panel& panel, NmcsimProcess&) {
        panel.begin();
        panel.send(SIGSTOP);
    });
    each([](Panel& panel, NmcsimProcess&) {
        EXPECT_TRUE(panel.motorsStop());
        panel.send(SIGCONT);
    });
    each([](Panel& panel, NmcsimProcess&) {
        EXPECT_EQ(panel.word(), "stopped");
        ASSERT_EQ(panel.word(), "moving") << "it moves again";
        EXPECT_TRUE(panel.moves());
        EXPECT_TRUE(panel.reports().empty()) << "it was reported in this session";
        panel.send(SIGKILL);
    });
    each([](Panel& panel, NmcsimProcess& sim) {
        ASSERT_TRUE(panel.ends());
        EXPECT_TRUE(panel.motorsStop());
        const QJsonObject state = sim.state(2);
        EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool())
            << "it holds; " << QJsonDocument(state).toJson(QJsonDocument::Compact).toStdString();
        EXPECT_TRUE(panel.isReported());
        ASSERT_TRUE(panel.letsGo());
    });
}

/// The crash path and the guardian both act. The second panel uses the port of the first one, and finds its
/// chain.
TEST(H02_Guarded, IsStoppedWhenItCrashes) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    for (const auto& [course, how] :
         {std::pair(Course{"group", 19'200}, "segv"), std::pair(Course{"hold", 115'200}, "abort")}) {
        SCOPED_TRACE(course.motion);
        Panel panel(sim, QLatin1String(course.motion), course.baud,
                    {QStringLiteral("bus"), QLatin1String(how)});
        panel.begin();
        panel.goOn();
        ASSERT_TRUE(panel.ends());
        EXPECT_EQ(panel.exitStatus(), QProcess::CrashExit);
        EXPECT_TRUE(panel.motorsStop());
        EXPECT_TRUE(panel.isReported());
        ASSERT_TRUE(panel.letsGo());
    }
}

/// A panel that only watches what another program has left in motion.
class Watcher {
public:
    explicit Watcher(const QStringList& end) : m_end(end) {}
    void begin() {
        ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(m_sim, 2, 8));
        m_before = testing_support::changes(m_sim);
        m_panel.emplace(m_sim, QStringLiteral("look"), 19'200, m_end);
    }
    void expectUndisturbed() {
        m_panel->goOn();
        ASSERT_TRUE(m_panel->ends());
        EXPECT_EQ(m_panel->exitStatus(), QProcess::CrashExit);
        ASSERT_TRUE(m_panel->letsGo());
        EXPECT_NEAR(m_panel->velocity(2), 8.0, 0.01);
        EXPECT_EQ(testing_support::changes(m_sim), m_before);
        EXPECT_TRUE(m_panel->reports().empty());
    }
    [[nodiscard]] Panel& panel() { return *m_panel; }
    [[nodiscard]] NmcsimProcess& sim() { return m_sim; }

private:
    NmcsimProcess m_sim{QStringLiteral("servo,servo"), {QStringLiteral("--enable-faults")}};
    QStringList m_end;
    QJsonArray m_before;
    std::optional<Panel> m_panel;
};

/// Both at once, because the test mostly waits.
TEST(H02_ReadOnlyPanel, LeavesMotorsAloneWhileItIsHaltedAndWhenItIsKilledAndWhenItCrashes) {
    Watcher halted({QStringLiteral("gui"), QStringLiteral("kill")});
    Watcher crashes({QStringLiteral("bus"), QStringLiteral("segv")});
    ASSERT_NO_FATAL_FAILURE(halted.begin());
    ASSERT_NO_FATAL_FAILURE(crashes.begin());
    halted.panel().begin();
    halted.panel().send(SIGSTOP);
    crashes.panel().begin();
    ASSERT_NO_FATAL_FAILURE(crashes.expectUndisturbed());
    // More than three times what a guardian tolerates otherwise.
    ASSERT_NO_FATAL_FAILURE(testing_support::letPass(halted.sim(), std::chrono::milliseconds(500)));
    EXPECT_NEAR(halted.panel().velocity(2), 8.0, 0.01);
    halted.panel().send(SIGCONT);
    halted.expectUndisturbed();
}

/// One panel with its guardian and one without, at the same time, because the test mostly waits.
TEST(H02_Unguarded, GoesOnAndSaysSoAndEndsInOrderWithoutAReport) {
    NmcsimProcess guardedSim(QStringLiteral("servo,servo")), unguardedSim(QStringLiteral("servo,servo"));
    const QStringList end{QStringLiteral("close"), QStringLiteral("kill")};
    Panel guarded(guardedSim, QStringLiteral("velocity"), 19'200, end);
    Panel unguarded(unguardedSim, QStringLiteral("velocity"), 115'200, end);
    unguarded.begin();
    const pid_t guard = unguarded.guard();
    ASSERT_GT(guard, 0);
    ::kill(guard, SIGKILL);
    EXPECT_TRUE(unguarded.says("unguarded"));
    EXPECT_TRUE(unguarded.moves()) << "the motor runs on";
    guarded.begin();
    for (Panel* panel : {&guarded, &unguarded}) {
        panel->goOn();
        ASSERT_TRUE(panel->ends());
        EXPECT_EQ(panel->exitStatus(), QProcess::NormalExit);
        EXPECT_TRUE(panel->motorsStop());
        EXPECT_TRUE(panel->reports().empty());
    }
}

}  // namespace
}  // namespace nmc

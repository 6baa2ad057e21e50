// SPDX-License-Identifier: GPL-3.0-or-later
// What a program that was killed leaves behind, and what the next one reports about it; with real processes.
#include <gtest/gtest.h>

#include "tests/support/eventually.h"
#include "tests/support/leaverunning.h"
#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;
using testing_support::leaveRunning;
using testing_support::NmcsimProcess;

const QString kEnded = QStringLiteral("The last session ended while motor 1 was moving.");

/// nmcpanel in its own process and with its own home, connected to a chain whose motor moves.
class PanelProcess {
public:
    PanelProcess(const QString& home, const QString& port)
        : m_data(home + QStringLiteral("/nmcpanel/NMC Panel")) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        for (const char* place : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
            environment.insert(QLatin1String(place), home);
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process.start(QStringLiteral(NMCPANEL_PATH), {QStringLiteral("--port"), port});
    }
    ~PanelProcess() { kill(); }

    [[nodiscard]] const QString& data() const { return m_data; }
    [[nodiscard]] QStringList markers() const {
        return QDir(m_data).entryList({QStringLiteral("moving-%1-*.json").arg(m_process.processId())});
    }
    [[nodiscard]] bool marks() {
        return testing_support::eventually([this] { return markers().size() == 1; });
    }
    void kill() {
        m_process.kill();  // SIGKILL
        m_process.waitForFinished(testing_support::kPatienceMs);
    }
    [[nodiscard]] bool end() {
        m_process.terminate();
        return m_process.waitForFinished(testing_support::kPatienceMs);
    }

private:
    QString m_data;
    QProcess m_process;
};

TEST(H02_Killed, IsSaidAtTheNextStartWithWhatItsGuardianDidAndTheOtherPanelsMarkIsLeftAlone) {
    QTemporaryDir home;
    NmcsimProcess one(QStringLiteral("servo"), {QStringLiteral("--enable-faults")});
    NmcsimProcess two(QStringLiteral("servo"), {QStringLiteral("--enable-faults")});
    ASSERT_NO_FATAL_FAILURE(leaveRunning(one, 1, 4));
    ASSERT_NO_FATAL_FAILURE(leaveRunning(two, 1, 4));
    PanelProcess killed(home.path(), one.terminal());
    PanelProcess lives(home.path(), two.terminal());
    ASSERT_TRUE(killed.marks());
    ASSERT_TRUE(lives.marks());
    killed.kill();
    {
        // No guardian's report is found from here.
        IntentPanel next({}, {}, killed.data());
        next.start();
        ASSERT_EQ(next.count(kEnded), 1);
        EXPECT_TRUE(next.standing(kEnded)->message().body.contains(one.terminal()));
    }
    EXPECT_EQ(lives.markers().size(), 1);

    const QDir reports(home.filePath(QStringLiteral("nmcpanel")));
    ASSERT_TRUE(testing_support::eventually(
        [&] { return reports.entryList({QStringLiteral("guardian-*.report")}).size() == 1; }));
    IntentPanel next(reports.filePath(QStringLiteral("next.ini")), {}, killed.data());
    next.start();
    const QString told = QStringLiteral("its guardian commanded module 1 to stop");
    ASSERT_NE(next.standing(told), nullptr);
    EXPECT_EQ(next.count(kEnded), 0) << "one event gives one message";
    const QString body = next.standing(told)->message().body;
    EXPECT_TRUE(body.startsWith(QStringLiteral("Motor 1 was moving, at %1.").arg(one.terminal())))
        << body.toStdString();

    EXPECT_TRUE(lives.end());
    EXPECT_TRUE(lives.markers().isEmpty()) << "it stopped its motor and ended normally";
    EXPECT_NE(next.standing(told), nullptr);
}

}  // namespace
}  // namespace nmc

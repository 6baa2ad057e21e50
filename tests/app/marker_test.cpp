// SPDX-License-Identifier: GPL-3.0-or-later
// What a program that was killed leaves behind, and what the next one says of it; with real processes.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDeadlineTimer>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <thread>

#include "tests/app/othermaster.h"
#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;
using testing_support::moves;
using testing_support::NmcsimProcess;
using testing_support::setGoing;

const QString kEnded = QStringLiteral("The last session ended while motor 1 was moving.");

/// nmcpanel in a process and a home of its own, connected to a chain whose motor moves.
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
        return QTest::qWaitFor([this] { return markers().size() == 1; }, 20'000);
    }
    void kill() {
        m_process.kill();  // SIGKILL
        m_process.waitForFinished();
    }
    [[nodiscard]] bool end() {
        m_process.terminate();
        return m_process.waitForFinished();
    }

private:
    QString m_data;
    QProcess m_process;
};

class H02_Killed : public testing::Test {
protected:
    [[nodiscard]] static bool stays(IntentPanel& panel) { return panel.standing(kEnded) != nullptr; }
    QTemporaryDir home;
};

TEST_F(H02_Killed, IsSaidAtTheNextStartUntilTheMotorWasSeenAtRest) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    ASSERT_NO_FATAL_FAILURE(setGoing(sim));
    PanelProcess killed(home.path(), sim.terminal());
    ASSERT_TRUE(killed.marks());
    killed.kill();
    {
        IntentPanel idle({}, {}, killed.data());
        idle.start();
        ASSERT_TRUE(stays(idle));
        EXPECT_TRUE(idle.standing(kEnded)->message().body.contains(sim.terminal()));
    }
    IntentPanel next({}, {}, killed.data());
    next.start();
    ASSERT_TRUE(stays(next)) << "to have been told once is not enough";
    NmcsimProcess other(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(next.connectTo(other.terminal()));
    ASSERT_TRUE(next.answersFor(2.0));
    EXPECT_TRUE(stays(next)) << "that is another port";
    next.connectTo(sim.terminal());
    ASSERT_TRUE(next.waitFor([&] {
        return next.connected() && next.composition().store().link().port == sim.terminal().toStdString();
    }));
    next.pressStopAll();
    EXPECT_TRUE(next.waitFor([&] { return !stays(next); }));
    EXPECT_FALSE(moves(sim));
    IntentPanel last({}, {}, killed.data());
    last.start();
    EXPECT_FALSE(stays(last));
}

TEST_F(H02_Killed, LeavesTheOtherPanelsMarkAlone) {
    NmcsimProcess one(QStringLiteral("servo"));
    NmcsimProcess two(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(setGoing(one));
    ASSERT_NO_FATAL_FAILURE(setGoing(two));
    PanelProcess killed(home.path(), one.terminal());
    PanelProcess lives(home.path(), two.terminal());
    ASSERT_TRUE(killed.marks());
    ASSERT_TRUE(lives.marks());
    killed.kill();
    IntentPanel next({}, {}, killed.data());
    next.start();
    ASSERT_EQ(next.count(kEnded), 1);
    EXPECT_TRUE(next.standing(kEnded)->message().body.contains(one.terminal()));
    EXPECT_EQ(lives.markers().size(), 1);
    EXPECT_TRUE(lives.end());
    EXPECT_TRUE(lives.markers().isEmpty()) << "it stopped its motor, and said goodbye";
    EXPECT_TRUE(stays(next));
}

TEST_F(H02_Killed, IsOverWhenTheUserHasLooked) {
    NmcsimProcess sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(setGoing(sim));
    PanelProcess killed(home.path(), sim.terminal());
    ASSERT_TRUE(killed.marks());
    killed.kill();
    for (const bool first : {true, false}) {
        IntentPanel next({}, {}, killed.data());
        next.start();
        ASSERT_EQ(stays(next), first);
        if (!first)
            break;
        auto* looked = next.window().findChild<QAbstractButton*>(QStringLiteral("bannerAction_lookedAt"));
        ASSERT_NE(looked, nullptr);
        QTest::mouseClick(looked, Qt::LeftButton);
        EXPECT_FALSE(stays(next));
    }
}

TEST_F(H02_Killed, WhatItsGuardianDidIsToldInTheSameMessageAndCanBeLookedAt) {
    NmcsimProcess sim(QStringLiteral("servo"));
    ASSERT_NO_FATAL_FAILURE(setGoing(sim));
    PanelProcess killed(home.path(), sim.terminal());
    ASSERT_TRUE(killed.marks());
    killed.kill();
    const QDir reports(home.filePath(QStringLiteral("nmcpanel")));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return reports.entryList({QStringLiteral("guardian-*.report")}).size() == 1; }, 20'000));
    IntentPanel next(reports.filePath(QStringLiteral("next.ini")), {}, killed.data());
    next.start();
    const QString told = QStringLiteral("its guardian told module 1 to stop");
    ASSERT_NE(next.standing(told), nullptr);
    EXPECT_EQ(next.count(kEnded), 0) << "one event, one message";
    const QString body = next.standing(told)->message().body;
    EXPECT_TRUE(body.startsWith(QStringLiteral("Motor 1 was moving, at %1.").arg(sim.terminal())))
        << body.toStdString();
    ASSERT_TRUE(next.press(told, QStringLiteral("Look first")));
    ASSERT_TRUE(next.waitFor([&] { return next.connected() && next.module().latest.has_value(); }));
    EXPECT_TRUE(next.composition().store().link().readOnly);
    ASSERT_TRUE(next.answersFor(2.0));
    EXPECT_NE(next.standing(told), nullptr) << "to look on is not to settle it";
    ASSERT_TRUE(next.press(told, QStringLiteral("Look first")));
    EXPECT_NE(next.standing(QStringLiteral("A port is already open")), nullptr);
    EXPECT_TRUE(next.connected()) << "to close it for that might stop motors";
    ASSERT_TRUE(next.press(told, QStringLiteral("I have checked")));
    EXPECT_EQ(next.standing(told), nullptr);
}

TEST_F(H02_Killed, AMarkThatWasTamperedWithIsNoDanger) {
    const auto leave = [this](const QString& name, const QByteArray& content) {
        QFile file(home.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
    };
    leave(QStringLiteral("moving-1-2-3.json"), R"({"port":"x","modules":[0,33,-1,"x",null]})");
    leave(QStringLiteral("moving-1-2-4.json"), R"({"port":7,"modules":{}})");
    leave(QStringLiteral("moving-1-2-5.json"), QByteArray(1 << 20, '['));
    leave(QStringLiteral("moving-99999999999999999999-2-5.json"), "");
    leave(QStringLiteral("moving-x.json"), R"({"port":"x","modules":[1]})");
    IntentPanel panel({}, {}, home.path());
    panel.start();
    EXPECT_EQ(panel.count(QStringLiteral("last session")), 0);
}

TEST(MotionMark, IsAskedForBeforeTheCommandAndGoneWhenTheMotorStands) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    EXPECT_EQ(panel.markers().size(), 1);
    panel.click("stopAbruptlyButton");
    ASSERT_TRUE(panel.waitFor([&] { return panel.markers().isEmpty(); }));
    // Whatever is seen of the motor: the thread that writes needs no event of this one.
    panel.ask(intent::RunAtVelocity{CountsPerTick(8 << 16), CountsPerTickSquared(1'311), false});
    const QDeadlineTimer patience(20'000);
    while (panel.markers().isEmpty() && !patience.hasExpired())
        std::this_thread::yield();
    ASSERT_EQ(panel.markers().size(), 1);
    EXPECT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.markers().size(), 1);
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return panel.markers().isEmpty(); }));
}

TEST(PortGone, WithAMotorMovingIsNotOverBecauseSomebodyTriedAgain) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    IntentPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    const QString gone = QStringLiteral("Module 1 was moving");
    sim.quit();
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(gone) != nullptr; }));
    for (int i = 0; i < 2; ++i) {
        const qsizetype before = panel.headlines().size();
        QTest::mouseClick(panel.window().findChild<QAbstractButton*>(QStringLiteral("bannerAction_retry")),
                          Qt::LeftButton);
        ASSERT_TRUE(panel.waitFor([&] {
            return !panel.composition().worker().isOpen() && (i > 0 || panel.headlines().size() > before);
        }));
        EXPECT_NE(panel.standing(gone), nullptr);
        EXPECT_EQ(panel.markers().size(), 1) << "what moved is not forgotten either";
    }
}

}  // namespace
}  // namespace nmc

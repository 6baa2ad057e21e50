// SPDX-License-Identifier: GPL-3.0-or-later
// H-05: the computer delays its sleep until the motors stand. The test has its own D-Bus, with a fake logind
// on it.
#include "link/connection/sleepinhibitor.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <QDBusConnection>
#include <QDBusUnixFileDescriptor>
#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <array>

#include "link/connection/simulatortransport.h"
#include "tests/link/connection.h"
#include "tests/support/leaverunning.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;

/// Does what systemd's logind does with delay locks: it keeps the other end of each, which hangs up when the
/// lock is released.
class FakeLogind : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.login1.Manager")

public:
    ~FakeLogind() override {
        for (const int end : m_ends)
            ::close(end);
    }
    [[nodiscard]] int asked() const { return static_cast<int>(m_ends.size()); }
    [[nodiscard]] const QStringList& lastAsked() const { return m_last; }
    /// Number of locks that are held now.
    [[nodiscard]] int held() const {
        int count = 0;
        for (const int end : m_ends) {
            pollfd look{end, 0, 0};
            ::poll(&look, 1, 0);
            count += (look.revents & POLLHUP) == 0 ? 1 : 0;
        }
        return count;
    }

public slots:
    QDBusUnixFileDescriptor Inhibit(const QString& what, const QString& who, const QString& why,
                                    const QString& mode) {
        m_last = {what, who, why, mode};
        std::array<int, 2> ends{};
        EXPECT_EQ(::pipe(ends.data()), 0);
        m_ends.push_back(ends[0]);
        QDBusUnixFileDescriptor lock(ends[1]);  // makes a copy of it
        ::close(ends[1]);
        return lock;
    }

signals:
    void PrepareForSleep(bool start);

private:
    std::vector<int> m_ends;
    QStringList m_last;
};

class H05_SleepInhibitor : public testing::Test {
protected:
    H05_SleepInhibitor() {
        m_daemon.start(
            QStringLiteral("dbus-daemon"),
            {QStringLiteral("--session"), QStringLiteral("--nofork"), QStringLiteral("--print-address")});
        while (!m_daemon.canReadLine() && m_daemon.waitForReadyRead(kPatienceMs)) {
        }
        address = QString::fromLocal8Bit(m_daemon.readLine()).trimmed();
        QDBusConnection bus = QDBusConnection::connectToBus(address, QStringLiteral("logind"));
        EXPECT_TRUE(bus.registerObject(QStringLiteral("/org/freedesktop/login1"), &logind,
                                       QDBusConnection::ExportAllContents));
        EXPECT_TRUE(bus.registerService(QStringLiteral("org.freedesktop.login1")));
    }
    ~H05_SleepInhibitor() override {
        QDBusConnection::disconnectFromBus(QStringLiteral("logind"));
        m_daemon.kill();
        m_daemon.waitForFinished();
    }

    QString address;
    FakeLogind logind;

private:
    QProcess m_daemon;
};

TEST_F(H05_SleepInhibitor, DelaysSleepWhileAnythingMoves) {
    SleepInhibitor inhibitor(address);
    EXPECT_EQ(logind.asked(), 0);
    inhibitor.setMoving(true);
    ASSERT_TRUE(eventually([this] { return logind.held() == 1; }));
    EXPECT_EQ(logind.lastAsked(),
              (QStringList{QStringLiteral("sleep"), QStringLiteral("NMC Panel"),
                           QStringLiteral("Motors are moving."), QStringLiteral("delay")}));
    inhibitor.setMoving(true);
    inhibitor.setMoving(false);
    EXPECT_TRUE(eventually([this] { return logind.held() == 0; }));
    inhibitor.setMoving(true);
    EXPECT_TRUE(eventually([this] { return logind.held() == 1; }));
    EXPECT_EQ(logind.asked(), 2);
}

TEST_F(H05_SleepInhibitor, LetsGoOfALockThatComesWhenNothingMovesAnyMore) {
    SleepInhibitor inhibitor(address);
    inhibitor.setMoving(true);
    inhibitor.setMoving(false);
    ASSERT_TRUE(eventually([this] { return logind.asked() == 1; }));
    EXPECT_TRUE(eventually([this] { return logind.held() == 0; }));
}

TEST_F(H05_SleepInhibitor, HasTheMotorsStoppedAndSleepWaitsForThat) {
    Connection connection;
    connection.open([] {
        return std::make_unique<SimulatorTransport>(std::vector{ModuleIdentity{ModuleType::Servo, 4}});
    });
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    SleepInhibitor inhibitor(address);
    inhibitor.follow(connection.store());
    QObject::connect(&inhibitor, &SleepInhibitor::stopWanted, &connection.worker(), &BusWorker::stopAll);
    ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(0, 100'000'000)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([this] { return logind.held() == 1; }));

    emit logind.PrepareForSleep(true);  // the lid is closed
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 1U);
    EXPECT_TRUE(connection.waitUntil([this] { return logind.held() == 0; })) << "now it may sleep";

    emit logind.PrepareForSleep(false);  // and is opened again
    ASSERT_EQ(connection.carryOut(move(0, 100'000'000)), bus::Outcome::Done);
    EXPECT_TRUE(connection.waitUntil([this] { return logind.held() == 1; }));
}

/// This is the system bus of a process that has a line without a window.
TEST_F(H05_SleepInhibitor, HasTheMotorsOfNmcctlStopped) {
    constexpr int kNotCarriedOut = 5;  // the manual's page nmcctl, Exit codes
    const QTemporaryDir folder;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DBUS_SYSTEM_BUS_ADDRESS"), address);
    // Each is a folder of its own: what is made for settings may be open to others, a folder of sockets not.
    for (const char* name : {"XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
        ASSERT_TRUE(QDir(folder.path()).mkdir(QLatin1String(name)));
        environment.insert(QLatin1String(name), folder.filePath(QLatin1String(name)));
    }
    QProcess nmcctl;
    nmcctl.setProcessEnvironment(environment);
    nmcctl.start(QStringLiteral(NMCCTL_PATH), {QStringLiteral("--simulator=servo"), QStringLiteral("-")});
    nmcctl.write(
        "gains 1 --set kp=200 kd=2000 ki=20 il=200 ol=255 cl=0 el=8000 sr=1\n"
        "enable 1\n"
        "move 1 100000000\n");
    nmcctl.closeWriteChannel();
    ASSERT_TRUE(eventually([this] { return logind.held() == 1; })) << nmcctl.readAllStandardError().data();

    emit logind.PrepareForSleep(true);
    ASSERT_TRUE(eventually([&nmcctl] { return nmcctl.state() == QProcess::NotRunning; }));
    EXPECT_EQ(nmcctl.exitCode(), kNotCarriedOut) << nmcctl.readAllStandardError().data();
    EXPECT_EQ(logind.held(), 0);
}

/// On a read-only connection, motors are for another host to stop.
TEST_F(H05_SleepInhibitor, LetsTheComputerSleepOverAReadOnlyConnection) {
    NmcsimProcess sim(QStringLiteral("servo"), {QStringLiteral("--enable-faults")});
    ASSERT_NO_FATAL_FAILURE(leaveRunning(sim, 1, 8));
    bus::EngineConfig config;
    config.readOnly = true;
    Connection connection;
    SleepInhibitor inhibitor(address);
    inhibitor.follow(connection.store());
    QSignalSpy stopWanted(&inhibitor, &SleepInhibitor::stopWanted);
    connection.open([&sim] { return std::make_unique<SerialTransport>(sim.terminal()); }, config);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_TRUE(connection.waitUntil([&] { return connection.store().movingMotors() > 0; }));
    // This request takes the same way to logind, after any earlier one.
    SleepInhibitor next(address);
    next.setMoving(true);
    ASSERT_TRUE(connection.waitUntil([this] { return logind.asked() > 0; }));
    EXPECT_EQ(logind.asked(), 1);
    EXPECT_EQ(stopWanted.count(), 0);
}

/// A motor that cannot be reached does not delay the computer's sleep for longer than the stop takes.
TEST_F(H05_SleepInhibitor, LetsGoWhenTheStopHasRunItsCourse) {
    SleepInhibitor inhibitor(address);
    QSignalSpy stopWanted(&inhibitor, &SleepInhibitor::stopWanted);
    inhibitor.setMoving(true);
    ASSERT_TRUE(eventually([this] { return logind.held() == 1; }));
    inhibitor.stopFinished();
    EXPECT_EQ(logind.held(), 1) << "this stop has nothing to do with sleep";
    emit logind.PrepareForSleep(true);
    ASSERT_TRUE(stopWanted.wait(kPatienceMs));
    inhibitor.setMoving(false);
    EXPECT_EQ(logind.held(), 1) << "it waits for the end of the stop";
    inhibitor.stopFinished();
    EXPECT_TRUE(eventually([this] { return logind.held() == 0; }));
}

TEST(H05_NoLogind, IsNoError) {
    SleepInhibitor inhibitor(QStringLiteral("unix:path=/nowhere/at/all"));
    QSignalSpy stopWanted(&inhibitor, &SleepInhibitor::stopWanted);
    inhibitor.setMoving(true);
    inhibitor.stopFinished();
    inhibitor.setMoving(false);
    QCoreApplication::processEvents();
    EXPECT_EQ(stopWanted.count(), 0);
}

}  // namespace
}  // namespace nmc

#include "sleepinhibitor_test.moc"

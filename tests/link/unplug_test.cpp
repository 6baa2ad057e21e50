// SPDX-License-Identifier: GPL-3.0-or-later
// The real serial path when the port goes away, does not support the rate, or is in use by another program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QProcess>

#include "link/connection/wakeup.h"
#include "link/terminal/ptyserver.h"
#include "tests/link/connection.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;

/// The commands that module 1 of nmcsim has carried out, by name.
QStringList executed(NmcsimProcess& sim) {
    return sim.control(QStringLiteral("stats"))[QStringLiteral("modules")]
        .toArray()[0]
        .toObject()[QStringLiteral("executed")]
        .toObject()
        .keys();
}

void expectGoneOnce(Connection& connection) {
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_TRUE(connection.news<PortClosed>()->error.has_value());
    EXPECT_EQ(connection.news<PortClosed>()->error->problem, PortProblem::Gone);
    // The thread has ended, and the transport with it: nothing is left that could report this again, or spin.
    EXPECT_FALSE(connection.worker().isOpen());
    QCoreApplication::processEvents();
    EXPECT_EQ(connection.store().link().phase, LinkPhase::Disconnected);
    EXPECT_EQ(connection.count<PortClosed>(), 1);
}

/// It is noticed without anything being sent.
TEST(F27_Unplug, OfALineThatIsSilentIsSaidByThePortItself) {
    auto terminal = PtyServer::create({});
    ASSERT_TRUE(terminal.has_value());
    SerialTransport transport(QString::fromStdString(terminal->path()));
    ASSERT_TRUE(transport.open().has_value());
    terminal = tl::unexpected(std::string("gone"));
    const Wakeup nobody;
    const auto received = transport.receive(std::nullopt, nobody.fd());
    ASSERT_FALSE(received.has_value());
    EXPECT_EQ(received.error().problem, PortProblem::Gone);
}

/// Also F-27: it is reported once, the port is closed, and the next connection works.
TEST(F28_UnplugDuringACommand, IsToldOnceDropsTheQueueAndReplaysNothing) {
    const QString link = QStringLiteral("/tmp/nmc-replay-%1").arg(::getpid());
    Connection connection;
    const QStringList ordered{QStringLiteral("set_gain"), QStringLiteral("stop_motor"),
                              QStringLiteral("load_trajectory"), QStringLiteral("start_motion")};
    {
        NmcsimProcess sim(QStringLiteral("servo"), {QStringLiteral("--link"), link});
        connection.openSerial(link);
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
        ASSERT_EQ(connection.carryOut(move(0, 100)), bus::Outcome::Done);
        for (const QString& command : ordered)
            EXPECT_TRUE(executed(sim).contains(command)) << command.toStdString();
        connection.forgetNews();
        // The line is never idle during polling, and this queue takes seconds.
        for (int i = 0; i < 200; ++i)
            connection.submit(gainsAndEnable(0));
        ASSERT_TRUE(connection.waitFor<bus::OperationFinished>());
    }
    expectGoneOnce(connection);
    connection.submit(move(0, 2'000));  // while no module is there

    connection.forgetNews();
    NmcsimProcess again(QStringLiteral("servo"), {QStringLiteral("--link"), link});
    connection.openSerial(link);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_TRUE(connection.waitUntil([&] { return connection.module(0).latest.has_value(); }));
    for (const QString& command : ordered)
        EXPECT_FALSE(executed(again).contains(command)) << command.toStdString();
}

TEST(H13_SecondInstance, IsNamedWithItsNumberAlsoByAnotherNameOfThePort) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    QProcess other;
    other.start(QStringLiteral(CRASHER_PATH),
                {sim.terminal(), QStringLiteral("gui"), QStringLiteral("kill")});
    // It locks the port before it opens it.
    const QString files = QStringLiteral("/proc/%1/fd/").arg(other.processId());
    const auto holds = [&] {
        for (const QString& file : QDir(files).entryList(QDir::System))
            if (QFile::symLinkTarget(files + file) == sim.terminal())
                return true;
        return false;
    };
    ASSERT_TRUE(eventually(holds));
    const QString alias = QStringLiteral("/tmp/nmc-second-%1").arg(::getpid());
    ASSERT_EQ(::symlink(sim.terminal().toLocal8Bit().constData(), alias.toLocal8Bit().constData()), 0);
    for (const QString& name : {sim.terminal(), alias}) {
        Connection connection;
        connection.openSerial(name);
        ASSERT_TRUE(connection.waitFor<PortClosed>());
        const PortError& error = *connection.news<PortClosed>()->error;
        EXPECT_EQ(error.problem, PortProblem::InUse) << name.toStdString();
        EXPECT_EQ(error.program, "crasher") << name.toStdString();
        EXPECT_EQ(error.pid, other.processId()) << name.toStdString();
    }
    ::unlink(alias.toLocal8Bit().constData());
    other.kill();
    other.waitForFinished();
}

TEST(F25_Rate, ThatTheAdapterRoundsAwayIsRefusedBeforeAByteIsSent) {
    NmcsimProcess sim(QStringLiteral("servo"));
    Connection connection;
    connection.open([port = sim.terminal()] {
        return std::make_unique<SerialTransport>(port, 57'600, [](int) { return 59'524U; });
    });
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    EXPECT_EQ(connection.news<PortClosed>()->error->problem, PortProblem::RateNotPossible);
    EXPECT_TRUE(connection.news<PortClosed>()->error->detail.find("59524") != std::string::npos);
    EXPECT_EQ(sim.control(QStringLiteral("time"))[QStringLiteral("received")].toInt(-1), 0);
}

/// The chain was left at that rate by another adapter.
TEST(F25_Rate, ThatIsRememberedAndThatTheAdapterCannotMakeIsNotSearched) {
    NmcsimProcess sim(QStringLiteral("servo"));
    Connection connection;
    bus::EngineConfig config;
    config.knownBaud = 250'000;
    connection.open(
        [port = sim.terminal()] {
            return std::make_unique<SerialTransport>(port, 19'200, [](int fd) {
                const auto rate = lineRate(fd);
                return rate == 250'000U ? std::optional(230'000U) : rate;
            });
        },
        config);
    // Whether its module is found also depends on how busy this computer is.
    EXPECT_TRUE(connection.waitUntil([&] {
        return connection.news<bus::ChainFound>() != nullptr ||
               connection.news<bus::ConnectFailed>() != nullptr;
    }));
}

TEST(F25_Rate, ThatATerminalTakesIsReadBackFromIt) {
    const auto terminal = PtyServer::create({});
    ASSERT_TRUE(terminal.has_value());
    SerialTransport transport(QString::fromStdString(terminal->path()), 57'600);
    ASSERT_TRUE(transport.open().has_value());
    EXPECT_EQ(lineRate(transport.fd()), 19'200U) << "discovery begins at the modules' rate";
    ASSERT_TRUE(transport.setBaud(115'200).has_value());
    EXPECT_EQ(lineRate(transport.fd()), 115'200U);
    EXPECT_FALSE(lineRate(-1).has_value());
}

TEST(H16_NoDescriptorLeft, IsSaidInsteadOfAborting) {
    NmcsimProcess sim(QStringLiteral("servo"));
    Connection connection;
    std::vector<int> taken;
    for (int fd = 0; (fd = ::open("/dev/null", O_RDONLY | O_CLOEXEC)) >= 0;)
        taken.push_back(fd);
    connection.openSerial(sim.terminal());
    const bool closed = connection.waitFor<PortClosed>();
    for (const int fd : taken)
        ::close(fd);
    ASSERT_TRUE(closed);
    EXPECT_EQ(connection.news<PortClosed>()->error->problem, PortProblem::TooManyFiles);
    connection.forgetNews();
    connection.openSerial(sim.terminal());
    // Whether its module is found also depends on how busy this computer is.
    EXPECT_TRUE(connection.waitUntil([&] {
        return connection.news<bus::ChainFound>() != nullptr ||
               connection.news<bus::ConnectFailed>() != nullptr;
    })) << "it works as soon as descriptors are available again";
}

}  // namespace
}  // namespace nmc

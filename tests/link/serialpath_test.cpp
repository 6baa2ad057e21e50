// SPDX-License-Identifier: GPL-3.0-or-later
// The real serial path: QSerialPort on a pseudo-terminal that the real nmcsim process serves.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryFile>
#include <map>

#include "link/terminal/ptyserver.h"
#include "tests/link/asnobody.h"
#include "tests/link/connection.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;

/// A simulated chain, and the connection to it.
struct Path {
    NmcsimProcess sim{QStringLiteral("servo,servo,servo@1")};
    Connection connection;
};

/// All rates at once, because the test mostly waits.
TEST(SerialPath, FindsTheChainMovesAMotorAndStopsItAtEachRate) {
    std::map<std::uint32_t, Path> paths;
    for (const std::uint32_t baud : {19'200U, 115'200U, 57'600U, 9'600U})
        paths[baud].connection.openSerial(paths[baud].sim.terminal(), baud);
    const auto each = [&](const auto& check) {
        for (auto& [baud, path] : paths) {
            SCOPED_TRACE(baud);
            if (!HasFatalFailure())
                check(path.sim, path.connection);
        }
    };
    each([](NmcsimProcess&, Connection& connection) {
        ASSERT_TRUE(connection.waitUntil([&] {
            return connection.count<bus::ChainFound>() + connection.count<bus::ConnectFailed>() > 0;
        }));
        ASSERT_EQ(connection.news<bus::ConnectFailed>(), nullptr)
            << "ConnectFailure " << static_cast<int>(connection.news<bus::ConnectFailed>()->reason);
        ASSERT_EQ(connection.store().link().modules.size(), 3U);
        EXPECT_EQ(connection.module(2).info.identity.version, 1);

        // A program cannot change what is connected to a real port. The line is sent before the gains, so
        // that it would have been answered by now.
        connection.worker().ask(ControlLine{"set 2 power 0"});
        // Without an integral term, the motor rests where the filter no longer overcomes dry friction: at
        // most 2 of 255, which is 2 * 256 / Kp 200 = 2.6 counts.
        ASSERT_EQ(
            connection.carryOut({step(1, servo::SetGain{200, 2'000, 0, 0, 255, 0, 8'000, 1, std::uint8_t{0}}),
                                 step(1, servo::StopMotor{true, servo::StopManner::Abruptly, {}})}),
            bus::Outcome::Done);
        EXPECT_EQ(connection.count<SimulatorAnswered>(), 0);
        ASSERT_EQ(connection.carryOut(move(1, 4'000)), bus::Outcome::Done);
    });
    each([](NmcsimProcess& sim, Connection& connection) {
        ASSERT_TRUE(connection.waitUntil([&] {
            return !connection.module(1).moving() &&
                   std::abs(*connection.module(1).latest->position - 4'000) <= 5;
        }));
        EXPECT_NEAR(sim.state(2)[QStringLiteral("position")].toInt(), 4'000, 5);
        ASSERT_EQ(connection.carryOut(move(1, -100'000'000)), bus::Outcome::Done);
    });
    each([](NmcsimProcess& sim, Connection& connection) {
        ASSERT_TRUE(connection.waitUntil([&] { return *connection.module(1).latest->position < 3'900; }));
        connection.forgetNews();
        connection.worker().stopAll();
        ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
        EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 3U);
        EXPECT_TRUE(connection.news<bus::StopFinished>()->unreached.empty());
        const QJsonObject state = sim.state(2);
        EXPECT_TRUE(state[QStringLiteral("power")].toBool());
        EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool()) << "a stop keeps holding";
        EXPECT_GT(state[QStringLiteral("position")].toInt(), -90'000'000)
            << "it must have been stopped on its way";
        EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool()) << "a stop switches nothing on";

        connection.worker().close();
        ASSERT_TRUE(connection.waitFor<PortClosed>());
        EXPECT_FALSE(connection.news<PortClosed>()->error.has_value());
        EXPECT_EQ(sim.violations(), "");
    });
}

TEST(SerialPathRates, ChangeToAnyDivisorWhileAMotorHoldsAndTheNextConnectionFindsTheChain) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    {
        Connection connection;
        connection.openSerial(sim.terminal());
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        ASSERT_EQ(connection.carryOut(gainsAndEnable(0)), bus::Outcome::Done);
        for (const std::uint32_t baud : {62'500U, 57'600U}) {
            connection.forgetNews();
            connection.worker().ask(ChangeRate{baud});
            ASSERT_TRUE(connection.waitFor<bus::RateChanged>());
            EXPECT_EQ(connection.store().link().baud, baud);
            EXPECT_NEAR(sim.state(1)[QStringLiteral("baud")].toInt(), static_cast<int>(baud), 0.02 * baud);
            EXPECT_TRUE(sim.state(1)[QStringLiteral("servo_on")].toBool());
            const auto before = connection.worker().statistics().answered;
            EXPECT_TRUE(connection.waitUntil(
                [&] { return connection.worker().statistics().answered > before + 50; }));
        }
    }
    Connection next;
    next.openSerial(sim.terminal());
    ASSERT_TRUE(next.waitFor<bus::ChainFound>());
    EXPECT_EQ(next.store().link().modules.size(), 2U);
    EXPECT_EQ(sim.violations(), "");
}

PortProblem problemOf(const QString& port) {
    Connection connection;
    connection.openSerial(port);
    EXPECT_TRUE(connection.waitFor<PortClosed>());
    const auto* closed = connection.news<PortClosed>();
    EXPECT_TRUE(closed != nullptr && closed->error.has_value());
    return closed != nullptr && closed->error ? closed->error->problem : PortProblem::Other;
}

TEST(NoPort, IsNotFound) {
    EXPECT_EQ(problemOf(QStringLiteral("/dev/ttyNMC99")), PortProblem::NotFound);
}

TEST(H19_NotATerminal, IsNotASerialPort) {
    EXPECT_EQ(problemOf(QStringLiteral("/dev/null")), PortProblem::NotASerialPort);
    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    EXPECT_EQ(problemOf(file.fileName()), PortProblem::NotASerialPort);
}

TEST(F35_TwoNames, OfAPortThatIsUsedAreBothInUse) {
    const auto terminal = PtyServer::create({});
    ASSERT_TRUE(terminal.has_value());
    const QString port = QString::fromStdString(terminal->path());
    SerialTransport first(port);
    ASSERT_TRUE(first.open().has_value());
    EXPECT_EQ(problemOf(port), PortProblem::InUse);
    const QString alias = QStringLiteral("/tmp/nmc-alias-%1").arg(::getpid());
    ASSERT_EQ(::symlink(terminal->path().c_str(), alias.toLocal8Bit().constData()), 0);
    EXPECT_EQ(problemOf(alias), PortProblem::InUse);
    ::unlink(alias.toLocal8Bit().constData());
}

TEST(F31_Permission, OfAPortOfAnotherUserIsMissing) {
    const auto terminal = PtyServer::create({});
    ASSERT_TRUE(terminal.has_value());
    ASSERT_EQ(::chmod(terminal->path().c_str(), 0), 0);  // shuts out its owner as well, unless that is root
    const AsNobody nobody;
    Connection connection;
    connection.openSerial(QString::fromStdString(terminal->path()));
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    const PortError& error = *connection.news<PortClosed>()->error;
    EXPECT_EQ(error.problem, PortProblem::NoPermission);
    EXPECT_FALSE(error.user.empty());
}

}  // namespace
}  // namespace nmc

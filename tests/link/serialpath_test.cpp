// SPDX-License-Identifier: GPL-3.0-or-later
// The real serial path: QSerialPort on a pseudo-terminal that the real nmcsim process serves.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryFile>

#include "link/terminal/ptyserver.h"
#include "tests/link/asnobody.h"
#include "tests/link/connection.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;

class SerialPath : public testing::TestWithParam<std::uint32_t> {};

TEST_P(SerialPath, FindsTheChainMovesAMotorAndStopsIt) {
    NmcsimProcess sim(QStringLiteral("servo,servo,servo@1"));
    ASSERT_FALSE(sim.terminal().isEmpty());
    Connection connection;
    connection.openSerial(sim.terminal(), GetParam());
    ASSERT_TRUE(connection.findsChain(3));
    EXPECT_EQ(connection.module(2).info.identity.version, 1);

    ASSERT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(1, 20'000)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return connection.module(1).activity() == Activity::AtSpeed; }));
    ASSERT_TRUE(connection.waitUntil([&] { return !connection.module(1).moving(); }));
    // The integral unwinds the overshoot against friction: that takes seconds.
    ASSERT_TRUE(
        connection.waitUntil([&] { return std::abs(*connection.module(1).latest->position - 20'000) <= 5; }));
    EXPECT_NEAR(sim.state(2)[QStringLiteral("position")].toInt(), 20'000, 5);

    ASSERT_EQ(connection.carryOut(move(1, 0)), bus::Outcome::Done);
    ASSERT_TRUE(connection.waitUntil([&] { return connection.module(1).activity() == Activity::AtSpeed; }));
    connection.forgetNews();
    connection.worker().stopAll();
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    EXPECT_EQ(connection.news<bus::StopFinished>()->stopped.size(), 3U);
    EXPECT_TRUE(connection.news<bus::StopFinished>()->unreached.empty());
    const QJsonObject state = sim.state(2);
    EXPECT_TRUE(state[QStringLiteral("servo_on")].toBool()) << "a stop keeps holding";
    EXPECT_GT(state[QStringLiteral("position")].toInt(), 100) << "it must have been stopped on its way to 0";
    EXPECT_FALSE(sim.state(1)[QStringLiteral("servo_on")].toBool()) << "a stop switches nothing on";

    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    EXPECT_FALSE(connection.news<PortClosed>()->error.has_value());
    EXPECT_EQ(sim.violations(), "");
}

INSTANTIATE_TEST_SUITE_P(Rates, SerialPath, testing::Values(19'200U, 115'200U, 57'600U, 9'600U));

TEST(SerialPathTrouble, AClosedTerminalIsToldOnceAndTheNextConnectionWorks) {
    Connection connection;
    {
        NmcsimProcess sim(QStringLiteral("servo"));
        connection.openSerial(sim.terminal());
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    }
    ASSERT_TRUE(connection.waitFor<PortClosed>());
    ASSERT_TRUE(connection.news<PortClosed>()->error.has_value());
    EXPECT_EQ(connection.news<PortClosed>()->error->problem, PortProblem::Gone);
    EXPECT_FALSE(connection.worker().isOpen());
    EXPECT_EQ(connection.store().link().phase, LinkPhase::Disconnected);
    EXPECT_EQ(connection.count<PortClosed>(), 1);

    connection.forgetNews();
    NmcsimProcess again(QStringLiteral("servo,servo"));
    connection.openSerial(again.terminal());
    EXPECT_TRUE(connection.findsChain(2));
}

TEST(SerialPathTrouble, AChainLeftAtAnotherRateIsFound) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    for (const std::uint32_t baud : {115'200U, 19'200U, 57'600U}) {
        Connection connection;
        connection.openSerial(sim.terminal(), baud);
        ASSERT_TRUE(connection.findsChain(2)) << baud;
    }
}

TEST(SerialPathTrouble, AModuleThatRestartsGoesSilentWhileTheOthersGoOn) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    Connection connection;
    connection.openSerial(sim.terminal());
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    // The module nearest the host: nothing hangs on its ADDR_OUT.
    EXPECT_FALSE(sim.control(QStringLiteral("power-cycle 2")).contains(QStringLiteral("error")));
    ASSERT_TRUE(connection.waitFor<bus::ModuleUnresponsive>());
    EXPECT_EQ(connection.news<bus::ModuleUnresponsive>()->module, ModuleIndex(1));
    EXPECT_EQ(connection.module(1).activity(), Activity::Unresponsive);
    EXPECT_NE(connection.module(0).activity(), Activity::Unresponsive);
}

TEST(SerialPathTrouble, NobodyAnsweringIsSaidAndThePortStaysOpenForAnotherTry) {
    const auto terminal = PtyServer::create({});  // a line with nobody on it
    ASSERT_TRUE(terminal.has_value());
    Connection connection;
    connection.openSerial(QString::fromStdString(terminal->path()));
    ASSERT_TRUE(connection.waitFor<bus::ConnectFailed>());
    EXPECT_EQ(connection.news<bus::ConnectFailed>()->reason, bus::ConnectFailure::NobodyAnswers);
    EXPECT_TRUE(connection.worker().isOpen());
}

PortProblem problemOf(const QString& port) {
    Connection connection;
    connection.openSerial(port);
    EXPECT_TRUE(connection.waitFor<PortClosed>());
    const auto* closed = connection.news<PortClosed>();
    EXPECT_TRUE(closed != nullptr && closed->error.has_value());
    return closed != nullptr && closed->error ? closed->error->problem : PortProblem::Other;
}

TEST(SerialPathTrouble, APortThatIsNotThereIsNotFound) {
    EXPECT_EQ(problemOf(QStringLiteral("/dev/ttyNMC99")), PortProblem::NotFound);
}

TEST(H19_NotATerminal, IsNotASerialPort) {
    EXPECT_EQ(problemOf(QStringLiteral("/dev/null")), PortProblem::NotASerialPort);
    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    EXPECT_EQ(problemOf(file.fileName()), PortProblem::NotASerialPort);
}

TEST(F35_TwoNames, OfAPortThatIsUsedAreBothInUse) {
    NmcsimProcess sim(QStringLiteral("servo"));
    Connection first;
    first.openSerial(sim.terminal());
    ASSERT_TRUE(first.waitFor<bus::ChainFound>());
    EXPECT_EQ(problemOf(sim.terminal()), PortProblem::InUse);
    const QString alias = QStringLiteral("/tmp/nmc-alias-%1").arg(::getpid());
    ASSERT_EQ(::symlink(sim.terminal().toLocal8Bit().constData(), alias.toLocal8Bit().constData()), 0);
    EXPECT_EQ(problemOf(alias), PortProblem::InUse);
    ::unlink(alias.toLocal8Bit().constData());
    first.worker().close();
    EXPECT_TRUE(first.waitFor<PortClosed>());
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

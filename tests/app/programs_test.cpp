// SPDX-License-Identifier: GPL-3.0-or-later
// The programs themselves, as a shell starts them.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>

#include "tests/support/nmcsimprocess.h"
#include "tests/support/patience.h"

namespace nmc {
namespace {

using testing_support::kPatienceMs;

struct Ran {
    int exitCode = -1;
    QString out;
    QString err;
};

Ran run(const char* program, const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QLatin1String(name));
    process.setProcessEnvironment(environment);
    process.start(QLatin1String(program), arguments);
    EXPECT_TRUE(process.waitForFinished(kPatienceMs));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

TEST(H17_NoDisplay, IsNotNeededForHelpVersionAndPorts) {
    for (const char* option : {"--help", "--version", "--list-ports"}) {
        const Ran ran = run(NMCPANEL_PATH, {QLatin1String(option)});
        EXPECT_EQ(ran.exitCode, 0) << option;
        EXPECT_TRUE(ran.err.isEmpty()) << ran.err.toStdString();
    }
}

TEST(Nmcpanel, SaysOneSentenceOnStandardErrorWhenAnArgumentIsWrong) {
    const Ran port = run(NMCPANEL_PATH, {QStringLiteral("--port"), QStringLiteral("/dev/ttyNMC99")});
    EXPECT_EQ(port.exitCode, 3);
    EXPECT_TRUE(port.out.isEmpty());
    EXPECT_EQ(port.err.count(QLatin1Char('\n')), 1) << port.err.toStdString();
    EXPECT_EQ(run(NMCPANEL_PATH, {QStringLiteral("--baud"), QStringLiteral("300")}).exitCode, 2);
    EXPECT_EQ(run(NMCPANEL_PATH, {QStringLiteral("--simulator=pump")}).exitCode, 2);
}

TEST(H17_NoDisplay, IsSaidInsteadOfAborting) {
    const Ran ran = run(NMCPANEL_PATH, {QStringLiteral("--simulator")});
    EXPECT_EQ(ran.exitCode, 3);
    EXPECT_FALSE(ran.err.isEmpty());
}

TEST(Nmcsim, NamesWhatIsWrongInItsArguments) {
    const Ran chain = run(NMCSIM_PATH, {QStringLiteral("--chain"), QStringLiteral("servo,pump")});
    EXPECT_EQ(chain.exitCode, 2);
    EXPECT_TRUE(chain.err.contains(QStringLiteral("pump"))) << chain.err.toStdString();
    EXPECT_EQ(run(NMCSIM_PATH, {QStringLiteral("--speed"), QStringLiteral("fast")}).exitCode, 2);
    EXPECT_EQ(run(NMCSIM_PATH, {QStringLiteral("--speed"), QStringLiteral("nan")}).exitCode, 2);
    EXPECT_EQ(run(NMCSIM_PATH, {QStringLiteral("--frobnicate")}).exitCode, 2);
    EXPECT_EQ(run(NMCSIM_PATH, {QStringLiteral("surplus")}).exitCode, 2);
    EXPECT_EQ(run(NMCSIM_PATH, {QStringLiteral("--help")}).exitCode, 0);
}

TEST(Nmcsim, SurvivesTheEndOfItsInputAndEndsOnSigterm) {
    QProcess process;
    const QString link = QStringLiteral("/tmp/nmcsim-link-%1").arg(QCoreApplication::applicationPid());
    process.start(QLatin1String(NMCSIM_PATH), {QStringLiteral("--link"), link});
    ASSERT_TRUE(process.waitForReadyRead(kPatienceMs));
    EXPECT_TRUE(process.readLine().startsWith("ready /dev/"));
    EXPECT_TRUE(QFileInfo::exists(link));
    process.closeWriteChannel();
    EXPECT_FALSE(process.waitForFinished(200)) << "the end of standard input must not end it";
    process.terminate();
    ASSERT_TRUE(process.waitForFinished(kPatienceMs));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 0);
    EXPECT_FALSE(QFileInfo(link).isSymLink());
}

TEST(Nmcsim, AnswersEveryControlLineWithOneLineOfJson) {
    testing_support::NmcsimProcess sim(QStringLiteral("servo,servo@2"));
    EXPECT_EQ(sim.state(2)[QStringLiteral("version")].toInt(), 2);
    for (const char* bad : {"", "state", "state 3", "state x", "set 1 limit1 7", "set 1 colour 1", "launch"})
        EXPECT_TRUE(sim.control(QLatin1String(bad)).contains(QStringLiteral("error"))) << bad;
    EXPECT_FALSE(sim.control(QStringLiteral("set 1 load 0.01")).contains(QStringLiteral("error")));
    EXPECT_GE(sim.control(QStringLiteral("time"))[QStringLiteral("ticks")].toInt(-1), 0);
}

}  // namespace
}  // namespace nmc

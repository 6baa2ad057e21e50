// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commandline.h"

#include <gtest/gtest.h>

#include <QTemporaryFile>

namespace nmc {
namespace {

const QList<PortEntry> kPorts{{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("FTDI USB Serial")},
                              {QStringLiteral("/dev/ttyS0"), {}}};

std::variant<Start, Say> read(const QStringList& arguments) {
    return readCommandLine(QStringList{QStringLiteral("nmcpanel")} + arguments, [] { return kPorts; });
}

Start started(const QString& arguments) {
    const auto asked = read(arguments.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    const auto* start = std::get_if<Start>(&asked);
    EXPECT_NE(start, nullptr) << arguments.toStdString();
    return start != nullptr ? *start : Start{};
}

Say said(const QString& arguments) {
    const auto asked = read(arguments.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    const auto* say = std::get_if<Say>(&asked);
    EXPECT_NE(say, nullptr) << arguments.toStdString();
    return say != nullptr ? *say : Say{};
}

TEST(CommandLine, TakesTheAddressOfADeviceServer) {
    for (const char* address : {"tcp://moxa:4001", "rfc2217://[::1]:4001"})
        EXPECT_EQ(started(QStringLiteral("--port ") + QLatin1String(address)).port, QLatin1String(address));
    for (const char* wrong : {"tcp://moxa", "rfc2217://moxa:x", "rfc2217://:4001"}) {
        const Say say = said(QStringLiteral("--port ") + QLatin1String(wrong));
        EXPECT_EQ(say.exitCode, 2) << wrong;
        EXPECT_TRUE(say.text.contains(QLatin1String(wrong))) << say.text.toStdString();
        EXPECT_TRUE(say.text.contains(QStringLiteral("rfc2217://HOST:PORT"))) << say.text.toStdString();
    }
}

TEST(CommandLine, ConnectsToNothingUnlessAsked) {
    EXPECT_FALSE(started(QString()).port.has_value());
    EXPECT_EQ(started(QString()).baud, 19'200U);
}

TEST(CommandLine, TakesAPortAndARate) {
    const Start start = started(QStringLiteral("--port /dev/ttyUSB0 --baud 115200"));
    EXPECT_EQ(start.port, QStringLiteral("/dev/ttyUSB0"));
    EXPECT_EQ(start.baud, 115'200U);
    // By its full name, under which its chain is remembered.
    EXPECT_EQ(started(QStringLiteral("--port=ttyUSB0")).port, QStringLiteral("/dev/ttyUSB0"));
}

TEST(CommandLine, TakesTheSimulatorWithAndWithoutAChain) {
    EXPECT_EQ(started(QStringLiteral("--simulator")).port, QStringLiteral("simulator=servo,servo,step"));
    EXPECT_EQ(started(QStringLiteral("--simulator=servo,servo@1")).port,
              QStringLiteral("simulator=servo,servo@1"));
}

TEST(CommandLine, TheChainMayStandBehindTheSimulatorAsTheHelpWritesIt) {
    EXPECT_TRUE(said(QStringLiteral("--help")).text.contains(QStringLiteral("--simulator <CHAIN>")));
    EXPECT_EQ(started(QStringLiteral("--simulator servo,servo@1")).port,
              QStringLiteral("simulator=servo,servo@1"));
    EXPECT_EQ(started(QStringLiteral("--simulator --baud 9600")).port,
              QStringLiteral("simulator=servo,servo,step"));
    EXPECT_EQ(started(QStringLiteral("--simulator step --baud 9600")).baud, 9'600U);
    const Say say = said(QStringLiteral("--simulator servoo"));
    EXPECT_EQ(say.exitCode, 2);
    EXPECT_TRUE(say.text.contains(QStringLiteral("servoo"))) << say.text.toStdString();
}

TEST(CommandLine, ASpaceAndAnEqualsSignBeforeTheChainMeanTheSame) {
    for (const char* chain : {"servo", "servo,step", "servo@1,servo@4,step@1"}) {
        const QString before = QStringLiteral("--enable-faults --simulator");
        const QString behind = QLatin1String(chain) + QStringLiteral(" --baud 57600 --read-only mill.json");
        for (const QLatin1Char sign : {QLatin1Char(' '), QLatin1Char('=')}) {
            const Start start = started(before + sign + behind);
            EXPECT_EQ(start.port, QStringLiteral("simulator=") + QLatin1String(chain));
            EXPECT_EQ(start.baud, 57'600U);
            EXPECT_TRUE(start.readOnly);
            EXPECT_TRUE(start.enableFaults);
            EXPECT_EQ(start.machine, QStringLiteral("mill.json"));
        }
    }
    EXPECT_EQ(said(QStringLiteral("--simulator gizmo")).text, said(QStringLiteral("--simulator=gizmo")).text);
}

TEST(CommandLine, ProgramsMayMoveMotorsOnlyIfItSaysControl) {
    EXPECT_TRUE(said(QStringLiteral("--help")).text.contains(QStringLiteral("--serve <control>")));
    EXPECT_EQ(started(QString()).programs, Start::Programs::KeptOut);
    const Start alone = started(QStringLiteral("--serve mill.json"));
    EXPECT_EQ(alone.programs, Start::Programs::LetIn);
    EXPECT_EQ(alone.machine, QStringLiteral("mill.json"));
    for (const char* words : {"--serve=control mill.json", "--serve control mill.json"}) {
        const Start start = started(QLatin1String(words));
        EXPECT_EQ(start.programs, Start::Programs::MayMove) << words;
        EXPECT_EQ(start.machine, QStringLiteral("mill.json")) << words;
    }
    const Say say = said(QStringLiteral("--serve=foo"));
    EXPECT_EQ(say.exitCode, 2);
    EXPECT_EQ(say.text, QStringLiteral("Use --serve alone or as --serve=control."));
}

TEST(CommandLine, TakesOneMachineFile) {
    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    EXPECT_EQ(started(QStringLiteral("mill.json")).machine, QStringLiteral("mill.json"));
    EXPECT_FALSE(started(QString()).machine.has_value());
    const Start both = started(QStringLiteral("--simulator ") + file.fileName());
    EXPECT_EQ(both.machine, file.fileName()) << "the file exists, and it is not a chain";
    EXPECT_EQ(both.port, QStringLiteral("simulator=servo,servo,step"));
    EXPECT_EQ(said(QStringLiteral("mill.json lathe.json")).exitCode, 2);
}

TEST(CommandLine, LooksOnlyWhereAskedAndAtSomething) {
    EXPECT_FALSE(started(QStringLiteral("--port ttyUSB0")).readOnly);
    EXPECT_TRUE(started(QStringLiteral("--port ttyUSB0 --read-only")).readOnly);
    EXPECT_TRUE(started(QStringLiteral("--read-only --simulator")).readOnly);
    const Say say = said(QStringLiteral("--read-only"));
    EXPECT_EQ(say.exitCode, 2);
    EXPECT_TRUE(say.text.contains(QStringLiteral("--port"))) << say.text.toStdString();
}

TEST(CommandLine, FaultsAreOnlyForThoseWhoAskForThem) {
    EXPECT_FALSE(started(QStringLiteral("--simulator")).enableFaults);
    EXPECT_TRUE(started(QStringLiteral("--simulator --enable-faults")).enableFaults);
}

TEST(CommandLine, ListsPortsWithTheirDescriptions) {
    const Say say = said(QStringLiteral("--list-ports"));
    EXPECT_EQ(say.exitCode, 0);
    EXPECT_EQ(say.text, QStringLiteral("/dev/ttyUSB0\tFTDI USB Serial\n/dev/ttyS0"));
}

TEST(CommandLine, ExplainsEveryOption) {
    const Say say = said(QStringLiteral("--help"));
    EXPECT_EQ(say.exitCode, 0);
    for (const char* option : {"--port", "--baud", "--simulator", "--read-only", "--enable-faults",
                               "--list-ports", "--help", "--version"})
        EXPECT_TRUE(say.text.contains(QLatin1String(option))) << option;
    EXPECT_TRUE(said(QStringLiteral("--version")).text.startsWith(QStringLiteral("NMC Panel 0.")));
}

TEST(CommandLine, SaysWhichPortsThereAreWhenOneIsNot) {
    const Say say = said(QStringLiteral("--port /dev/ttyUSB7"));
    EXPECT_EQ(say.exitCode, 3);
    EXPECT_TRUE(say.text.contains(QStringLiteral("/dev/ttyUSB7"))) << say.text.toStdString();
    EXPECT_TRUE(say.text.contains(QStringLiteral("/dev/ttyUSB0"))) << say.text.toStdString();
}

TEST(CommandLine, SaysWhichRatesThereAre) {
    for (const char* bad : {"--baud 38400", "--baud fast", "--baud -1", "--baud 0"}) {
        const Say say = said(QLatin1String(bad));
        EXPECT_EQ(say.exitCode, 2) << bad;
        for (const char* rate : {"9600", "19200", "57600", "115200"})
            EXPECT_TRUE(QString(say.text).remove(QLatin1Char(' ')).contains(QLatin1String(rate)))
                << say.text.toStdString();
    }
}

TEST(CommandLine, NamesWhatIsWrongInAChain) {
    const Say say = said(QStringLiteral("--simulator=servo,gizmo"));
    EXPECT_EQ(say.exitCode, 2);
    EXPECT_TRUE(say.text.contains(QStringLiteral("gizmo"))) << say.text.toStdString();
    EXPECT_EQ(said(QStringLiteral("--simulator=")).exitCode, 2);
    EXPECT_EQ(said(QStringLiteral("--simulator=servo@9")).exitCode, 2);
}

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
    for (const char* bad : {"--frobnicate", "mill.json surplus", "--port", "--list-ports=3"})
        EXPECT_EQ(said(QLatin1String(bad)).exitCode, 2) << bad;
    EXPECT_TRUE(said(QStringLiteral("--frobnicate")).text.contains(QStringLiteral("frobnicate")));
}

}  // namespace
}  // namespace nmc

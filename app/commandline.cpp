// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commandline.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>

#include "link/ports/networkline.h"
#include "protocol/baud.h"
#include "sim/chainspec.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

constexpr int kBadArguments = 2;
constexpr int kNoSuchPort = 3;

class CommandLine {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

const QString kPort = QStringLiteral("port");
const QString kBaud = QStringLiteral("baud");
const QString kSimulator = QStringLiteral("simulator");
const QString kReadOnly = QStringLiteral("read-only");
const QString kServe = QStringLiteral("serve");
const QString kControl = QStringLiteral("control");
const QString kEnableFaults = QStringLiteral("enable-faults");
const QString kListPorts = QStringLiteral("list-ports");
const QString kHelp = QStringLiteral("help");
const QString kVersion = QStringLiteral("version");
const QString kQuitAfterFirstPaint = QStringLiteral("quit-after-first-paint");

void declareOptions(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        CommandLine::tr("Control panel for Networked Modular Control motor modules."));
    QCommandLineOption benchmark(kQuitAfterFirstPaint);
    benchmark.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addPositionalArgument(QStringLiteral("file"), CommandLine::tr("Machine file to open at startup."),
                                 QStringLiteral("[FILE]"));
    parser.addOptions({
        {kPort,
         CommandLine::tr(
             "Connect to a serial port at startup, or to one at a device server: tcp://HOST:PORT or rfc2217://HOST:PORT."),
         CommandLine::tr("NAME")},
        {kBaud, CommandLine::tr("Baud rate of the chain: 9600, 19200 (default), 57600 or 115200."),
         CommandLine::tr("N")},
        {kSimulator,
         CommandLine::tr(
             "Connect to the built-in simulator at startup. CHAIN lists its modules, the one farthest from the host first; the default is %1.")
             .arg(QString::fromUtf8(sim::kDefaultChain)),
         CommandLine::tr("CHAIN")},
        {kReadOnly,
         CommandLine::tr(
             "With --port or --simulator: connect read-only. Only status requests are sent, and closing does not stop motors. STOP ALL still works.")},
        {kServe,
         CommandLine::tr(
             "Let other programs in from the start. With =control, one of them may move motors without the user being asked."),
         kControl},
        {kEnableFaults, CommandLine::tr("Allow control lines to inject faults into the built-in simulator.")},
        {kListPorts, CommandLine::tr("List the serial ports of this computer.")},
        {{QStringLiteral("h"), kHelp}, CommandLine::tr("Show this help.")},
        {{QStringLiteral("v"), kVersion}, CommandLine::tr("Show the version.")},
        benchmark,
    });
}

/// For an argument that may be a chain or a file: true if such a file exists and it is not a valid chain.
bool isFile(const QString& argument) {
    return !sim::parseChain(argument.toStdString()) && QFileInfo::exists(argument);
}

/// QCommandLineParser does not support options with an optional value.
QStringList withOptionalValues(const QStringList& arguments) {
    QStringList all;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        QString argument = arguments[i];
        if (argument == QStringLiteral("--") + kSimulator) {
            const QString next = arguments.value(i + 1);
            const bool given = !next.isEmpty() && !next.startsWith(QLatin1Char('-')) && !isFile(next);
            argument += QLatin1Char('=') + (given ? next : QString::fromUtf8(sim::kDefaultChain));
            i += given ? 1 : 0;
        } else if (argument == QStringLiteral("--") + kServe) {
            const bool given = arguments.value(i + 1) == kControl;
            argument += QLatin1Char('=') + (given ? kControl : QString());
            i += given ? 1 : 0;
        }
        all << argument;
    }
    return all;
}

QString portTable(const QList<PortEntry>& ports) {
    QStringList lines;
    for (const PortEntry& port : ports)
        lines << (port.description.isEmpty() ? port.name : port.name + QLatin1Char('\t') + port.description);
    return lines.join(QLatin1Char('\n'));
}

/// The full name of the port, by which the panel remembers its chain; empty if there is none.
QString fullName(const QString& port, const QList<PortEntry>& ports) {
    for (const PortEntry& entry : ports)
        if (entry.name == port || entry.name == QStringLiteral("/dev/") + port)
            return entry.name;
    // Terminals of simulators and udev links are not in the list, but are equally usable, and so is a
    // network.
    return QFileInfo::exists(port) || isNetworkName(port.toStdString()) ? port : QString();
}

std::optional<Say> readPort(const QCommandLineParser& parser, const std::function<QList<PortEntry>()>& ports,
                            Start& start) {
    if (parser.isSet(kSimulator)) {
        const QString chain = parser.value(kSimulator);
        if (const auto parsed = sim::parseChain(chain.toStdString()); !parsed)
            return Say{texts::badChain(chain, QString::fromStdString(parsed.error())), kBadArguments};
        start.port = kSimulatorPort + QLatin1Char('=') + chain;
    } else if (parser.isSet(kPort)) {
        const QString name = parser.value(kPort);
        if (isNetworkName(name.toStdString()) && !parseNetworkLine(name.toStdString())) {
            const Message message =
                texts::portProblem({PortProblem::NotANetworkLine, name.toStdString(), {}, {}, {}});
            return Say{message.headline + QLatin1Char(' ') + message.body, kBadArguments};
        }
        const QList<PortEntry> known = ports();
        const QString full = fullName(name, known);
        if (full.isEmpty()) {
            QStringList names;
            for (const PortEntry& port : known)
                names << port.name;
            return Say{texts::unknownPort(name, names), kNoSuchPort};
        }
        start.port = full;
    }
    return std::nullopt;
}

}  // namespace

std::variant<Start, Say> readCommandLine(const QStringList& arguments,
                                         const std::function<QList<PortEntry>()>& ports) {
    QCommandLineParser parser;
    declareOptions(parser);
    if (!parser.parse(withOptionalValues(arguments))) {
        const QStringList unknown = parser.unknownOptionNames();
        return Say{unknown.isEmpty() ? parser.errorText() : texts::unknownOption(unknown.first()),
                   kBadArguments};
    }
    if (parser.positionalArguments().size() > 1)
        return Say{texts::unknownOption(parser.positionalArguments().last()), kBadArguments};
    if (parser.isSet(kHelp))
        return Say{parser.helpText(), 0};
    if (parser.isSet(kVersion))
        return Say{QStringLiteral("NMC Panel " NMC_VERSION), 0};
    if (parser.isSet(kListPorts))
        return Say{portTable(ports()), 0};

    Start start;
    if (!parser.positionalArguments().isEmpty())
        start.machine = parser.positionalArguments().first();
    start.quitAfterFirstPaint = parser.isSet(kQuitAfterFirstPaint);
    start.enableFaults = parser.isSet(kEnableFaults);
    if (parser.isSet(kBaud)) {
        const auto baud = findBaud(parser.value(kBaud).toUInt());
        if (!baud)
            return Say{texts::badBaud(parser.value(kBaud)), kBadArguments};
        start.baud = baud->nominal;
    }
    if (parser.isSet(kServe)) {
        const QString what = parser.value(kServe);
        if (!what.isEmpty() && what != kControl)
            return Say{texts::badServe(), kBadArguments};
        start.programs = what.isEmpty() ? Start::Programs::LetIn : Start::Programs::MayMove;
    }
    if (const auto say = readPort(parser, ports, start))
        return *say;
    start.readOnly = parser.isSet(kReadOnly);
    if (start.readOnly && !start.port)
        return Say{texts::readOnlyWithoutPort(), kBadArguments};
    return start;
}

}  // namespace nmc

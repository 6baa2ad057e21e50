// SPDX-License-Identifier: GPL-3.0-or-later
// nmcctl: commands for motors from a shell, through a panel or at a port of its own.
#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QTextStream>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/ctlcommands.h"
#include "app/headlessline.h"
#include "app/longoptions.h"
#include "app/panelsettings.h"
#include "app/translations.h"
#include "app/unixsignals.h"
#include "link/connection/crashburst.h"
#include "link/files/machineio.h"
#include "model/machinefile/machinefile.h"
#include "protocol/baud.h"
#include "sim/chainspec.h"
#include "widgets/common/languages.h"
#include "widgets/common/texts.h"

namespace {

using nmc::CtlCommands;

const QString kServe = QStringLiteral("serve");

struct Options {
    QString socket;
    nmc::ConnectTarget line{.port = {}, .baud = nmc::kPowerUpBaud};  ///< no port: a panel has it
    QString machine;
    QList<QStringList> commands;
};

QTextStream& out() {
    static QTextStream stream(stdout);
    return stream;
}
QTextStream& problems() {
    static QTextStream stream(stderr);
    return stream;
}

[[noreturn]] void refuse(const QString& sentence, int exitCode = CtlCommands::BadArguments) {
    problems() << "nmcctl: " << sentence << Qt::endl;
    std::exit(exitCode);
}

void printHelp() {
    out()
        << "Usage: nmcctl [OPTION]... COMMAND [WORD]...\n"
           "Commands NMC motor modules through a panel that lets programs in, or at a serial port of its own.\n"
           "\n"
           "AXIS is the name of an axis or its number from 1. Values are in the unit of the axis, which may\n"
           "follow them: 12.5mm, 20mm/s, 100mm/s2. For an axis in counts, velocities are per tick of its servo,\n"
           "not per second: 1counts/tick, 0.01counts/tick2; a PIC-STEP has steps, steps/s and steps/s2. At a\n"
           "port of its own, a command ends when its motion does.\n"
           "\n"
           "Options:\n"
           "  --socket PATH          the socket of the panel, if several let programs in\n"
           "  --port NAME            use this serial port, without a panel\n"
           "  --simulator[=CHAIN]    use the built-in simulator; default "
        << QString::fromUtf8(nmc::sim::kDefaultChain)
        << "\n"
           "  --baud N               with --port: rate of the chain; default 19200\n"
           "  --machine FILE         with --port: names, units and travel limits of the axes\n"
           "  --read-only            with --port: read only; the chain is left as it is\n"
           "  --help                 show this help\n"
           "  --version              show the version\n"
           "\n"
           "Commands:\n"
        << CtlCommands::help()
        << "  serve                  with --port: let programs in, as a panel does, until it is terminated;\n"
           "                         one of them may move motors, and nobody is asked\n"
           "  -                      read commands from standard input, one in a line, until one fails\n"
           "\n"
           "Exit codes:\n"
           "  0                      done\n"
           "  1                      refused; the sentence says why\n"
           "  2                      the arguments are wrong; nothing was requested\n"
           "  3                      no panel lets programs in, the port cannot be used or is gone, or nothing can\n"
           "                         be let in there\n"
           "  4                      the user refused, another program may move motors, or control was lost\n"
           "  5                      begun, but ended by a stop or a fault\n"
           "  130                    interrupted; motors are stopped\n"
           "\n"
           "Examples:\n"
           "  nmcctl move X 12.5mm --wait\n"
           "      the panel asks its user, and the command ends when X has come to rest\n"
           "  nmcctl --port /dev/ttyUSB0 --machine bench.json serve\n"
           "      a computer without a screen, for programs in Python or another nmcctl\n"
           "  nmcctl --simulator=servo list\n"
           "      no hardware at all\n";
    out().flush();
}

void readCommands(Options& options, const QStringList& words) {
    options.commands = {words};
    if (words == QStringList{QStringLiteral("-")}) {
        options.commands.clear();
        QTextStream input(stdin);
        for (QString line; input.readLineInto(&line);)
            if (const QStringList command = QProcess::splitCommand(line);
                !command.isEmpty() && !command[0].startsWith(QLatin1Char('#')))
                options.commands << command;
    }
    const bool serves = words.value(0) == kServe;
    if (serves && (options.line.port.isEmpty() || words.size() > 1))
        refuse(QStringLiteral("serve stands alone, and needs --port or --simulator."));
    for (const QStringList& command : options.commands)
        if (!serves && !CtlCommands::names().contains(command[0]))
            refuse(QStringLiteral("There is no command \"%1\". nmcctl --help lists them.").arg(command[0]));
}

Options readOptions(int argc, char** argv) {
    Options options;
    bool hasPort = false, hasBaud = false, simulates = false;
    const auto text = [](const char* value) {
        if (*value == '\0')  // most likely a variable of a script that is not set
            refuse(QStringLiteral("The value of an option is empty."));
        return QString::fromLocal8Bit(value);
    };
    const std::vector<nmc::LongOption> all{
        {"socket", required_argument,
         // QLocalSocket would look for a relative path in the folder for temporary files.
         [&](const char* value) { options.socket = QFileInfo(text(value)).absoluteFilePath(); }},
        {"port", required_argument,
         [&](const char* value) {
             options.line.port = text(value);
             hasPort = true;
         }},
        {"simulator", optional_argument,
         [&](const char* value) {
             const std::string chain = value != nullptr ? value : std::string(nmc::sim::kDefaultChain);
             if (const auto parsed = nmc::sim::parseChain(chain); !parsed)
                 refuse(nmc::texts::badChain(text(value), QString::fromStdString(parsed.error())));
             options.line.port = nmc::kSimulatorPort + QLatin1Char('=') + QString::fromStdString(chain);
             simulates = true;
         }},
        {"baud", required_argument,
         [&](const char* value) {
             const auto baud = nmc::findBaud(text(value).toUInt());
             if (!baud)
                 refuse(nmc::texts::badBaud(text(value)));
             options.line.baud = baud->nominal;
             hasBaud = true;
         }},
        {"machine", required_argument, [&](const char* value) { options.machine = text(value); }},
        {"read-only", no_argument, [&](const char*) { options.line.readOnly = true; }},
    };
    if (!nmc::takeLongOptions(argc, argv, "+", all, &printHelp, "nmcctl " NMC_VERSION))
        refuse(QStringLiteral("Try nmcctl --help."));
    QStringList words;
    for (int i = optind; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    if (words.isEmpty())
        refuse(QStringLiteral("A command is missing. nmcctl --help lists them."));
    if (options.line.port.isEmpty() && (hasBaud || options.line.readOnly || !options.machine.isEmpty()))
        refuse(QStringLiteral("--baud, --machine and --read-only need --port or --simulator."));
    if (hasPort && simulates)
        refuse(QStringLiteral("--simulator does without the chain at --port."));
    if (!options.line.port.isEmpty() && !options.socket.isEmpty())
        refuse(QStringLiteral("--socket is that of a panel, and --port and --simulator do without one."));
    readCommands(options, words);
    return options;
}

QString wordsOf(const nmc::Message& message) {
    return (message.headline + QLatin1Char(' ') + message.body).trimmed();
}

nmc::Machine readMachine(const QString& path) {
    if (path.isEmpty())
        return {};
    const auto text = nmc::readFile(path, nmc::kMaxMachineFile);
    if (!text)
        refuse(wordsOf(nmc::texts::machineNotOpened(text.error())));
    const auto machine = nmc::parseMachine(*text);
    if (!machine)
        refuse(wordsOf(nmc::texts::machineNotOpened(path, machine.error())));
    return machine->machine;
}

/// The socket of the only panel that lets programs in.
QString onlyPanel() {
    const QStringList sockets = nmc::ApiClient::sockets();
    if (sockets.isEmpty())
        refuse(QStringLiteral("No panel lets programs in. Switch on Chain, Let programs in, or give --port."),
               CtlCommands::NotReached);
    if (sockets.size() > 1)
        refuse(QStringLiteral("Several panels let programs in. Give one of these as --socket: %1")
                   .arg(sockets.join(QLatin1Char(' '))),
               CtlCommands::NotReached);
    return sockets.first();
}

/// `line`: of this process; null: a panel's.
int carryOut(const Options& options, const QString& socket, nmc::HeadlessLine* line,
             const nmc::UnixSignals& interruption) {
    nmc::ApiClient client;
    const QObject whileItLives;
    using Error = nmc::ApiClient::Error;
    QObject::connect(&interruption, &nmc::UnixSignals::terminationAsked, &whileItLives, [&client] {
        client.end({Error::Kind::Interrupted, QStringLiteral("Interrupted.")});
    });
    if (line != nullptr)
        QObject::connect(line, &nmc::HeadlessLine::lost, &whileItLives, [&client] {
            client.end({Error::Kind::Gone, QStringLiteral("The line is gone.")});
        });
    if (const auto reached = client.connectTo(socket, QStringLiteral("nmcctl")); !reached) {
        problems() << "nmcctl: " << socket << ": " << reached.error().sentence << Qt::endl;
        const bool interrupted = reached.error().kind == Error::Kind::Interrupted;
        return interrupted ? CtlCommands::Interrupted : CtlCommands::NotReached;
    }
    CtlCommands commands(client, line != nullptr, out(), problems());
    for (const QStringList& words : options.commands)
        if (const auto exit = commands.run(words); exit != CtlCommands::Done)
            return exit;
    return line == nullptr ? commands.leaveRunning() : CtlCommands::Done;
}

template <typename Condition>
void waitFor(const Condition& condition) {
    while (!condition())
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
}

int runAtOwnLine(const Options& options, QSettings& settings) {
    const bool serves = options.commands.value(0).value(0) == kServe;
    const nmc::crashburst::HandlerStack stack;
    nmc::crashburst::installHandlers();
    nmc::HeadlessLine line(settings, readMachine(options.machine));
    const nmc::UnixSignals interruption(&line.worker());
    bool found = false, lost = false, interrupted = false, ended = false;
    QObject::connect(&line, &nmc::HeadlessLine::reported, &line, [serves](const nmc::Message& message) {
        if (serves || message.severity != nmc::Severity::Normal)
            problems() << wordsOf(message) << Qt::endl;
    });
    QObject::connect(&line, &nmc::HeadlessLine::connected, &line, [&found] { found = true; });
    QObject::connect(&line, &nmc::HeadlessLine::lost, &line, [&lost] { lost = true; });
    QObject::connect(&line, &nmc::HeadlessLine::ended, &line, [&ended] { ended = true; });
    QObject::connect(&interruption, &nmc::UnixSignals::terminationAsked, &line,
                     [&interrupted] { interrupted = true; });
    line.open(options.line);
    waitFor([&] { return found || lost || interrupted; });
    int exit = CtlCommands::NotReached;
    const bool letsIn = !line.socket().isEmpty();  // or why not has been reported
    if (found && letsIn && !serves && !interrupted)
        exit = carryOut(options, line.socket(), &line, interruption);
    else if (found && letsIn)
        waitFor([&] { return lost || interrupted; });
    if (interrupted && exit != CtlCommands::Done)  // a recording is done when it is interrupted
        exit = serves ? CtlCommands::Done : CtlCommands::Interrupted;
    line.end();
    waitFor([&] { return ended; });
    return exit;
}

}  // namespace

int main(int argc, char** argv) {
    nmc::nameApplication();
    const QCoreApplication application(argc, argv);
    nmc::PanelSettings settings;
    nmc::Translations translations;
    nmc::installTranslations(translations,
                             nmc::languages::localeOf(settings.value(nmc::languages::kSetting).toString()));
    const Options options = readOptions(argc, argv);
    if (!options.line.port.isEmpty())
        return runAtOwnLine(options, settings);
    const nmc::UnixSignals interruption(nullptr);
    return carryOut(options, options.socket.isEmpty() ? onlyPanel() : options.socket, nullptr, interruption);
}

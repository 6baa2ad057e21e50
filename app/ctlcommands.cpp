// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ctlcommands.h"

#include <QDateTime>
#include <QFile>
#include <QRegularExpression>
#include <QTimer>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "model/api/apirecording.h"

namespace nmc {

namespace {

using Kind = api::Field::Kind;
using Json = api::Json;
template <typename T>
using Or = tl::expected<T, QString>;

/// Less than half of the time after which a motor stops that is jogged (bus/holdtask.h).
constexpr int kJogEvery = 50;        // ms
constexpr int kAnswersWithin = 200;  // ms, to request_control if the user is not asked
constexpr auto kWait = "wait";
constexpr double kMostSeconds = 1e7;

/// Those that a command line has no use for, or that have a command made by hand.
constexpr std::array kNotAsTheyAre{"hello", "describe",        "state",           "subscribe",
                                   "jog",   "request_control", "release_control", "set_gains"};

[[nodiscard]] QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

/// A number means the axis with this number, even if another one has it for a name.
[[nodiscard]] Json axisOf(const QString& given) {
    bool isWhole = false;
    const qint64 number = given.toLongLong(&isWhole);
    return isWhole ? Json(number) : Json(given.toStdString());
}

/// A number, a text or "-" for what is not known.
[[nodiscard]] QString shown(const Json& value) {
    if (value.is_null())
        return QStringLiteral("-");
    if (value.is_number_float())
        return QString::number(value.get<double>(), 'g', 10);
    if (value.is_structured()) {
        const bool rows = value.is_array() && !value.empty() && value.front().is_object();
        QStringList parts(rows ? 1 : 0);
        for (const auto& [key, part] : value.items())
            parts << (value.is_object() ? text(key) + QLatin1Char('=') : QString()) + shown(part);
        return parts.join(rows ? QStringLiteral("\n    ") : QStringLiteral(" "));
    }
    return value.is_string() ? text(value.get<std::string>()) : text(value.dump());
}

/// The name of an axis, or its number if it has none.
[[nodiscard]] QString nameOf(const Json& axis) {
    const QString name = text(axis.at("name").get<std::string>());
    return name.isEmpty() ? shown(axis.at("number")) : name;
}

[[nodiscard]] QString placeOf(const Json& axis) {
    const Json& position = axis.at("position");
    return shown(position) + (position.is_null() ? QString() : QLatin1Char(' ') + shown(axis.at("unit")));
}

[[nodiscard]] Or<QDeadlineTimer> endAfter(const QString& given) {
    bool isNumber = false;
    const double seconds = given.toDouble(&isNumber);
    if (!isNumber || !(seconds >= 0 && seconds <= kMostSeconds))
        return tl::unexpected(QStringLiteral("\"%1\" is not a number of seconds.").arg(given));
    return QDeadlineTimer(std::chrono::milliseconds(std::llround(1e3 * seconds)), Qt::PreciseTimer);
}

/// The end of a command that goes on until it is interrupted, or for --seconds.
[[nodiscard]] Or<QDeadlineTimer> endOf(const QMap<QString, QString>& options) {
    const auto given = options.find(QStringLiteral("seconds"));
    if (given == options.end())
        return QDeadlineTimer(QDeadlineTimer::Forever);
    return endAfter(*given);
}

[[nodiscard]] bool isOneOf(const std::string& name, const auto& names) {
    return std::ranges::find(names, name) != std::end(names);
}

/// Methods that move a motor to a goal. A search for home may end with the motor off, if that is its recipe's
/// stop; any other goal cannot have been reached then.
[[nodiscard]] bool movesToGoal(const std::string& method) {
    return isOneOf(method, std::array{"move", "move_by", "go_home", "home"});
}

/// Numbers of an axis may carry its unit.
[[nodiscard]] QString unitOf(Kind kind, const Json& axis) {
    switch (kind) {
        case Kind::Velocity:
            return shown(axis.at("velocity_unit"));
        case Kind::Acceleration:
            return shown(axis.at("velocity_unit")) + QLatin1Char('2');
        case Kind::Position:
        case Kind::Distance:
        case Kind::Axis:
        case Kind::Whole:
        case Kind::Flag:
        case Kind::Text:
            break;
    }
    return shown(axis.at("unit"));
}

}  // namespace

// ---- the table ----

CtlCommands::Command CtlCommands::commandOf(const api::Method& method) {
    Command command{.name = text(method.name).replace(QLatin1Char('_'), QLatin1Char('-')),
                    .text = text(method.text),
                    .act = &CtlCommands::callMethod,
                    .method = &method};
    if (method.name == "start_sequence")
        command.name = QStringLiteral("run-sequence");
    command.usage = command.name;
    QString options;
    for (const api::Field& field : method.fields) {
        const QString word = text(field.name).toUpper();
        if (field.required || field.kind == Kind::Axis) {
            command.usage += field.required ? QLatin1Char(' ') + word : QStringLiteral(" [%1]").arg(word);
            command.least += field.required ? 1 : 0;
            ++command.most;
        } else {
            command.options << text(field.name);
            options += QStringLiteral(" [--%1 %2]").arg(text(field.name), word.left(1));
        }
    }
    command.usage += options;
    if (method.access == api::Access::Control || (method.access == api::Access::Stop && command.most > 0)) {
        command.flags << QLatin1String(kWait);
        command.usage += QStringLiteral(" [--wait]");
    }
    return command;
}

const QList<CtlCommands::Command>& CtlCommands::commands() {
    static const QList<Command> all = [] {
        QList<Command> list{
            {.name = QStringLiteral("list"),
             .usage = QStringLiteral("list"),
             .text = QStringLiteral("Lists the axes: number, name, chip, state, position."),
             .act = &CtlCommands::list},
            {.name = QStringLiteral("state"),
             .usage = QStringLiteral("state [AXIS] [--json]"),
             .text = QStringLiteral("Shows all that is known of the axes."),
             .flags = {QStringLiteral("json")},
             .most = 1,
             .act = &CtlCommands::state},
            {.name = QStringLiteral("watch"),
             .usage = QStringLiteral("watch [--seconds S]"),
             .text = QStringLiteral("Shows each change and each message until it is interrupted."),
             .options = {QStringLiteral("seconds")},
             .act = &CtlCommands::watch},
            {.name = QStringLiteral("record"),
             .usage = QStringLiteral("record FILE [--seconds S]"),
             .text = QStringLiteral(
                 "Records all samples until it is interrupted, in a file that the scope can open."),
             .options = {QStringLiteral("seconds")},
             .least = 1,
             .most = 1,
             .act = &CtlCommands::record},
            {.name = QStringLiteral("gains"),
             .usage = QStringLiteral("gains AXIS [--get] [--set NAME=VALUE...] [--wait]"),
             .text = QStringLiteral(
                 "Shows the gains of a PIC-SERVO, or sends them; those left out stay as they are."),
             .flags = {QStringLiteral("get"), QStringLiteral("set"), QLatin1String(kWait)},
             .least = 1,
             .most = static_cast<qsizetype>(api::findMethod("set_gains")->fields.size()),
             .act = &CtlCommands::gains,
             .method = api::findMethod("set_gains")},
            {.name = QStringLiteral("jog"),
             .usage = QStringLiteral("jog AXIS VELOCITY SECONDS"),
             .text = QStringLiteral("Moves for that long; the sign of VELOCITY is the direction."),
             .least = 3,
             .most = 3,
             .act = &CtlCommands::jog,
             .method = api::findMethod("jog")},
        };
        for (const api::Method& method : api::methods())
            if (!isOneOf(method.name, kNotAsTheyAre))
                list << commandOf(method);
        return list;
    }();
    return all;
}

QString CtlCommands::help() {
    QString lines;
    for (const Command& command : commands())
        lines += QStringLiteral("  %1\n                         %2\n").arg(command.usage, command.text);
    return lines;
}

QStringList CtlCommands::names() {
    QStringList names;
    for (const Command& command : commands())
        names << command.name;
    return names;
}

// ---- words ----

CtlCommands::Exit CtlCommands::run(const QStringList& words) {
    const auto command = std::ranges::find(commands(), words.value(0), &Command::name);
    if (command == commands().end()) {
        m_problems << "There is no command \"" << words.value(0) << "\". nmcctl --help lists them."
                   << Qt::endl;
        return BadArguments;
    }
    Words rest;
    for (qsizetype i = 1; i < words.size(); ++i) {
        const QString& word = words[i];
        if (!word.startsWith(QStringLiteral("--"))) {
            rest.values << word;
            continue;
        }
        const QString name = word.mid(2).section(QLatin1Char('='), 0, 0);
        if (command->flags.contains(name) && !word.contains(QLatin1Char('='))) {
            rest.flags << name;
        } else if (command->options.contains(name) && word.contains(QLatin1Char('='))) {
            rest.options[name] = word.section(QLatin1Char('='), 1);
        } else if (command->options.contains(name) && i + 1 < words.size()) {
            rest.options[name] = words[++i];
        } else {
            return usage(
                *command,
                QStringLiteral("\"%1\" is not an option of this command, or has no value.").arg(word));
        }
    }
    if (rest.values.size() < command->least)
        return usage(*command, QStringLiteral("Something is missing."));
    if (rest.values.size() > command->most)
        return usage(*command, QStringLiteral("\"%1\" is too much.").arg(rest.values[command->most]));
    const Exit exit = (this->*command->act)(*command, rest);
    m_out.flush();
    return exit == Done ? written() : exit;
}

CtlCommands::Exit CtlCommands::written() {
    m_out.flush();
    if (m_out.status() == QTextStream::Ok)
        return Done;
    m_problems << "The output could not be written." << Qt::endl;
    return NotCarriedOut;
}

CtlCommands::Exit CtlCommands::usage(const Command& command, const QString& problem) {
    m_problems << problem << "\nUsage: " << command.usage << Qt::endl;
    return BadArguments;
}

Or<Json> CtlCommands::parametersOf(const api::Method& method, const Words& words) {
    Json parameters = Json::object();
    Json axis;
    qsizetype next = 0;
    for (const api::Field& field : method.fields) {
        const QString name = text(field.name);
        const bool positional = field.required || field.kind == Kind::Axis;
        if (positional ? next >= words.values.size() : !words.options.contains(name))
            continue;
        const QString given = positional ? words.values[next++] : words.options[name];
        if (field.kind == Kind::Axis)
            axis = axisState(given).value_or(Json());  // the panel refuses what is no axis
        const auto value = valueOf(field, given, axis);
        if (!value)
            return tl::unexpected(value.error());
        parameters[field.name] = *value;
    }
    return parameters;
}

/// Whether the value is possible is for the other end to say.
Or<Json> CtlCommands::valueOf(const api::Field& field, const QString& given, const Json& axis) {
    static const QRegularExpression measure(
        QStringLiteral(R"(^([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)$)"));
    static const QStringList yes{QStringLiteral("on"), QStringLiteral("high"), QStringLiteral("1")};
    static const QStringList no{QStringLiteral("off"), QStringLiteral("low"), QStringLiteral("0")};
    bool isWhole = false;
    const qint64 whole = given.toLongLong(&isWhole);
    switch (field.kind) {
        case Kind::Axis:
            return axisOf(given);
        case Kind::Text:
            return Json(given.toStdString());
        case Kind::Whole:
            if (!isWhole)
                return tl::unexpected(QStringLiteral("\"%1\" is not a whole number.").arg(given));
            return Json(whole);
        case Kind::Flag:
            if (!yes.contains(given) && !no.contains(given))
                return tl::unexpected(QStringLiteral("\"%1\" is neither on nor off.").arg(given));
            return Json(yes.contains(given));
        case Kind::Position:
        case Kind::Distance:
        case Kind::Velocity:
        case Kind::Acceleration:
            break;
    }
    const auto parts = measure.match(given);
    if (!parts.hasMatch())
        return tl::unexpected(QStringLiteral("\"%1\" is not a number.").arg(given));
    if (const QString unit = parts.captured(2);
        !unit.isEmpty() && !axis.is_null() && unit != unitOf(field.kind, axis))
        return tl::unexpected(QStringLiteral("\"%1\" has to be in %2, the unit of the axis.")
                                  .arg(given, unitOf(field.kind, axis)));
    return Json(parts.captured(1).toDouble());
}

tl::expected<Json, ApiClient::Error> CtlCommands::axisState(const QString& axis) {
    return m_client.call("state", {{"axis", axisOf(axis)}});
}

// ---- what is read ----

CtlCommands::Exit CtlCommands::list(const Command&, const Words&) {
    const auto state = m_client.call("state");
    if (!state)
        return report(state.error());
    for (const Json& axis : state->at("modules"))
        m_out << shown(axis.at("number")) << '\t' << shown(axis.at("name")) << '\t' << shown(axis.at("type"))
              << '\t' << shown(axis.at("state")) << '\t' << placeOf(axis) << '\n';
    return Done;
}

CtlCommands::Exit CtlCommands::state(const Command&, const Words& words) {
    const bool one = !words.values.isEmpty();
    const auto state = one ? axisState(words.values[0]) : m_client.call("state");
    if (!state)
        return report(state.error());
    if (words.has("json")) {
        m_out << text(state->dump()) << '\n';
        return Done;
    }
    for (const Json& axis : one ? Json::array({*state}) : state->at("modules")) {
        m_out << nameOf(axis) << '\n';
        for (const auto& [key, value] : axis.items())
            m_out << "  " << text(key) << ": " << shown(value) << '\n';
    }
    return Done;
}

/// The commands after this one are sent nothing that they have not asked for.
tl::expected<CtlCommands::Exit, ApiClient::Error> CtlCommands::follow(
    const Json& subscription, const QDeadlineTimer& until,
    const std::function<Exit(const std::string& method, const Json& parameters)>& take) {
    if (const auto begun = m_client.call("subscribe", subscription); !begun)
        return tl::unexpected(begun.error());
    Exit exit = Done;
    while (exit == Done) {
        const auto news = next(until);
        if (!news)
            return tl::unexpected(news.error());
        if (!*news)
            break;
        exit = take((*news)->at("method").get<std::string>(), (*news)->at("params"));
    }
    if (const auto ended = m_client.call("subscribe"); !ended)
        return tl::unexpected(ended.error());
    (void)mayMove();
    return exit;
}

ApiClient::Or<std::optional<CtlCommands::Json>> CtlCommands::next(const QDeadlineTimer& until) {
    auto news = m_client.next(until);
    if (news && *news && (*news)->at("method") == "control_lost")
        m_control = false;
    return news;
}

bool CtlCommands::mayMove() {
    const QDeadlineTimer now;
    for (auto news = next(now); news && *news;)
        news = next(now);
    return m_control;
}

CtlCommands::Exit CtlCommands::watch(const Command& command, const Words& words) {
    const auto until = endOf(words.options);
    if (!until)
        return usage(command, until.error());
    QMap<int, QString> before;  // by number: several axes may have one name
    const auto show = [&](const std::string& method, const Json& parameters) {
        if (method == "event")
            m_out << shown(parameters.at("text")) << '\n';
        else if (method == "state")
            for (const Json& axis : parameters.at("modules"))
                if (const QString now = placeOf(axis) + QLatin1Char('\t') + shown(axis.at("state"));
                    std::exchange(before[axis.at("number").get<int>()], now) != now)
                    m_out << nameOf(axis) << '\t' << now << '\n';
        return written();
    };
    const auto exit = follow({{"state", true}, {"events", true}}, *until, show);
    return exit ? *exit : report(exit.error());
}

CtlCommands::Exit CtlCommands::record(const Command& command, const Words& words) {
    const auto until = endOf(words.options);
    if (!until)
        return usage(command, until.error());
    const auto state = m_client.call("state");
    if (!state)
        return report(state.error());
    QFile file(words.values[0]);
    const auto notWritten = [&](Exit exit) {
        m_problems << file.fileName() << ": " << file.errorString() << Qt::endl;
        return exit;
    };
    if (!file.open(QIODevice::WriteOnly))
        return notWritten(BadArguments);
    api::ApiRecording recording(*state, "nmcctl " NMC_VERSION,
                                QDateTime::currentDateTime().toString(Qt::ISODateWithMs).toStdString());
    const auto write = [&](const std::string& rows) {
        const bool written = file.write(rows.data(), static_cast<qint64>(rows.size())) >= 0 && file.flush();
        return written ? Done : notWritten(NotCarriedOut);
    };
    if (const Exit begun = write(recording.head()); begun != Done)
        return begun;
    const auto exit =
        follow({{"samples", true}}, *until, [&](const std::string& method, const Json& parameters) {
            if (method != "samples")
                return Done;
            if (recording.isOfThisChain(parameters))
                return write(recording.rowsOf(parameters));
            m_problems << "Another chain is at the port now. The recording has ended." << Qt::endl;
            return NotCarriedOut;
        });
    if (!exit && exit.error().kind == ApiClient::Error::Kind::Interrupted)
        return Done;
    return exit ? *exit : report(exit.error());
}

CtlCommands::Exit CtlCommands::gains(const Command& command, const Words& words) {
    if (words.has("set") && words.has("get"))
        return usage(command, QStringLiteral("Gains are either shown or sent."));
    const auto state = axisState(words.values[0]);
    if (!state)
        return report(state.error());
    const Json& axis = *state;
    if (!words.has("set")) {
        if (words.values.size() > 1)
            return usage(command, QStringLiteral("Gains are sent only with --set."));
        const Json& gains = axis.at("gains");
        if (gains.is_null())
            m_out << (axis.at("type") == "servo" ? "not known: they cannot be read from a module\n"
                                                 : "none: only a PIC-SERVO has gains\n");
        for (const auto& [name, value] : gains.items())
            m_out << text(name) << '=' << shown(value) << '\n';
        return Done;
    }
    Json parameters{{"axis", axisOf(words.values[0])}};
    const auto& fields = command.method->fields;
    for (const QString& word : words.values.mid(1)) {
        const std::string name = word.section(QLatin1Char('='), 0, 0).toLower().toStdString();
        const auto gain = std::ranges::find(fields, name, &api::Field::name);
        if (gain == fields.end() || gain->kind != Kind::Whole)
            return usage(command, QStringLiteral("There is no gain \"%1\".").arg(text(name)));
        bool isWhole = false;
        const qint64 value = word.section(QLatin1Char('='), 1).toLongLong(&isWhole);
        if (!isWhole)
            return usage(command, QStringLiteral("\"%1\" is not NAME=VALUE.").arg(word));
        parameters[name] = value;
    }
    return request(*command.method, parameters, words.has(kWait));
}

// ---- what is commanded ----

CtlCommands::Exit CtlCommands::callMethod(const Command& command, const Words& words) {
    const auto parameters = parametersOf(*command.method, words);
    if (!parameters)
        return usage(command, parameters.error());
    return request(*command.method, *parameters, words.has(kWait));
}

CtlCommands::Exit CtlCommands::request(const api::Method& method, const Json& parameters, bool waits) {
    if (method.access == api::Access::Control)
        if (const auto problem = takeControl(parameters.value("axis", Json())))
            return *problem;
    if (movesToGoal(method.name))
        warnOfLimits(shown(parameters["axis"]));
    if (const auto done = m_client.call(method.name, parameters); !done)
        return report(done.error());
    const bool one = parameters.contains("axis");
    const QString axis = one ? shown(parameters["axis"]) : QString();
    if (method.name == "stop" && !one)
        m_control = false;  // as for every program
    if (isOneOf(method.name, std::array{"stop", "wait"}))
        noteOver(axis);
    else if (method.access == api::Access::Control)
        m_underway.insert(axis);
    if (!(waits || m_alwaysWaits) || method.access == api::Access::Read)
        return Done;
    const auto rest = m_client.call("wait", one ? Json{{"axis", parameters["axis"]}} : Json::object());
    // A stop of all motors has cancelled what this program had requested before, and they are at rest.
    if (!rest && method.name == "stop" && !one && rest.error().reason == "NotCarriedOut")
        return Done;
    if (!rest)
        return reportEnd(rest.error());
    noteOver(axis);
    if (one && movesToGoal(method.name) && method.name != "home" && rest->at("on") == false) {
        m_problems << "The motor has gone off." << Qt::endl;
        return NotCarriedOut;
    }
    if (one)
        showPlace(*rest);
    return Done;
}

CtlCommands::Exit CtlCommands::jog(const Command& command, const Words& words) {
    const Json axis = axisState(words.values[0]).value_or(Json());
    const auto velocity = valueOf({"velocity", Kind::Velocity, true, {}}, words.values[1], axis);
    auto until = endAfter(words.values[2]);
    if (!velocity || !until)
        return usage(command, velocity ? until.error() : velocity.error());
    const Json parameters{{"axis", axisOf(words.values[0])}, {"velocity", *velocity}};
    if (const auto problem = takeControl(parameters["axis"]))
        return *problem;
    until = endAfter(words.values[2]);  // from now on: the user may have taken a while to answer
    for (bool begun = false; !until->hasExpired(); begun = true) {
        if (const auto held = m_client.call("jog", parameters); !held)
            return begun ? reportEnd(held.error()) : report(held.error());
        const auto pause = next(QDeadlineTimer(std::min<qint64>(kJogEvery, until->remainingTime())));
        if (!pause)
            return report(pause.error());
    }
    return request(*api::findMethod("stop"), {{"axis", parameters["axis"]}}, true);
}

void CtlCommands::warnOfLimits(const QString& axis) {
    const Json state = axisState(axis).value_or(Json());
    if (!state.is_null() && state.at("travel_limits_in_force") == false)
        m_problems << "The travel limits of " << nameOf(state) << " are not in force: its home is unknown."
                   << Qt::endl;
}

/// A PIC-I/O has no place.
void CtlCommands::showPlace(const Json& axis) {
    if (!axis.at("position").is_null())
        m_out << nameOf(axis) << '\t' << placeOf(axis) << '\n';
}

std::optional<CtlCommands::Exit> CtlCommands::takeControl(const Json& axis) {
    // The user is not asked about an axis that does not exist.
    if (!m_control && !axis.is_null())
        if (const auto state = m_client.call("state", {{"axis", axis}}); !state)
            return report(state.error());
    if (mayMove())
        return std::nullopt;
    // A panel answers at once unless it really asks.
    QTimer asked;
    asked.setSingleShot(true);
    QObject::connect(&asked, &QTimer::timeout, &asked, [this] {
        m_problems << "The panel asks its user whether this program may move motors." << Qt::endl;
    });
    if (m_client.about().value("asks_user", false))
        asked.start(kAnswersWithin);
    const auto answer = m_client.call("request_control");
    if (!answer)
        return report(answer.error());
    m_control = answer->at("granted") == true;
    if (m_control)
        return std::nullopt;
    const std::string reason = answer->value("reason", "");
    m_problems << (reason == "Refused" ? "The user has refused."
                   : reason == "InUse" ? "Another program may move motors."
                   : reason == "Asking"
                       ? "The user is being asked about another request. Run the command again after that."
                       : "The user has refused, or another program may move motors.")
               << Qt::endl;
    return NoControl;
}

void CtlCommands::noteOver(const QString& axis) {
    if (axis.isEmpty())
        m_underway.clear();
    else
        m_underway.erase(axis);
}

CtlCommands::Exit CtlCommands::leaveRunning() {
    if (mayMove()) {  // otherwise the user would be asked again
        const auto left = m_client.call("request_control", {{"on_disconnect", "finish"}});
        return left || m_underway.empty() ? Done : report(left.error());
    }
    if (m_underway.empty())
        return Done;
    m_problems << "Control is lost: what was not waited for may have been stopped." << Qt::endl;
    return NotCarriedOut;
}

CtlCommands::Exit CtlCommands::report(const ApiClient::Error& error) {
    using ErrorKind = ApiClient::Error::Kind;
    const bool isLost = error.reason == "NoControl";  // which it had: takeControl()
    m_problems
        << (isLost
                ? QStringLiteral(
                      "Control was lost: motors were stopped, the user took over, or the chain was disconnected. Run the command again.")
                : error.sentence)
        << Qt::endl;
    switch (error.kind) {
        case ErrorKind::NotReached:
        case ErrorKind::Gone:
            return NotReached;
        case ErrorKind::Interrupted:
            return Interrupted;
        case ErrorKind::Refused:
            break;
    }
    if (isOneOf(error.reason,
                std::array{"FieldMissing", "FieldWrong", "AxisUnknown", "AxisAmbiguous", "SequenceUnknown"}))
        return BadArguments;
    if (error.reason == "NotConnected")
        return NotReached;
    if (isOneOf(error.reason, std::array{"NotCarriedOut", "NotSettled"}))
        return NotCarriedOut;
    return isLost ? NoControl : Refused;
}

CtlCommands::Exit CtlCommands::reportEnd(const ApiClient::Error& error) {
    const Exit exit = report(error);
    return exit == NotReached || exit == Interrupted ? exit : NotCarriedOut;
}

}  // namespace nmc

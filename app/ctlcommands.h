// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QMap>
#include <QString>
#include <QStringList>
#include <QTextStream>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include <tl/expected.hpp>

#include "link/api/apiclient.h"
#include "model/api/apimethods.h"

namespace nmc {

/// The commands of nmcctl, carried out by a program that lets others in (docs/api.md). Most of them are its
/// methods: their parameters and help come from the table of methods. Waits as ApiClient does.
class CtlCommands {
public:
    /// How a command ended, as an exit code.
    enum Exit : std::uint8_t {
        Done = 0,
        Refused = 1,        ///< a precondition is not met
        BadArguments = 2,   ///< nothing was requested
        NotReached = 3,     ///< no panel and no port, or they have gone
        NoControl = 4,      ///< the user, or another program, has the motors
        NotCarriedOut = 5,  ///< begun, and not carried out to the end; or a file could not be written
        Interrupted = 130,
    };

    /// `waits`: every command waits until its motion is over, because the line closes after the last one.
    CtlCommands(ApiClient& client, bool waits, QTextStream& out, QTextStream& problems)
        : m_client(client), m_alwaysWaits(waits), m_out(out), m_problems(problems) {}

    /// Carries out the command that the words are, the first one being its name.
    [[nodiscard]] Exit run(const QStringList& words);
    /// Call before closing the connection after success: moves that were not waited for go on. If that fails,
    /// they are stopped.
    [[nodiscard]] Exit leaveRunning();

    /// One command in a line, with what it does, for --help.
    [[nodiscard]] static QString help();
    [[nodiscard]] static QStringList names();

private:
    using Json = api::Json;
    /// The words after the name.
    struct Words {
        QStringList values{};              ///< without a name
        QMap<QString, QString> options{};  ///< --NAME VALUE
        QStringList flags{};               ///< --NAME
        [[nodiscard]] bool has(const char* flag) const { return flags.contains(QLatin1String(flag)); }
    };
    struct Command {
        QString name;
        QString usage{};
        QString text{};
        QStringList flags{};            ///< --NAME
        QStringList options{};          ///< --NAME VALUE
        qsizetype least = 0, most = 0;  ///< number of values
        Exit (CtlCommands::*act)(const Command& command, const Words& words) = nullptr;
        const api::Method* method = nullptr;
    };

    [[nodiscard]] static const QList<Command>& commands();
    [[nodiscard]] static Command commandOf(const api::Method& method);

    Exit callMethod(const Command& command, const Words& words);
    Exit list(const Command& command, const Words& words);
    Exit state(const Command& command, const Words& words);
    Exit watch(const Command& command, const Words& words);
    Exit gains(const Command& command, const Words& words);
    Exit jog(const Command& command, const Words& words);
    Exit record(const Command& command, const Words& words);

    [[nodiscard]] tl::expected<Json, QString> parametersOf(const api::Method& method, const Words& words);
    [[nodiscard]] tl::expected<Json, QString> valueOf(const api::Field& field, const QString& text,
                                                      const Json& axis);
    /// The state of one axis, or why the panel refuses it.
    [[nodiscard]] tl::expected<Json, ApiClient::Error> axisState(const QString& axis);
    /// Unless this program has it. `axis`: that of the command; null if it has none.
    [[nodiscard]] std::optional<Exit> takeControl(const Json& axis);
    [[nodiscard]] Exit request(const api::Method& method, const Json& parameters, bool waits);
    /// Calls `take` with each notification until then, or until it does not return Done.
    [[nodiscard]] tl::expected<Exit, ApiClient::Error> follow(
        const Json& subscription, const QDeadlineTimer& until,
        const std::function<Exit(const std::string& method, const Json& parameters)>& take);
    /// ApiClient::next(), which may report that control is lost.
    [[nodiscard]] ApiClient::Or<std::optional<Json>> next(const QDeadlineTimer& until);
    /// Whether it still has control after what has been notified of until now, which is dropped.
    [[nodiscard]] bool mayMove();
    /// It was stopped or waited for; without an axis, everything was.
    void noteOver(const QString& axis);
    void warnOfLimits(const QString& axis);
    void showPlace(const Json& axis);
    /// Whether all of the output is; says so if it is not.
    [[nodiscard]] Exit written();
    [[nodiscard]] Exit usage(const Command& command, const QString& problem);
    Exit report(const ApiClient::Error& error);
    /// Of what was begun, and so was not refused.
    Exit reportEnd(const ApiClient::Error& error);

    ApiClient& m_client;
    bool m_alwaysWaits;
    QTextStream& m_out;
    QTextStream& m_problems;
    bool m_control = false;        ///< mayMove() knows better
    std::set<QString> m_underway;  ///< axes, as written, begun and not waited for; empty: a sequence
};

}  // namespace nmc

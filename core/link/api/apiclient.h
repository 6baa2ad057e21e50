// SPDX-License-Identifier: MIT
#pragma once

#include <QDeadlineTimer>
#include <QLocalSocket>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace nmc {

/// A program's end of the socket that ApiServer opens (docs/api.md). call() and next() wait, and process the
/// events of the application meanwhile, so that the other end may be in the same thread. Not reentrant.
class ApiClient {
public:
    using Json = nlohmann::ordered_json;

    struct Error {
        enum class Kind : std::uint8_t {
            NotReached,   ///< nothing accepts connections at the path
            Gone,         ///< the other end has closed the connection, or what it is for has gone
            Refused,      ///< by the other end; `reason` is for programs
            Interrupted,  ///< by the user
        };
        Kind kind;
        QString sentence;
        std::string reason{};
    };
    template <typename T>
    using Or = tl::expected<T, Error>;

    /// The sockets at which programs are let in, by name; those that a panel left behind when it crashed are
    /// passed over.
    [[nodiscard]] static QStringList sockets();

    /// Connects and says hello as `program`. Call first, and once.
    [[nodiscard]] Or<void> connectTo(const QString& path, const QString& program);

    /// The result of hello.
    [[nodiscard]] const Json& about() const { return m_about; }
    /// The result of a method.
    [[nodiscard]] Or<Json> call(const std::string& method, const Json& parameters = Json::object());
    /// The next notification that was subscribed to, in order of arrival; empty if none came until then.
    [[nodiscard]] Or<std::optional<Json>> next(const QDeadlineTimer& until = QDeadlineTimer::Forever);
    /// Ends the wait that is in progress, and every later one, with the error that was stated first; no
    /// method is called any more.
    void end(const Error& why) {
        if (!m_end)
            m_end = why;
    }

private:
    [[nodiscard]] Or<std::optional<Json>> line(const QDeadlineTimer& until);

    QLocalSocket m_socket;
    Json m_about;
    int m_lastId = 0;
    std::deque<Json> m_notifications;
    std::optional<Error> m_end;  ///< see end()
};

}  // namespace nmc

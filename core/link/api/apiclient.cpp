// SPDX-License-Identifier: MIT
#include "link/api/apiclient.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <utility>

#include "link/api/apiserver.h"
#include "model/api/apimethods.h"

namespace nmc {

using namespace nlohmann::literals;

namespace {

[[nodiscard]] auto unexpected(ApiClient::Error::Kind kind, const QString& sentence) {
    return tl::unexpected(ApiClient::Error{kind, sentence});
}

[[nodiscard]] auto noPanel() {
    return unexpected(ApiClient::Error::Kind::Gone,
                      QStringLiteral("The program that answers is not NMC Panel."));
}

}  // namespace

QStringList ApiClient::sockets() {
    const QDir folder = QFileInfo(ApiServer::pathFor(QStringLiteral("any"))).dir();
    QStringList paths;
    for (const QString& name : folder.entryList({QStringLiteral("*.sock")}, QDir::System, QDir::Name))
        if (const QString path = folder.filePath(name); ApiServer::isServed(path))
            paths << path;
    return paths;
}

ApiClient::Or<void> ApiClient::connectTo(const QString& path, const QString& program) {
    m_socket.connectToServer(path);
    if (!m_socket.waitForConnected())
        return unexpected(Error::Kind::NotReached, QStringLiteral("No panel lets programs in here."));
    auto hello = call("hello", {{"protocol", api::kProtocol}, {"program", program.toStdString()}});
    if (!hello)
        return tl::unexpected(hello.error());
    if (!hello->is_object() || !hello->contains("protocol"))
        return noPanel();
    m_about = std::move(*hello);
    return {};
}

ApiClient::Or<ApiClient::Json> ApiClient::call(const std::string& method, const Json& parameters) {
    if (m_end)
        return tl::unexpected(*m_end);
    const Json request{{"jsonrpc", "2.0"}, {"id", ++m_lastId}, {"method", method}, {"params", parameters}};
    m_socket.write(QByteArray::fromStdString(request.dump()) + '\n');
    while (true) {
        auto arrived = line(QDeadlineTimer::Forever);
        if (!arrived)
            return tl::unexpected(arrived.error());
        Json& answer = **arrived;
        const Json id = answer.value("id", Json());
        const bool unread = id.is_null() && answer.contains("error");  // it cannot say which line that was
        if (answer.contains("method")) {
            m_notifications.push_back(std::move(answer));
        } else if (id == m_lastId || unread) {
            if (answer.contains("result"))
                return answer["result"];
            const Json message = answer.value("/error/message"_json_pointer, Json());
            const Json reason = answer.value("/error/data/reason"_json_pointer, Json());
            if (!message.is_string() || !reason.is_string())
                return noPanel();
            return tl::unexpected(Error{Error::Kind::Refused, QString::fromStdString(message), reason});
        }
    }
}

ApiClient::Or<std::optional<ApiClient::Json>> ApiClient::next(const QDeadlineTimer& until) {
    if (m_notifications.empty()) {
        auto arrived = line(until);
        if (!arrived || !*arrived)
            return arrived;
        m_notifications.push_back(std::move(**arrived));
    }
    Json first = std::move(m_notifications.front());
    m_notifications.pop_front();
    return first;
}

ApiClient::Or<std::optional<ApiClient::Json>> ApiClient::line(const QDeadlineTimer& until) {
    QTimer alarm;  // makes processEvents() return
    if (!until.isForever())
        alarm.start(std::chrono::milliseconds(until.remainingTime()));
    while (!m_socket.canReadLine()) {
        if (m_end)
            return tl::unexpected(*m_end);
        if (m_socket.state() != QLocalSocket::ConnectedState)
            return unexpected(Error::Kind::Gone, QStringLiteral("The panel has gone."));
        if (until.hasExpired())
            return std::nullopt;
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    Json json = Json::parse(m_socket.readLine().toStdString(), nullptr, false);
    if (!json.is_object())
        return noPanel();
    return json;
}

}  // namespace nmc

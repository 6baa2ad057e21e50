// SPDX-License-Identifier: MIT
#include "link/api/apiserver.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QLocalSocket>
#include <QRegularExpression>
#include <QStandardPaths>
#include <cerrno>
#include <cstring>

namespace nmc {

namespace {

constexpr int kLinesAtOnce = 32;     ///< of one client, so that no client keeps the others waiting
constexpr int kAnswersWithin = 200;  ///< ms, in which a panel that runs accepts a connection

[[nodiscard]] bool isOurs(const struct stat& status) {
    return status.st_uid == geteuid() && (status.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

[[nodiscard]] QString systemReason() {
    return QString::fromLocal8Bit(std::strerror(errno));
}

}  // namespace

ApiServer::ApiServer(QObject* parent) : QObject(parent) {
    m_server.setSocketOptions(QLocalServer::UserAccessOption);
    connect(&m_server, &QLocalServer::newConnection, this, &ApiServer::accept);
}

QString ApiServer::pathFor(const QString& port) {
    static const QRegularExpression unusual(QStringLiteral("[^A-Za-z0-9._-]"));
    QString name = QFileInfo(port).fileName();
    name.replace(unusual, QStringLiteral("_"));
    return QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation) + QStringLiteral("/nmcpanel/") +
           name + QStringLiteral(".sock");
}

bool ApiServer::isServed(const QString& path) {
    QLocalSocket socket;
    socket.connectToServer(path);
    return socket.waitForConnected(kAnswersWithin);
}

tl::expected<void, ApiServerProblem> ApiServer::listen(const QString& path) {
    using Kind = ApiServerProblem::Kind;
    close();
    const QByteArray folder = QFile::encodeName(QFileInfo(path).absolutePath());
    if (::mkdir(folder.constData(), S_IRWXU) != 0 && errno != EEXIST)
        return tl::unexpected(ApiServerProblem{Kind::System, QString::fromLocal8Bit(folder), systemReason()});
    struct stat status {};
    if (::lstat(folder.constData(), &status) != 0 || !S_ISDIR(status.st_mode) || !isOurs(status))
        return tl::unexpected(ApiServerProblem{Kind::NotPrivate, QString::fromLocal8Bit(folder)});
    const QByteArray socket = QFile::encodeName(path);
    if (::lstat(socket.constData(), &status) == 0) {
        if (!S_ISSOCK(status.st_mode) || !isOurs(status))
            return tl::unexpected(ApiServerProblem{Kind::NotPrivate, path});
        if (isServed(path))
            return tl::unexpected(ApiServerProblem{Kind::InUse, path});
        QLocalServer::removeServer(path);
    }
    if (!m_server.listen(path))
        return tl::unexpected(ApiServerProblem{Kind::System, path, m_server.errorString()});
    ::chmod(socket.constData(), S_IRUSR | S_IWUSR);  // Qt leaves the right to execute it
    return {};
}

void ApiServer::close() {
    m_server.close();
    while (!m_clients.empty())
        drop(m_clients.begin()->first);
}

void ApiServer::accept() {
    while (QLocalSocket* socket = m_server.nextPendingConnection()) {
        if (m_clients.size() >= kMostClients) {
            socket->deleteLater();
            continue;
        }
        const Client client = ++m_last;
        m_clients[client] = socket;
        socket->setReadBufferSize(kLongestLine);
        connect(socket, &QLocalSocket::readyRead, this, [this, client] { read(client); });
        connect(
            socket, &QLocalSocket::disconnected, this, [this, client] { read(client); },
            Qt::QueuedConnection);
        emit clientsChanged();
        read(client);
    }
}

bool ApiServer::readLine(Client client) {
    const auto found = m_clients.find(client);
    if (found == m_clients.end())
        return false;
    QLocalSocket* socket = found->second;
    if (!socket->canReadLine()) {
        if (socket->bytesAvailable() >= kLongestLine)
            emit overflowed(client);
        return false;
    }
    emit received(client, socket->readLine().trimmed());
    return true;
}

void ApiServer::read(Client client) {
    for (int i = 0; i < kLinesAtOnce; ++i) {
        if (readLine(client))
            continue;
        // Only now: a stop may be among what it sent before it disappeared.
        if (const auto found = m_clients.find(client);
            found != m_clients.end() && found->second->state() == QLocalSocket::UnconnectedState)
            drop(client);
        return;
    }
    QMetaObject::invokeMethod(
        this, [this, client] { read(client); }, Qt::QueuedConnection);
}

void ApiServer::send(Client client, const QByteArray& line) {
    const auto found = m_clients.find(client);
    if (found == m_clients.end())
        return;
    if (found->second->bytesToWrite() + line.size() > kMostWaiting) {
        // Queued: the caller may be looping over all clients.
        QMetaObject::invokeMethod(
            this, [this, client] { drop(client); }, Qt::QueuedConnection);
        return;
    }
    found->second->write(line + '\n');
}

bool ApiServer::hasRoom(Client client, qsizetype size) const {
    const auto found = m_clients.find(client);
    return found != m_clients.end() && found->second->bytesToWrite() + size <= kMostOffered;
}

bool ApiServer::offer(Client client, const QByteArray& line) {
    if (!hasRoom(client, line.size()))
        return false;
    send(client, line);
    return true;
}

void ApiServer::cutOff(Client client) {
    if (const auto found = m_clients.find(client); found != m_clients.end())
        found->second->flush();
    drop(client);
}

void ApiServer::drop(Client client) {
    const auto found = m_clients.find(client);
    if (found == m_clients.end())
        return;
    QLocalSocket* socket = found->second;
    m_clients.erase(found);
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
    emit vanished(client);
    emit clientsChanged();
}

}  // namespace nmc

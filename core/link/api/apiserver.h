// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QLocalServer>
#include <QObject>
#include <map>

#include <tl/expected.hpp>

#include "link/api/apiserverproblem.h"

class QLocalSocket;

namespace nmc {

/// The local socket to which other programs connect, one line for each message (docs/api.md). It knows
/// nothing of what they say. A client that does not read what it must read is cut off, so that it costs the
/// others nothing. GUI thread.
class ApiServer : public QObject {
    Q_OBJECT

public:
    /// Counted from 1, never used again.
    using Client = quint64;

    static constexpr std::size_t kMostClients = 128;
    static constexpr qsizetype kLongestLine = 64 * 1024;
    static constexpr qint64 kMostWaiting = 1024 * 1024;  ///< bytes of what a client must read
    static constexpr qint64 kMostOffered = 64 * 1024;    ///< bytes waiting beyond which offers are dropped

    explicit ApiServer(QObject* parent = nullptr);

    /// $XDG_RUNTIME_DIR/nmcpanel/NAME.sock, NAME being what comes last in the name of the port.
    [[nodiscard]] static QString pathFor(const QString& port);

    /// True if a panel that runs accepts connections at this path.
    [[nodiscard]] static bool isServed(const QString& path);
    /// Opens the socket, for this user only; one that was left behind by a program that ended is replaced.
    [[nodiscard]] tl::expected<void, ApiServerProblem> listen(const QString& path);
    /// Cuts all clients off.
    void close();
    [[nodiscard]] bool isOpen() const { return m_server.isListening(); }
    [[nodiscard]] QString path() const { return m_server.fullServerName(); }

    /// `line` has no line feed. The client must read it.
    void send(Client client, const QByteArray& line);
    /// False if so much is waiting for the client that an offer of this size would be dropped.
    [[nodiscard]] bool hasRoom(Client client, qsizetype size) const;
    /// The same as send(), but dropped if the client is behind; returns whether it was sent.
    bool offer(Client client, const QByteArray& line);
    /// After what was sent to it, as far as the system takes that at once.
    void cutOff(Client client);

signals:
    void received(nmc::ApiServer::Client client, const QByteArray& line);
    /// A line was longer than kLongestLine; the receiver cuts the client off.
    void overflowed(nmc::ApiServer::Client client);
    /// Also for those that were cut off.
    void vanished(nmc::ApiServer::Client client);
    void clientsChanged();

private:
    void accept();
    void read(Client client);
    /// False if there is none yet, or no client.
    bool readLine(Client client);
    void drop(Client client);

    QLocalServer m_server;
    std::map<Client, QLocalSocket*> m_clients;
    Client m_last = 0;
};

}  // namespace nmc

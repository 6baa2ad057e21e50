// SPDX-License-Identifier: GPL-3.0-or-later
// The socket at which programs are let in: who may open it, what stands in its place, and a program's end.
#include "link/api/apiserver.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QLocalSocket>
#include <cstring>

#include "link/api/apiclient.h"
#include "tests/support/eventually.h"
#include "tests/support/runtimefolder.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::RuntimeFolder;

TEST(ApiSocket, IsForThisUserOnlyAndReplacesOneThatWasLeftBehind) {
    const RuntimeFolder runtime;
    const QString path = ApiServer::pathFor(u"/dev/ttyUSB0"_s);
    {
        ApiServer server;
        ASSERT_TRUE(server.listen(path));
        struct stat status {};
        ASSERT_EQ(::stat(path.toUtf8().constData(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0600U);
        ApiServer second;
        const auto refused = second.listen(path);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ApiServerProblem::Kind::InUse);
    }
    // As a killed panel leaves it: the socket is there, and nobody answers.
    const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.toUtf8().constData(), sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(left, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ::close(left);
    ASSERT_EQ(::chmod(path.toUtf8().constData(), 0600), 0);
    ApiServer server;
    EXPECT_TRUE(server.listen(path));
}

TEST(ApiSocket, TrustsNeitherLinksNorOpenFolders) {
    const RuntimeFolder runtime;
    const QString path = ApiServer::pathFor(u"/dev/ttyUSB0"_s);
    ApiServer server;
    ASSERT_TRUE(server.listen(path));
    server.close();
    ASSERT_TRUE(QFile::link(u"/tmp/elsewhere"_s, path));
    auto refused = server.listen(path);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ApiServerProblem::Kind::NotPrivate);
    ASSERT_TRUE(QFile::remove(path));
    ASSERT_EQ(::chmod(QFileInfo(path).absolutePath().toUtf8().constData(), 0777), 0);
    refused = server.listen(path);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ApiServerProblem::Kind::NotPrivate);
}

/// The last of them may be a stop.
TEST(ApiSocket, ReadsAllThatAClientSentBeforeItDisappeared) {
    constexpr int kLines = 500;
    const RuntimeFolder runtime;
    const QString path = ApiServer::pathFor(u"/dev/ttyUSB0"_s);
    ApiServer server;
    ASSERT_TRUE(server.listen(path));
    QByteArrayList lines;
    QObject::connect(&server, &ApiServer::received, &server,
                     [&](ApiServer::Client /*client*/, const QByteArray& line) { lines << line; });
    bool vanished = false;
    QObject::connect(&server, &ApiServer::vanished, &server, [&] { vanished = true; });
    QLocalSocket client;
    client.connectToServer(path);
    ASSERT_TRUE(client.waitForConnected());
    for (int i = 1; i <= kLines; ++i)
        client.write(QByteArray::number(i) + '\n');
    client.disconnectFromServer();  // once all is written
    ASSERT_TRUE(testing_support::eventually([&] { return vanished; }));
    ASSERT_EQ(lines.size(), kLines);
    EXPECT_EQ(lines.back(), QByteArray::number(kLines));
}

/// The answer to one call and Ctrl+C may arrive together, before the call that would move a motor.
TEST(ApiClient, CallsNothingOnceItIsInterrupted) {
    const RuntimeFolder runtime;
    const QString path = ApiServer::pathFor(u"/dev/ttyUSB0"_s);
    ApiServer server;
    ASSERT_TRUE(server.listen(path));
    int lines = 0;
    QObject::connect(&server, &ApiServer::received, &server,
                     [&](ApiServer::Client client, const QByteArray& /*line*/) {
                         ++lines;
                         server.send(client, R"({"jsonrpc":"2.0","id":1,"result":{"protocol":"1.1"}})");
                     });
    ApiClient client;
    ASSERT_TRUE(client.connectTo(path, u"test"_s));
    ASSERT_EQ(lines, 1) << "hello";
    client.end({ApiClient::Error::Kind::Interrupted, u"Interrupted."_s});
    const auto moved = client.call("move", {{"axis", 1}, {"to", 10}});
    ASSERT_FALSE(moved);
    EXPECT_EQ(moved.error().kind, ApiClient::Error::Kind::Interrupted);
    // What had been called would be there before this.
    ApiClient next;
    ASSERT_TRUE(next.connectTo(path, u"next"_s));
    EXPECT_EQ(lines, 2) << "another hello";
}

/// At a path that the user names, any program may listen.
TEST(ApiClient, SaysThatAnotherServiceIsNoPanel) {
    const RuntimeFolder runtime;
    const QString path = ApiServer::pathFor(u"/dev/ttyUSB0"_s);
    ApiServer server;
    ASSERT_TRUE(server.listen(path));
    QByteArray answer;
    QObject::connect(
        &server, &ApiServer::received, &server,
        [&](ApiServer::Client client, const QByteArray& /*line*/) { server.send(client, answer); });
    for (const char* other :
         {R"({"jsonrpc":"2.0","id":1,"error":{"code":-32601,"message":"Method not found"}})",
          R"({"jsonrpc":"2.0","id":1,"error":"no"})", R"({"jsonrpc":"2.0","id":1})",
          R"({"jsonrpc":"2.0","id":1,"result":{}})", R"({"jsonrpc":"2.0","id":1,"result":7})", "[]",
          "220 mail.example.org ESMTP"}) {
        answer = other;
        ApiClient client;
        const auto connected = client.connectTo(path, u"test"_s);
        ASSERT_FALSE(connected) << other;
        EXPECT_EQ(connected.error().sentence, u"The program that answers is not NMC Panel."_s) << other;
    }
}

}  // namespace
}  // namespace nmc

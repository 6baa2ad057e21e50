// SPDX-License-Identifier: GPL-3.0-or-later
// What a port logs, as who looks for a fault gets to see it.
#include <gmock/gmock.h>

#include "link/terminal/ptyserver.h"
#include "tests/link/connection.h"
#include "tests/link/logreader.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::StartsWith;

TEST(LinkLog, TellsOfThePortAloneWhereThatIsAskedFor) {
    const auto terminal = PtyServer::create({});  // a line with nobody on it
    ASSERT_TRUE(terminal.has_value());
    const LogReader log(QStringLiteral("nmc.link.port=true"));
    Connection connection;
    connection.openSerial(QString::fromStdString(terminal->path()));
    const auto line = [&terminal](const char* words) {
        return Contains(StartsWith("nmc.link.port: " + terminal->path() + words));
    };
    ASSERT_TRUE(connection.waitUntil([&] { return testing::Value(LogReader::lines(), line(" at ")); }));
    EXPECT_THAT(LogReader::lines(), line(" is open"));
    EXPECT_THAT(LogReader::lines(), testing::Each(StartsWith("nmc.link.port: ")));
}

}  // namespace
}  // namespace nmc

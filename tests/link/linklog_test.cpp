// SPDX-License-Identifier: GPL-3.0-or-later
// What the log contains about a port, for a user who looks for a fault.
#include <gmock/gmock.h>

#include "link/connection/serialtransport.h"
#include "link/terminal/ptyserver.h"
#include "tests/link/logreader.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::StartsWith;

TEST(LinkLog, TellsOfThePort) {
    const auto terminal = PtyServer::create({});
    ASSERT_TRUE(terminal.has_value());
    const LogReader log(QStringLiteral("nmc.link.port=true"));
    SerialTransport port(QString::fromStdString(terminal->path()), 115'200);
    ASSERT_TRUE(port.open().has_value());
    ASSERT_TRUE(port.setBaud(115'200).has_value());
    EXPECT_THAT(LogReader::lines(), Contains("nmc.link.port: " + terminal->path() + " is open"));
    EXPECT_THAT(LogReader::lines(),
                Contains(StartsWith("nmc.link.port: " + terminal->path() + " at 115200 Bd")));
}

}  // namespace
}  // namespace nmc

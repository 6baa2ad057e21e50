// SPDX-License-Identifier: GPL-3.0-or-later
// What the log contains about requests, for a user who looks for a fault.
#include "link/connection/linklog.h"

#include <gmock/gmock.h>

#include "tests/link/connection/virtualconnection.h"
#include "tests/link/logreader.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::IsEmpty;
using testing::StartsWith;

void moveAndStop() {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualConnection connection(sim);
    connection.open(115'200);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(1, 2'000)), bus::Outcome::Done);
    connection.worker().stopAll();
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
}

TEST(LinkLog, SaysNothingUnlessAsked) {
    const LogReader log({});
    ASSERT_NO_FATAL_FAILURE(moveAndStop());
    EXPECT_THAT(LogReader::lines(), IsEmpty());
}

TEST(LinkLog, TellsOfRequestsAndWhatBecameOfThem) {
    const LogReader log(QStringLiteral("nmc.link*=true"));
    ASSERT_NO_FATAL_FAILURE(moveAndStop());
    const auto lines = LogReader::lines();
    EXPECT_THAT(lines, Contains("nmc.link: chain found: modules 2, 115200 Bd"));
    EXPECT_THAT(lines,
                Contains(StartsWith("nmc.link.requests: operation 2; module 2 Load Trajectory: position "
                                    "2000,")));
    EXPECT_THAT(lines, Contains("nmc.link: operation 2: Done"));
    EXPECT_THAT(lines, Contains(StartsWith("nmc.link: stop finished: stopped 1 2, not reached none")));
    EXPECT_EQ(lines.back(), "nmc.link: port closed");
}

/// This category logs nothing here, because the port is not one of the system's.
TEST(LinkLog, OneCategoryCanBeChosen) {
    const LogReader log(QStringLiteral("nmc.link.port=true"));
    ASSERT_NO_FATAL_FAILURE(moveAndStop());
    EXPECT_THAT(LogReader::lines(), IsEmpty());
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// What the link logs, as who looks for a fault gets to see it.
#include "link/connection/linklog.h"

#include <gmock/gmock.h>

#include <QMutex>
#include <QStringList>

#include "tests/link/connection.h"
#include "tests/support/nmcsimprocess.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::Contains;
using testing::IsEmpty;
using testing::StartsWith;

/// Collects what goes to the log of this process, of all threads, as "category: text".
class LogReader {
public:
    explicit LogReader(const QString& rules) {
        s_lines.clear();
        QLoggingCategory::setFilterRules(rules);
        m_before = qInstallMessageHandler(&LogReader::take);
    }
    ~LogReader() {
        qInstallMessageHandler(m_before);
        QLoggingCategory::setFilterRules({});
    }
    LogReader(const LogReader&) = delete;
    LogReader& operator=(const LogReader&) = delete;

    static std::vector<std::string> lines() {
        const QMutexLocker lock(&s_mutex);
        return s_lines;
    }

private:
    static void take(QtMsgType, const QMessageLogContext& context, const QString& text) {
        const QMutexLocker lock(&s_mutex);
        s_lines.push_back(std::string(context.category) + ": " + text.toStdString());
    }

    QtMessageHandler m_before;
    inline static QMutex s_mutex;
    inline static std::vector<std::string> s_lines;
};

void moveAndStop(NmcsimProcess& sim) {
    Connection connection;
    connection.openSerial(sim.terminal(), 115'200);
    ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
    ASSERT_EQ(connection.carryOut(gainsAndEnable(1)), bus::Outcome::Done);
    ASSERT_EQ(connection.carryOut(move(1, 2'000)), bus::Outcome::Done);
    connection.worker().stopAll();
    ASSERT_TRUE(connection.waitFor<bus::StopFinished>());
    connection.worker().close();
    ASSERT_TRUE(connection.waitFor<PortClosed>());
}

TEST(LinkLog, SaysNothingUnlessAsked) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    const LogReader log({});
    ASSERT_NO_FATAL_FAILURE(moveAndStop(sim));
    EXPECT_THAT(LogReader::lines(), IsEmpty());
}

TEST(LinkLog, TellsOfPortRequestsAndWhatBecameOfThem) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    const std::string port = sim.terminal().toStdString();
    const LogReader log(QStringLiteral("nmc.link*=true"));
    ASSERT_NO_FATAL_FAILURE(moveAndStop(sim));
    const auto lines = LogReader::lines();
    EXPECT_THAT(lines, Contains("nmc.link.port: " + port + " is open"));
    EXPECT_THAT(lines, Contains(StartsWith("nmc.link.port: " + port + " at 115200 Bd")));
    EXPECT_THAT(lines, Contains("nmc.link: chain found: modules 2, 115200 Bd"));
    EXPECT_THAT(lines,
                Contains(StartsWith("nmc.link.requests: operation 2; module 2 Load Trajectory: position "
                                    "2000,")));
    EXPECT_THAT(lines, Contains("nmc.link: operation 2: done"));
    EXPECT_THAT(lines, Contains(StartsWith("nmc.link: stop finished: stopped 1 2, not reached none")));
    EXPECT_EQ(lines.back(), "nmc.link: port closed");
}

TEST(LinkLog, OneCategoryCanBeChosen) {
    NmcsimProcess sim(QStringLiteral("servo,servo"));
    const LogReader log(QStringLiteral("nmc.link.port=true"));
    ASSERT_NO_FATAL_FAILURE(moveAndStop(sim));
    ASSERT_FALSE(LogReader::lines().empty());
    EXPECT_THAT(LogReader::lines(), testing::Each(StartsWith("nmc.link.port: ")));
}

}  // namespace
}  // namespace nmc

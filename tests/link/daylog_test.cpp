// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/files/daylog.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <future>

#include "tests/support/eventually.h"

namespace nmc {
namespace {

class DayLogTest : public testing::Test {
protected:
    static QDateTime at(int day, int hour = 12) { return {QDate(2026, 11, day), QTime(hour, 0)}; }
    QByteArray content(const char* name) {
        QFile file(m_folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    QString folder() { return m_folder.path(); }
    /// Each time, it waits for as long as a panel that ends.
    static bool finishes(DayLog& log) {
        return testing_support::eventually([&log] { return log.finish(); });
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(DayLogTest, KeepsTheLinesOfEachDayInAFileOfItsOwn) {
    {
        DayLog log(folder() + QStringLiteral("/log"));
        log.write("one", at(21, 23));
        log.write("two", at(21, 23));
        log.write("three", at(22, 0));
    }
    EXPECT_EQ(content("log/messages-2026-11-21.log"), "one\ntwo\n");
    EXPECT_EQ(content("log/messages-2026-11-22.log"), "three\n");
}

TEST_F(DayLogTest, ALaterSessionGoesOnBehindTheOneBefore) {
    DayLog(folder()).write("one", at(21));
    DayLog(folder()).write("two", at(21));
    EXPECT_EQ(content("messages-2026-11-21.log"), "one\ntwo\n");
}

TEST_F(DayLogTest, TheOldestOf31DaysGoes) {
    QDir dir(folder());
    const auto touch = [&dir](const QString& name) {
        QFile file(dir.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    };
    for (int day = 1; day <= 30; ++day)
        touch(QStringLiteral("messages-2026-10-%1.log").arg(day, 2, 10, QLatin1Char('0')));
    touch(QStringLiteral("messages-2026-10-01.log.old"));
    touch(QStringLiteral("notes.log"));
    DayLog log(folder());
    log.write("one", at(1));
    ASSERT_TRUE(finishes(log));
    EXPECT_FALSE(dir.exists(QStringLiteral("messages-2026-10-01.log")));
    EXPECT_FALSE(dir.exists(QStringLiteral("messages-2026-10-01.log.old")));
    EXPECT_TRUE(dir.exists(QStringLiteral("messages-2026-10-02.log")));
    EXPECT_TRUE(dir.exists(QStringLiteral("notes.log"))) << "it is not a log of ours";
    EXPECT_EQ(content("messages-2026-11-01.log"), "one\n");
}

/// The clock was set back: the files that are there are all of later days.
TEST_F(DayLogTest, TheFileThatIsWrittenIsNeverTheOneThatGoes) {
    for (int day = 1; day <= 30; ++day) {
        QFile file(folder() + QStringLiteral("/messages-2026-12-%1.log").arg(day, 2, 10, QLatin1Char('0')));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    DayLog log(folder());
    log.write("one", at(1));
    ASSERT_TRUE(finishes(log));
    log.write("two", at(1));
    ASSERT_TRUE(finishes(log));
    EXPECT_EQ(content("messages-2026-11-01.log"), "one\ntwo\n");
}

TEST_F(DayLogTest, OneThatIsTooLargeIsBegunAnewAndTheOneBeforeIsKept) {
    QFile file(folder() + QStringLiteral("/messages-2026-11-21.log"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_TRUE(file.resize(DayLog::kMostBytes));
    file.close();
    DayLog(folder()).write("one", at(21));
    EXPECT_EQ(content("messages-2026-11-21.log"), "one\n");
    EXPECT_EQ(content("messages-2026-11-21.log.old").size(), DayLog::kMostBytes);
}

// The first line is on its way to a disk that does not answer: the other lines wait, and none is lost.
TEST_F(DayLogTest, KeepsNobodyWaitingAndLosesNothing) {
    std::promise<void> asked;
    std::promise<void> answer;
    bool first = true;
    DayLog log(folder(), [&](const QString& path, std::string_view lines) {
        if (std::exchange(first, false)) {
            asked.set_value();
            answer.get_future().wait();
        }
        return DayLog::appendToFile(path, lines);
    });
    log.write("one", at(21));
    asked.get_future().wait();
    log.write("two", at(21));
    log.write("three", at(21));
    answer.set_value();
    ASSERT_TRUE(finishes(log));
    EXPECT_EQ(content("messages-2026-11-21.log"), "one\ntwo\nthree\n");
}

TEST_F(DayLogTest, TellsOnceThatItCannotKeepThem) {
    QFile inTheWay(folder() + QStringLiteral("/log"));
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    DayLog log(inTheWay.fileName());
    QSignalSpy failed(&log, &DayLog::failed);
    log.write("one", at(21));
    ASSERT_TRUE(finishes(log));
    ASSERT_TRUE(testing_support::eventually([&] { return failed.size() == 1; }));
    log.write("two", at(21));
    ASSERT_TRUE(finishes(log));
    QCoreApplication::processEvents();
    EXPECT_EQ(failed.size(), 1);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/files/filekeeper.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <future>

namespace nmc {
namespace {

using namespace std::chrono_literals;

class FileKeeperTest : public testing::Test {
protected:
    QString path(const char* name) { return m_folder.filePath(QLatin1String(name)); }
    static QByteArray content(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(FileKeeperTest, WritesAndRemovesInTheOrderThatWasAskedFor) {
    FileKeeper keeper;
    keeper.write(path("a"), "one");
    keeper.write(path("b"), "two");
    keeper.write(path("a"), "three");
    keeper.remove(path("b"));
    ASSERT_TRUE(keeper.finish());
    EXPECT_EQ(content(path("a")), "three");
    EXPECT_FALSE(QFile::exists(path("b")));
}

TEST_F(FileKeeperTest, MakesTheFolder) {
    FileKeeper keeper;
    keeper.write(path("new/folder/a"), "one");
    ASSERT_TRUE(keeper.finish());
    EXPECT_EQ(content(path("new/folder/a")), "one");
}

TEST_F(FileKeeperTest, LeavesNothingUndoneWhenItEnds) {
    FileKeeper().write(path("a"), "one");
    EXPECT_EQ(content(path("a")), "one");
}

TEST_F(FileKeeperTest, LeavesWhatWasThereWhereItCannotWrite) {
    ASSERT_TRUE(QDir().mkpath(path("a")));  // a folder: no file can take its place
    FileKeeper keeper;
    keeper.write(path("a"), "one");
    keeper.write(path("b"), "two");
    ASSERT_TRUE(keeper.finish());
    EXPECT_TRUE(QDir(path("a")).exists());
    EXPECT_EQ(content(path("b")), "two");
}

TEST_F(FileKeeperTest, KeepsNobodyWaitingForADiskThatDoesNotAnswer) {
    std::promise<void> answer;
    const std::shared_future<void> answered = answer.get_future().share();
    QStringList written;
    FileKeeper keeper([&](const QString& file, const std::string& /*content*/) {
        answered.wait();
        written << QFileInfo(file).fileName();
    });
    keeper.write(path("a"), "one");
    keeper.write(path("b"), "two");  // returns
    EXPECT_FALSE(keeper.finish(0ms));
    answer.set_value();
    ASSERT_TRUE(keeper.finish());
    EXPECT_EQ(written, QStringList({QStringLiteral("a"), QStringLiteral("b")}));
}

}  // namespace
}  // namespace nmc

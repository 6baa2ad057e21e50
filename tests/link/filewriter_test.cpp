// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/files/filewriter.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <future>
#include <map>
#include <mutex>
#include <optional>

#include "tests/support/eventually.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using testing_support::eventually;

class FileWriterTest : public testing::Test {
protected:
    static constexpr std::chrono::milliseconds kPatience{testing_support::kPatienceMs};

    QString path(const char* name) { return m_folder.filePath(QLatin1String(name)); }
    static QByteArray content(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    }
    static FileWriter::Content text(const char* content) {
        return [content] { return std::string(content); };
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(FileWriterTest, WritesAndRemovesInTheOrderThatWasAskedFor) {
    FileWriter writer;
    writer.write(path("a"), text("one"));
    writer.write(path("b"), text("two"));
    writer.write(path("a"), text("three"));
    writer.remove(path("b"));
    ASSERT_TRUE(writer.finish(kPatience));
    EXPECT_EQ(content(path("a")), "three");
    EXPECT_FALSE(QFile::exists(path("b")));
}

TEST_F(FileWriterTest, LeavesNothingUndoneWhenItEnds) {
    FileWriter().write(path("a"), text("one"));
    EXPECT_EQ(content(path("a")), "one");
}

TEST_F(FileWriterTest, TellsWhatBecameOfIt) {
    ASSERT_TRUE(QDir().mkpath(path("folder")));
    FileWriter writer;
    std::map<QString, FileWriter::Result> told;
    for (const char* name : {"a", "folder", "none/a"})
        writer.write(path(name), text("one"),
                     [&told, file = path(name)](const FileWriter::Result& result) { told[file] = result; });
    ASSERT_TRUE(writer.finish(kPatience));
    EXPECT_TRUE(told.empty()) << "nothing is reported before the event loop runs";
    ASSERT_TRUE(eventually([&] { return told.size() == 3; }));
    EXPECT_TRUE(told[path("a")].has_value());
    EXPECT_EQ(told[path("folder")].error().trouble, FileErrorKind::NotAFile);
    EXPECT_EQ(told[path("none/a")].error().trouble, FileErrorKind::NoFolder);
    EXPECT_TRUE(QDir(path("folder")).exists()) << "the existing folder stays";
}

TEST_F(FileWriterTest, WritesNothingIfTheContentSaysWhyNot) {
    FileWriter writer;
    writer.write(path("a"), text("one"));
    ASSERT_TRUE(writer.finish(kPatience));
    std::optional<FileWriter::Result> told;
    writer.write(
        path("a"),
        [] {
            return tl::unexpected(FileError{FileErrorKind::ChangedElsewhere, {}});
        },
        [&told](const FileWriter::Result& result) { told = result; });
    ASSERT_TRUE(eventually([&] { return told.has_value(); }));
    EXPECT_EQ(told->error().trouble, FileErrorKind::ChangedElsewhere);
    EXPECT_EQ(content(path("a")), "one");
}

TEST_F(FileWriterTest, TellsNobodyAfterItsEnd) {
    bool told = false;
    FileWriter().write(path("a"), text("one"), [&](const FileWriter::Result& /*result*/) { told = true; });
    QCoreApplication::processEvents();
    EXPECT_FALSE(told);
}

TEST_F(FileWriterTest, KeepsNobodyWaitingForADiskThatDoesNotAnswer) {
    std::promise<void> asked;
    std::promise<void> answer;
    std::mutex mutex;
    QByteArrayList written;
    FileWriter writer([&](const QString& file, std::string_view content) {
        if (file == path("stuck") && content == "one") {
            asked.set_value();
            answer.get_future().wait();
        }
        const std::scoped_lock lock(mutex);
        written << QByteArray(content.data(), static_cast<qsizetype>(content.size()));
        return FileWriter::Result();
    });
    int told = 0;
    const auto count = [&](const FileWriter::Result& /*result*/) { ++told; };
    writer.write(path("stuck"), text("one"), count);  // returns at once
    asked.get_future().wait();
    writer.write(path("stuck"), text("two"), count);
    writer.write(path("stuck"), text("three"), count);
    writer.write(path("elsewhere"), text("four"), count);
    ASSERT_TRUE(eventually([&] { return told == 1; })) << "the other disk answers";
    EXPECT_FALSE(writer.finish(0ms));
    answer.set_value();
    ASSERT_TRUE(writer.finish(kPatience));
    EXPECT_EQ(written, QByteArrayList({"four", "one", "three"}));
    ASSERT_TRUE(eventually([&] { return told == 3; }));
}

}  // namespace
}  // namespace nmc

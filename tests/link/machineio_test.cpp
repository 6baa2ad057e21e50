// SPDX-License-Identifier: GPL-3.0-or-later
// H-10, H-14, H-18: files are read within bounds and written completely or not at all, and unsaved work
// survives its program.
#include "link/files/machineio.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "asnobody.h"
#include "link/files/unsavedwork.h"
#include "tests/support/eventually.h"

namespace nmc {
namespace {

using testing_support::AsNobody;

class MachineIo : public testing::Test {
protected:
    QString path(const char* name) { return directory.filePath(QLatin1String(name)); }
    static std::string contentOf(const QString& file) { return readFile(file, 1'000).value_or("(not read)"); }
    QTemporaryDir directory;
};

TEST_F(MachineIo, WhatWasWrittenIsReadUpToTheBound) {
    ASSERT_TRUE(writeFile(path("a.json"), "12345").has_value());
    EXPECT_EQ(readFile(path("a.json"), 5), "12345");
    const auto cut = readFile(path("a.json"), 4);
    ASSERT_FALSE(cut.has_value());
    EXPECT_EQ(cut.error().trouble, FileErrorKind::TooLarge);
    ASSERT_TRUE(writeFile(path("a.json"), "").has_value());
    EXPECT_EQ(readFile(path("a.json"), 0), "");
}

TEST_F(MachineIo, ReadingSaysWhyNot) {
    EXPECT_EQ(readFile(path("none.json"), 10).error().trouble, FileErrorKind::NotThere);
    EXPECT_EQ(readFile(directory.path(), 10).error().trouble, FileErrorKind::NotAFile);
    EXPECT_EQ(readFile(QStringLiteral("/dev/zero"), 10).error().trouble, FileErrorKind::NotAFile);
    ASSERT_EQ(mkfifo(path("fifo").toLocal8Bit().constData(), 0600), 0);
    EXPECT_EQ(readFile(path("fifo"), 10).error().trouble, FileErrorKind::NotAFile)
        << "reading it would block";
    ASSERT_TRUE(writeFile(path("secret.json"), "x").has_value());
    QFile::setPermissions(path("secret.json"), {});
    QFile::setPermissions(directory.path(), QFile::Permissions(0x7755));
    const AsNobody nobody;
    EXPECT_EQ(readFile(path("secret.json"), 10).error().trouble, FileErrorKind::NoPermission);
}

TEST_F(MachineIo, WritingSaysWhyNot) {
    EXPECT_EQ(writeFile(path("none/a.json"), "x").error().trouble, FileErrorKind::NoFolder);
    EXPECT_EQ(writeFile(directory.path(), "x").error().trouble, FileErrorKind::NotAFile);
    EXPECT_EQ(writeFile(QStringLiteral("/dev/full"), "x").error().trouble, FileErrorKind::NotAFile);
    ASSERT_TRUE(writeFile(path("old.json"), "old").has_value());
    QFile::setPermissions(path("old.json"), QFile::ReadOwner | QFile::ReadOther);
    QFile::setPermissions(directory.path(), QFile::Permissions(0x5555));
    {
        const AsNobody nobody;
        EXPECT_EQ(writeFile(path("new.json"), "x").error().trouble, FileErrorKind::NoPermission);
        EXPECT_EQ(writeFile(path("old.json"), "x").error().trouble, FileErrorKind::NoPermission);
    }
    QFile::setPermissions(directory.path(), QFile::Permissions(0x7755));
    EXPECT_EQ(contentOf(path("old.json")), "old");
    EXPECT_EQ(QDir(directory.path()).entryList(QDir::Files), QStringList{QStringLiteral("old.json")})
        << "no temporary file is left behind";
}

TEST_F(MachineIo, UnsavedWorkIsFoundByTheNextSessionUntilItIsDropped) {
    const QString folder = path("unsaved");
    {
        UnsavedWork work(folder);
        EXPECT_FALSE(work.left().has_value());
        EXPECT_TRUE(QDir(folder).entryList({QStringLiteral("unsaved-?")}).isEmpty())
            << "nothing has been kept yet";
        work.keep(QStringLiteral("/home/anna/my mill\n.json"), {}, "first", {});
        work.keep(QStringLiteral("/home/anna/my mill\n.json"), QStringLiteral("a1"), "second\nline", {});
    }
    {
        UnsavedWork work(folder);
        ASSERT_TRUE(work.left().has_value());
        EXPECT_EQ(work.left()->file, QStringLiteral("/home/anna/my mill\n.json"));
        EXPECT_EQ(work.left()->fileHash, QStringLiteral("a1"));
        EXPECT_EQ(work.left()->content, "second\nline");
        work.keep({}, {}, "another", {});  // its own work goes elsewhere
        work.forget();
    }
    {
        UnsavedWork work(folder);
        ASSERT_TRUE(work.left().has_value());
        work.dropLeft();
        EXPECT_FALSE(work.left().has_value());
    }
    EXPECT_FALSE(UnsavedWork(folder).left().has_value());
}

TEST_F(MachineIo, UnsavedWorkOfAProgramThatStillRunsIsLeftToIt) {
    const QString folder = path("unsaved");
    auto running = std::make_unique<UnsavedWork>(folder);
    running->keep({}, {}, "of the first", {});
    UnsavedWork second(folder);
    EXPECT_FALSE(second.left().has_value());
    second.keep({}, {}, "of the second", {});
    running.reset();
    UnsavedWork third(folder);
    ASSERT_TRUE(third.left().has_value());
    EXPECT_EQ(third.left()->content, "of the first");
}

TEST_F(MachineIo, UnsavedWorkThatCannotBeReadDoesNotHideWhatIsBehindIt) {
    const QString folder = path("unsaved");
    UnsavedWork(folder).keep({}, {}, std::string(1'200'000, 'x'), {});  // no machine file is that large
    {
        UnsavedWork second(folder);
        EXPECT_FALSE(second.left().has_value());
        second.keep({}, {}, "of the second", {});
    }
    UnsavedWork third(folder);
    ASSERT_TRUE(third.left().has_value());
    EXPECT_EQ(third.left()->content, "of the second");
}

TEST_F(MachineIo, UnsavedWorkThatCannotBeKeptSaysSo) {
    ASSERT_TRUE(writeFile(path("file"), "x").has_value());
    UnsavedWork work(path("file/unsaved"));
    std::optional<FileWriter::Result> kept;
    work.keep({}, {}, "x", [&](const FileWriter::Result& result) { kept = result; });
    ASSERT_TRUE(testing_support::eventually([&] { return kept.has_value(); }));
    EXPECT_FALSE(kept->has_value());
}

}  // namespace
}  // namespace nmc

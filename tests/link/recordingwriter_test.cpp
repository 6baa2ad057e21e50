// SPDX-License-Identifier: GPL-3.0-or-later
// A recording soon reaches the disk, and no disk makes the panel wait or stop.
#include "link/files/recordingwriter.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QTemporaryDir>
#include <memory>
#include <optional>

#include "asnobody.h"
#include "tests/support/eventually.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using testing_support::AsNobody;
using testing_support::eventually;

class SmallFiles {
public:
    explicit SmallFiles(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallFiles() { setrlimit(RLIMIT_FSIZE, &m_before); }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;

private:
    rlimit m_before{};
};

/// A reader that has the pipe open, but does not read.
class IdleReader {
public:
    explicit IdleReader(const QString& fifo)
        : m_fd(::open(QFile::encodeName(fifo).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
    ~IdleReader() { ::close(m_fd); }
    [[nodiscard]] bool somethingCame() const {
        pollfd fd{m_fd, POLLIN, 0};
        return ::poll(&fd, 1, 0) == 1;
    }
    IdleReader(const IdleReader&) = delete;
    IdleReader& operator=(const IdleReader&) = delete;

private:
    int m_fd;
};

/// A line of `size` bytes, different for each number.
std::string piece(int number, std::size_t size) {
    std::string text = std::to_string(number) + ',';
    text.resize(size - 1, static_cast<char>('a' + number % 26));
    return text + '\n';
}

class RecordingWriterTest : public testing::Test {
protected:
    void make(RecordingWriter::Limits limits = {}) {
        m_writer = std::make_unique<RecordingWriter>(limits);
        QObject::connect(m_writer.get(), &RecordingWriter::failed,
                         [this](const RecordingFailure& failure) { m_failures.push_back(failure); });
        QObject::connect(m_writer.get(), &RecordingWriter::finished,
                         [this](qint64 bytes, double seconds) { m_finished.emplace_back(bytes, seconds); });
    }
    void SetUp() override { make(); }

    QString path(const char* name) { return m_directory.filePath(QLatin1String(name)); }
    QString fifo() {
        const QString name = path("fifo");
        mkfifo(QFile::encodeName(name).constData(), 0600);
        return name;
    }
    static std::string contentOf(const QString& file) {
        QFile open(file);
        return open.open(QIODevice::ReadOnly) ? open.readAll().toStdString() : "(not read)";
    }
    bool waitForEnd() {
        return eventually([this] { return !m_failures.empty() || !m_finished.empty(); });
    }
    /// The problem with which the current recording ends without being stopped.
    std::optional<RecordingProblemKind> trouble() {
        if (!waitForEnd() || m_failures.size() != 1 || !m_finished.empty())
            return std::nullopt;
        EXPECT_FALSE(m_writer->isBusy());
        return m_failures.front().trouble;
    }

    QTemporaryDir m_directory;
    std::unique_ptr<RecordingWriter> m_writer;
    std::vector<RecordingFailure> m_failures;
    std::vector<std::pair<qint64, double>> m_finished;
};

TEST_F(RecordingWriterTest, WritesWhatItWasGivenAndSaysHowMuch) {
    ASSERT_FALSE(m_writer->isBusy());
    m_writer->append("nobody records");
    m_writer->start(path("a.csv"));
    EXPECT_TRUE(m_writer->isRecording());
    EXPECT_EQ(m_writer->path(), path("a.csv"));
    m_writer->append("head\n");
    m_writer->append("");
    m_writer->append("1,2\n");
    m_writer->stop();
    EXPECT_FALSE(m_writer->isRecording());
    EXPECT_TRUE(m_writer->isBusy());
    m_writer->append("too late");
    m_writer->stop();
    ASSERT_TRUE(waitForEnd());
    EXPECT_FALSE(m_writer->isBusy());
    EXPECT_TRUE(m_failures.empty());
    ASSERT_EQ(m_finished.size(), 1U);
    EXPECT_EQ(m_finished[0].first, 9);
    EXPECT_GE(m_finished[0].second, 0.0);
    EXPECT_EQ(contentOf(path("a.csv")), "head\n1,2\n");
}

TEST_F(RecordingWriterTest, WhatHasComeIsInTheFileWhileItIsRecorded) {
    m_writer->start(path("a.csv"));
    m_writer->append("1\n");
    EXPECT_TRUE(eventually([this] { return contentOf(path("a.csv")) == "1\n"; }));
    m_writer->append("2\n");
    EXPECT_TRUE(eventually([this] { return contentOf(path("a.csv")) == "1\n2\n"; }));
    EXPECT_TRUE(m_writer->isRecording());
}

TEST_F(RecordingWriterTest, RecordsAgainIntoTheSameFile) {
    for (const char* text : {"first and long\n", "second\n"}) {
        m_finished.clear();
        m_writer->start(path("a.csv"));
        m_writer->append(text);
        m_writer->stop();
        ASSERT_TRUE(waitForEnd());
        EXPECT_EQ(contentOf(path("a.csv")), text);
    }
    EXPECT_TRUE(m_failures.empty());
}

TEST_F(RecordingWriterTest, LosesNothingWhenItIsClosedWhileDataWaits) {
    make({.toClose = std::chrono::milliseconds(testing_support::kPatienceMs)});
    std::string whole;
    m_writer->start(path("a.csv"));
    for (int i = 0; i < 400; ++i) {
        whole += piece(i, 50'000);
        m_writer->append(piece(i, 50'000));
    }
    m_writer.reset();
    EXPECT_TRUE(contentOf(path("a.csv")) == whole);
    EXPECT_TRUE(m_failures.empty());
}

TEST_F(RecordingWriterTest, SaysWhyItCannotBegin) {
    m_writer->start(path("none/a.csv"));
    EXPECT_EQ(trouble(), RecordingProblemKind::NoFolder);
    EXPECT_FALSE(m_failures.front().detail.isEmpty());
    m_failures.clear();
    m_writer->start(m_directory.path());
    EXPECT_EQ(trouble(), RecordingProblemKind::NotAFile);
    m_failures.clear();
    QFile::setPermissions(m_directory.path(), QFile::Permissions(0x5555));
    const AsNobody nobody;
    m_writer->start(path("new.csv"));
    EXPECT_EQ(trouble(), RecordingProblemKind::NoPermission);
    EXPECT_EQ(m_failures.front().bytes, 0);
}

TEST_F(RecordingWriterTest, EndsWhenTheDiskIsFull) {
    m_writer->start(QStringLiteral("/dev/full"));
    m_writer->append("1\n");
    EXPECT_EQ(trouble(), RecordingProblemKind::NoSpace);
    m_writer->append("2\n");
    m_writer->stop();
    QCoreApplication::processEvents();
    EXPECT_EQ(m_failures.size(), 1U);
    EXPECT_TRUE(m_finished.empty());
}

TEST_F(RecordingWriterTest, WhatWasWrittenBeforeAFileIsTooLargeStaysInIt) {
    const SmallFiles small(1'000'000);
    m_writer->start(path("a.csv"));
    for (int i = 0; i < 3; ++i)
        m_writer->append(piece(i, 400'000));
    EXPECT_EQ(trouble(), RecordingProblemKind::FileTooLarge);
    EXPECT_EQ(m_failures.front().bytes, 800'000);
    EXPECT_TRUE(contentOf(path("a.csv")) == piece(0, 400'000) + piece(1, 400'000))
        << "the third line did not fit, and no part of it is there";
}

TEST_F(RecordingWriterTest, TheLastLineOfAPieceThatFitsIsWhole) {
    const SmallFiles small(1'000);
    m_writer->start(path("a.csv"));
    std::string rows;
    for (int i = 0; i < 100; ++i)
        rows += piece(i, 30);
    m_writer->append(rows);
    EXPECT_EQ(trouble(), RecordingProblemKind::FileTooLarge);
    EXPECT_EQ(m_failures.front().bytes, 990) << "33 rows of 30 bytes";
    EXPECT_TRUE(contentOf(path("a.csv")) == rows.substr(0, 990));
}

TEST_F(RecordingWriterTest, TellsWhenItsFileWasDeleted) {
    make({.toFlush = 10ms});
    m_writer->start(path("a.csv"));
    m_writer->append("1\n");
    ASSERT_TRUE(eventually([this] { return contentOf(path("a.csv")) == "1\n"; }));
    QFile::remove(path("a.csv"));
    m_writer->append("2\n");
    EXPECT_EQ(trouble(), RecordingProblemKind::Removed);
}

TEST_F(RecordingWriterTest, APipeThatNobodyReadsIsRefusedAtOnce) {
    m_writer->start(fifo());
    m_writer->append("1\n");
    EXPECT_EQ(trouble(), RecordingProblemKind::NotAFile);
}

TEST_F(RecordingWriterTest, EndsWhenTheDiskDoesNotKeepUp) {
    make({.queue = 300'000});
    const IdleReader reader(fifo());
    m_writer->start(path("fifo"));
    // A pipe holds 64 KiB.
    int pieces = 0;
    for (; pieces < 100 && m_writer->isRecording(); ++pieces)
        m_writer->append(piece(pieces, 10'000));
    EXPECT_GE(pieces, 30);
    EXPECT_LE(pieces, 38);
    EXPECT_TRUE(m_failures.empty()) << "failures are not reported from within the call";
    EXPECT_EQ(trouble(), RecordingProblemKind::TooSlow);
    EXPECT_LE(m_failures.front().bytes, 65'536);
}

TEST_F(RecordingWriterTest, ADiskThatHangsDoesNotKeepItFinishingForEver) {
    make({.toFinish = 50ms});
    const IdleReader reader(fifo());
    m_writer->start(path("fifo"));
    m_writer->append(piece(0, 100'000));
    m_writer->stop();
    EXPECT_EQ(trouble(), RecordingProblemKind::TooSlow);
}

TEST_F(RecordingWriterTest, ADiskThatHangsDoesNotKeepThePanelFromClosing) {
    make({.toClose = 10ms});
    const IdleReader reader(fifo());
    m_writer->start(path("fifo"));
    m_writer->append(piece(0, 100'000));
    m_writer.reset();
    EXPECT_TRUE(m_failures.empty());
}

TEST_F(RecordingWriterTest, AfterADiskThatHungAnotherRecordingWorks) {
    make({.queue = 100'000});
    const IdleReader reader(fifo());
    m_writer->start(path("fifo"));
    m_writer->append(piece(0, 100'000));
    m_writer->append(piece(1, 100'000));
    ASSERT_EQ(trouble(), RecordingProblemKind::TooSlow);
    m_failures.clear();
    m_writer->start(path("b.csv"));
    m_writer->append("1\n");
    m_writer->stop();
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(m_failures.empty());
    EXPECT_EQ(contentOf(path("b.csv")), "1\n");
}

TEST_F(RecordingWriterTest, AReaderThatGoesAwayEndsTheRecordingAndNotTheProgram) {
    auto reader = std::make_unique<IdleReader>(fifo());
    m_writer->start(path("fifo"));
    m_writer->append(piece(0, 100'000));
    ASSERT_TRUE(eventually([&] { return reader->somethingCame(); }));
    reader.reset();
    EXPECT_TRUE(waitForEnd());
    ASSERT_EQ(m_failures.size(), 1U);
    EXPECT_FALSE(m_failures.front().detail.isEmpty());
}

}  // namespace
}  // namespace nmc

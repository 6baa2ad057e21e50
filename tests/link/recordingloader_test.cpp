// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of any kind is opened without blocking the thread that requests it.
#include "link/files/recordingloader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QFile>
#include <QTemporaryDir>

#include "model/recording/recording.h"
#include "tests/support/eventually.h"

namespace nmc {
namespace {

using testing_support::eventually;

class RecordingLoaderTest : public testing::Test {
protected:
    RecordingLoaderTest() {
        QObject::connect(&loader, &RecordingLoader::loaded,
                         [this](const std::shared_ptr<LoadedRecording>& recording) { loaded = recording; });
        QObject::connect(&loader, &RecordingLoader::failed,
                         [this](const FileError& error) { failed = error; });
    }
    QString path(const char* name) { return directory.filePath(QLatin1String(name)); }
    QString write(const char* name, const std::string& text) {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text.data(), static_cast<qint64>(text.size()));
        return file.fileName();
    }
    void open(const QString& file) {
        loader.start(file);
        ASSERT_TRUE(eventually([&] { return !loader.isBusy(); }));
        ASSERT_TRUE(eventually([&] { return loaded != nullptr || failed.has_value(); }));
    }
    /// A recording of gains, followed by `rows` samples of module 2, a millisecond apart.
    static std::string recording(int rows) {
        RecordingHeader header;
        header.startedAt = "2026-11-21T21:21:02.123+01:00";
        std::string text = recordingHead(header);
        servo::SetGain gains;
        gains.kp = 77;
        appendGains(text, {ModuleIndex(1), TimePoint(Duration(5)), gains}, {});
        for (int i = 0; i < rows; ++i) {
            ScopeSample sample;
            sample.time = TimePoint(std::chrono::milliseconds(i));
            sample.position = i;
            appendRow(text, ModuleIndex(1), sample, {});
        }
        return text;
    }

    QTemporaryDir directory;
    RecordingLoader loader;
    std::shared_ptr<LoadedRecording> loaded;
    std::optional<FileError> failed;
};

TEST_F(RecordingLoaderTest, ReadsSamplesAndGains) {
    open(write("run.csv", recording(1'000)));
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(loaded->samples, 1'000U);
    EXPECT_FALSE(loaded->problem.has_value());
    EXPECT_EQ(loaded->header.startedAt, "2026-11-21T21:21:02.123+01:00");
    EXPECT_EQ(loaded->history.module(ModuleIndex(1))->count(), 1'000U);
    EXPECT_EQ(loaded->history.module(ModuleIndex(1))->last()->position, 999);
    ASSERT_EQ(loaded->history.gains().size(), 1U);
    EXPECT_EQ(loaded->history.gains()[0].gains->kp, 77);
}

TEST_F(RecordingLoaderTest, ShowsWhatThereIsAboveAProblem) {
    open(write("cut.csv", recording(1'000) + "2,0.99"));
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(loaded->samples, 1'000U);
    ASSERT_TRUE(loaded->problem.has_value());
    EXPECT_EQ(loaded->problem->kind, RecordingProblem::Kind::Truncated);
}

TEST_F(RecordingLoaderTest, RefusesWhatIsNoPlainFile) {
    ASSERT_EQ(mkfifo(path("fifo").toLocal8Bit().constData(), 0600), 0);
    for (const QString& none : {directory.path(), path("fifo"), QStringLiteral("/dev/zero")}) {
        failed.reset();
        open(none);
        ASSERT_TRUE(failed.has_value()) << none.toStdString();
        EXPECT_EQ(failed->trouble, FileErrorKind::NotAFile);
    }
    failed.reset();
    open(path("none.csv"));
    ASSERT_TRUE(failed.has_value());
    EXPECT_EQ(failed->trouble, FileErrorKind::NotThere);
}

TEST_F(RecordingLoaderTest, AnotherFileTakesThePlaceOfTheFirst) {
    const QString big = write("big.csv", recording(300'000));
    const QString small = write("small.csv", recording(3));
    loader.start(big);
    open(small);
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(loaded->path, small);
    EXPECT_EQ(loaded->samples, 3U);
}

TEST_F(RecordingLoaderTest, ACancelledOneIsNotHeardOfAgain) {
    loader.start(write("run.csv", recording(1'000)));
    loader.cancel();
    EXPECT_FALSE(loader.isBusy());
    open(path("none.csv"));
    EXPECT_EQ(loaded, nullptr);
}

}  // namespace
}  // namespace nmc

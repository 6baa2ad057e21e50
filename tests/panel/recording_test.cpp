// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings are made and opened, with the simulator and a German locale.
#include <bit>

#include "model/recording/recordingreader.h"
#include "tests/support/choosefile.h"
#include "tests/support/gains.h"
#include "tests/support/virtualpanel.h"
#include "widgets/common/requests.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {
namespace {

using namespace testing_support;

struct ReadBack {
    RecordingHeader header;
    std::vector<ScopeSample> samples;  ///< of module 1
    std::vector<GainsChange> gains;
    std::optional<RecordingProblem> problem;
};

ReadBack readBack(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    ReadBack read;
    RecordingReader reader({[&](ModuleIndex module, const ScopeSample& sample) {
                                if (module == ModuleIndex(0))
                                    read.samples.push_back(sample);
                            },
                            [&](const GainsChange& change) { read.gains.push_back(change); }});
    reader.feed(file.readAll().toStdString());
    read.problem = reader.finish();
    read.header = reader.header();
    return read;
}

bool sameBits(const ScopeSample& a, const ScopeSample& b) {
    const auto same = [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    };
    return a.position == b.position && same(a.error, b.error) && same(a.errorLow, b.errorLow) &&
           same(a.errorHigh, b.errorHigh) && same(a.velocity, b.velocity) && a.analog == b.analog &&
           a.status == b.status && a.aux == b.aux && a.gapBefore == b.gapBefore;
}

class RecordingProgram : public testing::Test {
protected:
    RecordingProgram() {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        panel.start();
        panel.connectTo(sim.terminal());
        EXPECT_TRUE(panel.waitFor([&] { return panel.module().activity() != Activity::Unknown; }));
    }
    ~RecordingProgram() override { QLocale::setDefault(before); }

    ScopeFiles& files() { return panel.window().scopeFiles(); }
    QString path(const char* name) { return directory.filePath(QLatin1String(name)); }
    [[nodiscard]] const ModuleHistory& live() {
        return *panel.composition().store().history().module(ModuleIndex(0));
    }
    void record(const QString& file) { emit files().recordRequested(file); }
    bool told(const char* words) {
        return panel.waitFor([&] { return panel.count(QLatin1String(words)) > 0; });
    }
    [[nodiscard]] QString scopeTitle() {
        return panel.window().findChild<QLabel*>(QStringLiteral("scopeRecordLabel"))->text();
    }

    const QLocale before;
    QTemporaryDir directory;
    VirtualChain sim{QStringLiteral("servo,servo"), QStringLiteral("simulator=servo,servo")};
    VirtualPanel panel;
};

TEST_F(RecordingProgram, AMoveIsRecordedToTheLastBit) {
    const std::uint64_t first = live().count();
    record(path("move.csv"));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    ASSERT_TRUE(panel.answersFor(1.0));
    emit files().recordingEndRequested();
    ASSERT_TRUE(told("Recorded \"move.csv\""));

    const ReadBack read = readBack(path("move.csv"));
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_EQ(read.header.port, "simulator=servo,servo");
    EXPECT_TRUE(read.header.simulated);
    EXPECT_EQ(read.header.modules.size(), 2U);
    ASSERT_EQ(read.gains.size(), 1U);
    EXPECT_EQ(read.gains[0].gains, testing_support::kGains);

    const TimePoint zero = *panel.composition().store().history().zero();
    std::vector<ScopeSample> kept;
    live().visitSince(first, [&](const ScopeSample& sample) { kept.push_back(sample); });
    ASSERT_GT(read.samples.size(), 50U);
    ASSERT_GE(kept.size(), read.samples.size());
    for (std::size_t i = 0; i < read.samples.size(); ++i) {
        ASSERT_TRUE(sameBits(read.samples[i], kept[i])) << i;
        EXPECT_EQ(read.samples[i].time.time_since_epoch(), kept[i].time - zero)
            << i << ": the same as in the scope";
    }
    EXPECT_GT(read.samples.back().position, read.samples.front().position + 1'000);
}

TEST_F(RecordingProgram, AFileThatIsChosenAfterTheChainHasGoneIsNotBegun) {
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().modules.empty(); }));
    record(path("late.csv"));
    EXPECT_EQ(panel.count(QStringLiteral("Nothing is recorded to \"late.csv\": no module is connected.")), 1);
    EXPECT_FALSE(QFile::exists(path("late.csv")));
}

TEST_F(RecordingProgram, ARecordingIsOpenedInTheScopeWhileTheMotorGoesOn) {
    record(path("move.csv"));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    ASSERT_TRUE(panel.answersFor(0.5));
    emit files().recordingEndRequested();
    ASSERT_TRUE(told("Recorded \"move.csv\""));
    emit files().openRequested(path("move.csv"));
    ASSERT_TRUE(panel.waitFor([&] { return scopeTitle() == QLatin1String("move.csv (simulator)"); }));
    EXPECT_EQ(panel.module().activity(), Activity::AtSpeed);
}

TEST_F(RecordingProgram, ARecordingIsLaidUnderWhatIsLive) {
    record(path("move.csv"));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    ASSERT_TRUE(panel.answersFor(0.5));
    panel.click("scopeRecordingEndButton");
    ASSERT_TRUE(told("Recorded \"move.csv\""));
    files().underAction()->trigger();
    auto* dialog = panel.window().findChild<QFileDialog*>(QStringLiteral("layUnderDialog"));
    ASSERT_NE(dialog, nullptr);
    chooseFile(*dialog, path("move.csv"));
    auto* label = panel.window().findChild<QLabel*>(QStringLiteral("scopeUnderLabel"));
    EXPECT_TRUE(panel.waitFor([&] { return label->text().endsWith(QLatin1String("move.csv (simulator)")); }));
    EXPECT_EQ(scopeTitle(), QString()) << "the scope stays live";
    EXPECT_EQ(panel.module().activity(), Activity::AtSpeed);
}

TEST_F(RecordingProgram, GainsInForceAtTheStartAreInTheFile) {
    panel.ask(intent::ApplyGains{testing_support::kGains});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
    record(path("later.csv"));
    ASSERT_TRUE(panel.answersFor(0.2));
    emit files().recordingEndRequested();
    ASSERT_TRUE(told("Recorded \"later.csv\""));
    const ReadBack read = readBack(path("later.csv"));
    ASSERT_EQ(read.gains.size(), 1U);
    EXPECT_EQ(read.gains[0].gains, testing_support::kGains);
    EXPECT_LE(read.gains[0].time, read.samples.front().time);
}

TEST_F(RecordingProgram, AFullDiskEndsTheRecordingAndNotTheMotion) {
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    record(QStringLiteral("/dev/full"));
    ASSERT_TRUE(told("Recording to \"full\" stopped: the disk is full."));
    EXPECT_EQ(panel.module().activity(), Activity::AtSpeed);
    EXPECT_TRUE(panel.answersFor(0.3));
    EXPECT_FALSE(panel.window().findChild<QLabel*>(QStringLiteral("scopeRecordingLabel"))->isVisible());
    record(path("again.csv"));
    EXPECT_TRUE(panel.answersFor(0.2));
    emit files().recordingEndRequested();
    EXPECT_TRUE(told("Recorded \"again.csv\""));
}

TEST_F(RecordingProgram, ClosingThePortEndsTheRecording) {
    record(path("move.csv"));
    ASSERT_TRUE(panel.answersFor(0.3));
    panel.disconnect();
    ASSERT_TRUE(told("Recorded \"move.csv\""));
    const ReadBack read = readBack(path("move.csv"));
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_GT(read.samples.size(), 10U);
}

TEST_F(RecordingProgram, AStopIsNotedInTheFile) {
    record(path("stop.csv"));
    ASSERT_TRUE(panel.answersFor(0.1));
    panel.pressStopAll();
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("were off")) > 0; }));
    emit files().recordingEndRequested();
    ASSERT_TRUE(told("Recorded \"stop.csv\""));
    QFile file(path("stop.csv"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("s: Stop of all motors\n"));
}

TEST_F(RecordingProgram, AFileThatIsCutIsShownAndSaysSo) {
    record(path("move.csv"));
    ASSERT_TRUE(panel.answersFor(0.5));
    emit files().recordingEndRequested();
    ASSERT_TRUE(told("Recorded \"move.csv\""));
    QFile file(path("move.csv"));
    ASSERT_TRUE(file.resize(file.size() - 5));
    emit files().openRequested(path("move.csv"));
    EXPECT_TRUE(told("the file ends in the middle of this line."));
    EXPECT_TRUE(panel.waitFor([&] { return scopeTitle() == QLatin1String("move.csv (simulator)"); }));
}

TEST_F(RecordingProgram, WhatIsNoRecordingIsRefused) {
    const std::vector<std::pair<QString, const char*>> wrong{
        {directory.path(), "Could not open"},
        {QStringLiteral("/dev/zero"), "Could not open \"zero\""},
        {path("none.csv"), "Could not open \"none.csv\""}};
    for (const auto& [file, words] : wrong) {
        emit files().openRequested(file);
        EXPECT_TRUE(told(words)) << file.toStdString();
    }
    QFile picture(path("picture.csv"));
    ASSERT_TRUE(picture.open(QIODevice::WriteOnly));
    picture.write("\x89PNG\r\n\x1a\n");
    picture.close();
    emit files().openRequested(path("picture.csv"));
    EXPECT_TRUE(told("\"picture.csv\" is not a recording of NMC Panel."));
    EXPECT_EQ(scopeTitle(), QString()) << "the scope stays live";
}

TEST_F(RecordingProgram, AnExportIsWrittenWholeOrSaysWhyNot) {
    emit panel.window().requests().save(path("x.svg"), [] { return std::string("<svg/>"); });
    ASSERT_TRUE(told("Saved \"x.svg\"."));
    QFile file(path("x.svg"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), "<svg/>");
    emit panel.window().requests().save(path("none/x.svg"), [] { return std::string("<svg/>"); });
    EXPECT_TRUE(told("Could not save \"x.svg\"."));
}

}  // namespace
}  // namespace nmc

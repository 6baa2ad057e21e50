// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/files/recordingwriter.h"
#include "model/recording/recordingreader.h"
#include "widgets/common/texts.h"
#include "windowtest.h"

namespace nmc {
namespace {

QString sentence(const RecordingProblem& problem) {
    return texts::recordingProblem(u"mill.csv"_s, problem);
}

TEST(RecordingTexts, SayWhatIsWrongWithAFile) {
    EXPECT_EQ(sentence({.kind = RecordingProblem::Kind::Empty}), u"\"mill.csv\" is empty."_s);
    EXPECT_EQ(sentence({.kind = RecordingProblem::Kind::OtherFormat}),
              u"\"mill.csv\" is not a recording of NMC Panel."_s);
    EXPECT_EQ(
        sentence({.kind = RecordingProblem::Kind::OtherForm}),
        u"\"mill.csv\" has one column per signal, a format for other programs. The scope opens files with one row per reply."_s);
    EXPECT_EQ(
        sentence({.kind = RecordingProblem::Kind::NewerVersion, .found = "7", .max = 1}),
        u"\"mill.csv\" was written by a newer NMC Panel: its format is 7; this version reads formats up to 1."_s);
}

TEST(RecordingTexts, SayWhatIsWrongInALine) {
    const auto inLine = [](RecordingProblem problem) {
        problem.line = 12;
        return sentence(problem);
    };
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::NoColumns}),
              u"\"mill.csv\" line 12: the file ends before its column names."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::MissingColumn, .field = "time_s"}),
              u"\"mill.csv\" line 12: column time_s is missing."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::LineTooLong, .max = 20'000}),
              u"\"mill.csv\" line 12: the line is longer than 20000 bytes, too long for a recording."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::Truncated}),
              u"\"mill.csv\" line 12: the file ends in the middle of this line."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::TooFewCells, .found = "3", .max = 12}),
              u"\"mill.csv\" line 12: the line has 3 cells for 12 columns."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::EmptyCell, .field = "position"}),
              u"\"mill.csv\" line 12: position is empty."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::NotANumber, .field = "position", .found = "x"}),
              u"\"mill.csv\" line 12: position is \"x\", which is not a number."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::OutOfRange,
                      .field = "status",
                      .found = "256",
                      .min = 0,
                      .max = 255}),
              u"\"mill.csv\" line 12: status is 256; it must be 0 to 255."_s);
    EXPECT_EQ(inLine({.kind = RecordingProblem::Kind::TimeGoesBack, .field = "time_s", .found = "2"}),
              u"\"mill.csv\" line 12: time_s of module 2 goes backwards."_s);
}

TEST(RecordingTexts, SayWhatIsShownOfAFileThatIsCut) {
    const RecordingProblem cut{.kind = RecordingProblem::Kind::Truncated, .line = 12};
    EXPECT_EQ(texts::recordingCut(u"/home/anna/mill.csv"_s, cut, 8).body,
              u"The scope shows the samples above that line: 8."_s);
    EXPECT_EQ(texts::recordingCut(u"/home/anna/mill.csv"_s, cut, 0).body,
              u"It has nothing to show. Choose another file."_s);
}

/// 1.2 times 1024 squared are 1 258 291 bytes.
TEST(RecordingTexts, SayWhyARecordingEndedAndWhatIsKept) {
    const auto ended = [](RecordingProblemKind trouble, qint64 bytes) {
        return texts::recordingFailed(u"/mnt/mill.csv"_s, {trouble, u"words of the system"_s, bytes});
    };
    const Message full = ended(RecordingProblemKind::NoSpace, 1'258'291);
    EXPECT_EQ(full.headline, u"Recording to \"mill.csv\" stopped: the disk is full."_s);
    EXPECT_EQ(
        full.body,
        u"The part written before (1.2 MB) is kept. Motor control continues. To continue recording, choose another file."_s);
    EXPECT_EQ(full.details, u"words of the system"_s);
    EXPECT_EQ(full.severity, Severity::Attention);
    EXPECT_TRUE(ended(RecordingProblemKind::NoPermission, 0).body.startsWith(u"Nothing was kept."_s));
    EXPECT_TRUE(ended(RecordingProblemKind::Removed, 4'096).body.startsWith(u"Nothing was kept."_s));
    EXPECT_EQ(full.key, ended(RecordingProblemKind::TooSlow, 1).key) << "repeats are counted";
}

}  // namespace
}  // namespace nmc

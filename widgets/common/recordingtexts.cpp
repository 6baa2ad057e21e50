// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about recordings and exports of the scope.
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include "link/files/recordingwriter.h"
#include "model/recording/recordingreader.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

namespace {

QString fileNameOf(const QString& path) {
    return QFileInfo(path).fileName();
}

QString folderOf(const QString& path) {
    return QDir::toNativeSeparators(QFileInfo(path).absolutePath());
}

QString length(double seconds) {
    return Texts::tr("%1 s").arg(
        readout(seconds < 10 ? std::round(seconds * 10) / 10 : std::round(seconds), 6));
}

/// Follows "stopped: ".
QString cause(RecordingProblemKind trouble) {
    switch (trouble) {
        case RecordingProblemKind::NoFolder:
            return Texts::tr("its folder does not exist.");
        case RecordingProblemKind::NotAFile:
            return Texts::tr("this is a folder or a device, not a file.");
        case RecordingProblemKind::NoPermission:
            return Texts::tr("your user account has no write access.");
        case RecordingProblemKind::ReadOnly:
            return Texts::tr("the disk is read-only.");
        case RecordingProblemKind::NoSpace:
            return Texts::tr("the disk is full.");
        case RecordingProblemKind::FileTooLarge:
            return Texts::tr("the file is too large for the disk.");
        case RecordingProblemKind::Removed:
            return Texts::tr("the file was deleted.");
        case RecordingProblemKind::TooSlow:
            return Texts::tr("the disk is too slow.");
        case RecordingProblemKind::Other:
            return Texts::tr("the disk reported a write error.");
    }
    return {};
}

/// What is wrong in a line; follows a colon and ends with a full stop.
QString wrongInLine(const RecordingProblem& problem) {
    using Kind = RecordingProblem::Kind;
    const QString field = QString::fromStdString(problem.field);
    const QString found = QString::fromStdString(problem.found);
    switch (problem.kind) {
        case Kind::Empty:
        case Kind::OtherFormat:
        case Kind::OtherForm:
        case Kind::NewerVersion:
            return {};
        case Kind::NoColumns:
            return Texts::tr("the file ends before its column names.");
        case Kind::MissingColumn:
            return Texts::tr("column %1 is missing.").arg(field);
        case Kind::LineTooLong:
            return Texts::tr("the line is longer than %1 bytes, too long for a recording.")
                .arg(plainNumber(problem.max));
        case Kind::Truncated:
            return Texts::tr("the file ends in the middle of this line.");
        case Kind::TooFewCells:
            return Texts::tr("the line has %1 cells for %2 columns.").arg(found, plainNumber(problem.max));
        case Kind::EmptyCell:
            return Texts::tr("%1 is empty.").arg(field);
        case Kind::NotANumber:
            return Texts::tr("%1 is \"%2\", which is not a number.").arg(field, found);
        case Kind::OutOfRange:
            return Texts::tr("%1 is %2; it must be %3 to %4.")
                .arg(field, found, plainNumber(problem.min), plainNumber(problem.max));
        case Kind::TimeGoesBack:
            return Texts::tr("%1 of module %2 goes backwards.").arg(field, found);
    }
    return {};
}

Message notOpened(const QString& headline, const QString& body, const QString& details = {}) {
    return {.key = key::kOpenedRecording,
            .severity = Severity::Attention,
            .headline = headline,
            .body = body,
            .details = details};
}

}  // namespace

Message recordingNotBegun(const QString& path) {
    return {
        .key = key::kRecording,
        .severity = Severity::Attention,
        .headline = Texts::tr("Nothing is recorded to \"%1\": no module is connected.").arg(fileNameOf(path)),
        .body = Texts::tr("Connect first, then record again.")};
}

Message recordingEnded(const QString& path, double seconds) {
    return {.key = key::kRecording,
            .headline = Texts::tr("Recorded \"%1\": %2.").arg(fileNameOf(path), length(seconds)),
            .body = Texts::tr("Saved in %1.").arg(folderOf(path))};
}

/// The size tells what is kept; of what was recorded, more may have waited for a slow disk.
Message recordingFailed(const QString& path, const RecordingFailure& failure) {
    const bool kept = failure.bytes > 0 && failure.trouble != RecordingProblemKind::Removed;
    const QString rest =
        kept ? Texts::tr("The part written before (%1) is kept.")
                   .arg(QLocale().formattedDataSize(failure.bytes, 1, QLocale::DataSizeTraditionalFormat))
             : Texts::tr("Nothing was kept.");
    return {
        .key = key::kRecording,
        .severity = Severity::Attention,
        .headline =
            Texts::tr("Recording to \"%1\" stopped: %2").arg(fileNameOf(path), cause(failure.trouble)),
        .body =
            Texts::tr("%1 Motor control continues. To continue recording, choose another file.").arg(rest),
        .details = failure.detail};
}

QString recordingProblem(const QString& file, const RecordingProblem& problem) {
    using Kind = RecordingProblem::Kind;
    if (problem.kind == Kind::Empty)
        return Texts::tr("\"%1\" is empty.").arg(file);
    if (problem.kind == Kind::OtherFormat)
        return Texts::tr("\"%1\" is not a recording of NMC Panel.").arg(file);
    if (problem.kind == Kind::OtherForm)
        return Texts::
            tr("\"%1\" has one column per signal, a format for other programs. The scope opens files with one row per reply.")
                .arg(file);
    if (problem.kind == Kind::NewerVersion)
        return Texts::
            tr("\"%1\" was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.")
                .arg(file, QString::fromStdString(problem.found), plainNumber(problem.max));
    return Texts::tr("\"%1\" line %2: %3").arg(file, QString::number(problem.line), wrongInLine(problem));
}

Message recordingCut(const QString& path, const RecordingProblem& problem, quint64 samples) {
    const QString what = recordingProblem(fileNameOf(path), problem);
    if (samples == 0)
        return notOpened(what, Texts::tr("It has nothing to show. Choose another file."));
    return notOpened(what, Texts::tr("The scope shows the samples above that line: %1.")
                               .arg(grouped(static_cast<qint64>(samples))));
}

Message recordingWithoutSamples(const QString& path) {
    return notOpened(Texts::tr("\"%1\" contains no samples.").arg(fileNameOf(path)),
                     Texts::tr("It has nothing to show. Choose another file."));
}

Message recordingNotOpened(const FileError& error) {
    return notOpened(Texts::tr("Could not open \"%1\".").arg(fileNameOf(error.path)), fileProblem(error),
                     error.detail);
}

Message exported(const QString& path) {
    return {.key = key::kExported,
            .headline = Texts::tr("Saved \"%1\".").arg(fileNameOf(path)),
            .body = Texts::tr("Saved in %1.").arg(folderOf(path)),
            .relation = Message::Relation::Update};  // the trigger may save one after another
}

Message notExported(const FileError& error) {
    return {.key = key::kNotExported,
            .severity = Severity::Attention,
            .headline = Texts::tr("Could not save \"%1\".").arg(fileNameOf(error.path)),
            .body = fileProblem(error),
            .details = error.detail};
}

}  // namespace nmc::texts

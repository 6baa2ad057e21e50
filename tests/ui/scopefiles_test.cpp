// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopefiles.h"

#include "model/recording/recordingreader.h"
#include "scopehistory.h"
#include "tests/support/choosefile.h"
#include "widgets/common/palettes.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopeplot.h"
#include "windowtest.h"

namespace nmc {
namespace {

class ScopeFilesTest : public WindowTest {
protected:
    ScopeFilesTest() : saved(&window->requests(), &Requests::save) { showServos({{}, {}}); }
    ScopeFiles& files() { return window->scopeFiles(); }
    void show(HandMadeHistory& made, double now) {
        for (int i = 0; i < 2; ++i) {
            window->showHistory(made.history(), HandMadeHistory::at(now));
            QApplication::processEvents();
        }
    }
    QAction* action(const QString& objectName) {
        auto* found = window->findChild<QAction*>(objectName);
        EXPECT_NE(found, nullptr) << objectName.toStdString();
        return found;
    }
    /// The content for the file that is chosen.
    std::string exported(const QString& name, HandMadeHistory& made, double now, int filter = 0) {
        action(u"scopeExport"_s + name + u"Action"_s)->trigger();
        auto* dialog = find<QFileDialog>(u"scopeExport"_s + name.toLower() + u"Dialog"_s);
        EXPECT_FALSE(dialog->isModal()) << "STOP ALL stays within reach";
        dialog->selectNameFilter(dialog->nameFilters().value(filter));
        testing_support::chooseFile(*dialog, u"/home/anna/run.x"_s);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        show(made, now);
        EXPECT_EQ(saved.count(), 1);
        if (saved.isEmpty())
            return {};
        EXPECT_EQ(saved[0][0].toString(), u"/home/anna/run.x"_s);
        return saved.takeFirst()[1].value<FileContent>()();
    }
    /// 30 s of module 1, and 10 s of module 2, with 10 samples per second.
    static HandMadeHistory twoModules() {
        HandMadeHistory made(2);
        for (int i = 0; i <= 300; ++i)
            made.add(i / 10.0, i).error = 0.1F;
        for (int i = 0; i <= 100; ++i)
            made.addTo(1, 20 + i / 10.0, -i);
        return made;
    }

    QSignalSpy saved;
};

TEST_F(ScopeFilesTest, CsvHoldsEverySampleOfTheTimeThatIsSeen) {
    const QDateTime before = QDateTime::currentDateTime();
    HandMadeHistory made = twoModules();
    show(made, 29.5);  // the window moves in whole divisions
    std::vector<std::int32_t> first;
    std::vector<std::int32_t> second;
    RecordingReader reader({[&](ModuleIndex module, const ScopeSample& sample) {
        (module == ModuleIndex(0) ? first : second).push_back(sample.position);
        const bool same = module != ModuleIndex(0) || sample.error == 0.1F;
        EXPECT_TRUE(same) << sample.error;
    }});
    reader.feed(exported(u"Csv"_s, made, 29.5));
    EXPECT_FALSE(reader.finish().has_value());
    ASSERT_EQ(first.size(), 101U) << "20 to 30 s";
    EXPECT_EQ(first.front(), 200);
    EXPECT_EQ(first.back(), 300);
    ASSERT_EQ(second.size(), 101U);
    EXPECT_EQ(second.back(), -100);
    EXPECT_EQ(reader.header().port, "/dev/ttyUSB0");
    EXPECT_FALSE(reader.header().simulated);
    ASSERT_EQ(reader.header().modules.size(), 2U);
    const QDateTime started =
        QDateTime::fromString(QString::fromStdString(reader.header().startedAt), Qt::ISODateWithMs);
    // The first sample came 30 s before the first frame.
    EXPECT_GE(started, before.addSecs(-31));
    EXPECT_LE(started, QDateTime::currentDateTime().addSecs(-28));
}

/// The date has gone on by 600 s more than the time of the samples, which is 600 s less here, as the date
/// cannot be set.
TEST_F(ScopeFilesTest, TheSamplesAfterASuspendHaveTheirDate) {
    HandMadeHistory made = twoModules();
    show(made, 629.5);
    const QDateTime before = QDateTime::currentDateTime();
    show(made, 29.5);
    RecordingReader reader({[](ModuleIndex /*module*/, const ScopeSample& /*sample*/) {}});
    reader.feed(exported(u"Csv"_s, made, 29.5));
    const QDateTime started =
        QDateTime::fromString(QString::fromStdString(reader.header().startedAt), Qt::ISODateWithMs);
    EXPECT_GE(started, before.addSecs(-31));
    EXPECT_LE(started, QDateTime::currentDateTime().addSecs(-28));
}

/// 600 s after the last sample, the port is closed, and time stands where the samples end.
TEST_F(ScopeFilesTest, TheDatesOfTheSamplesStayAfterADisconnect) {
    HandMadeHistory made = twoModules();
    const QDateTime before = QDateTime::currentDateTime();
    show(made, 630);
    const double end = toSeconds(*made.history().end() - *made.history().zero());
    show(made, end);
    RecordingReader reader({[](ModuleIndex /*module*/, const ScopeSample& /*sample*/) {}});
    reader.feed(exported(u"Csv"_s, made, end));
    const QDateTime started =
        QDateTime::fromString(QString::fromStdString(reader.header().startedAt), Qt::ISODateWithMs);
    EXPECT_GE(started, before.addSecs(-631));
    EXPECT_LE(started, QDateTime::currentDateTime().addSecs(-628));
}

TEST_F(ScopeFilesTest, CsvHasAColumnForEachSignalWhereThatIsChosen) {
    HandMadeHistory made = twoModules();
    show(made, 29.5);
    const QStringList sparse = QString::fromStdString(exported(u"Csv"_s, made, 29.5, 1)).split(u'\n');
    EXPECT_TRUE(sparse[0].startsWith(u"time_s,Module_1/position_counts,"_s)) << sparse[0].toStdString();
    EXPECT_TRUE(sparse[0].contains(u",Module_2/position_counts,"_s));
    ASSERT_EQ(sparse.size(), 1 + 202 + 1) << "101 replies of each from 20 to 30 s";
    EXPECT_TRUE(sparse[1].startsWith(u"20.000000000,200,"_s)) << sparse[1].toStdString();
    const qsizetype acceleration = sparse[0].split(u',').indexOf(u"Module_1/acceleration_counts_per_s2"_s);
    ASSERT_GT(acceleration, 0);
    const QString first = sparse[1].split(u',')[acceleration];
    EXPECT_FALSE(first.isEmpty()) << "earlier samples contribute to it, too";
    EXPECT_NEAR(first.toDouble(), 0, 1e-6) << "10 counts/s all the time";
    const QStringList even = QString::fromStdString(exported(u"Csv"_s, made, 29.5, 2)).split(u'\n');
    EXPECT_EQ(even[0], sparse[0]);
    ASSERT_EQ(even.size(), 1 + 10'001 + 1);
    EXPECT_TRUE(even[1 + 50].startsWith(u"20.050000000,200.5,"_s)) << even[51].toStdString();
}

TEST_F(ScopeFilesTest, CsvSaysWhenOlderSamplesAreOnlyKeptInACoarserForm) {
    const std::string words = "not all samples before are in this file";
    HandMadeHistory young = twoModules();
    show(young, 30);
    EXPECT_EQ(exported(u"Csv"_s, young, 30).find(words), std::string::npos);
    HandMadeHistory old(2);  // more samples than there is memory for
    for (int i = 0; i < 900'000; ++i)
        old.add(30 + i / 100'000.0, i);
    show(old, 39);
    EXPECT_NE(exported(u"Csv"_s, old, 39).find(words), std::string::npos);
}

TEST_F(ScopeFilesTest, PngIsTheStripsBelowACaption) {
    HandMadeHistory made = twoModules();
    for (int i = 0; i < 3; ++i)
        show(made, 30);
    const QImage image = QImage::fromData(QByteArray::fromStdString(exported(u"Png"_s, made, 30)), "PNG");
    const QWidget* strips = find(u"scopeStrips"_s);
    EXPECT_EQ(image.width(), 2 * strips->width());
    EXPECT_GT(image.height(), 2 * (strips->height() + strips->fontMetrics().height()));
}

TEST_F(ScopeFilesTest, SvgOfARecordCanBeReadWhateverItsTitle) {
    HandMadeHistory made = twoModules();
    auto record = std::make_shared<ScopeRecord>();
    record->title = u"A & <b>.csv"_s;
    record->history = made.history();
    record->modules = window->scopeModules();
    window->showRecord(record);
    QXmlStreamReader xml(QByteArray::fromStdString(exported(u"Svg"_s, made, 30)));
    QString words;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::Characters)
            words += xml.text();
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_TRUE(words.contains(record->title)) << words.toStdString();
}

TEST_F(ScopeFilesTest, SvgHoldsTheTracesAsLinesWithinThePlot) {
    HandMadeHistory made(2);
    for (int i = 0; i <= 3'000; ++i)  // more than there are pixels
        made.add(i / 100.0, i < 2'500 ? 0 : 100'000);
    show(made, 30);
    auto* plot = find<ScopePlot>(u"scopePlot1"_s);
    plot->zoomValues(0.001, 0);  // the step leaves the plot far above
    const std::string svg = exported(u"Svg"_s, made, 30);
    QXmlStreamReader xml(QByteArray::fromStdString(svg));
    QList<qsizetype> curves;  // number of points of each
    QString words;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isCharacters())
            words += xml.text();
        if (!xml.isStartElement() || (xml.name() != u"polyline"_s && xml.name() != u"path"_s))
            continue;
        // No coordinate is outside of the picture, as those of the step's line would be.
        static const QRegularExpression number(u"-?[0-9.]+(e[+-]?[0-9]+)?"_s);
        const QString shape =
            xml.attributes().value(xml.name() == u"path"_s ? u"d"_s : u"points"_s).toString();
        qsizetype numbers = 0;
        for (auto match = number.globalMatch(shape); match.hasNext(); ++numbers)
            EXPECT_LT(std::abs(match.next().captured().toDouble()), 5'000) << shape.toStdString();
        if (numbers > 100)
            curves << numbers / 2;
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    ASSERT_EQ(curves.size(), 2)
        << "position and A/D; the step has left the plot, and the command is not known";
    for (const qsizetype places : curves)
        EXPECT_GT(places, 400);
    EXPECT_EQ(svg.find("<image"), std::string::npos) << "vectors only";
    EXPECT_TRUE(words.contains(u"/dev/ttyUSB0"_s)) << words.toStdString();
}

TEST_F(ScopeFilesTest, APageHoldsThePictureInVectors) {
    HandMadeHistory made = twoModules();
    show(made, 30);
    const std::string pdf = exported(u"Pdf"_s, made, 30);
    EXPECT_TRUE(pdf.starts_with("%PDF-"));
    EXPECT_NE(pdf.find("/MediaBox [0 0 842"), std::string::npos) << "A4 in landscape format";
    EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos) << "vectors only";
}

/// A page without the date and the random numbers that its writer inserts.
QString pageIn(const std::string& pdf) {
    static const QRegularExpression chance(u"/CreationDate[^\n]*|/ID[^\n]*|<xmp[^\n]*"_s);
    return QString::fromLatin1(QByteArray::fromStdString(pdf)).remove(chance);
}

TEST_F(ScopeFilesTest, PaperKnowsNothingOfTheScreensColours) {
    HandMadeHistory made = twoModules();
    show(made, 30);
    const std::string png = exported(u"Png"_s, made, 30);
    const std::string svg = exported(u"Svg"_s, made, 30);
    const std::string pdf = exported(u"Pdf"_s, made, 30);
    const QImage light = QImage::fromData(QByteArray::fromStdString(png), "PNG");
    EXPECT_EQ(light.pixelColor(2, light.height() - 2), QColor(Qt::white));
    window->setPalette(darkPalette());
    show(made, 30);
    EXPECT_TRUE(exported(u"Png"_s, made, 30) == png);
    EXPECT_TRUE(exported(u"Svg"_s, made, 30) == svg);
    EXPECT_TRUE(pageIn(exported(u"Pdf"_s, made, 30)) == pageIn(pdf));
    EXPECT_EQ(find(u"scopeStrips"_s)->palette().color(QPalette::Base), darkPalette().color(QPalette::Base))
        << "the screen stays as it was";
    window->setPalette(look::paletteOf(look::Colours::HighContrast));
    EXPECT_EQ(find(u"scopeStrips"_s)->palette().color(QPalette::Base), QColor(Qt::black))
        << "it follows its palette as before";
}

TEST_F(ScopeFilesTest, ACopyIsAPictureAndItsFewSamples) {
    HandMadeHistory made = twoModules();
    show(made, 30);
    action(u"scopeCopyAction"_s)->trigger();
    show(made, 30);
    const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
    EXPECT_TRUE(copied->hasImage());
    EXPECT_TRUE(copied->data(u"text/csv"_s).startsWith("# NMC Panel recording 1"));
}

TEST_F(ScopeFilesTest, WhatIsExportedIsSavedEvenIfTheScopeIsHiddenMeanwhile) {
    HandMadeHistory made = twoModules();
    show(made, 30);
    action(u"scopeExportCsvAction"_s)->trigger();
    auto* dialog = find<QFileDialog>(u"scopeExportcsvDialog"_s);
    action(u"scopeDockAction"_s)->trigger();
    ASSERT_FALSE(window->findChild<ScopePanel*>()->isVisible());
    testing_support::chooseFile(*dialog, u"/home/anna/run.csv"_s);
    show(made, 30);
    EXPECT_EQ(saved.count(), 1);
}

TEST_F(ScopeFilesTest, RecordsOnlyWhatIsConnected) {
    files().showConnected(false);
    EXPECT_FALSE(button(u"scopeRecordButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"scopeRecordButton"_s)->toolTip().contains(u"connect a module first"_s));
    files().showConnected(true);
    EXPECT_TRUE(button(u"scopeRecordButton"_s)->isEnabled());
    QSignalSpy wanted(&files(), &ScopeFiles::recordRequested);
    click(u"scopeRecordButton"_s);
    auto* dialog = find<QFileDialog>(u"scopeRecordDialog"_s);
    EXPECT_FALSE(dialog->isModal());
    EXPECT_FALSE(dialog->testOption(QFileDialog::DontConfirmOverwrite));
    testing_support::chooseFile(*dialog, u"/home/anna/mill.csv"_s);
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted[0][0].toString(), u"/home/anna/mill.csv"_s);
}

TEST_F(ScopeFilesTest, SaysThatItRecordsAndEndsWhenAsked) {
    files().showConnected(true);
    files().showRecording(ScopeFiles::Recording{u"/home/anna/mill.csv"_s, 12.7, 1'258'291});
    EXPECT_TRUE(find(u"scopeRecordingLabel"_s)->isVisible());
    EXPECT_EQ(text(u"scopeRecordingLabel"_s), u"● Recording mill.csv, 12 s, 1.2 MB"_s);
    EXPECT_EQ(button(u"scopeRecordButton"_s)->text(), u"Stop recording"_s);
    EXPECT_EQ(button(u"scopeRecordButton"_s)->accessibleName(), u"Stop recording"_s);
    QSignalSpy ended(&files(), &ScopeFiles::recordingEndRequested);
    click(u"scopeRecordingEndButton"_s);
    EXPECT_EQ(ended.count(), 1);
    click(u"scopeRecordButton"_s);
    EXPECT_EQ(ended.count(), 2) << "Ctrl+Shift+R begins and ends";
    files().showConnected(false);
    EXPECT_TRUE(button(u"scopeRecordButton"_s)->isEnabled()) << "until it has ended";
    files().showRecording({});
    EXPECT_FALSE(find(u"scopeRecordingLabel"_s)->isVisible());
    EXPECT_EQ(button(u"scopeRecordButton"_s)->accessibleName(), u"Record…"_s);
}

TEST_F(ScopeFilesTest, SaysHowFarItHasOpenedAndCanBeCancelled) {
    files().showOpening(ScopeFiles::Opening{u"/home/anna/mill.csv"_s, 0.456});
    EXPECT_EQ(text(u"scopeOpeningLabel"_s), u"Opening mill.csv, 45 %"_s);
    QSignalSpy cancelled(&files(), &ScopeFiles::openingCancelled);
    click(u"scopeOpeningEndButton"_s);
    EXPECT_EQ(cancelled.count(), 1);
    files().showOpening({});
    EXPECT_FALSE(find(u"scopeOpeningLabel"_s)->isVisible());
}

TEST_F(ScopeFilesTest, OpensWhatIsChosenOrDropped) {
    const QString chosen = directory.filePath(u"a.csv"_s);
    ASSERT_TRUE(QFile(chosen).open(QIODevice::WriteOnly));
    QSignalSpy wanted(&files(), &ScopeFiles::openRequested);
    action(u"openRecordingAction"_s)->trigger();
    auto* dialog = find<QFileDialog>(u"openRecordingDialog"_s);
    EXPECT_FALSE(dialog->isModal());
    testing_support::chooseFile(*dialog, chosen);
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile(u"/home/anna/b.csv"_s)});
    auto* panel = window->findChild<ScopePanel*>();
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(panel, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &dragged, Qt::LeftButton, {});
    QApplication::sendEvent(panel, &drop);
    ASSERT_EQ(wanted.count(), 2);
    EXPECT_EQ(wanted[0][0].toString(), chosen);
    EXPECT_EQ(wanted[1][0].toString(), u"/home/anna/b.csv"_s);
}

TEST_F(ScopeFilesTest, ARecordIsExportedAsTheOneThatItWas) {
    HandMadeHistory made = twoModules();
    HandMadeHistory live(2);
    live.add(0, 5);
    show(live, 0);
    RecordingHeader header;
    header.startedAt = "2026-11-21T21:21:02.123+01:00";
    header.zero = HandMadeHistory::at(0);
    header.port = "/dev/ttyS7";
    header.simulated = true;
    window->showRecord(std::make_shared<const ScopeRecord>(recordOf(u"mill.csv"_s, header, made.history())));
    show(live, 0);
    EXPECT_EQ(text(u"scopeRecordLabel"_s), u"mill.csv (simulator)"_s);
    RecordingReader reader({[](ModuleIndex, const ScopeSample&) {}});
    reader.feed(exported(u"Csv"_s, live, 0));
    EXPECT_FALSE(reader.finish().has_value());
    EXPECT_EQ(reader.samples(), 301U + 101U);
    EXPECT_EQ(reader.header().startedAt, "2026-11-21T21:21:02.123+01:00");
    EXPECT_EQ(reader.header().port, "/dev/ttyS7");
    EXPECT_TRUE(reader.header().simulated);
}

}  // namespace
}  // namespace nmc

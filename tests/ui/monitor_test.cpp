// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/packetrecords.h"
#include "tests/support/choosefile.h"
#include "widgets/monitor/monitordock.h"
#include "widgets/monitor/packetmonitor.h"
#include "windowtest.h"

namespace nmc {
namespace {

using namespace testing_support;
using bus::Purpose;
using bus::ReplyResult;

class Monitor : public WindowTest {
protected:
    Monitor() { window->monitor().begin(session(true)); }

    static PacketSession session(bool simulated) {
        return {"NMC Panel 0.3.0", "2025-06-01T12:00:00.000Z", simulated ? "simulator" : "/dev/ttyUSB0",
                simulated, TimePoint{}};
    }
    MonitorDock* dock() { return find<MonitorDock>(u"monitorDock"_s); }
    bool recording() { return dock()->builtPage() != nullptr && dock()->builtPage()->recording(); }
    QTableView* table() { return find<QTableView>(u"packetTable"_s); }
    QComboBox* box(const QString& objectName) { return find<QComboBox>(objectName); }
    void open() {
        window->findChild<QAction*>(u"monitorDockAction"_s)->trigger();
        ASSERT_TRUE(eventually([this] { return recording(); }));
    }
    QString cell(int row, int column) { return table()->model()->index(row, column).data().toString(); }
    QStringList column(int number) {
        QStringList texts;
        for (int row = 0; row < table()->model()->rowCount(); ++row)
            texts << cell(row, number);
        return texts;
    }
    int rows() { return table()->model()->rowCount(); }
    /// Shows a connect, two polls and an unanswered stop, which the filters distinguish.
    void showFour() {
        window->monitor().showPackets(
            {resetRecord(1, 100), pollRecord(2, 2'000'000), pollRecord(3, 2'500'000, 1),
             with(pollRecord(4, 3'000'000), Purpose::Stop, ReplyResult::Unresponsive)});
    }
    void showPolls(int count, std::uint64_t from = 1) {
        std::vector<bus::ExchangeRecord> records;
        for (int i = 0; i < count; ++i)
            records.push_back(pollRecord(from + static_cast<std::uint64_t>(i), i));
        window->monitor().showPackets(std::move(records));
    }
    /// The content for the file that the user chooses.
    QByteArray saved(const QString& name) {
        QSignalSpy saves(&window->requests(), &Requests::save);
        click(u"packetSave"_s);
        testing_support::chooseFile(*find<QFileDialog>(u"packetSaveDialog"_s), directory.filePath(name));
        if (saves.size() != 1)
            return {};
        EXPECT_EQ(saves[0][0].toString(), directory.filePath(name));
        return QByteArray::fromStdString(saves[0][1].value<FileContent>()());
    }
    QSignalSpy wanted{&window->monitor(), &MonitorDock::recordingChanged};
};

TEST_F(Monitor, WantsRecordsOnlyWhileItCanBeSeenAndIsNotPaused) {
    EXPECT_FALSE(recording());
    EXPECT_EQ(wanted.size(), 0);
    open();
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_TRUE(wanted.at(0).at(0).toBool());
    click(u"packetPause"_s);
    ASSERT_EQ(wanted.size(), 2);
    EXPECT_FALSE(wanted.at(1).at(0).toBool());
    EXPECT_EQ(button(u"packetPause"_s)->text(), u"Resume"_s);
    click(u"packetPause"_s);
    ASSERT_EQ(wanted.size(), 3);
    EXPECT_TRUE(wanted.at(2).at(0).toBool());
    dock()->close();
    ASSERT_TRUE(eventually([this] { return wanted.size() == 4; }));
    EXPECT_FALSE(wanted.at(3).at(0).toBool());
}

TEST_F(Monitor, IsBuiltWhenItIsFirstSeenAndKnowsTheConnectionThen) {
    window->monitor().begin(session(false));
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.modules.resize(5);
    window->showLink(link);
    EXPECT_EQ(window->findChild<QTabWidget*>(u"monitorTabs"_s), nullptr);
    open();
    EXPECT_NE(window->findChild<QTabWidget*>(u"monitorTabs"_s), nullptr);
    EXPECT_EQ(box(u"packetModuleBox"_s)->count(), 6) << "all, and five modules";
    EXPECT_TRUE(saved(u"first.txt"_s).contains("/dev/ttyUSB0"));
}

TEST_F(Monitor, WantsNoneBehindAnotherTab) {
    open();
    find<QDockWidget>(u"messagesDock"_s)->raise();
    EXPECT_TRUE(eventually([this] { return !recording(); }));
    dock()->raise();
    EXPECT_TRUE(eventually([this] { return recording(); }));
}

TEST_F(Monitor, ShowsTimeBytesMeaningAndVerdict) {
    open();
    showFour();
    ASSERT_EQ(rows(), 4);
    const QStringList poll{u"2.000000"_s,
                           u"Module 1"_s,
                           u"poll"_s,
                           u"AA 01 13 05 19"_s,
                           u"Read Status: position, velocity"_s,
                           u"09 D2 04 00 00 FE FF DC"_s,
                           u"position 1234, velocity 2, move_done power_on"_s,
                           u"accepted"_s};
    for (int column = 0; column < 8; ++column)
        EXPECT_EQ(cell(1, column), poll.at(column));
    EXPECT_EQ(column(1), (QStringList{u"Group FF"_s, u"Module 1"_s, u"Module 2"_s, u"Module 1"_s}));
    EXPECT_EQ(cell(0, 7), u"no answer expected"_s);
    EXPECT_EQ(cell(3, 7), u"no answer"_s);
    EXPECT_EQ(text(u"packetSummary"_s), u"4 of 4 shown"_s);
}

TEST_F(Monitor, FiltersByModuleAndByKind) {
    showServos({{}, {}});
    open();
    showFour();
    box(u"packetModuleBox"_s)->setCurrentIndex(2);
    EXPECT_EQ(column(1), (QStringList{u"Module 2"_s}));
    EXPECT_EQ(text(u"packetSummary"_s), u"1 of 4 shown"_s);
    box(u"packetModuleBox"_s)->setCurrentIndex(0);
    const auto purposesOf = [this](const QString& kind) {
        QComboBox* kinds = box(u"packetKindBox"_s);
        kinds->setCurrentIndex(kinds->findText(kind));
        return column(2);
    };
    EXPECT_EQ(purposesOf(u"Polls"_s), (QStringList{u"poll"_s, u"poll"_s}));
    EXPECT_EQ(purposesOf(u"Commands"_s), QStringList{});
    EXPECT_EQ(purposesOf(u"Stops"_s), (QStringList{u"stop"_s}));
    EXPECT_EQ(purposesOf(u"Connecting and link"_s), (QStringList{u"connecting"_s}));
    EXPECT_EQ(purposesOf(u"Errors only"_s), (QStringList{u"stop"_s}));
    window->monitor().showPackets({pollRecord(5)});
    EXPECT_EQ(rows(), 1) << "what comes later is filtered, too";
    EXPECT_EQ(purposesOf(u"All kinds"_s).size(), 5);
}

TEST_F(Monitor, OffersTheModulesUnderTheirPresentNames) {
    showServos({{}, {}});
    open();
    EXPECT_EQ(box(u"packetModuleBox"_s)->itemText(2), u"Module 2"_s);
    machine.axes.resize(2);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    EXPECT_EQ(box(u"packetModuleBox"_s)->itemText(2), u"Module 2 \"Z axis\""_s);
}

TEST_F(Monitor, FollowsTheNewestUntilTheUserScrollsUp) {
    open();
    showPolls(500);
    QScrollBar* bar = table()->verticalScrollBar();
    ASSERT_GT(bar->maximum(), 0);
    EXPECT_EQ(bar->value(), bar->maximum());
    bar->setValue(100);
    showPolls(500, 501);
    EXPECT_EQ(bar->value(), 100);
    bar->setValue(bar->maximum());
    showPolls(500, 1'001);
    EXPECT_EQ(bar->value(), bar->maximum());
}

TEST_F(Monitor, KeepsTwentyThousandAndSaysWhatIsGone) {
    open();
    showPolls(20'000);
    table()->verticalScrollBar()->setValue(5'000);
    showPolls(1'500, 20'001);
    EXPECT_EQ(rows(), 20'000);
    EXPECT_EQ(table()->verticalScrollBar()->value(), 3'500) << "what is being read stays where it is";
    EXPECT_EQ(text(u"packetSummary"_s), u"20\u202F000 of 20\u202F000 shown, 1\u202F500 older dropped"_s);
}

TEST_F(Monitor, SaysWhereSomethingWasNotRecorded) {
    open();
    showPolls(1);
    click(u"packetPause"_s);
    click(u"packetPause"_s);
    showPolls(1, 2);
    EXPECT_EQ(column(0), (QStringList{u"0.000000"_s, u"⋯ 0.000000"_s}));
}

TEST_F(Monitor, CopiesTheSelectedRows) {
    open();
    showFour();
    table()->selectRow(1);
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text(),
              u"2.000000 s  module 1  115200 Bd  > AA 01 13 05 19  (Read Status: position, velocity)  "
              "< 09 D2 04 00 00 FE FF DC  (position 1234, velocity 2, move_done power_on)  accepted"_s);
    table()->clearSelection();
    click(u"packetCopy"_s);
    EXPECT_EQ(QGuiApplication::clipboard()->text().count(u'\n'), 3);
}

TEST_F(Monitor, ClearsAndBeginsAnewWithEachConnection) {
    open();
    showFour();
    click(u"packetClear"_s);
    EXPECT_EQ(rows(), 0);
    showFour();
    window->monitor().begin(session(false));
    EXPECT_EQ(rows(), 0);
}

TEST_F(Monitor, SavesATextForPeople) {
    open();
    showFour();
    const QStringList lines = QString::fromUtf8(saved(u"packets.txt"_s)).split(u'\n');
    ASSERT_EQ(lines.size(), 8);
    EXPECT_EQ(lines.at(0), u"SIMULATED SESSION: no hardware was connected."_s);
    EXPECT_EQ(lines.at(1),
              u"Packets of NMC Panel 0.3.0 on Simulator, seconds since 2025-06-01T12:00:00.000Z"_s);
    EXPECT_EQ(lines.at(3),
              u"0.000100 s  group FF  19200 Bd  > AA FF 0F 0E  (Hard Reset)  no answer expected"_s);
    EXPECT_TRUE(lines.at(6).endsWith(u"  no answer"_s));
}

TEST_F(Monitor, SavesALogThatCanBeReplayed) {
    window->monitor().begin(session(false));
    open();
    box(u"packetKindBox"_s)->setCurrentIndex(1);
    window->monitor().showPackets({resetRecord(1, 100), pollRecord(2, 2'000'000)});
    EXPECT_EQ(saved(u"packets.nmclog"_s),
              "# nmcpanel packet log 1\n"
              "# program NMC Panel 0.3.0\n"
              "# started 2025-06-01T12:00:00.000Z\n"
              "# port /dev/ttyUSB0\n"
              "# simulated no\n"
              "# dropped 0\n"
              "# time_us took_us purpose module baud type:items verdict >command <reply\n"
              "#\n"
              "100.000 25000.000 connect - 19200 0:00 not_asked >AAFF0F0E <\n"
              "2000000.000 1450.000 poll 1 115200 0:05 accepted >AA01130519 <09D2040000FEFFDC\n");
}

TEST_F(Monitor, AsksForAFileWithoutBlockingTheWindow) {
    open();
    click(u"packetSave"_s);
    auto* dialog = find<QFileDialog>(u"packetSaveDialog"_s);
    EXPECT_FALSE(dialog->isModal());
    EXPECT_TRUE(dialog->testOption(QFileDialog::DontUseNativeDialog));
    click(u"packetSave"_s);
    EXPECT_EQ(window->findChildren<QFileDialog*>().size(), 1);
}

TEST_F(Monitor, ShowsTheCountersAndWhatTheyCount) {
    LinkFigures figures;
    figures.counters.exchanges = 12'345;
    figures.counters.answered = 12'000;
    figures.counters.timeouts = 3;
    figures.counters.rejected = 2;
    figures.counters.rejections[static_cast<std::size_t>(bus::Rejection::HomeChanged)] = 2;
    figures.counters.roundTripSum = std::chrono::seconds(24);
    figures.counters.roundTripMax = std::chrono::microseconds(12'300);
    window->showFigures(figures);
    open();
    const QAbstractItemModel* counters = find<QTableView>(u"counterTable"_s)->model();
    ASSERT_EQ(counters->rowCount(), 12 + 17);
    QMap<QString, QString> values;
    for (int row = 0; row < counters->rowCount(); ++row)
        values[counters->index(row, 1).data().toString()] = counters->index(row, 0).data().toString();
    EXPECT_EQ(values.value(u"sent: commands that asked for an answer"_s), u"12\u202F345"_s);
    EXPECT_EQ(values.value(u"timeouts: no answer, or too few bytes"_s), u"3"_s);
    EXPECT_EQ(values.value(u"  of these: home register changed without a command"_s), u"2"_s);
    EXPECT_EQ(values.value(u"mean round trip, from sending a command to its complete answer"_s), u"2 ms"_s);
    EXPECT_EQ(values.value(u"longest round trip"_s), u"12.3 ms"_s);
}

TEST_F(Monitor, IsWorkedByKeyboard) {
    showServos({{}, {}});
    open();
    QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
    EXPECT_TRUE(box(u"packetModuleBox"_s)->hasFocus());
    QTest::keyClick(window.get(), Qt::Key_T, Qt::ControlModifier);
    EXPECT_TRUE(box(u"packetKindBox"_s)->hasFocus());
    for (const bool paused : {true, false}) {
        QTest::keyClick(window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        EXPECT_TRUE(eventually([&] { return recording() != paused; }));
    }
    showFour();
    QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(eventually([this] { return rows() == 0; }));
}

TEST(MonitorTexts, EachVerdictSaysWhatBecameOfTheExchange) {
    const auto verdictOf = [](ReplyResult end) {
        return texts::verdict(with(pollRecord(1), Purpose::Poll, end));
    };
    EXPECT_EQ(verdictOf(ReplyResult::Accepted), u"accepted"_s);
    EXPECT_EQ(verdictOf(ReplyResult::Refused), u"module refused: checksum"_s);
    EXPECT_EQ(verdictOf(ReplyResult::Unresponsive), u"no answer"_s);
    EXPECT_EQ(verdictOf(ReplyResult::Partial), u"too few bytes"_s);
    EXPECT_EQ(verdictOf(ReplyResult::BadChecksum), u"wrong checksum"_s);
    EXPECT_EQ(verdictOf(ReplyResult::Abandoned), u"cancelled by a stop"_s);
    EXPECT_EQ(texts::verdict(resetRecord(1)), u"no answer expected"_s);
    auto rejected = with(pollRecord(1), Purpose::Poll, ReplyResult::Rejected);
    rejected.rejection = bus::Rejection::HomeChanged;
    EXPECT_EQ(texts::verdict(rejected), u"rejected: home register changed without a command"_s);
    QSet<QString> sentences;
    for (std::size_t i = 0; i < bus::kRejections; ++i)
        sentences.insert(texts::rejection(static_cast<bus::Rejection>(i)));
    EXPECT_EQ(sentences.size(), 17);
    EXPECT_FALSE(sentences.contains(QString()));
}

}  // namespace
}  // namespace nmc

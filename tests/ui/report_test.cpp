// SPDX-License-Identifier: GPL-3.0-or-later
// What a report of a problem contains, and that it is only written to a file.
#include "bus/exchangerecord.h"
#include "widgets/help/problemreport.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/monitor/monitordock.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Report : public WindowTest {
protected:
    QString open() {
        window->findChild<QAction*>(u"reportProblemAction"_s)->trigger();
        return find<QPlainTextEdit>(u"reportTextField"_s)->toPlainText();
    }
    /// The lines of the part with this title.
    static QStringList part(const QString& report, const QString& title) {
        return report.section(u"== %1 ==\n"_s.arg(title), 1)
            .section(u"\n\n=="_s, 0, 0)
            .trimmed()
            .split(u'\n');
    }
};

TEST_F(Report, DoesNotSayOfModulesThatNobodyAsksThatTheyDoNotAnswer) {
    LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
    link.phase = LinkPhase::Lost;
    link.quiet = true;
    link.modules[0].restarted();
    link.modules[0].silent = true;
    window->showLink(link);
    const QStringList chain = part(open(), u"Chain"_s);
    ASSERT_EQ(chain.size(), 2);
    EXPECT_TRUE(chain[0].contains(u"does not answer, has restarted"_s)) << chain[0].toStdString();
    EXPECT_TRUE(chain[1].contains(u"not asked"_s)) << chain[1].toStdString();
    EXPECT_FALSE(chain[1].contains(u"does not answer"_s)) << chain[1].toStdString();
}

TEST_F(Report, SaysWhatIsThere) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, u"FT232R USB UART"_s, u"A10K"_s, 0x0403, 0x6001}});
    Servo lost{.index = 1, .position = -77, .gains = false};
    ModuleState silent = lost.state();
    silent.silent = true;
    window->showLink(connectedTo({Servo{.position = 1'234}.state(), silent}));
    window->showMessage(texts::unaddressed());
    settings.setValue(u"connection/baud"_s, 115200);
    const QString report = open();

    EXPECT_TRUE(part(report, u"Program and system"_s)[0].contains(QLatin1StringView(qVersion())));
    EXPECT_EQ(part(report, u"Port and adapter"_s)[0], u"Port /dev/ttyUSB0: FT232R USB UART, USB 0403:6001"_s);
    EXPECT_TRUE(part(report, u"Port and adapter"_s)[1].contains(u"/dev/ttyUSB0, 115200 Bd, connected"_s));
    const QStringList chain = part(report, u"Chain"_s);
    ASSERT_EQ(chain.size(), 2);
    // Its status byte: move done, power; 0x09.
    EXPECT_EQ(chain[0],
              u"Module 1: PIC-SERVO, version 4, address 1, status 09, position 1234, Kp 100, Kd "
              "1000, Ki 0, IL 0, OL 255, CL 0, EL 4000, SR 1, DB 0"_s);
    EXPECT_EQ(chain[1],
              u"Module 2: PIC-SERVO, version 4, address 2, status 09, position -77, does not "
              "answer, gains unknown"_s);
    EXPECT_TRUE(part(report, u"Messages"_s)[0].contains(texts::unaddressed().headline));
    EXPECT_TRUE(part(report, u"Settings"_s).contains(u"connection/baud = 115200"_s));
    EXPECT_TRUE(part(report, u"Packets"_s)[0].startsWith(u"None were recorded"_s));
}

TEST_F(Report, HasTheLastPacketsOfTheMonitor) {
    find(u"monitorDock"_s)->show();
    find(u"monitorDock"_s)->raise();
    QApplication::processEvents();
    window->monitor().begin(PacketSession{});
    std::vector<bus::ExchangeRecord> records;
    constexpr int kMade = 510;
    for (int i = 0; i < kMade; ++i) {
        bus::ExchangeRecord record;
        record.number = static_cast<std::uint64_t>(i) + 1;
        record.sent = record.ended = TimePoint(std::chrono::seconds(i));
        record.command = {0xAA, 0x01, 0x0E, 0x0F};
        records.push_back(record);
    }
    window->monitor().showPackets(std::move(records));
    const QStringList packets = part(open(), u"Packets"_s);
    ASSERT_EQ(packets.size(), 500);
    EXPECT_TRUE(packets.front().trimmed().startsWith(u"10.000000"_s)) << packets.front().toStdString();
    EXPECT_TRUE(packets.back().trimmed().startsWith(u"509.000000"_s)) << packets.back().toStdString();
}

TEST_F(Report, KeepsBackPinAndHome) {
    settings.setValue(u"operator/pin"_s, u"5994471abb01112afcc1"_s);
    settings.setValue(u"operator/salt"_s, u"0badc0de"_s);
    settings.setValue(u"machine/recent"_s,
                      QStringList{QDir::homePath() + u"/mill.json"_s, u"/home/bob/x.json"_s});
    settings.setValue(u"window/geometry"_s, QByteArray("\x01\x02\x03"));
    const QString report = open();
    const QStringList lines = part(report, u"Settings"_s);
    EXPECT_TRUE(lines.contains(u"operator/pin = (left out)"_s));
    EXPECT_FALSE(report.contains(u"5994471abb"_s));
    EXPECT_FALSE(report.contains(u"0badc0de"_s));
    EXPECT_TRUE(lines.contains(u"machine/recent = ~/mill.json, ~/x.json"_s))
        << lines.join(u'\n').toStdString();
    EXPECT_TRUE(lines.contains(u"window/geometry = (3 bytes)"_s));
    EXPECT_FALSE(report.contains(QDir::homePath() + u'/'));
}

TEST(Homes, OfEverybodyAreHidden) {
    const QString home = QDir::homePath();
    EXPECT_EQ(withoutHomes(home + u"/a, "_s + home), u"~/a, ~"_s);
    EXPECT_EQ(withoutHomes(u"'/home/anna/mill.json' of /home/bob."_s), u"'~/mill.json' of ~"_s);
    EXPECT_EQ(withoutHomes(u"/dev/ttyUSB0 /srv/home"_s), u"/dev/ttyUSB0 /srv/home"_s);
}

TEST_F(Report, IsReadOnlyAndSavedWhereTheUserSays) {
    showServo();
    QSignalSpy saves(&window->requests(), &Requests::save);
    const QString report = open();
    auto* text = find<QPlainTextEdit>(u"reportTextField"_s);
    text->setFocus();
    QTest::keyClicks(text, u"x"_s);
    EXPECT_EQ(text->toPlainText(), report);
    click(u"reportSaveButton"_s);
    auto* dialog = find<QFileDialog>(u"reportSaveDialog"_s);
    dialog->selectFile(directory.filePath(u"told.txt"_s));
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save), Qt::LeftButton);
    ASSERT_EQ(saves.size(), 1);
    EXPECT_EQ(saves[0][0].toString(), directory.filePath(u"told.txt"_s));
    EXPECT_EQ(QString::fromStdString(saves[0][1].value<FileContent>()()), report);
    click(u"reportCloseButton"_s);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(window->findChild<QWidget*>(u"reportDialog"_s), nullptr);
}

}  // namespace
}  // namespace nmc

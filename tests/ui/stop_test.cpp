// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/texts.h"
#include "widgets/messages/messagelist.h"
#include "windowtest.h"

namespace nmc {
namespace {

class StopAll : public WindowTest {
protected:
    StopAll() { showServos({{}, {}, {}}); }
    QSignalSpy stops{window.get(), &MainWindow::stopAllRequested};
};

TEST_F(StopAll, ActsOnPressNotOnRelease) {
    QTest::mousePress(button(u"stopAllButton"_s), Qt::LeftButton);
    EXPECT_EQ(stops.size(), 1);
    QTest::mouseRelease(button(u"stopAllButton"_s), Qt::LeftButton);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, IsAtLeastFifteenMillimetresHigh) {
    const QWidget* stop = find(u"stopAllButton"_s);
    EXPECT_GE(stop->height() * 25.4 / stop->logicalDpiY(), 15.0);
    window->resize(window->minimumSize());
    QApplication::processEvents();
    EXPECT_GE(stop->height() * 25.4 / stop->logicalDpiY(), 15.0);
    EXPECT_TRUE(window->rect().contains(QRect(stop->mapTo(window.get(), QPoint()), stop->size())));
}

TEST_F(StopAll, StandsAloneAtTheFarRight) {
    const QWidget* stop = find(u"stopAllButton"_s);
    EXPECT_GT(stop->mapTo(window.get(), QPoint()).x() + stop->width(), window->width() * 19 / 20);
}

TEST_F(StopAll, IsBlackWithWhiteWords) {
    const QImage image = find(u"stopAllButton"_s)->grab().toImage();
    int black = 0;
    int white = 0;
    int coloured = 0;
    for (int x = 0; x < image.width(); ++x) {
        for (int y = 0; y < image.height(); ++y) {
            const QColor c = image.pixelColor(x, y);
            black += c == Qt::black ? 1 : 0;
            white += c == Qt::white ? 1 : 0;
            coloured += c.saturation() > 60 && c.value() > 60 ? 1 : 0;
        }
    }
    EXPECT_GT(black, image.width() * image.height() / 2);
    EXPECT_GT(white, 200);
    EXPECT_EQ(coloured, 0);
}

TEST_F(StopAll, IsEnabledWheneverAPortIsOpen) {
    for (LinkPhase phase : {LinkPhase::Connecting, LinkPhase::Connected, LinkPhase::Lost}) {
        LinkState link = connectedTo({Servo{}.state()});
        link.phase = phase;
        window->showLink(link);
        EXPECT_TRUE(button(u"stopAllButton"_s)->isEnabled());
    }
    window->showLink({});
    EXPECT_FALSE(button(u"stopAllButton"_s)->isEnabled());
}

TEST_F(StopAll, F41_ReachesNoModuleOfAnUnknownType) {
    std::vector<ModuleState> modules{Servo{}.state(), Servo{.index = 1}.state()};
    modules[1].info.identity = {static_cast<ModuleType>(7), 2};
    window->showLink(connectedTo(modules));
    EXPECT_TRUE(button(u"stopAllButton"_s)->toolTip().contains(u"reaches 1 of 2"_s));
    window->showStopResult({{ModuleIndex(0)}, {}, {}, {ModuleIndex(1)}, fromSeconds(0.021)});
    EXPECT_EQ(text(u"stopResultLabel"_s),
              u"1 of 2 stopped. No stop command is known for module 2: use the hardware stop."_s);
}

TEST_F(StopAll, SaysWhatItReachesAndWhatItReached) {
    std::vector<ModuleState> modules{Servo{}.state(), Servo{.index = 1}.state(), Servo{.index = 2}.state()};
    modules[2].silent = true;
    window->showLink(connectedTo(modules));
    EXPECT_TRUE(button(u"stopAllButton"_s)->toolTip().contains(u"reaches 2 of 3"_s));
    window->showStopResult({{ModuleIndex(0), ModuleIndex(1)}, {ModuleIndex(2)}, {}, {}, fromSeconds(0.021)});
    EXPECT_EQ(text(u"stopResultLabel"_s),
              u"2 of 3 stopped. Module 3 does not answer: use the hardware stop."_s);
    EXPECT_EQ(text(u"bannerHeadline"_s), text(u"stopResultLabel"_s));
}

/// This has happened: one motor held, two were off, and each Esc left another line in the list.
TEST_F(StopAll, SaysWhatHoldsAndWhatWasOffInOneEntryHoweverOftenItIsPressed) {
    showServos({{}, {.index = 1, .on = false}, {.index = 2, .on = false}});
    const auto rows = [this] { return find<MessageList>(u"messageList"_s)->shownEntries(); };
    const std::size_t before = rows().size();
    const std::vector<ModuleIndex> all{ModuleIndex(0), ModuleIndex(1), ModuleIndex(2)};
    for (const double seconds : {0.022, 0.031, 0.019})
        window->showStopResult({all, {}, {}, {}, fromSeconds(seconds), {all.begin() + 1, all.end()}});
    EXPECT_EQ(text(u"stopResultLabel"_s), u"1 stopped and holding, 2 were off, 19 ms."_s);
    ASSERT_EQ(rows().size(), before + 1);
    EXPECT_EQ(rows().front().message.headline, text(u"stopResultLabel"_s));
    EXPECT_EQ(rows().front().count, 3);
    // A stop after something has moved again is another one.
    showServos({{.moveDone = false}, {.index = 1, .on = false}, {.index = 2, .on = false}});
    showServos({{.millisecond = 40}, {.index = 1, .on = false}, {.index = 2, .on = false}});
    window->showStopResult({all, {}, {}, {}, fromSeconds(0.02), {all.begin() + 1, all.end()}});
    EXPECT_EQ(rows().size(), before + 2);
}

TEST_F(StopAll, NeverCallsItselfAnEmergencyStop) {
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        if (widget->objectName() == u"sim_step_estopBox"_s)
            continue;  // this is the name of the stepper's input
        for (QString words : {widget->accessibleName(), widget->toolTip()}) {
            words.remove(u"E-stop input"_s);
            EXPECT_FALSE(words.contains(u"emergency"_s, Qt::CaseInsensitive)) << words.toStdString();
            EXPECT_FALSE(words.contains(u"e-stop"_s, Qt::CaseInsensitive)) << words.toStdString();
        }
    }
}

TEST_F(StopAll, U10_EscWorksFromATextField) {
    field(u"kpField"_s)->setFocus();
    QTest::keyClick(field(u"kpField"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, U10_EscThroughTheWindowSystemStopsOnce) {
    field(u"kpField"_s)->setFocus();
    QTest::keyPress(window->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1) << "it acts on press";
    QTest::keyRelease(window->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
    QTest::keyClick(window->windowHandle(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 2);
}

TEST_F(StopAll, U10_EscWorksFromAList) {
    QTest::keyClick(find(u"chainList"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, U10_EscWorksFromAnOpenComboBox) {
    auto* box = find<QComboBox>(u"scopeWindowBox"_s);
    box->showPopup();
    QTest::keyClick(box->view(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, U10_EscWorksFromAModalDialog) {
    QDialog dialog(window.get());
    QLineEdit edit(&dialog);
    dialog.setModal(true);
    dialog.show();
    QTest::keyClick(&edit, Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, U10_EscWorksFromAMenu) {
    auto* menu = find<QMenu>(u"viewMenu"_s);
    menu->popup(window->mapToGlobal(QPoint(20, 20)));
    QTest::keyClick(menu, Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(StopAll, EscIgnoresAutoRepeat) {
    QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier, QString(), true);
    QApplication::sendEvent(field(u"kpField"_s), &repeat);
    EXPECT_EQ(stops.size(), 0);
}

TEST_F(StopAll, ALostReleaseDoesNotMakeTheNextEscDeaf) {
    QTest::keyPress(field(u"kpField"_s), Qt::Key_Escape);
    QApplication::processEvents();
    QTest::keyPress(field(u"kpField"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 2);
}

TEST_F(StopAll, NothingElseStartsOnEsc) {
    QSignalSpy intents(&window->requests(), &Requests::intent);
    QSignalSpy holds(&window->requests(), &Requests::hold);
    QTest::keyClick(field(u"goalField"_s), Qt::Key_Escape);
    EXPECT_EQ(intents.size() + holds.size(), 0);
}

}  // namespace
}  // namespace nmc

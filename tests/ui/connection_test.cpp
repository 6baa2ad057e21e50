// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/apitexts.h"
#include "widgets/common/texts.h"
#include "widgets/mainwindow/connectionbar.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Connection : public WindowTest {
protected:
    QComboBox* ports() { return find<QComboBox>(u"portBox"_s); }
    ModuleState movingServo() { return Servo{.moveDone = false}.state(); }
};

TEST_F(Connection, TheSimulatorIsAlwaysThereFirstStartIncluded) {
    EXPECT_GE(ports()->findData(kSimulatorPort), 0);
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, u"USB Serial Converter"_s}});
    EXPECT_GE(ports()->findData(kSimulatorPort), 0);
    EXPECT_EQ(ports()->itemText(0), u"/dev/ttyUSB0  (USB Serial Converter)"_s);
}

TEST_F(Connection, ConnectsToTheChosenPortAndRate) {
    QSignalSpy connects(window.get(), &MainWindow::connectRequested);
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}});
    window->connectionBar().choosePort(u"/dev/pts/7"_s, 57600);
    click(u"connectButton"_s);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.at(0).at(0).toString(), u"/dev/pts/7"_s);
    EXPECT_EQ(connects.at(0).at(1).toUInt(), 57600U);
}

TEST_F(Connection, APortCanBeTypedWhilePortsComeAndGo) {
    QSignalSpy connects(window.get(), &MainWindow::connectRequested);
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, u"USB Serial Converter"_s}});
    auto* field = find<QLineEdit>(u"portField"_s);
    field->selectAll();
    QTest::keyClicks(ports(), u"/dev/serial/by-id/"_s);
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}, {u"/dev/ttyUSB1"_s, {}}});
    QTest::keyClicks(ports(), u"usb-A1 "_s);
    EXPECT_EQ(field->text(), u"/dev/serial/by-id/usb-A1 "_s);
    QTest::keyClick(ports(), Qt::Key_Return);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.at(0).at(0).toString(), u"/dev/serial/by-id/usb-A1"_s);
    // A port of the list is still called by its name.
    field->selectAll();
    QTest::keyClicks(ports(), u"Simulator"_s);
    click(u"connectButton"_s);
    ASSERT_EQ(connects.size(), 2);
    EXPECT_EQ(connects.at(1).at(0).toString(), kSimulatorPort);
}

TEST_F(Connection, WithoutAPortTheListOpensInstead) {
    QSignalSpy connects(window.get(), &MainWindow::connectRequested);
    auto* field = find<QLineEdit>(u"portField"_s);
    field->selectAll();
    QTest::keyClick(ports(), Qt::Key_Delete);
    QTest::keyClick(ports(), Qt::Key_Return);
    EXPECT_EQ(connects.size(), 0);
    EXPECT_TRUE(ports()->view()->isVisible());
    ports()->hidePopup();
}

TEST_F(Connection, AChosenSimulatorChainSaysWhatItIs) {
    window->connectionBar().choosePort(u"simulator=servo,servo@1"_s, 115200);
    EXPECT_EQ(ports()->currentData().toString(), u"simulator=servo,servo@1"_s);
    EXPECT_EQ(ports()->currentText(), u"Simulator (servo,servo@1)"_s);
}

TEST_F(Connection, AChosenPortStaysWhenItIsUnplugged) {
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}, {u"/dev/ttyUSB1"_s, {}}});
    window->connectionBar().choosePort(u"/dev/ttyUSB1"_s, 0);
    window->connectionBar().showPorts({{u"/dev/ttyUSB0"_s, {}}});
    EXPECT_EQ(ports()->currentData().toString(), u"/dev/ttyUSB1"_s);
}

TEST_F(Connection, PortAndRateAreDescribedFromTheStart) {
    for (const QString& name : {u"portBox"_s, u"baudBox"_s}) {
        EXPECT_FALSE(find(name)->toolTip().isEmpty());
        EXPECT_EQ(find(name)->accessibleDescription(), find(name)->toolTip());
    }
}

TEST_F(Connection, OpeningTheListAsksForThePorts) {
    QSignalSpy asked(&window->connectionBar(), &ConnectionBar::portsRequested);
    ports()->showPopup();
    EXPECT_EQ(asked.size(), 1);
    ports()->hidePopup();
}

/// STOP ALL is below the bar, and would move from under the pointer.
TEST_F(Connection, NothingMovesWhenAProgramGetsControl) {
    window->resize(1'500, 900);
    window->showPrograms({.on = true, .path = u"/run/ttyUSB0.sock"_s, .connected = 1});
    const auto* ribbon = find(u"programsRibbon"_s);
    QApplication::processEvents();
    const int before = ribbon->height();
    window->showPrograms(
        {.on = true, .path = u"/run/ttyUSB0.sock"_s, .connected = 1, .inControl = u"scan.py"_s});
    QApplication::processEvents();
    EXPECT_TRUE(button(u"endProgramControlButton"_s)->isVisible());
    EXPECT_EQ(ribbon->height(), before);
}

TEST_F(Connection, ASimulatedSessionIsMarkedOnTheWholeWindow) {
    EXPECT_FALSE(find(u"simulatorRibbon"_s)->isVisible());
    LinkState link = connectedTo({Servo{}.state()});
    link.port = "simulator";
    link.simulated = true;
    window->showLink(link);
    EXPECT_TRUE(find(u"simulatorRibbon"_s)->isVisible());
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - Simulator"_s);
    window->showLink({});
    EXPECT_FALSE(find(u"simulatorRibbon"_s)->isVisible());
    EXPECT_EQ(window->windowTitle(), u"NMC Panel"_s);
}

TEST_F(Connection, StatusBarSaysStateAndFigures) {
    showServo();
    window->showFigures({.exchangesPerSecond = 482.3,
                         .wireShare = 0.957,
                         .errorsPerSecond = 0.1,
                         .errors = 3,
                         .meanRoundTripMs = 1.98});
    EXPECT_EQ(text(u"linkLabel"_s), u"Connected to /dev/ttyUSB0 at 115\u202f200 Bd, 1 module"_s);
    EXPECT_EQ(text(u"rateLabel"_s), u"482 exchanges/s, 96 % bus load"_s);
    EXPECT_EQ(text(u"errorLabel"_s), u"3 errors, 0.1/s"_s);
    EXPECT_EQ(text(u"roundTripLabel"_s), u"round trip 1.98 ms"_s);
    window->showLink({});
    EXPECT_EQ(text(u"linkLabel"_s), u"Not connected"_s);
    EXPECT_FALSE(text(u"rateLabel"_s).contains(u"482"_s)) << "these figures belong to a link that has gone";
}

TEST_F(Connection, U05_ClosingWhileAMotorMovesAsksAndStopsFirst) {
    window->showLink(connectedTo({movingServo(), Servo{.index = 1, .moveDone = false}.state()}));
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QSignalSpy confirmed(window.get(), &MainWindow::closeConfirmed);
    EXPECT_FALSE(window->close());
    EXPECT_EQ(text(u"closeText"_s), u"2 motors are moving. They will be stopped before the port closes."_s);
    click(u"stopAndCloseButton"_s);
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(confirmed.size(), 1);
    EXPECT_TRUE(window->isVisible()) << "it stays until the motors are known to have stopped";
    window->finishClose();
    EXPECT_FALSE(window->isVisible());
}

TEST_F(Connection, U05_StayStays) {
    window->showLink(connectedTo({movingServo()}));
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    window->close();
    click(u"stayButton"_s);
    EXPECT_EQ(stops.size(), 0);
    EXPECT_TRUE(window->isVisible());
}

TEST_F(Connection, U05_ClosingAtRestIsNotAsked) {
    showServo();
    EXPECT_TRUE(window->close());
}

TEST_F(Connection, U06_DisconnectingWhileAMotorMovesStopsFirst) {
    window->showLink(connectedTo({movingServo()}));
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 0);
    click(u"stopAndCloseButton"_s);
    EXPECT_EQ(stops.size(), 1);
    window->showStopResult({{ModuleIndex(0)}, {}, {}, {}, fromSeconds(0.01)});
    EXPECT_EQ(disconnects.size(), 1);
}

TEST_F(Connection, LayoutIsKeptAndCanBeReset) {
    find<QDockWidget>(u"messagesDock"_s)->hide();
    window->close();
    MainWindow next(settings);
    next.show();
    EXPECT_FALSE(next.findChild<QDockWidget*>(u"messagesDock"_s)->isVisible());
    next.findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
    EXPECT_TRUE(next.findChild<QDockWidget*>(u"messagesDock"_s)->isVisible());
}

TEST_F(Connection, FirstStartSaysWhatToFitAndTakesNoForAnAnswerOnce) {
    settings.remove(u"safety/understood"_s);
    MainWindow first(settings);
    first.show();
    EXPECT_EQ(first.findChild<QLabel*>(u"bannerHeadline"_s)->text(), texts::safety().headline);
    QTest::mouseClick(first.findChild<QAbstractButton*>(u"bannerAction_understood"_s), Qt::LeftButton);
    EXPECT_FALSE(first.findChild<QWidget*>(u"banner"_s)->isVisible());
    MainWindow second(settings);
    second.show();
    EXPECT_FALSE(second.findChild<QWidget*>(u"banner"_s)->isVisible());
}

}  // namespace
}  // namespace nmc

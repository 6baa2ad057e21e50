// SPDX-License-Identifier: GPL-3.0-or-later
// faults.md H-02: a connection that only looks, as the window shows it.
#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QMenu>
#include <QTabWidget>

#include "widgets/chain/chainmenu.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"
#include "windowtest.h"

namespace nmc {
namespace {

class H02_ReadOnlyWindow : public WindowTest {
protected:
    void look(std::vector<ModuleState> modules) {
        for (ModuleState& module : modules)
            module.readOnly = true;
        LinkState link = connectedTo(std::move(modules));
        link.readOnly = true;
        window->showLink(link);
        QApplication::processEvents();
    }
    void trigger(const char* action) { window->findChild<QAction*>(QLatin1StringView(action))->trigger(); }
    void expectRefused(const QString& name) {
        EXPECT_FALSE(button(name)->isEnabled()) << name.toStdString();
        EXPECT_TRUE(button(name)->toolTip().contains(u"read-only"_s))
            << name.toStdString() << ": " << button(name)->toolTip().toStdString();
    }
};

TEST_F(H02_ReadOnlyWindow, IsAskedForBesideConnectAndInTheMenu) {
    QSignalSpy connects(window.get(), &MainWindow::connectRequested);
    window->choosePort(u"/dev/pts/7"_s, 57'600);
    click(u"moreWaysButton"_s);
    auto* menu = find<QMenu>(u"moreWaysMenu"_s);
    ASSERT_TRUE(menu->isVisible());
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Return);
    ASSERT_EQ(connects.size(), 1);
    EXPECT_EQ(connects.at(0), (QList<QVariant>{u"/dev/pts/7"_s, 57'600U, true}));
    click(u"connectButton"_s);
    ASSERT_EQ(connects.size(), 2);
    EXPECT_FALSE(connects.at(1).at(2).toBool()) << "it is not remembered";
    EXPECT_TRUE(find<QMenu>(u"chainMenu"_s)
                    ->actions()
                    .contains(window->findChild<QAction*>(u"connectReadOnlyAction"_s)));
}

TEST_F(H02_ReadOnlyWindow, SaysSoInItsRibbonTitleAndStatusBar) {
    EXPECT_FALSE(find(u"readOnlyRibbon"_s)->isVisible());
    look({Servo{}.state()});
    EXPECT_TRUE(find(u"readOnlyRibbon"_s)->isVisible());
    EXPECT_EQ(text(u"readOnlyRibbonText"_s),
              u"READ-ONLY — only status requests are sent. STOP ALL still works."_s);
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - /dev/ttyUSB0 (read-only)"_s);
    EXPECT_EQ(text(u"linkLabel"_s), u"Connected to /dev/ttyUSB0 at 115\u202f200 Bd, 1 module, read-only"_s);
    QSignalSpy fully(window.get(), &MainWindow::connectFullyRequested);
    click(u"connectFullyButton"_s);
    EXPECT_EQ(fully.size(), 1);
    showServo();
    EXPECT_FALSE(find(u"readOnlyRibbon"_s)->isVisible());
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - /dev/ttyUSB0"_s);
}

TEST_F(H02_ReadOnlyWindow, NoControlOfAServoSends) {
    QSignalSpy intents(window.get(), &MainWindow::intentRequested);
    look({Servo{}.state()});
    auto* pages = find<QTabWidget>(u"servoPages"_s);
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        for (auto* control : window->findChildren<QAbstractButton*>())
            if (control->isVisible() && pages->isAncestorOf(control) && !control->isCheckable())
                QTest::mouseClick(control, Qt::LeftButton);
    }
    EXPECT_EQ(intents.size(), 0);
    for (const QString& name : {u"stopSmoothlyButton"_s, u"stopAbruptlyButton"_s, u"motorOffButton"_s})
        expectRefused(name);
}

TEST_F(H02_ReadOnlyWindow, TheChainAsAWholeIsToldNothing) {
    ModuleState member = Servo{}.state();
    member.info.group = bus::GroupPlace{0x81, false};
    member.loadWaiting = true;
    look({member});
    QSignalSpy restarts(window.get(), &MainWindow::restartNetworkRequested);
    trigger("groupsAction");
    expectRefused(u"groupStartButton"_s);
    expectRefused(u"groupHomeButton"_s);
    EXPECT_FALSE(find<QComboBox>(u"group1Box"_s)->isEnabled());
    trigger("rateAction");
    auto* rate = find<QComboBox>(u"chainRateBox"_s);
    rate->setCurrentIndex(rate->findData(57'600));
    expectRefused(u"changeRateButton"_s);
    trigger("chainDoctorAction");
    expectRefused(u"restartChainButton"_s);
    EXPECT_TRUE(button(u"scanButton"_s)->isEnabled()) << "that only asks";
    EXPECT_FALSE(window->findChild<QAction*>(u"restartNetworkAction"_s)->isEnabled());
    EXPECT_EQ(restarts.size(), 0);
}

TEST_F(H02_ReadOnlyWindow, AMessageOffersNothingThatWouldBeSent) {
    showServos({{}, {}});
    window->showMessage(texts::restarted({ModuleIndex(0)}, 2));
    look({Servo{}.state(), Servo{.index = 1}.state()});
    EXPECT_EQ(window->findChild<QAbstractButton*>(u"bannerAction_readdress"_s), nullptr);
    EXPECT_EQ(window->findChild<QAbstractButton*>(u"listAction_readdress"_s), nullptr);
    window->showMessage(texts::restarted({ModuleIndex(1)}, 2));
    EXPECT_TRUE(window->findChild<MessageList*>()->rows().front()->message().actions.isEmpty());
}

TEST_F(H02_ReadOnlyWindow, LeavingAsksNothingAndStopsNothing) {
    look({Servo{.moveDone = false}.state()});
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QSignalSpy disconnects(window.get(), &MainWindow::disconnectRequested);
    click(u"disconnectButton"_s);
    EXPECT_EQ(disconnects.size(), 1);
    EXPECT_TRUE(window->close());
    EXPECT_EQ(stops.size(), 0);
}

TEST_F(H02_ReadOnlyWindow, StopAllAndEscActAsEver) {
    look({Servo{.moveDone = false}.state()});
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QTest::mousePress(button(u"stopAllButton"_s), Qt::LeftButton);
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 2);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chainmodel.h"
#include "windowtest.h"

namespace nmc {
namespace {

class ChainList : public WindowTest {
protected:
    QAbstractItemView* list() { return find<QAbstractItemView>(u"chainList"_s); }
    QVariant at(int row, int role) { return list()->model()->index(row, 0).data(role); }
};

TEST_F(ChainList, IsInWireOrderWithThePcAtItsEnd) {
    showServos({{.position = 12345}, {.version = 2}, {}});
    ASSERT_EQ(list()->model()->rowCount(), 4);
    EXPECT_EQ(at(0, ChainModel::Name).toString(), u"Module 1"_s);
    EXPECT_EQ(at(0, ChainModel::Address).toInt(), 1);
    EXPECT_EQ(at(0, ChainModel::Position).toString(), u"12\u202f345"_s);
    EXPECT_EQ(at(1, ChainModel::TypeText).toString(), u"PIC-SERVO v2"_s);
    EXPECT_EQ(at(2, ChainModel::ActivityText).toString(), u"Holding"_s);
    EXPECT_TRUE(at(3, ChainModel::IsHost).toBool());
    EXPECT_EQ(at(3, Qt::DisplayRole).toString(), u"PC"_s);
}

TEST_F(ChainList, ReadsOutARowInOneSentence) {
    showServo({.position = 7});
    EXPECT_EQ(at(0, Qt::AccessibleTextRole).toString(),
              u"Module 1, address 1, PIC-SERVO v4, Holding, position 7 counts. Home: unknown"_s);
}

/// A PIC-I/O has no motor.
TEST_F(ChainList, ReadsOutOfAPicIoNothingOfAMotor) {
    ModuleState module = Servo{}.state();
    module.info.identity = {ModuleType::Io, 1};
    window->showLink(connectedTo({module}));
    EXPECT_TRUE(at(0, Qt::AccessibleTextRole).toString().startsWith(u"Module 1, address 1, PIC-I/O v1, "_s));
    EXPECT_EQ(at(0, ChainModel::Position).toString(), QString());
    for (const int role : {int(Qt::AccessibleTextRole), int(Qt::ToolTipRole)})
        for (const QString& word : {u"position"_s, u"steps"_s, u"ome"_s, u"–"_s})
            EXPECT_FALSE(at(0, role).toString().contains(word)) << at(0, role).toString().toStdString();
}

/// A position that is struck out on the screen is read out with its age.
TEST_F(ChainList, ReadsOutHowOldAPositionIs) {
    const ModuleState module = Servo{.position = 7}.state();
    LinkState link = connectedTo({module});
    link.phase = LinkPhase::Lost;
    window->showLink(link);
    window->showTime(module.latestTime + std::chrono::milliseconds(3'040));
    EXPECT_EQ(at(0, Qt::AccessibleTextRole).toString(),
              u"Module 1, address 1, PIC-SERVO v4, No answer, position 7 counts, 3 s old. Home: unknown"_s);
    EXPECT_EQ(find(u"positionLabel"_s)->accessibleName(), u"Position 7 counts, 3 s old"_s);
    window->showTime(module.latestTime + std::chrono::milliseconds(4'140));
    EXPECT_TRUE(at(0, Qt::AccessibleTextRole).toString().contains(u"position 7 counts, 4.1 s old"_s));
}

TEST_F(ChainList, TheFirstModuleIsSelectedUntilTheUserSelectsAnother) {
    EXPECT_EQ(window->selectedModule(), std::nullopt);
    showServos({{}, {.position = 99}});
    EXPECT_EQ(window->selectedModule(), ModuleIndex(0));
    list()->setFocus();
    QTest::keyClick(list(), Qt::Key_Down);
    EXPECT_EQ(window->selectedModule(), ModuleIndex(1));
    EXPECT_EQ(text(u"positionLabel"_s), u"99"_s);
}

TEST_F(ChainList, AnotherChainHasTheModuleAtTheSamePlaceSelected) {
    showServos({{}, {}, {}});
    list()->setCurrentIndex(list()->model()->index(2, 0));
    window->showLink({});
    EXPECT_EQ(window->selectedModule(), std::nullopt);
    showServos({{}, {}});
    EXPECT_EQ(window->selectedModule(), ModuleIndex(1)) << "the last one";
    EXPECT_EQ(list()->currentIndex().row(), 1);
    showServos({{}, {}, {}, {}});
    EXPECT_EQ(window->selectedModule(), ModuleIndex(2));
    EXPECT_EQ(list()->currentIndex().row(), 2);
}

TEST_F(ChainList, ThePcCannotBeSelected) {
    showServo();
    list()->setFocus();
    QTest::keyClick(list(), Qt::Key_Down);
    EXPECT_EQ(window->selectedModule(), ModuleIndex(0));
}

TEST_F(ChainList, ALostLinkStrikesOutEverythingAtOnce) {
    for (const LinkPhase phase : {LinkPhase::Lost, LinkPhase::Connecting}) {
        LinkState link = connectedTo({Servo{.position = 2995}.state(), Servo{.index = 1}.state()});
        window->showLink(link);
        EXPECT_FALSE(at(0, ChainModel::PositionIsOld).toBool());
        link.phase = phase;
        window->showLink(link);
        for (int row : {0, 1}) {
            EXPECT_TRUE(at(row, ChainModel::PositionIsOld).toBool());
            EXPECT_EQ(at(row, ChainModel::ActivityText).toString(), u"No answer"_s);
        }
        EXPECT_EQ(text(u"stateLabel"_s), u"No answer"_s);
        EXPECT_TRUE(find<QLabel>(u"positionLabel"_s)->font().strikeOut());
        EXPECT_EQ(find(u"stopAllButton"_s)->toolTip().contains(u"reaches 2 of 2"_s), false);
    }
}

/// This has happened: modules that were stopped, and that nobody asked any more, seemed not to answer.
TEST_F(ChainList, ModulesThatAreNotAskedAnyMoreAreNotSaidNotToAnswer) {
    LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state(), Servo{.index = 2}.state()});
    link.phase = LinkPhase::Lost;
    link.quiet = true;
    link.modules[0].restarted();
    link.modules[0].silent = true;
    link.modules[2].silent = true;
    window->showLink(link);
    EXPECT_EQ(at(0, ChainModel::ActivityText).toString(), u"Restarted"_s);
    EXPECT_EQ(at(1, ChainModel::ActivityText).toString(), u"Not asked"_s);
    EXPECT_EQ(at(2, ChainModel::ActivityText).toString(), u"No answer"_s) << "it did not before either";
    EXPECT_EQ(text(u"linkLabel"_s), u"Sending to /dev/ttyUSB0 has stopped: module 1 restarted"_s);
    link.quiet = false;
    window->showLink(link);
    EXPECT_EQ(at(1, ChainModel::ActivityText).toString(), u"No answer"_s);
    EXPECT_EQ(text(u"linkLabel"_s), u"Connection to /dev/ttyUSB0 lost, motor state unknown"_s);
}

/// Scan again only queries: motors that turn keep turning, and can be stopped.
TEST_F(ChainList, LookingAgainIsNoFaultOfTheChain) {
    QSignalSpy intents(&window->requests(), &Requests::intent);
    LinkState link =
        connectedTo({Servo{.moveDone = false, .position = 2995}.state(), Servo{.index = 1}.state()});
    window->showLink(link);
    const QString moving = text(u"stateLabel"_s);
    ASSERT_FALSE(moving.isEmpty());
    link.phase = LinkPhase::Connecting;
    link.looking = true;
    window->showLink(link);
    window->showTime(link.modules[0].latestTime + std::chrono::milliseconds(1'300));
    for (int row : {0, 1}) {
        EXPECT_TRUE(at(row, ChainModel::PositionIsOld).toBool());
        const QString words = at(row, ChainModel::ActivityText).toString();
        EXPECT_TRUE(words.contains(u"looking for modules…"_s)) << words.toStdString();
        EXPECT_FALSE(words.contains(u"No answer"_s));
        EXPECT_NE(at(row, ChainModel::ActivityValue).toInt(), static_cast<int>(Activity::Unresponsive));
    }
    EXPECT_EQ(text(u"stateLabel"_s), moving) << "the last known state";
    EXPECT_TRUE(text(u"stateMeaning"_s).startsWith(u"Looking for modules…"_s));
    EXPECT_EQ(text(u"positionUnit"_s), u"counts, 1.3 s old"_s);
    for (const QString& stop :
         {u"stopSmoothlyButton"_s, u"stopAbruptlyButton"_s, u"stopHereButton"_s, u"motorOffButton"_s}) {
        const qsizetype before = intents.size();
        click(stop);
        EXPECT_EQ(intents.size(), before + 1) << stop.toStdString();
    }
    for (const QString& other : {u"goButton"_s, u"enableButton"_s, u"runForwardButton"_s})
        EXPECT_FALSE(button(other)->isEnabled()) << other.toStdString();
    EXPECT_TRUE(button(u"goButton"_s)->toolTip().startsWith(u"Looking for modules…"_s));
}

TEST_F(ChainList, AModuleThatWasNotHeardForLongIsStruckOutInTheListAsInItsHead) {
    showServos({{.millisecond = 0}, {.millisecond = 900}});
    window->showHistory(History(2), TimePoint(std::chrono::milliseconds(1'950)));
    EXPECT_TRUE(at(0, ChainModel::PositionIsOld).toBool());
    EXPECT_TRUE(find<QLabel>(u"positionLabel"_s)->font().strikeOut());
    EXPECT_FALSE(at(1, ChainModel::PositionIsOld).toBool());
}

TEST_F(ChainList, KeepsTheSelectionWhileValuesChange) {
    showServos({{}, {}});
    list()->setCurrentIndex(list()->model()->index(1, 0));
    showServos({{.position = 1}, {.position = 2}});
    EXPECT_EQ(window->selectedModule(), ModuleIndex(1));
}

TEST_F(ChainList, F41_AnUnknownTypeHasAReadOnlyPanel) {
    showServo();
    ModuleState module = Servo{}.state();
    module.info.identity = {static_cast<ModuleType>(7), 2};
    window->showLink(connectedTo({module}));
    EXPECT_TRUE(find(u"genericPanel"_s)->isVisible());
    EXPECT_EQ(window->findChild<QWidget*>(u"servoPanel"_s), nullptr);
    EXPECT_TRUE(text(u"genericName"_s).contains(u"type 7 v2"_s));
}

TEST_F(ChainList, WithoutAChainTheMiddleSaysWhatToDo) {
    EXPECT_TRUE(find(u"startPage"_s)->isVisible());
    LinkState lost;
    lost.phase = LinkPhase::Lost;
    window->showLink(lost);
    EXPECT_EQ(text(u"emptyPanel"_s), u"No module"_s);
    EXPECT_TRUE(find(u"emptyPanel"_s)->isVisible());
    showServo();
    EXPECT_FALSE(find(u"emptyPanel"_s)->isVisible());
}

TEST_F(ChainList, SaysInTheToolTipWhatItHasNoRoomFor) {
    machine.axes.resize(1);
    machine.axes[0].name = "A name that is longer than the list is wide";
    window->showMachine(machine);
    showServo({.version = 2});
    const QString tip = at(0, Qt::ToolTipRole).toString();
    for (const int role : {int(ChainModel::Title), int(ChainModel::TypeText), int(ChainModel::ActivityText)})
        EXPECT_TRUE(tip.contains(at(0, role).toString())) << tip.toStdString();
    EXPECT_EQ(at(1, Qt::ToolTipRole), at(1, ChainModel::TypeText)) << "the port is its tool tip";
}

}  // namespace
}  // namespace nmc

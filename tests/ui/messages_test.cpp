// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/apitexts.h"
#include "widgets/messages/banner.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Messages : public WindowTest {
protected:
    MessageList* list() { return find<MessageList>(u"messageList"_s); }
    /// Two servos in the connection with this number.
    LinkState connection(std::uint32_t number, LinkPhase phase = LinkPhase::Connected) {
        LinkState link = connectedTo({Servo{}.state(), Servo{.index = 1}.state()});
        link.connection = number;
        link.phase = phase;
        if (phase == LinkPhase::Disconnected)
            link.modules.clear();
        return link;
    }
    [[nodiscard]] bool offers(const QString& action) {
        return window->findChild<QWidget*>(u"bannerAction_"_s + action) != nullptr ||
               window->findChild<QWidget*>(u"listAction_"_s + action) != nullptr;
    }
    void tripTheSecond() {
        window->showLink(connection(1));
        window->showMessage(texts::withRecord(texts::tripped(ModuleIndex(1), 400)));
    }
    /// Keys of the visible rows, newest first.
    [[nodiscard]] QStringList shownKeys() {
        QStringList keys;
        for (const MessageRow* row : list()->rows())
            if (row->isVisibleTo(list()))
                keys << row->message().key;
        return keys;
    }
    /// Selects the entry that is this many below the first.
    void choose(const QString& box, int downs) {
        auto* combo = find<QComboBox>(box);
        combo->setFocus();
        QTest::keyClick(combo, Qt::Key_Home);
        for (int i = 0; i < downs; ++i)
            QTest::keyClick(combo, Qt::Key_Down);
    }
    void tellThree() {
        window->showLink(connection(1));
        window->showMessage(texts::amplifierWentOff(ModuleIndex(0), Activity::Overheated));
        window->showMessage(texts::amplifierWentOff(ModuleIndex(1), Activity::EstopActive));
        window->showMessage(texts::rateChanged({115'200}));
    }
    QSignalSpy actions{window.get(), &MainWindow::messageAction};
};

/// This has happened: a busy computer left a line in the list at each of its hiccups.
TEST_F(Messages, ShortFreezesAreCountedInOneRow) {
    for (const double seconds : {1.1, 1.4, 1.2})
        window->showMessage(texts::panelFroze(seconds, false));
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_EQ(list()->rows().at(0)->count(), 3);
    window->showMessage(texts::panelFroze(3, true));
    ASSERT_EQ(list()->rows().size(), 2) << "motors were stopped this time";
    EXPECT_EQ(list()->rows().at(0)->count(), 1);
}

TEST_F(Messages, OneRowForOneCauseAndRepeatsAreCounted) {
    for (std::uint8_t attempt = 1; attempt <= 3; ++attempt)
        window->showMessage(texts::refused({ModuleIndex(1), attempt}));
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_EQ(list()->rows().at(0)->count(), 3);
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageTime"_s)->text().contains(u"3 times"_s));
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageBody"_s)->text().contains(u"(3 of 3)"_s));
}

TEST_F(Messages, WhatReplacesAnotherMessageIsNoRepeatOfIt) {
    const QString path = u"/tmp/line"_s;
    for (const LineLent::State state :
         {LineLent::State::Waiting, LineLent::State::InUse, LineLent::State::Left})
        window->showMessage(texts::lineLent({state, path.toStdString()}));
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_EQ(list()->rows().at(0)->count(), 1);
    EXPECT_TRUE(list()->rows().at(0)->message().headline.contains(u"no longer lent"_s));
}

TEST_F(Messages, WhatBecomesKnownLaterIsNoRepeat) {
    Message message = texts::motionSuspect({ModuleIndex(0), bus::MotionSuspect::Reason::Overshot, 5});
    window->showMessage(message);
    message.headline += u" It has stopped."_s;
    window->amendMessage(message);
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_EQ(list()->rows().at(0)->count(), 1);
    EXPECT_EQ(list()->rows().at(0)->message().headline, message.headline);
    EXPECT_EQ(text(u"bannerHeadline"_s), message.headline);
    window->endMessage(message.key);
    window->amendMessage(message);
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
}

TEST_F(Messages, TheOldestRowLastsAsLongAsTheClickOnItsButton) {
    window->showMessage(
        {.key = u"oldest"_s, .headline = u"Oldest"_s, .actions = {{MessageAction::How, u"How"_s}}});
    for (std::size_t i = 1; i < MessageModel::kMost; ++i)
        window->showMessage({.key = u"other"_s + QString::number(i), .headline = u"Other"_s});
    const QPointer<MessageRow> oldest = list()->rows().last();
    ASSERT_EQ(oldest->message().headline, u"Oldest"_s);
    bool lasts = false;
    QObject::connect(window.get(), &MainWindow::messageAction, window.get(), [&] {
        window->showMessage({.key = u"news"_s, .headline = u"News"_s});
        lasts = oldest != nullptr;
    });
    oldest->findChild<QAbstractButton*>()->click();
    EXPECT_TRUE(lasts) << "the message is read again after what the button does";
    EXPECT_EQ(list()->rows().size(), static_cast<qsizetype>(MessageModel::kMost));
    EXPECT_EQ(list()->rows().first()->message().headline, u"News"_s);
}

TEST_F(Messages, WhatStandsIsNotDroppedForWhatIsOver) {
    window->showMessage({.key = u"fault"_s, .headline = u"No motor power"_s, .stands = true});
    // Each ends the one before.
    for (std::size_t i = 0; i <= MessageModel::kMost; ++i)
        window->showMessage({.key = u"other"_s, .headline = u"Other "_s + QString::number(i)});
    EXPECT_EQ(list()->rows().size(), static_cast<qsizetype>(MessageModel::kMost));
    EXPECT_EQ(list()->rows().last()->message().headline, u"No motor power"_s);
}

TEST_F(Messages, OneRowForAllFilesThatWereSavedAndOneForAFailure) {
    window->showMessage(texts::exported(u"/tmp/trigger 001.csv"_s));
    window->showMessage(texts::notExported({FileErrorKind::Other, u"/tmp/trigger 002.csv"_s, {}}));
    window->showMessage(texts::exported(u"/tmp/trigger 003.csv"_s));
    ASSERT_EQ(list()->rows().size(), 2);
    EXPECT_TRUE(list()->rows().at(0)->message().headline.contains(u"trigger 003.csv"_s));
    EXPECT_TRUE(list()->rows().at(1)->message().headline.contains(u"trigger 002.csv"_s));
}

TEST_F(Messages, ButtonsThatDoNotFitBesideOneAnotherMakeNoRowWider) {
    const QString words(40, u'x');
    window->showMessage({.key = u"key"_s,
                         .headline = u"Headline"_s,
                         .actions = {{MessageAction::How, words}, {MessageAction::Reconnect, words}}});
    const MessageRow* row = list()->rows().first();
    EXPECT_LT(row->minimumSizeHint().width(), 2 * row->findChild<QAbstractButton*>()->sizeHint().width());
}

TEST_F(Messages, TheOthersAndAllWordsAreOneClickAway) {
    window->findChild<QAction*>(u"messagesDockAction"_s)->trigger();
    ASSERT_FALSE(list()->isVisible());
    window->showMessage(texts::powerLost(ModuleIndex(1)));
    EXPECT_EQ(button(u"bannerAll"_s)->text(), u"Read all…"_s);
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    EXPECT_EQ(button(u"bannerAll"_s)->text(), u"1 more…"_s);
    click(u"bannerAll"_s);
    EXPECT_TRUE(list()->isVisible());
}

TEST_F(Messages, TheSameKeyWithOtherWordsIsAnotherCause) {
    const bus::OperationFinished refused{bus::OperationId(1), bus::Outcome::Refused, ModuleIndex(0), 0x17};
    bus::OperationFinished silent = refused;
    silent.outcome = bus::Outcome::NoAnswer;
    window->showMessage(texts::operationFailed(refused));
    window->showMessage(texts::operationFailed(silent));
    ASSERT_EQ(list()->rows().size(), 2);
    EXPECT_FALSE(list()->rows().at(0)->over());
    EXPECT_TRUE(list()->rows().at(1)->over());
    EXPECT_EQ(list()->rows().at(1)->message().headline, texts::operationFailed(refused).headline);
}

TEST_F(Messages, WhatIsFilteredOutIsHiddenAndComesBack) {
    tellThree();
    ASSERT_EQ(shownKeys().size(), 3);
    choose(u"messageKindBox"_s, 1);
    EXPECT_EQ(shownKeys(), QStringList{u"overheated.1"_s});
    choose(u"messageKindBox"_s, 2);
    EXPECT_EQ(shownKeys(), QStringList{u"estop.2"_s});
    choose(u"messageKindBox"_s, 0);
    choose(u"messageModuleBox"_s, 2);
    EXPECT_EQ(shownKeys(), QStringList{u"estop.2"_s});
    choose(u"messageModuleBox"_s, 0);
    QTest::keyClicks(find<QLineEdit>(u"messageTextField"_s), u"TOO HOT"_s);
    EXPECT_EQ(shownKeys(), QStringList{u"overheated.1"_s});
    QTest::keyClicks(find<QLineEdit>(u"messageTextField"_s), u" and cold"_s);
    EXPECT_TRUE(shownKeys().isEmpty());
    EXPECT_TRUE(find(u"noMessagesLabel"_s)->isVisible());
    EXPECT_TRUE(find(u"banner"_s)->isVisible())
        << "the worst message that has not ended, whatever the list shows";
    find<QLineEdit>(u"messageTextField"_s)->selectAll();
    QTest::keyClick(find<QLineEdit>(u"messageTextField"_s), Qt::Key_Delete);
    EXPECT_EQ(shownKeys().size(), 3);
}

/// This has happened: the second one read "All modul".
TEST_F(Messages, TheFiltersAreNotCutInTheSmallestWindow) {
    tellThree();
    window->resize(1'024, 700);
    QApplication::processEvents();
    for (const QString& name : {u"messageKindBox"_s, u"messageModuleBox"_s}) {
        const auto* box = find<QComboBox>(name);
        ASSERT_TRUE(box->isVisible()) << name.toStdString();
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect room =
            box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        EXPECT_GE(room.width(), box->fontMetrics().horizontalAdvance(box->itemText(0)))
            << name.toStdString() << ", width " << box->width();
    }
}

TEST_F(Messages, TheFilterHasThePresentNamesOfTheModules) {
    tellThree();
    const auto* modules = find<QComboBox>(u"messageModuleBox"_s);
    EXPECT_EQ(modules->itemText(2), u"Module 2"_s);
    choose(u"messageModuleBox"_s, 2);
    machine.axes.resize(2);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    EXPECT_EQ(modules->currentText(), u"Module 2 \"Z axis\""_s);
    window->showLink(connection(1, LinkPhase::Disconnected));
    texts::setModuleNames({});
    EXPECT_EQ(modules->count(), 3) << "their messages are still listed";
    EXPECT_EQ(shownKeys(), QStringList{u"estop.2"_s});
}

TEST_F(Messages, WhatIsOverLeavesTheListOfWhatIsNot) {
    tellThree();
    auto* box = button(u"messageNotOverBox"_s);
    QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
    window->endMessage(u"overheated.1"_s);
    EXPECT_FALSE(shownKeys().contains(u"overheated.1"_s));
    EXPECT_TRUE(shownKeys().contains(u"estop.2"_s));
}

TEST_F(Messages, TheBannersButtonShowsItWhateverTheFilterHides) {
    tellThree();
    choose(u"messageKindBox"_s, 2);
    ASSERT_FALSE(shownKeys().contains(u"overheated.1"_s));
    click(u"bannerAll"_s);
    EXPECT_TRUE(shownKeys().contains(u"overheated.1"_s));
}

TEST_F(Messages, WhatIsShownIsExportedTheOldestFirst) {
    tellThree();
    window->endMessage(u"overheated.1"_s);
    choose(u"messageModuleBox"_s, 1);
    QSignalSpy saved(&window->requests(), &Requests::save);
    click(u"messageExportButton"_s);
    auto* dialog = window->findChild<QFileDialog*>(u"messageExportDialog"_s);
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>()->setText(directory.filePath(u"out"_s));
    QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    ASSERT_EQ(saved.size(), 1);
    EXPECT_EQ(saved.at(0).at(0).toString(), directory.filePath(u"out.txt"_s));
    const QString text = QString::fromStdString(saved.at(0).at(1).value<FileContent>()());
    const QStringList lines = text.split(u'\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 1) << text.toStdString();
    EXPECT_TRUE(lines.front().contains(u"\tModule 1\tModule 1 is too hot and switched its motor off.\t"_s));
    EXPECT_TRUE(lines.front().contains(u"ended at"_s));
}

TEST_F(Messages, AnEntryOfAnotherDaySaysTheDay) {
    const QDateTime before(QDate(2026, 11, 21), QTime(23, 59, 58));
    EXPECT_EQ(timeText(before, QDate(2026, 11, 21)), u"23:59:58"_s);
    EXPECT_EQ(timeText(before, QDate(2026, 11, 22)), u"2026-11-21 23:59:58"_s);
    MessageEntry entry{texts::powerLost(ModuleIndex(0)), before};
    entry.over = before.addSecs(4);
    EXPECT_TRUE(messageLine(entry).endsWith(u"ended at 2026-11-22 00:00:02"_s));
}

TEST_F(Messages, NewestIsFirst) {
    window->showMessage(texts::garbled(ModuleIndex(0)));
    window->showMessage(texts::powerLost(ModuleIndex(1)));
    EXPECT_EQ(list()->rows().at(0)->message().key, texts::ofModule(u"power"_s, ModuleIndex(1)));
}

TEST_F(Messages, SayWhenItIsOverAndStartANewRowWhenItComesAgain) {
    window->showMessage(texts::powerLost(ModuleIndex(0)));
    window->endMessage(texts::ofModule(u"power"_s, ModuleIndex(0)));
    EXPECT_TRUE(list()->rows().at(0)->over());
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageTime"_s)->text().contains(u"ended at"_s));
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
    window->showMessage(texts::powerLost(ModuleIndex(0)));
    EXPECT_EQ(list()->rows().size(), 2);
}

TEST_F(Messages, BannerShowsTheWorstThatIsNotOver) {
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    window->showMessage(texts::powerLost(ModuleIndex(1)));
    EXPECT_EQ(text(u"bannerHeadline"_s), texts::tripped(ModuleIndex(0), 400).headline);
    window->endMessage(texts::ofModule(u"tripped"_s, ModuleIndex(0)));
    EXPECT_EQ(text(u"bannerHeadline"_s), texts::powerLost(ModuleIndex(1)).headline);
}

TEST_F(Messages, GoodNewsDoesNotRaiseABanner) {
    window->showMessage(texts::connected({std::vector<bus::ModuleInfo>(5), 115'200}, u"simulator"_s));
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
    EXPECT_EQ(list()->rows().size(), 1);
}

/// Otherwise, a click would be lost if news arrived between press and release.
TEST_F(Messages, NewsThatTheBannerDoesNotShowLeavesItsButtonsAlone) {
    window->showMessage(texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}}));
    QAbstractButton* retry = button(u"bannerAction_retry"_s);
    QTest::mousePress(retry, Qt::LeftButton);
    window->showMessage(texts::connected({std::vector<bus::ModuleInfo>(5), 115'200}, u"simulator"_s));
    EXPECT_EQ(button(u"bannerAction_retry"_s), retry);
    QTest::mouseRelease(retry, Qt::LeftButton);
    EXPECT_EQ(actions.size(), 1);
}

TEST_F(Messages, ButtonsAreVerbsAndSayWhichMessage) {
    window->showMessage(texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}}));
    click(u"bannerAction_retry"_s);
    ASSERT_EQ(actions.size(), 1);
    EXPECT_EQ(actions.at(0).at(0).value<Message>().key, texts::key::kPort);
    EXPECT_EQ(actions.at(0).at(1).value<MessageAction>(), MessageAction::Retry);
    QTest::mouseClick(list()->rows().at(0)->findChild<QAbstractButton*>(u"listAction_retry"_s),
                      Qt::LeftButton);
    EXPECT_EQ(actions.size(), 2);
}

TEST_F(Messages, AnActionMayEndItsOwnMessage) {
    QObject::connect(window.get(), &MainWindow::messageAction, window.get(),
                     [this](const Message& message) { window->endMessage(message.key); });
    window->showMessage(texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}}));
    QTest::mouseClick(list()->rows().at(0)->findChild<QAbstractButton*>(u"listAction_retry"_s),
                      Qt::LeftButton);
    EXPECT_TRUE(list()->rows().at(0)->over());
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
}

TEST_F(Messages, CopyCommandCopies) {
    window->showMessage(
        texts::portProblem({PortProblem::NoPermission, "/dev/ttyUSB0", "dialout", "anna", {}}));
    click(u"bannerAction_copyCommand"_s);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), u"sudo usermod -aG dialout anna"_s);
}

TEST_F(Messages, HidingTheBannerKeepsTheRow) {
    window->showMessage(texts::powerLost(ModuleIndex(0)));
    click(u"bannerDismiss"_s);
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
    EXPECT_FALSE(list()->rows().at(0)->over());
}

TEST_F(Messages, TextFromOutsideIsNotMarkup) {
    window->showMessage(texts::portProblem({PortProblem::InUse, "<b>x</b>", {}, {}, {}}));
    EXPECT_EQ(find<QLabel>(u"bannerHeadline"_s)->textFormat(), Qt::PlainText);
}

TEST_F(Messages, AButtonActsOnTheModuleOfItsMessageWhateverIsSelected) {
    tripTheSecond();
    ASSERT_EQ(window->selectedModule(), ModuleIndex(0));
    click(u"bannerAction_clearAndStayOff"_s);
    ASSERT_EQ(actions.size(), 1);
    EXPECT_EQ(actions.at(0).at(0).value<Message>().module, ModuleIndex(1));
    EXPECT_EQ(actions.at(0).at(1).value<MessageAction>(), MessageAction::ClearAndStayOff);
}

TEST_F(Messages, WhatCommandsIsOfferedAsLongAsItsConnectionIsThere) {
    tripTheSecond();
    EXPECT_TRUE(offers(u"clearAndStayOff"_s));
    window->showLink(connection(1, LinkPhase::Lost));
    EXPECT_TRUE(offers(u"clearAndStayOff"_s)) << "the link may come back";
    window->showLink(connection(1, LinkPhase::Connecting));
    window->showLink(connection(1));
    EXPECT_TRUE(offers(u"clearAndStayOff"_s));
    window->showLink(connection(1, LinkPhase::Disconnected));
    EXPECT_FALSE(offers(u"clearAndStayOff"_s));
    window->showLink(connection(2));
    EXPECT_FALSE(offers(u"clearAndStayOff"_s)) << "that would be another motor";
    EXPECT_TRUE(offers(u"showRecord"_s)) << "the record can still be shown";
}

TEST_F(Messages, AnotherConnectionWithoutAWordOfTheEndOfTheFirstTakesTheButtonToo) {
    tripTheSecond();
    window->showLink(connection(2, LinkPhase::Connecting));
    EXPECT_FALSE(offers(u"clearAndStayOff"_s));
}

TEST_F(Messages, AChainIsAcceptedOnlyInTheConnectionThatLacksAModule) {
    window->showLink(connection(1));
    window->showMessage(texts::fewerThanExpected(2, 3));
    EXPECT_TRUE(offers(u"workWith"_s));
    window->showLink(connection(1, LinkPhase::Disconnected));
    EXPECT_FALSE(offers(u"workWith"_s));
    EXPECT_TRUE(offers(u"scanAgain"_s)) << "it connects, and sends no command";
}

TEST_F(Messages, AChainIsLookedForUntilAnotherOneIsConnectedTo) {
    window->showLink(connection(1));
    window->showMessage(texts::linkLost(u"/dev/ttyUSB0"_s, {}));
    window->showLink(connection(1, LinkPhase::Disconnected));
    EXPECT_TRUE(offers(u"scanAgain"_s)) << "it connects to the same port";
    window->showLink(connection(2, LinkPhase::Connecting));
    EXPECT_FALSE(offers(u"scanAgain"_s)) << "that would end what runs on the other chain";
}

TEST_F(Messages, AButtonThatIsHeldWhileItsConnectionGoesDoesNothing) {
    tripTheSecond();
    QPointer<QAbstractButton> pressed = button(u"bannerAction_clearAndStayOff"_s);
    QTest::mousePress(pressed, Qt::LeftButton);
    window->showLink(connection(1, LinkPhase::Disconnected));
    window->showLink(connection(2));
    if (pressed)
        QTest::mouseRelease(pressed, Qt::LeftButton);
    EXPECT_EQ(actions.size(), 0);
}

TEST_F(Messages, AQuestionThatAMessageAskedGoesWithTheConnection) {
    QSignalSpy restarts(window.get(), &MainWindow::restartNetworkRequested);
    window->showLink(connection(1));
    window->showMessage(texts::restarted({ModuleIndex(1)}, 2));
    click(u"bannerAction_restartNetwork"_s);
    ASSERT_TRUE(find(u"restartDialog"_s)->isVisible());
    window->showLink(connection(2, LinkPhase::Connecting));
    window->showLink(connection(2));
    auto* dialog = window->findChild<QWidget*>(u"restartDialog"_s);
    EXPECT_TRUE(dialog == nullptr || !dialog->isVisible()) << "the same port may have another chain";
    EXPECT_EQ(restarts.size(), 0);
}

TEST_F(Messages, AnEventLeavesTheBannerWhenItIsOldNews) {
    find<Banner>(u"banner"_s)->setNewsLife(std::chrono::milliseconds(1));
    window->showMessage(texts::holdExpired({ModuleIndex(0)}));
    EXPECT_TRUE(find(u"banner"_s)->isVisible());
    EXPECT_TRUE(eventually([this] { return !find(u"banner"_s)->isVisible(); }));
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_FALSE(list()->rows().front()->over());
}

TEST_F(Messages, WhatIsStillTheCaseOrAsksForSomethingStaysInTheBanner) {
    find<Banner>(u"banner"_s)->setNewsLife(std::chrono::milliseconds(1));
    ModuleState tripped = Servo{}.state();
    tripped.switchedItselfOff = true;
    for (const Message& message : texts::standing(connectedTo({tripped}), TimePoint{}))
        window->showMessage(message);
    window->showMessage(texts::unsavedWorkLeft({}));
    window->showMessage(texts::holdExpired({ModuleIndex(0)}));
    ASSERT_EQ(button(u"bannerAll"_s)->text(), u"2 more…"_s);
    EXPECT_TRUE(eventually([this] { return button(u"bannerAll"_s)->text() == u"1 more…"_s; }));
    EXPECT_TRUE(text(u"bannerHeadline"_s).contains(u"switched its servo off"_s));
}

TEST_F(Messages, ARepeatIsNewsAgain) {
    auto* banner = find<Banner>(u"banner"_s);
    banner->setNewsLife(std::chrono::milliseconds(1));
    window->showMessage(texts::holdExpired({ModuleIndex(0)}));
    banner->setNewsLife(std::chrono::minutes(10));
    window->showMessage(texts::holdExpired({ModuleIndex(0)}));
    banner->setNewsLife(std::chrono::milliseconds(2));
    window->showMessage(texts::refused({ModuleIndex(1), 1}));
    EXPECT_TRUE(eventually([this] { return button(u"bannerAll"_s)->text() == u"Read all…"_s; }));
    EXPECT_EQ(text(u"bannerHeadline"_s), texts::holdExpired({ModuleIndex(0)}).headline);
}

}  // namespace
}  // namespace nmc

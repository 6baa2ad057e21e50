// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>

#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagerow.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Messages : public WindowTest {
protected:
    MessageList* list() { return find<MessageList>(u"messageList"_s); }
    QSignalSpy actions{window.get(), &MainWindow::messageAction};
};

TEST_F(Messages, OneRowForOneCauseAndRepeatsAreCounted) {
    for (std::uint8_t attempt = 1; attempt <= 3; ++attempt)
        window->showMessage(texts::refused({ModuleIndex(1), attempt}));
    ASSERT_EQ(list()->rows().size(), 1);
    EXPECT_EQ(list()->rows().at(0)->count(), 3);
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageTime"_s)->text().contains(u"3 times"_s));
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageBody"_s)->text().contains(u"(3 of 3)"_s));
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

TEST_F(Messages, NewestIsFirst) {
    window->showMessage(texts::garbled(ModuleIndex(0)));
    window->showMessage(texts::powerLost(ModuleIndex(1)));
    EXPECT_EQ(list()->rows().at(0)->message().key, texts::key::power(ModuleIndex(1)));
}

TEST_F(Messages, SayWhenItIsOverAndStartANewRowWhenItComesAgain) {
    window->showMessage(texts::powerLost(ModuleIndex(0)));
    window->endMessage(texts::key::power(ModuleIndex(0)));
    EXPECT_TRUE(list()->rows().at(0)->over());
    EXPECT_TRUE(list()->rows().at(0)->findChild<QLabel*>(u"messageTime"_s)->text().contains(u"over at"_s));
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
    window->showMessage(texts::powerLost(ModuleIndex(0)));
    EXPECT_EQ(list()->rows().size(), 2);
}

TEST_F(Messages, BannerShowsTheWorstThatIsNotOver) {
    window->showMessage(texts::tripped(ModuleIndex(0), 400));
    window->showMessage(texts::powerLost(ModuleIndex(1)));
    EXPECT_EQ(text(u"bannerHeadline"_s), texts::tripped(ModuleIndex(0), 400).headline);
    window->endMessage(texts::key::tripped(ModuleIndex(0)));
    EXPECT_EQ(text(u"bannerHeadline"_s), texts::powerLost(ModuleIndex(1)).headline);
}

TEST_F(Messages, GoodNewsDoesNotRaiseABanner) {
    window->showMessage(texts::connected({std::vector<bus::ModuleInfo>(5), 115'200}, u"simulator"_s));
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
    EXPECT_EQ(list()->rows().size(), 1);
}

TEST_F(Messages, ButtonsAreVerbsAndSayWhichMessage) {
    window->showMessage(texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}}));
    click(u"bannerAction_retry"_s);
    ASSERT_EQ(actions.size(), 1);
    EXPECT_EQ(actions.at(0).at(0).toString(), texts::key::port());
    EXPECT_EQ(actions.at(0).at(1).toString(), texts::action::kRetry);
    QTest::mouseClick(list()->rows().at(0)->findChild<QAbstractButton*>(u"listAction_retry"_s),
                      Qt::LeftButton);
    EXPECT_EQ(actions.size(), 2);
}

TEST_F(Messages, AnActionMayEndItsOwnMessage) {
    QObject::connect(window.get(), &MainWindow::messageAction, window.get(),
                     [this](const QString& key) { window->endMessage(key); });
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

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// What happened around a fault or a stop, shown in the scope of the whole program.
#include "link/clock.h"
#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"
#include "widgets/common/requests.h"
#include "widgets/messages/banner.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class Flight : public testing::Test {
protected:
    void begin() {
        ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
        ASSERT_TRUE(panel.answersFor(0.5));
    }
    ScopePanel& scope() { return *panel.window().findChild<ScopePanel*>(); }
    ScopeStrips& strips() { return *panel.window().findChild<ScopeStrips*>(); }
    /// Shows the record of the message with these words; `later`: messages with them that came after it.
    [[nodiscard]] bool clickShow(const QString& words, int later = 0) {
        for (const MessageRow* row : panel.window().findChild<MessageList*>()->rows())
            if (row->message().headline.contains(words) && later-- == 0)
                for (QAbstractButton* button : row->findChildren<QAbstractButton*>())
                    if (button->text().remove(QLatin1Char('&')) == QLatin1String("Show the last 2 s")) {
                        QTest::mouseClick(button, Qt::LeftButton);
                        return true;
                    }
        return false;
    }
    QString title() { return panel.window().findChild<QLabel*>(QStringLiteral("scopeRecordLabel"))->text(); }

    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualChain other{QStringLiteral("servo,servo")};
    VirtualPanel panel;
};

TEST_F(Flight, AStopIsShownWithWhatLedToItWhilePollingGoesOn) {
    begin();
    panel.pressStopAll();
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("stopped and holding")) > 0; }));
    ASSERT_TRUE(panel.answersFor(0.2));
    for (const QLabel* label : panel.window().findChild<Banner*>()->findChildren<QLabel*>())
        EXPECT_FALSE(label->text().contains(QLatin1String("stopped")))
            << "a stop that succeeds does not shift the panel";
    ASSERT_TRUE(clickShow(QStringLiteral("stopped and holding")));
    ASSERT_TRUE(scope().showsRecord());
    EXPECT_TRUE(title().contains(QLatin1String("Stop of all motors"))) << title().toStdString();
    EXPECT_NEAR(strips().time().width(), 2.5, 1e-6);
    EXPECT_GT(panel.count(QStringLiteral("stopped and holding")), 0) << "the message stays";
    // The record that is shown stays the same while polling goes on.
    const QString before = title();
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(title(), before);
    QTest::mouseClick(panel.window().findChild<QAbstractButton*>(QStringLiteral("scopeLiveButton")),
                      Qt::LeftButton);
    EXPECT_FALSE(scope().showsRecord());
}

TEST_F(Flight, APowerLossCanStillBeShownWhenThePortIsClosed) {
    begin();
    (void)sim.control(QStringLiteral("set 1 power 0"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("no motor power")) > 0; }));
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
    ASSERT_TRUE(clickShow(QStringLiteral("no motor power")));
    EXPECT_TRUE(scope().showsRecord());
    EXPECT_TRUE(title().contains(QLatin1String("no motor power"))) << title().toStdString();
}

/// A record reaches back by 5 s.
TEST_F(Flight, AStopLongAfterTheLastSampleHasNothingToShow) {
    begin();
    sim.tell("fault bus silent");
    const TimePoint silent = monotonicNow();
    ASSERT_TRUE(panel.waitFor([&] { return monotonicNow() > silent + std::chrono::seconds(6); }));
    panel.pressStopAll();
    const QString told = QStringLiteral("use the hardware stop");
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(told) > 0; }));
    EXPECT_FALSE(clickShow(told));
    EXPECT_FALSE(scope().showsRecord());
}

/// The list has an entry for each fault, with what led to it.
TEST_F(Flight, AnEarlierFaultIsStillShownAfterALaterOneOfItsKind) {
    begin();
    const QString told = QStringLiteral("no motor power");
    (void)sim.control(QStringLiteral("set 1 power 0"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(told) == 1; }));
    (void)sim.control(QStringLiteral("set 1 power 1"));
    ASSERT_TRUE(panel.answersFor(3));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    (void)sim.control(QStringLiteral("set 1 power 0"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(told) == 2; }));
    ASSERT_TRUE(clickShow(told));
    const double second = strips().time().left();
    ASSERT_TRUE(clickShow(told, 1));
    EXPECT_GT(second - strips().time().left(), 3);
}

TEST_F(Flight, WhatIsExportedSaysWhereItHappenedWhateverIsConnectedNow) {
    begin();
    (void)sim.control(QStringLiteral("set 1 power 0"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("no motor power")) > 0; }));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(other.terminal()));
    ASSERT_TRUE(clickShow(QStringLiteral("no motor power")));
    ASSERT_TRUE(scope().showsRecord());
    const QTemporaryDir directory;
    QSignalSpy saved(&panel.window().requests(), &Requests::save);
    panel.window().findChild<QAction*>(QStringLiteral("scopeExportCsvAction"))->trigger();
    auto* dialog = panel.window().findChild<QFileDialog*>(QStringLiteral("scopeExportcsvDialog"));
    ASSERT_NE(dialog, nullptr);
    testing_support::chooseFile(*dialog, directory.filePath(QStringLiteral("fault.csv")));
    ASSERT_TRUE(panel.waitFor([&] { return saved.count() == 1; }));
    const QString file = QString::fromStdString(saved[0][1].value<FileContent>()());
    EXPECT_TRUE(file.contains(sim.terminal())) << file.left(500).toStdString();
    EXPECT_FALSE(file.contains(other.terminal())) << file.left(500).toStdString();
}

TEST_F(Flight, SaysSoIfTooMuchHasHappenedSince) {
    begin();
    (void)sim.control(QStringLiteral("set 1 power 0"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("no motor power")) > 0; }));
    for (int stop = 0; stop < 20; ++stop) {
        panel.pressStopAll();
        ASSERT_TRUE(panel.answersFor(0.5));
    }
    ASSERT_TRUE(clickShow(QStringLiteral("no motor power")));
    EXPECT_FALSE(scope().showsRecord());
    EXPECT_EQ(panel.count(QStringLiteral("no longer kept")), 1);
}

TEST_F(Flight, TheHistoryIsStillThereAfterThePortIsClosed) {
    begin();
    const auto kept = panel.composition().store().history().module(ModuleIndex(0))->count();
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
    EXPECT_GE(panel.composition().store().history().module(ModuleIndex(0))->count(), kept);
}

}  // namespace
}  // namespace nmc

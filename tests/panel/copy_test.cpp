// SPDX-License-Identifier: GPL-3.0-or-later
// Settings copied from one axis to others, in the whole program: the differences are shown, Apply sends
// exactly those commands, and only to the chosen modules.
#include "tests/support/changes.h"
#include "tests/support/gains.h"
#include "tests/support/virtualpanel.h"
#include "widgets/machine/machinemenu.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::changes;
using testing_support::kGains;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class CopyAxis : public testing::Test {
protected:
    /// The first axis of three PIC-SERVOs and a PIC-STEP has gains, which its module was sent, and limits.
    void begin(bool readOnly = false) {
        panel.composition().show({sim.terminal(), 115'200, false, false, readOnly});
        ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && panel.module().latest; }));
        AxisSettings first;
        first.gains = kGains;
        first.travel = {-1'000, 5'000, 0.0};
        emit panel.window().requests().axisEdited(ModuleIndex(0), first);
        if (readOnly)
            return;
        panel.ask(intent::ApplyGains{kGains});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
        before = changes(sim);
    }
    template <typename Widget>
    Widget* find(const QString& name) {
        auto* widget = panel.window().findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name.toStdString();
        return widget;
    }
    QAction* action() { return find<QAction>(u"copyAxisAction"_s); }
    void click(const QString& name) {
        auto* button = find<QAbstractButton>(name);
        ASSERT_TRUE(button->isEnabled()) << name.toStdString() << ": " << button->toolTip().toStdString();
        QTest::mouseClick(button, Qt::LeftButton);
    }
    static QStringList texts(const QListWidget* list) {
        QStringList all;
        for (int row = 0; row < list->count(); ++row)
            all << list->item(row)->text();
        return all;
    }
    void tick(const QString& list, const QString& text) {
        const auto items = find<QListWidget>(list)->findItems(text, Qt::MatchExactly);
        ASSERT_EQ(items.size(), 1) << text.toStdString();
        items.first()->setCheckState(Qt::Checked);
    }
    /// Requests the gains of the first axis for the third.
    void copyGains() {
        action()->trigger();
        ASSERT_NO_FATAL_FAILURE(tick(u"copyToList"_s, u"Module 3"_s));
        ASSERT_NO_FATAL_FAILURE(tick(u"copyPartsList"_s, u"Gains"_s));
        ASSERT_NO_FATAL_FAILURE(click(u"copyShowButton"_s));
    }
    QTreeWidget* table() { return panel.window().findChild<QTreeWidget*>(u"differencesTable"_s); }
    const AxisSettings& axis(std::uint8_t index) {
        return panel.composition().machine().axis(ModuleIndex(index));
    }
    void expectNothingMoved() {
        for (const int module : {1, 2, 3}) {
            EXPECT_FALSE(sim.state(module)[u"servo_on"_s].toBool());
            EXPECT_EQ(sim.state(module)[u"position"_s].toInt(), 0);
        }
        EXPECT_EQ(sim.violations(), "");
    }

    VirtualChain sim{u"servo,servo,servo,step"_s};
    QJsonArray before;
    VirtualPanel panel;
};

TEST_F(CopyAxis, OffersTheAxesOfTheSameTypeAndTheSettingsThatDiffer) {
    ASSERT_NO_FATAL_FAILURE(begin());
    action()->trigger();
    EXPECT_EQ(texts(find<QListWidget>(u"copyToList"_s)), (QStringList{u"Module 2"_s, u"Module 3"_s}));
    EXPECT_EQ(texts(find<QListWidget>(u"copyPartsList"_s)),
              (QStringList{u"Travel and speed limits"_s, u"Gains"_s}));
    auto* show = find<QAbstractButton>(u"copyShowButton"_s);
    EXPECT_FALSE(show->isEnabled());
    EXPECT_EQ(find<QLabel>(u"copyHint"_s)->text(), u"Select the axes to copy to."_s);
    tick(u"copyToList"_s, u"Module 2"_s);
    EXPECT_EQ(show->toolTip(), u"Select the settings to copy."_s);
    tick(u"copyPartsList"_s, u"Gains"_s);
    EXPECT_TRUE(show->isEnabled());
    // The PIC-STEP is the only one of its type.
    find<QComboBox>(u"copyFromBox"_s)->setCurrentIndex(3);
    EXPECT_EQ(find<QListWidget>(u"copyToList"_s)->count(), 0);
    EXPECT_EQ(show->toolTip(), u"No other axis with this type of module has other settings."_s);
}

TEST_F(CopyAxis, ApplySendsTheGainsToThatModuleAndNothingToTheOthers) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(copyGains());
    ASSERT_NE(table(), nullptr);
    ASSERT_EQ(table()->topLevelItemCount(), 1);
    const QTreeWidgetItem* gains = table()->topLevelItem(0);
    EXPECT_EQ(gains->text(0), u"Module 3: Gains"_s);
    EXPECT_EQ(gains->text(3), u"Sent to the module."_s);
    EXPECT_EQ(table()->headerItem()->text(1), u"Module 1"_s);
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before) << "nothing is sent before it is applied";
    EXPECT_EQ(axis(2).gains, std::nullopt);
    ASSERT_NO_FATAL_FAILURE(click(u"applyDifferencesButton"_s));
    ASSERT_TRUE(panel.waitFor([&] { return sim.state(3)[u"gains"_s].toObject()[u"kp"_s] == 200; }));
    ASSERT_TRUE(panel.answersFor(0.3));
    const QJsonArray after = changes(sim);
    for (const int other : {0, 1, 3})
        EXPECT_EQ(after[other], before[other]) << "module " << other + 1;
    QJsonObject third = before[2].toObject();
    third[u"set_gain"_s] = 1;
    EXPECT_EQ(after[2].toObject(), third);
    EXPECT_EQ(axis(2).gains, kGains);
    EXPECT_EQ(axis(2).travel, TravelSettings{}) << "only the gains were chosen";
    EXPECT_EQ(panel.headlines().first(), u"Settings copied from Module 1: 1."_s);
    EXPECT_TRUE(panel.window().isWindowModified()) << "no file has it yet";
    expectNothingMoved();
}

TEST_F(CopyAxis, CopiesWhatIsSetWhenItIsRequested) {
    ASSERT_NO_FATAL_FAILURE(begin());
    action()->trigger();
    tick(u"copyToList"_s, u"Module 2"_s);
    tick(u"copyPartsList"_s, u"Travel and speed limits"_s);
    AxisSettings first = axis(0);
    first.travel.highest = 7'000;
    first.backlash.distance = 20;
    emit panel.window().requests().axisEdited(ModuleIndex(0), first);
    EXPECT_EQ(texts(find<QListWidget>(u"copyPartsList"_s)),
              (QStringList{u"Travel and speed limits"_s, u"Backlash"_s, u"Gains"_s}));
    ASSERT_NO_FATAL_FAILURE(click(u"copyShowButton"_s));
    ASSERT_EQ(table()->topLevelItemCount(), 1) << "what was ticked, and nothing else";
    ASSERT_NO_FATAL_FAILURE(click(u"applyDifferencesButton"_s));
    EXPECT_EQ(axis(1).travel, first.travel);
    EXPECT_EQ(axis(1).backlash, BacklashSettings{});
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before) << "limits are the panel's";
    expectNothingMoved();
}

TEST_F(CopyAxis, NothingIsSentWhileAMotorMoves) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(copyGains());
    panel.ask(intent::Enable{});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn(); }));
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(6'554), false}});
    auto* apply = find<QAbstractButton>(u"applyDifferencesButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().moving() && !apply->isEnabled(); }));
    EXPECT_TRUE(apply->toolTip().contains(u"moving"_s)) << apply->toolTip().toStdString();
    emit panel.window().machineMenu().applyRequested({{ModuleIndex(2), MachinePart::Gains}});
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim)[2], before[2]);
    EXPECT_EQ(axis(2).gains, std::nullopt);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(CopyAxis, CancelChangesNothing) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(copyGains());
    ASSERT_NO_FATAL_FAILURE(click(u"cancelDifferencesButton"_s));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before);
    EXPECT_EQ(axis(2).gains, std::nullopt);
}

TEST_F(CopyAxis, OnAReadOnlyConnectionSettingsAreFilledInAndNothingIsSent) {
    {
        VirtualPanel other;  // it gives the modules their addresses
        ASSERT_NO_FATAL_FAILURE(other.startAt(sim.terminal()));
    }
    ASSERT_NO_FATAL_FAILURE(begin(true));
    before = changes(sim);
    ASSERT_NO_FATAL_FAILURE(copyGains());
    ASSERT_NE(table(), nullptr);
    const QString applying = table()->topLevelItem(0)->text(3);
    EXPECT_TRUE(applying.startsWith(u"Filled in, not sent:"_s)) << applying.toStdString();
    EXPECT_TRUE(applying.contains(u"read-only"_s)) << applying.toStdString();
    ASSERT_NO_FATAL_FAILURE(click(u"applyDifferencesButton"_s));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(changes(sim), before);
    EXPECT_EQ(axis(2).gains, kGains);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(CopyAxis, OperatorModeLocksItAndClosesWhatIsOpen) {
    ASSERT_NO_FATAL_FAILURE(begin());
    action()->trigger();
    const QPointer<QDialog> dialog = find<QDialog>(u"copyDialog"_s);
    find<QAction>(u"operatorAction"_s)->trigger();
    for (const QString& field : {u"operatorPinField"_s, u"operatorPinAgainField"_s})
        QTest::keyClicks(find<QLineEdit>(field), u"4711"_s);
    ASSERT_NO_FATAL_FAILURE(click(u"operatorBeginButton"_s));
    ASSERT_TRUE(panel.waitFor([&] { return !action()->isEnabled(); }));
    EXPECT_TRUE(dialog == nullptr || !dialog->isVisible());
    EXPECT_TRUE(action()->toolTip().contains(u"operator mode"_s, Qt::CaseInsensitive))
        << action()->toolTip().toStdString();
    // What was chosen right before is not shown either.
    emit panel.window().requests().copyAxis({ModuleIndex(0), axis(0), {ModuleIndex(2)}, {}});
    EXPECT_EQ(table(), nullptr);
    EXPECT_EQ(changes(sim), before);
}

TEST_F(CopyAxis, AnotherChainEndsIt) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(copyGains());
    ASSERT_NE(table(), nullptr);
    action()->trigger();
    const QPointer<QDialog> dialog = find<QDialog>(u"copyDialog"_s);
    find<QAbstractButton>(u"disconnectButton"_s)->click();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
    ASSERT_TRUE(panel.waitFor([&] { return table() == nullptr && dialog == nullptr; }));
    EXPECT_EQ(axis(2).gains, std::nullopt);
}

}  // namespace
}  // namespace nmc

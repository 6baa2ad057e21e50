// SPDX-License-Identifier: GPL-3.0-or-later
// The machine part of the File menu, the table of differences, and the questions before unsaved work is given
// up.
#include "model/machinefile/machinecompare.h"
#include "tests/support/choosefile.h"
#include "widgets/machine/machinemenu.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing::ElementsAre;

class MachineWindow : public WindowTest {
protected:
    MachineMenu& menu() { return window->machineMenu(); }
    void trigger(const QString& action) {
        auto* found = window->findChild<QAction*>(action);
        ASSERT_NE(found, nullptr) << action.toStdString();
        found->trigger();
    }
    QTreeWidget* table() { return find<QTreeWidget>(u"differencesTable"_s); }
    static Difference difference(MachinePart part, Applying applying, bool wanted = true) {
        Difference row{{ModuleIndex(0), part}, {{"Kp", Quantity::Plain, 200.0, 150.0}}};
        row.fields.push_back({"Kd", Quantity::Plain, 2'000.0, std::nullopt});
        row.applying = applying;
        row.wanted = wanted;
        return row;
    }
    /// Shows a name, gains that are sent, limit pins that are not ticked, and a module of another type.
    void showSome() {
        menu().showDifferences(u"/home/anna/mill.json"_s,
                               {difference(MachinePart::AxisName, Applying::ChangesPanel),
                                difference(MachinePart::Gains, Applying::Sends),
                                difference(MachinePart::Io, Applying::Sends, false),
                                difference(MachinePart::Hardware, Applying::OtherHardware)});
    }
};

TEST_F(MachineWindow, TheTitleNamesTheMachineAndMarksWhatIsNotSaved) {
    EXPECT_EQ(window->windowTitle(), u"NMC Panel"_s);
    menu().showFile({u"/home/anna/mill.json"_s, u"Mill 2000"_s, false, {}});
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - mill[*]"_s);
    EXPECT_FALSE(window->isWindowModified());
    menu().showFile({u"/home/anna/mill.json"_s, u"Mill 2000"_s, true, {}});
    EXPECT_TRUE(window->isWindowModified());
    menu().showFile({{}, u"Mill 2000"_s, true, {}});
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - Mill 2000[*]"_s);
    menu().showFile({{}, {}, true, {}});
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - new machine[*]"_s);
    menu().showFile({});
    EXPECT_EQ(window->windowTitle(), u"NMC Panel"_s);
}

TEST_F(MachineWindow, WhileTheDiskIsWaitedForTheTitleSaysSoAndNothingElseIsAskedOfIt) {
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {u"/home/anna/old.json"_s}, true});
    EXPECT_EQ(window->windowTitle(), u"NMC Panel - mill[*] (being saved)"_s);
    const QSignalSpy saved(&menu(), &MachineMenu::saveRequested);
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(saved.count(), 0);
    EXPECT_FALSE(find<QMenu>(u"recentMachinesMenu"_s)->isEnabled());
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {u"/home/anna/old.json"_s}});
    EXPECT_TRUE(find<QMenu>(u"recentMachinesMenu"_s)->isEnabled());
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(saved.count(), 1);
}

TEST_F(MachineWindow, TheStandardKeysOpenSaveAndBeginAnew) {
    const std::pair<QString, QKeySequence> keys[] = {
        {u"newMachineAction"_s, Qt::CTRL | Qt::Key_N},
        {u"openMachineAction"_s, Qt::CTRL | Qt::Key_O},
        {u"saveMachineAction"_s, Qt::CTRL | Qt::Key_S},
        {u"saveMachineAsAction"_s, Qt::CTRL | Qt::SHIFT | Qt::Key_S}};
    for (const auto& [name, key] : keys)
        EXPECT_EQ(window->findChild<QAction*>(name)->shortcut(), key) << name.toStdString();
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {}});
    const QSignalSpy saved(&menu(), &MachineMenu::saveRequested);
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(saved.count(), 1);
}

TEST_F(MachineWindow, RecentFilesAreInTheMenuAndEachOpensItsFile) {
    auto* recent = find<QMenu>(u"recentMachinesMenu"_s);
    EXPECT_FALSE(recent->isEnabled()) << "there are none";
    menu().showFile({{}, {}, false, {u"/home/anna/mill.json"_s, u"/mnt/a & b.json"_s}});
    EXPECT_TRUE(recent->isEnabled());
    ASSERT_EQ(recent->actions().size(), 2);
    EXPECT_EQ(recent->actions()[0]->text(), u"&1  mill.json"_s);
    EXPECT_EQ(recent->actions()[1]->text(), u"&2  a && b.json"_s);
    EXPECT_EQ(recent->actions()[1]->toolTip(), u"/mnt/a & b.json"_s);
    QSignalSpy opened(&menu(), &MachineMenu::openRequested);
    recent->actions()[1]->trigger();
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened[0][0].toString(), u"/mnt/a & b.json"_s);
}

TEST_F(MachineWindow, AMachineWithoutAFileAsksForOneWhenItIsSaved) {
    const QSignalSpy saved(&menu(), &MachineMenu::saveRequested);
    trigger(u"saveMachineAction"_s);
    EXPECT_EQ(saved.count(), 0);
    auto* dialog = find<QFileDialog>(u"saveMachineDialog"_s);
    EXPECT_FALSE(dialog->isModal()) << "STOP ALL stays within reach";
    QSignalSpy savedAs(&menu(), &MachineMenu::saveAsRequested);
    testing_support::chooseFile(*dialog, u"/home/anna/new.json"_s);
    ASSERT_EQ(savedAs.count(), 1);
    EXPECT_EQ(savedAs[0][0].toString(), u"/home/anna/new.json"_s);
}

// ---- the table ----

TEST_F(MachineWindow, ARowOfOneValueNamesItsQuantity) {
    const auto one = [](MachinePart part, const char* key) {
        return Difference{{ModuleIndex(0), part}, {{key, Quantity::Plain, 40.0, 42.0}}};
    };
    menu().showDifferences(u"/home/anna/mill.json"_s,
                           {one(MachinePart::Gains, "Kp"), one(MachinePart::Motion, "velocity"),
                            one(MachinePart::AccelerationTime, "acceleration_time")});
    EXPECT_EQ(table()->topLevelItem(0)->text(0), u"Module 1: Gains, Kp"_s);
    EXPECT_EQ(table()->topLevelItem(1)->text(0), u"Module 1: Motion, Velocity"_s);
    EXPECT_EQ(table()->topLevelItem(2)->text(0), u"Module 1: Acceleration time"_s);
}

TEST_F(MachineWindow, TheTableShowsFileAndPresentAndWhatApplyingDoes) {
    showSome();
    ASSERT_EQ(table()->topLevelItemCount(), 4);
    const QTreeWidgetItem* gains = table()->topLevelItem(1);
    EXPECT_EQ(gains->text(0), u"Module 1: Gains"_s);
    EXPECT_EQ(gains->text(3), u"Sent to the module."_s);
    EXPECT_EQ(gains->checkState(0), Qt::Checked);
    EXPECT_EQ(gains->child(0)->text(0), u"Kp"_s);
    EXPECT_EQ(gains->child(0)->text(1), u"200"_s);
    EXPECT_EQ(gains->child(0)->text(2), u"150"_s);
    EXPECT_EQ(gains->child(1)->text(2), u"unknown"_s);
    EXPECT_EQ(table()->topLevelItem(2)->checkState(0), Qt::Unchecked);
    EXPECT_FALSE(table()->topLevelItem(3)->data(0, Qt::CheckStateRole).isValid()) << "it cannot be ticked";
    EXPECT_FALSE(find<QDialog>(u"differencesDialog"_s)->isModal()) << "STOP ALL stays within reach";
}

TEST_F(MachineWindow, ApplyTellsWhatIsTicked) {
    std::vector<PartId> chosen;
    QObject::connect(&menu(), &MachineMenu::applyRequested, &menu(),
                     [&chosen](const std::vector<PartId>& ids) { chosen = ids; });
    showSome();
    table()->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(text(u"differencesSummary"_s), u"Selected: 1 of 4. Sent to modules: 1."_s);
    click(u"applyDifferencesButton"_s);
    EXPECT_THAT(chosen, ElementsAre(PartId{ModuleIndex(0), MachinePart::Gains}));
    click(u"tickAllButton"_s);
    click(u"applyDifferencesButton"_s);
    EXPECT_EQ(chosen.size(), 3U) << "never including what cannot be applied";
    click(u"tickNoneButton"_s);
    click(u"applyDifferencesButton"_s);
    EXPECT_TRUE(chosen.empty());
}

TEST_F(MachineWindow, WhileAMotorMovesNothingCanBeSentButNamesCanBeTaken) {
    showSome();
    menu().differences()->showMoving(1);
    EXPECT_FALSE(button(u"applyDifferencesButton"_s)->isEnabled());
    EXPECT_THAT(button(u"applyDifferencesButton"_s)->toolTip().toStdString(),
                testing::HasSubstr("1 motor is moving"));
    table()->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
    EXPECT_TRUE(button(u"applyDifferencesButton"_s)->isEnabled());
    table()->topLevelItem(1)->setCheckState(0, Qt::Checked);
    menu().differences()->showMoving(0);
    EXPECT_TRUE(button(u"applyDifferencesButton"_s)->isEnabled());
}

TEST_F(MachineWindow, EscStopsTheMotorsAndDropsTheFile) {
    showServo();
    const QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    const QSignalSpy applied(&menu(), &MachineMenu::applyRequested);
    const QSignalSpy dropped(&menu(), &MachineMenu::differencesDropped);
    showSome();
    QTest::keyClick(table(), Qt::Key_Escape);
    EXPECT_EQ(stops.count(), 1);
    EXPECT_EQ(applied.count(), 0);
    EXPECT_EQ(dropped.count(), 1);
}

TEST_F(MachineWindow, EnterDoesNotApply) {
    showSome();
    const QSignalSpy applied(&menu(), &MachineMenu::applyRequested);
    for (QWidget* widget : {static_cast<QWidget*>(table()), static_cast<QWidget*>(menu().differences())})
        QTest::keyClick(widget, Qt::Key_Return);
    EXPECT_EQ(applied.count(), 0);
}

TEST_F(MachineWindow, TheKeyboardAloneTicksAndApplies) {
    std::vector<PartId> chosen;
    QObject::connect(&menu(), &MachineMenu::applyRequested, &menu(),
                     [&chosen](const std::vector<PartId>& ids) { chosen = ids; });
    showSome();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(menu().differences(), testing_support::kPatienceMs));
    menu().differences()->activateWindow();
    ASSERT_TRUE(eventually([this] { return QApplication::activeWindow() == menu().differences(); }));
    table()->setFocus();
    table()->setCurrentItem(table()->topLevelItem(0));
    QTest::keyClick(table(), Qt::Key_Space);
    QTest::keyClick(menu().differences(), Qt::Key_A, Qt::AltModifier);
    ASSERT_TRUE(eventually([&chosen] { return !chosen.empty(); }))
        << "a button clicked by a key first looks pressed for a moment";
    EXPECT_THAT(chosen, ElementsAre(PartId{ModuleIndex(0), MachinePart::Gains}));
}

TEST_F(MachineWindow, EveryFieldOfAMachineHasAWord) {
    Machine file;
    file.name = "Mill";
    file.baud = 19'200;
    file.groups = {{0x81, "Table", {ModuleIndex(0)}, ModuleIndex(0)}};
    file.program.points = {{"Pick", {}}};
    file.program.sequences = {{"Main", {}}};
    file.homeOrder = {ModuleIndex(0)};
    file.operatorRights.emplace();
    AxisSettings& axis = file.axes.emplace_back();
    axis.name = "X";
    axis.unit = {UnitKind::Own, 2.0, "n"};
    axis.motion = {1, 1, 1, 1, 1, 1};
    axis.travel = {-1, 1, 1};
    axis.backlash = {1, true};
    axis.homing.emplace();
    axis.homing->velocity = axis.homing->indexVelocity = axis.homing->acceleration = 1;
    axis.homing->travelLimit = axis.homing->timeLimit = 1;
    axis.limitStop = {true, {false, false, HomingRecipe::Stop::Smoothly, true, true}};
    axis.analog = {1.0, 1.0, "A"};
    axis.io.emplace().fastPath = true;
    axis.fastPath = true;
    axis.parameters.emplace();
    axis.accelerationTime = 1;
    axis.outputNames[0] = axis.inputNames[0] = "Lamp";
    std::size_t fields = 0;
    for (const Difference& row : compare(file, {}, {}))
        for (const FieldDifference& field : row.fields) {
            const QString key = QString::fromStdString(field.key);
            EXPECT_NE(texts::machineField(key), key) << field.key;
            ++fields;
        }
    EXPECT_EQ(fields, 70U) << "13 of the machine and 57 of its axis";
    EXPECT_EQ(texts::machineField(u"group129"_s), u"Group 81"_s);
}

// ---- unsaved work ----

TEST_F(MachineWindow, UnsavedChangesAreAskedAboutOnceBeforeTheWindowCloses) {
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {}});
    window->close();
    window->close();
    EXPECT_EQ(window->findChildren<QDialog*>(u"unsavedDialog"_s).size(), 1);
    EXPECT_EQ(text(u"unsavedText"_s), u"Save the changes to \"mill\"?"_s);
    click(u"stayUnsavedButton"_s);
    EXPECT_TRUE(window->isVisible());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    window->close();
    click(u"goOnUnsavedButton"_s);
    EXPECT_FALSE(window->isVisible());
}

/// The question blocks nothing, so a user who works on may no longer see it, and would find it hours later.
TEST_F(MachineWindow, AQuestionThatWaitsSaysSoWhereTheUserLooks) {
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {}});
    window->close();
    const QWidget* asked = find(u"unsavedDialog"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(const_cast<QWidget*>(asked), testing_support::kPatienceMs));
    EXPECT_FALSE(find(u"banner"_s)->isVisible()) << "the question is visible";
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
    ASSERT_TRUE(eventually([&] { return find(u"banner"_s)->isVisible(); }));
    EXPECT_EQ(text(u"bannerHeadline"_s), u"A question is waiting for your answer: Unsaved changes"_s);
    EXPECT_EQ(text(u"bannerBody"_s), u"Save the changes to \"mill\"?"_s);
    click(u"bannerAction_showQuestion"_s);
    EXPECT_TRUE(eventually([&] { return asked->isActiveWindow(); }));
    EXPECT_TRUE(eventually([&] { return !find(u"banner"_s)->isVisible(); }));
    // It is answered elsewhere, and there is nothing left to ask.
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), testing_support::kPatienceMs));
    menu().showFile({u"/home/anna/mill.json"_s, {}, false, {}});
    EXPECT_FALSE(find(u"banner"_s)->isVisible());
}

TEST_F(MachineWindow, SavingFirstClosesOnlyWhenItWorked) {
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {}});
    window->close();
    click(u"saveFirstButton"_s);
    EXPECT_TRUE(window->isVisible()) << "it has not been saved yet";
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QObject::connect(&menu(), &MachineMenu::saveRequested, &menu(), [this] {
        menu().showFile({u"/home/anna/mill.json"_s, {}, false, {}});
    });
    window->close();
    click(u"saveFirstButton"_s);
    EXPECT_FALSE(window->isVisible());
}

TEST_F(MachineWindow, SavingFirstClosesIfItsDialogWasOpenAlready) {
    menu().showFile({{}, {}, true, {}});
    QObject::connect(&menu(), &MachineMenu::saveAsRequested, &menu(), [this](const QString& path) {
        menu().showFile({path, {}, false, {}});
    });
    trigger(u"saveMachineAction"_s);
    window->close();
    click(u"saveFirstButton"_s);
    EXPECT_TRUE(window->isVisible());
    testing_support::chooseFile(*find<QFileDialog>(u"saveMachineDialog"_s), u"/home/anna/new.json"_s);
    EXPECT_FALSE(window->isVisible());
}

TEST_F(MachineWindow, ClosingWaitsForTheDiskUnlessTheUserDoesNot) {
    const MachineFile saving{u"/home/anna/mill.json"_s, {}, true, {}, true};
    menu().showFile(saving);
    window->close();
    EXPECT_EQ(text(u"closeText"_s), u"Saving \"mill\". The window closes when it is saved."_s);
    click(u"staySavingButton"_s);
    menu().showFile({u"/home/anna/mill.json"_s, {}, false, {}});
    EXPECT_TRUE(window->isVisible()) << "the user chose to stay";
    menu().showFile(saving);
    window->close();
    menu().showFile({u"/home/anna/mill.json"_s, {}, true, {}});
    EXPECT_TRUE(window->isVisible()) << "it was not saved";
    menu().showFile(saving);
    window->close();
    menu().showFile({u"/home/anna/mill.json"_s, {}, false, {}});
    EXPECT_FALSE(window->isVisible());
    window->show();
    menu().showFile(saving);
    window->close();
    click(u"closeUnsavedButton"_s);
    EXPECT_FALSE(window->isVisible());
}

TEST_F(MachineWindow, NewAndOpenAskFirstAndNameTheLoss) {
    const QSignalSpy begun(&menu(), &MachineMenu::newRequested);
    menu().showFile({{}, {}, true, {}});
    trigger(u"newMachineAction"_s);
    EXPECT_EQ(begun.count(), 0);
    EXPECT_THAT(button(u"goOnUnsavedButton"_s)->text().toStdString(), testing::HasSubstr("lost"));
    click(u"goOnUnsavedButton"_s);
    EXPECT_EQ(begun.count(), 1);
}

TEST_F(MachineWindow, WhatWasAskedForLastIsDoneWhenTheQuestionIsAnswered) {
    const QSignalSpy begun(&menu(), &MachineMenu::newRequested);
    const QSignalSpy opened(&menu(), &MachineMenu::openRequested);
    menu().showFile({{}, {}, true, {u"/home/anna/mill.json"_s}});
    trigger(u"newMachineAction"_s);
    trigger(u"recentMachine1Action"_s);
    click(u"goOnUnsavedButton"_s);
    EXPECT_EQ(begun.count(), 0);
    EXPECT_EQ(opened.count(), 1);
}

TEST_F(MachineWindow, ClosingIsAskedAboutInPlaceOfANewMachine) {
    const QSignalSpy begun(&menu(), &MachineMenu::newRequested);
    menu().showFile({{}, {}, true, {}});
    trigger(u"newMachineAction"_s);
    window->close();
    EXPECT_THAT(button(u"goOnUnsavedButton"_s)->text().toStdString(), testing::HasSubstr("Close"));
    click(u"goOnUnsavedButton"_s);
    EXPECT_EQ(begun.count(), 0);
    EXPECT_FALSE(window->isVisible());
}

TEST_F(MachineWindow, EscInTheQuestionStaysAndStops) {
    showServo();
    const QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    menu().showFile({{}, {}, true, {}});
    window->close();
    QTest::keyClick(find(u"unsavedDialog"_s), Qt::Key_Escape);
    EXPECT_TRUE(window->isVisible());
    EXPECT_EQ(stops.count(), 1);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// The page of points and sequences: what can be done when, and why not; and its item models.
#include "model/sequence/sequencecheck.h"
#include "model/sequence/sequenceedit.h"
#include "sim/random.h"
#include "widgets/common/requests.h"
#include "widgets/common/words.h"
#include "widgets/sequences/pointsmodel.h"
#include "widgets/sequences/rowsmodel.h"
#include "widgets/sequences/sequencesdock.h"
#include "windowtest.h"

namespace nmc {
namespace {

Program twoPoints() {
    return {{{"A", {{ModuleIndex(0), 100, false}}}, {"B", {{ModuleIndex(0), 0, false}}}},
            {{"Main", {action::MoveTo{"A"}, action::Wait{0.5}, action::MoveTo{"B"}, action::Repeat{0, 3}}}}};
}

class SequencePage : public WindowTest {
protected:
    SequencePage() {
        window->resize(1'500, 1'100);
        QObject::connect(&window->requests(), &Requests::programEdited, window.get(),
                         [this](const Program& program) {
                             machine.program = program;
                             window->showMachine(machine);
                         });
        showServo();
        QTest::keyClick(window->windowHandle(), Qt::Key_F3);
    }
    void load(const Program& program) {
        machine.program = program;
        window->showMachine(machine);
    }
    void choose(const QString& table, int row) {
        auto* view = find<QTableView>(table);
        QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                          view->visualRect(view->model()->index(row, 0)).center());
    }
    QString cell(int row, int column) {
        return find<QTableView>(u"rowTable"_s)->model()->index(row, column).data().toString();
    }
    QString whyNot(const QString& name) {
        return button(name)->isEnabled() ? QString() : button(name)->toolTip();
    }
};

TEST_F(SequencePage, SaysWhatIsMissingBeforeTeaching) {
    EXPECT_EQ(whyNot(u"teachButton"_s), u"Enter a name for the point first."_s);
    auto* name = find<QLineEdit>(u"pointNameField"_s);
    QTest::keyClicks(name, u"A"_s);
    EXPECT_EQ(whyNot(u"teachButton"_s), QString());
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(machine.program.points.size(), 1U);
    EXPECT_EQ(machine.program.points[0].name, "A");
    EXPECT_FALSE(machine.program.points[0].axes.at(0).fromHome);
    showServo({.position = 50});
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(machine.program.points.size(), 1U) << "the same point was taught again";
    EXPECT_EQ(machine.program.points[0].axes.at(0).counts, 50);
    window->showLink({});
    EXPECT_FALSE(whyNot(u"teachButton"_s).isEmpty());
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_TRUE(eventually([this] { return QToolTip::text() == whyNot(u"teachButton"_s); }));
}

/// A PIC-I/O never has a position.
TEST_F(SequencePage, OnlyMotorsAreOfferedToTeachAndKeepTheirTicks) {
    ModuleState io;
    io.info = {ModuleIndex(1), BusAddress(2), {ModuleType::Io, 1}};
    const LinkState chain = connectedTo({Servo{}.state(), io, Servo{.index = 2, .position = 30}.state()});
    window->showLink(chain);
    auto* axes = find<QListWidget>(u"teachAxesList"_s);
    auto* name = find<QLineEdit>(u"pointNameField"_s);
    ASSERT_EQ(axes->count(), 3);
    EXPECT_TRUE(axes->item(1)->isHidden());
    QTest::keyClicks(name, u"A"_s);
    EXPECT_EQ(whyNot(u"teachButton"_s), QString());
    axes->item(0)->setCheckState(Qt::Unchecked);
    window->showLink({});
    window->showLink(chain);
    EXPECT_FALSE(axes->item(0)->isHidden());
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(machine.program.points.size(), 1U);
    ASSERT_EQ(machine.program.points[0].axes.size(), 1U) << "the first was not ticked before";
    EXPECT_EQ(machine.program.points[0].axes[0].module, ModuleIndex(2));
    EXPECT_EQ(machine.program.points[0].axes[0].counts, 30);
}

/// The other points of the axis are in steps.
TEST_F(SequencePage, APositionOfAnotherTypeOfModuleIsNotTaught) {
    machine.axes.emplace_back().expected = ModuleIdentity{ModuleType::Stepper, 1};
    load(twoPoints());
    QTest::keyClicks(find<QLineEdit>(u"pointNameField"_s), u"C"_s);
    EXPECT_EQ(whyNot(u"teachButton"_s), u"Module 1: "_s + texts::refusal(Refusal::OtherType));
    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 4};
    window->showMachine(machine);
    EXPECT_EQ(whyNot(u"teachButton"_s), QString());
}

TEST_F(SequencePage, RowsHaveThePresentNamesOfTheModules) {
    Program program = twoPoints();
    program.sequences[0].rows = {action::Home{ModuleIndex(0)}};
    load(program);
    QSignalSpy changes(find<QTableView>(u"rowTable"_s)->model(), &QAbstractItemModel::dataChanged);
    machine.axes.resize(1);
    machine.axes[0].name = "X axis";
    window->showMachine(machine);
    EXPECT_EQ(changes.size(), 1) << "the table draws them again";
    EXPECT_EQ(cell(0, 1), u"Module 1 \"X axis\""_s);
    texts::setModuleNames({});
}

/// From 400, a move to 100 from below with 50 counts of play turns round at 50.
TEST_F(SequencePage, ALimitIsNamedAsForAMove) {
    machine.axes.resize(1);
    machine.axes[0].travel.lowest = 60;
    machine.axes[0].backlash = {50, false};
    Program program;
    program.points = {{"A", {{ModuleIndex(0), 100, true}}}};
    program.sequences = {{"Main", {action::MoveTo{"A"}}}};
    load(program);
    ModuleState module = Servo{.position = 400, .millisecond = 10}.state();
    module.home.found(0, module.latestTime);
    module.travel = machine.axes[0].travel;
    module.backlash = machine.axes[0].backlash;
    window->showLink(connectedTo({module}));
    const QString reason = whyNot(u"runSequenceButton"_s);
    EXPECT_TRUE(reason.startsWith(u"Main, row 1: "_s)) << reason.toStdString();
    EXPECT_TRUE(reason.contains(u"would reverse at 50 counts, below the lowest position 60 counts"_s))
        << reason.toStdString();
}

TEST_F(SequencePage, ADryRunIsNotShownForOtherRows) {
    Program program = twoPoints();
    load(program);
    const auto* result = window->findChild<QLabel*>(u"dryRunLabel"_s);
    click(u"dryRunButton"_s);
    window->sequences().showForesight({});
    EXPECT_TRUE(result->text().startsWith(u"Dry run"_s)) << result->text().toStdString();
    program.sequences[0].rows.pop_back();
    load(program);
    EXPECT_EQ(result->text(), QString());
    click(u"dryRunButton"_s);
    program.sequences[0].rows.pop_back();
    load(program);
    window->sequences().showForesight({});
    EXPECT_EQ(result->text(), QString()) << "it was begun with the rows before";
}

/// This has happened: they were below the table, and moved when a result appeared, so that a click meant for
/// Run added a row.
TEST_F(SequencePage, WhatRunsASequenceIsAlwaysVisibleAndNeverMoves) {
    load(twoPoints());
    auto* scroll = find<QScrollArea>(u"sequencesPageScroll"_s);
    const auto places = [&] {
        QApplication::processEvents();
        QList<QRect> all;
        for (const QString& name : {u"runSequenceButton"_s, u"pauseSequenceButton"_s, u"stopSequenceButton"_s,
                                    u"runFromRowButton"_s, u"stepSequenceButton"_s, u"dryRunButton"_s,
                                    u"addRowButton"_s, u"removePointButton"_s}) {
            const auto* control = window->findChild<QAbstractButton*>(name);
            all << QRect(control->mapTo(window.get(), QPoint()), control->size());
        }
        return all;
    };
    for (const QString& name : {u"sequenceBox"_s, u"runSequenceButton"_s, u"pauseSequenceButton"_s,
                                u"stopSequenceButton"_s, u"sequenceStateLabel"_s})
        EXPECT_FALSE(scroll->isAncestorOf(find(name))) << name.toStdString();
    const QList<QRect> before = places();
    click(u"dryRunButton"_s);
    EXPECT_EQ(places(), before) << "it says End dry run now";
    window->sequences().showForesight({});
    EXPECT_EQ(places(), before) << "a result has appeared";
    SequenceReport report;
    report.places = {{"Main", 1}};
    report.stage = SequenceStage::Paused;
    window->sequences().showRun(report);
    EXPECT_EQ(places(), before) << "Pause says Continue now";
    report.stage = SequenceStage::Over;
    report.end = SequenceEnd::NotSettled;
    report.module = ModuleIndex(0);
    window->sequences().showRun(report);
    EXPECT_EQ(places(), before) << "a long reason why it ended";

    scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
    EXPECT_EQ(places().first(6), before.first(6));
    for (const QString& name : {u"runSequenceButton"_s, u"pauseSequenceButton"_s, u"stopSequenceButton"_s,
                                u"sequenceStateLabel"_s}) {
        const auto* control = window->findChild<QWidget*>(name);
        EXPECT_EQ(control->visibleRegion().boundingRect(), control->rect()) << name.toStdString();
    }
}

TEST_F(SequencePage, ANameBeingTypedGoesToNoOtherSequence) {
    Program program = twoPoints();
    program.sequences.push_back({"Other", {action::Wait{1}}});
    load(program);
    auto* name = find<QLineEdit>(u"sequenceNameField"_s);
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, u"Mill"_s);
    program.sequences.erase(program.sequences.begin());
    load(program);
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_EQ(machine.program.sequences.size(), 1U);
    EXPECT_EQ(machine.program.sequences[0].name, "Other") << "the name was meant for Main";
}

TEST_F(SequencePage, ShowsRowsInWords) {
    load(twoPoints());
    EXPECT_EQ(cell(0, 0), u"move to"_s);
    EXPECT_EQ(cell(0, 1), u"A"_s);
    EXPECT_EQ(cell(0, 2), u"together"_s);
    EXPECT_EQ(cell(1, 3), u"0.5 s"_s);
    EXPECT_EQ(cell(3, 1), u"from row 1 on"_s);
    EXPECT_EQ(cell(3, 3), u"3 times in all"_s);
}

TEST_F(SequencePage, RowsAreMovedDuplicatedAndRemoved) {
    load(twoPoints());
    choose(u"rowTable"_s, 1);
    click(u"rowUpButton"_s);
    EXPECT_EQ(machine.program.sequences[0].rows[0], Action(action::Wait{0.5}));
    EXPECT_EQ(std::get<action::Repeat>(machine.program.sequences[0].rows[3]).from, 1U)
        << "it still repeats from the move to A on";
    click(u"duplicateRowButton"_s);
    EXPECT_EQ(machine.program.sequences[0].rows.size(), 5U);
    click(u"removeRowButton"_s);
    EXPECT_EQ(machine.program.sequences[0].rows.size(), 4U);
    choose(u"rowTable"_s, 3);
    EXPECT_FALSE(whyNot(u"rowDownButton"_s).isEmpty());
    QTest::keyClick(find(u"rowTable"_s), Qt::Key_Z, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(machine.program.sequences[0].rows.size(), 5U);
}

TEST_F(SequencePage, WhatIsUsedIsNotRemoved) {
    load(twoPoints());
    choose(u"pointTable"_s, 0);
    EXPECT_TRUE(whyNot(u"removePointButton"_s).contains(u"Row 1 of \"Main\""_s))
        << whyNot(u"removePointButton"_s).toStdString();
}

TEST_F(SequencePage, ANewNameIsOneEverywhere) {
    load(twoPoints());
    auto* name = find<QLineEdit>(u"sequenceNameField"_s);
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, u"Loading"_s);
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(machine.program.sequences[0].name, "Loading");
    EXPECT_EQ(find<QComboBox>(u"sequenceBox"_s)->currentText(), u"Loading"_s);
    EXPECT_EQ(find<QTableView>(u"rowTable"_s)->model()->rowCount(), 4);
}

TEST_F(SequencePage, TheReasonWhyItCannotRunNamesTheRow) {
    load(twoPoints());
    EXPECT_EQ(whyNot(u"runSequenceButton"_s), QString());
    showServo({.on = false});
    EXPECT_TRUE(whyNot(u"runSequenceButton"_s).startsWith(u"Main, row 1: "_s))
        << whyNot(u"runSequenceButton"_s).toStdString();
}

TEST_F(SequencePage, ARunMarksItsRowAndForbidsAnother) {
    Program program = twoPoints();
    program.sequences.push_back({"Other", {action::Wait{1}, action::Wait{2}, action::Wait{3}}});
    load(program);
    auto* table = find<QTableView>(u"rowTable"_s);
    QApplication::processEvents();
    const int before = table->viewport()->x();
    SequenceReport report;
    report.places = {{"Main", 2}};
    window->sequences().showRun(report);
    EXPECT_EQ(table->model()->headerData(2, Qt::Vertical).toString(), u"▸ 3"_s);
    QApplication::processEvents();
    EXPECT_EQ(table->viewport()->x(), before) << "the mark always has its room";
    auto* sequences = find<QComboBox>(u"sequenceBox"_s);
    sequences->setCurrentIndex(1);
    EXPECT_EQ(table->model()->headerData(2, Qt::Vertical).toString(), u"3"_s) << "of another sequence";
    sequences->setCurrentIndex(0);
    EXPECT_EQ(table->model()->headerData(2, Qt::Vertical).toString(), u"▸ 3"_s);
    EXPECT_EQ(whyNot(u"runSequenceButton"_s), u"A sequence is already running."_s);
    EXPECT_EQ(whyNot(u"stopSequenceButton"_s), QString());
    QSignalSpy stops(&window->requests(), &Requests::stopSequence);
    click(u"stopSequenceButton"_s);
    EXPECT_EQ(stops.size(), 1);
    report.stage = SequenceStage::Over;
    report.end = SequenceEnd::LinkInDoubt;
    window->sequences().showRun(report);
    EXPECT_TRUE(text(u"sequenceStateLabel"_s).startsWith(u"Ended: "_s))
        << "it cannot be continued as a pause can";
    EXPECT_FALSE(whyNot(u"pauseSequenceButton"_s).isEmpty());
    EXPECT_EQ(whyNot(u"runSequenceButton"_s), QString());
}

TEST_F(SequencePage, ASequenceIsNotOfferedToItself) {
    Program program = twoPoints();
    program.sequences.push_back({"Outer", {action::Call{"Main"}}});
    RowsModel model;
    model.showRows(program, "Outer", 1);
    EXPECT_EQ(model.index(0, RowsModel::What).data(RowsModel::ChoicesRole).toStringList(),
              QStringList{u"Main"_s});
    model.showRows(program, "Main", 1);
    const QStringList kinds = model.index(0, RowsModel::Do).data(RowsModel::ChoicesRole).toStringList();
    EXPECT_FALSE(kinds.contains(u"call"_s)) << "Outer leads back to Main";
    EXPECT_FALSE(kinds.contains(u"repeat"_s)) << "nothing stands above the first row";
}

/// The chain consists of a servo and a PIC-I/O.
TEST(SequenceModels, OfferThePinsThatAModuleHas) {
    Program program{{},
                    {{"Main", {action::WaitForInput{ModuleIndex(0)}, action::SetOutput{ModuleIndex(0), 2}}}}};
    RowsModel rows;
    const auto show = [&] { rows.showRows(program, "Main", 2, {ModuleType::Servo, ModuleType::Io}); };
    QObject::connect(&rows, &RowsModel::rowEdited, [&](int row, const Action& action) {
        program.sequences[0].rows[static_cast<std::size_t>(row)] = action;
        show();
    });
    const auto choose = [&](int row, int column, const QString& wanted) {
        const QModelIndex cell = rows.index(row, column);
        const auto choices = cell.data(RowsModel::ChoicesRole).toStringList();
        ASSERT_TRUE(choices.contains(wanted)) << choices.join(u'|').toStdString();
        EXPECT_TRUE(rows.setData(cell, static_cast<int>(choices.indexOf(wanted)), Qt::EditRole));
    };
    show();
    EXPECT_EQ(rows.index(0, RowsModel::How).data().toString(), u"limit 1 active"_s);
    choose(0, RowsModel::What, u"Module 2"_s);
    EXPECT_EQ(rows.index(0, RowsModel::How).data().toString(), u"IO1 high"_s);
    choose(0, RowsModel::How, u"IO12 low"_s);
    EXPECT_EQ(program.sequences[0].rows[0],
              Action(action::WaitForInput{ModuleIndex(1), InputPin::Io12, false}));
    choose(1, RowsModel::What, u"Module 2"_s);
    choose(1, RowsModel::How, u"IO7 high"_s);
    EXPECT_EQ(program.sequences[0].rows[1], Action(action::SetOutput{ModuleIndex(1), 7, true}));
    choose(1, RowsModel::What, u"Module 1"_s);
    EXPECT_EQ(rows.index(1, RowsModel::How).data().toString(), u"output 1 on"_s)
        << "it has no seventh output";
    choose(1, RowsModel::Do, u"wait for A/D"_s);
    EXPECT_EQ(rows.index(1, RowsModel::What).data().toString(), u"Module 2"_s)
        << "the first module that has one";
    choose(1, RowsModel::How, u"A/D 3 below"_s);
    EXPECT_TRUE(rows.setData(rows.index(1, RowsModel::Number), 200, Qt::EditRole));
    EXPECT_FALSE(rows.setData(rows.index(1, RowsModel::Number), 256, Qt::EditRole));
    EXPECT_TRUE(rows.setData(rows.index(1, RowsModel::Within), 2.5, Qt::EditRole));
    EXPECT_EQ(program.sequences[0].rows[1],
              Action(action::WaitForAnalog{ModuleIndex(1), 3, false, 200, 2.5}));
    EXPECT_EQ(rows.index(1, RowsModel::Within).data().toString(), u"within 2.5 s"_s);
}

/// The chain consists of a PIC-I/O.
TEST(SequenceModels, BeginAWaitWithAPinThatTheFirstModuleHas) {
    Program program{{}, {{"Main", {action::WaitForArrival{}, action::Wait{}}}}};
    RowsModel rows;
    const auto show = [&] { rows.showRows(program, "Main", 1, {ModuleType::Io}); };
    QObject::connect(&rows, &RowsModel::rowEdited, [&](int row, const Action& action) {
        program.sequences[0].rows[static_cast<std::size_t>(row)] = action;
        show();
    });
    show();
    const QModelIndex cell = rows.index(1, RowsModel::Do);
    const auto choices = cell.data(RowsModel::ChoicesRole).toStringList();
    ASSERT_TRUE(choices.contains(u"wait for input"_s));
    EXPECT_TRUE(rows.setData(cell, static_cast<int>(choices.indexOf(u"wait for input"_s)), Qt::EditRole));
    EXPECT_EQ(rows.index(1, RowsModel::How).data().toString(), u"IO1 high"_s);
    EXPECT_EQ(program.sequences[0].rows[1], Action(action::WaitForInput{ModuleIndex(0), InputPin::Io1}));
}

/// The same action, or the same module while no module is connected, resets nothing of the row.
TEST(SequenceModels, ChangeNothingIfWhatIsChosenIsChosenAgain) {
    Program program = twoPoints();
    program.points.push_back({"Place", {}});
    program.sequences[0].rows = {action::MoveTo{"Place", false, true, 20},
                                 action::WaitForInput{ModuleIndex(1), InputPin::Io3, false, 4.0}};
    RowsModel rows;
    rows.showRows(program, "Main", 2, {});
    QSignalSpy edits(&rows, &RowsModel::rowEdited);
    for (int row = 0; row < rows.rowCount(); ++row)
        for (int column = 0; column < RowsModel::ColumnCount; ++column) {
            const QModelIndex cell = rows.index(row, column);
            EXPECT_FALSE(rows.setData(cell, rows.data(cell, Qt::EditRole), Qt::EditRole))
                << "row " << row << ", column " << column;
        }
    EXPECT_EQ(edits.size(), 0);
}

/// Checks Qt's requirements of an item model, while programs change at random.
TEST(SequenceModels, KeepQtsDemands) {
    sim::Random random(7);
    RowsModel rows;
    PointsModel points;
    const QAbstractItemModelTester rowDemands(&rows, QAbstractItemModelTester::FailureReportingMode::Warning);
    const QAbstractItemModelTester pointDemands(&points,
                                                QAbstractItemModelTester::FailureReportingMode::Warning);
    Program program = twoPoints();
    const auto scale = [](ModuleIndex) { return AxisScale::servo({}, 1); };
    QObject::connect(&rows, &RowsModel::rowEdited, [&](int row, const Action& action) {
        program.sequences[0].rows[static_cast<std::size_t>(row)] = action;
    });
    std::size_t most = 0;
    for (int i = 0; i < 400; ++i) {
        std::vector<Action>& all = program.sequences[0].rows;
        switch (random.below(6)) {
            case 0:
                insertRow(program.sequences[0], random.below(all.size() + 1), rows.newRow());
                break;
            case 1:
                if (!all.empty())
                    removeRow(program.sequences[0], random.below(all.size()));
                break;
            case 2:
                if (all.size() > 1) {
                    const auto from = random.below(all.size());
                    std::ignore = moveRow(program.sequences[0], from, random.below(all.size()));
                }
                break;
            case 3:
                program.points.push_back({freeName(program.points, "P"), {}});
                break;
            case 4:
                if (program.points.size() > 2 && !userOfPoint(program, program.points.back().name))
                    program.points.pop_back();
                break;
            default:
                if (rows.rowCount() > 0) {
                    const auto cell =
                        rows.index(static_cast<int>(random.below(static_cast<std::size_t>(rows.rowCount()))),
                                   static_cast<int>(random.below(RowsModel::ColumnCount)));
                    const auto choices = cell.data(RowsModel::ChoicesRole).toStringList();
                    if (!choices.isEmpty())
                        rows.setData(cell,
                                     static_cast<int>(random.below(static_cast<std::size_t>(choices.size()))),
                                     Qt::EditRole);
                }
        }
        most = std::max(most, all.size());
        rows.showRows(program, "Main", 3);
        points.showPoints(program.points, scale);
        ASSERT_FALSE(contradiction(program)) << i;
        ASSERT_EQ(rows.rowCount(), static_cast<int>(all.size()));
        ASSERT_EQ(points.rowCount(), static_cast<int>(program.points.size()));
    }
    EXPECT_GT(most, 5U);
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// A user teaches points, makes a sequence of them and runs it, in the window; the simulator knows where the
// motor is.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class Sequences : public testing::Test {
protected:
    void begin() {
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.enable());
        panel.window().resize(1'500, 1'100);
        QTest::keyClick(panel.window().windowHandle(), Qt::Key_F3);
        ASSERT_TRUE(panel.waitFor([&] { return find<QWidget>("sequencesPage")->isVisible(); }));
    }
    template <typename T>
    T* find(const char* name) {
        auto* found = panel.window().findChild<T*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString state() { return find<QLabel>("sequenceStateLabel")->text(); }
    void teach(const QString& name) {
        panel.type("pointNameField", name);
        ASSERT_NO_FATAL_FAILURE(panel.click("teachButton"));
    }
    void doubleClick(int row, int column) {
        auto* table = find<QTableView>("rowTable");
        const QPoint at = table->visualRect(table->model()->index(row, column)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);  // the first click of the two
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
    }
    /// Chooses by a double click on the cell, the arrow keys and Enter.
    void choose(int row, int column, const QString& what) {
        auto* table = find<QTableView>("rowTable");
        doubleClick(row, column);
        auto* popup = [&]() -> QWidget* {
            std::ignore = panel.waitFor([] { return QApplication::activePopupWidget() != nullptr; });
            return QApplication::activePopupWidget();
        }();
        ASSERT_NE(popup, nullptr);
        auto* list = popup->findChild<QAbstractItemView*>();
        const QModelIndexList wanted =
            list->model()->match(list->model()->index(0, 0), Qt::DisplayRole, what, 1, Qt::MatchExactly);
        ASSERT_EQ(wanted.size(), 1) << what.toStdString();
        const int way = wanted.front().row() - list->currentIndex().row();
        for (int step = 0; step < std::abs(way); ++step)
            QTest::keyClick(list, way > 0 ? Qt::Key_Down : Qt::Key_Up);
        QTest::keyClick(list, Qt::Key_Return);
        ASSERT_TRUE(panel.waitFor([&] { return table->findChild<QWidget*>(u"rowChoiceBox"_s) == nullptr; }));
        EXPECT_EQ(table->model()->index(row, column).data().toString(), what);
    }
    void typeNumber(int row, const QString& text) {
        doubleClick(row, 3);
        auto* field = find<QLineEdit>("rowNumberField");
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        auto* table = find<QTableView>("rowTable");
        ASSERT_TRUE(
            panel.waitFor([&] { return table->findChild<QWidget*>(u"rowNumberField"_s) == nullptr; }));
    }
    void moveTo(std::int32_t position) {
        panel.ask(intent::Move{
            servomotion::Trapezoid{Counts(position), CountsPerTick(4 << 16), CountsPerTickSquared(1'311)}});
        ASSERT_TRUE(panel.waitFor([&] {
            return std::abs(*panel.module().latest->position - position) < 5 && !panel.module().moving();
        }));
    }
    /// Makes two points, and a sequence that goes back and forth between them.
    void makeSequence() {
        ASSERT_NO_FATAL_FAILURE(begin());
        ASSERT_NO_FATAL_FAILURE(teach(u"Pick"_s));
        ASSERT_NO_FATAL_FAILURE(moveTo(1'500));
        ASSERT_NO_FATAL_FAILURE(teach(u"Place"_s));
        ASSERT_NO_FATAL_FAILURE(panel.click("newSequenceButton"));
        for (int row = 0; row < 2; ++row)
            ASSERT_NO_FATAL_FAILURE(panel.click("addRowButton"));
        ASSERT_NO_FATAL_FAILURE(choose(1, 1, u"Place"_s));
    }
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
};

TEST_F(Sequences, TaughtMadeAndRun) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    const Program& program = panel.composition().machine().program;
    ASSERT_EQ(program.points.size(), 2U);
    EXPECT_NEAR(program.points[0].axes.at(0).counts, 0, 3);
    EXPECT_NEAR(program.points[1].axes.at(0).counts, 1'500, 5);
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    EXPECT_TRUE(state().startsWith(u"Running"_s)) << state().toStdString();
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Done"_s); })) << state().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 1'500, 5);
    EXPECT_EQ(panel.count(u"is done"_s), 1);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(Sequences, EscInTheMidstEndsItForGood) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    ASSERT_NO_FATAL_FAILURE(panel.click("addRowButton"));
    ASSERT_NO_FATAL_FAILURE(choose(2, 0, u"repeat"_s));
    ASSERT_NO_FATAL_FAILURE(typeNumber(2, u"0"_s));
    EXPECT_EQ(find<QTableView>("rowTable")->model()->index(2, 3).data().toString(), u"forever"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Ended"_s); })) << state().toStdString();
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    const int stood = sim.state(1)[u"position"_s].toInt();
    ASSERT_TRUE(panel.answersFor(1.5));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), stood, 4) << "no motion is waiting to start again";
    EXPECT_FALSE(find<QAbstractButton>("stopSequenceButton")->isEnabled());
    EXPECT_EQ(sim.violations(), "");
}

/// docs/link.md 2.7: it is reported from 1 s on, and stops the motors after 2 s.
TEST_F(Sequences, AFreezeThatStopsNothingEndsNoWait) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(teach(u"Pick"_s));
    ASSERT_NO_FATAL_FAILURE(moveTo(1'500));
    ASSERT_NO_FATAL_FAILURE(panel.click("newSequenceButton"));
    for (int row = 0; row < 2; ++row)
        ASSERT_NO_FATAL_FAILURE(panel.click("addRowButton"));
    ASSERT_NO_FATAL_FAILURE(choose(0, 0, u"wait"_s));
    ASSERT_NO_FATAL_FAILURE(typeNumber(0, u"5"_s));
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Running"_s); })) << state().toStdString();
    panel.freeze(std::chrono::milliseconds(1'200));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Done"_s); })) << state().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 5);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(Sequences, AFreezeThatStopsNothingEndsNoMove) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    panel.freeze(std::chrono::milliseconds(1'200));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Done"_s); })) << state().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 1'500, 5);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(Sequences, PausesBehindItsRowAndGoesOn) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_NO_FATAL_FAILURE(panel.click("pauseSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Paused before"_s); }));
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 5) << "it finished the row";
    EXPECT_EQ(find<QAbstractButton>("pauseSequenceButton")->text(), u"Continue"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("stepSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Done"_s); })) << state().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 1'500, 5);
}

TEST_F(Sequences, APanelsStopOfItsModuleEndsIt) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    panel.ask(intent::StopSmoothly{});
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Ended"_s); })) << state().toStdString();
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(panel.count(u"ended, and its motors"_s), 1);
    // From where the motor stands, only the first row can be run.
    find<QTableView>("rowTable")->selectRow(1);
    EXPECT_FALSE(find<QAbstractButton>("runFromRowButton")->isEnabled());
    EXPECT_TRUE(find<QAbstractButton>("runFromRowButton")->toolTip().contains(u"at point \"Pick\""_s))
        << find<QAbstractButton>("runFromRowButton")->toolTip().toStdString();
}

TEST_F(Sequences, EndsWithItsConnection) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    ASSERT_NO_FATAL_FAILURE(panel.click("runSequenceButton"));
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Ended"_s); })) << state().toStdString();
    EXPECT_FALSE(find<QAbstractButton>("stopSequenceButton")->isEnabled());
    EXPECT_EQ(panel.count(u"its motors were commanded to stop"_s), 0) << "nothing could be sent";
    sim.plugIn();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_FALSE(find<QAbstractButton>("runSequenceButton")->toolTip().contains(u"already running"_s));
}

TEST_F(Sequences, GoesToAPoint) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    auto* table = find<QTableView>("pointTable");
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualRect(table->model()->index(0, 0)).center());
    ASSERT_NO_FATAL_FAILURE(panel.click("goToPointButton"));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Done"_s); })) << state().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), 0, 5);
}

TEST_F(Sequences, ADryRunTellsAndMovesNothing) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    const int stood = sim.state(1)[u"position"_s].toInt();
    ASSERT_NO_FATAL_FAILURE(panel.click("dryRunButton"));
    const auto* label = find<QLabel>("dryRunLabel");
    ASSERT_TRUE(panel.waitFor([&] { return label->text().contains(u"done after"_s); }))
        << label->text().toStdString();
    EXPECT_TRUE(label->text().contains(u"moves: 2"_s)) << label->text().toStdString();
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), stood, 3);
}

TEST_F(Sequences, EditsAreUndone) {
    ASSERT_NO_FATAL_FAILURE(makeSequence());
    const Program made = panel.composition().machine().program;
    ASSERT_NO_FATAL_FAILURE(panel.click("removeRowButton"));
    EXPECT_EQ(panel.composition().machine().program.sequences[0].rows.size(), 1U);
    ASSERT_NO_FATAL_FAILURE(panel.click("undoEditButton"));
    EXPECT_EQ(panel.composition().machine().program, made);
    ASSERT_NO_FATAL_FAILURE(panel.click("redoEditButton"));
    EXPECT_EQ(panel.composition().machine().program.sequences[0].rows.size(), 1U);
    // Two points, a sequence, two rows, one edited row and one removed row.
    for (int edit = 0; edit < 7; ++edit)
        ASSERT_NO_FATAL_FAILURE(panel.click("undoEditButton"));
    EXPECT_FALSE(find<QAbstractButton>("undoEditButton")->isEnabled());
    EXPECT_EQ(panel.composition().machine().program, Program{});
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
// A whole first shift: a user who has never seen the panel sets up two axes and works with them until the
// evening, finding each control by the name that a screen reader says, in a window of 1280 x 800. What the
// motors did is checked with the simulator.
#include "tests/support/hand.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using testing_support::Hand;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using namespace Qt::StringLiterals;

class FirstShift : public testing::Test {
protected:
    void TearDown() override { texts::setModuleNames({}); }
    [[nodiscard]] double shaft(int module) { return sim.state(module)[u"position"_s].toDouble(); }
    /// True if it is at rest this many counts from home; these gains leave an error of a tenth of a
    /// millimetre.
    [[nodiscard]] bool standsAt(int place) {
        const auto& home = panel->module().home.place();
        return home && !moves(sim) && std::abs(shaft(1) - home->counts - place) <= 40;
    }
    QAbstractItemView* doubleClick(int row, int column) {
        auto* table = hand->find<QAbstractItemView>(u"Rows of the sequence"_s);
        const QPoint at = table->visualRect(table->model()->index(row, column)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, at);
        return table;
    }
    void chooseInRow(int row, int column, const QString& what) {
        auto* table = doubleClick(row, column);
        ASSERT_TRUE(panel->waitFor([] { return QApplication::activePopupWidget() != nullptr; }));
        auto* list = QApplication::activePopupWidget()->findChild<QAbstractItemView*>();
        QTest::keyClicks(list, what);
        QTest::keyClick(list, Qt::Key_Return);
        ASSERT_TRUE(panel->waitFor([] { return QApplication::activePopupWidget() == nullptr; }));
        ASSERT_TRUE(panel->waitFor([&] {
            return table->model()->index(row, column).data().toString() == what;
        })) << table->model()->index(row, column).data().toString().toStdString();
    }
    void typeInRow(int row, const QString& number) {
        auto* table = doubleClick(row, 3);
        auto* field = hand->find<QLineEdit>(u"Value of the row"_s);
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, number);
        QTest::keyClick(field, Qt::Key_Return);
        ASSERT_TRUE(
            panel->waitFor([&] { return table->findChild<QWidget*>(u"rowNumberField"_s) == nullptr; }));
    }
    void begin() {
        panel.emplace(settings, VirtualPanel::noAdapters(), folder.path());
        hand.emplace(*panel);
        panel->start();
        panel->window().resize(1'280, 800);
        ASSERT_NO_FATAL_FAILURE(panel->connectTo(sim.terminal()));
        ASSERT_TRUE(panel->waitFor([&] { return panel->module().latest.has_value(); }));
    }
    QTemporaryDir folder;
    const QString machine = folder.filePath(u"press.json"_s);
    const QString settings = folder.filePath(u"panel.ini"_s);
    VirtualChain sim{u"servo,servo"_s};
    std::optional<VirtualPanel> panel;
    std::optional<Hand> hand;
};

TEST_F(FirstShift, IsWorkedWhole) {
    for (const QString& line :
         {u"set 1 travel_min -700"_s, u"set 1 travel_max 30000"_s, u"set 1 limits auto"_s})
        std::ignore = sim.control(line);
    ASSERT_NO_FATAL_FAILURE(begin());

    // The unit, with the wizard: 500 lines are 2000 counts per turn, and a screw with a lead of 5 mm makes
    // that 400 counts per mm.
    ASSERT_NO_FATAL_FAILURE(hand->turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"Name of the axis"_s, u"X"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Calculate the unit"_s));
    ASSERT_NO_FATAL_FAILURE(hand->choose(u"rotary, in turns"_s, u"linear, in millimetres"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Use this unit"_s));
    EXPECT_EQ(panel->composition().machine().axes.at(0).unit.countsPerUnit, 400);

    // The direction check.
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Direction check"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Pulse motor"_s));
    ASSERT_TRUE(hand->reads(u"✓"_s));
    EXPECT_FALSE(sim.state(1)[u"servo_on"_s].toBool());

    // Starting values, and homing to the switch.
    ASSERT_NO_FATAL_FAILURE(hand->turnTo(u"Gains"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Starting values"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Apply gains"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Enable servo"_s));
    ASSERT_TRUE(panel->waitFor([&] { return panel->module().servoOn(); }));
    ASSERT_NO_FATAL_FAILURE(hand->turnTo(u"Homing"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Home: search"_s));
    ASSERT_TRUE(hand->reads(u"Done"_s));
    EXPECT_TRUE(panel->module().home.place().has_value());

    // Travel limits, in the new unit.
    ASSERT_NO_FATAL_FAILURE(hand->turnTo(u"Axis"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"Lowest position"_s, u"-1"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"Highest position"_s, u"50"_s));
    EXPECT_TRUE(
        panel->waitFor([&] { return panel->composition().machine().axes.at(0).travel.highest == 50 * 400; }));

    ASSERT_NO_FATAL_FAILURE(hand->type(u"Velocity of the move"_s, u"20"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"Acceleration"_s, u"100"_s));

    // Three points, taught where the motor stands; it is moved there in millimetres.
    hand->strike(Qt::Key_F3);
    ASSERT_NO_FATAL_FAILURE(hand->tick(u"Axes to teach"_s, u"Module 2"_s));
    for (const auto& [point, millimetres] : {std::pair{u"Load"_s, 5}, {u"Dip"_s, 15}, {u"Dry"_s, 25}}) {
        ASSERT_NO_FATAL_FAILURE(hand->type(u"Goal position"_s, QString::number(millimetres)));
        ASSERT_NO_FATAL_FAILURE(hand->click(u"Go to the position"_s));
        // What is taught is the position on display, which follows the motor a few frames later.
        ASSERT_TRUE(panel->waitFor([&, at = 400 * millimetres, frames = 0]() mutable {
            frames = standsAt(at) ? frames + 1 : 0;
            return frames > 10;
        })) << millimetres;
        ASSERT_NO_FATAL_FAILURE(hand->type(u"Name of the point to teach"_s, point));
        ASSERT_NO_FATAL_FAILURE(hand->click(u"Teach a point"_s));
    }
    ASSERT_EQ(panel->composition().machine().program.points.size(), 3U);

    // A sequence that goes to each of them, waits, and repeats all of it twice.
    ASSERT_NO_FATAL_FAILURE(hand->click(u"New sequence"_s));
    for (int row = 0; row < 5; ++row)
        ASSERT_NO_FATAL_FAILURE(hand->click(u"Add row"_s));
    ASSERT_NO_FATAL_FAILURE(chooseInRow(1, 1, u"Dip"_s));
    ASSERT_NO_FATAL_FAILURE(chooseInRow(2, 0, u"wait"_s));
    ASSERT_NO_FATAL_FAILURE(chooseInRow(3, 1, u"Dry"_s));
    ASSERT_NO_FATAL_FAILURE(chooseInRow(4, 0, u"repeat"_s));
    ASSERT_NO_FATAL_FAILURE(typeInRow(4, u"2"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Dry run"_s));
    ASSERT_TRUE(hand->reads(u"done after"_s));
    EXPECT_TRUE(standsAt(25 * 400)) << "a dry run moves nothing";

    // Run, pause, a single row, continue, and Esc in the middle.
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Run the sequence"_s));
    ASSERT_TRUE(panel->waitFor([&] { return moves(sim); }));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Pause the sequence"_s));
    ASSERT_TRUE(hand->reads(u"Paused before"_s));
    EXPECT_TRUE(standsAt(5 * 400)) << "it finished the row";
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Single step"_s));
    ASSERT_TRUE(panel->waitFor([&] { return standsAt(15 * 400); }));
    ASSERT_TRUE(hand->reads(u"Paused before"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Continue"_s));
    ASSERT_TRUE(panel->waitFor([&] { return moves(sim); }));
    hand->strike(Qt::Key_Escape);
    ASSERT_TRUE(hand->reads(u"Ended"_s));
    ASSERT_TRUE(panel->waitFor([&] { return !moves(sim); }));
    // A start would be taken back until the stop has ended.
    ASSERT_TRUE(panel->waitFor([&] { return panel->count(u"1 stopped and holding"_s) == 1; }));

    // It is run again from its first row to its end.
    hand->find<QAbstractItemView>(u"Rows of the sequence"_s)
        ->setCurrentIndex(hand->find<QAbstractItemView>(u"Rows of the sequence"_s)->model()->index(0, 0));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Run from row"_s));
    ASSERT_TRUE(panel->waitFor([&] { return moves(sim); }));
    ASSERT_TRUE(hand->reads(u"Done"_s));
    EXPECT_TRUE(standsAt(25 * 400));

    // All axes: a motion while a button is held.
    hand->strike(Qt::Key_F4);
    const double before = shaft(1);
    ASSERT_NO_FATAL_FAILURE(
        hand->hold(u"Hold to move Module 1 \"X\" forward"_s, [&] { return shaft(1) > before + 100; }));
    ASSERT_TRUE(panel->waitFor([&] { return !moves(sim); }));

    // The pendant: a motion while both keys are held.
    hand->strike(Qt::Key_F12);
    const double jogged = shaft(1);
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Shift);
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_Right, Qt::ShiftModifier);
    ASSERT_TRUE(panel->waitFor([&] { return shaft(1) > jogged + 50; }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Shift);
    ASSERT_TRUE(panel->waitFor([&] { return !moves(sim); }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_Right);
    hand->strike(Qt::Key_F12);

    // Into operator mode and out of it again.
    ASSERT_NO_FATAL_FAILURE(hand->fromMenu(u"Operator mode"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"PIN to leave"_s, u"a1b2"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"PIN again"_s, u"a1b2"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Enter operator mode"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Leave"_s));
    ASSERT_NO_FATAL_FAILURE(hand->type(u"PIN"_s, u"a1b2"_s));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Leave operator mode"_s));

    // Save, and quit while a motor runs.
    hand->strike(Qt::CTRL | Qt::Key_S);
    ASSERT_NO_FATAL_FAILURE(hand->chooseFile(machine));
    ASSERT_TRUE(panel->waitFor([&] { return QFile::exists(machine); }));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Run reverse"_s));
    ASSERT_TRUE(panel->waitFor([&] { return moves(sim); }));
    hand->strike(Qt::CTRL | Qt::Key_Q);
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Stop and close"_s));
    ASSERT_TRUE(panel->waitFor([&] { return !panel->window().isVisible(); }));
    EXPECT_FALSE(moves(sim));
    panel.reset();

    // The next morning: all power was off; the machine is opened, and home is restored.
    std::ignore = sim.control(u"power-cycle all"_s);
    ASSERT_NO_FATAL_FAILURE(begin());
    hand->strike(Qt::CTRL | Qt::Key_O);
    ASSERT_NO_FATAL_FAILURE(hand->chooseFile(machine));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Apply"_s));
    ASSERT_TRUE(panel->waitFor([&] {
        const auto& axes = panel->composition().machine().axes;
        return !axes.empty() && axes[0].name == "X";
    }));
    ASSERT_TRUE(panel->waitFor([&] { return panel->standing(u"from home when last seen"_s) != nullptr; }));
    ASSERT_TRUE(panel->press(u"from home when last seen"_s, u"Restore home"_s));
    EXPECT_TRUE(panel->module().home.place().has_value());
    EXPECT_EQ(panel->composition().machine().program.points.size(), 3U);

    // A recording is made and opened, and a picture of it is saved.
    ASSERT_NO_FATAL_FAILURE(hand->turnTo(u"Scope"_s));
    const QString recording = folder.filePath(u"shift.csv"_s);
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Record"_s));
    ASSERT_NO_FATAL_FAILURE(hand->chooseFile(recording));
    ASSERT_NO_FATAL_FAILURE(hand->click(u"Stop recording"_s));
    ASSERT_TRUE(panel->waitFor([&] { return panel->count(u"Recorded \"shift.csv\""_s) == 1; }));
    hand->strike(Qt::CTRL | Qt::SHIFT | Qt::Key_O);
    ASSERT_NO_FATAL_FAILURE(hand->chooseFile(recording));
    ASSERT_TRUE(hand->reads(u"shift.csv"_s));
    const QString picture = folder.filePath(u"shift.png"_s);
    ASSERT_NO_FATAL_FAILURE(hand->fromMenu(u"Picture (PNG)"_s));
    ASSERT_NO_FATAL_FAILURE(hand->chooseFile(picture));
    EXPECT_TRUE(panel->waitFor([&] { return !QImage(picture).isNull(); }));
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc

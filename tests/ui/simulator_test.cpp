// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/words.h"
#include "widgets/simulator/simulatordock.h"
#include "windowtest.h"

namespace nmc {
namespace {

QJsonObject servoState() {
    return {{u"module"_s, 1},
            {u"type"_s, u"servo"_s},
            {u"version"_s, 4},
            {u"addr_broken"_s, true},
            {u"position"_s, 1234},
            {u"shaft"_s, 1234.5},
            {u"position_error"_s, 16},
            {u"velocity"_s, 0.5},
            {u"pwm"_s, -20},
            {u"current"_s, 0.25},
            {u"analog"_s, 13},
            {u"analog_input"_s, QJsonValue::Null},
            {u"power"_s, true},
            {u"limit1"_s, true},
            {u"limit2"_s, false},
            {u"index"_s, false},
            {u"load"_s, -0.02},
            {u"inertia"_s, 1.7e-5},
            {u"friction"_s, 0.004},
            {u"travel_min"_s, -5000},
            {u"limits"_s, u"manual"_s},
            {u"travel_max"_s, QJsonValue::Null}};
}

QJsonObject stepState() {
    return {{u"module"_s, 2},
            {u"type"_s, u"step"_s},
            {u"version"_s, 1},
            {u"position"_s, 700},
            {u"shaft"_s, 700},
            {u"step_rate"_s, -400},
            {u"power"_s, true},
            {u"analog"_s, 255},
            {u"current_limit"_s, 100},
            {u"inputs"_s, QJsonObject{{u"estop"_s, true}, {u"home_switch"_s, true}, {u"in1"_s, false}}},
            {u"travel_min"_s, QJsonValue::Null},
            {u"travel_max"_s, 9000},
            {u"limits"_s, u"auto"_s},
            {u"home_switch_at"_s, 300}};
}

QJsonArray pins(std::initializer_list<int> set) {
    QJsonArray all;
    for (int pin = 1; pin <= 12; ++pin)
        all.append(std::find(set.begin(), set.end(), pin) != set.end());
    return all;
}

/// IO1 is an input that is high, IO2 one that is low, IO3 an output that is high.
QJsonObject ioState() {
    return {{u"module"_s, 1},
            {u"type"_s, u"io"_s},
            {u"version"_s, 1},
            {u"pins"_s, pins({1, 3})},
            {u"is_input"_s, pins({1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12})},
            {u"analog"_s, QJsonArray{10, 20, 30}},
            {u"pwm"_s, QJsonArray{100, 255}},
            {u"timer_mode"_s, u"counter"_s},
            {u"count"_s, 1234}};
}

class Simulator : public WindowTest {
protected:
    void attach(int modules = 2, std::uint32_t connection = 1) {
        std::vector<ModuleState> found;
        for (int i = 0; i < modules; ++i)
            found.push_back(Servo{.index = i}.state());
        LinkState link = connectedTo(std::move(found));
        link.port = "simulator";
        link.simulated = true;
        link.connection = connection;
        window->showLink(link);
    }
    QDockWidget* dock() { return find<QDockWidget>(u"simulatorDock"_s); }
    QAction* toggle() { return window->findChild<QAction*>(u"simulatorDockAction"_s); }

    /// Waits until the dock sends this query, and answers it.
    void answer(const QString& line, const QJsonObject& json) {
        ASSERT_TRUE(eventually([&] { return asked(line); })) << line.toStdString();
        lines.clear();
        window->simulator().showAnswer(line, QJsonDocument(json).toJson(QJsonDocument::Compact));
    }
    bool asked(const QString& line) {
        return std::any_of(lines.cbegin(), lines.cend(),
                           [&line](const QList<QVariant>& said) { return said.at(0).toString() == line; });
    }
    /// The last line that is not one of the dock's own queries.
    QString lastLine() {
        for (auto said = lines.crbegin(); said != lines.crend(); ++said)
            if (const QString line = said->at(0).toString(); !line.startsWith(u"sta"_s))
                return line;
        return {};
    }
    void toPage(const QString& bench, int page) { find<QTabWidget>(bench)->setCurrentIndex(page); }
    void press(const QString& objectName) { click(objectName); }
    /// Clicks the mark itself: a check box as wide as its row does not react everywhere.
    void tick(const QString& objectName) {
        QAbstractButton* box = button(objectName);
        QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
    }

    QSignalSpy lines{&window->simulator(), &SimulatorDock::lineEntered};
};

TEST_F(Simulator, IsThereOnlyWhileAttachedToTheSimulator) {
    EXPECT_FALSE(dock()->isVisible());
    EXPECT_FALSE(toggle()->isVisible());
    showServo();
    EXPECT_FALSE(dock()->isVisible()) << "it is a real port";
    EXPECT_FALSE(toggle()->isVisible());
    attach();
    EXPECT_TRUE(dock()->isVisible());
    EXPECT_TRUE(toggle()->isVisible());
    window->showLink({});
    EXPECT_FALSE(dock()->isVisible());
    EXPECT_FALSE(toggle()->isVisible());
    window->findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
    EXPECT_FALSE(dock()->isVisible());
}

TEST_F(Simulator, ClosedStaysClosedUntilTheUserOpensIt) {
    attach();
    dock()->close();
    window->showLink({});
    attach();
    EXPECT_FALSE(dock()->isVisible());
    MainWindow next(settings);
    next.show();
    LinkState link = connectedTo({Servo{}.state()});
    link.simulated = true;
    next.showLink(link);
    EXPECT_FALSE(next.findChild<QDockWidget*>(u"simulatorDock"_s)->isVisible())
        << "it also stays closed in the next session";
    toggle()->trigger();
    EXPECT_TRUE(dock()->isVisible());
    window->showLink({});
    attach();
    EXPECT_TRUE(dock()->isVisible());
}

TEST_F(Simulator, AsksNothingWhileNobodyLooks) {
    attach();
    dock()->close();
    QTimer reference;
    QSignalSpy chances(&reference, &QTimer::timeout);
    reference.start(200);
    lines.clear();
    ASSERT_TRUE(eventually([&] { return chances.size() >= 2; }));
    EXPECT_TRUE(lines.isEmpty());
}

TEST_F(Simulator, ShowsTheStateItIsTold) {
    attach();
    answer(u"state 1"_s, servoState());
    EXPECT_TRUE(button(u"sim_servo_powerBox"_s)->isChecked());
    EXPECT_TRUE(button(u"sim_servo_limit1Box"_s)->isChecked());
    EXPECT_FALSE(button(u"sim_servo_limit2Box"_s)->isChecked());
    EXPECT_TRUE(button(u"sim_servo_addressBrokenBox"_s)->isChecked());
    EXPECT_FALSE(button(u"sim_servo_analogBox"_s)->isChecked());
    EXPECT_EQ(field(u"sim_servo_loadField"_s)->value(), -0.02);
    EXPECT_EQ(find<QSlider>(u"sim_servo_loadSlider"_s)->value(), -4);
    EXPECT_EQ(field(u"sim_servo_inertiaField"_s)->value(), 17);
    EXPECT_EQ(field(u"sim_servo_frictionField"_s)->value(), 0.004);
    EXPECT_TRUE(button(u"sim_servo_travel_minBox"_s)->isChecked());
    EXPECT_EQ(field(u"sim_servo_travel_minField"_s)->value(), -5000);
    EXPECT_FALSE(button(u"sim_servo_travel_maxBox"_s)->isChecked());
    EXPECT_FALSE(field(u"sim_servo_travel_maxField"_s)->isEnabled());
    EXPECT_EQ(text(u"simTruth_shaft"_s), u"1\u202f234.5"_s);
    EXPECT_EQ(text(u"simTruth_position_error"_s), u"16"_s);
    EXPECT_EQ(text(u"simTruth_pwm"_s), u"\u221220"_s);
    EXPECT_TRUE(lastLine().isEmpty()) << "showing values sends nothing";
}

TEST_F(Simulator, AClickIsTheControlLineOfNmcsim) {
    attach();
    answer(u"state 1"_s, servoState());
    tick(u"sim_servo_limit2Box"_s);
    EXPECT_EQ(lastLine(), u"set 1 limit2 1"_s);
    tick(u"sim_servo_powerBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 power 0"_s);
    tick(u"sim_servo_addressBrokenBox"_s);
    EXPECT_EQ(lastLine(), u"mend 1"_s);
    tick(u"sim_servo_addressBrokenBox"_s);
    EXPECT_EQ(lastLine(), u"break 1"_s);
    press(u"sim_servo_powerCycleButton"_s);
    EXPECT_EQ(lastLine(), u"power-cycle 1"_s);
    press(u"sim_servo_powerCycleAllButton"_s);
    EXPECT_EQ(lastLine(), u"power-cycle all"_s);
    press(u"sim_servo_overrunButton"_s);
    EXPECT_EQ(lastLine(), u"set 1 servo_overrun 1"_s);
    press(u"sim_servo_analogBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 analog 13"_s) << "it starts with what the converter reads";
    press(u"sim_servo_analogBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 analog auto"_s);
}

TEST_F(Simulator, LoadsActWhenTheNumberIsFinished) {
    attach();
    answer(u"state 1"_s, servoState());
    toPage(u"sim_servo_bench"_s, 1);
    type(u"sim_servo_loadField"_s, u"0.05"_s);
    EXPECT_TRUE(lastLine().isEmpty()) << "an unfinished number is not sent";
    QTest::keyClick(field(u"sim_servo_loadField"_s), Qt::Key_Return);
    EXPECT_EQ(lastLine(), u"set 1 load 0.05"_s);
    QTest::keyClick(field(u"sim_servo_loadField"_s), Qt::Key_Up);
    EXPECT_EQ(lastLine(), u"set 1 load 0.055"_s);
    find<QSlider>(u"sim_servo_loadSlider"_s)->setValue(-3);
    EXPECT_EQ(lastLine(), u"set 1 load -0.015"_s);
    type(u"sim_servo_inertiaField"_s, u"34"_s);
    QTest::keyClick(field(u"sim_servo_inertiaField"_s), Qt::Key_Return);
    EXPECT_EQ(lastLine(), u"set 1 inertia 3.4e-05"_s);
    press(u"sim_servo_travel_maxBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 travel_max 11235"_s) << "five turns from the shaft";
    press(u"sim_servo_travel_minBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 travel_min none"_s);
    press(u"sim_servo_limitsBox"_s);
    EXPECT_EQ(lastLine(), u"set 1 limits auto"_s);
    lines.clear();
    type(u"sim_servo_frictionField"_s, u"101"_s);
    QTest::keyClick(field(u"sim_servo_frictionField"_s), Qt::Key_Return);
    EXPECT_TRUE(lastLine().isEmpty()) << "out of range";
}

TEST_F(Simulator, WhatIsBeingTypedIsLeftAlone) {
    attach();
    answer(u"state 1"_s, servoState());
    toPage(u"sim_servo_bench"_s, 1);
    type(u"sim_servo_loadField"_s, u"0.0"_s);
    answer(u"state 1"_s, servoState());
    EXPECT_EQ(field(u"sim_servo_loadField"_s)->text(), u"0.0"_s);
}

TEST_F(Simulator, AnAnswerFromBeforeTheClickDoesNotUndoIt) {
    attach();
    answer(u"state 1"_s, servoState());
    ASSERT_TRUE(eventually([&] { return asked(u"state 1"_s); }));
    tick(u"sim_servo_powerBox"_s);
    window->simulator().showAnswer(u"state 1"_s, QJsonDocument(servoState()).toJson());
    EXPECT_FALSE(button(u"sim_servo_powerBox"_s)->isChecked());
    lines.clear();
    answer(u"state 1"_s, servoState());
    EXPECT_TRUE(button(u"sim_servo_powerBox"_s)->isChecked()) << "the simulator's answer counts";
}

TEST_F(Simulator, AStepperHasItsOwnControls) {
    attach();
    answer(u"stats"_s, {{u"modules"_s, QJsonArray{1, 2, 3}}, {u"violation_count"_s, 0}});
    auto* modules = find<QComboBox>(u"simModuleBox"_s);
    EXPECT_EQ(modules->count(), 3) << "including modules that the panel did not find";
    modules->setCurrentIndex(1);
    answer(u"state 2"_s, stepState());
    EXPECT_TRUE(find(u"sim_step_bench"_s)->isVisible());
    EXPECT_FALSE(find(u"sim_servo_bench"_s)->isVisible());
    EXPECT_TRUE(button(u"sim_step_estopBox"_s)->isChecked());
    EXPECT_TRUE(button(u"sim_step_home_switchBox"_s)->isChecked());
    EXPECT_FALSE(button(u"sim_step_home_switchBox"_s)->isEnabled()) << "it stands at 300 counts";
    EXPECT_FALSE(button(u"sim_step_limit1Box"_s)->isEnabled()) << "the travel closes it";
    EXPECT_EQ(field(u"sim_step_home_switch_atField"_s)->value(), 300);
    EXPECT_EQ(field(u"sim_step_travel_maxField"_s)->value(), 9000);
    EXPECT_EQ(text(u"simTruth_step_rate"_s), u"\u2212400"_s);
    EXPECT_FALSE(find(u"simTruth_pwm"_s)->isVisible());
    tick(u"sim_step_in1Box"_s);
    EXPECT_EQ(lastLine(), u"set 2 in1 1"_s);
    toPage(u"sim_step_bench"_s, 1);
    press(u"sim_step_home_switch_atBox"_s);
    EXPECT_EQ(lastLine(), u"set 2 home_switch_at none"_s);
}

TEST_F(Simulator, FollowsTheListOfModules) {
    attach();
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_EQ(find<QComboBox>(u"simModuleBox"_s)->currentIndex(), 1);
    tick(u"sim_servo_limit1Box"_s);
    EXPECT_EQ(lastLine(), u"set 2 limit1 1"_s);
    find<QComboBox>(u"simModuleBox"_s)->setCurrentIndex(0);
    attach();
    EXPECT_EQ(find<QComboBox>(u"simModuleBox"_s)->currentIndex(), 0) << "its own selection stays";
}

TEST_F(Simulator, TheModulesHaveTheirPresentNames) {
    attach();
    EXPECT_EQ(find<QComboBox>(u"simModuleBox"_s)->itemText(1), u"Module 2"_s);
    machine.axes.resize(2);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    EXPECT_EQ(find<QComboBox>(u"simModuleBox"_s)->itemText(1), u"Module 2 \"Z axis\""_s);
}

TEST_F(Simulator, ViolationsAreCounted) {
    attach();
    answer(u"stats"_s, {{u"modules"_s, QJsonArray{1, 2}},
                        {u"violation_count"_s, 1},
                        {u"violations"_s, QJsonArray{QJsonObject{{u"time"_s, 1.5},
                                                                 {u"module"_s, 2},
                                                                 {u"kind"_s, u"unknown_command"_s},
                                                                 {u"bytes"_s, u"AA 02 0D 0F"_s}}}}});
    EXPECT_EQ(text(u"simViolations"_s), u"1"_s);
    EXPECT_TRUE(find(u"simViolations"_s)->toolTip().contains(u"unknown_command"_s));
}

/// One that is opened as soon as the last one has closed is not seen disconnected in between.
TEST_F(Simulator, AnotherConnectionBeginsWithNothingKnown) {
    attach();
    answer(u"stats"_s,
           {{u"modules"_s, QJsonArray{1, 2}}, {u"violation_count"_s, 1}, {u"violations"_s, QJsonArray{}}});
    EXPECT_EQ(text(u"simViolations"_s), u"1"_s);
    attach(2, 2);
    EXPECT_EQ(text(u"simViolations"_s), u"–"_s);
}

TEST_F(Simulator, ATypedLineGetsItsAnswerWhole) {
    attach();
    auto* edit = find<QLineEdit>(u"simLineEdit"_s);
    edit->setFocus();
    QTest::keyClicks(edit, u"  faults "_s);
    QTest::keyClick(edit, Qt::Key_Return);
    EXPECT_EQ(lastLine(), u"faults"_s);
    window->simulator().showAnswer(u"faults"_s, R"({"faults":[],"seed":12345678901234567890})");
    EXPECT_EQ(text(u"simAnswerHead"_s), u"Answer to: faults"_s);
    EXPECT_TRUE(find<QPlainTextEdit>(u"simAnswer"_s)->toPlainText().contains(u"12345678901234567890"_s));
    edit->setText(u"break 1"_s);
    QTest::keyClick(edit, Qt::Key_Return);
    window->simulator().showAnswer(u"break 1"_s, R"({"ok":true})");
    EXPECT_EQ(text(u"simAnswerHead"_s), u"Done: break 1"_s);
}

TEST_F(Simulator, ARefusalIsShownWhole) {
    attach();
    tick(u"sim_servo_limit1Box"_s);
    window->simulator().showAnswer(u"set 1 limit1 1"_s, R"({"error":"the limits follow the travel"})");
    EXPECT_EQ(text(u"simAnswerHead"_s), u"Failed: set 1 limit1 1"_s);
    EXPECT_EQ(find<QPlainTextEdit>(u"simAnswer"_s)->toPlainText(), u"the limits follow the travel"_s);
}

TEST_F(Simulator, EscStopsFromTheControlLineToo) {
    attach();
    QSignalSpy stops(window.get(), &MainWindow::stopAllRequested);
    QTest::keyClick(find<QLineEdit>(u"simLineEdit"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
}

TEST_F(Simulator, APicIoHasABenchOfItsOwn) {
    attach();
    answer(u"state 1"_s, ioState());
    ASSERT_TRUE(find<QTabWidget>(u"sim_io_bench"_s)->isVisible());
    EXPECT_TRUE(button(u"sim_io_pin1Box"_s)->isChecked());
    EXPECT_FALSE(button(u"sim_io_pin2Box"_s)->isChecked());
    EXPECT_TRUE(button(u"sim_io_pin3Box"_s)->isChecked());
    EXPECT_FALSE(button(u"sim_io_pin3Box"_s)->isEnabled()) << "an output is set by the module";
    EXPECT_EQ(find<QLabel>(u"sim_io_pwm"_s)->text(), u"100 and 255"_s);
    EXPECT_EQ(find<QLabel>(u"sim_io_count"_s)->text(), u"counter, "_s + texts::grouped(1'234));
    tick(u"sim_io_pin2Box"_s);
    EXPECT_EQ(lastLine(), u"set 1 in 2 1"_s);
    tick(u"sim_io_pin1Box"_s);
    EXPECT_EQ(lastLine(), u"set 1 in 1 0"_s);
    auto* field = find<QLineEdit>(u"sim_io_analog2Field"_s);
    EXPECT_EQ(field->text(), u"20"_s);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, u"200"_s);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(lastLine(), u"set 1 analog 2 200"_s);
    EXPECT_FALSE(find<QLabel>(u"simTruth_analog"_s)->isVisible()) << "it has three of them";
}

}  // namespace
}  // namespace nmc

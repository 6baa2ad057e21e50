// SPDX-License-Identifier: GPL-3.0-or-later
#include "responserecords.h"
#include "tests/support/choosefile.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/response/responsedock.h"
#include "widgets/response/responseplot.h"

namespace nmc {
namespace {

/// A motor that is at 90 of 100 counts after 10 ms, and at its goal after 30 ms.
KeptResponse inTwoStages() {
    KeptResponse kept = ramp();
    for (ResponsePoint& point : kept.run.points)
        if (point.seconds > 0.0005)
            point.position = point.seconds < 0.0095 ? 500 : point.seconds < 0.0295 ? 590 : 600;
    judge(kept.run, kFirstBand);
    return kept;
}

class Responses : public WindowTest {
protected:
    /// Shows a servo that holds its position if it is on.
    void showServo(Servo servo = {}) {
        servo.held = servo.on;
        WindowTest::showServo(servo);
    }
    void open() {
        window->findChild<QAction*>(u"responseDockAction"_s)->trigger();
        ASSERT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    }
    void openWith(const Servo& servo = {}) {
        showServo(servo);
        open();
    }
    /// Shows a servo whose settings were changed by `change`.
    template <typename Change>
    void showChanged(Change change) {
        ModuleState module = Servo{.held = true}.state();
        change(module);
        window->showLink(connectedTo({module}));
    }
    void report(ProcedureStage stage, std::optional<ProcedureFailure> failure = {}) {
        ProcedureReport r;
        r.kind = ProcedureKind::StepResponse;
        r.stage = stage;
        r.failure = failure;
        window->showProcedure(r);
    }
    QString reason(const QString& control) {
        EXPECT_FALSE(button(control)->isEnabled()) << control.toStdString();
        EXPECT_EQ(button(control)->toolTip(), button(control)->accessibleDescription());
        return button(control)->toolTip();
    }
    intent::StepResponse wanted() {
        EXPECT_EQ(intents.size(), 1);
        return std::get<intent::StepResponse>(intents.takeFirst().at(1).value<Intent>());
    }
    QTableWidget* table() { return find<QTableWidget>(u"responseRunTable"_s); }
    QString listed(int row, int column) { return table()->item(row, column)->text(); }
    /// The visible rows of the results: some rows are only for moves, others only for steps.
    std::vector<int> resultRows() {
        auto* results = find<QTableWidget>(u"responseResults"_s);
        std::vector<int> rows;
        for (int row = 0; row < results->rowCount(); ++row)
            if (!results->isRowHidden(row))
                rows.push_back(row);
        return rows;
    }
    QString result(int row, int column = 0) {
        return find<QTableWidget>(u"responseResults"_s)
            ->item(resultRows().at(static_cast<std::size_t>(row)), column)
            ->text();
    }
    QString results(int column) {
        QStringList cells;
        for (int row = 0; row < static_cast<int>(resultRows().size()); ++row)
            cells << result(row, column);
        return cells.join(u" | "_s);
    }
    /// Toggles a mark with the space bar.
    void tick(int row, int column) {
        table()->setFocus();
        table()->setCurrentCell(row, column);
        QTest::keyClick(table(), Qt::Key_Space);
    }
    [[nodiscard]] bool ticked(int row, int column) {
        return table()->item(row, column)->checkState() == Qt::Checked;
    }

    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(Responses, AreBehindF9AndBuiltWhenTheyAreSeen) {
    QAction* toggle = window->findChild<QAction*>(u"responseDockAction"_s);
    ASSERT_NE(toggle, nullptr);
    EXPECT_EQ(toggle->shortcut(), QKeySequence(Qt::Key_F9));
    EXPECT_EQ(window->findChild<QWidget*>(u"responsePage"_s), nullptr);
    toggle->trigger();
    EXPECT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    EXPECT_TRUE(find(u"scopePanel"_s)->visibleRegion().isEmpty()) << "it lies in front of the scope";
    window->findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
    EXPECT_FALSE(find(u"responseDock"_s)->isVisible());
}

TEST_F(Responses, OpenFromTheGainsPage) {
    showServo();
    click(u"openStepResponseButton"_s);
    EXPECT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    EXPECT_TRUE(button(u"responseButton"_s)->isEnabled()) << "it knows the module that was shown earlier";
}

TEST_F(Responses, TakeRoomFromTheMessagesBesideThem) {
    const int before = find(u"messagesDock"_s)->width();
    openWith();
    EXPECT_TRUE(eventually([&] { return find(u"messagesDock"_s)->width() < before; }));
    EXPECT_GT(find(u"messagesDock"_s)->width(), 150);
}

TEST_F(Responses, TheStepIsWhatStandsInTheFields) {
    openWith();
    click(u"responseButton"_s);
    const auto first = wanted();
    EXPECT_EQ(first.counts, 100);
    EXPECT_EQ(first.method, ResponseMethod::Profile);
    EXPECT_EQ(first.record, 0.5);
    type(u"responseDistanceField"_s, u"-250"_s);
    type(u"responseRecordField"_s, u"1,25"_s);
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(1);
    click(u"responseButton"_s);
    const auto second = wanted();
    EXPECT_EQ(second.counts, -250);
    EXPECT_EQ(second.method, ResponseMethod::StopHere);
    EXPECT_EQ(second.record, 1.25);
}

TEST_F(Responses, WhatTheShortcutMovesComesInSight) {
    openWith();
    QTest::keyClick(window.get(), Qt::Key_F9, Qt::ShiftModifier);
    EXPECT_EQ(intents.size(), 1);
    find<QDockWidget>(u"scopeDock"_s)->raise();
    ASSERT_TRUE(eventually([this] { return button(u"responseButton"_s)->visibleRegion().isEmpty(); }));
    QTest::keyClick(window.get(), Qt::Key_F9, Qt::ShiftModifier);
    EXPECT_EQ(intents.size(), 2);
    EXPECT_TRUE(eventually([this] { return !button(u"responseButton"_s)->visibleRegion().isEmpty(); }));
}

/// It settles within 10 ms, in a record of 100 ms.
TEST_F(Responses, ThePlotShowsTheTransientOrByADoubleClickAll) {
    openWith();
    window->stepResponses().showRun(ramp());
    auto* plot = find<ResponsePlot>(u"responsePlot"_s);
    const auto place = [plot](double seconds) {
        return plot->geometryShown().at(seconds, 0).x() / plot->width();
    };
    EXPECT_GT(place(0.018), 0.8);
    QTest::mouseDClick(plot, Qt::LeftButton);
    EXPECT_LT(place(0.018), 0.5);
    EXPECT_LT(place(0.1), 1.0);
    QTest::mouseDClick(plot, Qt::LeftButton);
    EXPECT_GT(place(0.018), 0.8);
}

TEST_F(Responses, AllRunsAreLaidBelowWhenThatIsTicked) {
    openWith();
    for (const double there : {100.0, 100.0, 140.0})
        window->stepResponses().showRun(ramp(there));
    tick(1, 0);
    auto* plot = find<ResponsePlot>(u"responsePlot"_s);
    const QImage two = plot->grab().toImage();
    QAbstractButton* all = button(u"responseAllRunsBox"_s);
    QTest::mouseClick(all, Qt::LeftButton, {}, {all->height() / 2, all->height() / 2});
    EXPECT_NE(plot->grab().toImage(), two);
    QTest::mouseClick(all, Qt::LeftButton, {}, {all->height() / 2, all->height() / 2});
    EXPECT_EQ(plot->grab().toImage(), two);
}

TEST_F(Responses, TheDistanceIsInTheUnitOfTheAxis) {
    openWith();
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 50.0, {}};
    window->showMachine(machine);
    EXPECT_EQ(field(u"responseDistanceField"_s)->value(), 2);
    EXPECT_EQ(text(u"responseDistanceFieldUnit"_s), u"mm"_s);
    type(u"responseDistanceField"_s, u"0.5"_s);
    click(u"responseButton"_s);
    EXPECT_EQ(wanted().counts, 25);
}

TEST_F(Responses, SayWhyNot) {
    openWith({.on = false});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::ServoOff));
    EXPECT_EQ(text(u"responseState"_s), texts::refusal(Refusal::ServoOff)) << "not only in the tool tip";
    showServo({.gains = false});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::GainsUnknown));
    showServo({.moveDone = false});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::Moving));
    showChanged([](ModuleState& module) { module.gains->el = 100; });
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::StepWouldTrip));
    showServo({.position = 0x7FFF'FFFF});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::GoalOutOfRange));
    showServo();
    type(u"responseDistanceField"_s, u"0"_s);
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::StepTooShort));
    for (const auto& [name, value] :
         {std::pair{u"responseDistanceField"_s, u"2001"_s}, std::pair{u"responseRecordField"_s, u"3.5"_s}}) {
        const QString before = field(name)->text();
        type(name, value);
        EXPECT_EQ(reason(u"responseButton"_s), field(name)->problemText());
        EXPECT_TRUE(field(name)->problemText().contains(u"must be"_s));
        type(name, before);
        type(u"responseDistanceField"_s, u"100"_s);
    }
    EXPECT_TRUE(button(u"responseButton"_s)->isEnabled());
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(1);
    showServo({.version = 1});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::VersionLacksIt));
    window->showLink({});
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::NotConnected));
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Responses, OfferToHoldWhereThePositionHeldIsNotKnown) {
    WindowTest::showServo({.position = 40});
    open();
    EXPECT_EQ(reason(u"responseButton"_s), texts::refusal(Refusal::CommandUnknown));
    const QPoint place = button(u"responseButton"_s)->pos();
    click(u"responseHoldButton"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::StopHere>(intents.takeFirst().at(1).value<Intent>()));
    showServo({.position = 40});
    EXPECT_FALSE(button(u"responseHoldButton"_s)->isVisible());
    EXPECT_EQ(button(u"responseButton"_s)->pos(), place);
    click(u"responseButton"_s);
    EXPECT_EQ(wanted().counts, 100);
}

TEST_F(Responses, AreMadeOneAtATime) {
    openWith();
    report(ProcedureStage::Moving);
    EXPECT_FALSE(reason(u"responseButton"_s).isEmpty());
    EXPECT_EQ(text(u"responseState"_s), u"Moving"_s);
    report(ProcedureStage::Failed, ProcedureFailure::TravelLimit);
    EXPECT_TRUE(text(u"responseState"_s).startsWith(u"The motor moved farther than the test allows"_s));
    EXPECT_TRUE(button(u"responseButton"_s)->isEnabled());
    report(ProcedureStage::Done);
    EXPECT_TRUE(text(u"responseState"_s).isEmpty());
}

TEST_F(Responses, TellWhatARunComesTo) {
    openWith();
    window->stepResponses().showRun(ramp(120));
    EXPECT_EQ(result(0), u"1"_s);
    // 120 counts in 10 ms: from 10 to 90 counts in 6.67 ms, known to one sample and the ticks of both ends.
    EXPECT_TRUE(result(1).startsWith(u"6.7 ± 1.6 ms"_s)) << result(1).toStdString();
    // The parabola through 108, 120 and 120 is 1.5 above them; that and half a count is the doubt.
    EXPECT_EQ(result(2), u"21.5 ± 2.0 %"_s);
    EXPECT_EQ(result(3), u"not recorded"_s);
    // 117.5 of 120 counts, at 12 a millisecond; known to half a sample and two half ticks.
    EXPECT_EQ(result(4), u"9.8 ± 1.1 ms"_s);
    EXPECT_EQ(listed(0, 10), u"9.8 ± 1.1 ms, off its goal"_s);
    EXPECT_EQ(result(5), u"\u221220.0 ± 0.5 counts"_s);
    EXPECT_EQ(result(6), u"unknown"_s) << "the error before the step is unknown";
    EXPECT_EQ(result(7), u"1 ms"_s);
    EXPECT_EQ(result(1, 1), u"–"_s) << "there is no B";
    KeptResponse limited = ramp();
    limited.run.pwm = PwmDemand{429, 255};
    window->stepResponses().showRun(limited);
    EXPECT_EQ(result(6), u"limited to 255"_s);
    limited.run.pwm = PwmDemand{23, 255};
    window->stepResponses().showRun(limited);
    EXPECT_EQ(result(6), u"at least 23"_s);
}

TEST_F(Responses, ANewRunIsComparedWithTheOneBefore) {
    openWith();
    window->stepResponses().showRun(ramp(100));
    EXPECT_TRUE(ticked(0, 0));
    EXPECT_EQ(result(0, 1), u"–"_s);
    window->stepResponses().showRun(ramp(110));
    EXPECT_EQ(listed(0, 2), u"2"_s) << "newest first";
    EXPECT_TRUE(ticked(0, 0) && !ticked(0, 1));
    EXPECT_TRUE(!ticked(1, 0) && ticked(1, 1));
    window->stepResponses().showRun(ramp(120));
    EXPECT_EQ(result(0, 0), u"3"_s);
    EXPECT_EQ(result(0, 1), u"1"_s) << "the run to compare with stays";
    EXPECT_EQ(result(2, 0), u"21.5 ± 2.0 %"_s);
    EXPECT_TRUE(result(2, 1).startsWith(u"1."_s)) << "10 counts in the last ms: the parabola adds 1.25";
    const QDateTime started = QDateTime::fromString(u"2026-11-21T21:21:02.123+01:00"_s, Qt::ISODateWithMs);
    EXPECT_EQ(listed(0, 5), QLocale().toString(started, QLocale::ShortFormat)) << "it was not taken today";
    EXPECT_EQ(listed(0, 6), u"100"_s);
    EXPECT_EQ(listed(0, 7), u"1000"_s);
    EXPECT_EQ(listed(0, 9), u"21.5 ± 2.0 %"_s);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Responses, TheBoxesSayWhichTwoAreDrawn) {
    openWith();
    for (const double there : {100, 110, 120})
        window->stepResponses().showRun(ramp(there));
    tick(1, 0);
    EXPECT_EQ(result(0, 0), u"2"_s);
    EXPECT_FALSE(ticked(0, 0)) << "there is only one A";
    tick(0, 1);
    EXPECT_EQ(result(0, 1), u"3"_s);
    auto* plot = find<ResponsePlot>(u"responsePlot"_s);
    EXPECT_TRUE(plot->legendText(0).startsWith(u"A: run 2"_s)) << plot->legendText(0).toStdString();
    EXPECT_TRUE(plot->legendText(1).startsWith(u"B: run 3"_s));
    tick(0, 1);
    EXPECT_EQ(result(0, 1), u"–"_s);
    tick(1, 0);
    EXPECT_EQ(result(0, 0), u"–"_s);
    EXPECT_TRUE(plot->legendText(0).isEmpty());
}

TEST_F(Responses, AnotherBandJudgesAllRunsAnew) {
    openWith();
    type(u"responseBandField"_s, u"20"_s);
    window->stepResponses().showRun(inTwoStages());
    EXPECT_TRUE(result(3).startsWith(u"9"_s) || result(3).startsWith(u"10"_s)) << result(3).toStdString();
    type(u"responseBandField"_s, u"5"_s);
    EXPECT_TRUE(result(3).startsWith(u"29"_s) || result(3).startsWith(u"30"_s)) << result(3).toStdString();
    EXPECT_EQ(listed(0, 10), result(3));
    type(u"responseBandField"_s, u"80"_s);
    EXPECT_EQ(listed(0, 10), result(3)) << "8 was applied while typing, 80 is out of range";
    EXPECT_FALSE(field(u"responseBandField"_s)->problemText().isEmpty());
}

TEST_F(Responses, GainsGoBackIntoTheFieldsUnsent) {
    openWith();
    KeptResponse run = ramp();
    run.run.taken.gains.kp = 77;
    run.run.taken.gains.kd = 770;
    window->stepResponses().showRun(run);
    EXPECT_EQ(reason(u"responseUseGainsButton"_s), u"Select a run in the list first."_s);
    table()->setCurrentCell(0, 2);
    find<QTabWidget>(u"servoPages"_s)->setCurrentIndex(2);
    click(u"responseUseGainsButton"_s);
    EXPECT_TRUE(find(u"gainsBox"_s)->isVisible());
    EXPECT_EQ(field(u"kpField"_s)->value(), 77);
    EXPECT_EQ(field(u"kdField"_s)->value(), 770);
    EXPECT_EQ(text(u"kpState"_s), u"● not sent"_s);
    EXPECT_EQ(text(u"elState"_s), u"✓ sent"_s) << "the run had the same";
    EXPECT_EQ(intents.size(), 0);
    click(u"undoGainsButton"_s);
    EXPECT_EQ(field(u"kpField"_s)->value(), 100);
    EXPECT_EQ(field(u"kdField"_s)->value(), 1000);
}

TEST_F(Responses, GainsAreForTheModuleOfTheRun) {
    showServos({{.held = true}, {.held = true}});
    open();
    window->stepResponses().showRun(ramp(100, 1));
    table()->setCurrentCell(0, 2);
    EXPECT_EQ(reason(u"responseUseGainsButton"_s),
              u"This run belongs to Module 2. Select that module first."_s);
    auto* chain = find<QAbstractItemView>(u"chainList"_s);
    chain->setCurrentIndex(chain->model()->index(1, 0));
    EXPECT_TRUE(button(u"responseUseGainsButton"_s)->isEnabled());
}

TEST_F(Responses, RemoveTakesARunOffTheList) {
    openWith();
    EXPECT_FALSE(reason(u"responseRemoveButton"_s).isEmpty());
    EXPECT_FALSE(reason(u"responseExportButton"_s).isEmpty());
    window->stepResponses().showRun(ramp(100));
    window->stepResponses().showRun(ramp(110));
    table()->setCurrentCell(0, 2);
    click(u"responseRemoveButton"_s);
    ASSERT_EQ(table()->rowCount(), 1);
    EXPECT_EQ(listed(0, 2), u"1"_s);
    EXPECT_EQ(result(0, 0), u"–"_s);
    EXPECT_EQ(result(0, 1), u"1"_s);
    window->stepResponses().showRun(ramp(110));
    EXPECT_EQ(listed(0, 2), u"3"_s) << "a number stands for one run";
}

TEST_F(Responses, WhatWasRemovedCanBePutBack) {
    openWith();
    EXPECT_EQ(reason(u"responsePutBackButton"_s), u"No run was removed."_s);
    for (const double there : {100, 110, 120})
        window->stepResponses().showRun(ramp(there));
    for (const int row : {1, 1}) {  // 2, then 1
        table()->setCurrentCell(row, 2);
        click(u"responseRemoveButton"_s);
        EXPECT_FALSE(button(u"responseRemoveButton"_s)->isEnabled())
            << "the next run was not selected by the user";
    }
    ASSERT_EQ(table()->rowCount(), 1);
    click(u"responsePutBackButton"_s);
    ASSERT_EQ(table()->rowCount(), 2);
    EXPECT_EQ(listed(1, 2), u"1"_s) << "the last one removed comes back first";
    QTest::keyClick(window.get(), Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(table()->rowCount(), 3);
    EXPECT_EQ(listed(1, 2), u"2"_s) << "it is back in its place";
    EXPECT_FALSE(button(u"responsePutBackButton"_s)->isEnabled());
}

TEST_F(Responses, ARunCanHaveANameAndANote) {
    openWith();
    window->stepResponses().showRun(ramp(100));
    window->stepResponses().showRun(ramp(110));
    QSignalSpy changes(&window->requests(), &Requests::storeRuns);
    const auto write = [this](int row, int column, const QString& words) {
        table()->setFocus();
        table()->setCurrentCell(row, column);
        QTest::keyClick(table(), Qt::Key_F2);
        const auto editors = table()->findChildren<QLineEdit*>();
        ASSERT_FALSE(editors.empty());
        QTest::keyClicks(editors.back(), words);
        QTest::keyClick(editors.back(), Qt::Key_Return);
        EXPECT_TRUE(eventually([&] { return listed(row, column) == words; }));
    };
    write(0, 3, u"stiffer"_s);
    write(1, 11, u"belt slack"_s);
    EXPECT_EQ(changes.size(), 2);
    const auto& runs = find<ResponsePage>(u"responsePage"_s)->runs();
    EXPECT_EQ(runs[1].name, "stiffer");
    EXPECT_EQ(runs[0].note, "belt slack");
    EXPECT_TRUE(find<ResponsePlot>(u"responsePlot"_s)->legendText(0).startsWith(u"A: run 2 \"stiffer\""_s));
    EXPECT_EQ(intents.size(), 0);
}

/// The row moves down by one while the user types in it.
TEST_F(Responses, ANewRunDoesNotTakeTheNameThatIsBeingWritten) {
    openWith();
    window->stepResponses().showRun(ramp(100));
    table()->setFocus();
    table()->setCurrentCell(0, 3);
    QTest::keyClick(table(), Qt::Key_F2);
    auto* editor = table()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, u"so"_s);
    window->stepResponses().showRun(ramp(110));
    QTest::keyClicks(editor, u"ft"_s);
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_TRUE(eventually([&] { return listed(1, 3) == u"soft"_s; }));
    EXPECT_EQ(listed(0, 3), u""_s);
}

/// The file is read when a run has already been made.
TEST_F(Responses, KeptRunsComeBelowThoseThatAreThere) {
    openWith();
    window->stepResponses().showRun(ramp(110));
    std::vector<KeptResponse> kept{ramp(100), ramp(120)};
    kept[0].number = 1;
    kept[0].name = "old";
    kept[1].number = 5;
    for (KeptResponse& run : kept)
        run.earlier = true;
    QSignalSpy changes(&window->requests(), &Requests::storeRuns);
    window->stepResponses().showKept(kept);
    EXPECT_EQ(changes.size(), 0) << "they are already in the file";
    ASSERT_EQ(table()->rowCount(), 3);
    EXPECT_EQ(listed(0, 2), u"6"_s);
    EXPECT_TRUE(ticked(0, 0)) << "it is still A";
    EXPECT_EQ(result(0, 0), u"6"_s);
    EXPECT_EQ(listed(2, 3), u"old"_s);
    table()->setCurrentCell(2, 2);
    EXPECT_TRUE(button(u"responseUseGainsButton"_s)->isEnabled());
    window->stepResponses().clearRuns();
    EXPECT_EQ(table()->rowCount(), 0);
    EXPECT_EQ(result(0, 0), u"–"_s);
}

TEST_F(Responses, TheListKeepsTheLastHundredAndWhatIsShown) {
    openWith();
    for (int i = 0; i < 103; ++i)
        window->stepResponses().showRun(ramp());
    ASSERT_EQ(table()->rowCount(), 100);
    EXPECT_EQ(listed(0, 2), u"103"_s);
    EXPECT_EQ(listed(98, 2), u"5"_s);
    EXPECT_EQ(listed(99, 2), u"1"_s) << "it is B";
}

TEST_F(Responses, APictureIsAsOnPaperAndSaysThatItIsSimulated) {
    openWith();
    window->stepResponses().showRun(ramp(120));
    const auto saved = [this] {
        QSignalSpy saves(&window->requests(), &Requests::save);
        window->findChild<QAction*>(u"responseSvgAction"_s)->trigger();
        auto* dialog = find<QFileDialog>(u"responsePicturesvgDialog"_s);
        testing_support::chooseFile(*dialog, u"/home/anna/step.svg"_s);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return saves.value(0).value(1).value<FileContent>()();
    };
    const std::string svg = saved();
    EXPECT_NE(svg.find("SIMULATOR, no real motor moved"), std::string::npos);
    window->setPalette(darkPalette());
    EXPECT_TRUE(saved() == svg);
    EXPECT_TRUE(look::isDark(find(u"responsePlot"_s)->palette())) << "the screen stays as it was";
}

TEST_F(Responses, ExportIsReadableWhateverTheLocale) {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    openWith();
    KeptResponse run = ramp(120);
    run.moduleName = "Left, \"arm\"\nof it";
    window->stepResponses().showRun(run);
    click(u"responseExportButton"_s);
    auto* dialog = find<QFileDialog>(u"responseRunsDialog"_s);
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->isModal());
    QSignalSpy saves(&window->requests(), &Requests::save);
    testing_support::chooseFile(*dialog, u"/home/anna/runs.csv"_s);
    ASSERT_EQ(saves.size(), 1);
    EXPECT_EQ(saves[0][0].toString(), u"/home/anna/runs.csv"_s);
    const std::string content = saves[0][1].value<FileContent>()();
    QLocale::setDefault(QLocale::c());
    const QStringList lines = QString::fromStdString(content).split(u'\n');
    EXPECT_TRUE(lines.contains(u"# run 1 simulated: yes (no real motor moved)"_s));
    EXPECT_TRUE(lines.contains(u"# run 1 started: 2026-11-21T21:21:02.123+01:00"_s));
    EXPECT_TRUE(lines.contains(u"# run 1 module: Left; \"arm\"?of it"_s));
    EXPECT_TRUE(lines.contains(u"# run 1 steady-state error: -20 counts +- 0.5"_s));
    EXPECT_TRUE(lines.contains(
        u"# gains of module 1 at 0.000000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 4000 sr 1 db 0"_s));
    const auto first = lines.indexOf(u"run,time_s,position,from_start,error"_s);
    ASSERT_GT(first, 0);
    EXPECT_EQ(lines.at(first + 1), u"1,-0.01,500,0,0"_s);
    EXPECT_EQ(lines.at(first + 1 + 15), u"1,0.005,560,60,40"_s);
    EXPECT_EQ(lines.size(), first + 1 + 111 + 1);
}

/// 100 counts at 1 count per tick, 0.1 counts per tick squared: 110 ticks, 56.32 ms; it lags by 7 counts
/// until then, and by 2 for another 4 ms.
KeptResponse move(unsigned round, double last = 0.0605) {
    KeptResponse kept = ramp();
    ResponseTaken& taken = kept.run.taken;
    taken.method = ResponseMethod::Move;
    taken.pace = {CountsPerTick(1U << 16U), CountsPerTickSquared(6'554)};
    taken.round = round;
    if (round % 2 == 0)
        std::swap(taken.from, taken.goal);
    kept.run.points.clear();
    for (int ms = -10; ms <= 100; ++ms) {
        const double s = ms / 1'000.0;
        const double error = s < 0 || s > last ? 0 : s < 0.0565 ? 7 : 2;
        kept.run.points.push_back({s, taken.goal - error, error});
    }
    judge(kept.run, kFirstBand);
    return kept;
}

TEST_F(Responses, AMoveIsRequestedWithItsOwnPaceThereAndBack) {
    openWith();
    for (const QString& name :
         {u"responseVelocityField"_s, u"responseWindowField"_s, u"responseRoundsField"_s})
        EXPECT_FALSE(field(name)->isVisible()) << name.toStdString();
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(2);
    EXPECT_TRUE(field(u"responseVelocityField"_s)->isVisible());
    EXPECT_FALSE(field(u"responseBandField"_s)->isVisible());
    type(u"responseDistanceField"_s, u"30000"_s);  // no step of that length is possible
    type(u"responseVelocityField"_s, u"8"_s);
    type(u"responseAccelerationField"_s, u"0.5"_s);
    type(u"responseRoundsField"_s, u"2"_s);
    EXPECT_EQ(button(u"responseButton"_s)->text(), u"Move"_s);
    click(u"responseButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto series = std::get<intent::StepSeries>(intents.takeFirst().at(1).value<Intent>());
    EXPECT_EQ(series.counts, (std::vector{30'000, -30'000, 30'000, -30'000}));
    EXPECT_EQ(series.each.method, ResponseMethod::Move);
    EXPECT_EQ(series.each.pace, (ServoPace{CountsPerTick(8U << 16U), CountsPerTickSquared(32'768)}));
    type(u"responseVelocityField"_s, u"0"_s);
    EXPECT_FALSE(reason(u"responseButton"_s).isEmpty());
    type(u"responseVelocityField"_s, u"0.5"_s);
    EXPECT_TRUE(reason(u"responseButton"_s).contains(u"more than 6 s"_s)) << "30000 counts at 977 counts/s";
    // A step is as long as before, and a motor is identified from steps.
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(0);
    EXPECT_FALSE(field(u"responseDistanceField"_s)->problemText().isEmpty());
}

/// 1000 counts are a millimetre. A tick is SR times 0.512 ms (DS-V 4.3): at SR 4, 10 mm/s are 20.48 counts
/// per tick, and 100 mm/s² 0.4194304 counts per tick squared; at SR 1, 5.12 and 0.0262144. Times 65 536,
/// rounded.
TEST_F(Responses, AMoveWithAnotherServoRateIsAsFastAsTheFieldsSay) {
    openWith();
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, 1'000.0, {}};
    machine.axes[0].gains = someGains();
    window->showMachine(machine);
    showChanged([](ModuleState& module) {
        module.gains->sr = 4;
        module.servoRate = 4;
    });
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(2);
    type(u"responseVelocityField"_s, u"10"_s);
    type(u"responseAccelerationField"_s, u"100"_s);
    const auto pace = [this](const QString& answer) {
        intents.clear();
        click(u"responseButton"_s);
        click(answer);
        EXPECT_EQ(intents.size(), 1);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return std::get<intent::StepSeries>(intents.takeFirst().at(1).value<Intent>()).each.pace;
    };
    EXPECT_EQ(pace(u"stepWithoutButton"_s),
              (ServoPace{CountsPerTick(1'342'177), CountsPerTickSquared(27'488)}));
    EXPECT_EQ(pace(u"applyAndStepButton"_s),
              (ServoPace{CountsPerTick(335'544), CountsPerTickSquared(1'718)}));
}

TEST_F(Responses, MovesAreJudgedByWindowAndDwell) {
    openWith();
    for (const unsigned round : {1U, 2U, 3U})
        window->stepResponses().showRun(move(round, round == 3 ? 0.0705 : 0.0605));
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(2);
    type(u"responseDwellField"_s, u"0.01"_s);
    type(u"responseWindowField"_s, u"1"_s);
    EXPECT_EQ(result(1), u"56.3 ± 0.6 ms"_s) << "to a tick, rounded up";
    // 2 counts off at 70 ms, none at 71 ms; the edge at 1.5 counts is passed at 70.25 ms, known to half an
    // interval and a tick. The profile ends at 55.81 ms, known to a tick.
    EXPECT_EQ(result(2), u"14.4 ± 1.6 ms"_s);
    EXPECT_TRUE(result(3).endsWith(u"ms (3)"_s)) << result(3).toStdString();
    EXPECT_EQ(result(4), u"7.0 ± 1.0 counts"_s);
    type(u"responseWindowField"_s, u"2"_s);
    EXPECT_EQ(result(2), u"1.1 ± 1.6 ms"_s) << "7 counts off at 56 ms, 2 at 57 ms: 2.5 at 56.9 ms";
    type(u"responseDwellField"_s, u"0.05"_s);
    EXPECT_EQ(result(2), u"not recorded"_s);
    EXPECT_EQ(result(3), u"0 of 3 settled"_s);
    KeptResponse slow = move(1);
    slow.run.taken.gains.sr = 4;
    window->stepResponses().showRun(slow);
    EXPECT_EQ(result(1), u"225 ± 3 ms"_s) << "110 servo ticks of 2.048 ms, to one of them";
}

TEST_F(Responses, MovesOfTwoModulesAtTheSameTimeAreTwoSeries) {
    openWith();
    for (const unsigned round : {1U, 2U, 3U}) {
        KeptResponse other = move(round);
        other.run.module = ModuleIndex(1);
        window->stepResponses().showRun(other);
        window->stepResponses().showRun(move(round));
    }
    find<QComboBox>(u"responseMethodBox"_s)->setCurrentIndex(2);
    type(u"responseDwellField"_s, u"0.01"_s);
    type(u"responseWindowField"_s, u"1"_s);
    EXPECT_TRUE(result(3).endsWith(u"ms (3)"_s)) << result(3).toStdString();
}

TEST_F(Responses, CursorsStandBesideThePlotWhileTheyAreWanted) {
    openWith();
    window->stepResponses().showRun(ramp(100));
    auto* readings = window->findChild<QTableWidget*>(u"responseCursorTable"_s);
    EXPECT_FALSE(readings->isVisible());
    click(u"responseCursorsButton"_s);
    EXPECT_TRUE(readings->isVisible());
    EXPECT_EQ(readings->rowCount(), 2);
    window->stepResponses().showRun(ramp(110));
    EXPECT_EQ(readings->rowCount(), 3) << "time, A and B";
    find(u"responsePlot"_s)->setFocus();
    QTest::keyClick(find(u"responsePlot"_s), Qt::Key_C);
    EXPECT_FALSE(readings->isVisible());
}

TEST_F(Responses, TheTimeOfAMoveBeginsAtItsStart) {
    openWith();
    window->stepResponses().showRun(move(1));
    QSignalSpy saves(&window->requests(), &Requests::save);
    window->findChild<QAction*>(u"responseSvgAction"_s)->trigger();
    auto* dialog = window->findChild<QFileDialog*>(u"responsePicturesvgDialog"_s);
    ASSERT_NE(dialog, nullptr);
    testing_support::chooseFile(*dialog, u"/home/anna/move.svg"_s);
    ASSERT_EQ(saves.size(), 1);
    const std::string content = saves[0][1].value<FileContent>()();
    EXPECT_NE(content.find("time since the start (s)"), std::string::npos);
    EXPECT_EQ(content.find("time since the step (s)"), std::string::npos);
}

TEST_F(Responses, PicturesGoToFilesAndOntoTheClipboard) {
    openWith();
    KeptResponse run = ramp(100);
    run.name = "stiffer";
    window->stepResponses().showRun(run);
    QSignalSpy saves(&window->requests(), &Requests::save);
    for (const auto& [kind, magic] :
         {std::pair{u"Png"_s, "\x89PNG"}, std::pair{u"Svg"_s, "<?xml"}, std::pair{u"Pdf"_s, "%PDF"}}) {
        window->findChild<QAction*>(u"response%1Action"_s.arg(kind))->trigger();
        auto* dialog = window->findChild<QFileDialog*>(u"responsePicture%1Dialog"_s.arg(kind.toLower()));
        ASSERT_NE(dialog, nullptr) << kind.toStdString();
        EXPECT_FALSE(dialog->isModal());
        testing_support::chooseFile(*dialog, u"/home/anna/step."_s + kind.toLower());
        const std::string content = saves.takeFirst()[1].value<FileContent>()();
        EXPECT_TRUE(content.starts_with(magic)) << kind.toStdString();
        if (kind == u"Svg"_s) {
            EXPECT_NE(content.find("stiffer"), std::string::npos);
            EXPECT_NE(content.find("Kp 100 Kd 1000"), std::string::npos);
            EXPECT_NE(content.find("time since the step (s)"), std::string::npos);
            EXPECT_NE(content.find("position from the start (counts)"), std::string::npos);
        }
    }
    QGuiApplication::clipboard()->clear();
    window->findChild<QAction*>(u"responseCopyAction"_s)->trigger();
    EXPECT_GT(QGuiApplication::clipboard()->image().width(), 100);
}

TEST_F(Responses, ShowingEmitsNothing) {
    openWith();
    QSignalSpy edits(&window->requests(), &Requests::axisEdited);
    window->stepResponses().showRun(ramp());
    showServo({.millisecond = 20});
    report(ProcedureStage::Done);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_EQ(edits.size(), 0);
}

}  // namespace
}  // namespace nmc

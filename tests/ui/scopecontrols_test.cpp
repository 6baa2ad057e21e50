// SPDX-License-Identifier: GPL-3.0-or-later
// The scope's controls, by mouse, wheel and keyboard.
#include <algorithm>
#include <cmath>

#include "scopehistory.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/signalsdialog.h"
#include "widgets/scope/statuslane.h"
#include "widgets/scope/tracesdialog.h"
#include "widgets/scope/xyplot.h"
#include "windowtest.h"

namespace nmc {
namespace {

class ScopeControls : public WindowTest {
protected:
    /// Two modules; the first goes up by 10 counts/s, the second stands at 500. The scope shows 10..20 s.
    ScopeControls() {
        showServos({Servo{.index = 0}, Servo{.index = 1}});
        for (int i = 0; i <= 2000; ++i) {
            made.addTo(0, i / 100.0, i / 10);
            made.addTo(1, i / 100.0, 500);
        }
        frame();
        frame();
    }
    void frame(double now = 20) {
        window->showHistory(made.history(), HandMadeHistory::at(now));
        QApplication::processEvents();
    }
    ScopeStrips& strips() { return *find<ScopeStrips>(u"scopeStrips"_s); }
    ScopePlot& plot() { return *find<ScopePlot>(u"scopePlot1"_s); }
    /// The point at a visible time, half-way up.
    QPoint at(double seconds) {
        const QRectF area = plot().plotArea();
        const double share = (seconds - strips().time().left()) / strips().time().width();
        return QPointF(area.left() + share * area.width(), area.center().y()).toPoint();
    }
    void wheel(double seconds, int notches, Qt::KeyboardModifiers modifiers = {}) {
        QWheelEvent event(at(seconds), plot().mapToGlobal(at(seconds)), {}, {0, notches * 120}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot(), &event);
        frame();
    }
    void drag(double from, double to, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint start = at(from);
        const QPoint end = at(to);
        QTest::mousePress(&plot(), Qt::LeftButton, modifiers, start);
        QMouseEvent move(QEvent::MouseMove, end, plot().mapToGlobal(end), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QApplication::sendEvent(&plot(), &move);
        QTest::mouseRelease(&plot(), Qt::LeftButton, modifiers, end);
        frame();
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {}) {
        strips().setFocus();
        QTest::keyClick(&strips(), static_cast<Qt::Key>(key), modifiers);
        frame();
    }
    double left() { return strips().time().left(); }
    double right() { return strips().time().right(); }
    /// Switches to the Tune layout, in which the strips are high.
    void makeRoom() {
        window->resize(1456, 952);
        QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
        for (int i = 0; i < 5; ++i)
            frame();
    }
    bool paused() { return button(u"scopePauseButton"_s)->isChecked(); }

    HandMadeHistory made{2};
};

TEST_F(ScopeControls, TheWheelZoomsAroundThePointer) {
    click(u"scopePauseButton"_s);
    wheel(14, 1);  // 1.25 times: 8 s, and 14 s stays at 4/10
    EXPECT_NEAR(right() - left(), 8, 1e-6);
    EXPECT_NEAR(left(), 14 - 0.4 * 8, 0.05);  // the pointer stands on a whole pixel
    wheel(14, -1);
    EXPECT_NEAR(right() - left(), 10, 1e-6);
}

TEST_F(ScopeControls, TheWheelWithShiftGoesAlongAndPauses) {
    wheel(14, 1, Qt::ShiftModifier);
    EXPECT_TRUE(paused());
    EXPECT_NEAR(left(), 9, 1e-6);
}

TEST_F(ScopeControls, TheWheelWithCtrlZoomsTheValuesOnly) {
    const AxisRange::Range before = plot().valueRange();
    wheel(14, 4, Qt::ControlModifier);
    EXPECT_LT(plot().valueRange().max - plot().valueRange().min, (before.max - before.min) * 0.8);
    EXPECT_EQ(right() - left(), 10);
    EXPECT_FALSE(plot().fits());
    key(Qt::Key_A);
    EXPECT_TRUE(plot().fits());
    EXPECT_EQ(plot().valueRange(), before);
}

TEST_F(ScopeControls, DraggingMovesThePictureAlong) {
    drag(12, 15);
    EXPECT_TRUE(paused());
    EXPECT_NEAR(left(), 7, 0.05);
    EXPECT_NEAR(right(), 17, 0.05);
}

TEST_F(ScopeControls, DraggingWithShiftChoosesAStretch) {
    drag(12, 15, Qt::ShiftModifier);
    EXPECT_TRUE(paused());
    EXPECT_NEAR(left(), 12, 0.05);
    EXPECT_NEAR(right(), 15, 0.05);
    EXPECT_LT(find<QComboBox>(u"scopeWindowBox"_s)->currentIndex(), 0)
        << "it is not one of the listed lengths";
}

/// The wheel zooms by 1.25.
TEST_F(ScopeControls, TheBoxNamesTheTimeThatIsVisible) {
    const auto* box = find<QComboBox>(u"scopeWindowBox"_s);
    EXPECT_EQ(box->currentText(), u"10 s"_s);
    wheel(14, 1);
    EXPECT_LT(box->currentIndex(), 0) << "8 s";
    click(u"scopeLaneButton"_s);
    frame();
    EXPECT_NEAR(right() - left(), 8, 1e-6);
    EXPECT_LT(box->currentIndex(), 0) << "still 8 s";
    pick(u"scopeWindowBox"_s, u"1 s"_s);
    frame();
    EXPECT_EQ(box->currentText(), u"1 s"_s);
    wheel((left() + right()) / 2, -1);
    EXPECT_NEAR(right() - left(), 1.25, 1e-6);
    EXPECT_LT(box->currentIndex(), 0) << "1.25 s";
}

TEST_F(ScopeControls, ADoubleClickShowsEverything) {
    QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at(15));
    frame();
    EXPECT_NEAR(left(), 0, 1e-6);
    EXPECT_NEAR(right(), 20, 1e-6);
}

TEST_F(ScopeControls, EverythingWorksByKeyboard) {
    key(Qt::Key_Left);
    EXPECT_TRUE(paused());
    EXPECT_NEAR(left(), 9, 1e-6);
    key(Qt::Key_Right);
    EXPECT_NEAR(left(), 10, 1e-6);
    key(Qt::Key_Plus);
    EXPECT_NEAR(right() - left(), 10 / 1.5, 1e-6);
    key(Qt::Key_Minus);
    EXPECT_NEAR(right() - left(), 10, 1e-6);
    key(Qt::Key_Home);
    EXPECT_NEAR(right(), 20, 1e-6);
    EXPECT_NEAR(left(), 0, 1e-6);
    const double bottom = plot().valueRange().min;
    key(Qt::Key_Up);
    EXPECT_GT(plot().valueRange().min, bottom);
    key(Qt::Key_End);
    EXPECT_FALSE(paused());
    frame(30);
    EXPECT_NEAR(right(), 30, 2.1);
}

TEST_F(ScopeControls, ArrowsInAFieldDoNotMoveTheScope) {
    QLineEdit* goal = field(u"goalField"_s);
    goal->setFocus();
    QTest::keyClick(goal, Qt::Key_Left);
    QTest::keyClick(goal, Qt::Key_Minus);
    frame();
    EXPECT_FALSE(paused());
    EXPECT_EQ(right() - left(), 10);
}

TEST_F(ScopeControls, CursorsReadTimesValuesAndDifferences) {
    click(u"scopePauseButton"_s);
    click(u"scopeCursorsButton"_s);
    auto* table = find<QTableWidget>(u"scopeCursorTable"_s);
    emit strips().cursorMoved(0, 12.0);
    emit strips().cursorMoved(1, 16.0);
    frame();
    ASSERT_TRUE(table->isVisible());
    EXPECT_EQ(table->item(0, 1)->text(), u"12.0000 s"_s);
    EXPECT_EQ(table->item(0, 3)->text(), u"4 s (0.25 Hz)"_s);
    EXPECT_EQ(table->item(1, 0)->text(), u"position"_s);
    EXPECT_EQ(table->item(1, 1)->text(), u"120"_s);
    EXPECT_EQ(table->item(1, 2)->text(), u"160"_s);
    EXPECT_EQ(table->item(1, 3)->text(), u"40"_s);
    EXPECT_EQ(table->item(2, 1)->text(), u"–"_s) << "the command position is not known";
    drag(12, 13);
    EXPECT_NEAR((*strips().cursors())[0], 13, 0.05) << "a cursor under the mouse moves with it";
    EXPECT_NEAR(left(), 10, 1e-6);
    click(u"scopeCursorsButton"_s);
    EXPECT_FALSE(table->isVisible());
}

/// The figures of a signal between the cursors, here of a ramp of 10 counts/s from 120 to 160 counts and of a
/// swing of 100 counts at 2 Hz.
TEST_F(ScopeControls, TheTableTellsWhatASignalComesToBetweenTheCursors) {
    HandMadeHistory swinging{2};
    for (int i = 0; i <= 2000; ++i) {
        swinging.add(i / 100.0, i / 10);
        swinging.addTo(
            1, i / 100.0,
            static_cast<std::int32_t>(std::lround(100 * std::sin(2 * 3.14159265358979 * 2 * i / 100.0))));
    }
    ScopeSetup setup;
    setup.strips[0] = {{ModuleIndex(0), ScopeSignal::Position}, {ModuleIndex(1), ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    click(u"scopePauseButton"_s);
    click(u"scopeCursorsButton"_s);
    emit strips().cursorMoved(0, 12.0);
    emit strips().cursorMoved(1, 16.0);
    for (int i = 0; i < 4; ++i) {
        window->showHistory(swinging.history(), HandMadeHistory::at(20));
        QApplication::processEvents();
    }
    auto* table = find<QTableWidget>(u"scopeCursorTable"_s);
    const auto row = [table](int number) {
        QStringList cells;
        for (int column = 4; column < table->columnCount(); ++column)
            cells << table->item(number, column)->text();
        return cells;
    };
    // The mean of whole counts, rounded down from every tenth of a count, is 0.45 less than 140.
    EXPECT_NEAR(row(1)[0].toDouble(), 140, 0.5);
    EXPECT_NEAR(row(1)[1].toDouble(), std::sqrt(140.0 * 140 + 40.0 * 40 / 12), 0.6);
    EXPECT_EQ(row(1)[2], u"40"_s);
    EXPECT_NEAR(row(1)[3].toDouble(), 10, 0.02);
    EXPECT_EQ(row(1)[4], u"–"_s) << "it does not swing";
    EXPECT_NEAR(row(2)[0].toDouble(), 0, 0.1);
    EXPECT_NEAR(row(2)[1].toDouble(), 100 / std::sqrt(2.0), 0.3);
    EXPECT_EQ(row(2)[2], u"200"_s);
    EXPECT_EQ(row(2)[4], u"2 Hz"_s);
}

/// From 120 to 160 counts as well, and then from -120 to -160.
TEST_F(ScopeControls, TheTableReadsATraceOfOnesOwnAsItIsDefinedNow) {
    auto* panel = find<ScopePanel>(u"scopePanel"_s);
    ScopeSetup setup;
    setup.strips[0] = {{ModuleIndex(0), ScopeSignal::Custom1}};
    setup.custom[0] = TraceDefinition{u"way"_s, u"ct"_s, {{ModuleIndex(0), ScopeSignal::Position}, 1}};
    panel->setSetup(setup);
    click(u"scopePauseButton"_s);
    click(u"scopeCursorsButton"_s);
    emit strips().cursorMoved(0, 12.0);
    emit strips().cursorMoved(1, 16.0);
    const auto mean = [this] {
        for (int i = 0; i < 4; ++i)
            frame();
        return find<QTableWidget>(u"scopeCursorTable"_s)->item(1, 4)->text();
    };
    EXPECT_NEAR(mean().toDouble(), 140, 0.5);
    setup.custom[0]->first.factor = -1;
    panel->setSetup(setup);
    EXPECT_NEAR(mean().replace(u'\u2212', u'-').toDouble(), -140, 0.5);
}

/// The second module swings by 100 counts at 5 Hz about a drift.
class SpectrumOfTheScope : public ScopeControls {
protected:
    SpectrumOfTheScope() {
        for (int i = 0; i <= 2000; ++i) {
            swinging.add(i / 100.0, i / 10);
            const double phase = 2 * 3.14159265358979 * 5 * i / 100.0;
            swinging.addTo(1, i / 100.0,
                           static_cast<std::int32_t>(std::lround(7.0 * i + 100 * std::sin(phase))));
        }
        ScopeSetup setup;
        setup.strips[0] = {{ModuleIndex(0), ScopeSignal::Position}, {ModuleIndex(1), ScopeSignal::Position}};
        setup.strips[1] = {{ModuleIndex(1), ScopeSignal::Velocity}};
        find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
        click(u"scopePauseButton"_s);
        click(u"scopeCursorsButton"_s);
        putCursors(12, 16);
        click(u"scopeSpectrumButton"_s);
        frames();
    }
    void putCursors(double first, double second) {
        emit strips().cursorMoved(0, first);
        emit strips().cursorMoved(1, second);
    }
    /// A spectrum is calculated at every thirteenth frame.
    void frames() {
        for (int i = 0; i < 20; ++i) {
            window->showHistory(swinging.history(), HandMadeHistory::at(20));
            QApplication::processEvents();
        }
    }
    void choose(int signal) {
        pick(u"spectrumSignalBox"_s, find<QComboBox>(u"spectrumSignalBox"_s)->itemText(signal));
        frames();
    }
    QString peak() { return find<QLabel>(u"spectrumPeak"_s)->text(); }
    QString range() { return find<QLabel>(u"spectrumRange"_s)->text(); }

    HandMadeHistory swinging{2};
};

TEST_F(SpectrumOfTheScope, TellsFrequencyAndAmplitudeOfTheSignalThatIsChosen) {
    auto* box = find<QComboBox>(u"spectrumSignalBox"_s);
    ASSERT_EQ(box->count(), 3);
    EXPECT_TRUE(box->itemText(1).contains(u"position"_s)) << box->itemText(1).toStdString();
    choose(1);
    EXPECT_TRUE(peak().startsWith(u"Peak: 5 Hz, amplitude 100"_s)) << peak().toStdString();
    EXPECT_EQ(range(),
              u"From 0.5 Hz, two periods between the cursors, to 49.5 Hz, nearly half the rate of the "
              "samples."_s);
}

/// 100 counts at 5 Hz are 2 pi 5 times as much a second: 3142.
TEST_F(SpectrumOfTheScope, OfTheVelocityIsThatOfThePositionsRateOfChange) {
    choose(2);
    EXPECT_TRUE(QRegularExpression(u"^Peak: 5 Hz, amplitude 3\\W?14\\d counts/s$"_s,
                                   QRegularExpression::UseUnicodePropertiesOption)
                    .match(peak())
                    .hasMatch())
        << peak().toStdString();
}

TEST_F(SpectrumOfTheScope, FollowsTheCursors) {
    choose(1);
    putCursors(12, 14);
    frames();
    EXPECT_TRUE(range().startsWith(u"From 1 Hz"_s)) << range().toStdString();
    EXPECT_TRUE(peak().startsWith(u"Peak: 5 Hz, amplitude 100"_s)) << peak().toStdString();
    putCursors(12, 12.05);
    frames();
    EXPECT_EQ(range(), u"Too few samples are between the cursors. Move them farther apart."_s);
    EXPECT_TRUE(peak().isEmpty()) << "no figure of another stretch stays";
    click(u"scopeCursorsButton"_s);
    EXPECT_FALSE(window->findChild<QWidget*>(u"spectrumDialog"_s)->isVisible());
}

/// Half an hour without samples, as between two connections to the same chain.
TEST_F(SpectrumOfTheScope, AsksForOneSideOfALongGap) {
    for (int i = 0; i <= 1000; ++i)
        swinging.addTo(0, 1'820 + i / 100.0, i);
    putCursors(12, 1'825);
    frames();
    EXPECT_EQ(range(), u"There is a long gap between the cursors. Move both to the same side of it."_s);
    EXPECT_TRUE(peak().isEmpty());
    putCursors(1'821, 1'825);
    frames();
    EXPECT_TRUE(range().startsWith(u"From 0.5 Hz"_s)) << range().toStdString();
}

/// Module 1 goes from 120 to 160 between the cursors, with 5 % of that as a margin; module 2 swings about
/// 8400 to 11200.
TEST_F(SpectrumOfTheScope, HasAnXyViewBesideIt) {
    click(u"scopeXyButton"_s);
    frames();
    auto* plot = find<XyPlot>(u"xyPlot"_s);
    EXPECT_EQ(find<QComboBox>(u"xyHorizontalBox"_s)->currentIndex(), 0);
    EXPECT_EQ(find<QComboBox>(u"xyVerticalBox"_s)->currentIndex(), 1);
    EXPECT_TRUE(plot->legendText(0).contains(u" over "_s)) << plot->legendText(0).toStdString();
    EXPECT_NEAR(plot->geometryShown().left, 118, 0.5);
    EXPECT_NEAR(plot->geometryShown().right, 162, 0.5);
    EXPECT_LT(plot->geometryShown().bottom, 8'400);
    EXPECT_GT(plot->geometryShown().top, 11'200);
    EXPECT_TRUE(text(u"xyHint"_s).isEmpty());
    putCursors(30, 31);
    frames();
    EXPECT_EQ(text(u"xyHint"_s), u"Too few samples are between the cursors. Move them farther apart."_s);
    EXPECT_TRUE(plot->legendText(0).isEmpty());
}

TEST_F(SpectrumOfTheScope, ForgetsTheChainBefore) {
    choose(1);
    click(u"scopeXyButton"_s);
    frames();
    const auto* plot = find<XyPlot>(u"xyPlot"_s);
    ASSERT_FALSE(peak().isEmpty());
    ASSERT_FALSE(plot->legendText(0).isEmpty());
    swinging = HandMadeHistory{2};
    frames();
    EXPECT_TRUE(peak().isEmpty()) << "no sample of this chain has arrived yet";
    EXPECT_TRUE(plot->legendText(0).isEmpty());
}

TEST_F(SpectrumOfTheScope, HasThePresentNamesOfTheModules) {
    click(u"scopeXyButton"_s);
    frames();
    machine.axes.resize(2);
    machine.axes[1].name = "Z axis";
    window->showMachine(machine);
    frames();
    const QString legend = find<XyPlot>(u"xyPlot"_s)->legendText(0);
    EXPECT_TRUE(legend.contains(u"Z axis"_s)) << legend.toStdString();
    texts::setModuleNames({});
}

/// Positions, with 5 % of their range on either side; a key zooms to 1/1.5.
TEST(XyPlotHands, ZoomAndMoveHoweverFarTheMotorWent) {
    for (const double far : {500.0, 5'000'000.0}) {
        XyPlot plot;
        plot.resize(600, 400);
        plot.show();
        plot.showCurve({{0, 0, false}, {far, 10, true}}, u"one over another"_s);
        const PlotGeometry all = plot.geometryShown();
        EXPECT_NEAR(all.right - all.left, 1.1 * far, 1e-6);
        QTest::keyClick(&plot, Qt::Key_Plus);
        const PlotGeometry zoomed = plot.geometryShown();
        EXPECT_NEAR(zoomed.right - zoomed.left, 1.1 * far / 1.5, 1e-6);
        QTest::keyClick(&plot, Qt::Key_Right);
        EXPECT_GT(plot.geometryShown().left, zoomed.left);
        QTest::keyClick(&plot, Qt::Key_Plus, Qt::ControlModifier);
        EXPECT_NEAR(plot.geometryShown().top - plot.geometryShown().bottom, (all.top - all.bottom) / 1.5,
                    1e-9);
    }
}

TEST(XyPlotOfAConstant, ShowsIt) {
    XyPlot plot;
    plot.resize(600, 400);
    plot.showCurve({{0, 3, false}, {1, 3, true}}, u"one over another"_s);
    const PlotGeometry shown = plot.geometryShown();
    EXPECT_NEAR(shown.y(3), shown.area.center().y(), 1);
}

/// The first module only drifts.
TEST_F(SpectrumOfTheScope, SaysThatNothingOscillates) {
    swinging = HandMadeHistory(2);
    for (int i = 0; i <= 2000; ++i)
        swinging.add(i / 100.0, 3 * i);
    choose(1);
    choose(0);
    EXPECT_EQ(peak(), u"No oscillation stands out from the noise."_s);
}

TEST_F(ScopeControls, TheTableFoldsAndStaysFolded) {
    makeRoom();
    click(u"scopeCursorsButton"_s);
    frame();
    auto* fold = button(u"scopeCursorFoldButton"_s);
    ASSERT_TRUE(find(u"scopeCursorTable"_s)->isVisible());
    const int before = strips().width() * strips().height();
    click(u"scopeCursorFoldButton"_s);
    frame();
    frame();
    EXPECT_FALSE(window->findChild<QWidget*>(u"scopeCursorTable"_s)->isVisible());
    EXPECT_GT(strips().width() * strips().height(), before) << "the strips get its room";
    EXPECT_TRUE(fold->text().contains(u"Hz"_s)) << fold->text().toStdString();
    EXPECT_FALSE(ScopeSetup::fromText(settings.value(u"scope/tune"_s).toString()).readings);
    click(u"scopeCursorFoldButton"_s);
    EXPECT_TRUE(find(u"scopeCursorTable"_s)->isVisible());
}

/// One strip becomes higher and its neighbour lower, this is kept for the next start, and a double click
/// makes all of them equal.
TEST_F(ScopeControls, TheLineBetweenTwoStripsIsDragged) {
    makeRoom();
    auto* second = find<ScopePlot>(u"scopePlot2"_s);
    auto* splitter = strips().findChild<QSplitter*>();
    const int first = plot().height();
    const int both = first + second->height();
    QSplitterHandle* line = splitter->handle(1);
    const QPoint grip = line->rect().center();
    const QPoint to = grip - QPoint(0, 20);
    QTest::mousePress(line, Qt::LeftButton, {}, grip);
    QMouseEvent move(QEvent::MouseMove, to, line->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(line, &move);
    QTest::mouseRelease(line, Qt::LeftButton, {}, line->mapFromGlobal(move.globalPosition().toPoint()));
    frame();
    EXPECT_NEAR(plot().height(), first - 20, 2);
    EXPECT_NEAR(second->height(), both - first + 20, 2);
    const ScopeSetup kept = ScopeSetup::fromText(settings.value(u"scope/tune"_s).toString());
    EXPECT_NEAR(kept.heights[0] / kept.heights[1], static_cast<double>(plot().height()) / second->height(),
                0.05);
    QTest::mouseDClick(line, Qt::LeftButton, {}, grip);
    frame();
    EXPECT_NEAR(plot().height(), second->height(), 1);
}

/// They are calculated from the samples once they are selected; the shaft of module 1 has a constant
/// acceleration.
TEST_F(ScopeControls, AccelerationAndPwmAreDrawnWhenTheyAreChosen) {
    HandMadeHistory moving{2};
    for (int i = 0; i <= 2000; ++i) {
        ScopeSample& sample = moving.add(i / 100.0, i * i);  // 2 counts each 0.01 s: 20 000 counts/s^2
        sample.aux = 0x04;
        sample.error = sample.errorLow = sample.errorHigh = 50;
    }
    History history = moving.history();
    history.noteGains(
        {ModuleIndex(0), HandMadeHistory::at(0), servo::SetGain{512, 0, 0, 0, 255, 0, 16'000, 1, {}}});
    click(u"scopeSignalsButton"_s);
    auto* table =
        find<SignalsDialog>(u"scopeSignalsDialog"_s)->findChild<QTreeWidget*>(u"scopeSignalsTable"_s);
    for (int i = 0; i < table->topLevelItem(0)->childCount(); ++i) {
        QTreeWidgetItem* signal = table->topLevelItem(0)->child(i);
        signal->setCheckState(1, signal->text(0) == u"acceleration"_s ? Qt::Checked : Qt::Unchecked);
        signal->setCheckState(2, signal->text(0) == u"PWM, calculated"_s ? Qt::Checked : Qt::Unchecked);
    }
    for (int i = 0; i < 3; ++i) {
        window->showHistory(history, HandMadeHistory::at(20));
        QApplication::processEvents();
    }
    EXPECT_TRUE(plot().legendText(0).startsWith(u"acceleration, counts/s²"_s))
        << plot().legendText(0).toStdString();
    EXPECT_GE(plot().valueRange().max, 20'000);
    EXPECT_LE(plot().valueRange().min, 20'000);
    EXPECT_LT(plot().valueRange().max - plot().valueRange().min, 20);
    auto* pwm = find<ScopePlot>(u"scopePlot2"_s);
    EXPECT_TRUE(pwm->legendText(0).endsWith(u"/s"_s)) << pwm->legendText(0).toStdString();
    EXPECT_LE(pwm->valueRange().min, 100) << "512 times 50 over 256";
    EXPECT_GE(pwm->valueRange().max, 100);
    EXPECT_LT(pwm->valueRange().max - pwm->valueRange().min, 20);
    find<SignalsDialog>(u"scopeSignalsDialog"_s)->reject();
}

/// Module 1 goes up by 10 counts/s, module 2 stands at 500: their difference is 500 - 10 t.
TEST_F(ScopeControls, ATraceOfOnesOwnIsDefinedShownAndRemembered) {
    click(u"scopeSignalsButton"_s);
    auto* dialog = find<SignalsDialog>(u"scopeSignalsDialog"_s);
    auto* table = dialog->findChild<QTreeWidget*>(u"scopeSignalsTable"_s);
    const auto rowOf = [table](const QString& name) {
        const auto rows = table->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return rows.empty() ? nullptr : rows.front();
    };
    click(u"scopeCustomTracesButton"_s);
    auto* traces = find<TracesDialog>(u"customTracesDialog"_s);
    const auto field = [traces](const QString& name) { return traces->findChild<QLineEdit*>(name); };
    EXPECT_FALSE(field(u"customTrace2FirstFactor"_s)->isEnabled()) << "a row without a name is empty";
    QTest::keyClicks(field(u"customTrace2Name"_s), u"distance"_s);
    auto* first = traces->findChild<QComboBox*>(u"customTrace2FirstSignal"_s);
    auto* second = traces->findChild<QComboBox*>(u"customTrace2SecondSignal"_s);
    EXPECT_FALSE(field(u"customTrace2SecondFactor"_s)->isEnabled()) << "there is no second signal";
    first->setCurrentText(u"Module 2: position"_s);
    second->setCurrentText(u"Selected module: position"_s);
    auto* factor = field(u"customTrace2SecondFactor"_s);
    factor->selectAll();
    QTest::keyClicks(factor, u"0"_s);
    EXPECT_FALSE(button(u"customTracesApplyButton"_s)->isEnabled());
    EXPECT_EQ(find<QLabel>(u"customTracesProblem"_s)->text(), u"A factor must not be 0."_s);
    factor->selectAll();
    QTest::keyClicks(factor, u"-1"_s);
    EXPECT_TRUE(find<QLabel>(u"customTracesProblem"_s)->text().isEmpty());
    QTest::keyClicks(field(u"customTrace2Unit"_s), u"counts"_s);
    click(u"customTracesApplyButton"_s);
    ASSERT_NE(rowOf(u"distance"_s), nullptr);
    rowOf(u"distance"_s)->setCheckState(2, Qt::Checked);
    rowOf(u"error, calculated"_s)->setCheckState(2, Qt::Unchecked);
    dialog->reject();
    frame();
    auto* strip = find<ScopePlot>(u"scopePlot2"_s);
    ASSERT_EQ(strip->traces().size(), 1U);
    EXPECT_TRUE(strip->legendText(0).startsWith(u"distance, counts"_s)) << strip->legendText(0).toStdString();
    EXPECT_GE(strip->valueRange().max, 400) << "at 10 s";
    EXPECT_LE(strip->valueRange().min, 300) << "at 20 s";
    EXPECT_LT(strip->valueRange().max - strip->valueRange().min, 150);
    const ScopeSetup kept = ScopeSetup::fromText(settings.value(u"scope"_s).toString());
    ASSERT_TRUE(kept.custom[1]);
    EXPECT_EQ(kept.custom[1]->name, u"distance"_s);
    EXPECT_EQ(MainWindow(settings).findChild<ScopePanel*>()->setup(), kept);
}

TEST_F(ScopeControls, TheWindowOfCustomTracesShowsThoseThatThereAre) {
    auto* panel = find<ScopePanel>(u"scopePanel"_s);
    ScopeSetup setup = panel->setup();
    setup.custom[1] = TraceDefinition{u"skew"_s,
                                      u"counts"_s,
                                      {{ModuleIndex(0), ScopeSignal::Position}, 2},
                                      TraceDefinition::Part{{ModuleIndex(1), ScopeSignal::Position}, -1}};
    panel->setSetup(setup);
    click(u"scopeSignalsButton"_s);
    click(u"scopeCustomTracesButton"_s);
    auto* traces = find<TracesDialog>(u"customTracesDialog"_s);
    EXPECT_EQ(traces->findChild<QLineEdit*>(u"customTrace2Name"_s)->text(), u"skew"_s);
    EXPECT_EQ(traces->findChild<QComboBox*>(u"customTrace2SecondSignal"_s)->currentText(),
              u"Module 2: position"_s);
    EXPECT_EQ(traces->findChild<QLineEdit*>(u"customTrace2SecondFactor"_s)->text(), u"-1"_s);
    click(u"customTracesApplyButton"_s);
    find<SignalsDialog>(u"scopeSignalsDialog"_s)->reject();
    EXPECT_EQ(panel->setup(), setup);
}

TEST_F(ScopeControls, ATraceOfModulesThatAreNotThereStaysAsItWasWhenTracesAreApplied) {
    auto* panel = find<ScopePanel>(u"scopePanel"_s);
    ScopeSetup setup = panel->setup();
    setup.custom[0] = TraceDefinition{u"skew"_s,
                                      u"counts"_s,
                                      {{ModuleIndex(2), ScopeSignal::Velocity}, 2},
                                      TraceDefinition::Part{{ModuleIndex(3), ScopeSignal::Velocity}, -1}};
    panel->setSetup(setup);
    click(u"scopeSignalsButton"_s);
    click(u"scopeCustomTracesButton"_s);
    auto* traces = find<TracesDialog>(u"customTracesDialog"_s);
    EXPECT_EQ(traces->findChild<QComboBox*>(u"customTrace1FirstSignal"_s)->currentText(),
              u"Module 3: velocity"_s);
    EXPECT_EQ(traces->findChild<QComboBox*>(u"customTrace1SecondSignal"_s)->currentText(),
              u"Module 4: velocity"_s);
    click(u"customTracesApplyButton"_s);
    find<SignalsDialog>(u"scopeSignalsDialog"_s)->reject();
    EXPECT_EQ(panel->setup(), setup);
}

TEST_F(ScopeControls, TheListOfSignalsIsFiltered) {
    click(u"scopeSignalsButton"_s);
    auto* dialog = find<SignalsDialog>(u"scopeSignalsDialog"_s);
    auto* table = dialog->findChild<QTreeWidget*>(u"scopeSignalsTable"_s);
    auto* filter = dialog->findChild<QLineEdit*>(u"scopeSignalsFilter"_s);
    const auto seen = [table] {
        QStringList names;
        for (int i = 0; i < table->topLevelItemCount(); ++i)
            for (int k = 0; k < table->topLevelItem(i)->childCount(); ++k)
                if (!table->topLevelItem(i)->isHidden() && table->topLevelItem(i)->isExpanded() &&
                    !table->topLevelItem(i)->child(k)->isHidden())
                    names << table->topLevelItem(i)->text(0) + u": "_s +
                                 table->topLevelItem(i)->child(k)->text(0);
        return names;
    };
    QTest::keyClicks(filter, u"2 VELO"_s);
    EXPECT_EQ(seen(), QStringList{u"Module 2: velocity"_s});
    QTest::keyClick(filter, Qt::Key_Return);
    EXPECT_TRUE(dialog->isVisible()) << "Enter does not close it";
    filter->selectAll();
    QTest::keyClicks(filter, u"nothing of the kind"_s);
    EXPECT_TRUE(seen().isEmpty());
    filter->clear();
    EXPECT_FALSE(table->topLevelItem(2)->isHidden());
    EXPECT_FALSE(table->topLevelItem(2)->child(0)->isHidden());
    dialog->reject();
}

TEST_F(ScopeControls, SignalsOfAnyModuleStandInAnyStripAndAreRemembered) {
    click(u"scopeSignalsButton"_s);
    auto* dialog = find<SignalsDialog>(u"scopeSignalsDialog"_s);
    auto* table = dialog->findChild<QTreeWidget*>(u"scopeSignalsTable"_s);
    // Module 2: position into strips 1 and 3.
    QTreeWidgetItem* position = table->topLevelItem(2)->child(0);
    position->setCheckState(1, Qt::Checked);
    position->setCheckState(3, Qt::Checked);
    dialog->reject();
    frame();
    ASSERT_EQ(plot().traces().size(), 3U);
    EXPECT_EQ(plot().traces()[2].module, ModuleIndex(1));
    EXPECT_EQ(plot().traces()[2].tag, u"2"_s) << "with several modules, each trace has its number";
    EXPECT_GE(plot().valueRange().max, 500);
    EXPECT_TRUE(find<ScopePlot>(u"scopePlot3"_s)->isVisible());
    const ScopeSetup kept = ScopeSetup::fromText(settings.value(u"scope"_s).toString());
    EXPECT_TRUE(kept.shows(2, {ModuleIndex(1), ScopeSignal::Position}));
    EXPECT_EQ(MainWindow(settings).findChild<ScopePanel*>()->setup(), kept);
}

/// Saved under a name, chosen again, replaced and removed, and there again in the next session.
TEST_F(ScopeControls, PresetsAreKeptByName) {
    auto* panel = find<ScopePanel>(u"scopePanel"_s);
    const auto save = [&](const QString& name) {
        window->findChild<QAction*>(u"scopeSavePresetAction"_s)->trigger();
        find<QLineEdit>(u"scopePresetName"_s)->setText(name);
        click(u"scopePresetSaveButton"_s);
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    const auto entry = [&](const QString& menu, const QString& name) {
        QAction* found = nullptr;
        for (QAction* action : window->findChild<QMenu*>(menu)->actions())
            if (action->text() == name)
                found = action;
        return found;
    };
    const ScopeSetup before = panel->setup();
    save(u"Usual & more"_s);
    ScopeSetup other = before;
    other.strips[1] = {{ModuleIndex(1), ScopeSignal::Velocity}};
    other.seconds = 2;
    panel->setSetup(other);
    save(u" Speed "_s);
    entry(u"scopePresetsMenu"_s, u"Usual && more"_s)->trigger();
    EXPECT_EQ(panel->setup(), before);
    MainWindow next(settings);
    auto* menu = next.findChild<QMenu*>(u"scopePresetsMenu"_s);
    EXPECT_EQ(menu->actions().at(0)->text(), u"Speed"_s);
    menu->actions().at(0)->trigger();
    EXPECT_EQ(next.findChild<ScopePanel*>()->setup(), other);

    save(u"Speed"_s);  // replaces it by what is shown now
    panel->setSetup(other);
    entry(u"scopePresetsMenu"_s, u"Speed"_s)->trigger();
    EXPECT_EQ(panel->setup(), before);
    entry(u"scopeRemovePresetMenu"_s, u"Speed"_s)->trigger();
    EXPECT_EQ(entry(u"scopePresetsMenu"_s, u"Speed"_s), nullptr);
    EXPECT_NE(entry(u"scopePresetsMenu"_s, u"Usual && more"_s), nullptr);
    EXPECT_EQ(settings.value(u"scope/presets"_s).toStringList().size(), 2);

    frame();
    wheel(14, 1);  // 8 s
    save(u"Near"_s);
    entry(u"scopePresetsMenu"_s, u"Usual && more"_s)->trigger();
    EXPECT_NEAR(right() - left(), 10, 1e-6) << "which is the time that was set before the zoom, too";
    entry(u"scopePresetsMenu"_s, u"Near"_s)->trigger();
    EXPECT_NEAR(right() - left(), 8, 1e-6);
}

TEST_F(ScopeControls, APresetNeedsAName) {
    window->findChild<QAction*>(u"scopeSavePresetAction"_s)->trigger();
    find<QLineEdit>(u"scopePresetName"_s)->setText(u"  "_s);
    EXPECT_FALSE(button(u"scopePresetSaveButton"_s)->isEnabled());
    click(u"scopePresetCancelButton"_s);
    EXPECT_TRUE(settings.value(u"scope/presets"_s).toStringList().isEmpty());
}

TEST_F(ScopeControls, StatusBitsAreDrawnHighAndLow) {
    HandMadeHistory bits;
    for (int i = 0; i <= 1000; ++i)
        bits.add(i / 100.0, 0).status = i < 500 ? 0x01 : 0x00;  // move_done
    window->showHistory(bits.history(), HandMadeHistory::at(10));
    click(u"scopeLaneButton"_s);
    for (int i = 0; i < 2; ++i) {
        window->showHistory(bits.history(), HandMadeHistory::at(10));
        QApplication::processEvents();
    }
    auto* lane = find<StatusLane>(u"scopeStatusLane"_s);
    ASSERT_TRUE(lane->isVisible());
    const QImage image = lane->grab().toImage();
    const double rowHeight = lane->height() / static_cast<double>(lane->bits().size());
    const auto colouredRows = [&](double seconds) {
        const int x = qRound(plot().plotArea().left() + seconds / 10 * plot().plotArea().width());
        QList<int> rows;
        for (int y = 0; y < static_cast<int>(rowHeight); ++y)
            if (const QColor c = image.pixelColor(x, y); c.blue() - c.red() > 20)
                rows << y;
        return rows;
    };
    // High: a line at the top, filled below. Low: a line at the bottom only.
    EXPECT_GT(colouredRows(2.5).size(), rowHeight / 2);
    const QList<int> low = colouredRows(7.5);
    ASSERT_FALSE(low.isEmpty());
    EXPECT_GT(low.first(), rowHeight / 2);
}

/// The bit is set as long as the servo is off, and means nothing then.
TEST_F(ScopeControls, ThePositionErrorBitIsGreyWhileTheServoIsOff) {
    HandMadeHistory bits;
    for (int i = 0; i <= 1000; ++i) {
        ScopeSample& sample = bits.add(i / 100.0, 0);
        sample.status = 0x10;
        sample.aux = i < 500 ? 0x00 : 0x04;  // servo_on
    }
    click(u"scopeLaneButton"_s);
    for (int i = 0; i < 2; ++i) {
        window->showHistory(bits.history(), HandMadeHistory::at(10));
        QApplication::processEvents();
    }
    auto* lane = find<StatusLane>(u"scopeStatusLane"_s);
    const auto row =
        std::ranges::find(lane->bits(), ScopeBit{ScopeBit::Byte::Status, 4}) - lane->bits().begin();
    const QImage image = lane->grab().toImage();
    const double height = lane->height() / static_cast<double>(lane->bits().size());
    const auto at = [&](double seconds) {
        const double x = plot().plotArea().left() + seconds / 10 * plot().plotArea().width();
        return image.pixelColor(qRound(x), qRound((static_cast<double>(row) + 0.5) * height));
    };
    const auto coloured = [](const QColor& c) { return c.blue() - c.red() > 20; };
    EXPECT_FALSE(coloured(at(2.5)));
    EXPECT_NE(at(2.5), lane->palette().color(QPalette::Base)) << "it is drawn";
    EXPECT_TRUE(coloured(at(7.5)));
}

TEST_F(ScopeControls, NoZoomHangsOrCrashes) {
    click(u"scopePauseButton"_s);
    for (int i = 0; i < 60; ++i)
        wheel((left() + right()) / 2, 3);
    for (int i = 0; i < 60; ++i)
        wheel((left() + right()) / 2, 3, Qt::ControlModifier);
    EXPECT_FALSE(plot().grab().isNull());
    for (int i = 0; i < 120; ++i)
        wheel((left() + right()) / 2, -3);
    for (int i = 0; i < 120; ++i)
        wheel((left() + right()) / 2, -3, Qt::ControlModifier);
    EXPECT_FALSE(plot().grab().isNull());
}

/// A count of module 1 is a billionth of a millimetre, and the 500 counts of module 2 are 500 km: between
/// them, a double has no steps as small as a part of that count.
TEST_F(ScopeControls, NoZoomHangsOrCrashesWhereScalesAreVeryDifferent) {
    machine.axes.resize(2);
    machine.axes[0].unit = {UnitKind::Millimetres, kMaxCountsPerUnit, ""};
    machine.axes[1].unit = {UnitKind::Millimetres, kMinCountsPerUnit, ""};
    window->showMachine(machine);
    ScopeSetup setup;
    setup.strips[0] = {{ModuleIndex(0), ScopeSignal::Position}, {ModuleIndex(1), ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    click(u"scopePauseButton"_s);
    frame();
    ASSERT_GE(plot().valueRange().max, 5e8);
    for (int i = 0; i < 120; ++i) {
        wheel((left() + right()) / 2, 2, Qt::ControlModifier);
        EXPECT_FALSE(plot().grab().isNull());
    }
    EXPECT_LT(plot().valueRange().min, plot().valueRange().max);
}

TEST_F(ScopeControls, ARecordStandsInPlaceOfWhatIsLiveUntilTheUserGoesBack) {
    auto record = std::make_shared<ScopeRecord>();
    record->title = u"mill.csv"_s;
    HandMadeHistory old;
    for (int i = 0; i <= 100; ++i)
        old.add(i / 100.0, 7'000);
    record->history = old.history();
    record->modules = window->scopeModules();
    window->showRecord(record);
    frame();
    EXPECT_EQ(text(u"scopeRecordLabel"_s), u"mill.csv"_s);
    EXPECT_GT(plot().valueRange().min, 6'000);
    EXPECT_NEAR(right(), 1, 1e-6);
    click(u"scopeLiveButton"_s);
    frame();
    frame();
    EXPECT_FALSE(paused());
    EXPECT_LT(plot().valueRange().max, 1'000);
    EXPECT_NEAR(right() - left(), 10, 1e-6) << "the time of the layout, not that of the record";
}

TEST_F(ScopeControls, StandsStillWhileAnotherModuleIsSelected) {
    click(u"scopePauseButton"_s);
    frame();
    const double from = left();
    auto* list = find<QAbstractItemView>(u"chainList"_s);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    ASSERT_EQ(window->selectedModule(), ModuleIndex(1));
    frame(25);
    EXPECT_TRUE(paused());
    EXPECT_EQ(left(), from);
}

TEST_F(ScopeControls, HasThePresentUnitEvenWhilePaused) {
    click(u"scopePauseButton"_s);
    frame();
    ASSERT_TRUE(plot().legendText(0).contains(u"counts"_s)) << plot().legendText(0).toStdString();
    machine.axes.resize(2);
    machine.axes[0].unit = {UnitKind::Millimetres, 200.0, ""};
    window->showMachine(machine);
    frame();
    EXPECT_TRUE(plot().legendText(0).contains(u"mm"_s)) << plot().legendText(0).toStdString();
    EXPECT_LT(plot().valueRange().max, 2) << "200 counts are 1 mm";
}

TEST_F(ScopeControls, TheCursorsAreInViewInARecordAndInANewConnection) {
    click(u"scopeCursorsButton"_s);
    frame();
    const auto inView = [this] {
        return std::ranges::all_of(*strips().cursors(),
                                   [this](double time) { return time > left() && time < right(); });
    };
    ASSERT_TRUE(inView());
    auto record = std::make_shared<ScopeRecord>();
    HandMadeHistory old;
    for (int i = 0; i <= 100; ++i)
        old.add(i / 100.0, 7'000);
    record->history = old.history();
    record->modules = window->scopeModules();
    window->showRecord(record);
    frame();
    EXPECT_NEAR(right(), 1, 1e-6);
    EXPECT_TRUE(inView()) << (*strips().cursors())[0];
    click(u"scopeLiveButton"_s);
    frame();
    EXPECT_TRUE(inView()) << (*strips().cursors())[0];
    made = HandMadeHistory{2};
    made.add(100, 0);
    frame(101);
    EXPECT_NEAR(left(), 0, 1e-6);
    EXPECT_TRUE(inView()) << (*strips().cursors())[0];
}

/// A hundred samples a second between -10 and 10, and a peak of so many of them.
TEST_F(ScopeControls, TheAxisShowsWhatLastsAndNotASpike) {
    for (const auto& [samples, seen] : {std::pair{1, false}, std::pair{2, true}}) {
        made = HandMadeHistory{2};
        for (int i = 0; i <= 2'000; ++i)
            made.add(i / 100.0, i >= 1'500 && i < 1'500 + samples ? 1'000 : i % 2 == 0 ? 10 : -10);
        key(Qt::Key_End);
        drag(14.2, 15.7, Qt::ShiftModifier);  // 150 samples
        key(Qt::Key_A);
        const AxisRange::Range range = plot().valueRange();
        EXPECT_LE(range.min, -10) << samples;
        EXPECT_GE(range.max, 10) << samples;
        EXPECT_EQ(range.max >= 1'000, seen) << range.max;
        if (!seen) {
            EXPECT_LE(range.max - range.min, 60) << "three spans of what lasts";
        }
    }
}

TEST_F(ScopeControls, ASpikeOfOneSampleIsSeenAtEveryZoom) {
    HandMadeHistory spike;
    for (int i = 0; i <= 200'000; ++i)
        spike.add(i / 1000.0, i == 111'111 ? 1'000 : 0);
    click(u"scopePauseButton"_s);
    for (const double width : {200.0, 50.0, 10.0, 2.0, 0.1, 0.01}) {
        strips().time().show(111.111 - width / 3, 111.111 + width * 2 / 3);
        for (int i = 0; i < 2; ++i) {
            emit strips().timeChanged();
            window->showHistory(spike.history(), HandMadeHistory::at(200));
            QApplication::processEvents();
        }
        const QRectF area = plot().plotArea();
        const QImage image = plot().grab().toImage();
        const int x = qRound(area.left() + area.width() / 3);
        // Its tip, or the mark at the edge of an axis that shows the rest.
        const double top =
            qMax(area.top(), area.bottom() - (1000 - plot().valueRange().min) /
                                                 (plot().valueRange().max - plot().valueRange().min) *
                                                 area.height());
        int highest = image.height();
        for (int y = static_cast<int>(area.top()); y < static_cast<int>(area.bottom()); ++y)
            for (int dx = -2; dx <= 2; ++dx)
                if (const QColor c = image.pixelColor(x + dx, y); c.blue() - c.red() > 60)
                    highest = qMin(highest, y);
        EXPECT_NEAR(highest, top, 3) << width << " s";
    }
}

}  // namespace
}  // namespace nmc

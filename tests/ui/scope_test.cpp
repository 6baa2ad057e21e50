// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scopehistory.h"
#include "tests/model/stepperfixture.h"
#include "widgets/scope/scopepanel.h"
#include "widgets/scope/scopeplot.h"
#include "windowtest.h"

namespace nmc {
namespace {

/// How far it is from grey, as axes and grid are.
int colourOf(const QColor& pixel) {
    const auto [least, most] = std::minmax({pixel.red(), pixel.green(), pixel.blue()});
    return most - least;
}

class Scope : public WindowTest {
protected:
    Scope() { showServo(); }
    ScopePlot* plot(const QString& name = u"scopePlot1"_s) { return find<ScopePlot>(name); }
    void show(HandMadeHistory& made, double now) {
        // The labels get their places when they are painted, and the plot gets what they leave of the strip.
        for (QRectF area; area != plot()->plotArea(); QApplication::processEvents()) {
            area = plot()->plotArea();
            window->showHistory(made.history(), HandMadeHistory::at(now));
            plot()->grab();
        }
    }
    /// Rows of the plot area that a trace colours, at a time within the visible 0..10 s.
    QList<int> rowsAt(const QString& name, double seconds, int reach = 1) {
        ScopePlot* strip = plot(name);
        const QImage image = strip->grab().toImage();
        const QRectF area = strip->plotArea();
        const int centre = qRound(area.left() + seconds / 10 * area.width());
        QList<int> rows;
        for (int y = static_cast<int>(area.top()); y <= static_cast<int>(area.bottom()); ++y) {
            for (int x = centre - reach; x <= centre + reach; ++x) {
                if (colourOf(image.pixelColor(x, y)) > 25) {
                    rows << y;
                    break;
                }
            }
        }
        return rows;
    }
};

TEST_F(Scope, HasNoStripForAModuleThatIsNotThere) {
    const auto visible = [this] {
        return std::ranges::count_if(find(u"scopeStrips"_s)->findChildren<ScopePlot*>(),
                                     [](const ScopePlot* strip) { return strip->isVisible(); });
    };
    const auto shown = visible();
    ScopeSetup setup = ScopeSetup::usual();
    setup.strips[3] = {{ModuleIndex(1), ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    EXPECT_EQ(visible(), shown);
    showServos({{}, {}});
    EXPECT_EQ(visible(), shown + 1);
}

TEST_F(Scope, DrawsASpikeOfOneSample) {
    HandMadeHistory level;
    level.add(0, 0);
    show(level, 10);
    const QRectF area = plot()->plotArea();
    // In the middle of a pixel: between two pixels, each would have half of the colour.
    const double middle = std::floor(area.center().x()) + 0.5;
    const auto at = std::lround((middle - area.left()) / area.width() * 4800);
    HandMadeHistory history;
    for (int i = 0; i <= 4800; ++i)
        history.add(i / 480.0, i == at ? 1000 : 0);
    show(history, 10);
    ASSERT_EQ(plot()->plotArea(), area);
    EXPECT_LT(plot()->valueRange().max, 1000) << "the axis shows the rest";
    const QList<int> rows = rowsAt(u"scopePlot1"_s, static_cast<double>(at) / 480, 1);
    ASSERT_FALSE(rows.isEmpty());
    EXPECT_NEAR(rows.first(), area.top(), 3) << "marked at the edge";
    EXPECT_GT(rows.size(), area.height() / 4) << "a line from the floor to the edge";
    EXPECT_LT(rowsAt(u"scopePlot1"_s, 3).size(), 6);
}

/// 800 counts up are 2 mm down, on an axis that is reversed.
TEST_F(Scope, AReversedAxisIsDrawnFromItsOtherSide) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, -400.0, ""};
    window->showMachine(machine);
    HandMadeHistory history;
    for (int i = 0; i <= 1'000; ++i)
        history.add(i / 100.0, 800 * i / 1'000);
    show(history, 10);
    const AxisRange::Range range = plot()->valueRange();
    EXPECT_LE(range.min, -2);
    EXPECT_NEAR(range.max, 0, 0.5);
    const QRectF area = plot()->plotArea();
    const double middle = area.bottom() - (-1 - range.min) / (range.max - range.min) * area.height();
    const QList<int> rows = rowsAt(u"scopePlot1"_s, 5, 1);
    ASSERT_FALSE(rows.isEmpty());
    EXPECT_NEAR(rows.first(), middle, 3);
    EXPECT_LT(rowsAt(u"scopePlot1"_s, 2).first(), rowsAt(u"scopePlot1"_s, 8).first()) << "it goes down";
}

/// An error of ±100 counts. A band of ±140 fits in the strip; a band of ±10 000 does not, which the strip
/// says, and the error remains visible.
TEST_F(Scope, AnErrorsBandIsTakenInAsFarAsTheErrorCanStillBeSeen) {
    window->resize(1500, 1100);  // in a low strip the axis has few numbers, and ends at round ones
    ScopeSetup setup = ScopeSetup::usual();
    setup.strips[2].clear();
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    for (const double half : {140.0, 10'000.0}) {
        HandMadeHistory history;
        for (int i = 0; i <= 1000; ++i) {
            ScopeSample& sample = history.add(i / 100.0, 0);
            sample.error = i % 100 < 50 ? -100 : 100;
            sample.errorLow = static_cast<float>(-half);
            sample.errorHigh = static_cast<float>(half);
        }
        show(history, 10);
        ScopePlot* strip = plot(u"scopePlot2"_s);
        const AxisRange::Range range = strip->valueRange();
        const bool whole = range.min <= -half && range.max >= half;
        EXPECT_EQ(whole, half < 1'000) << range.min << ".." << range.max;
        EXPECT_EQ(strip->bandNotice().isEmpty(), whole) << strip->bandNotice().toStdString();
        EXPECT_LE(range.max - range.min, 10 * 200) << "the error has a tenth of the strip";
    }
}

TEST_F(Scope, AGapIsAGap) {
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 100.0;
        if (t > 4 && t < 6)
            continue;
        history.add(t, 500).gapBefore = t == 6;
    }
    show(history, 10);
    EXPECT_FALSE(rowsAt(u"scopePlot1"_s, 3).isEmpty());
    EXPECT_TRUE(rowsAt(u"scopePlot1"_s, 5, 20).isEmpty());
    EXPECT_FALSE(rowsAt(u"scopePlot1"_s, 7).isEmpty());
}

/// Measured signals, and those derived from them, are solid, so that a short excursion cannot hide in a gap.
TEST_F(Scope, OnlyWhatIsCommandedIsDashed) {
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i)
        history.add(i / 100.0, 0).error = 3;
    ScopeSetup setup;
    setup.strips[0] = {{std::nullopt, ScopeSignal::Command}};
    setup.strips[1] = {{std::nullopt, ScopeSignal::Error}};
    setup.strips[2] = {{std::nullopt, ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    show(history, 10);
    const auto emptyPlaces = [this](const QString& name) {
        int empty = 0;
        for (double t = 2; t < 4; t += 0.01)
            empty += rowsAt(name, t, 0).isEmpty() ? 1 : 0;
        return empty;
    };
    EXPECT_GT(emptyPlaces(u"scopePlot1"_s), 30);
    EXPECT_LT(emptyPlaces(u"scopePlot1"_s), 140);
    EXPECT_EQ(emptyPlaces(u"scopePlot2"_s), 0);
    EXPECT_EQ(emptyPlaces(u"scopePlot3"_s), 0);
    EXPECT_TRUE(plot(u"scopePlot1"_s)->legendText(0).contains(u"calculated"_s));
    EXPECT_TRUE(plot(u"scopePlot2"_s)->legendText(0).contains(u"calculated"_s));
}

/// A line that rises by three pixels per pixel is smooth and straight, with one or two samples in every pixel
/// as well as with few. In every row, the middle of the coloured pixels is where the line crosses it.
TEST_F(Scope, ASteepLineIsSmoothHoweverManySamplesThereAre) {
    window->resize(1500, 952);  // high enough for a line of this slope
    ScopeSetup setup;
    setup.strips[0] = {{std::nullopt, ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    for (const int perSecond : {20, 100, 250, 400}) {
        HandMadeHistory history;
        const auto place = [](double t) { return std::clamp((t - 4) / 0.5, 0.0, 1.0) * 100'000; };
        for (int i = 0; i <= 10 * perSecond; ++i) {
            const double t = static_cast<double>(i) / perSecond;
            history.add(t, static_cast<std::int32_t>(std::lround(place(t))));
        }
        show(history, 10);
        const QImage image = plot()->grab().toImage();
        const QRectF area = plot()->plotArea();
        const AxisRange::Range range = plot()->valueRange();
        int rows = 0;
        for (double value = 20'000; value < 80'000; value += 1'000) {
            const int y = static_cast<int>(area.bottom() -
                                           (value - range.min) / (range.max - range.min) * area.height());
            const double middle =
                range.min + (area.bottom() - y - 0.5) / area.height() * (range.max - range.min);
            const double expected = area.left() + (4 + 0.5 * middle / 100'000) / 10 * area.width();
            double weight = 0, sum = 0;
            for (int x = static_cast<int>(expected) - 8; x < static_cast<int>(expected) + 8; ++x) {
                const int colour = colourOf(image.pixelColor(x, y));
                weight += colour;
                sum += colour * (x + 0.5);
            }
            ASSERT_GT(weight, 0) << perSecond << " at " << value;
            EXPECT_NEAR(sum / weight, expected, 0.3) << perSecond << " at " << value;
            ++rows;
        }
        EXPECT_GT(rows, 50);
    }
}

/// Points that are drawn as one line may not be beside it: in every column of pixels, the middle of the
/// coloured ones is where the curve crosses it.
TEST_F(Scope, ACurveOfFewSamplesIsWhereTheyAre) {
    ScopeSetup setup;
    setup.strips[0] = {{std::nullopt, ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    const auto place = [](double t) { return 9'000 * std::sin(2 * std::numbers::pi * t / 5); };
    HandMadeHistory history;
    for (int i = 0; i <= 200; ++i)
        history.add(i / 20.0, static_cast<std::int32_t>(std::lround(place(i / 20.0))));
    show(history, 10);
    const QImage image = plot()->grab().toImage();
    const QRectF area = plot()->plotArea();
    const AxisRange::Range range = plot()->valueRange();
    for (double t = 4; t < 9; t += 0.02) {  // the legend is at the left
        const int x = static_cast<int>(area.left() + t / 10 * area.width());
        const double value = place((x + 0.5 - area.left()) / area.width() * 10);
        const double expected = area.bottom() - (value - range.min) / (range.max - range.min) * area.height();
        double weight = 0, sum = 0;
        for (int y = static_cast<int>(expected) - 6; y < static_cast<int>(expected) + 6; ++y) {
            const int colour = colourOf(image.pixelColor(x, y));
            weight += colour;
            sum += colour * (y + 0.5);
        }
        ASSERT_GT(weight, 0) << t;
        EXPECT_NEAR(sum / weight, expected, 0.3) << t;
    }
}

/// Traces are drawn in another way where there are more samples than pixels.
TEST_F(Scope, TheNumberAtTheEndOfATraceHasItsColour) {
    showServos({{}, {}});
    ScopeSetup setup;
    setup.strips[0] = {{ModuleIndex(0), ScopeSignal::Position}, {ModuleIndex(1), ScopeSignal::Position}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    for (const int perSecond : {20, 400}) {
        HandMadeHistory history(2);
        for (int i = 0; i <= 8 * perSecond; ++i) {
            history.add(static_cast<double>(i) / perSecond, 0);
            history.addTo(1, static_cast<double>(i) / perSecond, 1'000);
        }
        show(history, 10);
        ASSERT_EQ(plot()->traces().size(), 2U);
        ASSERT_EQ(plot()->traces()[1].tag, u"2"_s);
        // From 4 to 8 pixels behind the last sample.
        EXPECT_FALSE(rowsAt(u"scopePlot1"_s, 8 + 6 / plot()->plotArea().width() * 10, 2).isEmpty())
            << perSecond;
    }
}

TEST_F(Scope, LegendSaysTheAchievedRate) {
    HandMadeHistory history;
    for (int i = 0; i <= 1200; ++i)
        history.add(i / 120.0, i % 7);
    show(history, 10);
    EXPECT_TRUE(plot()->legendText(0).contains(u"120/s"_s)) << plot()->legendText(0).toStdString();
}

TEST_F(Scope, StripsShareTheTimeAxis) {
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i) {
        history.add(i / 100.0, i * 100000).error = static_cast<float>(i % 3);
    }
    for (int frame = 0; frame < 4; ++frame)
        show(history, 10 + 0.01 * frame);
    EXPECT_NEAR(plot()->plotArea().left(), plot(u"scopePlot2"_s)->plotArea().left(), 2);
    EXPECT_NEAR(plot()->plotArea().right(), plot(u"scopePlot2"_s)->plotArea().right(), 2);
}

TEST_F(Scope, PauseHoldsThePictureStill) {
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i)
        history.add(i / 100.0, i % 50);
    show(history, 10);
    click(u"scopePauseButton"_s);
    show(history, 10);
    const QImage before = plot()->grab().toImage();
    for (int i = 1001; i <= 2000; ++i)
        history.add(i / 100.0, 900);
    show(history, 20);
    EXPECT_EQ(plot()->grab().toImage(), before);
}

/// The A/D value of a PIC-SERVO; a PIC-STEP reports no current, and no error (DS-S 5.2).
TEST_F(Scope, TheCurrentStandsBesideThePositionWhereItIsReported) {
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i)
        history.add(i / 100.0, 0).analog = 128;
    show(history, 10);
    ScopePlot* current = plot(u"scopePlot3"_s);
    ASSERT_TRUE(current->isVisible());
    EXPECT_TRUE(current->legendText(0).startsWith(u"A/D, "_s)) << current->legendText(0).toStdString();
    window->showLink(connectedTo({testing_support::Stepper::holding().module}));
    show(history, 10);
    EXPECT_TRUE(plot()->isVisible());
    EXPECT_FALSE(find<ScopePlot>(u"scopePlot2"_s)->isVisible());
    EXPECT_FALSE(current->isVisible());
}

TEST_F(Scope, NumbersAtTheAxesAndInWordsLookAlike) {
    EXPECT_EQ(texts::numberAt(-1234.5, 1), u"\u22121\u202f235"_s);
    EXPECT_EQ(texts::numberAt(-1234.5, 0.5), u"\u22121\u202f234.5"_s);
    EXPECT_EQ(texts::numberAt(0.1 + 0.2, 0.1), u"0.3"_s);
    EXPECT_EQ(texts::numberAt(-0.004, 0.1), u"0.0"_s);
    EXPECT_EQ(texts::numberAt(12'345'678, 1'000), u"12\u202f345\u202f678"_s);
}

/// Recorded: at rest for 3 s, then 400 counts/s. Live: at rest for 5 s, then 200 counts/s. One second after
/// each motion has begun, they are at 400 and 200 counts, one above the other.
TEST_F(Scope, ARecordingLiesUnderTheLiveTraceFromWhereTheMotionBegan) {
    auto recorded = std::make_shared<ScopeRecord>();
    HandMadeHistory old;
    HandMadeHistory live;
    for (int i = 0; i <= 1000; ++i) {
        old.add(i / 100.0, std::max(0, 4 * (i - 300)));
        live.add(i / 100.0, std::max(0, 2 * (i - 500)));
    }
    recorded->title = u"mill.csv"_s;
    recorded->history = old.history().cut(HandMadeHistory::at(0), HandMadeHistory::at(10));
    show(live, 10);
    window->showUnder(recorded);
    show(live, 10);
    EXPECT_EQ(find<QLabel>(u"scopeUnderLabel"_s)->text(), u"Overlay: mill.csv"_s);
    const auto rowOf = [&](double counts) {
        const QRectF area = plot()->plotArea();
        const AxisRange::Range range = plot()->valueRange();
        return area.bottom() - (counts - range.min) / (range.max - range.min) * area.height();
    };
    const QList<int> both = rowsAt(u"scopePlot1"_s, 6);
    ASSERT_FALSE(both.isEmpty());
    EXPECT_NEAR(both.first(), rowOf(400), 4);
    EXPECT_NEAR(both.last(), rowOf(200), 4);

    QTest::mouseClick(find<QPushButton>(u"scopeUnderEndButton"_s), Qt::LeftButton);
    show(live, 10);
    EXPECT_NEAR(rowsAt(u"scopePlot1"_s, 6).first(), rowOf(200), 4) << "it was removed";
    EXPECT_FALSE(find<QLabel>(u"scopeUnderLabel"_s)->isVisible());
}

/// A sample of a PIC-I/O has its counter where that of a motor has its position: 400 here, and twice that in
/// the user's trace.
TEST_F(Scope, AnOverlayIsReadAsTheTypeThatWasRecorded) {
    ScopeSetup setup;
    setup.strips[0] = {{{}, ScopeSignal::Position}};
    setup.strips[1] = {{{}, ScopeSignal::Custom1}};
    setup.custom[0] = TraceDefinition{u"twice"_s, u"ct"_s, {{{}, ScopeSignal::Position}, 2}};
    find<ScopePanel>(u"scopePanel"_s)->setSetup(setup);
    HandMadeHistory live;
    HandMadeHistory old;
    for (int i = 0; i <= 1000; ++i) {
        live.add(i / 100.0, 0);
        old.add(i / 100.0, 400);
    }
    show(live, 10);
    for (const ModuleType type : {ModuleType::Io, ModuleType::Servo}) {
        auto recorded = std::make_shared<ScopeRecord>();
        recorded->history = old.history();
        recorded->modules.resize(1);
        recorded->modules[0].identity.type = type;
        window->showUnder(recorded);
        show(live, 10);
        EXPECT_EQ(plot()->valueRange().max >= 400, type == ModuleType::Servo);
        EXPECT_EQ(plot(u"scopePlot2"_s)->valueRange().max >= 800, type == ModuleType::Servo);
    }
}

TEST_F(Scope, NothingIsBuiltUntilItIsSeen) {
    MainWindow hidden(settings);
    EXPECT_EQ(hidden.findChild<ScopePlot*>(u"scopePlot1"_s), nullptr);
    Requests requests;
    ScopePanel panel(requests);
    panel.showHistory(History(), HandMadeHistory::at(0));
    EXPECT_EQ(panel.findChild<ScopePlot*>(u"scopePlot1"_s), nullptr);
}

TEST_F(Scope, FollowsADarkPalette) {
    window->setPalette(darkPalette());
    HandMadeHistory history;
    for (int i = 0; i <= 1000; ++i)
        history.add(i / 100.0, 10);
    show(history, 10);
    const QImage image = plot()->grab().toImage();
    EXPECT_EQ(image.pixelColor(2, 2), darkPalette().color(QPalette::Base));
    EXPECT_FALSE(rowsAt(u"scopePlot1"_s, 5).isEmpty());
}

TEST_F(Scope, ShowsTheChosenLengthOfTime) {
    HandMadeHistory history;
    for (int i = 0; i <= 6000; ++i)
        history.add(i / 100.0, i < 5700 ? 0 : 100);
    auto* box = find<QComboBox>(u"scopeWindowBox"_s);
    box->setCurrentIndex(box->findText(u"2 s"_s));
    emit box->activated(box->currentIndex());
    show(history, 60);
    EXPECT_GE(plot()->valueRange().min, 90) << "the step is out of sight in a 2 s window";
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseplot.h"

#include "responserecords.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"
#include "widgets/response/responsewords.h"

namespace nmc {
namespace {

bool near(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 90;
}

/// True if a line of pixels across the curve at this point contains the colour.
bool drawn(const QImage& picture, const QPointF& at, const QColor& colour) {
    for (int y = -3; y <= 3; ++y)
        if (near(picture.pixelColor(at.toPoint() + QPoint(0, y)), colour))
            return true;
    return false;
}

TEST(StepPlotPicture, ASolidBDashedFromWhereTheyBegan) {
    ResponsePlot plot;
    plot.resize(600, 400);
    const KeptResponse a = ramp(120);
    KeptResponse b = ramp(60);
    b.run.taken.from = 500;
    plot.showRuns(&a, &b);
    QTest::mouseDClick(&plot, Qt::LeftButton);  // the whole record
    plot.grab();                                // lays it out
    const QImage picture = plot.grab().toImage();
    const QColor colourA = look::traceColour(0, plot.palette());
    const QColor colourB = look::traceColour(1, plot.palette());
    int dashes = 0;
    for (int i = 0; i < 100; ++i) {
        const double seconds = 0.015 + 0.0008 * i;
        EXPECT_TRUE(drawn(picture, plot.geometryShown().at(seconds, 120), colourA)) << seconds;
        dashes += drawn(picture, plot.geometryShown().at(seconds, 60), colourB) ? 1 : 0;
    }
    EXPECT_GT(dashes, 40);
    EXPECT_LT(dashes, 85);
    EXPECT_TRUE(drawn(picture, plot.geometryShown().at(0.005, 60), colourA)) << "half-way up";
    EXPECT_FALSE(drawn(picture, plot.geometryShown().at(-0.005, 60), colourA));
}

TEST(StepPlotPicture, TwoRunsOfOneModuleHaveOneUnit) {
    ResponsePlot plot;
    KeptResponse inMillimetres = ramp(100);
    inMillimetres.scale = AxisScale::servo({UnitKind::Millimetres, 50.0, {}}, 1);
    KeptResponse inCounts = ramp(100);
    plot.showRuns(&inMillimetres, &inCounts);
    EXPECT_TRUE(plot.legendText(1).endsWith(u"mm"_s)) << plot.legendText(1).toStdString();
    inCounts.run.module = ModuleIndex(1);
    plot.showRuns(&inMillimetres, &inCounts);
    EXPECT_TRUE(plot.legendText(1).endsWith(u"counts"_s)) << plot.legendText(1).toStdString();
}

TEST(StepPlotPicture, TheStripsHaveThatUnitAsWell) {
    ResponsePlot plot;
    plot.resize(600, 500);
    KeptResponse a = ramp(100);
    a.scale = AxisScale::servo({UnitKind::Millimetres, 50.0, {}}, 1);
    KeptResponse b = ramp(60);
    const auto picture = [&] {
        plot.showRuns(&a, &b);
        plot.grab();  // lays it out
        return plot.grab().toImage();
    };
    const QImage bInCounts = picture();
    b.scale = a.scale;
    EXPECT_EQ(bInCounts, picture()) << "the unit was changed between the two runs";
}

TEST(StepPlotPicture, NoLineCrossesAGap) {
    ResponsePlot plot;
    plot.resize(600, 400);
    KeptResponse run = ramp(100);
    auto& points = run.run.points;
    points.erase(std::remove_if(points.begin(), points.end(),
                                [](const ResponsePoint& p) { return p.seconds > 0.04 && p.seconds < 0.06; }),
                 points.end());
    for (ResponsePoint& point : points)
        point.position = point.seconds > 0.01 ? 560 : point.position;
    judge(run.run, kFirstBand);
    plot.showRuns(&run, nullptr);
    QTest::mouseDClick(&plot, Qt::LeftButton);
    plot.grab();
    const QImage picture = plot.grab().toImage();
    const QColor colour = look::traceColour(0, plot.palette());
    EXPECT_TRUE(drawn(picture, plot.geometryShown().at(0.03, 60), colour));
    EXPECT_FALSE(drawn(picture, plot.geometryShown().at(0.05, 60), colour));
    EXPECT_TRUE(drawn(picture, plot.geometryShown().at(0.07, 60), colour));
}

/// A step of 100 counts that takes 10 ms, in its own plot.
class ResponsePlotHands : public testing::Test {
protected:
    ResponsePlotHands() {
        plot.resize(600, 400);
        plot.showRuns(&run, nullptr);
        plot.show();
        plot.grab();
    }
    [[nodiscard]] const PlotGeometry& now() const { return plot.geometryShown(); }
    void wheel(const QPointF& at, int notches, Qt::KeyboardModifiers modifiers = {}) {
        QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * notches}, {}, modifiers, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(&plot, &event);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&plot, Qt::LeftButton, modifiers, from.toPoint());
        QTest::mouseMove(&plot, to.toPoint());
        QTest::mouseRelease(&plot, Qt::LeftButton, modifiers, to.toPoint());
    }

    KeptResponse run = ramp(100);
    ResponsePlot plot;
};

TEST_F(ResponsePlotHands, TheWheelZoomsAboutThePointer) {
    const PlotGeometry before = now();
    const QPointF at = plot.geometryShown().at(0.005, 50);
    wheel(at, 1);
    EXPECT_NEAR(now().right - now().left, (before.right - before.left) / 1.25, 1e-9);
    EXPECT_NEAR(now().x(0.005), at.x(), 1e-6) << "it stays under the pointer";
    EXPECT_EQ(now().top, before.top);
    wheel(at, -1, Qt::ControlModifier);
    EXPECT_NEAR(now().top - now().bottom, (before.top - before.bottom) * 1.25, 1e-9);
    EXPECT_NEAR(now().y(50), at.y(), 1e-6);
    for (int i = 0; i < 200; ++i)
        wheel(at, 1);
    EXPECT_GE(now().right - now().left, 1e-5) << "zooming has an end";
    QTest::mouseDClick(&plot, Qt::LeftButton);
    EXPECT_NEAR(now().right, 0.1, 1e-9) << "the whole record";
}

TEST_F(ResponsePlotHands, ADragMovesAndWithShiftItChoosesATime) {
    const PlotGeometry before = now();
    const QPointF at = plot.geometryShown().at(0.005, 50);
    drag(at, at + QPointF(40, -30));
    EXPECT_NEAR(now().x(0.005), at.x() + 40, 1.5);
    EXPECT_NEAR(now().y(50), at.y() - 30, 1.5);
    EXPECT_NEAR(now().right - now().left, before.right - before.left, 1e-9);
    plot.fitAgain();
    EXPECT_EQ(now().left, before.left);
    EXPECT_EQ(now().top, before.top);
    drag(plot.geometryShown().at(0.002, 20), plot.geometryShown().at(0.012, 90), Qt::ShiftModifier);
    EXPECT_NEAR(now().left, 0.002, 1e-4);
    EXPECT_NEAR(now().right, 0.012, 1e-4);
}

TEST_F(ResponsePlotHands, KeysDoTheSame) {
    const PlotGeometry before = now();
    QTest::keyClick(&plot, Qt::Key_Plus);
    EXPECT_NEAR(now().right - now().left, (before.right - before.left) / 1.5, 1e-9);
    QTest::keyClick(&plot, Qt::Key_Minus);
    EXPECT_NEAR(now().right, before.right, 1e-9);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_NEAR(now().left, before.left + (before.right - before.left) / 10, 1e-9);
    QTest::keyClick(&plot, Qt::Key_Home);
    EXPECT_NEAR(now().right, 0.1, 1e-9);
    QTest::keyClick(&plot, Qt::Key_A);
    EXPECT_EQ(now().right, before.right);
}

/// Between 5 and 8 ms it goes from 50 to 80 counts.
TEST_F(ResponsePlotHands, TheCursorsReadWhatIsThere) {
    EXPECT_TRUE(plot.readings().empty());
    plot.showCursors(true);
    drag(plot.geometryShown().at(now().left + (now().right - now().left) / 4, 0),
         plot.geometryShown().at(0.005, 0));
    drag(plot.geometryShown().at(now().left + (now().right - now().left) * 3 / 4, 0),
         plot.geometryShown().at(0.008, 0));
    const auto rows = plot.readings();
    ASSERT_EQ(rows.size(), 2U) << "time and A";
    const auto number = [](const QString& text) { return text.section(u' ', 0, 0).toDouble(); };
    EXPECT_NEAR(number(rows[0][1]), 5, 0.05);
    EXPECT_NEAR(number(rows[0][2]), 8, 0.05);
    EXPECT_NEAR(number(rows[0][3]), 3, 0.1);
    EXPECT_TRUE(rows[0][3].endsWith(u"Hz)"_s)) << rows[0][3].toStdString();
    EXPECT_NEAR(number(rows[1][1]), 50, 0.5);
    EXPECT_NEAR(number(rows[1][2]), 80, 0.5);
    EXPECT_NEAR(number(rows[1][3]), 30, 1);
    EXPECT_TRUE(rows[1][3].endsWith(u" counts"_s));
    plot.showCursors(false);
    EXPECT_TRUE(plot.readings().empty());
}

/// A reader of SVG need not support clipping.
TEST_F(ResponsePlotHands, NothingIsDrawnBesideAZoomedPlot) {
    drag(plot.geometryShown().at(0.004, 20), plot.geometryShown().at(0.006, 90), Qt::ShiftModifier);
    wheel(plot.geometryShown().at(0.005, 50), 5, Qt::ControlModifier);
    QImage picture(plot.size(), QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setClipping(false);
    plot.renderTo(painter);
    painter.end();
    const QColor colour = look::traceColour(0, plot.palette());
    const QRect area = now().area.toAlignedRect().adjusted(-3, -3, 3, 3);
    for (int y = area.top(); y < picture.height(); ++y)  // the legend is above
        for (int x = 0; x < picture.width(); ++x) {
            const bool inStrips =
                y > area.bottom() + 2 * plot.fontMetrics().height() && x >= area.left() && x <= area.right();
            if (area.contains(x, y) || inStrips)
                continue;
            ASSERT_FALSE(near(picture.pixelColor(x, y), colour)) << x << ' ' << y;
        }
    EXPECT_TRUE(drawn(picture, plot.geometryShown().at(0.005, 50), colour));
}

TEST(ResponseWords, NoMoreDigitsThanTheDoubtLeavesAMeaning) {
    EXPECT_EQ(texts::plusMinus({12.3456, 0.31}, u"ms"_s), u"12.3 ± 0.4 ms"_s) << "the doubt is rounded up";
    EXPECT_EQ(texts::plusMinus({12.3456, 0.14}, u"ms"_s), u"12.35 ± 0.14 ms"_s);
    EXPECT_EQ(texts::plusMinus({-834.2, 25}, u"ms"_s), u"\u2212834 ± 25 ms"_s);
    EXPECT_EQ(texts::plusMinus({-0.5, 0.5}, u"counts"_s), u"\u22120.5 ± 0.5 counts"_s);
    EXPECT_EQ(texts::plusMinus({-0.01, 0.5}, u"counts"_s), u"0.0 ± 0.5 counts"_s) << "there is no minus zero";
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const QString thousands = texts::plusMinus({-1'234.26, 0.5}, u"counts"_s);
    QLocale::setDefault(QLocale::c());
    EXPECT_EQ(thousands, u"\u22121\u202F234,3 ± 0,5 counts"_s) << "spaces separate thousands";
}

/// 1000 counts are a millimetre, and the axis is reversed: 25 counts ahead are 0.025 mm behind, and half a
/// count is 0.0005 mm either way.
TEST(ResponseWords, AnErrorOnAReversedAxisIsAsCertainAsOnAnother) {
    const AxisScale reversed = AxisScale::servo({UnitKind::Millimetres, -1'000.0, {}}, 1);
    const AxisScale forward = AxisScale::servo({UnitKind::Millimetres, 1'000.0, {}}, 1);
    const Measured error{25, 0.5};
    EXPECT_EQ(texts::responseError(error, forward), u"0.0250 ± 0.0005 mm"_s);
    EXPECT_EQ(texts::responseError(error, reversed), u"\u22120.0250 ± 0.0005 mm"_s);
    EXPECT_EQ(texts::responseErrorSize(error, forward), u"0.0250 ± 0.0005 mm"_s);
    EXPECT_EQ(texts::responseErrorSize(error, reversed), u"0.0250 ± 0.0005 mm"_s) << "it has no sign";
}

TEST(ResponseTextsOf, EveryEndOfATestSaysWhatToDo) {
    using enum ProcedureFailure;
    const std::vector loop{TravelLimit,        Unstable,    NotStill, WentOff,
                           ModuleUnresponsive, LinkSuspect, Refused,  StoppedShort};
    std::vector sines = loop;
    sines.push_back(NotFollowing);
    const std::pair<ProcedureKind, std::vector<ProcedureFailure>> kinds[] = {
        {ProcedureKind::StepResponse, loop},
        {ProcedureKind::SquareWave, loop},
        {ProcedureKind::FrequencyResponse, sines},
        {ProcedureKind::TryGains,
         {Swings, Saturates, TravelLimit, WentOff, ModuleUnresponsive, LinkSuspect, Refused}}};
    static const QRegularExpression remedy(
        u"\\b(Check|Lower|Use|Move|Step|Start|Try|These gains do not hold|Motor off ends it|lower|use|switch the motor off)\\b"_s);
    for (const auto& [kind, failures] : kinds)
        for (const ProcedureFailure failure : failures) {
            ProcedureReport report;
            report.kind = kind;
            report.stage = ProcedureStage::Failed;
            report.failure = failure;
            const auto message = texts::procedureEnded(report, {});
            ASSERT_TRUE(message);
            EXPECT_TRUE(message->headline.contains(u"Module 1"_s)) << message->headline.toStdString();
            EXPECT_TRUE(message->body.contains(remedy))
                << static_cast<int>(kind) << ' ' << static_cast<int>(failure) << ": "
                << message->body.toStdString();
        }
    ProcedureReport done;
    done.kind = ProcedureKind::StepResponse;
    done.stage = ProcedureStage::Done;
    EXPECT_FALSE(texts::procedureEnded(done, {}));
}

TEST(ResponseTextsOf, GainsThatWereKeptAreNotSaidToBeThePreviousOnes) {
    for (const ProcedureFailure failure : {ProcedureFailure::LinkSuspect, ProcedureFailure::Refused}) {
        ProcedureReport report;
        report.kind = ProcedureKind::TryGains;
        report.stage = ProcedureStage::Failed;
        report.failure = failure;
        report.kept = true;
        const auto message = texts::procedureEnded(report, {});
        ASSERT_TRUE(message);
        EXPECT_EQ(message->headline, u"The new gains of Module 1 are in force; OL may still be lowered."_s);
        EXPECT_TRUE(message->body.endsWith(u"Apply the gains again."_s)) << message->body.toStdString();
    }
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepplot.h"
#include "stepruns.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"
#include "widgets/response/stepresponsewords.h"

namespace nmc {
namespace {

bool near(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 90;
}

/// Of a line of pixels across the curve at that point.
bool drawn(const QImage& picture, const QPointF& at, const QColor& colour) {
    for (int y = -3; y <= 3; ++y)
        if (near(picture.pixelColor(at.toPoint() + QPoint(0, y)), colour))
            return true;
    return false;
}

TEST(StepPlotPicture, ASolidBDashedFromWhereTheyBegan) {
    StepPlot plot;
    plot.resize(600, 400);
    const KeptRun a = ramp(120);
    KeptRun b = ramp(60);
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
        EXPECT_TRUE(drawn(picture, plot.pointAt(seconds, 120), colourA)) << seconds;
        dashes += drawn(picture, plot.pointAt(seconds, 60), colourB) ? 1 : 0;
    }
    EXPECT_GT(dashes, 40);
    EXPECT_LT(dashes, 85);
    EXPECT_TRUE(drawn(picture, plot.pointAt(0.005, 60), colourA)) << "half-way up";
    EXPECT_FALSE(drawn(picture, plot.pointAt(-0.005, 60), colourA));
}

TEST(StepPlotPicture, TwoRunsOfOneModuleHaveOneUnit) {
    StepPlot plot;
    KeptRun inMillimetres = ramp(100);
    inMillimetres.scale = AxisScale::servo({UnitKind::Millimetres, 50.0, {}}, 1);
    KeptRun inCounts = ramp(100);
    plot.showRuns(&inMillimetres, &inCounts);
    EXPECT_TRUE(plot.legendText(1).endsWith(u"mm"_s)) << plot.legendText(1).toStdString();
    inCounts.run.module = ModuleIndex(1);
    plot.showRuns(&inMillimetres, &inCounts);
    EXPECT_TRUE(plot.legendText(1).endsWith(u"counts"_s)) << plot.legendText(1).toStdString();
}

TEST(StepPlotPicture, NoLineCrossesAGap) {
    StepPlot plot;
    plot.resize(600, 400);
    KeptRun run = ramp(100);
    auto& points = run.run.points;
    points.erase(std::remove_if(points.begin(), points.end(),
                                [](const StepPoint& p) { return p.seconds > 0.04 && p.seconds < 0.06; }),
                 points.end());
    for (StepPoint& point : points)
        point.position = point.seconds > 0.01 ? 560 : point.position;
    setBand(run.run, kFirstBand);
    plot.showRuns(&run, nullptr);
    QTest::mouseDClick(&plot, Qt::LeftButton);
    plot.grab();
    const QImage picture = plot.grab().toImage();
    const QColor colour = look::traceColour(0, plot.palette());
    EXPECT_TRUE(drawn(picture, plot.pointAt(0.03, 60), colour));
    EXPECT_FALSE(drawn(picture, plot.pointAt(0.05, 60), colour));
    EXPECT_TRUE(drawn(picture, plot.pointAt(0.07, 60), colour));
}

TEST(StepResponseWords, NoMoreDigitsThanTheDoubtLeavesAMeaning) {
    EXPECT_EQ(texts::plusMinus({12.3456, 0.31}, u"ms"_s), u"12.3 ± 0.4 ms"_s) << "the doubt is rounded up";
    EXPECT_EQ(texts::plusMinus({12.3456, 0.14}, u"ms"_s), u"12.35 ± 0.14 ms"_s);
    EXPECT_EQ(texts::plusMinus({-834.2, 25}, u"ms"_s), u"\u2212834 ± 25 ms"_s);
    EXPECT_EQ(texts::plusMinus({-0.5, 0.5}, u"counts"_s), u"\u22120.5 ± 0.5 counts"_s);
    EXPECT_EQ(texts::plusMinus({-0.01, 0.5}, u"counts"_s), u"0.0 ± 0.5 counts"_s) << "no minus zero";
}

TEST(StepResponseTexts, EveryEndOfAStepHasItsSentences) {
    for (const ProcedureFailure failure :
         {ProcedureFailure::TravelLimit, ProcedureFailure::Unstable, ProcedureFailure::NotStill,
          ProcedureFailure::WentOff, ProcedureFailure::ModuleSilent, ProcedureFailure::LinkSuspect,
          ProcedureFailure::Refused}) {
        ProcedureReport report;
        report.kind = ProcedureKind::StepResponse;
        report.stage = ProcedureStage::Failed;
        report.failure = failure;
        const auto message = texts::procedureEnded(report, {});
        ASSERT_TRUE(message);
        EXPECT_TRUE(message->headline.startsWith(u"Module 1 "_s)) << message->headline.toStdString();
        EXPECT_FALSE(message->body.isEmpty());
    }
    ProcedureReport done;
    done.kind = ProcedureKind::StepResponse;
    done.stage = ProcedureStage::Done;
    EXPECT_FALSE(texts::procedureEnded(done, {}));
}

}  // namespace
}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/squareplot.h"

#include <QPainter>
#include <algorithm>
#include <iterator>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/unitwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kSpreadAlpha = 60;
constexpr float kPreviousOpacity = 0.35F;
}  // namespace

SquarePlot::SquarePlot(QWidget* parent) : RecordPlot({26, 14}, {14, 8}, parent) {
    look::name(this, u"squarePlot"_s, tr("Square wave, one period"));
    setToolTip(tr(
        "All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains. Double-click to show everything. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time."));
    adoptPalette();
    fit();
}

SquarePlot::Curve SquarePlot::curveOf(const std::vector<FoldedPoint>& points, double from, double since,
                                      const AxisScale& scale) {
    Curve curve;
    for (const FoldedPoint& point : points) {
        const double at = since + point.seconds;
        curve.median << QPointF(at, scale.position(from + point.position));
        curve.low << QPointF(at, scale.position(from + point.low));
        curve.high << QPointF(at, scale.position(from + point.high));
    }
    return curve;
}

void SquarePlot::showFold(const Fold& now, const Fold& before, const AxisScale& scale) {
    const auto curvesOf = [&](const Fold& fold) {
        const double side = fold.counts / 2;
        return std::vector{curveOf(fold.forward, -side, 0, scale),
                           curveOf(fold.back, side, fold.half, scale)};
    };
    m_now = curvesOf(now);
    m_before = curvesOf(before);
    m_command.clear();
    const double side = scale.position(now.counts / 2);
    if (!now.forward.empty() || !now.back.empty())
        m_command << QPointF(-toSeconds(kBeforeStep), -side) << QPointF(0, -side) << QPointF(0, side)
                  << QPointF(now.half, side) << QPointF(now.half, -side) << QPointF(2 * now.half, -side);
    m_unit = texts::unitOf(scale);
    refreshLegend();
    fit();
}

void SquarePlot::refreshLegend() {
    std::vector<PlotFrame::LegendEntry> legend;
    if (!m_command.empty())
        legend = {{tr("median, %1").arg(m_unit), look::traceColour(0, palette()), false},
                  {tr("command"), look::mutedText(palette()), true}};
    m_frame.setLegend(legend);
    update();
}

RecordPlot::View SquarePlot::fitted() const {
    QRectF all = m_command.boundingRect();
    for (const auto* curves : {&m_now, &m_before})
        for (const Curve& curve : *curves)
            for (const QPolygonF* line : {&curve.low, &curve.high})
                if (!line->empty())
                    all = all.united(line->boundingRect());
    if (m_command.empty())
        all = QRectF(0, -1, 0.5, 2);
    return {all.left(), all.right(), all.top(), all.bottom()};
}

QMargins SquarePlot::room() const {
    const int em = fontMetrics().height();
    return {0, 0, em * 3 / 2, em};
}

void SquarePlot::paintTraces(QPainter& painter) {
    if (m_command.empty()) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(
            m_geometry.area, Qt::AlignCenter | Qt::TextWordWrap,
            tr("No edge recorded yet. A square wave overlays many steps while you change gains."));
        return;
    }
    painter.setClipRect(m_geometry.area);
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashLine));
    painter.drawPolyline(m_geometry.at(m_command));
    QColor colour = look::traceColour(0, palette());
    colour.setAlphaF(kPreviousOpacity);
    painter.setPen(QPen(colour, 1));
    for (const Curve& curve : m_before)
        painter.drawPolyline(m_geometry.at(curve.median));
    colour.setAlpha(kSpreadAlpha);
    for (const Curve& curve : m_now) {
        QPolygonF around = m_geometry.at(curve.low);
        const QPolygonF above = m_geometry.at(curve.high);
        std::copy(above.rbegin(), above.rend(), std::back_inserter(around));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(around);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(look::traceColour(0, palette()), kTraceWidth));
    for (const Curve& curve : m_now)
        painter.drawPolyline(m_geometry.at(curve.median));
}

}  // namespace nmc

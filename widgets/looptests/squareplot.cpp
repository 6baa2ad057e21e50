// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/squareplot.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/unitwords.h"
#include "widgets/scope/axisrange.h"
#include "widgets/scope/timewindow.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kSpreadAlpha = 60;
constexpr float kPreviousOpacity = 0.35F;
}  // namespace

SquarePlot::SquarePlot(QWidget* parent) : QWidget(parent) {
    look::name(this, u"squarePlot"_s, tr("Square wave, one period"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setToolTip(tr(
        "All edges with the present gains, overlaid: the line is their median, the shaded band holds 80 % of the samples. Pale: the previous gains."));
    connect(&m_frame, &PlotFrame::changed, this, qOverload<>(&QWidget::update));
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
    m_frame.setLegend(m_command.empty() ? std::vector<PlotFrame::LegendEntry>{}
                                        : std::vector<PlotFrame::LegendEntry>{
                                              {tr("median, %1").arg(texts::unitOf(scale)),
                                               look::traceColour(0, palette()), false},
                                              {tr("command"), look::mutedText(palette()), true}});
    fit();
}

void SquarePlot::adoptPalette() {
    m_frame.setLook(palette(), look::tabular(look::scaled(font(), 0.9)));
    update();
}

void SquarePlot::fit() {
    QRectF all = m_command.boundingRect();
    for (const auto* curves : {&m_now, &m_before})
        for (const Curve& curve : *curves)
            for (const QPolygonF* line : {&curve.low, &curve.high})
                if (!line->empty())
                    all = all.united(line->boundingRect());
    if (m_command.empty())
        all = QRectF(0, -1, 0.5, 2);
    const int em = fontMetrics().height();
    const int rows = std::clamp((height() - 3 * em) * 2 / (em * 3), 2, 8);
    const AxisRange::Range range = AxisRange::around(all.top(), all.bottom(), 0, rows);
    m_frame.setValueAxis(range.min, range.max, range.step);
    m_frame.setMargins(m_frame.labelWidth(), em * 3 / 2, em);
    const int columns = std::clamp(width() / (em * 5), 2, 10);
    const double division = TimeWindow::nice(all.width() / columns);
    m_frame.setTimeAxis(all.left(), all.right(), division, division);
    m_geometry = {m_frame.plotArea(), all.left(), all.right(), range.min, range.max};
    update();
}

QPolygonF SquarePlot::placed(const QPolygonF& line) const {
    QPolygonF places;
    places.reserve(line.size());
    for (const QPointF& point : line)
        places << QPointF(m_geometry.x(point.x()), m_geometry.y(point.y()));
    return places;
}

void SquarePlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_frame.picture(devicePixelRatioF()));
    m_geometry.area = m_frame.plotArea();
    if (m_geometry.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_command.empty()) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(
            m_geometry.area, Qt::AlignCenter | Qt::TextWordWrap,
            tr("No edge recorded yet. A square wave overlays many steps while you change gains."));
        return;
    }
    painter.setClipRect(m_geometry.area);
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashLine));
    painter.drawPolyline(placed(m_command));
    QColor colour = look::traceColour(0, palette());
    colour.setAlphaF(kPreviousOpacity);
    painter.setPen(QPen(colour, 1));
    for (const Curve& curve : m_before)
        painter.drawPolyline(placed(curve.median));
    colour.setAlpha(kSpreadAlpha);
    for (const Curve& curve : m_now) {
        QPolygonF around = placed(curve.low);
        const QPolygonF above = placed(curve.high);
        std::copy(above.rbegin(), above.rend(), std::back_inserter(around));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(around);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(look::traceColour(0, palette()), kTraceWidth));
    for (const Curve& curve : m_now)
        painter.drawPolyline(placed(curve.median));
    m_frame.paintLegend(painter);
}

void SquarePlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_frame.resize(size());
    fit();
}

void SquarePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        adoptPalette();
}

QSize SquarePlot::sizeHint() const {
    return {fontMetrics().height() * 26, fontMetrics().height() * 14};
}

QSize SquarePlot::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 8};
}

}  // namespace nmc

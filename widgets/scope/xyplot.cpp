// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/xyplot.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"

namespace nmc {

using namespace Qt::StringLiterals;

XyPlot::XyPlot(QWidget* parent) : RecordPlot({26, 24}, {14, 12}, parent) {
    look::name(this, u"xyPlot"_s, tr("One signal over another"));
    setToolTip(tr(
        "Each sample of the vertical signal, over the value of the horizontal one at the same time. The dot marks the last one. Double-click to show everything. Scroll to zoom horizontally, or vertically with Ctrl; drag to pan."));
    m_frame.setTimeUnit({});
    adoptPalette();
    fit();
}

void XyPlot::showCurve(std::vector<XyPoint> curve, const QString& label) {
    m_curve = std::move(curve);
    m_label = m_curve.empty() ? QString() : label;
    refreshLegend();
    fit();
}

RecordPlot::View XyPlot::fitted() const {
    if (m_curve.empty())
        return {-1, 1, -1, 1};
    const auto [left, right] = std::ranges::minmax(m_curve, {}, &XyPoint::x);
    const auto [bottom, top] = std::ranges::minmax(m_curve, {}, &XyPoint::y);
    constexpr double kMargin = 0.05;
    const double margin = left.x < right.x ? kMargin * (right.x - left.x) : 1;
    return {left.x - margin, right.x + margin, bottom.y, top.y};
}

void XyPlot::paintTraces(QPainter& painter) {
    if (m_curve.empty())
        return;
    painter.setClipRect(m_geometry.area);
    painter.setPen(QPen(look::traceColour(0, palette()), kTraceWidth));
    QPolygonF line;
    for (const XyPoint& point : m_curve) {
        if (!point.joined)
            painter.drawPolyline(std::exchange(line, {}));
        line << m_geometry.at(point.x, point.y);
    }
    painter.drawPolyline(line);
    const double radius = fontMetrics().height() / 5.0;
    painter.setBrush(painter.pen().color());
    painter.drawEllipse(line.last(), radius, radius);
}

}  // namespace nmc

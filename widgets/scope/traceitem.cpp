// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/traceitem.h"

#include <QPainter>
#include <cmath>

namespace nmc {

namespace {
constexpr double kPenWidth = 1.6;
constexpr double kDashPeriod = 9.0;  ///< px along the time axis
constexpr double kDashShare = 0.6;
}  // namespace

TraceItem::TraceItem(QGraphicsItem* parent) : QGraphicsItem(parent) {
    setZValue(10);
    setAcceptedMouseButtons(Qt::NoButton);
}

void TraceItem::setArea(const QRectF& area) {
    if (area == m_area)
        return;
    prepareGeometryChange();
    m_area = area;
}

void TraceItem::setTimeAxis(TimePoint origin, double left, double right) {
    m_origin = origin;
    m_left = left;
    m_right = right;
}

void TraceItem::setValueAxis(double bottom, double top) {
    m_bottom = bottom;
    m_top = top;
}

QPointF TraceItem::map(const SeriesPoint& point) const {
    const double seconds = toSeconds(point.time - m_origin);
    return {m_area.left() + (seconds - m_left) / (m_right - m_left) * m_area.width(),
            m_area.bottom() - (point.value - m_bottom) / (m_top - m_bottom) * m_area.height()};
}

void TraceItem::addSolid(const Series::Segment& segment, Lines& lines) const {
    QPointF before = map(segment.front());
    if (segment.size() == 1)
        lines.append(QLineF(before.x() - kPenWidth, before.y(), before.x() + kPenWidth, before.y()));
    for (std::size_t i = 1; i < segment.size(); ++i) {
        const QPointF here = map(segment[i]);
        lines.append(QLineF(before, here));
        before = here;
    }
}

/// Dashes that hang on the time of the data, so that they roll with it instead of crawling along it. Where
/// the trace is steep a gap would hide something, so it is drawn through.
void TraceItem::addDashed(const Series::Segment& segment, Lines& lines) const {
    const double perSecond = m_area.width() / (m_right - m_left);
    QPointF before = map(segment.front());
    double phase = toSeconds(segment.front().time - m_origin) * perSecond / kDashPeriod;
    for (std::size_t i = 1; i < segment.size(); ++i) {
        const QPointF here = map(segment[i]);
        const double next = toSeconds(segment[i].time - m_origin) * perSecond / kDashPeriod;
        if (std::abs(here.y() - before.y()) > 2 * std::abs(here.x() - before.x()) + 4) {
            lines.append(QLineF(before, here));
        } else if (next > phase) {
            for (double dash = std::floor(phase); dash < next; dash += 1.0) {
                const double from = std::max(dash, phase);
                const double to = std::min(dash + kDashShare, next);
                if (to <= from)
                    continue;
                const QLineF whole(before, here);
                lines.append(QLineF(whole.pointAt((from - phase) / (next - phase)),
                                    whole.pointAt((to - phase) / (next - phase))));
            }
        }
        before = here;
        phase = next;
    }
}

void TraceItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/, QWidget* /*widget*/) {
    if (m_area.isEmpty() || m_right <= m_left || m_top <= m_bottom)
        return;
    painter->save();
    painter->setClipRect(m_area);
    Lines lines;
    for (const Trace& trace : m_traces) {
        lines.clear();
        for (const Series::Segment& segment : trace.segments) {
            if (segment.empty())
                continue;
            if (trace.dashed)
                addDashed(segment, lines);
            else
                addSolid(segment, lines);
        }
        painter->setPen(
            QPen(trace.colour, kPenWidth, Qt::SolidLine, trace.dashed ? Qt::FlatCap : Qt::RoundCap));
        painter->drawLines(lines.constData(), static_cast<int>(lines.size()));
    }
    painter->restore();
}

}  // namespace nmc

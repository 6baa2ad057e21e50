// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <QVarLengthArray>
#include <vector>

#include "model/series.h"

namespace nmc {

/// What one trace looks like and what it shows in the present frame.
struct Trace {
    QColor colour;
    bool dashed = false;  ///< calculated
    std::vector<Series::Segment> segments;
};

/// Draws all traces of one strip in the chart's plot area, with drawLines: QLineSeries costs a hundred times
/// more (scope.md). A gap between segments stays a gap.
class TraceItem : public QGraphicsItem {
public:
    explicit TraceItem(QGraphicsItem* parent);

    /// Where the axes lie, in the parent's coordinates.
    void setArea(const QRectF& area);
    /// What the axes say: seconds since `origin`, and values.
    void setTimeAxis(TimePoint origin, double left, double right);
    void setValueAxis(double bottom, double top);
    std::vector<Trace>& traces() { return m_traces; }

    [[nodiscard]] QRectF boundingRect() const override { return m_area; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    using Lines = QVarLengthArray<QLineF, 1024>;
    [[nodiscard]] QPointF map(const SeriesPoint& point) const;
    void addSolid(const Series::Segment& segment, Lines& lines) const;
    void addDashed(const Series::Segment& segment, Lines& lines) const;

    QRectF m_area;
    TimePoint m_origin;
    double m_left = 0;
    double m_right = 1;
    double m_bottom = 0;
    double m_top = 1;
    std::vector<Trace> m_traces;
};

}  // namespace nmc

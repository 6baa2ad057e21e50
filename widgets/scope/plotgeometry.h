// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <optional>

namespace nmc {

/// The place and the ranges of a strip's axes: seconds since the history's zero, and values in the unit of
/// the axis.
struct PlotGeometry {
    QRectF area;
    double left = 0, right = 1;
    double bottom = 0, top = 1;

    [[nodiscard]] double x(double seconds) const {
        return area.left() + (seconds - left) / (right - left) * area.width();
    }
    [[nodiscard]] double y(double value) const {
        return area.bottom() - (value - bottom) / (top - bottom) * area.height();
    }
    [[nodiscard]] double seconds(double x) const {
        return left + (x - area.left()) / area.width() * (right - left);
    }
    [[nodiscard]] double value(double y) const {
        return bottom + (area.bottom() - y) / area.height() * (top - bottom);
    }
    /// Where this point is drawn.
    [[nodiscard]] QPointF at(double seconds, double value) const { return {x(seconds), y(value)}; }
    /// Where a line of such points is drawn.
    [[nodiscard]] QPolygonF at(const QPolygonF& line) const;
    /// The line from left to right at a value.
    [[nodiscard]] QLineF across(double value) const {
        return {area.left(), y(value), area.right(), y(value)};
    }
    /// The line from top to bottom at a time.
    [[nodiscard]] QLineF down(double seconds) const {
        return {x(seconds), area.top(), x(seconds), area.bottom()};
    }
    [[nodiscard]] bool empty() const { return area.isEmpty() || right <= left || top <= bottom; }
};

/// The part of a line that is within an area, and where it begins and ends, as fractions of the line.
struct LinePart {
    QLineF line;
    double from, to;
};
/// Nothing if there is no such part. When zoomed in far enough, a line between two samples is millions of
/// pixels long: too much for the dashes and for the rasterizer. An SVG file has no clipping at all.
[[nodiscard]] std::optional<LinePart> partWithin(const QRectF& area, const QLineF& line);

}  // namespace nmc

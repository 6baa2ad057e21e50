// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

#include "model/scope/history.h"

class QPainter;

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
    [[nodiscard]] bool empty() const { return area.isEmpty() || right <= left || top <= bottom; }
};

/// Converts counts to the values that are drawn.
struct LinearScale {
    double factor = 1;
    double offset = 0;
    [[nodiscard]] double operator()(double counts) const { return counts * factor + offset; }
    bool operator==(const LinearScale&) const = default;
};

/// The look of one trace, and its content in the present frame. On the screen it is drawn with drawLines, or
/// column by column where it is dense: QLineSeries would cost a hundred times as much, and drawPolyline ten
/// times (scope.md).
class TraceDrawing {
public:
    QColor colour;
    bool dashed = false;  ///< for a command position
    QString tag;          ///< written at the end of the trace, where hue alone does not distinguish traces

    /// Takes the samples that are visible in `geometry`'s time; its range of values does not matter yet.
    void take(const ModuleHistory& history, ScopeSignal signal, const LinearScale& scale, TimePoint zero,
              const PlotGeometry& geometry, double devicePixelRatio);
    void clear();
    /// Extremes within the visible time; lowest > highest if there are no values.
    [[nodiscard]] double lowest() const { return m_lowest; }
    [[nodiscard]] double highest() const { return m_highest; }
    /// Extremes of the band of a calculated error within the visible time; for other signals, those of the
    /// values.
    [[nodiscard]] double lowestBand() const { return m_lowestBand; }
    [[nodiscard]] double highestBand() const { return m_highestBand; }

    /// The painter is clipped to the plot area.
    void paint(QPainter& painter, const PlotGeometry& geometry) const;

private:
    /// At most a device pixel wide, or one sample.
    struct Column {
        double left, right;  ///< s
        double entry, exit;
        double bandLow, bandHigh;  ///< of a calculated error
        bool joined;               ///< to the previous column
    };
    [[nodiscard]] static double dashesPerSecond(const PlotGeometry& geometry);
    /// Passes each visible line to `add`, clipped, with the times of its ends.
    template <typename Add>
    void visitLines(const PlotGeometry& geometry, Add&& add) const;
    void paintLines(QPainter& painter, const PlotGeometry& geometry) const;
    void paintPath(QPainter& painter, const PlotGeometry& geometry) const;
    void paintDense(QPainter& painter, const PlotGeometry& geometry) const;
    void paintBand(QPainter& painter, const PlotGeometry& geometry) const;
    void paintTag(QPainter& painter, const PlotGeometry& geometry) const;

    std::vector<Column> m_columns;
    double m_lowest = 1, m_highest = 0;
    double m_lowestBand = 1, m_highestBand = 0;
    bool m_hasBand = false;
};

}  // namespace nmc

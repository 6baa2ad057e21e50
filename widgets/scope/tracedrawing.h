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

/// Where a strip's axes lie and what they say: seconds since the history's zero, and values in the unit of
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

/// From counts to what is drawn.
struct LinearScale {
    double factor = 1;
    double offset = 0;
    [[nodiscard]] double operator()(double counts) const { return counts * factor + offset; }
    bool operator==(const LinearScale&) const = default;
};

/// What one trace looks like, and what it shows in the present frame. Drawn with drawLines: QLineSeries
/// costs a hundred times more, and drawPolyline ten times (scope.md).
class TraceDrawing {
public:
    QColor colour;
    bool dashed = false;  ///< commanded
    QString tag;          ///< written at its end, where hue alone does not tell traces apart

    /// Takes what is to be seen in `geometry`'s time; the values of its axis do not matter yet.
    void take(const ModuleHistory& history, ScopeSignal signal, const LinearScale& scale, TimePoint zero,
              const PlotGeometry& geometry, double devicePixelRatio);
    void clear();
    /// Of what is within the time that is seen; lowest > highest where nothing is.
    [[nodiscard]] double lowest() const { return m_lowest; }
    [[nodiscard]] double highest() const { return m_highest; }
    /// The same of a calculated error's band; of others, as above.
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
        bool joined;               ///< to the one before
    };
    [[nodiscard]] static double dashesPerSecond(const PlotGeometry& geometry);
    /// Each line that is seen, clipped, from one time to another.
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

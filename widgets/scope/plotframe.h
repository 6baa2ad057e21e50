// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>
#include <QPixmap>
#include <QString>
#include <vector>

#include "widgets/scope/plotgeometry.h"

class QPainter;

namespace nmc {

/// Background, axes, grid and legend of a plot. All but the legend is drawn into a picture that is drawn
/// again only when it changes; the traces are painted over it, and the legend over them, inside the plot
/// area. docs/scope.md says why this is not a chart of Qt Charts.
class PlotFrame : public QObject {
    Q_OBJECT

public:
    struct LegendEntry {
        QString label;
        QColor colour;
        bool dashed = false;
        bool operator==(const LegendEntry&) const = default;
    };

    using QObject::QObject;

    void setLegend(const std::vector<LegendEntry>& entries);
    [[nodiscard]] QString legendText(std::size_t entry) const;
    void setLook(const QPalette& palette, const QFont& font);
    void resize(const QSizeF& size);
    /// Space to the left of the plot area (for labels), to its right, and below it.
    void setMargins(int left, int right, int bottom);
    /// `labelInterval` 0: this plot shows no times.
    void setTimeAxis(double left, double right, double division, double labelInterval);
    /// For a plot over something else than time; empty: the numbers stand alone.
    void setTimeUnit(const QString& unit);
    void setValueAxis(double bottom, double top, double interval);

    [[nodiscard]] QRectF plotArea() const;
    [[nodiscard]] PlotGeometry geometry() const {
        return {plotArea(), m_times.from, m_times.to, m_values.from, m_values.to};
    }
    /// Width that the numbers to the left of the plot area need.
    [[nodiscard]] int labelWidth() const { return m_labelWidth; }
    /// Returns the picture for the screen.
    [[nodiscard]] const QPixmap& picture(double devicePixelRatio);
    /// Draws vectors, for paper.
    void render(QPainter& painter) const;
    void paintLegend(QPainter& painter);

signals:
    /// The picture, the legend or the position of the plot area has changed.
    void changed();

private:
    /// An axis of the plot area; its lines and numbers are at multiples of an interval.
    struct Axis {
        double from = 0, to = 0, interval = 1;
        bool operator==(const Axis&) const = default;
        [[nodiscard]] std::vector<double> multiplesOf(double interval) const;
    };
    template <typename T>
    void set(T& part, const T& value);
    /// The place of a legend entry, and its label as far as there is room for it.
    struct Placed {
        QRectF area;
        QString label;
    };
    void invalidate();
    void measureLabels();
    [[nodiscard]] std::vector<Placed> placedLegend() const;
    void drawLegend(QPainter& painter, const std::vector<Placed>& entries) const;
    void paintLines(QPainter& painter) const;
    void paintNumbers(QPainter& painter) const;
    [[nodiscard]] double textHeight() const;
    [[nodiscard]] double gap() const;

    QSizeF m_size;
    QMargins m_margins;
    QFont m_font;
    QColor m_text, m_base, m_axes, m_grid;
    Axis m_values, m_times;
    double m_labelInterval = 0;
    int m_labelWidth = 0;  ///< stored because text is slow to measure, and every frame asks
    QString m_timeUnit{QLatin1Char('s')};
    std::vector<LegendEntry> m_legend;
    QPixmap m_picture;
    bool m_outdated = true;
    QPixmap m_legendPicture;  ///< null if it must be drawn again
    QPointF m_legendAt;
};

}  // namespace nmc

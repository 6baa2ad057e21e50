// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QGraphicsScene>
#include <QObject>
#include <QPalette>
#include <QPixmap>
#include <QString>
#include <vector>

class QChart;
class QLineSeries;
class QPainter;

namespace nmc {

class AxisGrid;

/// Axes, grid and legend of a strip, a chart of Qt Charts drawn into a picture that is made anew only when
/// one of them changes; the traces are painted over it. The one place that knows Qt Charts, which is
/// deprecated.
class ChartBackdrop : public QObject {
    Q_OBJECT

public:
    struct LegendEntry {
        QString label;
        QColor colour;
        bool dashed = false;
        bool operator==(const LegendEntry&) const = default;
    };

    explicit ChartBackdrop(QObject* parent = nullptr);

    void setLegend(const std::vector<LegendEntry>& entries);
    [[nodiscard]] QString legendText(std::size_t entry) const;
    void setLook(const QPalette& palette, const QFont& font);
    void resize(const QSizeF& size);
    /// Left of the plot area for labels, right, and below.
    void setMargins(int left, int right, int bottom);
    /// `labelInterval` 0: this strip does not say the time.
    void setTimeAxis(double left, double right, double division, double labelInterval);
    void setValueAxis(double bottom, double top, double interval);

    [[nodiscard]] QRectF plotArea() const;
    /// Room that the numbers left of the plot area need.
    [[nodiscard]] int labelWidth() const;
    /// For the screen.
    [[nodiscard]] const QPixmap& picture(double devicePixelRatio);
    /// For paper, in vectors.
    void render(QPainter& painter);

signals:
    /// The picture, or where the plot area lies.
    void changed();

private:
    void invalidate();

    QGraphicsScene m_scene;
    QChart* m_chart;
    AxisGrid* m_grid;
    std::vector<QLineSeries*> m_series;  ///< without data: they are there for the legend
    std::vector<LegendEntry> m_entries;
    QPixmap m_picture;
    bool m_outdated = true;
};

}  // namespace nmc

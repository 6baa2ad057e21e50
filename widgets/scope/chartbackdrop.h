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

/// Axes, grid and legend of a strip: a chart of Qt Charts, drawn into a picture that is drawn again only when
/// one of them changes; the traces are painted over it. The only class that uses Qt Charts, which is
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
    /// Space to the left of the plot area (for labels), to its right, and below it.
    void setMargins(int left, int right, int bottom);
    /// `labelInterval` 0: this strip shows no times.
    void setTimeAxis(double left, double right, double division, double labelInterval);
    void setValueAxis(double bottom, double top, double interval);

    [[nodiscard]] QRectF plotArea() const;
    /// Width that the numbers to the left of the plot area need.
    [[nodiscard]] int labelWidth() const;
    /// Returns the picture for the screen.
    [[nodiscard]] const QPixmap& picture(double devicePixelRatio);
    /// Draws vectors, for paper.
    void render(QPainter& painter);

signals:
    /// The picture or the position of the plot area has changed.
    void changed();

private:
    void invalidate();

    QGraphicsScene m_scene;
    QChart* m_chart;
    AxisGrid* m_grid;
    std::vector<QLineSeries*> m_series;  ///< without data, for the legend only
    std::vector<LegendEntry> m_entries;
    QPixmap m_picture;
    bool m_outdated = true;
};

}  // namespace nmc

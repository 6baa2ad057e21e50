// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QGraphicsItem>
#include <vector>

namespace nmc {

/// The axes of a strip: lines, grid and numbers. They replace those of Qt Charts: the width of its numbers
/// cannot be known in advance, so strips that share a time axis would not line up, and numbers that are close
/// together become dots; and its axes lay out an item for each line and number, which is most of the cost of
/// a chart.
class AxisGrid : public QGraphicsItem {
public:
    explicit AxisGrid(QGraphicsItem* parent);

    struct Look {
        QFont font;
        QColor text, axes, grid;
    };
    void setLook(const Look& look);
    /// The plot area, in the parent's coordinates.
    void setArea(const QRectF& area);
    /// Returns true if this changes anything.
    bool setValues(double bottom, double top, double interval);
    /// Returns true if this changes anything. `labelInterval` 0: this strip shows no times.
    bool setTimes(double left, double right, double division, double labelInterval);

    /// Width that the values need to the left of the plot area, whatever the layout.
    [[nodiscard]] int widthNeeded() const;

    [[nodiscard]] QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void paintLines(QPainter& painter) const;
    void paintValues(QPainter& painter) const;
    void paintTimes(QPainter& painter) const;
    [[nodiscard]] double gap() const;

    /// An axis of the plot area; its lines and numbers are at multiples of an interval.
    struct Axis {
        double from = 0, to = 0, interval = 1;
        bool operator==(const Axis&) const = default;
        [[nodiscard]] std::vector<double> multiplesOf(double interval) const;
    };
    [[nodiscard]] double x(double seconds) const;
    [[nodiscard]] double y(double value) const;

    Look m_look;
    QRectF m_area;
    Axis m_values, m_times;
    double m_labelInterval = 0;
};

}  // namespace nmc

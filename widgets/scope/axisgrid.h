// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QGraphicsItem>
#include <vector>

namespace nmc {

/// The axes of a strip: their lines, grid and numbers. Qt Charts' own numbers have a width that cannot be
/// known beforehand, so strips with one time axis would not line up, and become dots where they are close;
/// and its axes lay out an item for each line and number, which is most of what a chart costs.
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
    /// Whether this changes anything, here and below.
    bool setValues(double bottom, double top, double interval);
    /// `labelInterval` 0: this strip does not say the time.
    bool setTimes(double left, double right, double division, double labelInterval);

    /// Room that the values need left of the plot area, whatever the layout.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QGraphicsItem>

namespace nmc {

/// The numbers at the axes of a strip. Qt Charts' own have a width that cannot be known beforehand, so strips
/// with one time axis would not line up; and they become dots where they are close.
class AxisLabels : public QGraphicsItem {
public:
    explicit AxisLabels(QGraphicsItem* parent);

    void setLook(const QFont& font, const QColor& colour);
    /// The plot area, in the parent's coordinates.
    void setArea(const QRectF& area);
    void setValues(double bottom, double top, double interval);
    /// `interval` 0: this strip does not say the time.
    void setTimes(double left, double right, double interval);

    /// Room that the values need left of the plot area, whatever the layout.
    [[nodiscard]] int widthNeeded() const;

    [[nodiscard]] QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void paintValues(QPainter& painter) const;
    void paintTimes(QPainter& painter) const;
    [[nodiscard]] double gap() const;

    QFont m_font;
    QColor m_colour;
    QRectF m_area;
    double m_bottom = 0, m_top = 1, m_valueInterval = 1;
    double m_left = 0, m_right = 1, m_timeInterval = 0;
};

}  // namespace nmc

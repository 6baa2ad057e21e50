// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/axislabels.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString timeText(double seconds, double interval) {
    return texts::numberAt(seconds, interval) + u" s"_s;
}

}  // namespace

AxisLabels::AxisLabels(QGraphicsItem* parent) : QGraphicsItem(parent) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void AxisLabels::setLook(const QFont& font, const QColor& colour) {
    prepareGeometryChange();
    m_font = font;
    m_colour = colour;
    update();
}

void AxisLabels::setArea(const QRectF& area) {
    if (area == m_area)
        return;
    prepareGeometryChange();
    m_area = area;
}

void AxisLabels::setValues(double bottom, double top, double interval) {
    if (bottom == m_bottom && top == m_top && interval == m_valueInterval)
        return;
    prepareGeometryChange();
    m_bottom = bottom;
    m_top = top;
    m_valueInterval = interval;
    update();
}

void AxisLabels::setTimes(double left, double right, double interval) {
    if (left == m_left && right == m_right && interval == m_timeInterval)
        return;
    m_left = left;
    m_right = right;
    m_timeInterval = interval;
    update();
}

double AxisLabels::gap() const {
    return QFontMetricsF(m_font).height() * 0.4;
}

int AxisLabels::widthNeeded() const {
    const QFontMetricsF metrics(m_font);
    const double widest = std::max(metrics.horizontalAdvance(texts::numberAt(m_bottom, m_valueInterval)),
                                   metrics.horizontalAdvance(texts::numberAt(m_top, m_valueInterval)));
    return static_cast<int>(std::ceil(widest + gap()));
}

QRectF AxisLabels::boundingRect() const {
    const double height = QFontMetricsF(m_font).height();
    return m_area.adjusted(-widthNeeded(), -height, 3 * height, 2 * height);
}

void AxisLabels::paintValues(QPainter& painter) const {
    const double height = QFontMetricsF(m_font).height();
    const double perUnit = m_area.height() / (m_top - m_bottom);
    for (double n = std::ceil(m_bottom / m_valueInterval - 1e-6);
         n * m_valueInterval <= m_top + 1e-6 * m_valueInterval; n += 1.0) {
        const double y = m_area.bottom() - (n * m_valueInterval - m_bottom) * perUnit;
        const QRectF place(m_area.left() - widthNeeded(), y - height / 2, widthNeeded() - gap(), height);
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                         texts::numberAt(n * m_valueInterval, m_valueInterval));
    }
}

void AxisLabels::paintTimes(QPainter& painter) const {
    const double height = QFontMetricsF(m_font).height();
    const double perSecond = m_area.width() / (m_right - m_left);
    for (double n = std::ceil(m_left / m_timeInterval - 1e-6);
         n * m_timeInterval <= m_right + 1e-6 * m_timeInterval; n += 1.0) {
        const double x = m_area.left() + (n * m_timeInterval - m_left) * perSecond;
        const QRectF place(x - 4 * height, m_area.bottom() + gap() / 2, 8 * height, height);
        painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop,
                         timeText(n * m_timeInterval, m_timeInterval));
    }
}

void AxisLabels::paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/, QWidget* /*widget*/) {
    if (m_area.isEmpty() || m_top <= m_bottom)
        return;
    painter->setFont(m_font);
    painter->setPen(m_colour);
    paintValues(*painter);
    if (m_timeInterval > 0 && m_right > m_left)
        paintTimes(*painter);
}

}  // namespace nmc

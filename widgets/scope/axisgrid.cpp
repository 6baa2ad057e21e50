// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/axisgrid.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString timeLabel(double seconds, double interval) {
    return texts::numberAt(seconds, interval) + u" s"_s;
}

}  // namespace

AxisGrid::AxisGrid(QGraphicsItem* parent) : QGraphicsItem(parent) {
    setAcceptedMouseButtons(Qt::NoButton);
}

void AxisGrid::setLook(const Look& look) {
    prepareGeometryChange();
    m_look = look;
    update();
}

void AxisGrid::setArea(const QRectF& area) {
    if (area == m_area)
        return;
    prepareGeometryChange();
    m_area = area;
}

bool AxisGrid::setValues(double bottom, double top, double interval) {
    const Axis values{bottom, top, interval};
    if (values == m_values)
        return false;
    prepareGeometryChange();
    m_values = values;
    update();
    return true;
}

bool AxisGrid::setTimes(double left, double right, double division, double labelInterval) {
    const Axis times{left, right, division};
    if (times == m_times && labelInterval == m_labelInterval)
        return false;
    m_times = times;
    m_labelInterval = labelInterval;
    update();
    return true;
}

double AxisGrid::gap() const {
    return QFontMetricsF(m_look.font).height() * 0.4;
}

int AxisGrid::widthNeeded() const {
    const QFontMetricsF metrics(m_look.font);
    const double widest =
        std::max(metrics.horizontalAdvance(texts::numberAt(m_values.from, m_values.interval)),
                 metrics.horizontalAdvance(texts::numberAt(m_values.to, m_values.interval)));
    return static_cast<int>(std::ceil(widest + gap()));
}

QRectF AxisGrid::boundingRect() const {
    const double height = QFontMetricsF(m_look.font).height();
    return m_area.adjusted(-widthNeeded(), -height, 3 * height, 2 * height);
}

std::vector<double> AxisGrid::Axis::multiplesOf(double step) const {
    std::vector<double> multiples;
    if (to > from && step > 0)
        for (double n = std::ceil(from / step - 1e-6); n * step <= to + 1e-6 * step; n += 1.0)
            multiples.push_back(n * step);
    return multiples;
}

double AxisGrid::x(double seconds) const {
    return m_area.left() + (seconds - m_times.from) * m_area.width() / (m_times.to - m_times.from);
}

double AxisGrid::y(double value) const {
    return m_area.bottom() - (value - m_values.from) * m_area.height() / (m_values.to - m_values.from);
}

void AxisGrid::paintLines(QPainter& painter) const {
    painter.setPen(QPen(m_look.grid, 1));
    for (const double value : m_values.multiplesOf(m_values.interval))
        painter.drawLine(QLineF(m_area.left(), y(value), m_area.right(), y(value)));
    for (const double time : m_times.multiplesOf(m_times.interval))
        painter.drawLine(QLineF(x(time), m_area.top(), x(time), m_area.bottom()));
    painter.setPen(QPen(m_look.axes, 1));
    painter.drawLine(QLineF(m_area.topLeft(), m_area.bottomLeft()));
    painter.drawLine(QLineF(m_area.bottomLeft(), m_area.bottomRight()));
}

void AxisGrid::paintValues(QPainter& painter) const {
    const double height = QFontMetricsF(m_look.font).height();
    for (const double value : m_values.multiplesOf(m_values.interval)) {
        const QRectF place(m_area.left() - widthNeeded(), y(value) - height / 2, widthNeeded() - gap(),
                           height);
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                         texts::numberAt(value, m_values.interval));
    }
}

void AxisGrid::paintTimes(QPainter& painter) const {
    const double height = QFontMetricsF(m_look.font).height();
    for (const double time : m_times.multiplesOf(m_labelInterval)) {
        const QRectF place(x(time) - 4 * height, m_area.bottom() + gap() / 2, 8 * height, height);
        painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop, timeLabel(time, m_labelInterval));
    }
}

void AxisGrid::paint(QPainter* painter, const QStyleOptionGraphicsItem* /*option*/, QWidget* /*widget*/) {
    if (m_area.isEmpty())
        return;
    paintLines(*painter);
    painter->setFont(m_look.font);
    painter->setPen(m_look.text);
    paintValues(*painter);
    paintTimes(*painter);
}

}  // namespace nmc

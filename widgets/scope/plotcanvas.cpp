// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/plotcanvas.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"

namespace nmc {

PlotCanvas::PlotCanvas(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void PlotCanvas::adoptPalette() {
    m_frame.setLook(palette(), look::tabular(look::scaled(font(), 0.9)));
    refreshLegend();
}

void PlotCanvas::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        adoptPalette();
}

void PlotCanvas::setCursors(const std::optional<Cursors>& cursors) {
    if (std::exchange(m_cursors, cursors) != cursors)
        update();
}

// ---- painting ----

void PlotCanvas::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_frame.picture(devicePixelRatioF()));
    paintOver(painter);
}

void PlotCanvas::renderTo(QPainter& painter) {
    m_frame.render(painter);
    paintOver(painter);
}

void PlotCanvas::paintOver(QPainter& painter) {
    m_geometry.area = plotArea();
    if (m_geometry.empty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look::scaled(font(), 0.9));
    paintTraces(painter);
    m_frame.paintLegend(painter);
    paintMarks(painter);
    paintCursors(painter);
    if (m_drag == Drag::Choose) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlpha(kBandAlpha);
        painter.fillRect(QRectF(QPointF(m_dragFrom.x(), m_geometry.area.top()),
                                QPointF(m_dragTo.x(), m_geometry.area.bottom())),
                         fill);
    }
    painter.restore();
}

void PlotCanvas::paintCursors(QPainter& painter) const {
    for (std::size_t i = 0; m_cursors && i < m_cursors->size(); ++i) {
        const double x = m_geometry.x((*m_cursors)[i]);
        if (x < m_geometry.area.left() || x > m_geometry.area.right())
            continue;  // an SVG file has no clipping
        painter.setPen(QPen(palette().color(QPalette::Text), 1, i == 0 ? Qt::SolidLine : Qt::DashLine));
        painter.drawLine(QLineF(x, m_geometry.area.top(), x, m_geometry.area.bottom()));
        painter.drawText(QPointF(x + 3, m_geometry.area.top() + QFontMetricsF(painter.font()).ascent() + 1),
                         QString::number(i + 1));
    }
}

// ---- the mouse ----

std::optional<std::size_t> PlotCanvas::cursorAt(const QPointF& position) const {
    std::optional<std::size_t> nearest;
    double distance = fontMetrics().height() / 2.0;
    for (std::size_t i = 0; m_cursors && i < m_cursors->size(); ++i)
        if (const double away = std::abs(m_geometry.x((*m_cursors)[i]) - position.x()); away < distance) {
            nearest = i;
            distance = away;
        }
    return nearest;
}

void PlotCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_geometry.empty())
        return QWidget::mousePressEvent(event);
    m_dragFrom = m_dragTo = event->position();
    const auto cursor = cursorAt(event->position());
    m_drag = cursor                                   ? (*cursor == 0 ? Drag::Cursor1 : Drag::Cursor2)
             : event->modifiers() & Qt::ShiftModifier ? Drag::Choose
                                                      : Drag::Pan;
}

void PlotCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPointF from = std::exchange(m_dragTo, event->position());
    switch (m_drag) {
        case Drag::None:
            break;
        case Drag::Pan:
            if (m_dragTo != from)
                pan((from.x() - m_dragTo.x()) / m_geometry.area.width(),
                    (m_dragTo.y() - from.y()) / m_geometry.area.height());
            break;
        case Drag::Cursor1:
        case Drag::Cursor2:
            moveCursor(m_drag == Drag::Cursor1 ? 0 : 1, m_geometry.seconds(m_dragTo.x()));
            break;
        case Drag::Choose:
            update();
            break;
    }
}

void PlotCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(m_drag, Drag::None) != Drag::Choose)
        return QWidget::mouseReleaseEvent(event);
    update();
    const auto [from, to] = std::minmax({m_dragFrom.x(), m_dragTo.x()});
    if (to - from >= fontMetrics().height() / 2.0)
        showTime(m_geometry.seconds(from), m_geometry.seconds(to));
}

void PlotCanvas::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    showEverything();
}

void PlotCanvas::wheelEvent(QWheelEvent* event) {
    const QPoint delta = event->angleDelta();
    const double notches = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
    event->accept();
    if (notches == 0 || m_geometry.empty())
        return;
    if (event->modifiers() & Qt::ControlModifier)
        zoomValues(std::pow(kWheelZoom, -notches), m_geometry.value(event->position().y()));
    else if (event->modifiers() & Qt::ShiftModifier || delta.y() == 0)
        pan(-notches * kPan, 0);
    else
        zoomTime(std::pow(kWheelZoom, -notches), m_geometry.seconds(event->position().x()));
}

}  // namespace nmc

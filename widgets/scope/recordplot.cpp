// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/recordplot.h"

#include <QEvent>
#include <QKeyEvent>
#include <algorithm>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/scope/axisrange.h"
#include "widgets/scope/timewindow.h"

namespace nmc {

namespace {
/// Limits of zooming, in the units of the axes; those of an XY view are both of signals.
constexpr double kNarrowestView = 1e-5, kWidestView = 1e13;
}  // namespace

RecordPlot::RecordPlot(const QSize& wanted, const QSize& least, QWidget* parent)
    : PlotCanvas(parent), m_wanted(wanted), m_least(least) {
    setFocusPolicy(Qt::StrongFocus);
    connect(&m_frame, &PlotFrame::changed, this, qOverload<>(&QWidget::update));
}

void RecordPlot::refreshLegend() {
    std::vector<PlotFrame::LegendEntry> legend;
    if (!m_label.isEmpty())
        legend.push_back({m_label, look::traceColour(0, palette()), false});
    m_frame.setLegend(legend);
    update();
}

void RecordPlot::fitAgain() {
    m_view.reset();
    fit();
}

void RecordPlot::fit() {
    const int em = fontMetrics().height();
    const QMargins around = room();
    m_frame.resize(QSizeF(width(), frameHeight()));
    const int rows = std::clamp((frameHeight() - around.bottom() - 2 * em) * 2 / (em * 3), 2, 8);
    const View view = m_view.value_or(fitted());
    const AxisRange::Range range =
        m_view ? AxisRange::Range{view.bottom, view.top, TimeWindow::nice((view.top - view.bottom) / rows)}
               : AxisRange::around(view.bottom, view.top, 0, rows);
    m_frame.setValueAxis(range.min, range.max, range.step);
    m_frame.setMargins(m_frame.labelWidth() + around.left(), around.right(), around.bottom());
    const int columns = std::clamp(width() / (em * 5), 2, 10);
    const double division = TimeWindow::nice((view.right - view.left) / columns);
    m_frame.setTimeAxis(view.left, view.right, division, division);
    m_geometry = m_frame.geometry();
    update();
}

QMargins RecordPlot::room() const {
    const int em = fontMetrics().height();
    return {0, 0, em * 3 / 2, em * 3 / 2};
}

RecordPlot::View RecordPlot::seen() const {
    return {m_geometry.left, m_geometry.right, m_geometry.bottom, m_geometry.top};
}

void RecordPlot::showView(const View& view) {
    for (const auto& [low, high] : {std::pair(view.left, view.right), std::pair(view.bottom, view.top)})
        if (high - low < std::max(kNarrowestView, AxisRange::narrowest(low, high)) ||
            high - low > kWidestView)
            return;
    m_view = view;
    fit();
}

void RecordPlot::zoomTime(double factor, double at) {
    const View view = seen();
    showView({at - (at - view.left) * factor, at + (view.right - at) * factor, view.bottom, view.top});
}

void RecordPlot::zoomValues(double factor, double at) {
    const View view = seen();
    showView({view.left, view.right, at - (at - view.bottom) * factor, at + (view.top - at) * factor});
}

void RecordPlot::pan(double timeShare, double valueShare) {
    const View view = seen();
    const double time = timeShare * (view.right - view.left);
    const double value = valueShare * (view.top - view.bottom);
    showView({view.left + time, view.right + time, view.bottom + value, view.top + value});
}

void RecordPlot::showTime(double left, double right) {
    showView({left, right, m_geometry.bottom, m_geometry.top});
}

void RecordPlot::moveCursor(std::size_t cursor, double seconds) {
    if (auto moved = cursors()) {
        (*moved)[cursor] = seconds;
        setCursors(moved);
    }
}

void RecordPlot::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = m_geometry.area.center();
    const auto zoom = [&](double factor) {
        if (event->modifiers() & Qt::ControlModifier)
            zoomValues(factor, m_geometry.value(middle.y()));
        else
            zoomTime(factor, m_geometry.seconds(middle.x()));
    };
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(1 / kKeyZoom);
        case Qt::Key_Minus:
            return zoom(kKeyZoom);
        case Qt::Key_Left:
            return pan(-kPan, 0);
        case Qt::Key_Right:
            return pan(kPan, 0);
        case Qt::Key_Up:
            return pan(0, kPan);
        case Qt::Key_Down:
            return pan(0, -kPan);
        case Qt::Key_A:
            return fitAgain();
        default:
            QWidget::keyPressEvent(event);
    }
}

void RecordPlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void RecordPlot::changeEvent(QEvent* event) {
    PlotCanvas::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fit();
}

}  // namespace nmc

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopeplot.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <limits>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopewords.h"
#include "widgets/scope/timewindow.h"
#include "widgets/scope/underlay.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kWheelPan = 0.1;         ///< share of the visible time, for each notch
constexpr double kSmallestPart = 1e-4;    ///< share of the smallest span of a fitted axis: zooming ends here
constexpr float kUnderlayOpacity = 0.4F;  ///< of the recording under the traces
constexpr double kSpike = 3.0;            ///< spans of everything else from which a spike is out of view
constexpr double kBandRoom = 2.0;         ///< maximum room for a band on either side, in spans of the signals
}  // namespace

ScopePlot::ScopePlot(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(&m_frame, &PlotFrame::changed, this, &ScopePlot::paintWanted);
    leaveLeft(0);
    adoptPalette();
}

void ScopePlot::adoptPalette() {
    m_frame.setLook(palette(), look::tabular(look::scaled(font(), 0.9)));
    setTraces(m_traces);
}

void ScopePlot::setTraces(std::vector<Trace> traces) {
    const bool same = std::equal(
        traces.begin(), traces.end(), m_traces.begin(), m_traces.end(), [](const Trace& a, const Trace& b) {
            return a.module == b.module && a.signal == b.signal && a.scale == b.scale;
        });
    if (!same)
        forget();
    m_traces = std::move(traces);
    m_drawings.resize(m_traces.size());
    m_under.resize(m_traces.size());
    std::vector<PlotFrame::LegendEntry> legend;
    for (std::size_t i = 0; i < m_traces.size(); ++i) {
        const Trace& trace = m_traces[i];
        TraceDrawing& drawing = m_drawings[i];
        drawing.colour =
            look::traceColour(static_cast<int>(m_traces.front().signal) + static_cast<int>(i), palette());
        drawing.dashed = trace.signal == ScopeSignal::Command;
        drawing.tag = trace.tag;
        m_under[i].dashed = drawing.dashed;
        m_under[i].colour = drawing.colour;
        m_under[i].colour.setAlphaF(kUnderlayOpacity);
        const QString rate = texts::readout(std::round(trace.samplesPerSecond));
        const QString label = infoOf(trace.signal).calculated && trace.samplesPerSecond == 0
                                  ? tr("%1 · unknown").arg(trace.label)
                                  : tr("%1 · %2/s").arg(trace.label, rate);
        legend.push_back({label, drawing.colour, drawing.dashed});
    }
    m_frame.setLegend(legend);
}

void ScopePlot::setTimeLabels(bool shown) {
    m_timeLabels = shown;
}

void ScopePlot::showFrame(const View& view, const History& history, double now, const DerivedSignals& derived,
                          const Underlay* under) {
    m_view = view;
    m_geometry.area = plotArea();
    m_geometry.left = view.left;
    m_geometry.right = view.right;
    const auto take = [&](std::vector<TraceDrawing>& drawings, TimePoint zero, const auto& sourceOf) {
        for (std::size_t i = 0; i < m_traces.size(); ++i) {
            const DerivedSignals::Source source = sourceOf({m_traces[i].module, m_traces[i].signal});
            if (source.samples != nullptr)
                drawings[i].take(*source.samples, source.signal, m_traces[i].scale, zero, m_geometry,
                                 view.sharpness);
            else
                drawings[i].clear();
        }
    };
    take(m_drawings, view.zero, [&](const ModuleSignal& of) { return derived.source(history, of); });
    take(m_under, under != nullptr ? under->zero() : view.zero, [&](const ModuleSignal& of) {
        return under != nullptr ? under->source(of) : DerivedSignals::Source{};
    });
    m_frame.setTimeAxis(view.left, view.right, view.division, m_timeLabels ? 2 * view.division : 0);
    fitValues(now);
    noteBand();
    emit paintWanted();
}

/// Smallest span of a fitted value axis, in its unit.
double ScopePlot::smallestSpan() const {
    double count = std::numeric_limits<double>::infinity();
    for (const Trace& trace : m_traces)
        count = std::min(count, std::abs(trace.scale.factor));
    return std::isfinite(count) && count > 0 ? AxisRange::kSmallestSpan * count : AxisRange::kSmallestSpan;
}

void ScopePlot::fitValues(double now) {
    if (m_manual)
        return setValueAxis(*m_manual);
    Reach all;
    Reach steady;
    for (const auto* drawings : {&m_under, &m_drawings})
        for (const TraceDrawing& drawing : *drawings) {
            all.add(drawing.reach());
            steady.add(drawing.reachWithoutSpikes());
        }
    if (all.low > all.high)
        return setValueAxis(m_range.range());
    // Fitted to a spike, the axis would show the rest as a straight line; the same holds for the band.
    const bool spiky = all.span() > kSpike * std::max(steady.span(), smallestSpan());
    const Reach& reach = spiky ? steady : all;
    const double room = kBandRoom * std::max(reach.span(), smallestSpan());
    setValueAxis(m_range.fit(std::max(reach.lowBand, reach.low - room),
                             std::min(reach.highBand, reach.high + room), now, smallestSpan()));
}

/// A band that ends where the strip ends would look narrower than it is.
void ScopePlot::noteBand() {
    m_bandNotice.clear();
    for (const TraceDrawing& drawing : m_drawings)
        if (const Reach& reach = drawing.reach(); reach.lowBand < std::min(m_geometry.bottom, reach.low) ||
                                                  reach.highBand > std::max(m_geometry.top, reach.high))
            m_bandNotice = tr("The band exceeds the strip: %1 to %2")
                               .arg(texts::numberAt(reach.lowBand, valueRange().step),
                                    texts::numberAt(reach.highBand, valueRange().step));
}

/// Sets the value axis, with as many labels as there is room for.
void ScopePlot::setValueAxis(const AxisRange::Range& range) {
    const double room = std::max(1.0, plotArea().height() / (fontMetrics().height() * 1.7));
    double interval = range.step;
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
        interval = range.step * factor;
        if ((range.max - range.min) / interval <= room)
            break;
    }
    // A fitted axis ends at labels; one that the user has moved stays where it was put.
    m_geometry.bottom = m_manual ? range.min : std::floor(range.min / interval + 1e-9) * interval;
    m_geometry.top = m_manual ? range.max : std::ceil(range.max / interval - 1e-9) * interval;
    m_frame.setValueAxis(m_geometry.bottom, m_geometry.top, interval);
}

void ScopePlot::forget() {
    m_range.reset();
    m_manual.reset();
    for (TraceDrawing& drawing : m_drawings)
        drawing.clear();
    for (TraceDrawing& drawing : m_under)
        drawing.clear();
    update();
}

void ScopePlot::showCursors(const std::optional<CursorTimes>& cursors) {
    if (m_cursors == cursors)
        return;
    m_cursors = cursors;
    update();
}

void ScopePlot::showMarker(const std::optional<double>& seconds) {
    if (m_marker == seconds)
        return;
    m_marker = seconds;
    update();
}

void ScopePlot::showLevel(const std::optional<double>& level) {
    if (m_level == level)
        return;
    m_level = level;
    update();
}

void ScopePlot::fit() {
    m_manual.reset();
    m_range.reset();
}

void ScopePlot::zoomValues(double factor, double at) {
    const double share = (at - m_geometry.bottom) / (m_geometry.top - m_geometry.bottom);
    const double span =
        std::clamp((m_geometry.top - m_geometry.bottom) * factor, smallestSpan() * kSmallestPart, 1e13);
    const double bottom = at - share * span;
    m_manual = AxisRange::Range{bottom, bottom + span, TimeWindow::nice(span / 8)};
}

void ScopePlot::panValues(double share) {
    const double by = share * (m_geometry.top - m_geometry.bottom);
    const AxisRange::Range now = valueRange();
    m_manual = AxisRange::Range{now.min + by, now.max + by, now.step};
}

void ScopePlot::leaveLeft(int width) {
    const int em = fontMetrics().height();
    m_frame.setMargins(width, em * 3 / 2, m_timeLabels ? em : em / 2);
}

AxisRange::Range ScopePlot::valueRange() const {
    return {m_geometry.bottom, m_geometry.top, m_manual ? m_manual->step : m_range.range().step};
}

// ---- painting ----

void ScopePlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_frame.picture(devicePixelRatioF()));
    paintOver(painter);
}

void ScopePlot::renderTo(QPainter& painter) {
    m_frame.render(painter);
    paintOver(painter);
}

void ScopePlot::paintOver(QPainter& painter) {
    m_geometry.area = plotArea();
    if (m_geometry.empty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(look::scaled(font(), 0.9));
    painter.setClipRect(m_geometry.area);
    for (const TraceDrawing& drawing : m_under)
        drawing.paint(painter, m_geometry);
    for (const TraceDrawing& drawing : m_drawings)
        drawing.paint(painter, m_geometry);
    m_frame.paintLegend(painter);
    if (!m_manual)
        for (const auto* drawings : {&m_under, &m_drawings})
            for (const TraceDrawing& drawing : *drawings)
                drawing.paintExceeding(painter, m_geometry, valueRange().step);
    for (const Trace& trace : m_traces)
        for (const double limit : trace.limits)
            if (limit >= m_geometry.bottom && limit <= m_geometry.top) {
                painter.setPen(QPen(look::severityFill(Severity::Attention, palette()), 1, Qt::DashLine));
                painter.drawLine(QLineF(m_geometry.area.left(), m_geometry.y(limit), m_geometry.area.right(),
                                        m_geometry.y(limit)));
            }
    if (m_level && *m_level >= m_geometry.bottom && *m_level <= m_geometry.top) {
        painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashDotLine));
        painter.drawLine(QLineF(m_geometry.area.left(), m_geometry.y(*m_level), m_geometry.area.right(),
                                m_geometry.y(*m_level)));
    }
    if (m_marker && *m_marker >= m_geometry.left && *m_marker <= m_geometry.right) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
        painter.drawLine(QLineF(m_geometry.x(*m_marker), m_geometry.area.top(), m_geometry.x(*m_marker),
                                m_geometry.area.bottom()));
    }
    paintCursors(painter);
    if (!m_bandNotice.isEmpty()) {
        const QFontMetricsF metrics(painter.font());
        painter.setPen(look::mutedText(palette()));
        painter.drawText(QPointF(m_geometry.area.right() - metrics.horizontalAdvance(m_bandNotice) - 4,
                                 m_geometry.area.bottom() - metrics.descent() - 2),
                         m_bandNotice);
    }
    if (m_drag == Drag::Choose) {
        QColor fill = palette().color(QPalette::Highlight);
        fill.setAlpha(60);
        painter.fillRect(QRectF(QPointF(m_dragFrom.x(), m_geometry.area.top()),
                                QPointF(m_dragTo.x(), m_geometry.area.bottom())),
                         fill);
    }
    painter.restore();
}

void ScopePlot::paintCursors(QPainter& painter) const {
    if (!m_cursors)
        return;
    for (std::size_t i = 0; i < m_cursors->size(); ++i) {
        const double x = m_geometry.x((*m_cursors)[i]);
        if (x < m_geometry.area.left() || x > m_geometry.area.right())
            continue;  // an SVG file has no clipping
        painter.setPen(QPen(palette().color(QPalette::Text), 1, i == 0 ? Qt::SolidLine : Qt::DashLine));
        painter.drawLine(QLineF(x, m_geometry.area.top(), x, m_geometry.area.bottom()));
        painter.drawText(QPointF(x + 3, m_geometry.area.top() + QFontMetricsF(painter.font()).ascent() + 1),
                         QString::number(i + 1));
    }
}

void ScopePlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_frame.resize(size());
    m_geometry.area = plotArea();
}

void ScopePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        adoptPalette();
}

QSize ScopePlot::minimumSizeHint() const {
    return {fontMetrics().height() * 16, fontMetrics().height() * 5};
}

// ---- the mouse ----

std::optional<int> ScopePlot::cursorAt(const QPointF& position) const {
    if (!m_cursors)
        return std::nullopt;
    std::optional<int> nearest;
    double distance = fontMetrics().height() / 2.0;
    for (int i = 0; i < 2; ++i) {
        const double away = std::abs(m_geometry.x((*m_cursors)[static_cast<std::size_t>(i)]) - position.x());
        if (away < distance) {
            nearest = i;
            distance = away;
        }
    }
    return nearest;
}

void ScopePlot::mousePressEvent(QMouseEvent* event) {
    emit focusWanted();
    if (event->button() != Qt::LeftButton || m_geometry.empty())
        return QWidget::mousePressEvent(event);
    m_dragFrom = m_dragTo = event->position();
    const std::optional<int> cursor = cursorAt(event->position());
    m_drag = cursor                                   ? (*cursor == 0 ? Drag::Cursor1 : Drag::Cursor2)
             : event->modifiers() & Qt::ShiftModifier ? Drag::Choose
                                                      : Drag::Pan;
}

void ScopePlot::mouseMoveEvent(QMouseEvent* event) {
    const QPointF here = event->position();
    switch (m_drag) {
        case Drag::None:
            break;
        case Drag::Pan: {
            const double seconds = m_geometry.seconds(m_dragTo.x()) - m_geometry.seconds(here.x());
            if (m_manual)
                panValues((here.y() - m_dragTo.y()) / m_geometry.area.height());
            m_dragTo = here;
            if (seconds != 0)
                emit timePanned(seconds);
            break;
        }
        case Drag::Cursor1:
        case Drag::Cursor2:
            emit cursorMoved(m_drag == Drag::Cursor1 ? 0 : 1, m_geometry.seconds(here.x()));
            break;
        case Drag::Choose:
            m_dragTo = here;
            update();
            break;
    }
}

void ScopePlot::mouseReleaseEvent(QMouseEvent* event) {
    const Drag drag = std::exchange(m_drag, Drag::None);
    if (drag != Drag::Choose)
        return QWidget::mouseReleaseEvent(event);
    update();
    const auto [from, to] = std::minmax({m_dragFrom.x(), m_dragTo.x()});
    if (to - from >= fontMetrics().height() / 2.0)
        emit timeChosen(m_geometry.seconds(from), m_geometry.seconds(to));
}

void ScopePlot::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    emit everythingWanted();
}

void ScopePlot::wheelEvent(QWheelEvent* event) {
    const QPoint delta = event->angleDelta();
    const double notches = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
    event->accept();
    if (notches == 0 || m_geometry.empty())
        return;
    if (event->modifiers() & Qt::ControlModifier)
        zoomValues(std::pow(kWheelZoom, -notches), m_geometry.value(event->position().y()));
    else if (event->modifiers() & Qt::ShiftModifier || delta.y() == 0)
        emit timePanned(-notches * kWheelPan * (m_geometry.right - m_geometry.left));
    else
        emit timeZoomed(std::pow(kWheelZoom, -notches), m_geometry.seconds(event->position().x()));
}

}  // namespace nmc

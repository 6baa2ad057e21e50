// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopeplot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopewords.h"
#include "widgets/scope/timewindow.h"
#include "widgets/scope/underlay.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kSmallestPart = 1e-4;    ///< share of the smallest span of a fitted axis: zooming ends here
constexpr float kUnderlayOpacity = 0.4F;  ///< of the recording under the traces
constexpr double kSpike = 3.0;            ///< spans of everything else from which a spike is out of view
constexpr double kBandRoom = 2.0;         ///< maximum room for a band on either side, in spans of the signals
}  // namespace

ScopePlot::ScopePlot(QWidget* parent) : PlotCanvas(parent) {
    connect(&m_frame, &PlotFrame::changed, this, &ScopePlot::paintWanted);
    leaveLeft(0);
    adoptPalette();
}

void ScopePlot::setTraces(std::vector<Trace> traces) {
    const bool same = std::ranges::equal(traces, m_traces, [](const Trace& a, const Trace& b) {
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
        drawing.tag.setText(trace.tag);
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
    m_geometry.area = plotArea();
    m_geometry.left = view.left;
    m_geometry.right = view.right;
    const auto take = [&](std::vector<TraceDrawing>& drawings, TimePoint zero, const auto& sourceOf) {
        for (std::size_t i = 0; i < m_traces.size(); ++i) {
            const SignalSource source = sourceOf({m_traces[i].module, m_traces[i].signal});
            if (source.samples != nullptr)
                drawings[i].take(*source.samples, source.signal, m_traces[i].scale, zero, m_geometry,
                                 view.sharpness);
            else
                drawings[i].clear();
        }
    };
    take(m_drawings, view.zero, [&](const ModuleSignal& of) { return derived.source(history, of); });
    take(m_under, under != nullptr ? under->zero() : view.zero,
         [&](const ModuleSignal& of) { return under != nullptr ? under->source(of) : SignalSource{}; });
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
    for (auto* drawings : {&m_under, &m_drawings})
        for (TraceDrawing& drawing : *drawings)
            drawing.clear();
    update();
}

void ScopePlot::showMarker(const std::optional<double>& seconds) {
    if (std::exchange(m_marker, seconds) != seconds)
        update();
}

void ScopePlot::showLevel(const std::optional<double>& level) {
    if (std::exchange(m_level, level) != level)
        update();
}

void ScopePlot::fit() {
    m_manual.reset();
    m_range.reset();
}

void ScopePlot::zoomValues(double factor, double at) {
    const double share = (at - m_geometry.bottom) / (m_geometry.top - m_geometry.bottom);
    const double least =
        std::max(smallestSpan() * kSmallestPart, AxisRange::narrowest(m_geometry.bottom, m_geometry.top));
    const double span = std::clamp((m_geometry.top - m_geometry.bottom) * factor, least, 1e13);
    const double bottom = at - share * span;
    m_manual = AxisRange::Range{bottom, bottom + span, TimeWindow::nice(span / 8)};
}

void ScopePlot::panValues(double share) {
    const double by = share * (m_geometry.top - m_geometry.bottom);
    const AxisRange::Range now = valueRange();
    m_manual = AxisRange::Range{now.min + by, now.max + by, now.step};
}

/// A fitted value axis stays where it is.
void ScopePlot::pan(double timeShare, double valueShare) {
    if (m_manual)
        panValues(valueShare);
    if (timeShare != 0)
        emit timePanned(timeShare * (m_geometry.right - m_geometry.left));
}

void ScopePlot::leaveLeft(int width) {
    const int em = fontMetrics().height();
    m_frame.setMargins(width, em * 3 / 2, m_timeLabels ? em : em / 2);
}

AxisRange::Range ScopePlot::valueRange() const {
    return {m_geometry.bottom, m_geometry.top, m_manual ? m_manual->step : m_range.range().step};
}

// ---- painting ----

void ScopePlot::paintTraces(QPainter& painter) {
    painter.setClipRect(m_geometry.area);
    for (const auto* drawings : {&m_under, &m_drawings})
        for (const TraceDrawing& drawing : *drawings)
            drawing.paint(painter, m_geometry);
}

void ScopePlot::paintMarks(QPainter& painter) {
    if (!m_manual)
        for (const auto* drawings : {&m_under, &m_drawings})
            for (const TraceDrawing& drawing : *drawings)
                drawing.paintExceeding(painter, m_geometry, valueRange().step);
    for (const Trace& trace : m_traces)
        for (const double limit : trace.limits)
            if (limit >= m_geometry.bottom && limit <= m_geometry.top) {
                painter.setPen(QPen(look::severityFill(Severity::Attention, palette()), 1, Qt::DashLine));
                painter.drawLine(m_geometry.across(limit));
            }
    if (m_level && *m_level >= m_geometry.bottom && *m_level <= m_geometry.top) {
        painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashDotLine));
        painter.drawLine(m_geometry.across(*m_level));
    }
    if (m_marker && *m_marker >= m_geometry.left && *m_marker <= m_geometry.right) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
        painter.drawLine(m_geometry.down(*m_marker));
    }
    if (!m_bandNotice.isEmpty()) {
        const QFontMetricsF metrics(painter.font());
        painter.setPen(look::mutedText(palette()));
        painter.drawText(QPointF(m_geometry.area.right() - metrics.horizontalAdvance(m_bandNotice) - 4,
                                 m_geometry.area.bottom() - metrics.descent() - 2),
                         m_bandNotice);
    }
}

void ScopePlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_frame.resize(size());
    m_geometry.area = plotArea();
}

QSize ScopePlot::minimumSizeHint() const {
    return {fontMetrics().height() * 16, fontMetrics().height() * 5};
}

void ScopePlot::mousePressEvent(QMouseEvent* event) {
    emit focusWanted();
    PlotCanvas::mousePressEvent(event);
}

}  // namespace nmc

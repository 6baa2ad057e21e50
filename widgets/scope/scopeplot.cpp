// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopeplot.h"

#include <QEvent>
#include <QGraphicsLayout>
#include <QtCharts/QChart>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <cmath>
#include <limits>

#include "widgets/common/words.h"
#include "widgets/scope/axislabels.h"
#include "widgets/scope/traceitem.h"

namespace nmc {

using namespace Qt::StringLiterals;

ScopePlot::ScopePlot(std::vector<TraceStyle> traces, bool timeLabels, QWidget* parent)
    : QChartView(new QChart, parent),
      m_styles(std::move(traces)),
      m_timeAxis(new QValueAxis(this)),
      m_valueAxis(new QValueAxis(this)),
      m_item(new TraceItem(chart())),
      m_labels(new AxisLabels(chart())),
      m_timeLabels(timeLabels) {
    setRenderHint(QPainter::Antialiasing);
    setInteractive(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setRubberBand(QChartView::NoRubberBand);
    chart()->addAxis(m_timeAxis, Qt::AlignBottom);
    chart()->addAxis(m_valueAxis, Qt::AlignLeft);
    for (const TraceStyle& style : m_styles) {
        auto* series = new QLineSeries(chart());
        series->setName(style.label);
        chart()->addSeries(series);
        m_legend.push_back(series);
    }
    m_timeAxis->setTickType(QValueAxis::TicksDynamic);
    m_timeAxis->setTickAnchor(0);
    m_timeAxis->setTickInterval(m_view.division);
    m_timeAxis->setRange(m_view.left, m_view.right);
    m_timeAxis->setLabelsVisible(false);
    m_valueAxis->setLabelsVisible(false);
    m_valueAxis->setRange(m_range.range().min, m_range.range().max);
    leaveLeft(0);
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    m_item->traces().resize(m_styles.size());
    connect(chart(), &QChart::plotAreaChanged, this, [this](const QRectF& area) {
        m_item->setArea(area);
        m_labels->setArea(area);
        fitTicks();
    });
    adoptPalette();
    fitTicks();
}

void ScopePlot::adoptPalette() {
    const QColor text = palette().color(QPalette::Active, QPalette::Text);
    const QColor faint = look::faintLine(palette());
    chart()->setBackgroundBrush(palette().color(QPalette::Active, QPalette::Base));
    chart()->setBackgroundPen(Qt::NoPen);
    setBackgroundBrush(palette().color(QPalette::Active, QPalette::Base));
    const QFont font = look::tabular(look::scaled(this->font(), 0.9));
    for (QValueAxis* axis : {m_timeAxis, m_valueAxis}) {
        axis->setGridLinePen(QPen(faint, 1));
        axis->setLinePen(QPen(look::mutedText(palette()), 1));
    }
    m_labels->setLook(font, text);
    chart()->legend()->setLabelColor(text);
    chart()->legend()->setFont(font);
    for (std::size_t i = 0; i < m_styles.size(); ++i) {
        const QColor colour = look::traceColour(m_styles[i].colour, palette());
        m_legend[i]->setPen(QPen(colour, 2, m_styles[i].dashed ? Qt::DashLine : Qt::SolidLine));
        m_item->traces()[i].colour = colour;
        m_item->traces()[i].dashed = m_styles[i].dashed;
    }
}

void ScopePlot::showTraces(const View& view, const std::vector<const Series*>& series, TimePoint now) {
    const auto columns =
        static_cast<std::size_t>(qMax(1.0, std::ceil(plotArea().width() * devicePixelRatioF())));
    const TimePoint from = view.origin + fromSeconds(view.left);
    const TimePoint to = view.origin + fromSeconds(view.right);
    for (std::size_t i = 0; i < m_styles.size(); ++i)
        m_item->traces()[i].segments = series[i]->window(from, to, columns);
    if (!(view == m_view)) {
        m_view = view;
        m_timeAxis->setTickInterval(view.division);
        m_timeAxis->setRange(view.left, view.right);
        m_labels->setTimes(view.left, view.right, m_timeLabels ? view.division : 0);
    }
    fitValues(toSeconds(now - view.origin));
    m_item->setTimeAxis(view.origin, view.left, view.right);
    m_item->update();
}

void ScopePlot::fitValues(double seconds) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Trace& trace : m_item->traces()) {
        for (const Series::Segment& segment : trace.segments) {
            for (const SeriesPoint& point : segment) {
                low = std::min(low, point.value);
                high = std::max(high, point.value);
            }
        }
    }
    if (low > high)
        return;
    m_range.fit(low, high, seconds);
    fitTicks();
}

/// As many labels as there is room for: Qt Charts shows dots in place of those that it finds too close. The
/// number of ticks is given, not their distance: a distance that is small beside a range that has just grown
/// hangs Qt Charts.
void ScopePlot::fitTicks() {
    const AxisRange::Range& range = m_range.range();
    const double room = plotArea().height() / (fontMetrics().height() * 1.7);
    double interval = range.step;
    for (double factor : {1.0, 2.0, 5.0, 10.0}) {
        interval = range.step * factor;
        if ((range.max - range.min) / interval <= room)
            break;
    }
    const double bottom = std::floor(range.min / interval) * interval;
    const double top = std::ceil(range.max / interval) * interval;
    const int ticks = qMax(2, qRound((top - bottom) / interval) + 1);
    if (m_valueAxis->tickCount() != ticks)
        m_valueAxis->setTickCount(ticks);
    if (m_valueAxis->min() != bottom || m_valueAxis->max() != top)
        m_valueAxis->setRange(bottom, top);
    m_item->setValueAxis(bottom, top);
    m_labels->setValues(bottom, top, interval);
}

void ScopePlot::showRate(std::size_t trace, double samplesPerSecond) {
    const QString text =
        tr("%1 · %2 samples/s").arg(m_styles[trace].label, texts::readout(std::round(samplesPerSecond)));
    if (m_legend[trace]->name() != text)
        m_legend[trace]->setName(text);
}

void ScopePlot::forget() {
    m_range.reset();
    for (Trace& trace : m_item->traces())
        trace.segments.clear();
    m_item->update();
}

int ScopePlot::labelWidth() const {
    return m_labels->widthNeeded();
}

void ScopePlot::leaveLeft(int width) {
    const int em = fontMetrics().height();
    const QMargins margins(width, 0, em * 3 / 2, m_timeLabels ? em : em / 2);
    if (margins != chart()->margins())
        chart()->setMargins(margins);
}

QRectF ScopePlot::plotArea() const {
    return chart()->plotArea();
}

AxisRange::Range ScopePlot::valueRange() const {
    return {m_valueAxis->min(), m_valueAxis->max(), m_range.range().step};
}

QString ScopePlot::legendText(std::size_t trace) const {
    return m_legend[trace]->name();
}

QSize ScopePlot::sizeHint() const {
    return {fontMetrics().height() * 40, fontMetrics().height() * 9};
}

QSize ScopePlot::minimumSizeHint() const {
    return {fontMetrics().height() * 16, fontMetrics().height() * 6};
}

void ScopePlot::changeEvent(QEvent* event) {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        adoptPalette();
}

}  // namespace nmc

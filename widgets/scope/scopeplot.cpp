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
#include "widgets/scope/traceitem.h"

namespace nmc {

using namespace Qt::StringLiterals;

ScopePlot::ScopePlot(std::vector<TraceStyle> traces, bool timeLabels, QWidget* parent)
    : QChartView(new QChart, parent),
      m_styles(std::move(traces)),
      m_timeAxis(new QValueAxis(this)),
      m_valueAxis(new QValueAxis(this)),
      m_item(new TraceItem(chart())) {
    setRenderHint(QPainter::Antialiasing);
    setInteractive(false);
    setFrameShape(QFrame::NoFrame);
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
    m_timeAxis->setLabelFormat(u"%.0f s"_s);
    m_valueAxis->setLabelFormat(u"%.0f"_s);
    m_timeAxis->setLabelsVisible(timeLabels);
    m_valueAxis->setTickType(QValueAxis::TicksDynamic);
    m_valueAxis->setTickAnchor(0);
    m_valueAxis->setTickInterval(m_range.range().step);
    m_valueAxis->setRange(m_range.range().min, m_range.range().max);
    m_margins = QMargins(fontMetrics().height() / 3, 0, fontMetrics().height() / 2, 0);
    chart()->setMargins(m_margins);
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    m_item->traces().resize(m_styles.size());
    connect(chart(), &QChart::plotAreaChanged, this, [this](const QRectF& area) {
        m_item->setArea(area);
        fitTicks();
    });
    adoptPalette();
}

void ScopePlot::adoptPalette() {
    const QColor text = palette().color(QPalette::Active, QPalette::Text);
    const QColor faint = look::faintLine(palette());
    chart()->setBackgroundBrush(palette().color(QPalette::Active, QPalette::Base));
    chart()->setBackgroundPen(Qt::NoPen);
    setBackgroundBrush(palette().color(QPalette::Active, QPalette::Base));
    const QFont font = look::tabular(look::scaled(this->font(), 0.9));
    for (QValueAxis* axis : {m_timeAxis, m_valueAxis}) {
        axis->setLabelsColor(text);
        axis->setLabelsFont(font);
        axis->setGridLinePen(QPen(faint, 1));
        axis->setLinePen(QPen(look::mutedText(palette()), 1));
    }
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
        m_timeAxis->setLabelFormat(view.division < 1 ? u"%.1f s"_s : u"%.0f s"_s);
        m_timeAxis->setRange(view.left, view.right);
    }
    fitValues(toSeconds(now - view.origin));
    m_item->setAxes(view.origin, view.left, view.right, m_range.range().min, m_range.range().max);
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
    const AxisRange::Range before = m_range.range();
    const AxisRange::Range range = m_range.fit(low, high, seconds);
    if (range == before && m_valueAxis->max() == range.max && m_valueAxis->min() == range.min)
        return;
    m_valueAxis->setRange(range.min, range.max);
    fitTicks();
}

/// As many labels as there is room for: Qt Charts shows dots in place of those that it finds too close.
void ScopePlot::fitTicks() {
    const AxisRange::Range& range = m_range.range();
    const double room = plotArea().height() / (QFontMetricsF(m_valueAxis->labelsFont()).height() * 1.7);
    double interval = range.step;
    for (double factor : {1.0, 2.0, 5.0, 10.0}) {
        interval = range.step * factor;
        if ((range.max - range.min) / interval <= room)
            break;
    }
    if (m_valueAxis->tickInterval() != interval)
        m_valueAxis->setTickInterval(interval);
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

ScopePlot::Sides ScopePlot::neededSides() const {
    const QRectF area = chart()->plotArea();
    const QMargins margins = chart()->margins();
    return {area.left() - margins.left() + m_margins.left(),
            chart()->size().width() - area.right() - margins.right() + m_margins.right()};
}

void ScopePlot::leaveSides(const Sides& sides) {
    const Sides needed = neededSides();
    QMargins margins = m_margins;
    margins.setLeft(margins.left() + qRound(sides.left - needed.left));
    margins.setRight(margins.right() + qRound(sides.right - needed.right));
    const QMargins change = margins - chart()->margins();
    if (qAbs(change.left()) > 1 || qAbs(change.right()) > 1)
        chart()->setMargins(margins);
}

QRectF ScopePlot::plotArea() const {
    return chart()->plotArea();
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

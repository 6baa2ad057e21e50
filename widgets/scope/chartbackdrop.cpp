// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/chartbackdrop.h"

#include <QGraphicsLayout>
#include <QPainter>
#include <QtCharts/QChart>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <cmath>

#include "widgets/common/look.h"
#include "widgets/scope/axislabels.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChartBackdrop::ChartBackdrop(QObject* parent)
    : QObject(parent),
      m_chart(new QChart),
      m_timeAxis(new QValueAxis(this)),
      m_valueAxis(new QValueAxis(this)),
      m_labels(new AxisLabels(m_chart)) {
    m_scene.addItem(m_chart);
    m_chart->addAxis(m_timeAxis, Qt::AlignBottom);
    m_chart->addAxis(m_valueAxis, Qt::AlignLeft);
    for (QValueAxis* axis : {m_timeAxis, m_valueAxis}) {
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setLabelsVisible(false);
        axis->setLabelFormat(u" "_s);  // labels that are not seen are laid out all the same
    }
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setBackgroundRoundness(0);
    m_chart->legend()->setAlignment(Qt::AlignTop);
    m_chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    connect(m_chart, &QChart::plotAreaChanged, this, [this](const QRectF& area) {
        m_labels->setArea(area);
        invalidate();
    });
    // What changes in the scene later, when the event loop lays it out.
    connect(&m_scene, &QGraphicsScene::changed, this, &ChartBackdrop::invalidate);
}

void ChartBackdrop::invalidate() {
    m_outdated = true;
    emit changed();
}

void ChartBackdrop::setLegend(const std::vector<LegendEntry>& entries) {
    if (entries == m_entries)
        return;
    while (m_series.size() > entries.size()) {
        m_chart->removeSeries(m_series.back());
        delete m_series.back();
        m_series.pop_back();
    }
    while (m_series.size() < entries.size()) {
        m_series.push_back(new QLineSeries(m_chart));
        m_chart->addSeries(m_series.back());
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        m_series[i]->setName(entries[i].label);
        QPen pen(entries[i].colour, 2, Qt::SolidLine, Qt::FlatCap);
        if (entries[i].dashed)
            pen.setDashPattern({1.5, 1.0});  // two dashes fit upon the marker
        m_series[i]->setPen(pen);
    }
    m_entries = entries;
    invalidate();
}

QString ChartBackdrop::legendText(std::size_t entry) const {
    return entry < m_entries.size() ? m_entries[entry].label : QString();
}

void ChartBackdrop::setLook(const QPalette& palette, const QFont& font) {
    const QColor text = palette.color(QPalette::Active, QPalette::Text);
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    m_chart->setBackgroundBrush(base);
    m_chart->setBackgroundPen(Qt::NoPen);
    for (QValueAxis* axis : {m_timeAxis, m_valueAxis}) {
        axis->setGridLinePen(QPen(look::faintLine(palette), 1));
        axis->setLinePen(QPen(look::mutedText(palette), 1));
    }
    m_labels->setLook(font, text);
    m_chart->legend()->setLabelColor(text);
    m_chart->legend()->setFont(font);
    invalidate();
}

void ChartBackdrop::resize(const QSizeF& size) {
    m_scene.setSceneRect(QRectF(QPointF(), size));
    m_chart->resize(size);
    m_chart->layout()->activate();
    invalidate();
}

void ChartBackdrop::setMargins(int left, int right, int bottom) {
    const QMargins margins(left, 0, right, bottom);
    if (margins == m_chart->margins())
        return;
    m_chart->setMargins(margins);
    invalidate();
}

void ChartBackdrop::setTimeAxis(double left, double right, double division, double labelInterval) {
    if (move(*m_timeAxis, left, right, division))
        invalidate();
    m_labels->setTimes(left, right, labelInterval);
}

void ChartBackdrop::setValueAxis(double bottom, double top, double interval) {
    if (move(*m_valueAxis, bottom, top, interval))
        invalidate();
    m_labels->setValues(bottom, top, interval);
}

bool ChartBackdrop::move(QValueAxis& axis, double from, double to, double interval) {
    if (from == axis.min() && to == axis.max() && interval == axis.tickInterval())
        return false;
    // An interval that is small beside the range hangs Qt Charts, so whichever keeps them apart goes first;
    // and the anchor stays near, for the sake of its arithmetic.
    if (to - from > axis.max() - axis.min())
        axis.setTickInterval(interval);
    axis.setRange(from, to);
    axis.setTickInterval(interval);
    axis.setTickAnchor(std::floor(from / interval) * interval);
    return true;
}

QRectF ChartBackdrop::plotArea() const {
    return m_chart->plotArea();
}

int ChartBackdrop::labelWidth() const {
    return m_labels->widthNeeded();
}

const QPixmap& ChartBackdrop::picture(double devicePixelRatio) {
    const QSize pixels = (m_scene.sceneRect().size() * devicePixelRatio).toSize();
    if (!m_outdated && m_picture.size() == pixels)
        return m_picture;
    m_picture = QPixmap(pixels);
    m_picture.setDevicePixelRatio(devicePixelRatio);
    m_picture.fill(m_chart->backgroundBrush().color());
    QPainter painter(&m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    render(painter);
    m_outdated = false;
    return m_picture;
}

void ChartBackdrop::render(QPainter& painter) {
    m_scene.render(&painter, m_scene.sceneRect(), m_scene.sceneRect());
}

}  // namespace nmc

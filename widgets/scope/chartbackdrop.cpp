// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/chartbackdrop.h"

#include <QGraphicsLayout>
#include <QPainter>
#include <QtCharts/QChart>
#include <QtCharts/QLegend>
#include <QtCharts/QLineSeries>

#include "widgets/common/look.h"
#include "widgets/scope/axisgrid.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChartBackdrop::ChartBackdrop(QObject* parent)
    : QObject(parent), m_chart(new QChart), m_grid(new AxisGrid(m_chart)) {
    m_scene.addItem(m_chart);
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->setBackgroundRoundness(0);
    m_chart->legend()->setAlignment(Qt::AlignTop);
    m_chart->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    connect(m_chart, &QChart::plotAreaChanged, this, [this](const QRectF& area) {
        m_grid->setArea(area);
        invalidate();
    });
    // The scene also changes later, when the event loop lays it out.
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
            pen.setDashPattern({1.5, 1.0});  // two dashes fit on the marker
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
    m_grid->setLook({font, text, look::mutedText(palette), look::faintLine(palette)});
    m_chart->legend()->setLabelColor(text);
    m_chart->legend()->setFont(font);
    m_chart->layout()->activate();
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
    if (m_grid->setTimes(left, right, division, labelInterval))
        invalidate();
}

void ChartBackdrop::setValueAxis(double bottom, double top, double interval) {
    if (m_grid->setValues(bottom, top, interval))
        invalidate();
}

QRectF ChartBackdrop::plotArea() const {
    return m_chart->plotArea();
}

int ChartBackdrop::labelWidth() const {
    return m_grid->widthNeeded();
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

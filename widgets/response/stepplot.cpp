// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepplot.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/scope/axisrange.h"
#include "widgets/scope/timewindow.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kPenWidth = 1.6;
const QList<qreal> kDashes{4, 2.5};
constexpr std::size_t kModel = 3, kPrediction = 2;  ///< trace colours
constexpr double kPalest = 0.15, kStrongest = 0.5;  ///< opacity of runs that are neither A nor B
constexpr int kBandAlpha = 45;
constexpr double kShortest = 0.1;     ///< of the record, is always seen
constexpr double kGap = 6;            ///< sample intervals, from which on something is missing
constexpr double kUsualRecord = 0.5;  ///< s, of the axis before there is a run
}  // namespace

StepPlot::StepPlot(QWidget* parent) : QWidget(parent) {
    look::name(this, u"stepPlot"_s, tr("Step responses over time"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setToolTip(
        tr("Positions since the step, counted from where it began. The shaded band is the settling "
           "band around the goal. A double click shows the whole record, or only as long as it moves."));
    connect(&m_backdrop, &ChartBackdrop::changed, this, qOverload<>(&QWidget::update));
    adoptPalette();
    fit();
}

QColor StepPlot::colour(std::size_t which) const {
    return look::traceColour(static_cast<int>(which), palette());
}

StepPlot::Curve StepPlot::curveOf(const KeptRun& kept, const AxisScale& scale) {
    const StepTaken& taken = kept.run.taken;
    Curve curve;
    const double farApart = kGap * kept.run.metrics.interval;
    for (const StepPoint& point : kept.run.points) {
        const QPointF next(point.seconds, scale.position(point.position - taken.from));
        if (curve.parts.empty() || next.x() - curve.parts.back().back().x() > farApart)
            curve.parts.emplace_back();
        curve.parts.back() << next;
    }
    curve.goal = scale.position(static_cast<double>(taken.goal) - taken.from);
    curve.band = scale.position(kept.run.band());
    curve.bandPercent = kept.run.bandPercent;
    curve.record = taken.record;
    // As long again as it takes to settle, so that it is seen to stay.
    const auto& atRest = kept.run.metrics.settlingAtRest;
    curve.transient =
        atRest ? std::clamp(2 * atRest->value, kShortest * taken.record, taken.record) : taken.record;
    const QString run = kept.name.empty()
                            ? QString::number(kept.number)
                            : u"%1 \"%2\""_s.arg(kept.number).arg(QString::fromStdString(kept.name));
    curve.label = tr("run %1, %2").arg(run, texts::unitOf(scale));
    return curve;
}

void StepPlot::showRuns(const KeptRun* a, const KeptRun* b, const std::vector<const KeptRun*>& others) {
    m_others.clear();
    for (const KeptRun* other : others)
        m_others.push_back(curveOf(*other, a != nullptr ? a->scale : other->scale));
    m_curves[0] = a != nullptr ? std::optional(curveOf(*a, a->scale)) : std::nullopt;
    // The user may have changed the unit between two runs of a module.
    const bool oneModule = a != nullptr && b != nullptr && a->run.module == b->run.module;
    m_curves[1] = b != nullptr ? std::optional(curveOf(*b, oneModule ? a->scale : b->scale)) : std::nullopt;
    adoptPalette();
    fit();
}

QPolygonF StepPlot::lineOf(const KeptRun& about, const std::vector<StepPoint>& points) {
    QPolygonF line;
    for (const StepPoint& point : points)
        line << QPointF(point.seconds, about.scale.position(point.position - about.run.taken.from));
    return line;
}

void StepPlot::showModel(const KeptRun* about, const std::vector<StepPoint>& fitted,
                         const std::vector<StepPoint>& predicted) {
    m_fitted = about != nullptr ? lineOf(*about, fitted) : QPolygonF();
    m_predicted = about != nullptr ? lineOf(*about, predicted) : QPolygonF();
    adoptPalette();
    fit();
}

void StepPlot::adoptPalette() {
    m_backdrop.setLook(palette(), look::tabular(look::scaled(font(), 0.9)));
    std::vector<ChartBackdrop::LegendEntry> legend;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        if (m_curves[i])
            legend.push_back(
                {(i == 0 ? tr("A: %1") : tr("B: %1")).arg(m_curves[i]->label), colour(i), i == 1});
    if (!m_fitted.empty())
        legend.push_back({tr("motor model"), colour(kModel), true});
    if (!m_predicted.empty())
        legend.push_back({tr("predicted"), colour(kPrediction), true});
    if (!legend.empty())
        legend.push_back({tr("goal"), look::mutedText(palette()), true});
    m_backdrop.setLegend(legend);
    update();
}

void StepPlot::fit() {
    double low = 0, high = 0, left = -toSeconds(kBeforeStep), right = 0;
    for (const auto& curve : m_curves) {
        if (!curve)
            continue;
        low = std::min(low, curve->goal - curve->band);
        high = std::max(high, curve->goal + curve->band);
        right = std::max(right, m_whole ? curve->record : curve->transient);
        for (const QPolygonF& part : curve->parts) {
            low = std::min(low, part.boundingRect().top());
            high = std::max(high, part.boundingRect().bottom());
        }
    }
    for (const Curve& curve : m_others)
        for (const QPolygonF& part : curve.parts) {
            low = std::min(low, part.boundingRect().top());
            high = std::max(high, part.boundingRect().bottom());
        }
    for (const QPolygonF* line : {&m_fitted, &m_predicted})
        if (!line->empty()) {
            low = std::min(low, line->boundingRect().top());
            high = std::max(high, line->boundingRect().bottom());
        }
    if (right == 0) {
        high = 1;
        right = kUsualRecord;
    }
    const int em = fontMetrics().height();
    const int rows = std::clamp((height() - 3 * em) * 2 / (em * 3), 2, 8);
    const AxisRange::Range range = AxisRange::around(low, high, 0, rows);
    m_backdrop.setValueAxis(range.min, range.max, range.step);
    m_backdrop.setMargins(m_backdrop.labelWidth(), em * 3 / 2, em);
    const int columns = std::clamp(width() / (em * 5), 2, 10);
    const double division = TimeWindow::nice((right - left) / columns);
    m_backdrop.setTimeAxis(left, right, division, division);
    m_geometry = {m_backdrop.plotArea(), left, right, range.min, range.max};
    update();
}

QPointF StepPlot::pointAt(double seconds, double value) const {
    return {m_geometry.x(seconds), m_geometry.y(value)};
}

void StepPlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_backdrop.picture(devicePixelRatioF()));
    m_geometry.area = m_backdrop.plotArea();
    if (m_geometry.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_curves[0] && !m_curves[1]) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(m_geometry.area, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No run is shown. A step shows how the motor follows when its command jumps."));
        return;
    }
    // What runs along the edge is drawn whole.
    painter.setClipRect(m_geometry.area.adjusted(0, -kPenWidth, 0, kPenWidth));
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DotLine));
    painter.drawLine(
        QLineF(m_geometry.x(0), m_geometry.area.top(), m_geometry.x(0), m_geometry.area.bottom()));
    if (m_curves[0])
        paintGoal(painter, *m_curves[0]);
    if (m_curves[1] && !(m_curves[0] && m_curves[0]->sameGoal(*m_curves[1])))
        paintGoal(painter, *m_curves[1]);
    paintOthers(painter);
    paintCurve(painter, 1);
    paintCurve(painter, 0);
    painter.setPen(QPen(colour(kModel), kPenWidth, Qt::DotLine, Qt::FlatCap));
    paintLine(painter, m_fitted);
    QPen pen(colour(kPrediction), kPenWidth, Qt::SolidLine, Qt::FlatCap);
    pen.setDashPattern(kDashes);
    painter.setPen(pen);
    paintLine(painter, m_predicted);
}

void StepPlot::paintGoal(QPainter& painter, const Curve& curve) const {
    QColor fill = look::mutedText(palette());
    fill.setAlpha(kBandAlpha);
    painter.fillRect(
        QRectF(pointAt(0, curve.goal + curve.band), pointAt(curve.record, curve.goal - curve.band)), fill);
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashLine));
    painter.drawLine(QLineF(pointAt(0, curve.goal), pointAt(curve.record, curve.goal)));
}

/// Once for every change and not once a frame, so a polyline is quick enough, and its dashes run through.
void StepPlot::paintCurve(QPainter& painter, std::size_t which) const {
    if (!m_curves[which])
        return;
    QPen pen(colour(which), kPenWidth, Qt::SolidLine, Qt::FlatCap);
    if (which == 1)
        pen.setDashPattern(kDashes);
    painter.setPen(pen);
    for (const QPolygonF& part : m_curves[which]->parts)
        paintLine(painter, part);
}

void StepPlot::paintOthers(QPainter& painter) const {
    double strength = 0;
    for (const Curve& curve : m_others) {
        strength += 1.0 / static_cast<double>(m_others.size());
        QColor pale = colour(0);
        pale.setAlphaF(static_cast<float>(kPalest + (kStrongest - kPalest) * strength));
        painter.setPen(QPen(pale, 1));
        for (const QPolygonF& part : curve.parts)
            paintLine(painter, part);
    }
}

void StepPlot::paintLine(QPainter& painter, const QPolygonF& line) const {
    QPolygonF places;
    places.reserve(line.size());
    for (const QPointF& point : line)
        places << pointAt(point.x(), point.y());
    painter.drawPolyline(places);
}

void StepPlot::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    m_whole = !m_whole;
    fit();
}

void StepPlot::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_backdrop.resize(size());
    fit();
}

void StepPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        adoptPalette();
}

QSize StepPlot::sizeHint() const {
    return {fontMetrics().height() * 20, fontMetrics().height() * 10};
}

QSize StepPlot::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 7};
}

}  // namespace nmc

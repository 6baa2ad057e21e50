// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseplot.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <iterator>

#include "model/tuning/predict.h"
#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/response/plotline.h"
#include "widgets/scope/cursortable.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
const QList<qreal> kDashes{4, 2.5};
constexpr std::size_t kModel = 3, kPrediction = 2;  ///< trace colours
constexpr double kPalest = 0.15, kStrongest = 0.5;  ///< opacity of runs that are neither A nor B
constexpr double kShortest = 0.1;                   ///< share of the record that is always visible
constexpr double kUsualRecord = 0.5;                ///< s, length of the time axis before there is a run
}  // namespace

ResponsePlot::ResponsePlot(QWidget* parent) : RecordPlot({20, 10}, {14, 7}, parent) {
    look::name(this, u"responsePlot"_s, tr("Step responses over time"));
    setToolTip(tr(
        "Positions since the step, relative to its start. The shaded band is the settling band around the goal. Double-click to switch between the whole record and the motion. Scroll to zoom the time, or the positions with Ctrl; drag to pan; drag with Shift to select a time."));
    adoptPalette();
    fit();
}

QColor ResponsePlot::colour(std::size_t which) const {
    return look::traceColour(static_cast<int>(which), palette());
}

ResponsePlot::Curve ResponsePlot::curveOf(const KeptResponse& kept, const AxisScale& scale) {
    const ResponseTaken& taken = kept.run.taken;
    Curve curve;
    const double farApart = kSeveralIntervals * kept.run.metrics.interval;
    for (const ResponsePoint& point : kept.run.points) {
        const QPointF next(point.seconds, scale.position(point.position - taken.from));
        if (curve.parts.empty() || next.x() - curve.parts.back().back().x() > farApart)
            curve.parts.emplace_back();
        curve.parts.back() << next;
        if (taken.isMove())
            curve.command << QPointF(point.seconds,
                                     scale.position(point.position + point.error - taken.from));
    }
    curve.goal = scale.position(static_cast<double>(taken.goal) - taken.from);
    curve.band = scale.distance(kept.run.band());
    curve.bandPercent = kept.run.bandPercent;
    curve.record = taken.record;
    // Twice the settling time, so that the plot shows that the motor stays there.
    const auto& atRest = kept.run.metrics.settlingAtRest;
    curve.transient = atRest && !taken.isMove()
                          ? std::clamp(2 * atRest->value, kShortest * taken.record, taken.record)
                          : taken.record;
    const QString run = kept.name.empty()
                            ? QString::number(kept.number)
                            : u"%1 \"%2\""_s.arg(kept.number).arg(QString::fromStdString(kept.name));
    curve.unit = texts::unitOf(scale);
    curve.label = tr("run %1, %2").arg(run, texts::unitOf(scale));
    return curve;
}

void ResponsePlot::showRuns(const KeptResponse* a, const KeptResponse* b,
                            const std::vector<const KeptResponse*>& others) {
    m_others.clear();
    for (const KeptResponse* other : others)
        m_others.push_back(curveOf(*other, a != nullptr ? a->scale : other->scale));
    m_curves[0] = a != nullptr ? std::optional(curveOf(*a, a->scale)) : std::nullopt;
    // The user may have changed the unit between two runs of a module.
    const bool oneModule = a != nullptr && b != nullptr && a->run.module == b->run.module;
    const AxisScale* scaleOfB = b == nullptr ? nullptr : oneModule ? &a->scale : &b->scale;
    m_curves[1] = b != nullptr ? std::optional(curveOf(*b, *scaleOfB)) : std::nullopt;
    m_strips.show(a, b, scaleOfB);
    refreshLegend();
    fit();
    emit measured();
}

QPolygonF ResponsePlot::lineOf(const KeptResponse& about, const std::vector<ResponsePoint>& points) {
    QPolygonF line;
    for (const ResponsePoint& point : points)
        line << QPointF(point.seconds, about.scale.position(point.position - about.run.taken.from));
    return line;
}

void ResponsePlot::showModel(const KeptResponse* about, const std::vector<ResponsePoint>& fitted,
                             const Prediction* predicted) {
    m_fitted = about != nullptr ? lineOf(*about, fitted) : QPolygonF();
    m_predicted.clear();
    m_range.clear();
    if (about != nullptr && predicted != nullptr) {
        m_predicted = lineOf(*about, predicted->run.points);
        m_range = lineOf(*about, predicted->high);
        const QPolygonF low = lineOf(*about, predicted->low);
        std::copy(low.rbegin(), low.rend(), std::back_inserter(m_range));
    }
    refreshLegend();
    fit();
}

void ResponsePlot::refreshLegend() {
    std::vector<PlotFrame::LegendEntry> legend;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        if (m_curves[i])
            legend.push_back(
                {(i == 0 ? tr("A: %1") : tr("B: %1")).arg(m_curves[i]->label), colour(i), i == 1});
    if (!m_fitted.empty())
        legend.push_back({tr("motor model"), colour(kModel), true});
    if (!m_predicted.empty())
        legend.push_back({tr("predicted"), colour(kPrediction), true});
    const bool moves =
        std::ranges::any_of(m_curves, [](const auto& curve) { return curve && !curve->command.empty(); });
    if (!legend.empty())
        legend.push_back({moves ? tr("goal, command") : tr("goal"), look::mutedText(palette()), true});
    m_frame.setLegend(legend);
    update();
}

ResponsePlot::View ResponsePlot::fitted() const {
    double low = 0, high = 0, right = 0;
    const auto takeIn = [&](const QPolygonF& line) {
        if (line.empty())
            return;
        low = std::min(low, line.boundingRect().top());
        high = std::max(high, line.boundingRect().bottom());
    };
    for (const auto& curve : m_curves) {
        if (!curve)
            continue;
        low = std::min(low, curve->goal - curve->band);
        high = std::max(high, curve->goal + curve->band);
        right = std::max(right, m_whole ? curve->record : curve->transient);
        std::ranges::for_each(curve->parts, takeIn);
    }
    for (const Curve& curve : m_others)
        std::ranges::for_each(curve.parts, takeIn);
    takeIn(m_fitted);
    takeIn(m_predicted);
    takeIn(m_range);
    // Keeps the extremes away from the edge.
    constexpr double kHeadroom = 0.04;
    const double room = kHeadroom * (high - low);
    low -= room;
    high += room;
    const double left = -toSeconds(kBeforeStep);
    return right == 0 ? View{left, kUsualRecord, low, 1} : View{left, right, low, high};
}

QMargins ResponsePlot::room() const {
    const int em = fontMetrics().height();
    return {em * 5 / 4, 0, em * 3 / 2, em * 9 / 4};
}

void ResponsePlot::fitAgain() {
    m_whole = false;
    RecordPlot::fitAgain();
}

void ResponsePlot::paintEvent(QPaintEvent* event) {
    QPainter(this).fillRect(rect(), palette().color(QPalette::Base));  // the frame ends above the strips
    RecordPlot::paintEvent(event);
}

void ResponsePlot::paintTraces(QPainter& painter) {
    paintTitles(painter);
    if (!m_curves[0] && !m_curves[1]) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(
            m_geometry.area, Qt::AlignCenter | Qt::TextWordWrap,
            tr("No run selected. A step response shows how the motor follows a jump of its command."));
        return;
    }
    if (const int strips = stripsHeight(); strips > 0)
        m_strips.paint(painter, QRectF(0, height() - strips, width(), strips), m_geometry, palette());
    // Lines along the edge are drawn at their full width.
    painter.setClipRect(m_geometry.area.adjusted(0, -kTraceWidth, 0, kTraceWidth));
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DotLine));
    if (m_geometry.left <= 0 && m_geometry.right >= 0)
        painter.drawLine(m_geometry.down(0));
    if (m_curves[0])
        paintGoal(painter, *m_curves[0]);
    if (m_curves[1] && !(m_curves[0] && m_curves[0]->sameGoal(*m_curves[1])))
        paintGoal(painter, *m_curves[1]);
    paintOthers(painter);
    paintRange(painter);
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashLine));
    for (const auto& curve : m_curves)
        if (curve)
            paintLine(painter, m_geometry, curve->command);
    paintCurve(painter, 1);
    paintCurve(painter, 0);
    painter.setPen(QPen(colour(kModel), kTraceWidth, Qt::DotLine, Qt::FlatCap));
    paintLine(painter, m_geometry, m_fitted);
    QPen pen(colour(kPrediction), kTraceWidth, Qt::SolidLine, Qt::FlatCap);
    pen.setDashPattern(kDashes);
    painter.setPen(pen);
    paintLine(painter, m_geometry, m_predicted);
}

void ResponsePlot::paintTitles(QPainter& painter) const {
    const QRectF& area = m_geometry.area;
    const double em = QFontMetricsF(painter.font()).height();
    const std::optional<Curve>& first = m_curves[0] ? m_curves[0] : m_curves[1];
    painter.setPen(look::mutedText(palette()));
    painter.drawText(
        QRectF(area.left(), area.bottom() + em * 1.2, area.width(), em), Qt::AlignCenter,
        first && !first->command.isEmpty() ? tr("time since the start (s)") : tr("time since the step (s)"));
    const bool oneUnit = !m_curves[0] || !m_curves[1] || m_curves[0]->unit == m_curves[1]->unit;
    const QString unit = !first    ? QString()
                         : oneUnit ? first->unit
                                   : m_curves[0]->unit + u" | "_s + m_curves[1]->unit;
    painter.save();
    painter.translate(0, area.center().y());
    painter.rotate(-90);
    painter.drawText(
        QRectF(-area.height() / 2, 1, area.height(), em), Qt::AlignCenter,
        unit.isEmpty() ? tr("position from the start") : tr("position from the start (%1)").arg(unit));
    painter.restore();
}

/// Draws only what is within the area, because an SVG file has no clipping.
void ResponsePlot::paintLevel(QPainter& painter, double value, double from, double to) const {
    if (value < m_geometry.bottom || value > m_geometry.top || from > m_geometry.right ||
        to < m_geometry.left)
        return;
    painter.drawLine(QLineF(m_geometry.at(std::max(from, m_geometry.left), value),
                            m_geometry.at(std::min(to, m_geometry.right), value)));
}

void ResponsePlot::paintGoal(QPainter& painter, const Curve& curve) const {
    QColor fill = look::mutedText(palette());
    fill.setAlpha(kBandAlpha);
    painter.fillRect(QRectF(m_geometry.at(0, curve.goal + curve.band),
                            m_geometry.at(curve.record, curve.goal - curve.band))
                         .intersected(m_geometry.area),
                     fill);
    painter.setPen(QPen(look::mutedText(palette()), 1, Qt::DashLine));
    paintLevel(painter, curve.goal, 0, curve.record);
}

/// Called for every change and not for every frame, so a polyline is fast enough; its dashes are continuous.
void ResponsePlot::paintCurve(QPainter& painter, std::size_t which) const {
    if (!m_curves[which])
        return;
    QPen pen(colour(which), kTraceWidth, Qt::SolidLine, Qt::FlatCap);
    if (which == 1)
        pen.setDashPattern(kDashes);
    painter.setPen(pen);
    for (const QPolygonF& part : m_curves[which]->parts)
        paintLine(painter, m_geometry, part);
}

/// Draws only what is within the area, because an SVG file has no clipping.
void ResponsePlot::paintRange(QPainter& painter) const {
    QColor fill = colour(kPrediction);
    fill.setAlpha(kBandAlpha);
    QPainterPath path;
    path.addPolygon(m_geometry.at(m_range).intersected(QPolygonF(m_geometry.area)));
    painter.fillPath(path, fill);
}

void ResponsePlot::paintOthers(QPainter& painter) const {
    double strength = 0;
    for (const Curve& curve : m_others) {
        strength += 1.0 / static_cast<double>(m_others.size());
        QColor pale = colour(0);
        pale.setAlphaF(static_cast<float>(kPalest + (kStrongest - kPalest) * strength));
        painter.setPen(QPen(pale, 1));
        for (const QPolygonF& part : curve.parts)
            paintLine(painter, m_geometry, part);
    }
}

// ---- cursors ----

std::optional<double> ResponsePlot::Curve::at(double seconds) const {
    for (const QPolygonF& part : parts)
        for (qsizetype i = 1; i < part.size(); ++i)
            if (seconds >= part[i - 1].x() && seconds <= part[i].x())
                return part[i - 1].y() + (part[i].y() - part[i - 1].y()) * (seconds - part[i - 1].x()) /
                                             (part[i].x() - part[i - 1].x());
    return std::nullopt;
}

void ResponsePlot::showCursors(bool shown) {
    if (shown == cursors().has_value())
        return;
    const View view = seen();
    const double width = view.right - view.left;
    setCursors(shown ? std::optional(Cursors{view.left + width / 4, view.left + width * 3 / 4})
                     : std::nullopt);
    emit measured();
}

std::vector<std::array<QString, 4>> ResponsePlot::readings() const {
    std::vector<std::array<QString, 4>> rows;
    if (!cursors())
        return rows;
    const auto& [first, second] = *cursors();
    rows.push_back({Common::tr("time"), texts::stretch(first), texts::stretch(second),
                    CursorTable::between(*cursors())});
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (!m_curves[i])
            continue;
        const auto text = [&](std::optional<double> value) {
            return value ? texts::readout(*value) + u' ' + m_curves[i]->unit : u"–"_s;
        };
        const auto from = m_curves[i]->at(first);
        const auto to = m_curves[i]->at(second);
        rows.push_back({i == 0 ? Common::tr("A") : Common::tr("B"), text(from), text(to),
                        text(from && to ? std::optional(*to - *from) : std::nullopt)});
    }
    return rows;
}

// ---- mouse and keys, as in the scope ----

void ResponsePlot::moveCursor(std::size_t cursor, double seconds) {
    RecordPlot::moveCursor(cursor, seconds);
    emit measured();
}

void ResponsePlot::showEverything() {
    m_whole = !m_whole;
    RecordPlot::fitAgain();
}

void ResponsePlot::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_C)
        return emit cursorsWanted();
    if (event->key() != Qt::Key_Home)
        return RecordPlot::keyPressEvent(event);
    m_whole = true;
    RecordPlot::fitAgain();
}

int ResponsePlot::stripsHeight() const {
    const double em = fontMetrics().height();
    const bool room = height() >= em * (10 + ResponseStrips::kLines);
    return room && (m_curves[0] || m_curves[1]) ? qRound(em * ResponseStrips::kLines) : 0;
}

}  // namespace nmc

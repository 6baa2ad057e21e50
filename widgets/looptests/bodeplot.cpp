// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/bodeplot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/intent/looptestplan.h"
#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kLowestDecibels = -40, kHighestDecibels = 20;
constexpr double kFarthestBehind = -270, kAhead = 0;
QPen penOf(const QColor& colour, bool open) {
    QPen pen(colour, kTraceWidth);
    if (open)
        pen.setDashPattern({4, 2.5});
    return pen;
}
}  // namespace

struct BodePlot::Line {
    QPen pen;
    bool dotted = false;
    QPolygonF points{};                           ///< Hz and value
    std::vector<std::array<double, 2>> spread{};  ///< from, to
};

namespace {
/// The range from `low` to `high`, extended to include all values, in whole steps of `grain`.
template <typename Lines>
std::pair<double, double> rangeOf(const Lines& lines, double low, double high, double grain) {
    for (const auto& line : lines)
        for (const QPointF& point : line.points) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    return {std::floor(low / grain) * grain, std::ceil(high / grain) * grain};
}
}  // namespace

struct BodePlot::Pane {
    QRectF area;
    QString title;
    double from, to;  ///< Hz
    double bottom, top;
    double grain;  ///< between two lines
    double level;  ///< value of the emphasised line
    bool labelsFrequencies;
    std::vector<Line> lines;

    [[nodiscard]] double x(double hertz) const {
        return area.left() + std::log(hertz / from) / std::log(to / from) * area.width();
    }
    [[nodiscard]] double y(double value) const {
        return area.bottom() - (value - bottom) / (top - bottom) * area.height();
    }
};

BodePlot::BodePlot(QWidget* parent) : QWidget(parent) {
    look::name(this, u"bodePlot"_s, Common::tr("Frequency response"));
    setToolTip(tr(
        "T: closed loop, from command to position. L: open loop; its phase above -180° where it crosses 0 dB is the phase margin. Right of the grey line the baud rate is too low to measure. Bars: two standard deviations of T."));
    setFont(look::tabular(look::scaled(font(), 0.9)));
}

void BodePlot::showCurves(std::vector<Curve> curves, double honest) {
    if (curves == m_curves && honest == m_honest)
        return;
    m_curves = std::move(curves);
    m_honest = honest;
    update();
}

void BodePlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    const QRectF area = rect();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (m_curves.empty()) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(
            area, Qt::AlignCenter | Qt::TextWordWrap,
            tr("No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop."));
        return;
    }
    const QFontMetricsF metrics(font());
    std::vector<Line> loud, late;
    double from = 1.0;
    double to = kFastestSine;
    for (const Curve& curve : m_curves) {
        addLines(curve, loud, late);
        from = std::min(from, curve.points.front().hertz);
        to = std::max(to, curve.points.back().hertz);
    }
    const double left = metrics.horizontalAdvance(u"-270"_s) + metrics.height();
    const double below = metrics.height() * 2.6;
    const double gap = metrics.height() * 1.6;
    const double high = (area.height() - below - 2 * gap) / 2;
    const double wide = area.width() - left - metrics.height();
    const auto [lowest, highest] = rangeOf(loud, kLowestDecibels, kHighestDecibels, 20);
    const auto [behind, ahead] = rangeOf(late, kFarthestBehind, kAhead, 90);
    paintPane(painter, {QRectF(area.left() + left, area.top() + gap, wide, high), tr("Magnitude, dB"), from,
                        to, lowest, highest, 20, 0, false, std::move(loud)});
    paintPane(painter, {QRectF(area.left() + left, area.top() + 2 * gap + high, wide, high),
                        tr("Phase, degrees"), from, to, behind, ahead, 90, -180, true, std::move(late)});
    const QColor text = palette().color(QPalette::Text);
    paintLegend(painter, QRectF(area.left() + left, area.top(), wide, gap),
                {{tr("T, closed loop"), penOf(text, false)}, {tr("L, open loop"), penOf(text, true)}});
    std::vector<std::pair<QString, QPen>> names;
    for (const Curve& curve : m_curves)
        if (m_curves.size() > 1)
            names.emplace_back(curve.name, penOf(look::traceColour(curve.colour, palette()), false));
    paintLegend(painter, QRectF(area.left() + left, area.top() + gap + high, wide, gap), names);
}

void BodePlot::addLines(const Curve& curve, std::vector<Line>& loud, std::vector<Line>& late) const {
    for (const bool open : {false, true}) {
        if (!open && !curve.closes)
            continue;
        std::vector<FrequencyPoint> points;
        std::vector<std::complex<double>> values;
        for (const FrequencyPoint& point : curve.points)
            // L has no value where T is exactly 1.
            if (const auto value = open ? point.open() : point.closed; std::isfinite(std::norm(value))) {
                points.push_back(point);
                values.push_back(value);
            }
        const std::vector<double> turned = phases(values);
        Line magnitude{penOf(look::traceColour(curve.colour, palette()), open), curve.measured && !open};
        Line phase = magnitude;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const FrequencyPoint& point = points[i];
            magnitude.points << QPointF(point.hertz, decibels(values[i]));
            phase.points << QPointF(point.hertz, turned[i]);
            if (open)
                continue;
            const FrequencySpread spread = spreadOf(point);
            magnitude.spread.push_back({spread.lowest, spread.highest});
            phase.spread.push_back({turned[i] - spread.degrees, turned[i] + spread.degrees});
        }
        loud.push_back(std::move(magnitude));
        late.push_back(std::move(phase));
    }
}

void BodePlot::paintPane(QPainter& painter, const Pane& pane) const {
    const QFontMetricsF metrics(font());
    const QColor muted = look::mutedText(palette());
    painter.setPen(QPen(look::faintLine(palette()), 1));
    for (double decade = std::pow(10, std::floor(std::log10(pane.from))); decade < pane.to; decade *= 10)
        for (int i = 1; i < 10; ++i)
            if (const double hertz = decade * i; hertz >= pane.from && hertz <= pane.to) {
                painter.setPen(QPen(look::faintLine(palette()), 1));
                painter.drawLine(QLineF(pane.x(hertz), pane.area.top(), pane.x(hertz), pane.area.bottom()));
                if (!pane.labelsFrequencies || (i != 1 && i != 2 && i != 5))
                    continue;
                painter.setPen(muted);
                painter.drawText(QRectF(pane.x(hertz) - 40, pane.area.bottom(), 80, metrics.height() * 1.2),
                                 Qt::AlignCenter, texts::readout(hertz, 2));
            }
    for (double value = pane.bottom; value <= pane.top; value += pane.grain) {
        painter.setPen(QPen(value == pane.level ? muted : look::faintLine(palette()), 1));
        painter.drawLine(QLineF(pane.area.left(), pane.y(value), pane.area.right(), pane.y(value)));
        painter.setPen(muted);
        painter.drawText(QRectF(0, pane.y(value) - metrics.height() / 2,
                                pane.area.left() - metrics.height() / 3, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, texts::readout(value, 3));
    }
    painter.drawText(QPointF(pane.area.left(), pane.area.top() - metrics.descent()), pane.title);
    if (pane.labelsFrequencies)
        painter.drawText(QRectF(pane.area.left(), pane.area.bottom() + metrics.height() * 1.2,
                                pane.area.width(), metrics.height() * 1.2),
                         Qt::AlignCenter, tr("Frequency, Hz"));
    if (m_honest > pane.from && m_honest < pane.to) {
        painter.setPen(QPen(muted, 1, Qt::DashLine));
        painter.drawLine(QLineF(pane.x(m_honest), pane.area.top(), pane.x(m_honest), pane.area.bottom()));
    }
    for (const Line& line : pane.lines) {
        painter.setPen(line.pen);
        QPolygonF drawn;
        for (const QPointF& point : line.points)
            drawn << QPointF(pane.x(point.x()), pane.y(point.y()));
        painter.drawPolyline(drawn);
        if (line.dotted) {
            painter.setBrush(line.pen.color());
            for (const QPointF& point : drawn)
                painter.drawEllipse(point, 2, 2);
            painter.setBrush(Qt::NoBrush);
        }
        paintSpread(painter, pane, line);
    }
}

void BodePlot::paintSpread(QPainter& painter, const Pane& pane, const Line& line) {
    constexpr double kFoot = 3;
    for (std::size_t i = 0; i < line.spread.size(); ++i) {
        const double x = pane.x(line.points[static_cast<qsizetype>(i)].x());
        const double low = pane.y(std::max(line.spread[i][0], pane.bottom));
        const double high = pane.y(std::min(line.spread[i][1], pane.top));
        if (low - high < 2 * kFoot)  // within the dot
            continue;
        painter.drawLine(QLineF(x, low, x, high));
        for (const double y : {low, high})
            painter.drawLine(QLineF(x - kFoot, y, x + kFoot, y));
    }
}

/// From right to left.
void BodePlot::paintLegend(QPainter& painter, const QRectF& area,
                           const std::vector<std::pair<QString, QPen>>& entries) const {
    const QFontMetricsF metrics(font());
    double x = area.right();
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
        x -= metrics.horizontalAdvance(entry->first);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x, area.bottom() - metrics.descent()), entry->first);
        painter.setPen(entry->second);
        const double y = area.bottom() - metrics.height() / 2;
        x -= metrics.height() * 0.5;
        painter.drawLine(QLineF(x - metrics.height() * 1.5, y, x, y));
        x -= metrics.height() * 2.5;
    }
}

QSize BodePlot::sizeHint() const {
    return {fontMetrics().height() * 26, fontMetrics().height() * 18};
}

QSize BodePlot::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 12};
}

}  // namespace nmc

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
constexpr std::array<int, 2> kCurveColours{0, 2};  ///< T, L

/// The range from `low` to `high`, extended to include all values, in whole steps of `grain`.
std::pair<double, double> rangeOf(const std::array<std::vector<double>, 2>& curves, double low, double high,
                                  double grain) {
    for (const auto& curve : curves)
        for (const double value : curve) {
            low = std::min(low, value);
            high = std::max(high, value);
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
    bool tellsFrequencies;
    std::array<std::vector<double>, 2> curves;
    std::vector<std::array<double, 2>> spread;  ///< of the first curve: from, to

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

void BodePlot::showPoints(const std::vector<FrequencyPoint>& points, double honest) {
    if (points == m_points && honest == m_honest)
        return;
    m_points = points;
    m_honest = honest;
    update();
}

void BodePlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    paintTo(painter, rect());
}

void BodePlot::paintTo(QPainter& painter, const QRectF& area) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (m_points.empty()) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(
            area, Qt::AlignCenter | Qt::TextWordWrap,
            tr("No measurement yet. The motor follows sine waves from slow to fast, which shows the response of the loop."));
        return;
    }
    const QFontMetricsF metrics(font());
    std::vector<std::complex<double>> closed, open;
    for (const FrequencyPoint& point : m_points) {
        closed.push_back(point.closed);
        open.push_back(point.open());
    }
    std::array<std::vector<double>, 2> magnitudes;
    const std::array<std::vector<double>, 2> turned{phases(closed), phases(open)};
    std::vector<std::array<double, 2>> loud, late;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        magnitudes[0].push_back(decibels(closed[i]));
        magnitudes[1].push_back(decibels(open[i]));
        const FrequencySpread spread = spreadOf(m_points[i]);
        loud.push_back({spread.lowest, spread.highest});
        late.push_back({turned[0][i] - spread.degrees, turned[0][i] + spread.degrees});
    }
    const double left = metrics.horizontalAdvance(u"-270"_s) + metrics.height();
    const double below = metrics.height() * 2.6;
    const double gap = metrics.height() * 1.6;
    const double high = (area.height() - below - 2 * gap) / 2;
    const double wide = area.width() - left - metrics.height();
    const double from = std::min(1.0, m_points.front().hertz);
    const double to = std::max(kFastestSine, m_points.back().hertz);
    const auto [lowest, highest] = rangeOf(magnitudes, kLowestDecibels, kHighestDecibels, 20);
    const auto [behind, ahead] = rangeOf(turned, kFarthestBehind, kAhead, 90);
    paintPane(painter, {QRectF(area.left() + left, area.top() + gap, wide, high), tr("Magnitude, dB"), from,
                        to, lowest, highest, 20, 0, false, magnitudes, loud});
    paintPane(painter, {QRectF(area.left() + left, area.top() + 2 * gap + high, wide, high),
                        tr("Phase, degrees"), from, to, behind, ahead, 90, -180, true, turned, late});
    paintLegend(painter, QRectF(area.left() + left, area.top(), wide, gap));
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
                if (!pane.tellsFrequencies || (i != 1 && i != 2 && i != 5))
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
    if (pane.tellsFrequencies)
        painter.drawText(QRectF(pane.area.left(), pane.area.bottom() + metrics.height() * 1.2,
                                pane.area.width(), metrics.height() * 1.2),
                         Qt::AlignCenter, tr("Frequency, Hz"));
    if (m_honest > pane.from && m_honest < pane.to) {
        painter.setPen(QPen(muted, 1, Qt::DashLine));
        painter.drawLine(QLineF(pane.x(m_honest), pane.area.top(), pane.x(m_honest), pane.area.bottom()));
    }
    for (std::size_t which = 0; which < pane.curves.size(); ++which) {
        QPen pen(look::traceColour(kCurveColours.at(which), palette()), kTraceWidth);
        if (which == 1)
            pen.setDashPattern({4, 2.5});
        painter.setPen(pen);
        QPolygonF line;
        for (std::size_t i = 0; i < m_points.size(); ++i)
            line << QPointF(pane.x(m_points[i].hertz), pane.y(pane.curves.at(which)[i]));
        painter.drawPolyline(line);
        if (which != 0)
            continue;
        painter.setBrush(pen.color());
        for (const QPointF& point : line)
            painter.drawEllipse(point, 2, 2);
        painter.setBrush(Qt::NoBrush);
        paintSpread(painter, pane, line);
    }
}

void BodePlot::paintSpread(QPainter& painter, const Pane& pane, const QPolygonF& points) {
    constexpr double kFoot = 3;
    for (std::size_t i = 0; i < pane.spread.size(); ++i) {
        const double x = points[static_cast<qsizetype>(i)].x();
        const double low = pane.y(std::max(pane.spread[i][0], pane.bottom));
        const double high = pane.y(std::min(pane.spread[i][1], pane.top));
        if (low - high < 2 * kFoot)  // within the dot
            continue;
        painter.drawLine(QLineF(x, low, x, high));
        for (const double y : {low, high})
            painter.drawLine(QLineF(x - kFoot, y, x + kFoot, y));
    }
}

void BodePlot::paintLegend(QPainter& painter, const QRectF& area) const {
    const QFontMetricsF metrics(font());
    double x = area.right();
    const QStringList names{tr("T, closed loop"), tr("L, open loop")};
    for (qsizetype i = names.size() - 1; i >= 0; --i) {
        x -= metrics.horizontalAdvance(names[i]);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x, area.bottom() - metrics.descent()), names[i]);
        QPen pen(look::traceColour(kCurveColours.at(static_cast<std::size_t>(i)), palette()), kTraceWidth);
        if (i == 1)
            pen.setDashPattern({4, 2.5});
        painter.setPen(pen);
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

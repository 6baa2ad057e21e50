// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracedrawing.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPaintEngine>
#include <QPainter>
#include <QVarLengthArray>
#include <cmath>
#include <limits>

namespace nmc {

namespace {

constexpr double kPenWidth = 1.6;
constexpr double kDashPeriod = 9.0;  ///< px along the time axis
constexpr double kDashShare = 0.6;
constexpr int kBandAlpha = 70;
constexpr double kDense = 0.5;  ///< columns for each pixel
constexpr double kMargin = 10;  ///< px beyond the plot area

using Lines = QVarLengthArray<QLineF, 4096>;

/// The part of a line within `area`, as shares of it; false if there is none. Zoomed in far enough a line
/// between two samples is millions of pixels long: neither dashes nor the rasterizer may see that.
bool clip(const QLineF& line, const QRectF& area, double& from, double& to) {
    from = 0;
    to = 1;
    const auto cut = [&](double start, double way, double least, double most) {
        if (way == 0)
            return start >= least && start <= most;
        const double first = (way > 0 ? least - start : most - start) / way;
        const double last = (way > 0 ? most - start : least - start) / way;
        from = std::max(from, first);
        to = std::min(to, last);
        return from < to;
    };
    return cut(line.x1(), line.dx(), area.left(), area.right()) &&
           cut(line.y1(), line.dy(), area.top(), area.bottom());
}

/// For paper. Such a file has pixels of any size, and no clipping (Qt 6.4).
bool isVector(const QPainter& painter) {
    return painter.paintEngine()->type() == QPaintEngine::SVG;
}

/// Dashes that hang on the time of the data, so that they roll with it instead of crawling along it. Where
/// the trace is steep a gap would hide something, so it is drawn through.
void addDashed(const QLineF& line, double phase, double next, Lines& lines) {
    if (std::abs(line.dy()) > 2 * std::abs(line.dx()) + 4) {
        lines.append(line);
        return;
    }
    if (next <= phase)
        return;
    for (double dash = std::floor(phase); dash < next; dash += 1.0) {
        const double from = std::max(dash, phase);
        const double to = std::min(dash + kDashShare, next);
        if (to > from)
            lines.append(QLineF(line.pointAt((from - phase) / (next - phase)),
                                line.pointAt((to - phase) / (next - phase))));
    }
}

}  // namespace

void TraceDrawing::clear() {
    m_columns.clear();
    m_hasBand = false;
    m_lowest = std::numeric_limits<double>::infinity();
    m_highest = -m_lowest;
    m_lowestBand = m_lowest;
    m_highestBand = m_highest;
}

void TraceDrawing::take(const ModuleHistory& history, ScopeSignal signal, const LinearScale& scale,
                        TimePoint zero, const PlotGeometry& geometry, double devicePixelRatio) {
    clear();
    const double pixels = std::max(1.0, geometry.area.width() * devicePixelRatio);
    const Duration widest = fromSeconds((geometry.right - geometry.left) / pixels);
    const bool band = signal == ScopeSignal::Error;
    ScopeSpan before;
    bool beforeKnown = false;
    const auto visit = [&](const ScopeSpan& span) {
        const ScopeSpan::Extremes extremes = span.extremes(signal);
        if (extremes.known()) {
            const double low = scale(extremes.low);
            const double high = scale(extremes.high);
            Column column{toSeconds(span.first - zero),
                          toSeconds(span.last - zero),
                          extremes.lowFirst ? low : high,
                          extremes.lowFirst ? high : low,
                          low,
                          high,
                          beforeKnown && span.joins(before, signal)};
            if (band && std::isfinite(span.bandLow)) {
                column.bandLow = scale(static_cast<double>(span.bandLow));
                column.bandHigh = scale(static_cast<double>(span.bandHigh));
                m_hasBand = m_hasBand || column.bandHigh > column.bandLow;
            }
            m_columns.push_back(column);
            if (column.right >= geometry.left && column.left <= geometry.right) {
                m_lowest = std::min(m_lowest, low);
                m_highest = std::max(m_highest, high);
                m_lowestBand = std::min({m_lowestBand, column.bandLow, column.bandHigh});
                m_highestBand = std::max({m_highestBand, column.bandLow, column.bandHigh});
            }
        }
        beforeKnown = extremes.known();
        before = span;
    };
    history.visit(zero + fromSeconds(geometry.left), zero + fromSeconds(geometry.right), widest, visit);
}

void TraceDrawing::paint(QPainter& painter, const PlotGeometry& geometry) const {
    if (m_columns.empty() || geometry.empty())
        return;
    if (m_hasBand)
        paintBand(painter, geometry);
    if (static_cast<double>(m_columns.size()) > geometry.area.width() * kDense && !isVector(painter))
        paintDense(painter, geometry);
    else
        paintLines(painter, geometry);
    if (!tag.isEmpty())
        paintTag(painter, geometry);
}

double TraceDrawing::dashesPerSecond(const PlotGeometry& geometry) {
    return geometry.area.width() / (geometry.right - geometry.left) / kDashPeriod;
}

void TraceDrawing::paintLines(QPainter& painter, const PlotGeometry& geometry) const {
    const double dashes = dashesPerSecond(geometry);
    Lines lines;
    const auto add = [&](const QLineF& line, double fromSecond, double toSecond) {
        double from = 0, to = 1;
        if (!clip(line, geometry.area, from, to))
            return;
        const QLineF seen(line.pointAt(from), line.pointAt(to));
        const double seconds = toSecond - fromSecond;
        if (dashed)
            addDashed(seen, (fromSecond + from * seconds) * dashes, (fromSecond + to * seconds) * dashes,
                      lines);
        else
            lines.append(seen);
    };
    QPointF before;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column& column = m_columns[i];
        const QPointF entry(geometry.x(column.left), geometry.y(column.entry));
        const QPointF exit(geometry.x(column.right), geometry.y(column.exit));
        const bool goesOn = i + 1 < m_columns.size() && m_columns[i + 1].joined;
        if (column.joined)
            add(QLineF(before, entry), m_columns[i - 1].right, column.left);
        if (entry != exit)
            add(QLineF(entry, exit), column.left, column.right);
        else if (!column.joined && !goesOn && geometry.area.contains(entry))
            lines.append(QLineF(entry.x() - kPenWidth, entry.y(), entry.x() + kPenWidth, entry.y()));
        before = exit;
    }
    // Round caps would cost six times as much.
    painter.setPen(QPen(colour, kPenWidth, Qt::SolidLine, dashed ? Qt::FlatCap : Qt::SquareCap));
    painter.drawLines(lines.constData(), static_cast<int>(lines.size()));
}

/// Where there is a column in nearly every pixel, each pixel's reach is filled: a third of what lines cost.
void TraceDrawing::paintDense(QPainter& painter, const PlotGeometry& geometry) const {
    const double dashes = dashesPerSecond(geometry);
    QVarLengthArray<QRectF, 4096> rects;
    double pixel = 0, low = 0, high = 0;
    bool open = false;
    const auto close = [&] {
        if (!open)
            return;
        const double phase = geometry.seconds(pixel) * dashes;
        const bool gap = dashed && high - low < kPenWidth * 2 && phase - std::floor(phase) > kDashShare;
        if (!gap)
            rects.append(QRectF(pixel, low - kPenWidth / 2, 1, high - low + kPenWidth));
        open = false;
    };
    const auto reach = [&](double x, double from, double to) {
        if (open && std::floor(x) != pixel)
            close();
        const auto [top, bottom] = std::minmax(from, to);
        low = open ? std::min(low, top) : top;
        high = open ? std::max(high, bottom) : bottom;
        pixel = std::floor(x);
        open = true;
    };
    // What is beyond the plot area is clipped anyway.
    const auto within = [&](double y) {
        return std::clamp(y, geometry.area.top() - kMargin, geometry.area.bottom() + kMargin);
    };
    double beforeX = 0, beforeY = 0;
    for (const Column& column : m_columns) {
        const double x = geometry.x(column.left);
        const double entry = within(geometry.y(column.entry));
        const double exit = within(geometry.y(column.exit));
        // Pixels that lie between two columns are crossed on a straight line.
        const double first = std::max(std::floor(beforeX) + 1, geometry.area.left());
        for (double between = first;
             column.joined && between < std::min(std::floor(x), geometry.area.right()); between += 1) {
            const double slope = (entry - beforeY) / (x - beforeX);
            reach(between, beforeY + slope * (between - beforeX), beforeY + slope * (between + 1 - beforeX));
        }
        reach(x, column.joined && std::floor(beforeX) + 1 >= std::floor(x) ? beforeY : entry, entry);
        reach(x, entry, exit);
        beforeX = x;
        beforeY = exit;
    }
    close();
    // All at once: the painter sets out anew for each call.
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRects(rects.constData(), static_cast<int>(rects.size()));
}

void TraceDrawing::paintBand(QPainter& painter, const PlotGeometry& geometry) const {
    QVarLengthArray<QRectF, 4096> rects;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column& column = m_columns[i];
        const double from = geometry.x(column.left);
        // As far as the next one, which may be many pixels away.
        const bool goesOn = i + 1 < m_columns.size() && m_columns[i + 1].joined;
        const double to = goesOn ? geometry.x(m_columns[i + 1].left) : geometry.x(column.right) + 1;
        const QRectF band(QPointF(from, geometry.y(column.bandHigh)),
                          QPointF(to, geometry.y(column.bandLow)));
        if (const QRectF seen = band & geometry.area; !seen.isEmpty())
            rects.append(seen);
    }
    QColor fill = colour;
    fill.setAlpha(kBandAlpha);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRects(rects.constData(), static_cast<int>(rects.size()));
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void TraceDrawing::paintTag(QPainter& painter, const PlotGeometry& geometry) const {
    for (auto column = m_columns.rbegin(); column != m_columns.rend(); ++column) {
        if (column->right > geometry.right)
            continue;
        const QFontMetricsF metrics(painter.font());
        const double width = metrics.horizontalAdvance(tag);
        const double x = std::min(geometry.x(column->right) + 3, geometry.area.right() - width - 2);
        painter.drawText(QPointF(x, geometry.y(column->exit) - 3), tag);
        return;
    }
}

}  // namespace nmc

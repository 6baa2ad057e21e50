// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracedrawing.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QVarLengthArray>
#include <cmath>
#include <limits>
#include <optional>

namespace nmc {

namespace {

constexpr double kPenWidth = 1.6;
constexpr double kDashPeriod = 9.0;  ///< px along the time axis
constexpr double kDashShare = 0.6;
constexpr int kBandAlpha = 70;

using Lines = QVarLengthArray<QLineF, 4096>;

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

/// The part of a line within `area`. A painter's own clipping is not enough: an SVG file has none.
std::optional<QLineF> within(const QRectF& area, const QLineF& line) {
    double from = 0;
    double to = 1;
    const auto cut = [&](double start, double delta, double low, double high) {
        if (delta == 0.0) {
            if (start < low || start > high)
                to = -1;
            return;
        }
        const auto [first, second] = std::minmax({(low - start) / delta, (high - start) / delta});
        from = std::max(from, first);
        to = std::min(to, second);
    };
    cut(line.x1(), line.dx(), area.left(), area.right());
    cut(line.y1(), line.dy(), area.top(), area.bottom());
    if (from > to)
        return std::nullopt;
    return QLineF(line.pointAt(from), line.pointAt(to));
}

}  // namespace

void TraceDrawing::clear() {
    m_columns.clear();
    m_hasBand = false;
    m_lowest = std::numeric_limits<double>::infinity();
    m_highest = -m_lowest;
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
            if (band) {
                column.bandLow = scale(static_cast<double>(span.bandLow));
                column.bandHigh = scale(static_cast<double>(span.bandHigh));
                m_hasBand = m_hasBand || column.bandHigh > column.bandLow;
            }
            m_columns.push_back(column);
            if (column.right >= geometry.left && column.left <= geometry.right) {
                m_lowest = std::min(m_lowest, low);
                m_highest = std::max(m_highest, high);
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
    const double phasePerSecond = geometry.area.width() / (geometry.right - geometry.left) / kDashPeriod;
    Lines lines;
    const auto add = [&](const QLineF& line, double fromSecond, double toSecond) {
        if (dashed)
            addDashed(line, fromSecond * phasePerSecond, toSecond * phasePerSecond, lines);
        else
            lines.append(line);
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
        else if (!column.joined && !goesOn)
            lines.append(QLineF(entry.x() - kPenWidth, entry.y(), entry.x() + kPenWidth, entry.y()));
        before = exit;
    }
    painter.setPen(QPen(colour, kPenWidth, Qt::SolidLine, dashed ? Qt::FlatCap : Qt::RoundCap));
    Lines seen;
    for (const QLineF& line : lines)
        if (const auto part = within(geometry.area, line))
            seen.append(*part);
    painter.drawLines(seen.constData(), static_cast<int>(seen.size()));
    if (!tag.isEmpty())
        paintTag(painter, geometry);
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

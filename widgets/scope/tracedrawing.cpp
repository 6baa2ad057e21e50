// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracedrawing.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QVarLengthArray>
#include <cmath>

#include "widgets/common/plots.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

namespace {

constexpr double kDashPeriod = 9.0;  ///< px along the time axis
constexpr double kDashShare = 0.6;
constexpr int kEnvelopeAlpha = 70;
constexpr double kDense = 0.5;       ///< columns per pixel
constexpr double kClampMargin = 10;  ///< px beyond the plot area
constexpr double kTip = 2;          ///< px; a column that exceeds its neighbours by more stays one pixel wide
constexpr double kStraight = 0.05;  ///< px by which a point may be beside the line that passes it
constexpr double kSteep = 2;        ///< px per px; steeper lines are not dashed

using Lines = QVarLengthArray<QLineF, 4096>;

/// True when drawing for paper: pixels may have any size, and an SVG file has no clipping (Qt 6.4).
bool isVector(const QPainter& painter) {
    return painter.paintEngine()->type() != QPaintEngine::Raster;
}

/// Adds dashes that are tied to the time of the data, so that they roll with the trace instead of crawling
/// along it. Where the trace is steep, a gap would hide something, so the line is drawn solid.
void addDashed(const QLineF& line, double phase, double next, Lines& lines) {
    if (std::abs(line.dy()) > kSteep * std::abs(line.dx()) + 4) {
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

/// Lines that go straight on, as one line: most of what a line costs does not depend on its length.
class Straight {
public:
    /// The times, in s, are those of the line's ends. A dashed line must not become so long that it is steep.
    Straight(const QLineF& line, double from, double to, bool dashed)
        : m_line(line),
          m_from(from),
          m_to(to),
          m_most(dashed ? kSteep : std::numeric_limits<double>::infinity()) {
        narrow();
    }

    [[nodiscard]] const QLineF& line() const { return m_line; }
    [[nodiscard]] double from() const { return m_from; }
    [[nodiscard]] double to() const { return m_to; }

    /// Returns false if this line does not go straight on.
    bool add(const QLineF& line, double to) {
        const QLineF whole(m_line.p1(), line.p2());
        const double slope = whole.dy() / whole.dx();
        if (line.p1() != m_line.p2() || !(slope >= m_least && slope <= m_most))
            return false;
        m_line = whole;
        m_to = to;
        narrow();
        return true;
    }

private:
    /// Whatever is added must pass the present end.
    void narrow() {
        m_least = std::max(m_least, (m_line.dy() - kStraight) / m_line.dx());
        m_most = std::min(m_most, (m_line.dy() + kStraight) / m_line.dx());
    }

    QLineF m_line;
    double m_from, m_to;
    double m_most;  ///< px per px
    double m_least = -m_most;
};

/// Draws a thick line from left to right, one column of pixels at a time: where two columns meet, its edges
/// are halfway between them, so that it is smooth however steep it is. The coverage of a pixel has a closed
/// form, which costs a tenth of what Qt's painter needs for the same outline. All lengths are in device
/// pixels.
class ThickLine {
public:
    /// `rows`: the first visible row, and the one after the last.
    ThickLine(QPainter& painter, const QColor& colour, double pixel, std::pair<int, int> rows)
        : m_painter(painter),
          m_pixel(pixel),
          m_rows(rows),
          m_tile(kPiece, std::max(1, rows.second - rows.first), QImage::Format_ARGB32_Premultiplied) {
        m_tile.setDevicePixelRatio(1 / pixel);
        for (int i = 0; i <= kFull; ++i)
            m_colours[static_cast<std::size_t>(i)] =
                qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), i * colour.alpha() / kFull));
    }

    void add(int column, double top, double bottom) { m_reaches.append({column, top, bottom}); }
    /// Ends the line: what follows is not joined to it.
    void end() {
        for (qsizetype begin = 0; begin < m_reaches.size(); begin += kPiece)
            fill(begin, std::min<qsizetype>(begin + kPiece, m_reaches.size()));
        m_reaches.clear();
    }

private:
    static constexpr int kPiece = 64;
    static constexpr int kFull = 255;
    static constexpr double kFlat = 100;  ///< pixels per row; flatter edges are treated as level
    struct Reach {
        int column;
        double top, bottom;
    };
    using Edge = double Reach::*;
    /// An edge within one column, straight from its left side to its right side.
    struct Course {
        double left, right;
        double steep = left == right ? 0.0 : 1 / (right - left);

        [[nodiscard]] double lowest() const { return std::max(left, right); }
        [[nodiscard]] double highest() const { return std::min(left, right); }
        /// Share of the pixel in this row that is above the edge.
        [[nodiscard]] double above(double row) const {
            return steep == 0 || std::abs(steep) > kFlat ? std::clamp((left + right) / 2 - row, 0.0, 1.0)
                                                         : (sum(right - row) - sum(left - row)) * steep;
        }
        [[nodiscard]] static double sum(double y) {
            const double part = std::clamp(y, 0.0, 1.0);
            return part * part / 2 + std::max(y - 1, 0.0);
        }
    };

    [[nodiscard]] Course course(qsizetype i, Edge edge) const {
        const double here = m_reaches[i].*edge;
        const double before = i > 0 ? m_reaches[i - 1].*edge : here;
        const double after = i + 1 < m_reaches.size() ? m_reaches[i + 1].*edge : here;
        const double out = edge == &Reach::top ? 1 : -1;
        if ((i == 0 || out * (before - here) > kTip) &&
            (i + 1 == m_reaches.size() || out * (after - here) > kTip))
            return {here, here};
        return {(before + here) / 2, (here + after) / 2};
    }
    void fill(qsizetype begin, qsizetype end) {
        double top = m_reaches[begin].top;
        double bottom = m_reaches[begin].bottom;
        for (qsizetype i = begin; i < end; ++i) {
            top = std::min(top, m_reaches[i].top);
            bottom = std::max(bottom, m_reaches[i].bottom);
        }
        const int first = std::max(static_cast<int>(std::floor(top)), m_rows.first);
        const int behind = std::min(static_cast<int>(std::floor(bottom)) + 1, m_rows.second);
        if (behind <= first)
            return;
        const int width = static_cast<int>(end - begin);
        for (int row = first; row < behind; ++row)
            std::fill_n(line(row), width, 0U);
        for (qsizetype i = begin; i < end; ++i)
            fillColumn(i, static_cast<int>(i - begin), first, behind);
        m_painter.drawImage(QPointF(m_reaches[begin].column, first) * m_pixel, m_tile,
                            QRect(0, first - m_rows.first, width, behind - first));
    }
    void fillColumn(qsizetype i, int column, int first, int behind) {
        const Course top = course(i, &Reach::top);
        const Course bottom = course(i, &Reach::bottom);
        const double full = top.lowest();
        const double end = bottom.highest() - 1;
        const int last = std::min(static_cast<int>(std::floor(bottom.lowest())) + 1, behind);
        for (int row = std::max(static_cast<int>(std::floor(top.highest())), first); row < last; ++row) {
            const double under = row < full ? top.above(row) : 0.0;
            const double over = row > end ? bottom.above(row) : 1.0;
            const double covered = std::clamp(over - under, 0.0, 1.0);
            line(row)[column] = m_colours[static_cast<std::size_t>(kFull * covered + 0.5)];
        }
    }
    [[nodiscard]] QRgb* line(int row) {
        return reinterpret_cast<QRgb*>(m_bits + m_stride * (row - m_rows.first));
    }

    QPainter& m_painter;
    double m_pixel;
    std::pair<int, int> m_rows;
    QImage m_tile;
    uchar* m_bits = m_tile.bits();
    qsizetype m_stride = m_tile.bytesPerLine();
    std::array<QRgb, kFull + 1> m_colours{};
    QVarLengthArray<Reach, 2048> m_reaches;
};

}  // namespace

void TraceDrawing::clear() {
    m_columns.clear();
    m_hasBand = false;
    m_reach = {};
    m_highs = m_highBands = m_negatedLows = m_negatedLowBands = {};
    m_visible = 0;
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
            const double first = scale(extremes.lowFirst ? extremes.low : extremes.high);
            const double last = scale(extremes.lowFirst ? extremes.high : extremes.low);
            // With a negative scale, the lowest becomes the highest.
            const auto [low, high] = std::minmax({first, last});
            Column column{toSeconds(span.first - zero),
                          toSeconds(span.last - zero),
                          first,
                          last,
                          low,
                          high,
                          beforeKnown && span.joins(before, signal)};
            if (band && std::isfinite(span.bandLow)) {
                std::tie(column.bandLow, column.bandHigh) = std::minmax(
                    {scale(static_cast<double>(span.bandLow)), scale(static_cast<double>(span.bandHigh))});
                m_hasBand = m_hasBand || column.bandHigh > column.bandLow;
            }
            m_columns.push_back(column);
            if (column.right >= geometry.left && column.left <= geometry.right) {
                if (low < m_reach.low)
                    m_lowestAt = column.left;
                if (high > m_reach.high)
                    m_highestAt = column.left;
                m_reach.add({low, high, column.bandLow, column.bandHigh});
                m_highs.add(high);
                m_highBands.add(column.bandHigh);
                m_negatedLows.add(-low);
                m_negatedLowBands.add(-column.bandLow);
                ++m_visible;
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
    if (isVector(painter))
        paintPath(painter, geometry);
    else if (static_cast<double>(m_columns.size()) > geometry.area.width() * kDense)
        paintDense(painter, geometry);
    else
        paintLines(painter, geometry);
    if (!tag.text().isEmpty())
        paintTag(painter, geometry);
}

void TraceDrawing::paintExceeding(QPainter& painter, const PlotGeometry& geometry, double step) const {
    const QFontMetricsF metrics(painter.font());
    const double size = metrics.xHeight();
    const auto mark = [&](double at, double value, double edge, double inwards) {
        const double x =
            std::clamp(geometry.x(at), geometry.area.left() + size, geometry.area.right() - size);
        painter.setBrush(colour);
        painter.setPen(Qt::NoPen);
        painter.drawPolygon(QPolygonF{QPointF(x, edge), QPointF(x - size, edge + inwards * 1.5 * size),
                                      QPointF(x + size, edge + inwards * 1.5 * size)});
        const QString text = texts::numberAt(value, step);
        const double width = metrics.horizontalAdvance(text);
        const bool fits = x + 2 * size + width < geometry.area.right();
        painter.setPen(colour);
        painter.drawText(QPointF(fits ? x + 2 * size : x - 2 * size - width,
                                 edge + (inwards > 0 ? metrics.ascent() : -metrics.descent())),
                         text);
    };
    if (m_reach.high > geometry.top)
        mark(m_highestAt, m_reach.high, geometry.area.top(), 1);
    if (m_reach.low < geometry.bottom)
        mark(m_lowestAt, m_reach.low, geometry.area.bottom(), -1);
}

Reach TraceDrawing::reachWithoutSpikes() const {
    constexpr std::size_t kColumnsForASpike = 100;
    const std::size_t i = std::min(m_visible / kColumnsForASpike, m_highs.values.size() - 1);
    return {-m_negatedLows.values[i], m_highs.values[i], -m_negatedLowBands.values[i], m_highBands.values[i]};
}

double TraceDrawing::dashesPerSecond(const PlotGeometry& geometry) {
    return geometry.area.width() / (geometry.right - geometry.left) / kDashPeriod;
}

template <typename Add>
void TraceDrawing::visitLines(const PlotGeometry& geometry, Add&& add) const {
    const auto visit = [&](const QLineF& line, double fromSecond, double toSecond) {
        const double seconds = toSecond - fromSecond;
        if (const auto part = partWithin(geometry.area, line))
            add(part->line, fromSecond + part->from * seconds, fromSecond + part->to * seconds);
    };
    QPointF before;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column& column = m_columns[i];
        const QPointF entry = geometry.at(column.left, column.entry);
        const QPointF exit = geometry.at(column.right, column.exit);
        const bool goesOn = i + 1 < m_columns.size() && m_columns[i + 1].joined;
        if (column.joined)
            visit(QLineF(before, entry), m_columns[i - 1].right, column.left);
        if (entry != exit)
            visit(QLineF(entry, exit), column.left, column.right);
        else if (!column.joined && !goesOn)  // a single sample
            visit(QLineF(entry.x() - kTraceWidth, entry.y(), entry.x() + kTraceWidth, entry.y()), column.left,
                  column.left);
        before = exit;
    }
}

void TraceDrawing::paintLines(QPainter& painter, const PlotGeometry& geometry) const {
    const double dashes = dashesPerSecond(geometry);
    Lines lines;
    std::optional<Straight> straight;
    const auto draw = [&] {
        if (!straight)
            return;
        if (dashed && straight->to() > straight->from())
            addDashed(straight->line(), straight->from() * dashes, straight->to() * dashes, lines);
        else
            lines.append(straight->line());
    };
    visitLines(geometry, [&](const QLineF& line, double fromSecond, double toSecond) {
        if (straight && straight->add(line, toSecond))
            return;
        draw();
        straight.emplace(line, fromSecond, toSecond, dashed);
    });
    draw();
    // Round caps would cost six times as much.
    painter.setPen(QPen(colour, kTraceWidth, Qt::SolidLine, dashed ? Qt::FlatCap : Qt::SquareCap));
    painter.drawLines(lines.constData(), static_cast<int>(lines.size()));
}

/// Draws one path for each trace, which a drawing program treats as one object.
void TraceDrawing::paintPath(QPainter& painter, const PlotGeometry& geometry) const {
    QPainterPath path;
    visitLines(geometry, [&](const QLineF& line, double /*fromSecond*/, double /*toSecond*/) {
        if (path.isEmpty() || path.currentPosition() != line.p1())
            path.moveTo(line.p1());
        path.lineTo(line.p2());
    });
    QPen pen(colour, kTraceWidth, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (dashed)
        pen.setDashPattern(
            {kDashShare * kDashPeriod / kTraceWidth, (1 - kDashShare) * kDashPeriod / kTraceWidth});
    painter.setBrush(Qt::NoBrush);
    painter.strokePath(path, pen);
}

/// Where most pixels have a column, fills what the trace covers in each pixel: as smooth as lines, at a
/// fraction of their cost. All lengths are in device pixels.
void TraceDrawing::paintDense(QPainter& painter, const PlotGeometry& geometry) const {
    const double ratio = painter.device()->devicePixelRatioF();
    const double width = kTraceWidth * ratio;
    const double dashes = dashesPerSecond(geometry);
    const QRectF area(geometry.area.topLeft() * ratio, geometry.area.size() * ratio);
    ThickLine thick(painter, colour, 1 / ratio,
                    {static_cast<int>(std::floor(area.top())), static_cast<int>(std::ceil(area.bottom()))});
    double here = 0, low = 0, high = 0;
    bool open = false;
    const auto close = [&] {
        if (!open)
            return;
        const double phase = geometry.seconds(here / ratio) * dashes;
        const bool gap = dashed && high - low < width * 2 && phase - std::floor(phase) > kDashShare;
        if (gap)
            thick.end();
        else
            thick.add(static_cast<int>(here), low - width / 2, high + width / 2);
        open = false;
    };
    const auto reach = [&](double column, double from, double to) {
        if (open && column != here)
            close();
        const auto [top, bottom] = std::minmax(from, to);
        low = open ? std::min(low, top) : top;
        high = open ? std::max(high, bottom) : bottom;
        here = column;
        open = true;
    };
    // What is beyond the plot area is clipped anyway.
    const auto y = [&](double value) {
        return std::clamp(geometry.y(value) * ratio, area.top() - kClampMargin, area.bottom() + kClampMargin);
    };
    const double leftmost = std::floor(area.left()) - 1;
    const double rightmost = std::floor(area.right()) + 1;
    double atX = 0, atY = 0;
    const auto go = [&](double toX, double toY) {
        const double last = std::min(std::floor(toX), rightmost);
        double from = atY;
        for (double column = std::max(std::floor(atX), leftmost); column < last; column += 1) {
            const double to = atY + (toY - atY) * (column + 1 - atX) / (toX - atX);
            reach(column, from, to);
            from = to;
        }
        reach(last, from, toY);
        atX = toX;
        atY = toY;
    };
    for (const Column& column : m_columns) {
        const double left = geometry.x(column.left) * ratio;
        if (!column.joined) {
            close();
            thick.end();
            atX = left;
            atY = y(column.entry);
        }
        go(left, y(column.entry));
        go(geometry.x(column.right) * ratio, y(column.exit));
    }
    close();
    thick.end();
}

void TraceDrawing::paintBand(QPainter& painter, const PlotGeometry& geometry) const {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    QPolygonF above, below;
    const auto end = [&] {
        std::reverse(below.begin(), below.end());
        if (!above.isEmpty())
            path.addPolygon(above + below);
        above.clear();
        below.clear();
    };
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column& column = m_columns[i];
        if (!column.joined)
            end();
        // The band reaches to the next column, which may be many pixels away.
        const bool goesOn = i + 1 < m_columns.size() && m_columns[i + 1].joined;
        const double to = goesOn ? geometry.x(m_columns[i + 1].left) : geometry.x(column.right) + 1;
        const QRectF band(geometry.at(column.left, column.bandHigh), QPointF(to, geometry.y(column.bandLow)));
        if (const QRectF seen = band & geometry.area; !seen.isEmpty()) {
            above << seen.topLeft() << seen.topRight();
            below << seen.bottomLeft() << seen.bottomRight();
        } else {
            end();
        }
    }
    end();
    QColor fill = colour;
    fill.setAlpha(kEnvelopeAlpha);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillPath(path, fill);
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void TraceDrawing::paintTag(QPainter& painter, const PlotGeometry& geometry) const {
    for (auto column = m_columns.rbegin(); column != m_columns.rend(); ++column) {
        if (column->right > geometry.right)
            continue;
        const QSizeF size = tag.size();
        const double x = std::min(geometry.x(column->right) + 3, geometry.area.right() - size.width() - 2);
        const double ascent = QFontMetricsF(painter.font()).ascent();
        painter.setPen(colour);
        painter.drawStaticText(QPointF(x, geometry.y(column->exit) - 3 - ascent), tag);
        return;
    }
}

}  // namespace nmc
